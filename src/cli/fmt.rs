use std::path::Path;

use similar::TextDiff;

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::pipeline::standard_library;
use crate::sema::Names;
use crate::syntax::{Formatter, Spelling, parse};

use super::arguments::{Arguments, FmtArguments};
use super::load::{Loaded, load};
use super::session::Misuse;
use super::staged::Staged;
use super::status::Status;
use super::stopwatch::Stopwatch;
use super::streams::{complain, print, tell};
use super::voice::Voice;

/// `sweepc fmt FILE…`
pub(super) fn run(own: &FmtArguments, arguments: &Arguments) -> Status {
    if let Err(misuse) = Misuse::of_input(&own.files) {
        return misuse.complain();
    }
    let files = own.files.iter();
    let statuses = files.map(|file| format(file, own, arguments));
    statuses.max().unwrap_or(Status::Success)
}

/// Formats one file. Its imports are read for what their names mean; that some cannot be read is
/// no error here.
fn format(file: &Path, own: &FmtArguments, arguments: &Arguments) -> Status {
    let limits = arguments.limits();
    let voice = Voice::of(arguments);
    let mut stopwatch = Stopwatch::start();
    let Loaded {
        sources,
        documents,
        diagnostics: mut findings,
        ..
    } = load(file, &limits);
    let Some(document) = documents.first() else {
        voice.tell(&findings, &sources);
        return Status::of(&findings);
    };
    stopwatch.lap("read and parsed");
    let source = sources.file(document.file);
    let mut errors = Diagnostics::default();
    parse(document.file, &source.text, &limits, &mut errors);
    if errors.has_errors() {
        voice.tell(&errors, &sources);
        return Status::of(&errors);
    }
    let library = standard_library();
    let names = Names::of(&documents, &library);
    let formatter = Formatter {
        spelling: spelling(own),
        reading: &|name, declaration| names.reading(name, declaration),
        limits: &limits,
    };
    let Some(formatted) = formatter.format(document, &source.text) else {
        let name = &source.name;
        complain(&format!(
            "internal error: the layout of `{name}` would change what it says, and it stays as it \
             is; please report it with the input"
        ));
        return Status::Internal;
    };
    stopwatch.lap("laid out");
    if voice.is_verbose {
        tell(&stopwatch.lines(&source.name));
    }
    if own.check {
        return check(&source.name, &source.text, &formatted);
    }
    if file == Path::new("-") {
        return print(&formatted);
    }
    if formatted != source.text
        && let Err(error) = write(file, &formatted)
    {
        let message = format!("`{}` cannot be written: {error}", file.display());
        findings = Diagnostics::default();
        findings.push(Diagnostic::global(Code::E0602, message));
        voice.tell(&findings, &sources);
        return Status::of(&findings);
    }
    Status::Success
}

fn spelling(own: &FmtArguments) -> Spelling {
    match (own.ascii, own.unicode) {
        (true, _) => Spelling::Ascii,
        (_, true) => Spelling::Unicode,
        _ => Spelling::AsWritten,
    }
}

/// Lists a file that would change, and how.
fn check(name: &str, text: &str, formatted: &str) -> Status {
    if text == formatted {
        return Status::Success;
    }
    let difference = TextDiff::from_lines(text, formatted);
    let difference = difference.unified_diff().context_radius(1).to_string();
    Status::Errors.max(print(&format!("{name}\n{difference}")))
}

fn write(file: &Path, formatted: &str) -> std::io::Result<()> {
    let mut staged = Staged::default();
    staged.replace(file, formatted.as_bytes())?;
    let written = staged.commit();
    written.map(|_| ()).map_err(|(_, error)| error)
}
