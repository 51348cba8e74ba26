//! No Rust code names a construction: the standard library is text in the language itself.

use crate::source::{Source, words};
use crate::{Finding, hold, tree};

/// The names that lines `construction NAME(…` declare.
fn constructions(library: &str) -> Vec<String> {
    let lines = library
        .lines()
        .filter_map(|line| line.strip_prefix("construction "));
    lines
        .filter_map(|line| Some(line.split_once('(')?.0.trim().to_owned()))
        .collect()
}

/// Names of constructions in code or in string literals. A name of one word is also a word of the
/// language, so it counts only as a whole literal.
fn standard(file: &Source, names: &[String]) -> Vec<Finding> {
    let distinct = |word: &str| word.contains('_') && names.iter().any(|name| name == word);
    let finding = |line: usize, name: &str| format!("{}: the construction `{name}`", file.at(line));
    let mut findings = Vec::new();
    for word in file.words().into_iter().filter(|word| distinct(word.text)) {
        findings.push(finding(word.line, word.text));
    }
    for (line, literal) in &file.literals {
        if names.contains(literal) {
            findings.push(finding(*line, literal));
            continue;
        }
        for word in words(literal)
            .into_iter()
            .filter(|word| distinct(word.text))
        {
            findings.push(finding(line + word.line - 1, word.text));
        }
    }
    findings
}

#[test]
fn no_code_names_a_construction() {
    let names = constructions(&tree::standard_library());
    assert!(names.iter().any(|name| name == "oriented_translation"));
    hold(&tree::rust_of_the_crate(), |file| standard(file, &names));
}

#[test]
fn a_named_construction_is_found() {
    let names =
        constructions("# x\nconstruction scaled_turn(p) = p\nconstruction turn(h) =\n  h\n");
    assert_eq!(names, ["scaled_turn", "turn"]);
    let found = |text: &str| standard(&Source::new("src/sema/call.rs", text), &names).len();
    assert_eq!(
        found("match name { \"turn\" => scaled_turn(p), _ => {} }"),
        2
    );
    assert_eq!(found("let text = \"surface R =\\n scaled_turn(p)\";"), 1);
    assert_eq!(found("fn turn() { \"to turn\"; /* scaled_turn */ }"), 0);
}
