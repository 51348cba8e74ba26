use crate::diag::FileId;
use crate::syntax::ast::{Declaration, Reference};
use crate::syntax::lexer::{Lexed, Token, TokenKind, tokenize};

use super::columns::{Line, Table};
use super::doc::Doc;
use super::writer::Writer;
use super::{Formatter, Reading};

/// The comments that stand at a token.
#[derive(Debug, Clone, Default)]
struct Comments<'a> {
    /// On lines of their own before it, with the byte where each begins.
    leading: Vec<(usize, &'a str)>,
    /// Behind it on its line.
    trailing: Option<&'a str>,
}

/// The tokens of a text in their order, each with its comments, as they are handed out to the
/// layout of the tree.
pub(super) struct Tokens<'a> {
    text: &'a str,
    tokens: Vec<Token>,
    /// Those of each token.
    comments: Vec<Comments<'a>>,
    /// The next token.
    at: usize,
    /// The end of what was written last; none at the start of the file.
    written: Option<usize>,
    formatter: &'a Formatter<'a>,
    /// The declaration that is written.
    declaration: Option<&'a Declaration>,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(text: &'a str, formatter: &'a Formatter<'a>) -> Self {
        let Lexed {
            tokens, comments, ..
        } = tokenize(FileId::default(), text, formatter.limits);
        let mut attached = vec![Comments::default(); tokens.len()];
        for span in &comments {
            let start = span.start as usize;
            let next = tokens.partition_point(|token| (token.end as usize) <= start);
            // the end of the text is an empty token, and behind every comment
            let next = next.min(tokens.len().saturating_sub(1));
            let comment = text.get(span.range()).unwrap_or_default().trim_end();
            let before = next.checked_sub(1);
            let between = before.and_then(|own| text.get(tokens[own].end as usize..start));
            match before {
                Some(own) if between.is_some_and(|own| !own.contains(['\n', '\r'])) => {
                    attached[own].trailing = Some(comment);
                }
                _ => {
                    if let Some(own) = attached.get_mut(next) {
                        own.leading.push((start, comment));
                    }
                }
            }
        }
        Self {
            text,
            tokens,
            comments: attached,
            at: 0,
            written: None,
            formatter,
            declaration: None,
        }
    }

    /// The kind of the next token.
    pub(super) fn kind(&self) -> TokenKind {
        self.tokens
            .get(self.at)
            .map_or(TokenKind::End, |own| own.kind)
    }

    /// How the next token is written.
    pub(super) fn spelled(&self) -> String {
        let token = self.tokens.get(self.at);
        token.map_or_else(String::new, |token| {
            self.formatter
                .spelling
                .token(token.kind, self.slice(*token))
        })
    }

    fn slice(&self, token: Token) -> &'a str {
        let range = token.start as usize..token.end as usize;
        self.text.get(range).unwrap_or_default()
    }

    /// The next token.
    pub(super) fn token(&mut self) -> Doc {
        let text = self.spelled();
        self.token_as(text)
    }

    /// The sign between the intervals of a domain.
    pub(super) fn times(&mut self) -> Doc {
        let token = self.tokens.get(self.at).copied();
        let written = token.map_or("", |token| self.slice(token));
        self.token_as(self.formatter.spelling.times(written))
    }

    fn token_as(&mut self, text: String) -> Doc {
        let own = self.comments.get_mut(self.at).map(std::mem::take);
        let Comments { leading, trailing } = own.unwrap_or_default();
        self.at += 1;
        let leading = leading.into_iter().map(|(_, comment)| comment.to_owned());
        Doc::token(text, leading.collect(), trailing.map(str::to_owned))
    }

    /// Whether a blank stands before the next token, a parenthesis, because it is unknown what it is
    /// to the name before it and the text has one.
    pub(super) fn is_apart(&self, name: &Reference) -> bool {
        let reading = |own| (self.formatter.reading)(name, own);
        let before = self.at.checked_sub(1).and_then(|own| self.tokens.get(own));
        let touches = before.map(|own| own.end) == self.tokens.get(self.at).map(|own| own.start);
        !touches && self.declaration.map(reading) == Some(Reading::Unknown)
    }

    /// Writes a declaration and the comments before it.
    pub(super) fn item(&mut self, declaration: &'a Declaration, lines: &mut Vec<Line>) {
        self.comment_lines(lines);
        if let Some(token) = self.tokens.get(self.at) {
            self.blank_line(token.start as usize, lines);
        }
        self.declaration = Some(declaration);
        let doc = self.declaration(declaration);
        let mut own = Writer::write(&doc);
        if own.len() > 1 {
            // what takes several lines is no row of a table
            for line in &mut own {
                if line.table != Some(Table::Bindings) {
                    line.table = None;
                }
            }
        }
        lines.append(&mut own);
        let last = self.at.checked_sub(1).and_then(|own| self.tokens.get(own));
        self.written = last.map(|token| token.end as usize);
    }

    /// Writes the comments behind the last declaration.
    pub(super) fn end(&mut self, lines: &mut Vec<Line>) {
        self.comment_lines(lines);
    }

    /// Writes the comments on the lines before the next token.
    fn comment_lines(&mut self, lines: &mut Vec<Line>) {
        let Some(own) = self.comments.get_mut(self.at) else {
            return;
        };
        for (start, comment) in std::mem::take(&mut own.leading) {
            self.blank_line(start, lines);
            self.written = Some(start + comment.len());
            lines.push(Line {
                text: comment.to_owned(),
                ..Line::default()
            });
        }
    }

    /// Keeps one blank line where the text has some before what begins at a byte.
    fn blank_line(&self, start: usize, lines: &mut Vec<Line>) {
        let Some(between) = self.written.and_then(|end| self.text.get(end..start)) else {
            return;
        };
        let unified = between.replace("\r\n", "\n");
        if unified.matches(['\n', '\r']).count() > 1 {
            lines.push(Line::default());
        }
    }
}
