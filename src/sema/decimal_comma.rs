use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::Expr;

use super::lowerer::Lowerer;

impl Lowerer<'_> {
    /// The way out where a point has too many entries since commas stand in its numbers for points.
    /// It is certain where one does, and one entry is too many.
    pub(super) fn with_decimal_points(&self, finding: Diagnostic, entries: &[Expr]) -> Diagnostic {
        let numbers = self.decimal_commas(entries);
        let (Some(first), None) = (numbers.first(), overlapping(&numbers)) else {
            return finding;
        };
        let number = self.sources.map.slice(*first).replace(',', ".");
        let finding = finding.help(format!("a decimal fraction is written `{number}`"));
        match (numbers.len(), entries.len(), finding.primary) {
            (1, 4, Some(place)) if place.file == first.file => finding.fix(*first, number),
            _ => finding,
        }
    }

    /// The places of digits, a comma and digits where one entry ends and the next one begins.
    fn decimal_commas(&self, entries: &[Expr]) -> Vec<Span> {
        let pairs = entries.windows(2);
        let touching = pairs.filter_map(|pair| match pair {
            [left, right] if left.span.end + 1 == right.span.start => Some(left.span),
            _ => None,
        });
        let numbers = touching.filter_map(|left| {
            let text = &self.sources.map.file(left.file).text;
            let (before, behind) = text.split_at_checked(left.end as usize)?;
            let behind = behind.strip_prefix(',')?;
            let (whole, fraction) = (digits_at_end(before)?, digits_at_start(behind)?);
            let comma = left.end as usize;
            let span = Span::new(left.file, comma - whole, comma + 1 + fraction);
            Some(span)
        });
        numbers.collect()
    }
}

/// How many digits a text ends with, if they are a number of their own.
fn digits_at_end(text: &str) -> Option<usize> {
    let rest = text.trim_end_matches(|own: char| own.is_ascii_digit());
    let goes_on = rest.ends_with(|own: char| own.is_alphanumeric() || matches!(own, '_' | '.'));
    (rest.len() < text.len() && !goes_on).then_some(text.len() - rest.len())
}

/// How many digits a text begins with, if no point follows.
fn digits_at_start(text: &str) -> Option<usize> {
    let rest = text.trim_start_matches(|own: char| own.is_ascii_digit());
    (rest.len() < text.len() && !rest.starts_with('.')).then_some(text.len() - rest.len())
}

/// The first number that shares digits with the one before.
fn overlapping(numbers: &[Span]) -> Option<Span> {
    let pairs = numbers.windows(2);
    let mut shared = pairs.filter(|pair| pair[0].end > pair[1].start);
    shared.next().map(|pair| pair[1])
}
