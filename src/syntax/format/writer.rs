use super::columns::{Column, Line, Table};
use super::doc::{Doc, DocKind};
use super::{INDENT, WIDTH};

/// Writes the layout of a declaration in lines.
#[derive(Debug, Default)]
pub(super) struct Writer {
    lines: Vec<Line>,
    line: Line,
    /// The width of `line`.
    width: usize,
    /// Whether a blank comes before the next token of the line.
    space: bool,
    /// The next token begins a line, moved in so far.
    newline: Option<usize>,
    /// What the next token is marked as.
    marks: Vec<(Table, Column)>,
}

/// How a piece is written.
#[derive(Debug, Clone, Copy)]
struct Mode {
    /// On one line.
    flat: bool,
    /// What new lines are moved in by.
    indent: usize,
    /// The width of what follows on the same line in any case.
    behind: usize,
}

impl Writer {
    /// The lines of a declaration.
    pub(super) fn write(doc: &Doc) -> Vec<Line> {
        let mut writer = Self::default();
        let mode = Mode {
            flat: false,
            indent: 0,
            behind: 0,
        };
        writer.put(doc, mode);
        writer.end_line();
        writer.lines
    }

    fn put(&mut self, doc: &Doc, mode: Mode) {
        match &doc.kind {
            DocKind::Token {
                text,
                leading,
                trailing,
            } => {
                let indent = mode.indent.max(INDENT);
                for comment in leading {
                    self.comment_line(comment, indent);
                }
                self.token(text);
                if trailing.is_some() {
                    self.line.comment.clone_from(trailing);
                    self.newline = Some(indent);
                }
            }
            DocKind::Space => self.space = true,
            DocKind::Line if mode.flat => self.space = true,
            DocKind::Seam if mode.flat => {}
            DocKind::Line | DocKind::Seam | DocKind::Newline => self.newline = Some(mode.indent),
            DocKind::Mark(table, column) => self.marks.push((*table, *column)),
            DocKind::Nest(by, inner) => {
                let indent = mode.indent + by;
                self.put(inner, Mode { indent, ..mode });
            }
            DocKind::Group(inner) => {
                let flat = mode.flat || self.fits(inner, mode.behind);
                self.put(inner, Mode { flat, ..mode });
            }
            DocKind::Concat(parts) => self.concat(parts, mode),
            DocKind::Value { hugs, inner } => self.value(*hugs, inner, mode),
        }
    }

    fn concat(&mut self, parts: &[Doc], mode: Mode) {
        let mut behind = mode.behind;
        let mut widths = Vec::with_capacity(parts.len());
        for part in parts.iter().rev() {
            widths.push(behind);
            behind = part.lead_before(behind);
        }
        for (part, behind) in parts.iter().zip(widths.into_iter().rev()) {
            self.put(part, Mode { behind, ..mode });
        }
    }

    fn value(&mut self, hugs: bool, inner: &Doc, mode: Mode) {
        self.space = true;
        let flat = self.fits(inner, mode.behind);
        let below = mode.indent + INDENT;
        let fits_below = inner
            .flat
            .is_some_and(|width| below + width + mode.behind <= WIDTH);
        if flat || (hugs && !fits_below) {
            return self.put(inner, Mode { flat, ..mode });
        }
        self.newline = Some(below);
        let mode = Mode {
            flat: fits_below,
            indent: below,
            ..mode
        };
        self.put(inner, mode);
    }

    /// Whether a piece and what follows it on the same line fit on the line.
    fn fits(&self, doc: &Doc, behind: usize) -> bool {
        let start = self.newline.unwrap_or(self.width + usize::from(self.space));
        doc.flat
            .is_some_and(|width| start + width + behind <= WIDTH)
    }

    fn token(&mut self, text: &str) {
        if let Some(indent) = self.newline.take() {
            self.begin_line(indent);
        } else if self.space && self.width > 0 {
            self.append(" ");
        }
        self.space = false;
        for (table, column) in self.marks.drain(..) {
            self.line.table = Some(table);
            self.line.marks.push((column, self.width));
        }
        self.append(text);
    }

    fn append(&mut self, text: &str) {
        self.line.text += text;
        self.width += text.chars().count();
    }

    /// A comment on a line of its own; the next token stands on the next line.
    fn comment_line(&mut self, comment: &str, indent: usize) {
        let indent = self.newline.unwrap_or(indent);
        self.begin_line(indent);
        self.append(comment);
        self.newline = Some(indent);
    }

    fn begin_line(&mut self, indent: usize) {
        self.end_line();
        self.append(&" ".repeat(indent));
    }

    fn end_line(&mut self) {
        let line = std::mem::take(&mut self.line);
        if !line.text.is_empty() {
            self.lines.push(line);
        }
        self.width = 0;
    }
}
