use crate::export::Double;

/// The columns of a parameter record that hold data.
const PARAMETER_COLUMNS: usize = 64;
/// The columns of a record of the start and global sections that hold data.
const COLUMNS: usize = 72;

/// The pointer to an entity: the number of its first directory record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pointer(pub(super) usize);

/// One parameter of an entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Parameter {
    Integer(usize),
    Real(Double),
    Text(String),
    Pointer(Pointer),
}

/// How an entity depends on others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Status {
    /// It stands for itself.
    Independent,
    /// It is a part of another one.
    Part,
    /// It is a part of another one, in the plane of its parameters.
    Parametric,
    /// It says something of another one.
    Property,
}

impl Status {
    fn digits(self) -> &'static str {
        match self {
            Self::Independent => "00000000",
            Self::Part => "00010000",
            Self::Parametric => "00010500",
            Self::Property => "00010200",
        }
    }
}

/// An entity: its type and form, its label and its parameters.
#[derive(Clone, Debug)]
pub(super) struct Entity {
    pub(super) kind: usize,
    pub(super) form: usize,
    pub(super) status: Status,
    pub(super) label: String,
    pub(super) parameters: Vec<Parameter>,
}

/// A file of the Initial Graphics Exchange Specification, version 5.3: records of 80 columns in
/// five sections.
#[derive(Debug, Default)]
pub(super) struct File {
    directory: Vec<String>,
    parameters: Vec<String>,
}

impl File {
    /// Appends an entity.
    pub(super) fn add(&mut self, entity: &Entity) -> Pointer {
        let pointer = Pointer(self.directory.len() + 1);
        let first = self.parameters.len() + 1;
        let kind = Parameter::Integer(entity.kind);
        let words = [&kind].into_iter().chain(&entity.parameters).map(spelled);
        let lines = wrapped(&words.collect::<Vec<_>>(), PARAMETER_COLUMNS);
        let count = lines.len();
        for line in lines {
            let number = self.parameters.len() + 1;
            let line = format!("{line:<64}{:>8}P{number:>7}", pointer.0);
            self.parameters.push(line);
        }
        let Entity {
            kind, form, label, ..
        } = entity;
        let status = entity.status.digits();
        let (one, two) = (pointer.0, pointer.0 + 1);
        self.directory.push(format!(
            "{kind:>8}{first:>8}{0:>8}{0:>8}{0:>8}{0:>8}{0:>8}{0:>8}{status}D{one:>7}",
            0
        ));
        self.directory.push(format!(
            "{kind:>8}{0:>8}{0:>8}{count:>8}{form:>8}{0:>8}{0:>8}{label:>8}{0:>8}D{two:>7}",
            0
        ));
        pointer
    }

    /// The whole file: what a person reads first, and the words of the global section.
    pub(super) fn text(&self, start: &str, global: &[Parameter]) -> String {
        let global: Vec<_> = global.iter().map(spelled).collect();
        let mut text = String::new();
        let mut section = |lines: &[String], letter: char| {
            for (number, line) in (1..).zip(lines) {
                text.push_str(&format!("{line:<72}{letter}{number:>7}\n"));
            }
            lines.len()
        };
        let start = section(&[start.to_owned()], 'S');
        let global = section(&wrapped(&global, COLUMNS), 'G');
        for line in self.directory.iter().chain(&self.parameters) {
            text.push_str(line);
            text.push('\n');
        }
        let (directory, parameters) = (self.directory.len(), self.parameters.len());
        let counts = format!("S{start:>7}G{global:>7}D{directory:>7}P{parameters:>7}");
        text.push_str(&format!("{counts:<72}T{:>7}\n", 1));
        text
    }
}

/// A parameter as it is written.
fn spelled(parameter: &Parameter) -> String {
    match parameter {
        Parameter::Integer(value) => value.to_string(),
        Parameter::Pointer(Pointer(value)) => value.to_string(),
        // An exponent after D makes a constant of double precision; E would be a single one.
        Parameter::Real(value) => value.step().replace('E', "D"),
        Parameter::Text(text) => {
            let text = ascii(text);
            format!("{}H{text}", text.len())
        }
    }
}

/// Words in records: separated by commas, ended by a semicolon. Only a text may run on in the next
/// record.
fn wrapped(words: &[String], columns: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (index, word) in words.iter().enumerate() {
        let delimiter = if index + 1 == words.len() { ';' } else { ',' };
        let mut rest = format!("{word}{delimiter}");
        let last = lines.last().map_or(0, String::len);
        if last + rest.len() > columns && last > 0 {
            lines.push(String::new());
        }
        while rest.len() > columns {
            let next = rest.split_off(columns);
            lines.pop();
            lines.extend([rest, String::new()]);
            rest = next;
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(&rest);
        }
    }
    lines
}

/// A text in printable ASCII; other characters, and the backslash, by their number: `\u{3C3}`.
pub(super) fn ascii(text: &str) -> String {
    let spelled = |character: char| match character {
        ' '..='[' | ']'..='~' => character.to_string(),
        other => format!("\\u{{{:X}}}", u32::from(other)),
    };
    text.chars().map(spelled).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_wrapped_whole_and_texts_run_on() {
        let words = ["12".to_owned(), "345.".to_owned(), "6".to_owned()];
        assert_eq!(wrapped(&words, 8), ["12,345.,", "6;"]);
        assert_eq!(wrapped(&words, 7), ["12,", "345.,6;"]);
        let words = ["1".to_owned(), "9Habcdefghi".to_owned()];
        assert_eq!(wrapped(&words, 8), ["1,", "9Habcdef", "ghi;"]);
    }

    #[test]
    fn texts_are_counted_in_ascii() {
        let spelled = |text: &str| spelled(&Parameter::Text(text.to_owned()));
        assert_eq!(spelled("R;,"), "3HR;,");
        assert_eq!(spelled("Rσ"), "8HR\\u{3C3}");
        assert_eq!(spelled("a\\b"), "8Ha\\u{5C}b");
    }
}
