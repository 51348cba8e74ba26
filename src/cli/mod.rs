//! The command line: the only floor that reads and writes.

mod arguments;
mod batch;
mod check;
mod compile;
mod completions;
mod emit;
mod explain;
mod fmt;
mod format_findings;
mod interrupt;
mod load;
mod man;
mod numeral;
mod output;
mod parallel;
mod parsed;
mod progress;
mod refusal;
mod report;
mod session;
mod staged;
mod status;
mod stopwatch;
mod streams;
mod voice;
mod watch;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::sync::mpsc::channel;

use clap::{CommandFactory, FromArgMatches};

use arguments::{Arguments, Command};
use interrupt::Interrupt;
use status::Status;
use voice::Voice;
use watch::watch;

/// Stack for the deepest expressions that the default limits allow, and for each further level.
const STACK: usize = 16 << 20;
const STACK_OF_LEVEL: usize = 32 << 10;

/// Runs the command line of this process and returns its exit status.
#[must_use]
pub fn run() -> ExitCode {
    let arguments = match arguments() {
        Ok(arguments) => arguments,
        Err(error) => return answer(&error).into(),
    };
    let interrupt = Interrupt::listen();
    let levels = arguments.limits().nesting.saturating_sub(256);
    let stack = STACK.saturating_add(levels.saturating_mul(STACK_OF_LEVEL));
    let (budget, voice) = (arguments.budget(), Voice::of(&arguments));
    let (sender, receiver) = channel();
    let worker = std::thread::Builder::new().stack_size(stack);
    let work = worker.spawn(move || {
        if let Ok(status) = catch_unwind(AssertUnwindSafe(|| dispatch(&arguments, stack))) {
            let _ = sender.send(status);
        }
    });
    if let Err(error) = work {
        streams::complain(&format!(
            "there is no memory for so many levels (`--max-nesting`): {error}"
        ));
        return Status::Limit.into();
    }
    let status = watch(&receiver, budget, &interrupt, voice);
    // The work may still be going on, after a signal or at a limit.
    staged::abandon();
    progress::end();
    let Some(status) = status else {
        streams::complain(
            "internal error: this is a defect of sweepc, please report it with the input",
        );
        return Status::Internal.into();
    };
    status.into()
}

/// The command line of this process.
fn arguments() -> Result<Arguments, clap::Error> {
    let mut command = Arguments::command();
    let mut matches = command.try_get_matches_from_mut(std::env::args_os())?;
    let arguments = Arguments::from_arg_matches_mut(&mut matches)
        .map_err(|error| error.format(&mut Arguments::command()))?;
    // Both hold hundreds of small pieces, which the end of the process takes away at once.
    std::mem::forget((command, matches));
    Ok(arguments)
}

/// What is printed instead of a run: help, the version, or what is wrong with the command line.
fn answer(error: &clap::Error) -> Status {
    let printed = error.print();
    let lost = printed.is_err_and(|own| own.kind() != std::io::ErrorKind::BrokenPipe);
    match (error.use_stderr(), lost) {
        (true, _) => Status::Usage,
        (false, true) => Status::File,
        (false, false) => Status::Success,
    }
}

fn dispatch(arguments: &Arguments, stack: usize) -> Status {
    match &arguments.command {
        Command::Check(own) => check::run(own, arguments, stack),
        Command::Report(own) => report::run(own, arguments),
        Command::Compile(own) => compile::run(own, arguments, stack),
        Command::Explain(own) => explain::run(own, arguments),
        Command::Fmt(own) => fmt::run(own, arguments),
        Command::Completions(own) => completions::run(own),
        Command::Man(own) => man::run(own, arguments),
    }
}
