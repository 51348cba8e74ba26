use std::collections::HashSet;
use std::ffi::{OsStr, OsString};

use crate::diag::{Code, Diagnostic, Diagnostics, Limits, SourceMap};
use crate::export::{ALL, Exporter};
use crate::number::{Field, Real};
use crate::pipeline::{Compilation, Options};
use crate::report::{Report, render_json};

use super::arguments::CompileArguments;
use super::format_findings::FormatFindings;
use super::numeral::numeral;
use super::output::named;
use super::refusal::Refusal;
use super::session::Misuse;

/// What is to be written.
#[derive(Debug, Default)]
pub(super) struct Emit {
    pub(super) report: bool,
    /// The table of all variants.
    pub(super) table: bool,
    pub(super) formats: Vec<&'static Exporter>,
    /// The greatest distance between a surface and its triangles, if one is asked for.
    pub(super) chord: Option<Real>,
}

/// A file that is ready to be written.
#[derive(Debug)]
pub(super) struct Product {
    pub(super) name: OsString,
    pub(super) bytes: Vec<u8>,
    /// The surface that it holds, if it is the file of one.
    pub(super) surface: Option<String>,
}

impl Product {
    /// A file that is not of one surface.
    fn of_all(stem: &OsStr, ending: &str, bytes: Vec<u8>) -> Self {
        Self {
            name: named(stem, ending),
            bytes,
            surface: None,
        }
    }
}

impl Emit {
    /// Reads the command line.
    ///
    /// # Errors
    ///
    /// A word that is no format, or none at all; a distance that is not above 0, or beyond the
    /// limits of literals.
    pub(super) fn of(own: &CompileArguments, limits: &Limits) -> Result<Self, Refusal> {
        let emit = Self::of_words(&own.emit)?;
        let chord = own.chord.as_deref().map(|own| chord(own, limits));
        Ok(Self {
            chord: chord.transpose()?,
            ..emit
        })
    }

    /// Reads the words of `--emit`.
    fn of_words(words: &[String]) -> Result<Self, Misuse> {
        let mut emit = Self::default();
        let words = words.iter().map(|own| own.trim());
        for word in words.filter(|own| !own.is_empty()) {
            match ALL.iter().find(|format| format.name == word) {
                Some(format) if emit.formats.iter().all(|own| own.name != word) => {
                    emit.formats.push(format);
                }
                Some(_) => {}
                None if word == "report" => emit.report = true,
                None if word == "table" => emit.table = true,
                None => {
                    let names: Vec<&str> = ALL.iter().map(|format| format.name).collect();
                    return Err(Misuse(format!(
                        "`{word}` is no output format; there are: report, table, {}",
                        names.join(", ")
                    )));
                }
            }
        }
        if !emit.report && !emit.table && emit.formats.is_empty() {
            return Err(Misuse("`--emit` names no output format".to_owned()));
        }
        Ok(emit)
    }

    /// The files of a compilation; what is refused or warned of comes beside them.
    pub(super) fn products(
        &self,
        compilation: &Compilation,
        sources: &SourceMap,
        file: &str,
        stem: &OsStr,
        options: &Options,
    ) -> (Vec<Product>, Diagnostics) {
        let report = self.report.then(|| compilation.report(file, sources));
        self.products_with(report.as_ref(), compilation, stem, options)
    }

    /// As [`Emit::products`], with a report that is made already.
    pub(super) fn products_with(
        &self,
        report: Option<&Report>,
        compilation: &Compilation,
        stem: &OsStr,
        options: &Options,
    ) -> (Vec<Product>, Diagnostics) {
        let shown = stem.to_string_lossy();
        let mut files = Vec::new();
        let mut findings = Diagnostics::default();
        if let Some(report) = report.filter(|_| self.report) {
            match render_json(report) {
                Ok(text) => files.push(Product::of_all(stem, ".report.json", text.into_bytes())),
                Err(error) => findings.push(Diagnostic::global(Code::E0602, error.to_string())),
            }
        }
        let mut refused = HashSet::new();
        for surface in compilation.sound_surfaces() {
            let span = surface.definition().span;
            let exports = compilation.export(surface, &self.formats, &shown, options);
            let mut refusals = FormatFindings::default();
            let mut warnings = FormatFindings::default();
            for (format, result) in exports {
                match result {
                    Ok(exported) => {
                        for warning in exported.warnings {
                            warnings.add(format.name, warning.at(span));
                        }
                        let ending = format!("-{}.{}", surface.name(), format.extension);
                        files.push(Product {
                            surface: Some(surface.name().to_owned()),
                            ..Product::of_all(stem, &ending, exported.bytes)
                        });
                    }
                    Err(finding) => refusals.add(format.name, *finding),
                }
            }
            refused.extend(refusals.formats());
            findings.extend(warnings.findings("in the files"));
            findings.extend(refusals.findings("not written"));
        }
        let mut refusals = FormatFindings::default();
        for (format, result) in compilation.export_together(&self.formats, &shown, options) {
            match result {
                // What is odd about a surface is told with its own file.
                Ok(exported) => {
                    let ending = format!(".{}", format.extension);
                    files.push(Product::of_all(stem, &ending, exported.bytes));
                }
                // So is what its own file is refused for.
                Err(_) if refused.contains(format.name) => {}
                Err(finding) => refusals.add(format.name, *finding),
            }
        }
        findings.extend(refusals.findings("all surfaces in one file are not written"));
        (files, findings)
    }
}

/// The distance that `--chord` names.
fn chord(text: &str, limits: &Limits) -> Result<Real, Refusal> {
    let number = numeral(text, limits).map_err(|own| own.of_option(text, "--chord"))?;
    if !Field::sign(&number).is_gt() {
        return Err(Misuse(format!("`--chord {text}` is not above 0")).into());
    }
    Ok(Real::from(number))
}

/// Errors of single surfaces spoil only their own files; any other error spoils all.
pub(super) fn keeps_files(diagnostics: &Diagnostics) -> bool {
    diagnostics
        .errors()
        .all(|own| own.code.as_str().starts_with("E03") && own.code != Code::E0303)
}
