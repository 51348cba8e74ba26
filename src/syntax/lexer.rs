//! Text to tokens: the first half of parsing.

use nom::bytes::complete::{take_till, take_while, take_while1};
use nom::character::complete::{anychar, char, digit1, one_of};
use nom::combinator::{opt, recognize, value};
use nom::{IResult, Input, Parser};

use super::characters::{
    canonical_name, is_invisible, is_name_character, is_word_character, letter_meant, reorders,
    sign_meant, superscript_meant,
};
use crate::diag::{Code, Diagnostic, FileId, Limits, Span};

macro_rules! keywords {
    ($($variant:ident $word:literal,)*) => {
        /// A word that is never a name.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Keyword {
            $(#[doc = concat!("`", $word, "`")] $variant,)*
        }

        impl Keyword {
            /// Every keyword; those that begin a declaration come first.
            pub const ALL: &'static [Keyword] = &[$(Keyword::$variant,)*];

            /// The word.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $(Keyword::$variant => $word,)* }
            }

            /// The keyword that is written so.
            #[must_use]
            pub fn of(word: &str) -> Option<Keyword> {
                match word { $($word => Some(Keyword::$variant),)* _ => None }
            }
        }
    };
}

keywords! {
    Param "param",
    Let "let",
    Profile "profile",
    Sweep "sweep",
    Curve "curve",
    Construction "construction",
    Surface "surface",
    Expect "expect",
    Import "import",
    Unit "unit",
    Where "where",
    In "in",
    On "on",
}

impl Keyword {
    /// The keyword of a declaration that a word was probably meant to be.
    #[must_use]
    pub fn meant(word: &str) -> Option<Keyword> {
        if !(3..=20).contains(&word.len()) {
            return None;
        }
        if word == "assert" {
            return Some(Keyword::Expect);
        }
        let keywords = Keyword::ALL.iter().copied();
        keywords
            .filter(|keyword| keyword.begins_declaration())
            .map(|keyword| (strsim::damerau_levenshtein(word, keyword.as_str()), keyword))
            .filter(|(distance, keyword)| *distance <= 1 + usize::from(keyword.as_str().len() > 4))
            .min_by_key(|(distance, _)| *distance)
            .map(|(_, keyword)| keyword)
    }

    /// Whether a declaration begins with it.
    #[must_use]
    pub fn begins_declaration(self) -> bool {
        !matches!(self, Keyword::Where | Keyword::In | Keyword::On)
    }
}

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TokenKind {
    /// A word that is never a name.
    Keyword(Keyword),
    /// A name.
    Name,
    /// A number.
    Number,
    /// A string, quotes included.
    Text,
    /// `'` or one of its variants
    Prime,
    /// `″`
    DoublePrime,
    /// `+`
    Plus,
    /// `-`, `−`
    Minus,
    /// `*`, `·`, `×`
    Star,
    /// `**`, which the language does not have
    DoubleStar,
    /// `/`
    Slash,
    /// `^`
    Caret,
    /// `(`
    OpenParenthesis,
    /// `)`
    CloseParenthesis,
    /// `[`
    OpenBracket,
    /// `]`
    CloseBracket,
    /// `,`
    Comma,
    /// `:`
    Colon,
    /// `;`, which the language does not have
    Semicolon,
    /// `.`
    Dot,
    /// `=`
    Equal,
    /// `==`
    DoubleEqual,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// Something that was reported when it was read.
    Unknown,
    /// The end of the text, an empty token.
    End,
}

impl TokenKind {
    /// Whether it compares the sides of an expectation.
    #[must_use]
    pub fn is_relation(self) -> bool {
        use TokenKind::*;
        matches!(
            self,
            DoubleEqual | NotEqual | Less | LessOrEqual | Greater | GreaterOrEqual
        )
    }
}

/// A token and its bytes `start..end` in the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Its first byte.
    pub start: u32,
    /// One past its last byte.
    pub end: u32,
}

