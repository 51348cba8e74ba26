use std::fmt;

/// The reference to an entity, `#n`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Id(usize);

impl fmt::Display for Id {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "#{}", self.0)
    }
}

/// The data section of an exchange file (ISO 10303-21): numbered entities, one a line.
#[derive(Debug, Default)]
pub(super) struct Entities {
    text: String,
    count: usize,
}

impl Entities {
    /// Appends `#n=NAME(attributes);`, or a complex entity `#n=(…);`, and returns #n.
    pub(super) fn add(&mut self, entity: &str) -> Id {
        self.count += 1;
        let id = Id(self.count);
        self.text.push_str(&format!("{id}={entity};\n"));
        id
    }

    /// Appends a complex entity from its parts, in the alphabetical order that readers rely on.
    pub(super) fn add_complex(&mut self, parts: &mut [String]) -> Id {
        parts.sort_by(|left, right| record_name(left).cmp(record_name(right)));
        self.add(&format!("({})", parts.join(" ")))
    }

    /// All entities.
    pub(super) fn text(&self) -> &str {
        &self.text
    }
}

/// `NAME` of `NAME(attributes)`
fn record_name(part: &str) -> &str {
    part.split('(').next().unwrap_or(part)
}

/// `(a,b,c)`
pub(super) fn list<T: fmt::Display>(items: impl IntoIterator<Item = T>) -> String {
    let items: Vec<_> = items.into_iter().map(|item| item.to_string()).collect();
    format!("({})", items.join(","))
}

/// A text as a string of the exchange file: printable ASCII as it is, `'` and `\` doubled, other
/// characters by their number, `\X2\03C3\X0\`; `\X4\…\X0\` beyond the basic plane.
pub(super) fn string(text: &str) -> String {
    let mut encoded = String::from("'");
    let mut open = None;
    for character in text.chars() {
        let number = u32::from(character);
        let mode = match number {
            0x20..0x7F => None,
            0x1_0000.. => Some("\\X4\\"),
            _ => Some("\\X2\\"),
        };
        if mode != open {
            if open.is_some() {
                encoded.push_str("\\X0\\");
            }
            encoded.push_str(mode.unwrap_or_default());
            open = mode;
        }
        match (mode, character) {
            (None, '\'' | '\\') => encoded.extend([character, character]),
            (None, _) => encoded.push(character),
            (Some("\\X4\\"), _) => encoded.push_str(&format!("{number:08X}")),
            (Some(_), _) => encoded.push_str(&format!("{number:04X}")),
        }
    }
    if open.is_some() {
        encoded.push_str("\\X0\\");
    }
    encoded.push('\'');
    encoded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_are_escaped() {
        assert_eq!(string("plain"), "'plain'");
        assert_eq!(string("it's a\\b"), "'it''s a\\\\b'");
        assert_eq!(string("σκ_1"), "'\\X2\\03C303BA\\X0\\_1'");
        assert_eq!(string("a\nb"), "'a\\X2\\000A\\X0\\b'");
        assert_eq!(string("σ😀"), "'\\X2\\03C3\\X0\\\\X4\\0001F600\\X0\\'");
        assert_eq!(string(""), "''");
    }

    #[test]
    fn complex_entities_are_sorted_by_name() {
        let mut entities = Entities::default();
        let id =
            entities.add_complex(&mut ["B_SPLINE_CURVE(1)", "BOUNDED_CURVE()"].map(str::to_owned));
        assert_eq!(entities.text(), "#1=(BOUNDED_CURVE() B_SPLINE_CURVE(1));\n");
        assert_eq!(id.to_string(), "#1");
    }
}
