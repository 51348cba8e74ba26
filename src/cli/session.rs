use std::collections::{BTreeSet, HashMap};
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostics, SourceMap, Style, render_text};
use crate::number::Real;
use crate::pipeline::{Compilation, Options, compile};
use crate::syntax::ast::{Declaration, Document};
use crate::syntax::canonical_name;

use super::arguments::{Arguments, Color};
use super::explain::hint;
use super::load::{Loaded, load};
use super::status::Status;

/// A compiled file with its sources.
pub(super) struct Session {
    pub(super) sources: SourceMap,
    pub(super) compilation: Compilation,
    pub(super) options: Options,
    /// The files that were read.
    pub(super) paths: Vec<Option<PathBuf>>,
    /// Whether the root file was read and declares a surface.
    pub(super) readable: bool,
}

impl Session {
    /// Reads and compiles a file with the options of the command line.
    ///
    /// # Errors
    ///
    /// A wrong `-D` or `--surface`, which has been told on standard error.
    pub(super) fn open(
        file: &Path,
        arguments: &Arguments,
        any_weight_ratio: bool,
    ) -> Result<Self, Status> {
        let limits = arguments.limits();
        let Loaded {
            mut sources,
            documents,
            diagnostics,
            paths,
        } = load(file, &limits);
        let overrides = overrides(&arguments.set, &documents)?;
        if let Some(name) = &arguments.surface
            && !documents.is_empty()
        {
            check_surface(name, &documents)?;
        }
        let options = Options {
            overrides,
            surface: arguments.surface.clone(),
            limits,
            any_weight_ratio,
        };
        let readable = !documents.is_empty();
        let compilation = if readable {
            compile(&mut sources, &documents, &options, diagnostics)
        } else {
            Compilation {
                diagnostics,
                ..Compilation::default()
            }
        };
        Ok(Self {
            sources,
            compilation,
            options,
            paths,
            readable,
        })
    }

    /// Prints the findings to standard error, and where to read more of them.
    pub(super) fn print_diagnostics(&self, color: Color) {
        self.print_findings(color);
        print_hint(&self.codes());
    }

    /// Prints the findings to standard error.
    pub(super) fn print_findings(&self, color: Color) {
        print_findings(&self.compilation.diagnostics, &self.sources, color);
    }

    /// The codes of the findings.
    pub(super) fn codes(&self) -> BTreeSet<Code> {
        codes(&self.compilation.diagnostics)
    }
}

/// Prints findings to standard error, and where to read more of them.
pub(super) fn print_diagnostics(diagnostics: &Diagnostics, sources: &SourceMap, color: Color) {
    print_findings(diagnostics, sources, color);
    print_hint(&codes(diagnostics));
}

fn print_findings(diagnostics: &Diagnostics, sources: &SourceMap, color: Color) {
    let coloured = is_coloured(color, std::io::stderr().is_terminal());
    let style = if coloured {
        Style::Coloured
    } else {
        Style::Plain
    };
    let mut stderr = std::io::stderr().lock();
    for diagnostic in diagnostics.iter() {
        let _ = writeln!(stderr, "{}", render_text(diagnostic, sources, style));
    }
}

fn codes(diagnostics: &Diagnostics) -> BTreeSet<Code> {
    diagnostics.iter().map(|own| own.code).collect()
}

/// One line that names the pages on some codes, to standard error.
pub(super) fn print_hint(codes: &BTreeSet<Code>) {
    if !codes.is_empty() {
        let _ = writeln!(std::io::stderr(), "{}", hint(codes));
    }
}

/// Whether a stream is to be coloured.
pub(super) fn is_coloured(color: Color, is_terminal: bool) -> bool {
    match color {
        Color::Always => true,
        Color::Never => false,
        Color::Auto => std::env::var_os("NO_COLOR").is_none_or(|own| own.is_empty()) && is_terminal,
    }
}

/// Writes results to standard output; a reader that has gone away ends the output quietly.
pub(super) fn print(text: &str) {
    let mut stdout = std::io::stdout().lock();
    let _ = stdout
        .write_all(text.as_bytes())
        .and_then(|()| stdout.flush());
}

/// One line to standard error.
pub(super) fn complain(message: &str) {
    let _ = writeln!(std::io::stderr(), "sweepc: {message}");
}

/// The values of `-D NAME=VALUE`; each must name a `param`.
fn overrides(given: &[String], documents: &[Document]) -> Result<HashMap<String, Real>, Status> {
    let mut overrides = HashMap::new();
    let params = names(documents, |own| match own {
        Declaration::Param { name, .. } => Some(name.text.as_str()),
        _ => None,
    });
    for own in given {
        let Some((name, value)) = own.split_once('=') else {
            complain(&format!("`-D {own}` is not of the form NAME=VALUE"));
            return Err(Status::Usage);
        };
        let name = canonical_name(name.trim());
        let Ok(value) = value.trim().parse::<Real>() else {
            complain(&format!(
                "`{value}` is not an exact number such as 3/2 or 0.25"
            ));
            return Err(Status::Usage);
        };
        if !documents.is_empty() && !params.contains(&name.as_str()) {
            let list = if params.is_empty() {
                "the file has none".to_owned()
            } else {
                format!("there are: {}", params.join(", "))
            };
            complain(&format!("`{name}` is not a parameter; {list}"));
            return Err(Status::Usage);
        }
        overrides.insert(name, value);
    }
    Ok(overrides)
}

fn check_surface(name: &str, documents: &[Document]) -> Result<(), Status> {
    let surfaces = names(&documents[..1], |own| match own {
        Declaration::Surface { name, .. } => Some(name.text.as_str()),
        _ => None,
    });
    if surfaces.contains(&canonical_name(name).as_str()) {
        return Ok(());
    }
    let list = if surfaces.is_empty() {
        "the file has none".to_owned()
    } else {
        format!("there are: {}", surfaces.join(", "))
    };
    complain(&format!("`{name}` is not a surface; {list}"));
    Err(Status::Usage)
}

fn names<'a>(
    documents: &'a [Document],
    pick: impl Fn(&'a Declaration) -> Option<&'a str>,
) -> Vec<&'a str> {
    let items = documents.iter().flat_map(|document| &document.items);
    items.filter_map(|item| pick(&item.declaration)).collect()
}
