use crate::diag::{Code, Diagnostic};
use crate::pipeline::Compilation;
use crate::report::{render_json, render_markdown, render_text};

use super::arguments::{Arguments, ReportArguments, ReportFormat};
use super::output::{file_name, shown};
use super::progress;
use super::session::Session;
use super::status::Status;
use super::streams::{complain, print, tell};
use super::voice::Voice;

/// `sweepc report FILE`
pub(super) fn run(own: &ReportArguments, arguments: &Arguments) -> Status {
    progress::begin(&file_name(&own.file));
    let mut session = match Session::open(&own.file, arguments) {
        Ok(session) => session,
        Err(refusal) => return refusal.complain(Voice::of(arguments)),
    };
    require_surfaces(&mut session.compilation, session.readable, &own.file);
    let voice = Voice::of(arguments);
    voice.tell(&session.compilation.diagnostics, &session.sources);
    let name = file_name(&own.file);
    let report = session.compilation.report(&name, &session.sources);
    let status = Status::of(&session.compilation.diagnostics);
    if report.surfaces.is_empty() && own.format != ReportFormat::Json {
        return status;
    }
    let text = match own.format {
        ReportFormat::Text => render_text(&report),
        ReportFormat::Markdown => render_markdown(&report),
        ReportFormat::Json => match render_json(&report) {
            Ok(text) => text,
            Err(error) => {
                complain(&error.to_string());
                return Status::Internal;
            }
        },
    };
    session.stopwatch.lap("report made");
    if voice.is_verbose {
        tell(&session.stopwatch.lines(&name));
    }
    status.max(print(&text))
}

/// A file without surfaces has nothing to report or to build.
pub(super) fn require_surfaces(
    compilation: &mut Compilation,
    readable: bool,
    file: &std::path::Path,
) {
    if readable && compilation.surfaces.is_empty() && !compilation.diagnostics.has_errors() {
        let message = format!("nothing to build: `{}` declares no surface", shown(file));
        let finding = Diagnostic::global(Code::E0303, message);
        compilation
            .diagnostics
            .push(finding.help("declare one: `surface R = c(v) + x(u) n(v) + z(u) k`"));
    }
}
