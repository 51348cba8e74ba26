//! A file is a few screens, a function is one.

use crate::source::{Source, Word};
use crate::{Finding, hold, tree};

const FILE_LINES: usize = 600;
const FUNCTION_LINES: usize = 60;

/// Longer functions, each with the reason why it is one idea.
const LONGER: &[(&str, &str, &str)] = &[];

/// Files of more than [`FILE_LINES`] lines.
fn files(file: &Source) -> Vec<Finding> {
    let lines = file.text.lines().count();
    let long = lines > FILE_LINES;
    long.then(|| format!("{}: {lines} lines", file.at(1)))
        .into_iter()
        .collect()
}

/// Functions of more than [`FUNCTION_LINES`] lines, from `fn` to the closing brace.
fn functions(file: &Source) -> Vec<Finding> {
    let words = file.words();
    let mut findings = Vec::new();
    for pair in words.windows(2).filter(|pair| pair[0].text == "fn") {
        let between = &file.code[pair[0].start + 2..pair[1].start];
        let lines = if between.trim().is_empty() {
            lines(&file.code, pair[0])
        } else {
            0
        };
        let name = pair[1].text;
        let excused = LONGER
            .iter()
            .any(|(path, long, _)| *path == file.name && *long == name);
        if lines > FUNCTION_LINES && !excused {
            findings.push(format!(
                "{}: `{name}` has {lines} lines",
                file.at(pair[0].line)
            ));
        }
    }
    findings
}

/// The lines of the function at a word `fn`; none for a declaration without a body.
fn lines(code: &str, start: Word<'_>) -> usize {
    let (mut braces, mut brackets, mut lines) = (0_usize, 0_usize, 1);
    for c in code[start.start..].chars() {
        match c {
            '\n' => lines += 1,
            '(' | '[' => brackets += 1,
            ')' | ']' => brackets = brackets.saturating_sub(1),
            ';' if braces == 0 && brackets == 0 => return 0,
            '{' => braces += 1,
            '}' if braces == 1 => return lines,
            '}' => braces = braces.saturating_sub(1),
            _ => {}
        }
    }
    lines
}

#[test]
fn files_are_short() {
    hold(&tree::rust(), files);
}

#[test]
fn functions_fit_a_screen() {
    hold(&tree::rust(), functions);
}

#[test]
fn a_long_file_is_found() {
    assert_eq!(
        files(&Source::new("src/a.rs", &"//\n".repeat(601))).len(),
        1
    );
    assert!(files(&Source::new("src/a.rs", &"//\n".repeat(600))).is_empty());
}

#[test]
fn a_long_function_is_found() {
    let text = |body: usize| {
        format!(
            "fn f(a: [u8; 2]) {{\n{}}}\nfn g();\n",
            "{ } // {\n".repeat(body)
        )
    };
    assert_eq!(functions(&Source::new("src/a.rs", &text(59))).len(), 1);
    assert!(functions(&Source::new("src/a.rs", &text(58))).is_empty());
}
