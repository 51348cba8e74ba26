use std::collections::HashMap;
use std::path::{Path, PathBuf};

use csv::{ByteRecord, ReaderBuilder, Trim};

use crate::cli::load::read;
use crate::cli::numeral::numeral;
use crate::cli::output::shown;
use crate::diag::{Code, Diagnostic, Diagnostics, FileId, Limits, SourceMap, Span};
use crate::number::Rational;
use crate::sema::nearest;
use crate::syntax::{canonical_name, decode};

use super::quotes::OpenQuote;

/// Values of parameters, a variant a line.
#[derive(Debug, Default)]
pub(super) struct List {
    pub(super) path: PathBuf,
    pub(super) sources: SourceMap,
    pub(super) names: Vec<String>,
    /// The first line.
    header: Span,
    pub(super) rows: Vec<Vec<Rational>>,
}

impl List {
    /// Reads a CSV file.
    ///
    /// # Errors
    ///
    /// Its findings: what cannot be read, what is no table of exact numbers (E0605).
    pub(super) fn read(path: &Path, limits: &Limits) -> Result<Self, (Diagnostics, SourceMap)> {
        let mut list = Self {
            path: path.to_path_buf(),
            ..Self::default()
        };
        let mut findings = Diagnostics::default();
        let name = path.display().to_string();
        match read(path, limits).map(|bytes| decode(&bytes, &name, limits)) {
            Ok(Ok(text)) => {
                let file = list.sources.add(name, text.as_str());
                list.parse(&text, file, limits, &mut findings);
            }
            Ok(Err(finding)) => findings.push(*finding),
            Err(error) => {
                let message = format!("`{name}` cannot be read: {error}");
                findings.push(Diagnostic::global(Code::E0601, message));
            }
        }
        if findings.has_errors() {
            return Err((findings, list.sources));
        }
        Ok(list)
    }

    fn parse(&mut self, text: &str, file: FileId, limits: &Limits, findings: &mut Diagnostics) {
        let shift = if text.starts_with('\u{feff}') { 3 } else { 0 };
        let open = OpenQuote::find(&text[shift..]);
        let end = open.map_or(text.len(), |own| shift + own.line);
        self.read_lines(&text[shift..end], shift, file, limits, findings);
        if let Some(OpenQuote { at, .. }) = open {
            let span = Span::new(file, shift + at, shift + at + 1);
            let finding = Diagnostic::new(Code::E0605, span, "this quote is never closed");
            findings.push(finding);
        }
        if !findings.has_errors() && self.rows.is_empty() {
            let message = format!("`{}` lists no variant", self.path.display());
            let finding = Diagnostic::global(Code::E0605, message);
            findings.push(finding.help("write names in the first line, then a variant a line"));
        }
    }

    /// Reads lines that begin at an offset of the file.
    fn read_lines(
        &mut self,
        text: &str,
        shift: usize,
        file: FileId,
        limits: &Limits,
        findings: &mut Diagnostics,
    ) {
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(Trim::All)
            .from_reader(text.as_bytes());
        let mut record = ByteRecord::new();
        let mut seen: HashMap<Vec<Rational>, usize> = HashMap::new();
        loop {
            let start = usize::try_from(reader.position().byte()).unwrap_or(usize::MAX);
            if !reader.read_byte_record(&mut record).unwrap_or_default() {
                break;
            }
            let start = record.position().map_or(start, |own| {
                usize::try_from(own.byte()).unwrap_or(usize::MAX)
            });
            let end = usize::try_from(reader.position().byte()).unwrap_or(usize::MAX);
            let line = text.get(start..end).unwrap_or_default();
            let start = start + line.len() - line.trim_start().len();
            let span = Span::new(file, shift + start, shift + start + line.trim().len());
            let fields = record.iter().map(String::from_utf8_lossy);
            let fields: Vec<String> = fields.map(std::borrow::Cow::into_owned).collect();
            if self.names.is_empty() {
                self.take_header(&fields, span, findings);
                if findings.has_errors() {
                    return;
                }
                continue;
            }
            match self.row(&fields, span, limits) {
                Ok(row) => {
                    let variant = self.rows.len() + 1;
                    if let Some(first) = seen.insert(row.clone(), variant) {
                        let message =
                            format!("variant {variant} has the values of variant {first}");
                        findings.push(Diagnostic::new(Code::E0605, span, message));
                    }
                    self.rows.push(row);
                }
                Err(finding) => findings.push(*finding),
            }
            if findings.len() >= limits.syntax_errors {
                return;
            }
        }
    }

