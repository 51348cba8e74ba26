use std::collections::BTreeSet;
use std::path::Path;

use crate::diag::{Code, Diagnostic, Diagnostics, SourceMap, render_json};

use super::arguments::{Arguments, CheckArguments, CheckFormat};
use super::output::shown;
use super::parallel::Crew;
use super::progress;
use super::refusal::Refusal;
use super::session::{Misuse, Session, assignments};
use super::status::Status;
use super::streams::{complain, print, tell};
use super::voice::Voice;

/// What there is to say of one file.
struct Checked {
    out: String,
    err: String,
    codes: BTreeSet<Code>,
    status: Status,
}

impl Checked {
    fn of(
        diagnostics: &Diagnostics,
        sources: &SourceMap,
        format: CheckFormat,
        voice: Voice,
    ) -> Self {
        let mut checked = Self {
            out: String::new(),
            err: String::new(),
            codes: BTreeSet::new(),
            status: Status::of(diagnostics),
        };
        match format {
            CheckFormat::Text => {
                checked.err = voice.findings(diagnostics, sources);
                checked.codes = diagnostics.iter().map(|own| own.code).collect();
            }
            CheckFormat::Json => {
                let lines = voice.told(diagnostics);
                let lines = lines.map(|own| render_json(own, sources) + "\n");
                checked.out = lines.collect();
            }
        }
        checked
    }

    fn refused(refusal: &Refusal, format: CheckFormat, voice: Voice) -> Self {
        match refusal {
            Refusal::Findings(findings, sources) => Self::of(findings, sources, format, voice),
            Refusal::Misuse(Misuse(message)) => Self {
                out: String::new(),
                err: format!("sweepc: {message}\n"),
                codes: BTreeSet::new(),
                status: Status::Usage,
            },
        }
    }
}

/// `sweepc check FILE…`
///
/// Files are worked on side by side, and told of in the order in which they are named.
pub(super) fn run(own: &CheckArguments, arguments: &Arguments, stack: usize) -> Status {
    // What is wrong whatever the files are is said once.
    let voice = Voice::of(arguments);
    if let Err(refusal) = assignments(arguments) {
        let checked = Checked::refused(&refusal, own.format, voice);
        tell(&checked.err);
        voice.tell_hint(&checked.codes);
        return checked.status.max(print(&checked.out));
    }
    if let Err(misuse) = Misuse::of_input(&own.files) {
        return misuse.complain();
    }
    match own.files.as_slice() {
        [file] => progress::begin(&shown(file)),
        files => progress::begin_files(files.len()),
    }
    let (mut worst, mut codes) = (Status::Success, BTreeSet::new());
    let work = |index: usize| {
        let checked = check(&own.files[index], own, arguments, voice);
        progress::advance();
        checked
    };
    let crew = Crew {
        threads: arguments.threads(),
        stack,
    };
    crew.in_order(own.files.len(), work, |checked| {
        let status = match checked {
            Some(checked) => {
                tell(&checked.err);
                codes.extend(checked.codes);
                checked.status.max(print(&checked.out))
            }
            None => {
                complain("internal error: this is a defect of sweepc, please report it");
                Status::Internal
            }
        };
        worst = worst.max(status);
    });
    voice.tell_hint(&codes);
    worst
}

fn check(file: &Path, own: &CheckArguments, arguments: &Arguments, voice: Voice) -> Checked {
    let mut session = match Session::open(file, arguments) {
        Ok(session) => session,
        Err(refusal) => return Checked::refused(&refusal, own.format, voice),
    };
    let sources = &session.sources;
    let diagnostics = &mut session.compilation.diagnostics;
    if session.readable && session.compilation.surfaces.is_empty() && !diagnostics.has_errors() {
        let message = format!("`{}` declares no surface", shown(file));
        diagnostics.push(Diagnostic::global(Code::W1007, message));
    }
    let mut checked = Checked::of(diagnostics, sources, own.format, voice);
    if voice.is_verbose {
        let lines = session.stopwatch.lines(&shown(file));
        checked.err.push_str(&lines);
    }
    checked
}
