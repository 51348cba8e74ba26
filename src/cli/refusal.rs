use crate::diag::{Diagnostic, Diagnostics, SourceMap};

use super::session::Misuse;
use super::status::Status;
use super::voice::Voice;

/// Why what a command line asks for is not begun.
#[derive(Debug)]
pub(super) enum Refusal {
    Misuse(Misuse),
    Findings(Diagnostics, SourceMap),
}

impl Refusal {
    /// Tells it.
    pub(super) fn complain(&self, voice: Voice) -> Status {
        match self {
            Self::Misuse(misuse) => misuse.complain(),
            Self::Findings(findings, sources) => {
                voice.tell(findings, sources);
                Status::of(findings)
            }
        }
    }
}

impl From<Misuse> for Refusal {
    fn from(own: Misuse) -> Self {
        Self::Misuse(own)
    }
}

impl From<Diagnostic> for Refusal {
    fn from(own: Diagnostic) -> Self {
        let mut findings = Diagnostics::default();
        findings.push(own);
        Self::Findings(findings, SourceMap::default())
    }
}
