use nom::error::{ErrorKind, ParseError};

use super::hint::{end_of, hinted, is_over};
use super::stream::{Source, Stream};
use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::lexer::{Keyword, TokenKind};

/// Why a parser stopped.
#[derive(Debug)]
pub(super) enum Fault {
    /// Another token was expected than the one at the index.
    Expected { at: usize, what: &'static str },
    /// The finding is made; the parser goes on behind the index.
    Told { at: usize, finding: Box<Diagnostic> },
}

impl Fault {
    /// Where it stopped.
    pub(super) fn at(&self) -> usize {
        match self {
            Fault::Expected { at, .. } | Fault::Told { at, .. } => *at,
        }
    }

    /// Whether another declaration begins where it stopped.
    pub(super) fn is_at_the_end(&self, source: &Source<'_>) -> bool {
        match self {
            Fault::Expected { at, what } => is_over(source, *at, what),
            Fault::Told { .. } => false,
        }
    }

    /// The finding; none if the token was reported when it was read.
    pub(super) fn into_finding(self, source: &Source<'_>) -> Option<Diagnostic> {
        match self {
            Fault::Told { finding, .. } => Some(*finding),
            Fault::Expected { at, what } => unexpected(source, at, what),
        }
    }
}

impl<'a> ParseError<Stream<'a>> for Fault {
    fn from_error_kind(input: Stream<'a>, _: ErrorKind) -> Self {
        Fault::Expected {
            at: input.at,
            what: "something else",
        }
    }

    fn append(_: Stream<'a>, _: ErrorKind, other: Self) -> Self {
        other
    }
}

/// What a parser over tokens returns.
pub(super) type Parsed<'a, O> = nom::IResult<Stream<'a>, O, Fault>;

/// Not this alternative: another token was expected.
pub(super) fn expected<'a, O>(input: Stream<'a>, what: &'static str) -> Parsed<'a, O> {
    Err(nom::Err::Error(Fault::Expected { at: input.at, what }))
}

/// No alternative: the finding says what is wrong.
pub(super) fn told<O>(input: Stream<'_>, finding: Diagnostic) -> Parsed<'_, O> {
    Err(nom::Err::Failure(Fault::Told {
        at: input.at,
        finding: Box::new(finding),
    }))
}

/// E0006 at a place, or what it is more precisely: E0007, E0103.
fn unexpected(source: &Source<'_>, at: usize, what: &'static str) -> Option<Diagnostic> {
    let token = source.token(at);
    let span = source.span(token);
    match token.kind {
        TokenKind::Unknown => return None,
        TokenKind::Keyword(keyword)
            if source.is_misused_keyword(at)
                || (what == "a name" && !keyword.begins_declaration()) =>
        {
            return Some(keyword_as_name(keyword, span));
        }
        TokenKind::Number if what == "a name" => {
            if let Some(finding) = decimal_comma(source, at.wrapping_sub(1)) {
                return Some(finding);
            }
        }
        _ => {}
    }
    let (span, found) = match is_over(source, at, what) {
        true => {
            let last = source.span(source.token(at - 1));
            (end_of(last), "the end of the declaration".to_owned())
        }
        false => (span, source.described(token)),
    };
    let message = format!("expected {what}, found {found}");
    let finding = Diagnostic::new(Code::E0006, span, message);
    Some(hinted(finding, source, at, what))
}

/// E0103.
fn keyword_as_name(keyword: Keyword, span: Span) -> Diagnostic {
    let message = format!("`{}` is a keyword and cannot be a name", keyword.as_str());
    Diagnostic::new(Code::E0103, span, message).help("choose another name")
}

/// E0007, where the comma at the index touches a digit on either side.
pub(super) fn decimal_comma(source: &Source<'_>, comma: usize) -> Option<Diagnostic> {
    use TokenKind::{Comma, Number};
    let before = comma.checked_sub(1)?;
    let kinds = [before, comma, comma + 1].map(|index| source.kind(index));
    if kinds != [Number, Comma, Number]
        || !source.touches_next(before)
        || !source.touches_next(comma)
    {
        return None;
    }
    let (left, right) = (source.token(before), source.token(comma + 1));
    let (left, right) = (source.written(left), source.written(right));
    let span = source.span(source.token(before));
    let span = span.to(source.span(source.token(comma + 1)));
    let finding = Diagnostic::new(Code::E0007, span, "a comma is not a decimal point");
    Some(if left.len() + right.len() < 40 {
        let number = format!("{left}.{right}");
        finding.help(format!("write `{number}`")).fix(span, number)
    } else {
        finding.help("write a point")
    })
}
