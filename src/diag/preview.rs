use std::borrow::Cow;
use std::ops::Range;

use super::clipped::clipped;

/// The longest line that is shown whole, in characters.
const LONGEST: usize = 200;
/// What is shown of a longer one on either side of the change.
const SIDE: usize = 60;

/// The lines that an edit changes, as they are shown: of very long ones what stands around the
/// change.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Preview<'a> {
    pub(super) text: Cow<'a, str>,
    /// The number of its first line.
    pub(super) first: usize,
    /// What is replaced in it.
    pub(super) change: Range<usize>,
    pub(super) replacement: Cow<'a, str>,
}

impl<'a> Preview<'a> {
    /// The preview of an edit; the range lies on character boundaries.
    pub(super) fn of(text: Cow<'a, str>, change: Range<usize>, replacement: &'a str) -> Self {
        let shown = lines_around(&text, &change);
        let mut lines = text[shown].lines().chain(replacement.lines());
        if lines.any(is_long) {
            return Self::around(&text, change, replacement);
        }
        Self {
            text,
            first: 1,
            change,
            replacement: Cow::Borrowed(replacement),
        }
    }

    fn around(text: &str, change: Range<usize>, replacement: &'a str) -> Self {
        let (change, replacement) = narrowed(text, change, replacement);
        let shown = lines_around(text, &change);
        let mut own = ending(&text[shown.start..change.start]).into_owned();
        let start = own.len();
        own.push_str(&clipped(&text[change.clone()]));
        let end = own.len();
        own.push_str(&beginning(text[change.end..shown.end].trim_end()));
        Self {
            text: Cow::Owned(own),
            first: text[..shown.start].matches('\n').count() + 1,
            change: start..end,
            replacement: clipped(replacement),
        }
    }
}

/// The whole lines that a range touches, without the last line feed.
fn lines_around(text: &str, range: &Range<usize>) -> Range<usize> {
    let start = text[..range.start].rfind('\n').map_or(0, |own| own + 1);
    let end = text[range.end..].find('\n');
    start..end.map_or(text.len(), |own| range.end + own)
}

fn is_long(line: &str) -> bool {
    line.len() > LONGEST && line.chars().count() > LONGEST
}

/// The edit without the text at its ends that stays as it is.
fn narrowed<'a>(text: &str, change: Range<usize>, replacement: &'a str) -> (Range<usize>, &'a str) {
    let removed = &text[change.clone()];
    let same = |(one, other): &(char, char)| one == other;
    let pairs = removed.chars().zip(replacement.chars());
    let start: usize = pairs.take_while(same).map(|(own, _)| own.len_utf8()).sum();
    let (removed, replacement) = (&removed[start..], &replacement[start..]);
    let pairs = removed.chars().rev().zip(replacement.chars().rev());
    let end: usize = pairs.take_while(same).map(|(own, _)| own.len_utf8()).sum();
    let replacement = &replacement[..replacement.len() - end];
    (change.start + start..change.end - end, replacement)
}

/// The end of a text.
fn ending(text: &str) -> Cow<'_, str> {
    match text.char_indices().rev().nth(SIDE) {
        Some((before, own)) => Cow::Owned(format!("… {}", &text[before + own.len_utf8()..])),
        None => Cow::Borrowed(text),
    }
}

/// The beginning of a text.
fn beginning(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(SIDE) {
        Some((offset, _)) => Cow::Owned(format!("{} …", &text[..offset])),
        None => Cow::Borrowed(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_lines_are_shown_as_they_are() {
        let text = format!("{}\nlet a = 1,5\n", "x".repeat(LONGEST + 1));
        let comma = text.find(',').unwrap_or_default();
        let preview = Preview::of(Cow::Borrowed(&text), comma..comma + 1, ".");
        assert_eq!(preview.text, text);
        assert_eq!((preview.first, preview.change), (1, comma..comma + 1));
    }

    #[test]
    fn a_long_line_is_shown_around_the_change() {
        let (before, after) = ("κ".repeat(LONGEST), "x".repeat(LONGEST));
        let text = format!("unit mm\n{before}1,5{after}\r\n");
        let comma = text.find(',').unwrap_or_default();
        let preview = Preview::of(Cow::Borrowed(&text), comma - 1..comma + 2, "1.5");
        let (start, end) = ("κ".repeat(SIDE - 1), "x".repeat(SIDE - 1));
        assert_eq!(preview.text, format!("… {start}1,5{end} …"));
        assert_eq!(preview.first, 2);
        assert_eq!(&preview.text[preview.change], ",");
        assert_eq!(preview.replacement, ".");
    }

    #[test]
    fn what_is_put_in_may_be_long() {
        let long = "x".repeat(1_000_000);
        let preview = Preview::of(Cow::Borrowed("unit mm"), 5..7, &long);
        assert_eq!(preview.text, "unit mm");
        assert!(preview.replacement.len() < 2_000);
    }
}
