use std::borrow::Cow;

/// The longest text of a finding, in characters. Formulas and numbers of a few lines are kept.
const LONGEST: usize = 2_000;
/// What is kept of a longer one, from its start and its end.
const START: usize = 800;
const END: usize = 200;

/// A text as people read it: of a very long one its start and its end.
pub(super) fn clipped(text: &str) -> Cow<'_, str> {
    if text.len() <= LONGEST || text.chars().count() <= LONGEST {
        return Cow::Borrowed(text);
    }
    let offset = |place: Option<(usize, char)>| place.map_or(text.len(), |(offset, _)| offset);
    let start = offset(text.char_indices().nth(START));
    let end = offset(text.char_indices().rev().nth(END - 1));
    Cow::Owned(format!("{} … {}", &text[..start], &text[end..]))
}

#[test]
fn the_middle_of_a_long_text_is_left_out() {
    let short = "κ".repeat(LONGEST);
    assert_eq!(clipped(&short), short);
    let long = format!("a{short}b");
    let expected = format!("a{} … {}b", "κ".repeat(START - 1), "κ".repeat(END - 1));
    assert_eq!(clipped(&long), expected);
}
