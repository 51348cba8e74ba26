use nom::combinator::{cut, opt};
use nom::multi::separated_list1;
use nom::sequence::preceded;
use nom::{Input, Parser};

use super::expression::{expression, unquoted};
use super::fault::{Parsed, decimal_comma, expected, told};
use super::hint::{CURVE_PARAMETER, PLANE, TIMES, end_of, point_without_parentheses, start_of};
use super::piece::{Brackets, bracketed, comma, keyword, name, token};
use super::stream::{Source, Stream};
use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::ast::{Declaration, Expr, Interval, Item, Name, Plane, Relation, Role};
use crate::syntax::lexer::{Keyword, TokenKind, clipped};

/// One declaration, from its keyword on. Every error behind the keyword is final.
pub(super) fn declaration(input: Stream<'_>) -> Parsed<'_, Item> {
    let TokenKind::Keyword(keyword) = input.kind() else {
        return expected(input, "a declaration");
    };
    let rest = input.take_from(1);
    let (rest, declaration) = match keyword {
        Keyword::Param => cut(parameter).parse(rest),
        Keyword::Let => cut(definition).parse(rest),
        Keyword::Profile => cut(|rest| curve(Role::Profile, rest)).parse(rest),
        Keyword::Sweep => cut(|rest| curve(Role::Sweep, rest)).parse(rest),
        Keyword::Curve => cut(|rest| curve(Role::Further, rest)).parse(rest),
        Keyword::Construction => cut(construction).parse(rest),
        Keyword::Surface => cut(surface).parse(rest),
        Keyword::Expect => cut(expectation).parse(rest),
        Keyword::Import => cut(import).parse(rest),
        Keyword::Unit => cut(unit).parse(rest),
        Keyword::Where | Keyword::In | Keyword::On => expected(input, "a declaration"),
    }?;
    let span = input.span_until(rest);
    Ok((rest, Item { span, declaration }))
}

/// `NAME = CONST`
fn parameter(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, (name, _, value)) = (name, equal, expression).parse(input)?;
    Ok((rest, Declaration::Param { name, value }))
}

/// `NAME = EXPR`, `NAME(u, v) = EXPR`
fn definition(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, (name, parameters, _, value)) =
        (name, opt(parameters), equal, expression).parse(input)?;
    let declaration = Declaration::Let {
        name,
        parameters: parameters.unwrap_or_default(),
        value,
    };
    Ok((rest, declaration))
}

