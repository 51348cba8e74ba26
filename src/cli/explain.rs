use std::collections::BTreeSet;
use std::io::IsTerminal;

use anstyle::{AnsiColor, Style};

use crate::diag::Code;

use super::arguments::{Arguments, ExplainArguments};
use super::status::Status;
use super::streams::{complain, print};
use super::voice::is_coloured;

/// How many codes are proposed for one that does not exist.
const PROPOSALS: usize = 3;

/// `sweepc explain CODE…`; without a code, the list of all.
pub(super) fn run(own: &ExplainArguments, arguments: &Arguments) -> Status {
    let coloured = is_coloured(arguments.color, std::io::stdout().is_terminal());
    if own.codes.is_empty() {
        return print(&list(coloured));
    }
    let mut pages = Vec::new();
    for word in &own.codes {
        let word = word.trim();
        match Code::ALL
            .iter()
            .find(|own| own.as_str().eq_ignore_ascii_case(word))
        {
            Some(code) => pages.push(page(*code, coloured)),
            None => {
                complain(&unknown(word));
                return Status::Usage;
            }
        }
    }
    print(&pages.join("\n"))
}

/// The line that names the pages on some codes.
pub(super) fn hint(codes: &BTreeSet<Code>) -> String {
    let codes: Vec<&str> = codes.iter().map(|own| own.as_str()).collect();
    format!("for more: sweepc explain {}", codes.join(" "))
}

/// All codes with their titles, group by group.
fn list(coloured: bool) -> String {
    let mut text = String::new();
    let mut group = "";
    for code in Code::ALL {
        if code.group() != group {
            let blank = if group.is_empty() { "" } else { "\n" };
            group = code.group();
            text.push_str(blank);
            text.push_str(&painted(group, HEADING, coloured));
            text.push('\n');
        }
        text.push_str(&format!("  {code}  {}\n", code.title()));
    }
    text
}

const HEADING: Style = Style::new().bold();
const CODE: Style = AnsiColor::Cyan.on_default();

/// A page as it was written; on a coloured terminal without the marks of its headings and blocks.
fn page(code: Code, coloured: bool) -> String {
    let text = code.explanation();
    if !coloured {
        return text.to_owned();
    }
    let mut shown = String::new();
    let mut in_block = false;
    for line in text.lines() {
        if line.starts_with("```") {
            in_block = !in_block;
            continue;
        }
        let heading = line.trim_start_matches('#').trim_start();
        let line = match (in_block, heading.len() < line.len()) {
            (true, _) => painted(&format!("    {line}"), CODE, true),
            (false, true) if line.starts_with('#') => painted(heading, HEADING, true),
            _ => with_code(line),
        };
        shown.push_str(&line);
        shown.push('\n');
    }
    shown
}

/// A line with what stands between backticks painted.
fn with_code(line: &str) -> String {
    let parts = line.split('`').enumerate();
    parts
        .map(|(index, part)| painted(part, CODE, index % 2 == 1))
        .collect()
}

fn painted(text: &str, style: Style, coloured: bool) -> String {
    if coloured && !text.is_empty() {
        format!("{style}{text}{style:#}")
    } else {
        text.to_owned()
    }
}

/// What to say of a word that is no code: the codes whose titles hold it, else the nearest ones.
fn unknown(word: &str) -> String {
    let lower = word.to_lowercase();
    let titled = |own: &&&Code| lower.len() > 2 && own.title().to_lowercase().contains(&lower);
    let mut near: Vec<&Code> = Code::ALL.iter().filter(|own| titled(&own)).collect();
    if near.is_empty() {
        near.extend(Code::ALL);
        let word = word.to_ascii_uppercase();
        near.sort_by_key(|own| strsim::damerau_levenshtein(&word, own.as_str()));
        near.truncate(PROPOSALS);
    }
    let near = near.iter().map(|own| format!("{own} ({})", own.title()));
    let near = near.collect::<Vec<_>>().join(", ");
    format!("`{word}` is no code; near are {near}; `sweepc explain` lists all")
}