/// A text in tokens.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Lexed {
    /// The tokens in the order of the text; the last one is [`TokenKind::End`].
    pub tokens: Vec<Token>,
    /// The comments, from `#` to the end of the line.
    pub comments: Vec<Span>,
    /// What was wrong: E0002, E0003, E0004, E0005, E0503; at most one more than
    /// `limits.syntax_errors`.
    pub findings: Vec<Diagnostic>,
}

/// Cuts a text into tokens. Never fails; what has no place in the language is reported and stands
/// in the tokens as what was meant, or as [`TokenKind::Unknown`].
///
/// - **holds** the spans of tokens and comments are disjoint, ascending and on character boundaries
/// - **cost**  linear
#[must_use]
pub fn tokenize(file: FileId, text: &str, limits: &Limits) -> Lexed {
    let mut lexer = Lexer {
        file,
        text,
        limits,
        at: if text.starts_with('\u{FEFF}') { 3 } else { 0 },
        lexed: Lexed::default(),
    };
    loop {
        let rest = text[lexer.at..].trim_start_matches([' ', '\t', '\n', '\r']);
        lexer.at = text.len() - rest.len();
        let Ok((rest, lexeme)) = lexeme(rest) else {
            break;
        };
        let end = text.len() - rest.len();
        lexer.accept(lexeme, end);
        lexer.at = end;
    }
    lexer.emit(TokenKind::End, text.len());
    lexer.lexed
}

/// The name as written, with look-alikes replaced; `None` if one of its letters is not known.
pub(super) fn repaired_word(word: &str) -> Option<String> {
    let mut repaired = String::with_capacity(word.len());
    for c in word.chars().filter(|c| !is_invisible(*c)) {
        repaired.push(match is_name_character(c) {
            true => c,
            false => letter_meant(c)?,
        });
    }
    Some(repaired)
}

/// The tree's spelling of a name token: look-alikes replaced, then [`canonical_name`].
pub(super) fn name_text(word: &str) -> String {
    if word.is_ascii() {
        return canonical_name(word);
    }
    canonical_name(&repaired_word(word).unwrap_or_default())
}

#[derive(Clone, Copy)]
enum Lexeme {
    Comment,
    Word,
    Number { malformed: bool },
    Text { closed: bool },
    Sign(TokenKind),
    Superscript,
    Foreign(char),
}

type Read<'a, O> = IResult<&'a str, O>;

/// The first character says what follows.
fn lexeme(input: &str) -> Read<'_, Lexeme> {
    let (rest, first) = anychar(input)?;
    match first {
        c if c.is_ascii_digit() => number(input),
        c if is_word_character(c) => value(Lexeme::Word, take_while(is_word_character)).parse(rest),
        '#' => value(Lexeme::Comment, line).parse(rest),
        '&' | '|' => value(Lexeme::Foreign(first), take_while(|own| own == first)).parse(rest),
        '"' => string(rest),
        c if is_superscript(c) => {
            value(Lexeme::Superscript, take_while(is_superscript)).parse(rest)
        }
        c => match sign(input) {
            Some((rest, kind)) => Ok((rest, Lexeme::Sign(kind))),
            None => Ok((rest, Lexeme::Foreign(c))),
        },
    }
}

fn is_superscript(c: char) -> bool {
    superscript_meant(c).is_some()
}

/// All up to the end of the line.
fn line(input: &str) -> Read<'_, &str> {
    let end = input.bytes().position(|byte| matches!(byte, b'\n' | b'\r'));
    Ok(input.take_split(end.unwrap_or(input.len())))
}

/// Digits, a point and digits, an exponent: the longest match. What touches it and cannot follow
/// is taken along.
fn number(input: &str) -> Read<'_, Lexeme> {
    let point = (char('.'), digit1);
    let exponent = (char('e'), opt(one_of("+-−")), digit1);
    let (rest, _) = (digit1, opt(point), opt(exponent)).parse(input)?;
    let touching = take_while1(|c: char| c == '.' || c.is_ascii_digit());
    let (rest, touching) = opt(recognize(touching)).parse(rest)?;
    let malformed = touching.is_some();
    Ok((rest, Lexeme::Number { malformed }))
}

