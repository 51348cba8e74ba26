use nom::combinator::cut;
use nom::multi::{fold_many0, separated_list1};
use nom::{Input, Parser};

use super::fault::{Parsed, expected, told};
use super::hint::{end_of, start_of};
use super::piece::{Brackets, bracketed, comma, name, nested, token, too_deep};
use super::stream::{NEAR, Stream};
use crate::diag::{Code, Diagnostic};
use crate::syntax::ast::{Argument, Expr, ExprKind, ProductOp, Reference, Sign};
use crate::syntax::lexer::TokenKind;

/// `-a b + c`, the whole of an expression.
pub(super) fn expression(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, sign) = match input.kind() {
        TokenKind::Minus => (input.take_from(1), Sign::Minus),
        _ => (input, Sign::Plus),
    };
    let (rest, first) = product(rest)?;
    if sign == Sign::Plus && sum_sign(rest).is_err() {
        return Ok((rest, first));
    }
    let (rest, terms) = followed((sign, first), rest, |input| {
        (sum_sign, cut(product)).parse(input)
    })?;
    let span = input.span_until(rest);
    let kind = ExprKind::Sum(terms);
    Ok((rest, Expr { span, kind }))
}

/// The first item and all that follow it; kept out of the frames of deep expressions.
#[inline(never)]
fn followed<'a, T>(
    first: T,
    mut rest: Stream<'a>,
    next: impl Fn(Stream<'a>) -> Parsed<'a, T>,
) -> Parsed<'a, Vec<T>> {
    let mut list = Vec::with_capacity(4);
    list.push(first);
    loop {
        match next(rest) {
            Ok((behind, item)) => {
                list.push(item);
                rest = behind;
            }
            Err(nom::Err::Error(_)) => return Ok((rest, list)),
            Err(error) => return Err(error),
        }
    }
}

fn sum_sign(input: Stream<'_>) -> Parsed<'_, Sign> {
    match input.kind() {
        TokenKind::Plus => Ok((input.take_from(1), Sign::Plus)),
        TokenKind::Minus => Ok((input.take_from(1), Sign::Minus)),
        _ => expected(input, "an operator"),
    }
}

/// Factors joined by `*`, `/` or nothing.
fn product(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, first) = factor(input)?;
    if !goes_on(rest.kind()) {
        return Ok((rest, first));
    }
    let (rest, factors) = followed((ProductOp::Times, first), rest, next_factor)?;
    warn_of_quotients(input, &factors);
    let span = input.span_until(rest);
    let kind = ExprKind::Product(factors);
    Ok((rest, Expr { span, kind }))
}

/// Whether a product goes on with a token.
fn goes_on(next: TokenKind) -> bool {
    use TokenKind::*;
    matches!(
        next,
        Star | DoubleStar | Slash | Name | Number | OpenParenthesis
    )
}

