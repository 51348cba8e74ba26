//! The command line: the only floor that reads and writes.

mod arguments;
mod check;
mod compile;
mod explain;
mod fmt;
mod load;
mod output;
mod report;
mod session;
mod status;
mod watch;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::mpsc::channel;

use clap::Parser;

use arguments::{Arguments, Command};
use status::Status;
use watch::watch;

/// Stack for the deepest expressions that the default limits allow, and for each further level.
const STACK: usize = 16 << 20;
const STACK_OF_LEVEL: usize = 32 << 10;

/// Runs the command line of this process and returns its exit status.
#[must_use]
pub fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let usage = error.use_stderr();
            let _ = error.print();
            return if usage {
                Status::Usage
            } else {
                Status::Success
            }
            .into();
        }
    };
    let levels = arguments.limits().nesting.saturating_sub(256);
    let stack = STACK.saturating_add(levels.saturating_mul(STACK_OF_LEVEL));
    let budget = arguments.budget();
    let (sender, receiver) = channel();
    let worker = std::thread::Builder::new().stack_size(stack);
    let work = worker.spawn(move || {
        if let Ok(status) = catch_unwind(AssertUnwindSafe(|| dispatch(&arguments))) {
            let _ = sender.send(status);
        }
    });
    let status = work.ok().and_then(|_| watch(&receiver, budget));
    let Some(status) = status else {
        session::complain(
            "internal error: this is a defect of sweepc, please report it with the input",
        );
        return Status::Internal.into();
    };
    status.into()
}

fn dispatch(arguments: &Arguments) -> Status {
    match &arguments.command {
        Command::Check(own) => check::run(own, arguments),
        Command::Report(own) => report::run(own, arguments),
        Command::Compile(own) => compile::run(own, arguments),
        Command::Explain(own) => explain::run(own, arguments),
        Command::Fmt(own) => fmt::run(own, arguments),
    }
}
