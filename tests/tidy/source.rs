//! A source file with its comments and literals told apart from its code.

/// A file. `code` and `comments` have the lines of `text`, with everything else blanked.
pub(crate) struct Source {
    /// Relative to the root of the project, with `/` between folders.
    pub(crate) name: String,
    /// The file as it stands.
    pub(crate) text: String,
    /// Without comments, and without the contents of string and character literals.
    pub(crate) code: String,
    /// The comments alone.
    pub(crate) comments: String,
    /// The string literals as written between their quotes, with the line they begin on.
    pub(crate) literals: Vec<(usize, String)>,
}

/// What a byte of a file belongs to.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Code,
    Comment,
    Literal,
}

impl Source {
    /// Takes a file apart: Rust by its lexical rules, anything else by `#` comments.
    pub(crate) fn new(name: &str, text: &str) -> Self {
        let parts = if name.ends_with(".rs") {
            rust_parts(text)
        } else {
            sweep_parts(text)
        };
        let keep = |wanted: Part| -> String {
            let bytes = text.bytes().zip(&parts);
            let kept = bytes.map(|(byte, part)| {
                if *part == wanted || byte == b'\n' {
                    byte
                } else {
                    b' '
                }
            });
            String::from_utf8_lossy(&kept.collect::<Vec<_>>()).into_owned()
        };
        Self {
            name: name.to_owned(),
            text: text.to_owned(),
            code: keep(Part::Code),
            comments: keep(Part::Comment),
            literals: literals(text, &parts),
        }
    }

    /// A place in this file, for a finding.
    pub(crate) fn at(&self, line: usize) -> String {
        format!("{}:{line}", self.name)
    }

    /// The words of the code (identifiers, keywords, numbers) with their offset and line.
    pub(crate) fn words(&self) -> Vec<Word<'_>> {
        words(&self.code)
    }
}

/// A word of a text.
#[derive(Clone, Copy)]
pub(crate) struct Word<'a> {
    pub(crate) text: &'a str,
    pub(crate) start: usize,
    pub(crate) line: usize,
}

/// The maximal runs of letters, digits and underscores.
pub(crate) fn words(text: &str) -> Vec<Word<'_>> {
    let mut found = Vec::new();
    let (mut start, mut line) = (None, 1);
    for (at, c) in text.char_indices().chain([(text.len(), '\n')]) {
        let inside = c.is_alphanumeric() || c == '_';
        match (start, inside) {
            (None, true) => start = Some(at),
            (Some(from), false) => {
                found.push(Word {
                    text: &text[from..at],
                    start: from,
                    line,
                });
                start = None;
            }
            _ => {}
        }
        line += usize::from(c == '\n');
    }
    found
}

/// The literals of a text, without their quotes.
fn literals(text: &str, parts: &[Part]) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < parts.len() {
        let length = parts[at..]
            .iter()
            .take_while(|part| **part == parts[at])
            .count();
        if parts[at] == Part::Literal {
            let line = 1 + text[..at].matches('\n').count();
            found.push((line, text[at..at + length].to_owned()));
        }
        at += length;
    }
    found
}

/// `#` comments; the language has strings only in imports, and those hold no `#`.
fn sweep_parts(text: &str) -> Vec<Part> {
    let mut parts = Vec::with_capacity(text.len());
    let mut part = Part::Code;
    for byte in text.bytes() {
        part = match (part, byte) {
            (_, b'\n') => Part::Code,
            (Part::Code, b'#') => Part::Comment,
            _ => part,
        };
        parts.push(part);
    }
    parts
}

/// A stretch of Rust: `open` bytes of code, then `body` bytes of `part`, then `close` bytes of code.
struct Stretch {
    part: Part,
    open: usize,
    body: usize,
    close: usize,
}