fn next_factor(input: Stream<'_>) -> Parsed<'_, (ProductOp, Expr)> {
    let (rest, operator) = match input.kind() {
        TokenKind::Star => (input.take_from(1), ProductOp::Times),
        TokenKind::Slash => (input.take_from(1), ProductOp::Divide),
        TokenKind::Name | TokenKind::OpenParenthesis => (input, ProductOp::Juxtapose),
        TokenKind::Number => {
            // a finding may cost a look at the whole declaration
            if !input.source.has_enough_errors() && !is_before_second_relation(input) {
                input.source.report(number_on_the_right(input));
            }
            (input, ProductOp::Juxtapose)
        }
        TokenKind::DoubleStar => {
            let finding = Diagnostic::new(Code::E0006, input.span(), "unexpected `**`")
                .help("a power is written `^`")
                .fix(input.span(), "^");
            return told(input, finding);
        }
        _ => return expected(input, "an operator"),
    };
    if operator == ProductOp::Juxtapose
        && let Some(finding) = zero_and_x(input)
    {
        input.source.report(finding);
    }
    let (rest, factor) = cut(factor).parse(rest)?;
    Ok((rest, (operator, factor)))
}

/// Whether a name comes before the next token in an `expect`, a relation before that, and another
/// one behind it: that one is what is wrong, as in `a == b and 2 == c`.
fn is_before_second_relation(input: Stream<'_>) -> bool {
    let source = input.source;
    input.previous().kind == TokenKind::Name
        && source.relation_before(input.at).is_some()
        && (input.at..source.tokens.len())
            .take(NEAR)
            .take_while(|own| !source.begins_declaration(*own))
            .any(|own| source.kind(own).is_relation())
}

/// E0008: `x 2`, `1 000`.
fn number_on_the_right(input: Stream<'_>) -> Diagnostic {
    let number = input.source.described(input.first());
    let message = format!("the number {number} cannot stand to the right of a factor");
    let finding = Diagnostic::new(Code::E0008, input.span(), message);
    let previous = input.previous();
    if previous.kind == TokenKind::Number {
        let gap = input.source.span(previous).to(input.span());
        let finding = match input.source.is_in_list(input.at) {
            true => finding.fix(end_of(input.source.span(previous)), ","),
            false => finding,
        };
        return finding
            .related(input.source.span(previous), "the factor")
            .help(match input.source.slice(gap).contains(['\n', '\r']) {
                true => "between two numbers stands `,` or `*`",
                false => "digits are not grouped; between two numbers stands `,` or `*`",
            });
    }
    let finding = finding.help(format!(
        "write `* {}`, or put the number first",
        number.trim_matches('`')
    ));
    // In a list a comma may be missing as well, and a name that begins its line may be meant as a
    // keyword.
    let begins =
        previous.kind == TokenKind::Name && input.at > 0 && input.source.begins_line(input.at - 1);
    if begins || input.source.is_in_list(input.at) {
        return finding;
    }
    finding.fix(start_of(input.span()), "* ")
}

/// E0008: `0 x` and `0x1F`, which is how other languages write a number.
fn zero_and_x(input: Stream<'_>) -> Option<Diagnostic> {
    let (source, zero, word) = (input.source, input.previous(), input.first());
    if zero.kind != TokenKind::Number || source.written(zero) != "0" {
        return None;
    }
    let written = source.written(word);
    let alone = written == "x"
        && !matches!(
            source.kind(input.at + 1),
            TokenKind::OpenParenthesis | TokenKind::Dot | TokenKind::Prime | TokenKind::DoublePrime
        );
    let digits = written.strip_prefix('x').unwrap_or_default();
    let hexadecimal = zero.end == word.start
        && !digits.is_empty()
        && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    if !alone && !hexadecimal {
        return None;
    }
    let span = source.span(zero).to(source.span(word));
    let message = "`0 x` is neither a number nor a product";
    let finding = Diagnostic::new(Code::E0008, span, message).help("numbers are decimal");
    Some(match u64::from_str_radix(digits, 16) {
        Ok(value) if hexadecimal => finding.fix(span, value.to_string()),
        _ => finding,
    })
}

/// W1001: the factor after a quotient looks as if it stood below the line.
fn warn_of_quotients(input: Stream<'_>, factors: &[(ProductOp, Expr)]) {
    let is_number = |factor: &Expr| matches!(factor.kind, ExprKind::Number(_));
    for (index, window) in factors.windows(3).enumerate() {
        let [
            (_, above),
            (ProductOp::Divide, below),
            (ProductOp::Juxtapose, beside),
        ] = window
        else {
            continue;
        };
        if is_number(above) && is_number(below) || input.source.has_enough_warnings() {
            continue;
        }
        let slice = |from: &Expr, to: &Expr| input.source.slice(from.span.to(to.span));
        let (whole, quotient) = (slice(above, beside), slice(above, below));
        let factor = slice(beside, beside);
        let short = whole.len() <= 40 && !whole.contains(['\n', '\r', '#']);
        let finding = if short {
            let message = format!("`{whole}` means `({quotient}) {factor}`");
            let other = format!("{}/({} {factor})", slice(above, above), slice(below, below));
            let finding = Diagnostic::new(Code::W1001, below.span.to(beside.span), message)
                .help(format!("write `({quotient}) {factor}` or `{other}`"));
            // Behind another factor the parenthesis could become that of an application.
            match index {
                0 => finding.fix(above.span.to(below.span), format!("({quotient})")),
                _ => finding,
            }
        } else {
            let message = "the factor after the quotient multiplies it";
            Diagnostic::new(Code::W1001, below.span.to(beside.span), message)
                .help("put the quotient or its divisor in parentheses")
        };
        input.source.report(finding);
    }
}

/// `-a`, `a^b`
fn factor(input: Stream<'_>) -> Parsed<'_, Expr> {
    if input.kind() != TokenKind::Minus {
        return power(input);
    }
    nested(input, |input| {
        let (rest, negated) = cut(factor).parse(input.take_from(1))?;
        let span = input.span_until(rest);
        let kind = ExprKind::Negate(Box::new(negated));
        Ok((rest, Expr { span, kind }))
    })
}

fn power(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, base) = postfix(input)?;
    raised(input, rest, base)
}

/// The base and what follows it, if that is `^` and an exponent.
fn raised<'a>(start: Stream<'a>, input: Stream<'a>, base: Expr) -> Parsed<'a, Expr> {
    if input.kind() != TokenKind::Caret {
        return Ok((input, base));
    }
    let (rest, exponent) = nested(input, |input| exponent(input.take_from(1)))?;
    let span = start.span_until(rest);
    let kind = ExprKind::Power(Box::new(base), Box::new(exponent));
    Ok((rest, Expr { span, kind }))
}

/// A number, a negated number, a name, a parenthesis; or a power of these, but for the negated one.
fn exponent(input: Stream<'_>) -> Parsed<'_, Expr> {
    let after = input.take_from(1).kind();
    let (rest, base) = match input.kind() {
        TokenKind::Number => number(input)?,
        TokenKind::Minus => return negated_exponent(input),
        TokenKind::Plus => {
            let finding = refused(input, "an exponent has no `+` sign", "remove it");
            return told(input, finding.fix(input.span(), ""));
        }
        TokenKind::OpenParenthesis => {
            let (rest, inner) = parenthesis(input)?;
            if let ExprKind::Tuple(_) = inner.kind {
                let help = "write one integer, `^(…)`";
                return told(rest, refused(input, "a point is not an exponent", help));
            }
            (rest, inner)
        }
        TokenKind::Name => match after {
            TokenKind::Dot | TokenKind::Prime | TokenKind::DoublePrime => {
                let message = "an exponent is an integer or the name of a constant";
                return told(input, refused(input, message, "write a number"));
            }
            _ => bare_name(input)?,
        },
        _ => return cut(|input| expected(input, "an exponent")).parse(input),
    };
    raised(input, rest, base)
}

/// `-2` behind `^`
fn negated_exponent(input: Stream<'_>) -> Parsed<'_, Expr> {
    let help = "put the exponent in parentheses";
    let after = input.take_from(1);
    if after.kind() != TokenKind::Number {
        let message = "only a number can be negated in an exponent";
        let finding = refused(input, message, help);
        let behind = after.take_from(1);
        let goes_on = matches!(
            behind.kind(),
            TokenKind::OpenParenthesis | TokenKind::Dot | TokenKind::Prime | TokenKind::Caret
        );
        if after.kind() != TokenKind::Name || goes_on {
            return told(input, finding);
        }
        let span = input.span_until(behind);
        let written = input.source.slice(span);
        return told(input, finding.fix(span, format!("({written})")));
    }
    let (rest, number) = number(after)?;
    if rest.kind() == TokenKind::Caret {
        let message = "the sign of a power in an exponent can be read in two ways";
        return told(rest, refused(input, message, help));
    }
    let span = input.span_until(rest);
    let kind = ExprKind::Negate(Box::new(number));
    Ok((rest, Expr { span, kind }))
}

/// E0009.
fn refused(at: Stream<'_>, message: &str, help: &str) -> Diagnostic {
    Diagnostic::new(Code::E0009, at.span(), message).help(help)
}

fn bare_name(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, name) = name(input)?;
    let reference = Reference {
        qualifier: None,
        span: name.span,
        name,
        primes: 0,
    };
    let kind = ExprKind::Reference(reference);
    let span = input.span_until(rest);
    Ok((rest, Expr { span, kind }))
}

/// A primary expression and its components: `c(v).x`
fn postfix(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (mut rest, mut base) = primary(input)?;
    let mut depth = input.source.depth.get();
    while rest.kind() == TokenKind::Dot {
        depth += 1;
        if depth > input.source.limits.nesting {
            return told(rest, too_deep(rest));
        }
        let (after, component) = cut(name).parse(rest.take_from(1))?;
        base = Expr {
            span: input.span_until(after),
            kind: ExprKind::Component(Box::new(base), component),
        };
        rest = after;
    }
    if matches!(rest.kind(), TokenKind::Prime | TokenKind::DoublePrime) {
        let finding = Diagnostic::new(
            Code::E0006,
            rest.span(),
            "a prime stands behind a name only",
        );
        let finding = finding.help("write `f'(v)`, or `du(…)` and `dv(…)` for an expression");
        let ExprKind::Apply {
            function,
            parenthesis,
            ..
        } = &base.kind
        else {
            return told(rest, finding);
        };
        let slice = |span| input.source.slice(span);
        let moved = format!("{}{}", slice(rest.span()), slice(*parenthesis));
        let span = end_of(function.span).to(rest.span());
        return told(rest, finding.fix(span, moved));
    }
    Ok((rest, base))
}

fn primary(input: Stream<'_>) -> Parsed<'_, Expr> {
    match input.kind() {
        TokenKind::Number => number(input),
        TokenKind::Name => named(input),
        TokenKind::OpenParenthesis => parenthesis(input),
        _ => expected(input, "an expression"),
    }
}

fn number(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, number) = token(TokenKind::Number, "a number")(input)?;
    let written = input.source.written(number).replace('−', "-");
    let kind = ExprKind::Number(written);
    let span = input.span();
    Ok((rest, Expr { span, kind }))
}

/// `(a)`, `(a, b)`, `(a, b, c)`
fn parenthesis(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, (mut entries, span)) = bracketed(Brackets::Round, input, |input| {
        if is_labelled(input) {
            let span = input.span_until(input.take_from(2));
            let message = "only an argument has a label, and here is no function";
            return told(input, Diagnostic::new(Code::E0006, span, message));
        }
        separated_list1(comma, cut(expression)).parse(input)
    })?;
    let kind = match entries.pop() {
        Some(only) if entries.is_empty() => ExprKind::Group(Box::new(only)),
        last => {
            entries.extend(last);
            ExprKind::Tuple(entries)
        }
    };
    Ok((rest, Expr { span, kind }))
}

/// A name with its qualifier and primes, and the parenthesis behind it.
fn named(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, function) = reference(input)?;
    let (rest, kind) = if rest.kind() == TokenKind::OpenParenthesis {
        let (rest, (arguments, parenthesis)) =
            bracketed(Brackets::Round, rest, |input| arguments(input))?;
        let kind = ExprKind::Apply {
            function,
            arguments,
            parenthesis,
        };
        (rest, kind)
    } else {
        (rest, ExprKind::Reference(function))
    };
    let span = input.span_until(rest);
    Ok((rest, Expr { span, kind }))
}

