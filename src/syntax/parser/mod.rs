//! Tokens to tree: the second half of parsing.

mod broken;
mod declaration;
mod expression;
mod fault;
mod hint;
mod piece;
mod stream;

use self::declaration::{
    MISSING_KEYWORD, declaration, is_plain_constant, misspelt_keyword, nearly_keyword, stray,
};
use self::fault::Fault;
use self::hint::start_of;
use self::stream::{Source, Stream};
use super::ast::{Broken, Document, Item};
use super::lexer::{Token, TokenKind, clipped, tokenize};
use crate::diag::{Code, Diagnostic, Diagnostics, FileId, Limits};

/// The tree of a text. Never fails: what cannot be read is reported, and the parser goes on at the
/// next declaration.
///
/// - **errors** E0002 to E0009, E0103 (a keyword as a name), E0502, E0503; at most
///   `limits.syntax_errors` of them, and as many warnings (W1001), in the order of the text
/// - **cost**   linear; the stack grows with `limits.nesting` only
///
/// ```
/// use sweepc::diag::{Diagnostics, FileId, Limits};
/// let mut diagnostics = Diagnostics::default();
/// let text = "let a = 2 )\nlet b = 2u";
/// let document = sweepc::syntax::parse(FileId(0), text, &Limits::default(), &mut diagnostics);
/// assert_eq!(document.items.len(), 2);
/// assert_eq!(diagnostics.errors().count(), 1);
/// ```
pub fn parse(file: FileId, text: &str, limits: &Limits, diagnostics: &mut Diagnostics) -> Document {
    let lexed = tokenize(file, text, limits);
    let source = Source::new(file, text, &lexed.tokens, limits);
    let mut document = Document {
        file,
        items: Vec::new(),
        comments: lexed.comments,
        broken: Vec::new(),
    };
    let mut input = Stream::new(&source);
    while input.kind() != TokenKind::End {
        input = item(input, &mut document);
    }
    let (mut errors, warnings) = source.into_findings();
    errors.extend(lexed.findings);
    diagnostics.extend(shown(errors, limits.syntax_errors));
    diagnostics.extend(shown(warnings, limits.syntax_errors));
    document
}

/// Reads one declaration and what stands wrongly behind it; goes on at the next declaration.
fn item<'a>(input: Stream<'a>, document: &mut Document) -> Stream<'a> {
    let source = input.source;
    if !source.begins_declaration(input.at) {
        report_stray(input);
        document.broken.extend(broken::without_keyword(input));
        return recovered(input, input.at + 1);
    }
    match declaration(input) {
        Ok((rest, item)) => {
            let rest = without_semicolons(rest);
            // behind a value a name would be its next factor
            let begins_anew = rest.kind() == TokenKind::Name && source.begins_line(rest.at);
            if begins_anew || is_boundary(source, rest.at) {
                match broken::before_keyword(rest) {
                    Some(own) => document
                        .broken
                        .extend(broken::declared(input).into_iter().chain([own])),
                    None => document.items.push(item),
                }
                return rest;
            }
            match broken::swallowed(rest) {
                // the next declaration lost its keyword, and its name went into this value
                Some(own) => {
                    report_swallowed(rest, &own);
                    document
                        .broken
                        .extend(broken::declared(input).into_iter().chain([own]));
                }
                None => {
                    // what has no place behind a declaration is an error of that declaration
                    let span = item.span.to(rest.span());
                    document.items.push(Item { span, ..item });
                    report_stray(rest);
                }
            }
            recovered(rest, rest.at)
        }
        Err(nom::Err::Error(fault) | nom::Err::Failure(fault)) => {
            document.broken.extend(broken::declared(input));
            let at = fault.at().max(input.at + 1);
            let is_at_the_end = fault.is_at_the_end(source);
            report(source, fault);
            match is_at_the_end {
                true => input.moved_to(at),
                false => recovered(input, at),
            }
        }
        Err(nom::Err::Incomplete(_)) => recovered(input, input.at + 1),
    }
}

fn report(source: &Source<'_>, fault: Fault) {
    if let Some(finding) = fault.into_finding(source) {
        source.report(finding);
    }
}

fn report_stray(input: Stream<'_>) {
    if input.kind() == TokenKind::Semicolon {
        without_semicolons(input);
    } else if input.source.has_enough_errors() {
        // a finding may cost a look at the whole line
    } else if input.source.is_misused_keyword(input.at) {
        let what = "a declaration";
        report(input.source, Fault::Expected { at: input.at, what });
    } else if let Some(finding) = stray(input) {
        input.source.report(finding);
    }
}

/// Reports a declaration without its keyword at its name, if that begins the line.
fn report_swallowed(input: Stream<'_>, own: &Broken) {
    let (source, name) = (input.source, &own.name);
    let is_name = |token: &Token| source.span(*token) == name.span;
    let index = source.tokens.iter().position(is_name);
    if misspelt_keyword(input).is_some() || !index.is_some_and(|own| source.begins_line(own)) {
        return report_stray(input);
    }
    let message = format!("expected a declaration, found `{}`", clipped(&name.text));
    let finding = Diagnostic::new(Code::E0006, name.span, message).help(MISSING_KEYWORD);
    source.report(match index.filter(|own| is_plain_constant(source, *own)) {
        Some(_) => finding.fix(start_of(name.span), "let "),
        None => finding,
    });
}

/// Reports a `;` and skips those that follow.
fn without_semicolons(input: Stream<'_>) -> Stream<'_> {
    if input.kind() != TokenKind::Semicolon {
        return input;
    }
    let mut index = input.at;
    while input.source.kind(index) == TokenKind::Semicolon {
        index += 1;
    }
    let rest = input.moved_to(index);
    let span = input.span_until(rest);
    let message = "a declaration needs no `;`";
    let finding = Diagnostic::new(Code::E0006, span, message);
    input.source.report(finding.help("remove it").fix(span, ""));
    rest
}

/// Whether a declaration begins at an index, be it with a misspelt keyword at the start of a line,
/// or the file ends there.
fn is_boundary(source: &Source<'_>, index: usize) -> bool {
    source.kind(index) == TokenKind::End
        || source.begins_declaration(index)
        || (source.begins_line(index) && nearly_keyword(source, index).is_some())
}

/// The first declaration from an index on.
fn recovered(input: Stream<'_>, from: usize) -> Stream<'_> {
    let tokens = input.source.tokens.len();
    let next = (from..tokens).find(|index| is_boundary(input.source, *index));
    input.moved_to(next.unwrap_or(tokens))
}

/// The first findings in the order of the text; the last of them says whether there are more.
fn shown(mut findings: Vec<Diagnostic>, most: usize) -> Vec<Diagnostic> {
    findings.sort_by_key(|finding| finding.primary);
    let more = findings.len() > most;
    findings.truncate(most);
    if let (true, Some(last)) = (more, findings.last_mut()) {
        last.notes.push(format!(
            "more of this file are not shown, only the first {most}"
        ));
    }
    findings
}
