//! What declarations would have declared that cannot be read.

use super::declaration::{misspelt_keyword, nearly_keyword};
use super::stream::{Source, Stream};
use crate::syntax::ast::{Broken, Role};
use crate::syntax::lexer::{Keyword, TokenKind};

/// What the name at an index is in a declaration of that keyword; none if no name stands there.
fn named(source: &Source<'_>, index: usize, keyword: Option<Keyword>) -> Option<Broken> {
    let token = source.token(index);
    let role = match keyword {
        Some(Keyword::Profile) => Some(Role::Profile),
        Some(Keyword::Sweep) => Some(Role::Sweep),
        Some(Keyword::Curve) => Some(Role::Further),
        Some(_) => None,
        None => role_without_keyword(source, index),
    };
    (token.kind == TokenKind::Name).then(|| Broken {
        name: source.name(token),
        role,
    })
}

/// What the name in front of `(u) in` or `(v) on` is probably the name of.
fn role_without_keyword(source: &Source<'_>, index: usize) -> Option<Role> {
    let behind = source.kind(index + 4);
    if !matches!(behind, TokenKind::Keyword(Keyword::In | Keyword::On)) {
        return None;
    }
    match source.written(source.token(index + 2)) {
        "u" => Some(Role::Profile),
        "v" => Some(Role::Sweep),
        _ => None,
    }
}

/// The name behind the keyword of a declaration.
pub(super) fn declared(input: Stream<'_>) -> Option<Broken> {
    let keyword = match input.kind() {
        TokenKind::Keyword(keyword) => Some(keyword),
        _ => None,
    };
    named(input.source, input.at + 1, keyword)
}

/// The name of a declaration whose keyword is misspelt or missing, from its first word on.
pub(super) fn without_keyword(input: Stream<'_>) -> Option<Broken> {
    match nearly_keyword(input.source, input.at) {
        Some(keyword) => named(input.source, input.at + 1, Some(keyword)),
        None => named(input.source, input.at, None),
    }
}

/// The name of a declaration that was put in front of its keyword, and so went into the value of
/// the declaration before: `b` of `b let = 2`. The next declaration reports that it has no name.
pub(super) fn before_keyword(input: Stream<'_>) -> Option<Broken> {
    let (source, before) = (input.source, input.at.checked_sub(1)?);
    let TokenKind::Keyword(keyword) = input.kind() else {
        return None;
    };
    let takes_name = !matches!(keyword, Keyword::Expect | Keyword::Import | Keyword::Unit);
    let has_none = takes_name && source.kind(input.at + 1) != TokenKind::Name;
    (has_none && source.begins_line(before))
        .then(|| named(source, before, Some(keyword)))
        .flatten()
}

/// What a declaration without its keyword declares that went into the value of the declaration
/// before: `b` of `b(u) = 2u` and of `lett b = 2`.
pub(super) fn swallowed(input: Stream<'_>) -> Option<Broken> {
    let source = input.source;
    if source.has_enough_errors() {
        return None;
    }
    if let Some((index, keyword)) = misspelt_keyword(input) {
        return named(source, index + 1, Some(keyword));
    }
    let goes_on = matches!(
        input.kind(),
        TokenKind::Equal | TokenKind::Keyword(Keyword::In | Keyword::On)
    );
    let mut index = input.at.checked_sub(1).filter(|_| goes_on)?;
    if source.kind(index) == TokenKind::CloseParenthesis {
        let is_opener = |index: &usize| source.kind(*index) == TokenKind::OpenParenthesis;
        index = (0..index).rev().find(is_opener)?.checked_sub(1)?;
    }
    named(source, index, None)
}
