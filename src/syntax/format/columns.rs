use super::WIDTH;

/// Declarations whose columns stand below each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Table {
    /// `profile`, `sweep`, `curve`
    Curves,
    /// `param`, `let`
    Values,
    /// The names behind `where`.
    Bindings,
}

/// What begins a column, from the left to the right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Column {
    Name,
    Plane,
    Domain,
    Equals,
}

impl Column {
    const ALL: [Self; 4] = [Self::Name, Self::Plane, Self::Domain, Self::Equals];
}

/// A line that is written.
#[derive(Debug, Clone, Default)]
pub(super) struct Line {
    /// Without its comment.
    pub(super) text: String,
    /// The comment behind the text.
    pub(super) comment: Option<String>,
    pub(super) table: Option<Table>,
    /// Where the columns begin, in characters.
    pub(super) marks: Vec<(Column, usize)>,
}

impl Line {
    pub(super) fn width(&self) -> usize {
        self.text.chars().count()
    }

    fn mark(&self, column: Column) -> Option<usize> {
        let mark = self.marks.iter().find(|(own, _)| *own == column);
        mark.map(|(_, place)| *place)
    }

    /// Moves a column and all behind it to the right.
    fn pad(&mut self, column: Column, to: usize) {
        let Some(from) = self.mark(column) else {
            return;
        };
        let byte = self.text.char_indices().nth(from).map(|(byte, _)| byte);
        let blanks = " ".repeat(to - from);
        self.text
            .insert_str(byte.unwrap_or(self.text.len()), &blanks);
        for (own, place) in &mut self.marks {
            if *own >= column {
                *place += to - from;
            }
        }
    }
}

/// The text of lines: the columns of neighbouring declarations of a table are aligned, unless that
/// makes one of them too long, and so are the comments of neighbouring lines.
pub(super) fn aligned(mut lines: Vec<Line>) -> String {
    for run in lines.chunk_by_mut(|a, b| a.table.is_some() && a.table == b.table) {
        align(run);
    }
    let mut text = String::new();
    for run in lines.chunk_by(|a, b| a.comment.is_some() && b.comment.is_some()) {
        let widest = run.iter().map(Line::width).max().unwrap_or(0);
        for line in run {
            text += &line.text;
            if let Some(comment) = &line.comment {
                text += &" ".repeat(widest - line.width() + 2);
                text += comment;
            }
            text.push('\n');
        }
    }
    text
}

fn align(run: &mut [Line]) {
    let mut padded = run.to_vec();
    for column in Column::ALL {
        let target = padded.iter().filter_map(|line| line.mark(column)).max();
        for line in &mut padded {
            line.pad(column, target.unwrap_or(0));
        }
    }
    if padded.iter().all(|line| line.width() <= WIDTH) {
        run.clone_from_slice(&padded);
    }
}