    fn take_header(&mut self, fields: &[String], span: Span, findings: &mut Diagnostics) {
        self.header = span;
        self.names = fields.iter().map(|own| canonical_name(own)).collect();
        for (index, name) in self.names.iter().enumerate() {
            if name.is_empty() {
                let message = format!("column {} has no name", index + 1);
                let finding = Diagnostic::new(Code::E0605, span, message);
                findings.push(finding.help("name it, or remove its comma from every line"));
            } else if self.names[..index].contains(name) {
                let message = format!("`{name}` has two columns");
                findings.push(Diagnostic::new(Code::E0605, span, message));
            }
        }
        for field in fields.iter().filter(|own| own.contains('"')) {
            let message = format!("`{field}` is no name: a quote is part of it");
            let finding = Diagnostic::new(Code::E0605, span, message);
            findings.push(help_with_quotes(finding, field));
        }
        let unquoted = fields.iter().filter(|own| !own.contains('"'));
        for field in unquoted.filter(|own| !own.is_empty() && !is_name(own)) {
            let message = format!("`{field}` is no name");
            let help = match field.contains([';', '\t']) {
                true => "columns are separated by commas",
                false => "the first line names the parameters",
            };
            let finding = Diagnostic::new(Code::E0605, span, message);
            findings.push(finding.help(help));
        }
    }

    fn row(
        &self,
        fields: &[String],
        span: Span,
        limits: &Limits,
    ) -> Result<Vec<Rational>, Box<Diagnostic>> {
        if fields.len() != self.names.len() {
            let counted = |count: usize, noun: &str| match count {
                1 => format!("1 {noun}"),
                _ => format!("{count} {noun}s"),
            };
            let found = counted(fields.len(), "value");
            let wanted = counted(self.names.len(), "name");
            let message = format!("this line has {found}, the first line {wanted}");
            return Err(Box::new(Diagnostic::new(Code::E0605, span, message)));
        }
        let number = |own: &String| {
            numeral(own, limits)
                .map_err(|fault| Box::new(help_with_quotes(fault.at(span, own), own)))
        };
        fields.iter().map(number).collect()
    }

    /// The names that are no parameters of a file (E0112).
    pub(super) fn unknown(&self, parameters: &[&str], file: &Path) -> Diagnostics {
        let mut findings = Diagnostics::default();
        let known = |own: &&String| !parameters.contains(&own.as_str());
        for name in self.names.iter().filter(known) {
            let message = format!("`{name}` is not a parameter of `{}`", shown(file));
            let mut finding = Diagnostic::new(Code::E0112, self.header, message);
            if !parameters.is_empty() {
                finding = finding.note(format!("there are: {}", parameters.join(", ")));
            }
            findings.push(match nearest(name, parameters.iter()) {
                Some(meant) => finding.help(format!("did you mean `{meant}`?")),
                None => finding.help(format!("declare it: `param {name} = …`")),
            });
        }
        findings
    }
}

/// Whether a word may be the name of a parameter.
fn is_name(word: &str) -> bool {
    let is_part = |own: char| own.is_alphanumeric() || own == '_';
    word.chars().all(is_part) && !word.starts_with(|own: char| own.is_ascii_digit())
}

/// Says why a quote is part of a value that begins with it.
fn help_with_quotes(finding: Diagnostic, value: &str) -> Diagnostic {
    if value.starts_with('"') {
        finding.help("a quote opens a value only right behind the comma: remove the space between")
    } else {
        finding
    }
}
