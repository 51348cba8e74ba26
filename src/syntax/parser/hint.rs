//! The way out of the common slips: words, and an edit where it is certain.

use super::stream::Source;
use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::lexer::{Keyword, Token, TokenKind, clipped};

/// What is expected behind the name of a curve.
pub(super) const CURVE_PARAMETER: &str = "the parameter of the curve, `(u)` or `(v)`";
/// What is expected behind `in`.
pub(super) const PLANE: &str = "a plane, `xy`, `xz` or `yz`";
/// What is expected between the domains of a surface.
pub(super) const TIMES: &str = "`x` and the domain in `v`";

const PLANES: [&str; 3] = ["xy", "xz", "yz"];

/// The finding that `what` was expected at an index, with the way out where one is known.
pub(super) fn hinted(
    finding: Diagnostic,
    source: &Source<'_>,
    at: usize,
    what: &'static str,
) -> Diagnostic {
    let finding = match hint(source, at, what) {
        Some(help) => finding.help(help),
        None => finding,
    };
    match edit(source, at, what) {
        Some((span, text)) => finding.fix(span, text),
        None => finding,
    }
}

fn hint(source: &Source<'_>, at: usize, what: &'static str) -> Option<String> {
    use TokenKind::*;
    let token = source.token(at);
    let before = source.kind_before(at);
    let help = match (token.kind, what) {
        (Plus, "an expression") => "a leading `+` has no meaning here; remove it",
        (Slash, "an expression") if before == Slash => "a comment begins with `#`",
        (Star, "an expression") if before == Slash => "a comment begins with `#`",
        (Star, "an expression") if before == Star => "a power is written `^`",
        (DoubleStar, _) => "a power is written `^`",
        (Dot, _) if source.kind(at + 1) == Number => "a number begins with a digit: `0.5`",
        (CloseParenthesis | CloseBracket, _) if before == Comma => "remove the comma",
        (OpenBracket, _) => {
            "a point is written `(a, b)`; a list stands only as an argument of a curve"
        }
        (Text, _) => "a string stands only as an argument and behind `import`",
        (Semicolon, "`)`" | "`]`" | "`,`") if goes_on_behind(source, at) => {
            "write `,` between entries"
        }
        (Semicolon, _) => "no `;` is needed",
        (Equal, "an expression") if before == Equal => "a declaration has one `=`",
        (Colon, "`=`") => "write `=`",
        (Prime | DoublePrime | Name | Dot | Slash, "a string") => {
            "a string stands in double quotes"
        }
        (Keyword(self::Keyword::In), "a unit") => "the units are `mm`, `cm`, `m`, `inch`",
        (_, "an expression") if before == Equal && source.ends_declaration(at) => {
            "write the value behind the `=`"
        }
        (_, "`=`") if is_over(source, at, what) => return Some(value_missing(source, at)),
        (_, "`=`") => return equal_missing(source, at),
        _ => return None,
    };
    Some(help.to_owned())
}

/// Whether the declaration before an index, of which something is missing, goes no further: it
/// ends there, or another one follows on a line of its own without its keyword.
pub(super) fn is_over(source: &Source<'_>, at: usize, what: &str) -> bool {
    let written = source.written(source.token(at));
    let goes_on = PLANES.contains(&written)
        || (nearly(written, "in") && is_plane(source, at + 1))
        || (nearly(written, "on") && source.kind(at + 1) == TokenKind::OpenBracket);
    let is_another = what == "`=`" && source.kind(at) == TokenKind::Name && !goes_on;
    source.ends_declaration(at)
        || (is_another && source.begins_line(at) && has_equal_later(source, at))
}

/// What to write where a declaration ends behind its head. Which value is for the author to say.
fn value_missing(source: &Source<'_>, at: usize) -> String {
    let [keyword, name] = [2, 1].map(|back| source.token(at.wrapping_sub(back)));
    match keyword.kind {
        TokenKind::Keyword(own @ (Keyword::Param | Keyword::Let)) => {
            format!(
                "write `{} {} = 1`, or another value",
                own.as_str(),
                clipped(source.written(name))
            )
        }
        _ => "write `=` and the value".to_owned(),
    }
}