/// What follows the opening quote.
fn string(input: &str) -> Read<'_, Lexeme> {
    let (rest, _) = take_till(|c| matches!(c, '"' | '\n' | '\r')).parse(input)?;
    let (rest, closing) = opt(char('"')).parse(rest)?;
    let closed = closing.is_some();
    Ok((rest, Lexeme::Text { closed }))
}

/// The longest sign that a text begins with, and what is behind it.
fn sign(input: &str) -> Option<(&str, TokenKind)> {
    use TokenKind::*;
    let mut characters = input.chars();
    let first = characters.next()?;
    let rest = characters.as_str();
    let or_double = |single, second, double| match rest.strip_prefix(second) {
        Some(rest) => (rest, double),
        None => (rest, single),
    };
    Some(match first {
        '(' => (rest, OpenParenthesis),
        ')' => (rest, CloseParenthesis),
        '[' => (rest, OpenBracket),
        ']' => (rest, CloseBracket),
        ',' => (rest, Comma),
        ':' => (rest, Colon),
        ';' => (rest, Semicolon),
        '.' => (rest, Dot),
        '+' => (rest, Plus),
        '-' | '−' => (rest, Minus),
        '*' => or_double(Star, '*', DoubleStar),
        '·' | '×' => (rest, Star),
        '/' => (rest, Slash),
        '^' => (rest, Caret),
        '\'' | '’' | '′' => (rest, Prime),
        '″' => (rest, DoublePrime),
        '=' => or_double(Equal, '=', DoubleEqual),
        '<' => or_double(Less, '=', LessOrEqual),
        '>' => or_double(Greater, '=', GreaterOrEqual),
        '!' => (rest.strip_prefix('=')?, NotEqual),
        _ => return None,
    })
}

struct Lexer<'a> {
    file: FileId,
    text: &'a str,
    limits: &'a Limits,
    at: usize,
    lexed: Lexed,
}