/// `c`, `c.σ`, `f'`, `c.σ''`
fn reference(input: Stream<'_>) -> Parsed<'_, Reference> {
    let (mut rest, mut last) = name(input)?;
    let mut qualifier = None;
    if rest.kind() == TokenKind::Dot {
        let (after, property) = cut(name).parse(rest.take_from(1))?;
        qualifier = Some(Box::new(std::mem::replace(&mut last, property)));
        rest = after;
    }
    let start = rest;
    let (rest, primes) = fold_many0(prime, || 0, u32::saturating_add).parse(rest)?;
    if primes as usize > input.source.limits.nesting {
        return told(start, too_deep(start));
    }
    let reference = Reference {
        qualifier,
        name: last,
        primes,
        span: input.span_until(rest),
    };
    Ok((rest, reference))
}

fn prime(input: Stream<'_>) -> Parsed<'_, u32> {
    match input.kind() {
        TokenKind::Prime => Ok((input.take_from(1), 1)),
        TokenKind::DoublePrime => Ok((input.take_from(1), 2)),
        _ => expected(input, "a prime"),
    }
}

fn arguments(input: Stream<'_>) -> Parsed<'_, Vec<Argument>> {
    if input.kind() == TokenKind::CloseParenthesis {
        return Ok((input, Vec::new()));
    }
    separated_list1(comma, cut(argument)).parse(input)
}

/// Whether `NAME :` comes next.
fn is_labelled(input: Stream<'_>) -> bool {
    input.kind() == TokenKind::Name && input.source.kind(input.at + 1) == TokenKind::Colon
}

fn argument(input: Stream<'_>) -> Parsed<'_, Argument> {
    let (rest, label) = match is_labelled(input) {
        true => name(input).map(|(rest, label)| (rest.take_from(1), Some(label)))?,
        false => (input, None),
    };
    let (rest, value) = match rest.kind() {
        _ if label.as_ref().is_some_and(|own| own.text == "branch") && is_bare_branch(rest) => {
            bare_branch(rest)
        }
        TokenKind::Text => text(rest)?,
        TokenKind::OpenBracket => list(rest)?,
        _ => cut(expression).parse(rest)?,
    };
    Ok((rest, Argument { label, value }))
}

/// Whether two signs and nothing more come next.
fn is_bare_branch(input: Stream<'_>) -> bool {
    use TokenKind::*;
    let is_sign = |ahead| matches!(input.source.kind(input.at + ahead), Plus | Minus);
    let behind = input.source.kind(input.at + 2);
    is_sign(0) && is_sign(1) && matches!(behind, Comma | CloseParenthesis)
}

/// `+-`, which is a string without its quotes.
fn bare_branch(input: Stream<'_>) -> (Stream<'_>, Expr) {
    let rest = input.take_from(2);
    let span = input.span_until(rest);
    let sign = |ahead| match input.source.kind(input.at + ahead) {
        TokenKind::Plus => "+",
        _ => "-",
    };
    let branch = [sign(0), sign(1)].concat();
    let quoted = format!("\"{branch}\"");
    let message = format!("the branch `{branch}` stands without quotes");
    let finding = Diagnostic::new(Code::E0006, span, message);
    input
        .source
        .report(finding.help(format!("write `{quoted}`")).fix(span, quoted));
    let kind = ExprKind::Text(branch);
    (rest, Expr { span, kind })
}

fn text(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, path) = unquoted(input)?;
    let kind = ExprKind::Text(path);
    let span = input.span();
    Ok((rest, Expr { span, kind }))
}

/// What stands between the quotes.
pub(super) fn unquoted(input: Stream<'_>) -> Parsed<'_, String> {
    let (rest, text) = token(TokenKind::Text, "a string")(input)?;
    let written = input.source.written(text);
    let inner = written.get(1..written.len().saturating_sub(1));
    Ok((rest, inner.unwrap_or_default().to_owned()))
}

/// `[P, …]`
fn list(input: Stream<'_>) -> Parsed<'_, Expr> {
    let (rest, (entries, span)) = bracketed(Brackets::Square, input, |input| {
        if input.kind() == TokenKind::CloseBracket {
            return Ok((input, Vec::new()));
        }
        separated_list1(comma, cut(expression)).parse(input)
    })?;
    let kind = ExprKind::List(entries);
    Ok((rest, Expr { span, kind }))
}