fn equal_missing(source: &Source<'_>, at: usize) -> Option<String> {
    use TokenKind::*;
    let token = source.token(at);
    let written = source.written(token);
    match token.kind {
        Name if PLANES.contains(&written) => Some(format!("write `in {written}`")),
        Name if nearly(written, "in") && is_plane(source, at + 1) => Some("write `in`".to_owned()),
        Name if nearly(written, "on") && source.kind(at + 1) == OpenBracket => {
            Some("write `on`".to_owned())
        }
        Name | Number | OpenParenthesis | Minus => Some("write `=` before the value".to_owned()),
        _ => None,
    }
}

/// Whether another entry may begin behind a token.
fn goes_on_behind(source: &Source<'_>, at: usize) -> bool {
    use TokenKind::*;
    let ends = matches!(
        source.kind(at + 1),
        CloseParenthesis | CloseBracket | Comma | Semicolon | End
    );
    !ends && !source.begins_declaration(at + 1)
}

type Edit = (Span, String);

/// The edit that undoes a slip.
fn edit(source: &Source<'_>, at: usize, what: &'static str) -> Option<Edit> {
    use TokenKind::*;
    let token = source.token(at);
    let span = source.span(token);
    let before = source.kind_before(at);
    let previous = source.span(source.token(at.wrapping_sub(1)));
    let replaced = |span: Span, text: &str| Some((span, text.to_owned()));
    match (token.kind, what) {
        (Plus, "an expression") => replaced(span, ""),
        (Slash, "an expression") if before == Slash && previous.end == span.start => {
            replaced(previous.to(span), "#")
        }
        (Star, "an expression") if before == Star => replaced(previous.to(span), "^"),
        (DoubleStar, _) => replaced(span, "^"),
        (Dot, "an expression") if source.kind(at + 1) == Number && source.touches_next(at) => {
            replaced(start_of(span), "0")
        }
        (CloseParenthesis | CloseBracket, _)
            if before == Comma && surplus(source, at) == (0, 0) =>
        {
            replaced(previous, "")
        }
        (Equal, "an expression") if before == Equal && surplus(source, at) == (0, 0) => {
            replaced(previous.to(span), "=")
        }
        (Colon, "`=`") if source.kind(at + 1) == Equal => {
            replaced(span.to(source.span(source.token(at + 1))), "=")
        }
        (Colon, "`=`") => replaced(span, "="),
        (Semicolon, "`)`" | "`]`" | "`,`") if goes_on_behind(source, at) => commas(source, at),
        (Prime, "a string") => quoted(source, at),
        (Name | Dot | Slash, "a string") => path(source, at),
        (Equal | Keyword(_), "`]`") => replaced(end_of(previous), "]"),
        (Name, PLANE) => {
            let lower = source.written(token).to_ascii_lowercase();
            PLANES.contains(&lower.as_str()).then_some((span, lower))
        }
        (Star | Name, TIMES) if source.kind(at + 1) == OpenBracket => replaced(span, "x"),
        (Comma, TIMES) if source.kind(at + 1) == OpenBracket => replaced(span, " x"),
        (OpenBracket, TIMES) => replaced(start_of(span), "x "),
        (_, CURVE_PARAMETER) => match source.kind(at.wrapping_sub(2)) {
            Keyword(self::Keyword::Profile) => replaced(end_of(previous), "(u)"),
            Keyword(self::Keyword::Sweep) => replaced(end_of(previous), "(v)"),
            _ => None,
        },
        (_, "`=`") => before_the_value(source, at),
        _ => None,
    }
}

