use std::collections::BTreeSet;
use std::io::IsTerminal;

use crate::diag::{Code, Diagnostic, Diagnostics, Severity, SourceMap, Style, render_text};

use super::arguments::{Arguments, Color};
use super::explain::hint;
use super::streams::tell;

/// How a run speaks to its user.
#[derive(Debug, Clone, Copy)]
pub(super) struct Voice {
    style: Style,
    /// Only errors are told.
    pub(super) is_quiet: bool,
    /// The time of every stage is told.
    pub(super) is_verbose: bool,
}

impl Voice {
    /// The voice that the command line asks for.
    pub(super) fn of(arguments: &Arguments) -> Self {
        let coloured = is_coloured(arguments.color, std::io::stderr().is_terminal());
        Self {
            style: if coloured {
                Style::Coloured
            } else {
                Style::Plain
            },
            is_quiet: arguments.quiet,
            is_verbose: arguments.verbose,
        }
    }

    /// The findings that are told.
    pub(super) fn told<'a>(
        &self,
        diagnostics: &'a Diagnostics,
    ) -> impl Iterator<Item = &'a Diagnostic> {
        let errors_only = self.is_quiet;
        let all = diagnostics.iter();
        all.filter(move |own| !errors_only || own.severity() == Severity::Error)
    }

    /// The findings as text.
    pub(super) fn findings(&self, diagnostics: &Diagnostics, sources: &SourceMap) -> String {
        let told = self.told(diagnostics);
        let texts = told.map(|own| render_text(own, sources, self.style) + "\n");
        texts.collect()
    }

    /// Tells findings on standard error, and where to read more of them.
    pub(super) fn tell(&self, diagnostics: &Diagnostics, sources: &SourceMap) {
        tell(&self.findings(diagnostics, sources));
        self.tell_hint(&diagnostics.iter().map(|own| own.code).collect());
    }

    /// One line on standard error that names the pages on some codes.
    pub(super) fn tell_hint(&self, codes: &BTreeSet<Code>) {
        if !codes.is_empty() && !self.is_quiet {
            tell(&format!("{}\n", hint(codes)));
        }
    }
}

/// Whether a stream is to be coloured.
pub(super) fn is_coloured(color: Color, is_terminal: bool) -> bool {
    match color {
        Color::Always => true,
        Color::Never => false,
        Color::Auto => std::env::var_os("NO_COLOR").is_none_or(|own| own.is_empty()) && is_terminal,
    }
}
