use std::cell::{Cell, RefCell};
use std::iter::{Copied, Enumerate};
use std::slice::Iter;

use nom::{Input, Needed};

use crate::diag::{Diagnostic, FileId, Limits, Severity, Span};
use crate::syntax::ast::Name;
use crate::syntax::lexer::{Keyword, Token, TokenKind, clipped, name_text};

/// How many tokens a finding looks back or ahead at most where it may be made for every token.
pub(super) const NEAR: usize = 200;

/// What all parsers of one file share.
pub(super) struct Source<'a> {
    pub(super) file: FileId,
    pub(super) text: &'a str,
    /// The last one is the end.
    pub(super) tokens: &'a [Token],
    pub(super) limits: &'a Limits,
    /// How many brackets, signs and powers are open.
    pub(super) depth: Cell<usize>,
    errors: RefCell<Vec<Diagnostic>>,
    warnings: RefCell<Vec<Diagnostic>>,
}

impl<'a> Source<'a> {
    pub(super) fn new(
        file: FileId,
        text: &'a str,
        tokens: &'a [Token],
        limits: &'a Limits,
    ) -> Self {
        Self {
            file,
            text,
            tokens,
            limits,
            depth: Cell::new(0),
            errors: RefCell::default(),
            warnings: RefCell::default(),
        }
    }

    /// Keeps a finding that does not stop the parser.
    ///
    /// One more than will be shown is kept of each severity, so that the rest can be mentioned.
    pub(super) fn report(&self, finding: Diagnostic) {
        let list = match finding.severity() {
            Severity::Error => &self.errors,
            Severity::Warning => &self.warnings,
        };
        let mut list = list.borrow_mut();
        if list.len() <= self.limits.syntax_errors {
            list.push(finding);
        }
    }

    /// Whether further errors would not be kept.
    pub(super) fn has_enough_errors(&self) -> bool {
        self.errors.borrow().len() > self.limits.syntax_errors
    }

    /// Whether further warnings would not be kept.
    pub(super) fn has_enough_warnings(&self) -> bool {
        self.warnings.borrow().len() > self.limits.syntax_errors
    }

    /// The errors and the warnings.
    pub(super) fn into_findings(self) -> (Vec<Diagnostic>, Vec<Diagnostic>) {
        (self.errors.into_inner(), self.warnings.into_inner())
    }

    /// The token at an index; behind the last one, and before the first, stands the end.
    pub(super) fn token(&self, index: usize) -> Token {
        let end = u32::try_from(self.text.len()).unwrap_or(u32::MAX);
        self.tokens.get(index).copied().unwrap_or(Token {
            kind: TokenKind::End,
            start: end,
            end,
        })
    }

    pub(super) fn kind(&self, index: usize) -> TokenKind {
        self.token(index).kind
    }

    /// The kind of the token before an index.
    pub(super) fn kind_before(&self, index: usize) -> TokenKind {
        self.kind(index.wrapping_sub(1))
    }

    pub(super) fn span(&self, token: Token) -> Span {
        Span::new(self.file, token.start as usize, token.end as usize)
    }

