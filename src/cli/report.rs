use crate::diag::{Code, Diagnostic};
use crate::report::{render_json, render_markdown, render_text};

use super::arguments::{Arguments, ReportArguments, ReportFormat};
use super::output::file_name;
use super::session::{Session, complain, print};
use super::status::Status;

/// `sweepc report FILE`
pub(super) fn run(own: &ReportArguments, arguments: &Arguments) -> Status {
    let mut session = match Session::open(&own.file, arguments, false) {
        Ok(session) => session,
        Err(status) => return status,
    };
    require_surfaces(&mut session, &own.file);
    session.print_diagnostics(arguments.color);
    let report = session
        .compilation
        .report(&file_name(&own.file), &session.sources);
    let status = Status::of(&session.compilation.diagnostics);
    if report.surfaces.is_empty() && own.format != ReportFormat::Json {
        return status;
    }
    match own.format {
        ReportFormat::Text => print(&render_text(&report)),
        ReportFormat::Markdown => print(&render_markdown(&report)),
        ReportFormat::Json => match render_json(&report) {
            Ok(text) => print(&text),
            Err(error) => {
                complain(&error.to_string());
                return Status::Internal;
            }
        },
    }
    status
}

/// A file without surfaces has nothing to report or to build.
pub(super) fn require_surfaces(session: &mut Session, file: &std::path::Path) {
    let compilation = &mut session.compilation;
    if session.readable && compilation.surfaces.is_empty() && !compilation.diagnostics.has_errors()
    {
        let message = format!("nothing to build: `{}` declares no surface", file.display());
        let finding = Diagnostic::global(Code::E0303, message);
        compilation
            .diagnostics
            .push(finding.help("declare one: `surface R = c(v) + x(u) n(v) + z(u) k`"));
    }
}