/// `(p, c)`
fn parameters(input: Stream<'_>) -> Parsed<'_, Vec<Name>> {
    let (rest, (names, _)) = bracketed(Brackets::Round, input, |input| {
        separated_list1(comma, cut(name)).parse(input)
    })?;
    Ok((rest, names))
}

/// `NAME(u) in PLANE on [a, b] = CURVE`
fn curve(role: Role, input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (behind, (name, parameter)) = (name, curve_parameter).parse(input)?;
    let (rest, (plane, mut domain)) = (opt(plane), opt(on_interval)).parse(behind)?;
    let (rest, plane) = match plane {
        Some(_) => (rest, plane),
        None => {
            let (after, late) = opt(|rest| plane_behind_domain(behind, rest)).parse(rest)?;
            (after, late)
        }
    };
    let (rest, repeated) = opt(on_interval).parse(rest)?;
    if let (Some(first), Some(second)) = (&domain, &repeated) {
        let finding = Diagnostic::new(Code::E0006, second.span, "the domain is given twice");
        rest.source
            .report(finding.related(first.span, "first here"));
    }
    domain = domain.or(repeated);
    let (rest, (_, value)) = (equal, expression).parse(rest)?;
    let declaration = Declaration::Curve {
        role,
        name,
        parameter,
        plane,
        domain,
        value,
    };
    Ok((rest, declaration))
}

/// `(u)`; one name.
fn curve_parameter(input: Stream<'_>) -> Parsed<'_, Name> {
    if input.kind() != TokenKind::OpenParenthesis {
        return expected(input, CURVE_PARAMETER);
    }
    let (rest, (name, _)) = bracketed(Brackets::Round, input, name)?;
    Ok((rest, name))
}

/// `in PLANE`
fn plane(input: Stream<'_>) -> Parsed<'_, (Plane, Span)> {
    let (rest, _) = keyword(Keyword::In)(input)?;
    let plane = match (rest.kind(), rest.source.written(rest.first())) {
        (TokenKind::Name, "xy") => Plane::Xy,
        (TokenKind::Name, "xz") => Plane::Xz,
        (TokenKind::Name, "yz") => Plane::Yz,
        _ => return cut(|rest| expected(rest, PLANE)).parse(rest),
    };
    Ok((rest.take_from(1), (plane, rest.span())))
}

/// `on [a, b] in PLANE`, the wrong way round; the domain begins at `domain`.
fn plane_behind_domain<'a>(domain: Stream<'a>, input: Stream<'a>) -> Parsed<'a, (Plane, Span)> {
    let (rest, found) = plane(input)?;
    let span = input.span_until(rest);
    let finding = Diagnostic::new(Code::E0006, span, "the plane stands before the domain");
    let slice = |span: Span| input.source.slice(span);
    let exchanged = format!("{} {}", slice(span), slice(domain.span_until(input)));
    let finding = finding.help("write `in` before `on`");
    input
        .source
        .report(finding.fix(domain.span_until(rest), exchanged));
    Ok((rest, found))
}

/// `on [a, b]`
fn on_interval(input: Stream<'_>) -> Parsed<'_, Interval> {
    preceded(keyword(Keyword::On), cut(interval)).parse(input)
}

/// `[a, b]`
fn interval(input: Stream<'_>) -> Parsed<'_, Interval> {
    if input.kind() == TokenKind::OpenParenthesis {
        let finding = Diagnostic::new(Code::E0006, input.span(), "expected `[`, found `(`")
            .help("domains are closed: write `[a, b]`");
        let Some((span, _)) = input.source.enclosed(input.at) else {
            return told(input, finding);
        };
        let written = input.source.slice(span);
        let inner = written.get(1..written.len() - 1).unwrap_or_default();
        return told(input, finding.fix(span, format!("[{inner}]")));
    }
    let (rest, ((start, _, end), span)) = bracketed(Brackets::Square, input, |input| {
        let (rest, ends) = (cut(expression), cut(comma), cut(expression)).parse(input)?;
        match rest.kind() {
            TokenKind::CloseParenthesis => {
                let finding = Diagnostic::new(Code::E0006, rest.span(), "expected `]`, found `)`")
                    .help("domains are closed: write `[a, b]`")
                    .fix(rest.span(), "]");
                told(rest, finding)
            }
            TokenKind::Comma => {
                let finding = Diagnostic::new(Code::E0006, rest.span(), "a domain has two ends");
                told(rest, finding.help("a decimal point is written `.`"))
            }
            _ => Ok((rest, ends)),
        }
    })?;
    Ok((rest, Interval { start, end, span }))
}

/// `NAME(p, c) = EXPR where q = EXPR, …`
fn construction(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, name) = name(input)?;
    if rest.kind() != TokenKind::OpenParenthesis {
        return expected(rest, "the parameters of the construction, `(p, c)`");
    }
    let (rest, (parameters, _, body)) = (parameters, equal, expression).parse(rest)?;
    let bindings = preceded(
        keyword(Keyword::Where),
        cut(separated_list1(comma, cut(binding))),
    );
    let (rest, bindings) = opt(bindings).parse(rest)?;
    let declaration = Declaration::Construction {
        name,
        parameters,
        body,
        bindings: bindings.unwrap_or_default(),
    };
    Ok((rest, declaration))
}

/// `q = EXPR`
fn binding(input: Stream<'_>) -> Parsed<'_, (Name, Expr)> {
    let (rest, name) = name(input)?;
    if rest.kind() == TokenKind::OpenParenthesis {
        let message = "a name behind `where` takes no parameters";
        let finding = Diagnostic::new(Code::E0006, rest.span(), message);
        let finding = finding.help(format!("write `{} = …`", name.text));
        return told(rest, without_parameters(rest, finding));
    }
    let (rest, (_, value)) = (equal, expression).parse(rest)?;
    Ok((rest, (name, value)))
}

/// `NAME on [a, b] x [c, d] = EXPR`
fn surface(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, name) = name(input)?;
    if rest.kind() == TokenKind::OpenParenthesis {
        let message = "a surface has no parameter list: it is always in `u` and `v`";
        let finding = Diagnostic::new(Code::E0006, rest.span(), message);
        let finding = finding.help(format!("write `surface {} = …`", name.text));
        return told(rest, without_parameters(rest, finding));
    }
    let domain = (on_interval, cut(times), cut(interval)).map(|(u, (), v)| (u, v));
    let (rest, (domain, _, value)) = (opt(domain), equal, expression).parse(rest)?;
    let declaration = Declaration::Surface {
        name,
        domain,
        value,
    };
    Ok((rest, declaration))
}

/// Adds the edit that removes a parenthesis, if the declaration goes on behind it.
fn without_parameters(input: Stream<'_>, finding: Diagnostic) -> Diagnostic {
    match input.source.enclosed(input.at) {
        Some((span, behind))
            if matches!(
                input.source.kind(behind),
                TokenKind::Equal | TokenKind::Keyword(Keyword::On)
            ) =>
        {
            finding.fix(span, "")
        }
        _ => finding,
    }
}

/// `x` or `×` between two intervals.
fn times(input: Stream<'_>) -> Parsed<'_, ()> {
    match (input.kind(), input.source.written(input.first())) {
        (TokenKind::Name, "x") | (TokenKind::Star, "×") => Ok((input.take_from(1), ())),
        _ => expected(input, TIMES),
    }
}

/// `A == B`, `PREDICATE`
fn expectation(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, left) = expression(input)?;
    let (rest, relation) = opt((relation, cut(expression))).parse(rest)?;
    Ok((rest, Declaration::Expect { left, relation }))
}

fn relation(input: Stream<'_>) -> Parsed<'_, Relation> {
    let after = input.take_from(1);
    let relation = match input.kind() {
        TokenKind::DoubleEqual => Relation::Equal,
        TokenKind::NotEqual => Relation::NotEqual,
        TokenKind::Less => Relation::Less,
        TokenKind::LessOrEqual => Relation::LessOrEqual,
        TokenKind::Greater => Relation::Greater,
        TokenKind::GreaterOrEqual => Relation::GreaterOrEqual,
        TokenKind::Equal => return Ok(relation_meant(input)),
        _ => return expected(input, "a relation"),
    };
    Ok((after, relation))
}

/// What a relation that begins with `=` was meant to be: `=`, `= =`, `=>`, `=<`.
fn relation_meant(input: Stream<'_>) -> (Stream<'_>, Relation) {
    let after = input.take_from(1);
    let behind = after.take_from(1);
    let (rest, meant, relation) = match after.kind() {
        TokenKind::Greater => (behind, ">=", Relation::GreaterOrEqual),
        TokenKind::Less => (behind, "<=", Relation::LessOrEqual),
        TokenKind::Equal => (behind, "==", Relation::Equal),
        _ => (after, "==", Relation::Equal),
    };
    let span = input.span_until(rest);
    let found = clipped(input.source.slice(span));
    let message = format!("an expectation compares with `{meant}`, found `{found}`");
    let finding = Diagnostic::new(Code::E0006, span, message);
    input
        .source
        .report(finding.help(format!("write `{meant}`")).fix(span, meant));
    (rest, relation)
}

/// `"file.sweep"`
fn import(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, path) = unquoted(input)?;
    let path_span = input.span();
    Ok((rest, Declaration::Import { path, path_span }))
}

/// `mm`
fn unit(input: Stream<'_>) -> Parsed<'_, Declaration> {
    let (rest, _) = token(TokenKind::Name, "a unit")(input)?;
    let name = input.source.name(input.first());
    Ok((rest, Declaration::Unit { name }))
}

/// `=`, and `==` with an error.
fn equal(input: Stream<'_>) -> Parsed<'_, ()> {
    if input.kind() == TokenKind::DoubleEqual {
        let message = "a declaration is written with `=`, found `==`";
        let finding = Diagnostic::new(Code::E0006, input.span(), message);
        input
            .source
            .report(finding.help("write `=`").fix(input.span(), "="));
        return Ok((input.take_from(1), ()));
    }
    let (rest, _) = token(TokenKind::Equal, "`=`")(input)?;
    Ok((rest, ()))
}

/// The help where a declaration has no keyword.
pub(super) const MISSING_KEYWORD: &str =
    "every declaration begins with a keyword; a constant with `let`";

/// What is wrong with a token behind a complete declaration, or before the first one.
pub(super) fn stray(input: Stream<'_>) -> Option<Diagnostic> {
    use TokenKind::*;
    let source = input.source;
    let found = source.described(input.first());
    let bare = found.trim_start_matches("the ").trim_start_matches("a ");
    let unexpected = |message: String| Diagnostic::new(Code::E0006, input.span(), message);
    if input.kind() != Unknown
        && let Some((index, keyword)) = misspelt_keyword(input)
    {
        return Some(misspelt(source, index, keyword));
    }
    if input.kind() == Equal && is_nearly_where(source, input.at) {
        return Some(misspelt(source, input.at - 2, self::Keyword::Where));
    }
    let missing = MISSING_KEYWORD;
    let help = match input.kind() {
        Unknown => return None,
        Comma => return Some(stray_comma(source, input.at)),
        Slash => return Some(stray_slash(source, input.at)),
        CloseParenthesis | CloseBracket => {
            return Some(unexpected(format!("{found} closes nothing")));
        }
        Equal => missing,
        relation if relation.is_relation() => {
            if let Some(finding) = conjunction(source, input.at) {
                return Some(finding);
            }
            if let Some(start) = line_of_its_own(source, input.at) {
                let first = source.token(start);
                let message = format!("expected a declaration, found {}", source.described(first));
                let finding = Diagnostic::new(Code::E0006, source.span(first), message);
                let finding = finding.help("write `expect` in front");
                return Some(finding.fix(start_of(source.span(first)), "expect "));
            }
            "one relation stands in an `expect`, and nowhere else"
        }
        Keyword(self::Keyword::Where) => "only a `construction` takes `where`, once",
        Keyword(self::Keyword::In) => "`in` stands before the `=` of a curve",
        Keyword(self::Keyword::On) => "`on` stands before the `=`",
        OpenBracket => "a list stands only as an argument of a curve",
        Text => "a string stands only as an argument and behind `import`",
        Dot if source.kind(input.at + 1) == Number => "a number begins with a digit: `0.5`",
        Name => {
            let message = format!("expected a declaration, found {found}");
            let finding = unexpected(message).help(missing);
            return Some(match is_plain_constant(source, input.at) {
                true => finding.fix(start_of(input.span()), "let "),
                false => finding,
            });
        }
        _ => return Some(unexpected(format!("unexpected {bare}"))),
    };
    Some(unexpected(format!("unexpected {bare}")).help(help))
}

/// E0006 at a stroke that begins no declaration, but perhaps a comment.
fn stray_slash(source: &Source<'_>, at: usize) -> Diagnostic {
    use TokenKind::*;
    let (span, next) = (source.span(source.token(at)), source.token(at + 1));
    if !source.touches_next(at) || !matches!(next.kind, Slash | Star | DoubleStar) {
        return Diagnostic::new(Code::E0006, span, "unexpected `/`");
    }
    let span = span.to(source.span(next));
    let message = format!("unexpected `{}`", source.slice(span));
    let finding = Diagnostic::new(Code::E0006, span, message).help("a comment begins with `#`");
    match next.kind {
        Slash => finding.fix(span, "#"),
        _ => finding,
    }
}

/// E0007, or E0006 at a comma behind a value.
fn stray_comma(source: &Source<'_>, at: usize) -> Diagnostic {
    if let Some(finding) = decimal_comma(source, at) {
        return finding;
    }
    let span = source.span(source.token(at));
    let finding = Diagnostic::new(Code::E0006, span, "unexpected `,`");
    if source.expectation_around(at).is_some() {
        return comma_between_claims(source, at, finding);
    }
    let finding = finding.help("a point is written `(a, b)`");
    match point_without_parentheses(source, at) {
        Some((span, text)) => finding.fix(span, text),
        None => finding,
    }
}

/// The way out at a comma in an expectation. It is certain that another claim follows if that has
/// a relation, or the one before it has none.
fn comma_between_claims(source: &Source<'_>, at: usize, finding: Diagnostic) -> Diagnostic {
    if source.relation_before(at).is_some() && !source.has_relation_behind(at) {
        return finding
            .help("a pair is written `(a, b)`, and each claim is an `expect` of its own");
    }
    let before = source.span(source.token(at - 1));
    let comma = source.span(source.token(at));
    finding
        .help("write an `expect` for each claim")
        .fix(end_of(before).to(comma), "\nexpect")
}

/// E0006 at the `and` between the relation at an index and the one before it.
fn conjunction(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    let first = source.relation_before(at)?;
    let is_and = |own: &usize| source.written(source.token(*own)) == "and";
    let and = (first + 1..at).rev().find(is_and)?;
    let span = source.span(source.token(and));
    let message = "`and` does not join relations: these are two expectations";
    let finding = Diagnostic::new(Code::E0006, span, message).help("write an `expect` for each");
    let before = source.span(source.token(and - 1));
    Some(match source.begins_line(and) {
        true => finding.fix(span, "expect"),
        false => finding.fix(end_of(before).to(span), "\nexpect"),
    })
}

/// The first token of the line of a token, if that is a name or an opener that multiplies, perhaps
/// against its author's will, what the line before ends with.
fn line_of_its_own(source: &Source<'_>, at: usize) -> Option<usize> {
    use TokenKind::*;
    let start = (0..=at).rev().find(|own| source.begins_line(*own))?;
    let multiplies = matches!(source.kind(start), Name | OpenParenthesis)
        && matches!(
            source.kind_before(start),
            Name | Number | Prime | DoublePrime | CloseParenthesis
        );
    (start < at && multiplies).then_some(start)
}

/// The first word of the line of a token, if it is nearly a keyword, with that keyword.
pub(super) fn misspelt_keyword(input: Stream<'_>) -> Option<(usize, Keyword)> {
    let source = input.source;
    let offset = input.span().start as usize;
    let before = source.text.get(..offset).unwrap_or_default();
    let line = before.rfind(['\n', '\r']).map_or(0, |end| end + 1);
    let begin = source
        .tokens
        .partition_point(|token| (token.start as usize) < line);
    Some((begin, nearly_keyword(source, begin)?))
}

/// The keyword that a name followed by a name or a string was probably meant to be.
pub(super) fn nearly_keyword(source: &Source<'_>, index: usize) -> Option<Keyword> {
    let word = source.written(source.token(index));
    let is_word = source.kind(index) == TokenKind::Name;
    if !is_word || !matches!(source.kind(index + 1), TokenKind::Name | TokenKind::Text) {
        return None;
    }
    Keyword::meant(word)
}

/// Whether the `=` at an index belongs to a `where` that is misspelt: `whre q = …`.
fn is_nearly_where(source: &Source<'_>, at: usize) -> bool {
    let Some(index) = at.checked_sub(2) else {
        return false;
    };
    let word = source.written(source.token(index));
    let names = [index, index + 1].map(|own| source.kind(own)) == [TokenKind::Name; 2];
    let declares = (0..index).rev().find(|own| source.begins_declaration(*own));
    let declares = declares.map(|own| source.kind(own));
    names
        && declares == Some(TokenKind::Keyword(Keyword::Construction))
        && (4..=6).contains(&word.len())
        && strsim::damerau_levenshtein(word, "where") <= 2
}

/// Whether `NAME = NUMBER`, and nothing more, stands at an index.
pub(super) fn is_plain_constant(source: &Source<'_>, at: usize) -> bool {
    let number = match source.kind(at + 2) {
        TokenKind::Minus => at + 3,
        _ => at + 2,
    };
    source.kind(at) == TokenKind::Name
        && source.kind(at + 1) == TokenKind::Equal
        && source.kind(number) == TokenKind::Number
        && (source.kind(number + 1) == TokenKind::End || source.begins_declaration(number + 1))
}

/// E0006 at a misspelt keyword.
fn misspelt(source: &Source<'_>, index: usize, keyword: Keyword) -> Diagnostic {
    let (token, keyword) = (source.token(index), keyword.as_str());
    let span = source.span(token);
    let message = format!("expected a declaration, found {}", source.described(token));
    Diagnostic::new(Code::E0006, span, message)
        .help(format!("write `{keyword}`"))
        .fix(span, keyword)
}
