/// A quote of a CSV text that is never closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct OpenQuote {
    /// Where it stands.
    pub(super) at: usize,
    /// Where its line begins, and with it what cannot be read.
    pub(super) line: usize,
}

impl OpenQuote {
    /// Finds it. A quote opens a value at the very start of one; two quotes inside are one of the
    /// value.
    pub(super) fn find(text: &str) -> Option<Self> {
        let bytes = text.as_bytes();
        let (mut at, mut line, mut begins_value) = (0, 0, true);
        while let Some(own) = bytes.get(at) {
            match own {
                b'"' if begins_value => match closing(bytes, at + 1) {
                    Some(end) => at = end,
                    None => return Some(Self { at, line }),
                },
                b'\n' | b'\r' => line = at + 1,
                _ => {}
            }
            begins_value = matches!(own, b',' | b'\n' | b'\r');
            at += 1;
        }
        None
    }
}

/// Where a value ends whose text begins there.
fn closing(bytes: &[u8], mut at: usize) -> Option<usize> {
    loop {
        at += bytes[at..].iter().position(|own| *own == b'"')?;
        if bytes.get(at + 1) != Some(&b'"') {
            return Some(at);
        }
        at += 2;
    }
}

#[test]
fn quotes_that_are_never_closed() {
    for (text, expected) in [
        ("", None),
        ("a,b\n1,2\n", None),
        ("\"a\",\"\"\"\"\n\"1\r\n\",\"\"", None),
        ("a\"\n1\"\n \"2\n", None),
        ("a\n\"2\n", Some((2, 2))),
        ("a,\"", Some((2, 0))),
        ("\"a\n\",b\n1,\"\"\"\n", Some((9, 7))),
    ] {
        let found = OpenQuote::find(text).map(|own| (own.at, own.line));
        assert_eq!(found, expected, "{text:?}");
    }
}