impl Lexer<'_> {
    /// Takes the lexeme that ends at `end`.
    fn accept(&mut self, lexeme: Lexeme, end: usize) {
        match lexeme {
            Lexeme::Comment => {
                self.inspect(end);
                self.lexed.comments.push(Span::new(self.file, self.at, end));
            }
            Lexeme::Word => self.word(end),
            Lexeme::Number { malformed } => self.number(end, malformed),
            Lexeme::Text { closed } => self.string(end, closed),
            Lexeme::Sign(kind) => self.emit(kind, end),
            Lexeme::Superscript => self.superscript(end),
            Lexeme::Foreign(c) => self.foreign(c, end),
        }
    }

    fn emit(&mut self, kind: TokenKind, end: usize) {
        let Span { start, end, .. } = Span::new(self.file, self.at, end);
        self.lexed.tokens.push(Token { kind, start, end });
    }

    fn report(&mut self, finding: Diagnostic) {
        if self.lexed.findings.len() <= self.limits.syntax_errors {
            self.lexed.findings.push(finding);
        }
    }

    fn word(&mut self, end: usize) {
        let word = &self.text[self.at..end];
        let wrong = word.char_indices().find(|(_, c)| !is_name_character(*c));
        let Some((offset, c)) = wrong else {
            let kind = Keyword::of(word).map_or(TokenKind::Name, TokenKind::Keyword);
            return self.emit(kind, end);
        };
        let repaired = repaired_word(word);
        let start = self.at + offset;
        let mut finding = look_alike(c, Span::new(self.file, start, start + c.len_utf8()));
        if let Some(repaired) = &repaired {
            let help = match repaired.as_str() {
                "" => "remove it".to_owned(),
                _ => format!("write `{}`", clipped(repaired)),
            };
            let whole = Span::new(self.file, self.at, end);
            finding = finding.help(help).fix(whole, repaired.as_str());
        } else {
            finding = finding.help("names are made of Latin and Greek letters, digits and `_`");
        }
        self.report(finding);
        match repaired.as_deref() {
            Some("") => {}
            Some(name) if !name.starts_with(|c: char| c.is_ascii_digit()) => {
                let kind = Keyword::of(name).map_or(TokenKind::Name, TokenKind::Keyword);
                self.emit(kind, end);
            }
            _ => self.emit(TokenKind::Unknown, end),
        }
    }

    fn number(&mut self, end: usize, malformed: bool) {
        let written = &self.text[self.at..end];
        let span = Span::new(self.file, self.at, end);
        let digits = written.bytes().filter(u8::is_ascii_digit).count();
        if digits > self.limits.digits {
            let limit = self.limits.digits;
            let message = format!("a number of {digits} digits, the limit is {limit}");
            self.report(
                Diagnostic::new(Code::E0503, span, message).help("`--max-digits` raises the limit"),
            );
            return self.emit(TokenKind::Unknown, end);
        }
        if !malformed {
            return self.emit(TokenKind::Number, end);
        }
        let message = format!("`{}` is not a number", clipped(written));
        let mut finding = Diagnostic::new(Code::E0004, span, message);
        let before = written.trim_end_matches('.');
        let points = before.bytes().filter(|byte| *byte == b'.').count();
        if before.len() < written.len() && points <= 1 {
            let help = format!("write `{}`", clipped(before));
            finding = finding.help(help).fix(span, before);
        } else {
            finding = finding.help("a number has one decimal point at most");
        }
        self.report(finding);
        self.emit(TokenKind::Unknown, end);
    }

    fn string(&mut self, end: usize, closed: bool) {
        self.inspect(end);
        if closed {
            return self.emit(TokenKind::Text, end);
        }
        let opener = Span::new(self.file, self.at, self.at + 1);
        let finding = Diagnostic::new(Code::E0005, opener, "the string is not closed")
            .related(Span::new(self.file, end, end), "the line ends here")
            .help("write `\"` at its end");
        // The name of an imported file fills its line, unless a comment follows.
        let imports = Some(TokenKind::Keyword(Keyword::Import));
        let written = self.text[self.at..end].trim_end();
        let last = Span::new(self.file, self.at + written.len(), self.at + written.len());
        let whole = self.lexed.tokens.last().map(|own| own.kind) == imports;
        self.report(match whole && !written.contains('#') {
            true => finding.fix(last, "\""),
            false => finding,
        });
        self.emit(TokenKind::Unknown, end);
    }

    /// What no comment and no string may hold either.
    fn inspect(&mut self, end: usize) {
        let written = &self.text[self.at..end];
        if written.is_ascii() && !written.contains('\0') {
            return;
        }
        for (offset, c) in written.char_indices() {
            if c == '\0' || c == '\u{FEFF}' || reorders(c) {
                let start = self.at + offset;
                let span = Span::new(self.file, start, start + c.len_utf8());
                self.report(match c {
                    '\0' => misplaced(c, span),
                    _ => look_alike(c, span).help("remove it").fix(span, ""),
                });
            }
        }
    }

    fn superscript(&mut self, end: usize) {
        let raised = self.text[self.at..end].chars();
        let meant = format!(
            "^{}",
            raised.filter_map(superscript_meant).collect::<String>()
        );
        let span = Span::new(self.file, self.at, end);
        let code_point = self.text[self.at..].chars().next().map_or(0, u32::from);
        let message = format!("a raised digit (U+{code_point:04X}) is not an exponent");
        self.report(
            Diagnostic::new(Code::E0003, span, message)
                .help(format!("write `{}`", clipped(&meant)))
                .fix(span, meant),
        );
        self.emit(TokenKind::Unknown, end);
    }

    /// A character that begins no token.
    fn foreign(&mut self, c: char, end: usize) {
        let span = Span::new(self.file, self.at, end);
        let Some(meant) = sign_meant(c) else {
            let finding = misplaced(c, span);
            self.report(match self.rewritten(c, end) {
                Some((end, text)) => finding.fix(Span::new(self.file, self.at, end), text),
                None => finding,
            });
            if !is_blank(c) {
                self.emit(TokenKind::Unknown, end);
            }
            return;
        };
        let code_point = u32::from(c);
        let finding = if meant == " " {
            let message = format!("the space U+{code_point:04X} is not a plain one");
            Diagnostic::new(Code::E0003, span, message).help("write a space")
        } else {
            let message = format!("`{c}` (U+{code_point:04X}) looks like `{meant}`");
            Diagnostic::new(Code::E0003, span, message).help(format!("write `{meant}`"))
        };
        self.report(finding.fix(span, meant));
        match sign(meant) {
            Some(("", kind)) => self.emit(kind, end),
            _ if meant == " " => {}
            _ => self.emit(TokenKind::Unknown, end),
        }
    }
}

