use std::collections::BTreeSet;

use crate::diag::{Code, Diagnostic, render_json};

use super::arguments::{Arguments, CheckArguments, CheckFormat};
use super::session::{Session, print, print_hint};
use super::status::Status;

/// `sweepc check FILE…`
pub(super) fn run(own: &CheckArguments, arguments: &Arguments) -> Status {
    let mut worst = Status::Success;
    let mut codes = BTreeSet::new();
    for file in &own.files {
        let mut session = match Session::open(file, arguments, false) {
            Ok(session) => session,
            Err(status) => return status,
        };
        let diagnostics = &mut session.compilation.diagnostics;
        if session.readable && session.compilation.surfaces.is_empty() && !diagnostics.has_errors()
        {
            let message = format!("`{}` declares no surface", file.display());
            diagnostics.push(Diagnostic::global(Code::W1007, message));
        }
        worst = worst.max(Status::of(diagnostics));
        match own.format {
            CheckFormat::Text => {
                session.print_findings(arguments.color);
                codes.extend(session.codes());
            }
            CheckFormat::Json => {
                for diagnostic in session.compilation.diagnostics.iter() {
                    print(&format!("{}\n", render_json(diagnostic, &session.sources)));
                }
            }
        }
    }
    print_hint(&codes);
    worst
}