    pub(super) fn written(&self, token: Token) -> &'a str {
        self.slice(self.span(token))
    }

    pub(super) fn slice(&self, span: Span) -> &'a str {
        self.text.get(span.range()).unwrap_or_default()
    }

    pub(super) fn name(&self, token: Token) -> Name {
        Name {
            text: name_text(self.written(token)),
            span: self.span(token),
        }
    }

    /// Whether two neighbouring tokens have nothing between them.
    pub(super) fn touches_next(&self, index: usize) -> bool {
        self.token(index).end == self.token(index.wrapping_add(1)).start
    }

    /// Whether a line ends between a token and the one before it.
    pub(super) fn begins_line(&self, index: usize) -> bool {
        let before = match index.checked_sub(1) {
            Some(before) => self.token(before).end as usize,
            None => return true,
        };
        let between = self.text.get(before..self.token(index).start as usize);
        between.is_some_and(|between| between.contains(['\n', '\r']))
    }

    /// Whether a keyword stands where its author meant a name: a name is due, and what follows is
    /// an operator or a closing bracket, with which no declaration goes on; or it touches a dot.
    pub(super) fn is_misused_keyword(&self, index: usize) -> bool {
        use TokenKind::*;
        let Keyword(keyword) = self.kind(index) else {
            return false;
        };
        if self.kind_before(index) == Dot && self.touches_next(index.wrapping_sub(1)) {
            return true;
        }
        let name_is_due = !matches!(
            self.kind_before(index),
            End | Unknown
                | Name
                | Number
                | Text
                | Prime
                | DoublePrime
                | CloseParenthesis
                | CloseBracket
        );
        name_is_due
            && match self.kind(index + 1) {
                Plus | Star | Slash | Caret | CloseParenthesis | CloseBracket | Comma | Colon
                | Dot | Prime | DoublePrime | Equal | DoubleEqual => true,
                Minus | OpenParenthesis => keyword != self::Keyword::Expect,
                _ => false,
            }
    }

    /// Whether a declaration begins at an index, right or wrong.
    pub(super) fn begins_declaration(&self, index: usize) -> bool {
        let TokenKind::Keyword(keyword) = self.kind(index) else {
            return false;
        };
        keyword.begins_declaration() && !self.is_misused_keyword(index)
    }

    /// Whether a declaration is over before an index: the file ends there, or another begins on a
    /// line of its own. What is missing then is missing behind the last token.
    pub(super) fn ends_declaration(&self, index: usize) -> bool {
        let is_over = self.kind(index) == TokenKind::End
            || (self.begins_declaration(index) && self.begins_line(index));
        is_over && self.kind_before(index) != TokenKind::End
    }

    /// The text from a parenthesis to the one that closes it, and the index behind that.
    pub(super) fn enclosed(&self, opening: usize) -> Option<(Span, usize)> {
        let mut depth = 0_usize;
        for index in opening..self.tokens.len() {
            match self.kind(index) {
                TokenKind::OpenParenthesis => depth += 1,
                TokenKind::CloseParenthesis => depth = depth.checked_sub(1)?,
                _ if self.begins_declaration(index) => return None,
                _ => {}
            }
            if depth == 0 {
                let span = self.span(self.token(opening));
                return Some((span.to(self.span(self.token(index))), index + 1));
            }
        }
        None
    }

    /// The `expect` around an index, if it begins near enough.
    pub(super) fn expectation_around(&self, index: usize) -> Option<usize> {
        let mut near = (index.saturating_sub(NEAR)..index).rev();
        let start = near.find(|own| self.begins_declaration(*own))?;
        (self.kind(start) == TokenKind::Keyword(Keyword::Expect)).then_some(start)
    }

    /// The relation before an index in the `expect` around it.
    pub(super) fn relation_before(&self, index: usize) -> Option<usize> {
        let start = self.expectation_around(index)?;
        let mut before = (start..index).rev();
        before.find(|own| self.kind(*own).is_relation())
    }

    /// Whether a relation stands behind an index in the declaration around it.
    pub(super) fn has_relation_behind(&self, index: usize) -> bool {
        let ends = |own: &usize| self.kind(*own) == TokenKind::End || self.begins_declaration(*own);
        let mut behind = (index + 1..self.tokens.len()).take_while(|own| !ends(own));
        behind.any(|own| self.kind(own).is_relation())
    }

    /// Whether the innermost bracket that is open before an index is a `[`.
    pub(super) fn is_in_list(&self, index: usize) -> bool {
        let mut closed = 0_usize;
        for own in (0..index).rev() {
            match self.kind(own) {
                TokenKind::CloseParenthesis | TokenKind::CloseBracket => closed += 1,
                TokenKind::OpenParenthesis | TokenKind::OpenBracket if closed > 0 => closed -= 1,
                kind @ (TokenKind::OpenParenthesis | TokenKind::OpenBracket) => {
                    return kind == TokenKind::OpenBracket;
                }
                _ if self.begins_declaration(own) => return false,
                _ => {}
            }
        }
        false
    }

    /// What a token is called in a message.
    pub(super) fn described(&self, token: Token) -> String {
        match token.kind {
            TokenKind::End => "the end of the file".to_owned(),
            TokenKind::Keyword(keyword) => format!("the keyword `{}`", keyword.as_str()),
            TokenKind::Text => "a string".to_owned(),
            TokenKind::Name if !self.written(token).is_ascii() => {
                format!("`{}`", clipped(&name_text(self.written(token))))
            }
            _ => format!("`{}`", clipped(self.written(token))),
        }
    }
}

/// The tokens that are still to be read: the input of the nom parsers.
#[derive(Clone, Copy)]
pub(super) struct Stream<'a> {
    pub(super) source: &'a Source<'a>,
    /// The index of the next token.
    pub(super) at: usize,
    end: usize,
}

impl<'a> Stream<'a> {
    /// All tokens of a file.
    pub(super) fn new(source: &'a Source<'a>) -> Self {
        Self {
            source,
            at: 0,
            end: source.tokens.len(),
        }
    }

    /// The same tokens, from an index on.
    pub(super) fn moved_to(self, index: usize) -> Self {
        Self {
            at: index.min(self.end),
            ..self
        }
    }

    pub(super) fn first(self) -> Token {
        self.source.token(self.at)
    }

    pub(super) fn kind(self) -> TokenKind {
        self.first().kind
    }

    /// Where the next token stands.
    pub(super) fn span(self) -> Span {
        self.source.span(self.first())
    }

    /// The token that was read last.
    pub(super) fn previous(self) -> Token {
        self.source.token(self.at.wrapping_sub(1))
    }

    /// From the next token of `self` to the token before `rest`.
    pub(super) fn span_until(self, rest: Stream<'_>) -> Span {
        self.span().to(self.source.span(rest.previous()))
    }

    fn rest(&self) -> &'a [Token] {
        self.source
            .tokens
            .get(self.at..self.end)
            .unwrap_or_default()
    }
}

impl<'a> Input for Stream<'a> {
    type Item = Token;
    type Iter = Copied<Iter<'a, Token>>;
    type IterIndices = Enumerate<Self::Iter>;

    fn input_len(&self) -> usize {
        self.end - self.at
    }

    fn take(&self, count: usize) -> Self {
        Self {
            end: (self.at + count).min(self.end),
            ..*self
        }
    }

    fn take_from(&self, count: usize) -> Self {
        self.moved_to(self.at + count)
    }

    fn take_split(&self, count: usize) -> (Self, Self) {
        (self.take_from(count), self.take(count))
    }

    fn position<P: Fn(Token) -> bool>(&self, predicate: P) -> Option<usize> {
        self.iter_elements().position(predicate)
    }

    fn iter_elements(&self) -> Self::Iter {
        self.rest().iter().copied()
    }

    fn iter_indices(&self) -> Self::IterIndices {
        self.iter_elements().enumerate()
    }

    fn slice_index(&self, count: usize) -> Result<usize, Needed> {
        match self.input_len().checked_sub(count) {
            Some(_) => Ok(count),
            None => Err(Needed::new(count - self.input_len())),
        }
    }
}