/// Commas in place of the semicolon at an index and of those that follow in the brackets around.
fn commas(source: &Source<'_>, at: usize) -> Option<Edit> {
    use TokenKind::*;
    if surplus(source, at) != (0, 0) {
        return None;
    }
    let start = (0..at).rev().find(|own| source.begins_declaration(*own))?;
    let (mut depth, mut last) = (0_usize, at);
    for index in start + 1..source.tokens.len() {
        match source.kind(index) {
            OpenParenthesis | OpenBracket => depth += 1,
            CloseParenthesis | CloseBracket => depth = depth.checked_sub(1)?,
            Semicolon if depth > 0 && goes_on_behind(source, index) => last = index,
            Semicolon => return None,
            _ if source.begins_declaration(index) => break,
            _ => {}
        }
    }
    let whole = source.span(source.token(at));
    let whole = whole.to(source.span(source.token(last)));
    let written = source.slice(whole);
    let is_plain = !written.contains(['#', '"']);
    is_plain.then(|| (whole, written.replace(';', ",")))
}

/// The edit where a declaration goes on without its `=`.
fn before_the_value(source: &Source<'_>, at: usize) -> Option<Edit> {
    use TokenKind::*;
    let token = source.token(at);
    let (span, written) = (source.span(token), source.written(token));
    let edit = match token.kind {
        Name if PLANES.contains(&written) => (start_of(span), "in "),
        Name if nearly(written, "in") && is_plane(source, at + 1) => (span, "in"),
        Name if nearly(written, "on") && source.kind(at + 1) == OpenBracket => (span, "on"),
        Number | OpenParenthesis | Minus if !has_equal_later(source, at) => (start_of(span), "= "),
        _ => return None,
    };
    Some((edit.0, edit.1.to_owned()))
}

/// Whether a word of two letters was probably meant.
fn nearly(written: &str, word: &str) -> bool {
    let written = written.to_lowercase();
    written.chars().count() <= 3 && strsim::damerau_levenshtein(&written, word) <= 1
}

fn is_plane(source: &Source<'_>, at: usize) -> bool {
    PLANES.contains(&source.written(source.token(at)))
}

/// Whether an `=` stands on the same line from an index on.
fn has_equal_later(source: &Source<'_>, at: usize) -> bool {
    let goes_on = |own: &usize| !source.begins_line(*own) && !source.begins_declaration(*own);
    let mut line = (at + 1..source.tokens.len()).take_while(goes_on);
    line.any(|own| source.kind(own) == TokenKind::Equal)
}

/// A string in double quotes where it stands between primes.
fn quoted(source: &Source<'_>, at: usize) -> Option<Edit> {
    let line = (at + 1..source.tokens.len()).take_while(|own| !source.begins_line(*own));
    let mut line = line.take_while(|own| !source.begins_declaration(*own));
    let closing = line.find(|own| source.kind(*own) == TokenKind::Prime)?;
    let (opening, closing) = (source.token(at), source.token(closing));
    let inner = |from: Token, to: Token| source.text.get(from.end as usize..to.start as usize);
    let inner = inner(opening, closing).filter(|own| !own.contains('"'))?;
    let span = source.span(opening).to(source.span(closing));
    Some((span, format!("\"{inner}\"")))
}

/// The name of a `.sweep` file in double quotes where it stands without.
fn path(source: &Source<'_>, at: usize) -> Option<Edit> {
    let span = source.span(source.token(at));
    let line = source.text.get(span.start as usize..)?.lines().next()?;
    let name = line.split('#').next()?.trim_end();
    let end = span.start.checked_add(u32::try_from(name.len()).ok()?)?;
    let is_name = name.ends_with(".sweep") && !name.contains(char::is_whitespace);
    (is_name && !name.contains('"')).then(|| (Span { end, ..span }, format!("\"{name}\"")))
}

/// The edit where a bracket is closed by one of the other kind, or by that of the bracket around
/// it: what the counts of brackets in this declaration say.
pub(super) fn closing_edit(
    source: &Source<'_>,
    opener: Span,
    at: usize,
    closing: &str,
) -> Option<Edit> {
    let surplus = surplus(source, at);
    let span = source.span(source.token(at));
    let inside = source.slice(end_of(opener).to(start_of(span)));
    match (surplus, closing) {
        ((1, -1), ")") | ((-1, 1), "]") => Some((span, closing.to_owned())),
        ((1, 0), ")") if !inside.contains(['(', '[']) => Some((start_of(span), closing.to_owned())),
        ((0, 1), "]") => Some((start_of(span), closing.to_owned())),
        _ => None,
    }
}

