//! Words that stand for another word of the language: other spellings, and the nearest one.

/// Properties of curves by their names in words, and by names that are nearly theirs.
const PROPERTIES: [(&str, &str); 14] = [
    ("tangent", "t"),
    ("T", "t"),
    ("normal", "n"),
    ("N", "n"),
    ("curvature", "κ"),
    ("K", "κ"),
    ("speed", "σ"),
    ("arclength", "s"),
    ("arc_length", "s"),
    ("length", "s"),
    ("radius", "ρ"),
    ("X", "x"),
    ("Y", "y"),
    ("Z", "z"),
];

/// The ASCII names of properties; they are spelt out, so they may be misspelt.
const SPELT_OUT: [&str; 3] = ["kappa", "rho", "sigma"];

/// Length units by other names.
const UNITS: [(&str, &str); 18] = [
    ("millimeter", "mm"),
    ("millimeters", "mm"),
    ("millimetre", "mm"),
    ("millimetres", "mm"),
    ("centimeter", "cm"),
    ("centimeters", "cm"),
    ("centimetre", "cm"),
    ("centimetres", "cm"),
    ("meter", "m"),
    ("meters", "m"),
    ("metre", "m"),
    ("metres", "m"),
    ("mms", "mm"),
    ("cms", "cm"),
    ("inches", "inch"),
    ("zoll", "inch"),
    ("in", "inch"),
    ("inchs", "inch"),
];

/// The property that a word behind the name of a curve was probably meant to be.
pub(super) fn property_meant(word: &str) -> Option<&'static str> {
    let by_name = PROPERTIES.iter().find(|(name, _)| *name == word);
    by_name
        .map(|(_, property)| *property)
        .or_else(|| property_misspelt(word))
}

/// The property in Latin letters that a word is nearly.
pub(super) fn property_misspelt(word: &str) -> Option<&'static str> {
    nearest(word, SPELT_OUT.iter().copied())
}

/// The unit that a word was probably meant to be.
pub(super) fn unit_meant(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    let known = ["mm", "cm", "m", "inch"].into_iter();
    let mut known = known.filter(|own| *own == lower);
    let by_name = UNITS.iter().find(|(name, _)| *name == lower);
    known.next().or(by_name.map(|(_, unit)| *unit))
}

/// The longest word that is taken for a misspelt one.
const LONGEST: usize = 64;

/// The nearest of some words, if it is near: no more than a third of the letters differ, and
/// something of it remains.
///
/// A single letter is like any other; that is no help.
pub fn nearest<T: AsRef<str> + Ord>(word: &str, known: impl Iterator<Item = T>) -> Option<T> {
    let limit = match word.chars().count() {
        length @ 2..=LONGEST => length.div_ceil(3),
        _ => return None,
    };
    known
        .filter(|own| own.as_ref() != word && own.as_ref().chars().count() > 1)
        .map(|own| (distance(word, own.as_ref()), own))
        .filter(|(distance, own)| *distance <= limit && *distance < own.as_ref().chars().count())
        .min()
        .map(|(_, own)| own)
}

/// How many letters differ; none if capital letters are all.
fn distance(one: &str, other: &str) -> usize {
    if one.to_lowercase() == other.to_lowercase() {
        return 0;
    }
    strsim::damerau_levenshtein(one, other)
}
