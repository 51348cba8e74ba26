use super::columns::{Column, Table};

/// A piece of layout: what stands there, and where a line may end.
#[derive(Debug)]
pub(super) struct Doc {
    pub(super) kind: DocKind,
    /// Its width on one line; none if a line ends in it in any case.
    pub(super) flat: Option<usize>,
    /// The width of what comes before the first place where a line may end.
    pub(super) lead: usize,
    /// Whether there is such a place.
    breaks: bool,
    /// Whether a comment ends the line behind it.
    ends: bool,
}

#[derive(Debug)]
pub(super) enum DocKind {
    /// A token with the comments on the lines before it and the one behind it.
    Token {
        text: String,
        leading: Vec<String>,
        trailing: Option<String>,
    },
    /// A blank where no line ends.
    Space,
    /// A blank, or a line end if the group around it does not fit.
    Line,
    /// Nothing, or a line end if the group around it does not fit.
    Seam,
    /// A line end.
    Newline,
    /// The next token stands in a column.
    Mark(Table, Column),
    /// The lines that begin within are moved in.
    Nest(usize, Box<Doc>),
    /// On one line if it fits.
    Group(Box<Doc>),
    Concat(Vec<Doc>),
    /// What stands behind the `=` of a declaration: beside it, or on the next line. If it fits on
    /// neither and begins with a bracket or a call, it `hugs`: it begins beside the `=` and
    /// breaks inside.
    Value {
        hugs: bool,
        inner: Box<Doc>,
    },
}

impl Doc {
    fn new(kind: DocKind, flat: Option<usize>, lead: usize, breaks: bool) -> Self {
        Self {
            kind,
            flat,
            lead,
            breaks,
            ends: false,
        }
    }

    /// A piece of the same measures.
    fn around(inner: Doc, kind: impl FnOnce(Box<Doc>) -> DocKind) -> Self {
        Self {
            flat: inner.flat,
            lead: inner.lead,
            breaks: inner.breaks,
            ends: inner.ends,
            kind: kind(Box::new(inner)),
        }
    }

    pub(super) fn token(text: String, leading: Vec<String>, trailing: Option<String>) -> Self {
        let width = text.chars().count();
        let breaks = !leading.is_empty();
        let lead = if breaks { 0 } else { width };
        let flat = (!breaks).then_some(width);
        let ends = trailing.is_some();
        let kind = DocKind::Token {
            text,
            leading,
            trailing,
        };
        Self {
            ends,
            ..Self::new(kind, flat, lead, breaks)
        }
    }

    /// A token that the text has not.
    pub(super) fn added(text: &str) -> Self {
        Self::token(text.to_owned(), Vec::new(), None)
    }

    pub(super) fn space() -> Self {
        Self::new(DocKind::Space, Some(1), 1, false)
    }

    pub(super) fn line() -> Self {
        Self::new(DocKind::Line, Some(1), 0, true)
    }

    pub(super) fn seam() -> Self {
        Self::new(DocKind::Seam, Some(0), 0, true)
    }

    pub(super) fn newline() -> Self {
        Self::new(DocKind::Newline, None, 0, true)
    }

    pub(super) fn mark(table: Table, column: Column) -> Self {
        Self::new(DocKind::Mark(table, column), Some(0), 0, false)
    }

    pub(super) fn nest(by: usize, inner: Doc) -> Self {
        Self::around(inner, |inner| DocKind::Nest(by, inner))
    }

    pub(super) fn group(inner: Doc) -> Self {
        Self::around(inner, DocKind::Group)
    }

    pub(super) fn concat(parts: Vec<Doc>) -> Self {
        let ended = |(_, rest): (&Doc, &[Doc])| rest.iter().any(|part| part.ends);
        let flat = match parts.split_last() {
            Some(last) if ended(last) => None,
            _ => parts.iter().map(|part| part.flat).sum(),
        };
        let breaks = parts.iter().any(|part| part.breaks) || flat.is_none();
        let lead = lead(&parts, 0);
        Self {
            ends: parts.last().is_some_and(|part| part.ends),
            ..Self::new(DocKind::Concat(parts), flat, lead, breaks)
        }
    }

    pub(super) fn value(hugs: bool, inner: Doc) -> Self {
        let inner = Box::new(inner);
        Self::new(DocKind::Value { hugs, inner }, None, 0, true)
    }

    /// The width up to the first place where a line may end, `behind` the width of what follows.
    pub(super) fn lead_before(&self, behind: usize) -> usize {
        if self.breaks || self.ends {
            self.lead
        } else {
            self.lead + behind
        }
    }
}

/// The width of parts up to the first place where a line may end.
fn lead(parts: &[Doc], behind: usize) -> usize {
    let parts = parts.iter().rev();
    parts.fold(behind, |behind, part| part.lead_before(behind))
}
