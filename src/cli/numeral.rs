use crate::diag::{Code, Diagnostic, Limits, Span};
use crate::number::Rational;

use super::refusal::Refusal;
use super::session::Misuse;

/// Why a text is no number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum NumeralFault {
    /// It is no exact number.
    Malformed,
    /// A literal in it has so many digits; more than the limit (E0503).
    Digits { count: usize, limit: usize },
    /// The exponent of a literal in it is above the limit (E0504).
    Exponent { limit: u32 },
}

/// Reads an exact number from outside a source: `7`, `-3/2`, `0.25`, `1.5e-3`. The literals in it
/// keep to the limits, as those in a source do.
pub(super) fn numeral(text: &str, limits: &Limits) -> Result<Rational, NumeralFault> {
    for literal in text.split('/') {
        check(literal.trim(), limits)?;
    }
    Rational::from_text(text.trim(), limits.exponent).ok_or(NumeralFault::Malformed)
}

fn check(literal: &str, limits: &Limits) -> Result<(), NumeralFault> {
    let is_numeric = |own: char| own.is_ascii_digit() || "+-−.eE".contains(own);
    if !literal.chars().all(is_numeric) {
        return Err(NumeralFault::Malformed);
    }
    let limit = limits.digits;
    let count = literal.bytes().filter(u8::is_ascii_digit).count();
    if count > limit {
        return Err(NumeralFault::Digits { count, limit });
    }
    let Some((mantissa, exponent)) = literal.split_once(['e', 'E']) else {
        return Ok(());
    };
    let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
    let is_exponent = !digits.is_empty() && digits.bytes().all(|own| own.is_ascii_digit());
    if !is_exponent || Rational::from_text(mantissa, 0).is_none() {
        return Err(NumeralFault::Malformed);
    }
    let limit = limits.exponent;
    match digits.parse::<u32>() {
        Ok(own) if own <= limit => Ok(()),
        _ => Err(NumeralFault::Exponent { limit }),
    }
}

impl NumeralFault {
    /// The refusal of an option that is given this text.
    pub(super) fn of_option(self, text: &str, option: &str) -> Refusal {
        let message = self.message(text);
        match self.limit() {
            None => Misuse(message).into(),
            Some((code, help)) => Diagnostic::global(code, message)
                .note(format!("it is given with `{option}`"))
                .help(help)
                .into(),
        }
    }

    /// The finding at a place of a list (E0605, E0503, E0504).
    pub(super) fn at(self, span: Span, text: &str) -> Diagnostic {
        let message = self.message(text);
        match self.limit() {
            None => Diagnostic::new(Code::E0605, span, message),
            Some((code, help)) => Diagnostic::new(code, span, message).help(help),
        }
    }

    fn message(&self, text: &str) -> String {
        match self {
            Self::Malformed => format!("`{text}` is not an exact number such as 3/2 or 0.25"),
            Self::Digits { count, limit } => {
                format!("a number of {count} digits, the limit is {limit}")
            }
            Self::Exponent { limit } => format!("an exponent in `{text}` exceeds {limit}"),
        }
    }

    /// The limit that is exceeded, and the way to raise it.
    fn limit(&self) -> Option<(Code, &'static str)> {
        match self {
            Self::Malformed => None,
            Self::Digits { .. } => Some((Code::E0503, "`--max-digits` raises the limit")),
            Self::Exponent { .. } => Some((Code::E0504, "raise the limit with `--max-exponent`")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_literal_keeps_to_the_limits() {
        let limits = Limits {
            digits: 4,
            exponent: 20,
            ..Limits::default()
        };
        let digits = |count| Err(NumeralFault::Digits { count, limit: 4 });
        let exponent = Err(NumeralFault::Exponent { limit: 20 });
        for (text, expected) in [
            ("1234/4321", Ok(Rational::new(1234.into(), 4321.into()))),
            (" -15e-1 ", Ok(Rational::new((-3).into(), 2.into()))),
            ("12345", digits(5)),
            ("1/1.2345", digits(5)),
            ("1e21", exponent.clone()),
            ("1/1E-21", exponent.clone()),
            ("1e+99", exponent),
            ("1e999999", digits(7)),
            ("e21", Err(NumeralFault::Malformed)),
            ("1e+-21", Err(NumeralFault::Malformed)),
            ("a12345", Err(NumeralFault::Malformed)),
            ("1/0", Err(NumeralFault::Malformed)),
            ("", Err(NumeralFault::Malformed)),
        ] {
            assert_eq!(numeral(text, &limits), expected, "{text}");
        }
    }

    #[test]
    fn an_exponent_beyond_all_bounds() {
        let limit = u32::MAX;
        let limits = Limits {
            exponent: limit,
            ..Limits::default()
        };
        let fault = Err(NumeralFault::Exponent { limit });
        assert_eq!(numeral("1e99999999999999999999", &limits), fault);
    }
}
