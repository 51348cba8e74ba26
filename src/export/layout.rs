use serde_json::json;

/// A JSON text with its line breaks: one line for each member of an object and each row.
pub(super) enum Layout {
    /// Members of an object, by name.
    Object(Vec<(&'static str, Layout)>),
    /// Items of an array.
    List(Vec<Layout>),
    /// Items of an array, one line each.
    Rows(Vec<String>),
    /// A value on one line.
    Line(String),
}

impl Layout {
    /// A value on one line.
    pub(super) fn line(value: impl serde::Serialize) -> Self {
        Self::Line(json!(value).to_string())
    }

    /// The whole file.
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.into_text().into_bytes()
    }

    /// The whole text.
    pub(super) fn into_text(self) -> String {
        let mut text = String::new();
        self.print(0, &mut text);
        text.push('\n');
        text
    }

    /// Appends the text; its first line begins where the text ends, the others are indented.
    fn print(&self, depth: usize, text: &mut String) {
        let margin = |depth| format!("\n{}", "  ".repeat(depth));
        let comma = |index| if index > 0 { "," } else { "" };
        match self {
            Self::Line(line) => text.push_str(line),
            Self::Rows(rows) => {
                text.push('[');
                for (index, row) in rows.iter().enumerate() {
                    text.extend([comma(index), &margin(depth + 1), row]);
                }
                text.extend([&margin(depth), "]"]);
            }
            Self::List(items) => {
                text.push('[');
                for (index, item) in items.iter().enumerate() {
                    text.extend([comma(index), &margin(depth + 1)]);
                    item.print(depth + 1, text);
                }
                text.extend([&margin(depth), "]"]);
            }
            Self::Object(members) => {
                text.push('{');
                for (index, (key, value)) in members.iter().enumerate() {
                    text.extend([comma(index), &margin(depth + 1), "\"", key, "\": "]);
                    value.print(depth + 1, text);
                }
                text.extend([&margin(depth), "}"]);
            }
        }
    }
}

/// What belongs to u and what to v.
pub(super) fn along(u: Layout, v: Layout) -> Layout {
    Layout::Object(vec![("u", u), ("v", v)])
}

/// Rows of equal length, one line each.
pub(super) fn rows(items: Vec<String>, columns: usize) -> Layout {
    let rows = items.chunks(columns);
    Layout::Rows(rows.map(|row| array(row.iter().cloned())).collect())
}

/// An array on one line.
pub(super) fn array(items: impl Iterator<Item = String>) -> String {
    let mut text = String::from("[");
    for item in items {
        if text.len() > 1 {
            text.push_str(", ");
        }
        text.push_str(&item);
    }
    text.push(']');
    text
}