/// E0006 at a relation behind an opening parenthesis of an expectation. The parentheses go where
/// they are all of it.
pub(super) fn claim_in_parentheses(
    source: &Source<'_>,
    opening: usize,
    at: usize,
) -> Option<Diagnostic> {
    let start = source.expectation_around(at)?;
    if !source.kind(at).is_relation() {
        return None;
    }
    let message = "a claim stands without parentheses";
    let finding = Diagnostic::new(Code::E0006, source.span(source.token(at)), message)
        .help("write `expect A == B`, an `expect` for each claim");
    let whole = source.enclosed(opening).filter(|(_, behind)| {
        let ends = source.kind(*behind) == TokenKind::End || source.begins_declaration(*behind);
        opening == start + 1 && ends
    });
    Some(match whole {
        Some((span, _)) => {
            let opener = source.span(source.token(opening));
            let inside = Span {
                start: opener.end,
                end: span.end - 1,
                ..span
            };
            finding.fix(span, source.slice(inside))
        }
        None => finding,
    })
}

/// The point in parentheses that the value of a declaration was meant to be, where its first comma
/// is at an index: `surface R = u, v, 0`.
pub(super) fn point_without_parentheses(source: &Source<'_>, at: usize) -> Option<Edit> {
    use TokenKind::*;
    let start = (0..at).rev().find(|own| source.begins_declaration(*own))?;
    let equal = (start..at).find(|own| source.kind(*own) == Equal)?;
    let in_plane = (start..equal).any(|own| source.kind(own) == Keyword(self::Keyword::In));
    // two numbers alone may be one with a decimal comma
    let numbers = [at - 1, at + 1].map(|own| source.kind(own)) == [Number; 2];
    let entries = match source.kind(start) {
        Keyword(self::Keyword::Let) if !numbers => 2..=3,
        Keyword(self::Keyword::Surface) => 3..=3,
        Keyword(self::Keyword::Profile | self::Keyword::Sweep | self::Keyword::Curve) => {
            if in_plane { 2..=2 } else { 3..=3 }
        }
        _ => return None,
    };
    let (mut depth, mut commas, mut end) = (0_usize, 0_usize, equal + 1);
    while source.kind(end) != End && !source.begins_declaration(end) {
        match source.kind(end) {
            OpenParenthesis | OpenBracket => depth += 1,
            CloseParenthesis | CloseBracket => depth = depth.checked_sub(1)?,
            Comma if depth == 0 && source.kind(end + 1) == Comma => return None,
            Comma if depth == 0 => commas += 1,
            Unknown | Text | Equal | Colon | Semicolon => return None,
            kind if kind.is_relation() => return None,
            _ => {}
        }
        end += 1;
    }
    let whole = depth == 0 && source.kind_before(end) != Comma && entries.contains(&(commas + 1));
    let first = source.span(source.token(equal + 1));
    let value = first.to(source.span(source.token(end - 1)));
    whole.then(|| (value, format!("({})", source.slice(value))))
}

/// How many parentheses, and how many square brackets, are opened and not closed in the
/// declaration around an index. Where it is not 0, more is wrong than what was noticed first.
fn surplus(source: &Source<'_>, at: usize) -> (i64, i64) {
    use TokenKind::*;
    let start = (0..at).rev().find(|own| source.begins_declaration(*own));
    let mut surplus = (0, 0);
    for index in start.unwrap_or(at)..source.tokens.len() {
        match source.kind(index) {
            OpenParenthesis => surplus.0 += 1,
            CloseParenthesis => surplus.0 -= 1,
            OpenBracket => surplus.1 += 1,
            CloseBracket => surplus.1 -= 1,
            _ if index > at && source.begins_declaration(index) => break,
            _ => {}
        }
    }
    surplus
}

/// The place before a span.
pub(super) fn start_of(span: Span) -> Span {
    Span {
        end: span.start,
        ..span
    }
}

/// The place behind a span.
pub(super) fn end_of(span: Span) -> Span {
    Span {
        start: span.end,
        ..span
    }
}
