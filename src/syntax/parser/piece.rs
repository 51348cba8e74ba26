//! The small parsers that the grammar is put together from.

use nom::Input;

use super::fault::{Fault, Parsed, expected, told};
use super::hint::{claim_in_parentheses, closing_edit};
use super::stream::Stream;
use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::ast::Name;
use crate::syntax::lexer::{Keyword, Token, TokenKind};

/// One token of a kind; `what` is its name in a message.
pub(super) fn token<'a>(
    kind: TokenKind,
    what: &'static str,
) -> impl Fn(Stream<'a>) -> Parsed<'a, Token> {
    move |input| {
        let first = input.first();
        if first.kind == kind && input.input_len() > 0 {
            Ok((input.take_from(1), first))
        } else {
            expected(input, what)
        }
    }
}

pub(super) fn keyword<'a>(keyword: Keyword) -> impl Fn(Stream<'a>) -> Parsed<'a, Token> {
    token(TokenKind::Keyword(keyword), keyword.as_str())
}

pub(super) fn comma(input: Stream<'_>) -> Parsed<'_, Token> {
    token(TokenKind::Comma, "`,`")(input)
}

pub(super) fn name(input: Stream<'_>) -> Parsed<'_, Name> {
    let (rest, token) = token(TokenKind::Name, "a name")(input)?;
    Ok((rest, input.source.name(token)))
}

/// One level deeper, up to the limit; E0502 beyond it.
pub(super) fn nested<'a, O>(
    input: Stream<'a>,
    inner: impl FnOnce(Stream<'a>) -> Parsed<'a, O>,
) -> Parsed<'a, O> {
    let depth = input.source.depth.get();
    if depth >= input.source.limits.nesting {
        return told(input, too_deep(input));
    }
    input.source.depth.set(depth + 1);
    let result = inner(input);
    input.source.depth.set(depth);
    result
}

/// E0502.
pub(super) fn too_deep(input: Stream<'_>) -> Diagnostic {
    let limit = input.source.limits.nesting;
    let message = format!("brackets, signs and powers are nested more than {limit} deep");
    Diagnostic::new(Code::E0502, input.span(), message).help("`--max-nesting` raises the limit")
}

/// A pair of brackets.
#[derive(Clone, Copy)]
pub(super) enum Brackets {
    /// `(…)`
    Round,
    /// `[…]`
    Square,
}

impl Brackets {
    fn kinds(self) -> (TokenKind, TokenKind) {
        match self {
            Brackets::Round => (TokenKind::OpenParenthesis, TokenKind::CloseParenthesis),
            Brackets::Square => (TokenKind::OpenBracket, TokenKind::CloseBracket),
        }
    }

    fn opening(self) -> &'static str {
        match self {
            Brackets::Round => "`(`",
            Brackets::Square => "`[`",
        }
    }

    fn closing(self) -> &'static str {
        match self {
            Brackets::Round => "`)`",
            Brackets::Square => "`]`",
        }
    }
}

/// What stands in brackets, and the place of both; behind the opener there is no way back.
pub(super) fn bracketed<'a, O>(
    brackets: Brackets,
    input: Stream<'a>,
    inner: impl FnOnce(Stream<'a>) -> Parsed<'a, O>,
) -> Parsed<'a, (O, Span)> {
    let (open, close) = brackets.kinds();
    let (rest, opener) = token(open, brackets.opening())(input)?;
    let opener = input.source.span(opener);
    let result = nested(input, |_| {
        let (rest, content) = inner(rest)?;
        let (rest, _) = token(close, brackets.closing())(rest)?;
        Ok((rest, content))
    });
    match result {
        Ok((rest, content)) => Ok((rest, (content, input.span_until(rest)))),
        Err(error) => Err(unclosed(error, input, opener, brackets)),
    }
}

/// Makes an error final; one at the end of a file or at the next declaration becomes E0005.
fn unclosed(
    error: nom::Err<Fault>,
    input: Stream<'_>,
    opener: Span,
    brackets: Brackets,
) -> nom::Err<Fault> {
    let source = input.source;
    let fault = match error {
        nom::Err::Error(fault) | nom::Err::Failure(fault) => fault,
        nom::Err::Incomplete(needed) => return nom::Err::Incomplete(needed),
    };
    let Fault::Expected { at, what } = fault else {
        return nom::Err::Failure(fault);
    };
    let noticed = source.token(at);
    let finding = if noticed.kind == TokenKind::End || source.begins_declaration(at) {
        let message = format!("{} is not closed", brackets.opening());
        let remark = match noticed.kind {
            TokenKind::End => "the file ends here",
            _ => "the next declaration begins here",
        };
        Diagnostic::new(Code::E0005, opener, message)
            .related(source.span(noticed), remark)
            .help(format!("write {}", brackets.closing()))
    } else if let Some(finding) = claim_in_parentheses(source, input.at, at) {
        finding
    } else if what == brackets.closing()
        && matches!(
            noticed.kind,
            TokenKind::CloseBracket | TokenKind::CloseParenthesis
        )
    {
        let message = format!("expected {what}, found {}", source.described(noticed));
        let finding = Diagnostic::new(Code::E0006, source.span(noticed), message)
            .related(opener, format!("{} is open", brackets.opening()));
        match closing_edit(source, opener, at, brackets.closing().trim_matches('`')) {
            Some((span, text)) => finding.fix(span, text),
            None => finding,
        }
    } else {
        return nom::Err::Failure(fault);
    };
    nom::Err::Failure(Fault::Told {
        at,
        finding: Box::new(finding),
    })
}
