use crate::diag::{Code, Diagnostic, Span};

/// Why a format cannot carry a surface, or what is odd about the file. It knows the rule and the
/// way out, not the place in the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExportFault {
    /// The rule.
    pub code: Code,
    /// One line, lower case, without a full stop.
    pub message: String,
    /// What to do.
    pub help: String,
}

impl ExportFault {
    /// A fault with its way out.
    #[must_use]
    pub fn new(code: Code, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            code,
            message: message.into(),
            help: help.into(),
        }
    }

    /// The finding at a place in the source.
    #[must_use]
    pub fn at(self, span: Span) -> Diagnostic {
        Diagnostic::new(self.code, span, self.message).help(self.help)
    }
}
