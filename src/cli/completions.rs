use clap::CommandFactory;

use super::arguments::{Arguments, CompletionsArguments};
use super::status::Status;
use super::streams::print;

/// `sweepc completions SHELL`
pub(super) fn run(own: &CompletionsArguments) -> Status {
    let mut script = Vec::new();
    clap_complete::generate(own.shell, &mut Arguments::command(), "sweepc", &mut script);
    print(&String::from_utf8_lossy(&script))
}
