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

    /// The exit status that stands for it.
    pub(super) fn number(self) -> u8 {
        match self {
            Self::Success => 0,
            Self::Errors => 1,
            Self::Usage => 2,
            Self::File => 3,
            Self::Limit => 4,
            Self::Internal => 70,
            Self::Interrupted => INTERRUPTED,
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(status.number())
    }
}