impl Lexer<'_> {
    /// What a character that ends at `end` is in the language, with all that belongs to it: a
    /// radical sign with its radicand, a vulgar fraction, a form feed.
    fn rewritten(&self, c: char, end: usize) -> Option<(usize, String)> {
        let rest = &self.text[end..];
        let fraction = |text: &str| Some((end, text.to_owned()));
        match c {
            '√' if rest.starts_with('(') => Some((end, "sqrt".to_owned())),
            '√' => {
                let (after, Lexeme::Number { malformed: false }) = number(rest).ok()? else {
                    return None;
                };
                let radicand = &rest[..rest.len() - after.len()];
                Some((end + radicand.len(), format!("sqrt({radicand})")))
            }
            '½' => fraction("(1/2)"),
            '⅓' => fraction("(1/3)"),
            '⅔' => fraction("(2/3)"),
            '¼' => fraction("(1/4)"),
            '¾' => fraction("(3/4)"),
            _ if is_blank(c) => fraction(" "),
            _ => None,
        }
    }
}

/// Whether a character that has no place in the language separates tokens all the same.
fn is_blank(c: char) -> bool {
    matches!(c, '\u{B}' | '\u{C}')
}

/// E0003 without its help line.
fn look_alike(c: char, span: Span) -> Diagnostic {
    let code_point = u32::from(c);
    let message = if is_invisible(c) {
        format!("the invisible character U+{code_point:04X} has no place in the language")
    } else if let Some(meant) = letter_meant(c) {
        format!("`{c}` (U+{code_point:04X}) looks like `{meant}`")
    } else if matches!(c, '\u{300}'..='\u{36F}') {
        format!("the accent U+{code_point:04X} has no place in a name")
    } else {
        format!("`{c}` (U+{code_point:04X}) is not a letter of the language")
    };
    Diagnostic::new(Code::E0003, span, message)
}

/// E0002.
fn misplaced(c: char, span: Span) -> Diagnostic {
    let code_point = u32::from(c);
    let finding = if c.is_control() {
        let message = format!("the character U+{code_point:04X} has no place in the language");
        Diagnostic::new(Code::E0002, span, message).note(format!("at byte {}", span.start))
    } else {
        let message = format!("`{c}` (U+{code_point:04X}) has no place in the language");
        Diagnostic::new(Code::E0002, span, message)
    };
    match c {
        '{' | '}' => finding.help("brackets are `(…)`, and `[…]` for lists and domains"),
        '&' => finding.help("an `expect` holds one claim: write an `expect` for each"),
        '|' => finding.help("there is no `or` and no absolute value; `norm2(a)` is a·a"),
        '!' => finding.help("`!=` is the only sign with `!`"),
        '√' => finding.help("write `sqrt(…)`"),
        '°' => finding.help(
            "an angle stands by its cosine and sine: `turn(h)` is those of 2 arctan h, so that \
             `turn(1)` turns by a right angle",
        ),
        _ => finding,
    }
}

/// A piece of the source that fits a message: one line, 40 characters at most.
pub(super) fn clipped(text: &str) -> String {
    let blank = |c: char| if c.is_control() { ' ' } else { c };
    let mut shown: String = text.chars().take(40).map(blank).collect();
    if text.chars().nth(40).is_some() {
        shown.push('…');
    }
    shown
}
