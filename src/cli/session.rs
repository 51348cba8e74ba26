use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use crate::diag::SourceMap;
use crate::number::Real;
use crate::pipeline::{Compilation, Options, Step};
use crate::sema::nearest;
use crate::syntax::ast::{Declaration, Document};
use crate::syntax::canonical_name;

use super::arguments::Arguments;
use super::numeral::numeral;
use super::output::shown;
use super::parsed::Parsed;
use super::refusal::Refusal;
use super::status::Status;
use super::stopwatch::Stopwatch;
use super::streams::complain;

/// A command line that does not fit a file, in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Misuse(pub(super) String);

impl Misuse {
    /// Standard input can be read once.
    pub(super) fn of_input(files: &[PathBuf]) -> Result<(), Self> {
        match files.iter().filter(|own| own.as_os_str() == "-").count() {
            0 | 1 => Ok(()),
            _ => Err(Self("standard input can be read only once".to_owned())),
        }
    }

    /// Tells it.
    pub(super) fn complain(&self) -> Status {
        complain(&self.0);
        Status::Usage
    }
}

/// A compiled file with its sources.
pub(super) struct Session {
    pub(super) sources: SourceMap,
    pub(super) compilation: Compilation,
    pub(super) options: Options,
    /// The files that were read.
    pub(super) paths: Vec<Option<PathBuf>>,
    /// Whether the root file was read and declares a surface.
    pub(super) readable: bool,
    /// How long each stage took.
    pub(super) stopwatch: Stopwatch,
}

impl Session {
    /// Reads and compiles a file with the options of the command line.
    ///
    /// # Errors
    ///
    /// A `-D` or `--surface` that does not fit the file.
    pub(super) fn open(file: &Path, arguments: &Arguments) -> Result<Self, Refusal> {
        let mut stopwatch = Stopwatch::start();
        let parsed = Parsed::read(file, &arguments.limits());
        stopwatch.lap("read and parsed");
        let options = options(arguments, &parsed, file)?;
        let compilation = parsed.compile(&options, &mut |step| {
            stopwatch.lap(match step {
                Step::Lowered => "names and types resolved".to_owned(),
                Step::Checked(name) => format!("`{name}` expanded and checked"),
                Step::Judged => "expectations decided".to_owned(),
            });
        });
        Ok(Self {
            readable: parsed.is_readable(),
            sources: parsed.sources,
            paths: parsed.paths,
            compilation,
            options,
            stopwatch,
        })
    }
}

/// What every command is asked of a file.
///
/// # Errors
///
/// A `-D` or `--surface` that does not fit the file.
pub(super) fn options(
    arguments: &Arguments,
    parsed: &Parsed,
    file: &Path,
) -> Result<Options, Refusal> {
    Ok(Options {
        overrides: overrides(arguments, parsed, file)?,
        surface: arguments.surface.clone(),
        limits: arguments.limits(),
        ..Options::default()
    })
}

/// The names and values of `-D NAME=VALUE`.
///
/// # Errors
///
/// One that has another form, a value beyond the limits of literals, a second value of a name.
pub(super) fn assignments(arguments: &Arguments) -> Result<Vec<(String, Real)>, Refusal> {
    let limits = arguments.limits();
    let assignment = |own: &String| {
        let Some((name, value)) = own.split_once('=') else {
            return Err(Misuse(format!("`-D {own}` is not of the form NAME=VALUE")).into());
        };
        let name = name.trim();
        let number = numeral(value, &limits);
        let number = number.map_err(|own| own.of_option(value, &format!("-D {name}=…")))?;
        Ok((canonical_name(name), Real::from(number)))
    };
    let assignments = arguments.set.iter().map(assignment);
    let assignments = assignments.collect::<Result<Vec<_>, Refusal>>()?;
    let mut names = HashSet::new();
    match assignments.iter().find(|(name, _)| !names.insert(name)) {
        Some((name, _)) => Err(Misuse(format!("`{name}` is given its value twice")).into()),
        None => Ok(assignments),
    }
}

/// The values that replace those of parameters, once they and the surface asked for are known to
/// fit the file. What a file with errors declares is not known.
fn overrides(
    arguments: &Arguments,
    parsed: &Parsed,
    file: &Path,
) -> Result<HashMap<String, Real>, Refusal> {
    let assignments = assignments(arguments)?;
    if parsed.is_sound() {
        let documents = &parsed.documents;
        for (name, _) in &assignments {
            check_parameter(name, documents, file)?;
        }
        if let Some(name) = &arguments.surface {
            check_surface(name, documents, file)?;
        }
    }
    Ok(assignments.into_iter().collect())
}

/// Whether a file declares this parameter.
///
/// # Errors
///
/// One that it does not declare.
pub(super) fn check_parameter(
    name: &str,
    documents: &[Document],
    file: &Path,
) -> Result<(), Misuse> {
    check_name(name, &parameters(documents), "parameter", file)
}

/// The parameters of a file and its imports.
pub(super) fn parameters(documents: &[Document]) -> Vec<&str> {
    names(documents, |own| match own {
        Declaration::Param { name, .. } => Some(name.text.as_str()),
        _ => None,
    })
}

/// The surfaces of a file.
pub(super) fn surfaces(documents: &[Document]) -> Vec<&str> {
    names(documents.get(..1).unwrap_or_default(), |own| match own {
        Declaration::Surface { name, .. } => Some(name.text.as_str()),
        _ => None,
    })
}

/// The curves of a file.
pub(super) fn curves(documents: &[Document]) -> Vec<&str> {
    names(documents.get(..1).unwrap_or_default(), |own| match own {
        Declaration::Curve { name, .. } => Some(name.text.as_str()),
        _ => None,
    })
}

fn check_surface(name: &str, documents: &[Document], file: &Path) -> Result<(), Misuse> {
    check_name(&canonical_name(name), &surfaces(documents), "surface", file)
}

fn check_name(name: &str, known: &[&str], kind: &str, file: &Path) -> Result<(), Misuse> {
    if known.contains(&name) {
        return Ok(());
    }
    let list = if known.is_empty() {
        "the file has none".to_owned()
    } else {
        format!("there are: {}", known.join(", "))
    };
    let meant = nearest(name, known.iter());
    let meant = meant.map_or(String::new(), |own| format!("; did you mean `{own}`?"));
    Err(Misuse(format!(
        "`{name}` is not a {kind} of `{}`; {list}{meant}",
        shown(file)
    )))
}

fn names<'a>(
    documents: &'a [Document],
    pick: impl Fn(&'a Declaration) -> Option<&'a str>,
) -> Vec<&'a str> {
    let items = documents.iter().flat_map(|document| &document.items);
    items.filter_map(|item| pick(&item.declaration)).collect()
}
