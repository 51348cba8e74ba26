use std::process::ExitCode;

use crate::diag::{Diagnostics, Severity};

/// The exit status of a run that was asked to end.
pub(super) const INTERRUPTED: u8 = 130;

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Status {
    /// All well.
    Success,
    /// The input has errors or an expectation failed.
    Errors,
    /// The command line is wrong.
    Usage,
    /// A file could not be read or written.
    File,
    /// A limit was reached.
    Limit,
    /// A defect of the program.
    Internal,
    /// The run was asked to end.
    Interrupted,
}

impl Status {
    /// The status that findings amount to.
    pub(super) fn of(diagnostics: &Diagnostics) -> Self {
        let status = |code: crate::diag::Code| {
            if code.is_limit() {
                Self::Limit
            } else if code.is_file() {
                Self::File
            } else if code.severity() == Severity::Error {
                Self::Errors
            } else {
                Self::Success
            }
        };
        diagnostics
            .iter()
            .map(|own| status(own.code))
            .max()
            .unwrap_or(Self::Success)
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(match status {
            Status::Success => 0,
            Status::Errors => 1,
            Status::Usage => 2,
            Status::File => 3,
            Status::Limit => 4,
            Status::Internal => 70,
            Status::Interrupted => INTERRUPTED,
        })
    }
}