/// Line and nested block comments, plain and raw strings, characters.
fn rust_parts(text: &str) -> Vec<Part> {
    let bytes = text.as_bytes();
    let mut parts = vec![Part::Code; bytes.len()];
    let mut at = 0;
    while at < bytes.len() {
        let after_word = at > 0 && (bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'_');
        let Stretch {
            part,
            open,
            body,
            close,
        } = stretch(&bytes[at..], after_word);
        let end = (at + open + body).min(bytes.len());
        parts[at + open..end].fill(part);
        at = end + close;
    }
    parts
}

/// The stretch at the start of some Rust.
fn stretch(rest: &[u8], after_word: bool) -> Stretch {
    let comment = |body| Stretch {
        part: Part::Comment,
        open: 0,
        body,
        close: 0,
    };
    if rest.starts_with(b"//") {
        return comment(
            rest.iter()
                .position(|byte| *byte == b'\n')
                .unwrap_or(rest.len()),
        );
    }
    if rest.starts_with(b"/*") {
        return comment(block_comment(rest));
    }
    let raw = if after_word { None } else { raw_string(rest) };
    let plain = Stretch {
        part: Part::Code,
        open: 1,
        body: 0,
        close: 0,
    };
    raw.or_else(|| quotation(rest)).unwrap_or(plain)
}

/// A string or a character; a lifetime has no quote after its first character.
fn quotation(rest: &[u8]) -> Option<Stretch> {
    let body = match rest {
        [b'"', body @ ..] => quoted(body, b'"'),
        [b'\'', b'\\', ..] => quoted(&rest[1..], b'\''),
        [b'\'', first, ..] => {
            let width = first.leading_ones().max(1) as usize;
            (rest.get(1 + width) == Some(&b'\'')).then_some(width)?
        }
        _ => return None,
    };
    Some(Stretch {
        part: Part::Literal,
        open: 1,
        body,
        close: 1,
    })
}

/// A raw string.
fn raw_string(rest: &[u8]) -> Option<Stretch> {
    let prefix = [&b"r"[..], b"br", b"cr"]
        .into_iter()
        .find(|prefix| rest.starts_with(prefix))?;
    let hashes = rest[prefix.len()..]
        .iter()
        .take_while(|byte| **byte == b'#')
        .count();
    let open = prefix.len() + hashes + 1;
    let content = rest.get(open..).filter(|_| rest[open - 1] == b'"')?;
    let close = [vec![b'"'], vec![b'#'; hashes]].concat();
    let end = content
        .windows(close.len())
        .position(|window| window == close);
    let body = end.unwrap_or(content.len());
    Some(Stretch {
        part: Part::Literal,
        open,
        body,
        close: close.len(),
    })
}

/// The length of a block comment, with the comments inside it.
fn block_comment(rest: &[u8]) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < rest.len() {
        if rest[at..].starts_with(b"/*") {
            depth += 1;
            at += 2;
        } else if rest[at..].starts_with(b"*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                break;
            }
        } else {
            at += 1;
        }
    }
    at.min(rest.len())
}

/// The length up to a closing quote, over escapes.
fn quoted(body: &[u8], quote: u8) -> usize {
    let mut at = 0;
    while at < body.len() && body[at] != quote {
        at += if body[at] == b'\\' { 2 } else { 1 };
    }
    at.min(body.len())
}

#[test]
fn rust_is_taken_apart() {
    let text = r##"let a = "x // y"; // "note"
/* f32 /* nested */ still */ let b = 'c'; fn f<'a>() {} let d = r#"q " r"#; let e = '\'';
"##;
    let file = Source::new("src/a.rs", text);
    assert_eq!(
        file.literals,
        [
            (1, "x // y".to_owned()),
            (2, "c".to_owned()),
            (2, "q \" r".to_owned()),
            (2, "\\'".to_owned()),
        ]
    );
    assert!(file.comments.contains("// \"note\"") && file.comments.contains("still */"));
    let words: Vec<_> = file.words().iter().map(|word| word.text).collect();
    assert_eq!(
        words,
        [
            "let", "a", "let", "b", "fn", "f", "a", "let", "d", "r", "let", "e"
        ]
    );
    assert_eq!(file.code.lines().count(), text.lines().count());
}
