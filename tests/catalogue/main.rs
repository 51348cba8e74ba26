//! The catalogue of bad input: every row a test, with the outcome that is promised.
//!
//! Rows are numbered. Those about one text are the tables in `text.rs` and `meaning.rs`, to be read
//! from top to bottom; those that need several files, signals or a full disk are functions in
//! `files.rs`, `signals.rs` and `sameness.rs`. Every run is watched: it may not panic, not die of a
//! signal, not take longer than 20 seconds and not ask for more than 4 GiB.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod meaning;
mod text;
mod watched;

#[cfg(unix)]
mod files;
#[cfg(unix)]
mod sameness;
#[cfg(unix)]
mod signals;

use std::fs;

use tempfile::TempDir;
use watched::sweepc;

/// One text, what is asked for, and what comes of it.
pub(crate) struct Row {
    /// Its number in the catalogue.
    pub(crate) number: u32,
    pub(crate) input: Input,
    /// The command with its options; the file is called `x.sweep`.
    pub(crate) arguments: &'static [&'static str],
    /// The exit status.
    pub(crate) status: i32,
    /// The codes of all findings, in their order.
    pub(crate) codes: &'static [&'static str],
    /// What is said, on standard error or standard output.
    pub(crate) says: &'static [&'static str],
}

pub(crate) enum Input {
    Text(&'static str),
    Bytes(&'static [u8]),
    Made(fn() -> String),
}

use Input::Text;

const CHECK: &[&str] = &["check", "x.sweep"];

/// A row of `sweepc check`.
const fn row(
    number: u32,
    input: Input,
    status: i32,
    codes: &'static [&'static str],
    says: &'static [&'static str],
) -> Row {
    Row {
        number,
        input,
        arguments: CHECK,
        status,
        codes,
        says,
    }
}

/// A row of another command.
const fn run(
    number: u32,
    text: &'static str,
    arguments: &'static [&'static str],
    status: i32,
    codes: &'static [&'static str],
    says: &'static [&'static str],
) -> Row {
    Row {
        number,
        input: Text(text),
        arguments,
        status,
        codes,
        says,
    }
}

/// Rows that functions hold, by the file in which they are.
const HELD_BY_FUNCTIONS: &[(u32, &str)] = &[
    (44, "files.rs"),
    (45, "files.rs"),
    (46, "files.rs"),
    (50, "files.rs"),
    (51, "files.rs"),
    (52, "files.rs"),
    (53, "signals.rs"),
    (54, "signals.rs"),
    (55, "signals.rs"),
    (57, "signals.rs"),
    (61, "sameness.rs"),
    (62, "sameness.rs"),
    (63, "files.rs"),
    (64, "files.rs"),
];

/// Rows that do not apply, each with the reason.
const NOT_YET: &[(u32, &str)] = &[
    (47, "not in the catalogue"),
    (56, "no command watches its files"),
    (66, "not in the catalogue"),
    (
        67,
        "no input is known that makes the program panic; that a panic is caught is tested where it \
         is caught, in src/cli/parallel.rs",
    ),
    (68, "there is no language server"),
];

/// The last row.
const LAST: u32 = 68;

fn rows() -> impl Iterator<Item = &'static Row> {
    text::ROWS.iter().chain(meaning::ROWS)
}

/// Runs the rows of a table; all that fail are shown.
fn hold(rows: &[Row]) {
    let failures: Vec<String> = rows.iter().filter_map(failure).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// What is wrong with the outcome of a row.
fn failure(row: &Row) -> Option<String> {
    let folder = TempDir::new().unwrap();
    let text = match row.input {
        Input::Text(text) => text.as_bytes().to_vec(),
        Input::Bytes(bytes) => bytes.to_vec(),
        Input::Made(make) => make().into_bytes(),
    };
    fs::write(folder.path().join("x.sweep"), &text).unwrap();
    let run = sweepc(folder.path(), row.arguments, &[]);
    let said = format!("{}{}", run.err, run.out);
    let mut wrong = Vec::new();
    if (run.status, run.codes().as_slice()) != (row.status, row.codes) {
        wrong.push(format!("{} {:?}", run.status, run.codes()));
    }
    let unsaid = row.says.iter().filter(|part| !said.contains(**part));
    wrong.extend(unsaid.map(|part| format!("`{part}` is not said")));
    // However long a line is, a message is read by people.
    if run.err.len() > 100_000 {
        wrong.push(format!("a message of {} bytes", run.err.len()));
    }
    let written = fs::read_dir(folder.path()).unwrap().count() - 1;
    if row.arguments[0] != "compile" && written > 0 {
        wrong.push(format!("{written} files are written"));
    }
    let start: String = String::from_utf8_lossy(&text).chars().take(99).collect();
    let said: String = said.chars().take(2_000).collect();
    let wrong = wrong.join(", ");
    (!wrong.is_empty()).then(|| format!("row {}: {start}\n{wrong}\n{said}", row.number))
}

#[test]
fn rows_about_the_text() {
    hold(text::ROWS);
}

#[test]
fn rows_about_the_meaning() {
    hold(meaning::ROWS);
}

#[test]
fn every_row_has_a_place() {
    for number in 1..=LAST {
        let in_tables = usize::from(rows().any(|row| row.number == number));
        let listed = HELD_BY_FUNCTIONS.iter().chain(NOT_YET);
        let places = in_tables + listed.filter(|(own, _)| *own == number).count();
        assert_eq!(places, 1, "row {number}");
    }
    for (number, file) in HELD_BY_FUNCTIONS {
        let path = format!("{}/tests/catalogue/{file}", env!("CARGO_MANIFEST_DIR"));
        let code = fs::read_to_string(path).unwrap();
        assert!(
            code.contains(&format!("fn row_{number}_")),
            "row {number} in {file}"
        );
    }
}
