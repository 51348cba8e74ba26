//! The tree-sitter grammar: its trees, and that it accepts what the compiler accepts.

use tree_sitter::{Parser, Tree};

use crate::texts::{derived, files, is_refused, written};

/// The tree of a text.
pub(crate) fn tree(text: &str) -> Tree {
    let mut parser = Parser::new();
    parser
        .set_language(&tree_sitter_sweep::LANGUAGE.into())
        .unwrap();
    parser.parse(text, None).unwrap()
}

/// Whether the tree of a text has no ERROR and no MISSING node.
fn is_accepted(text: &str) -> bool {
    !tree(text).root_node().has_error()
}

/// A case of the corpus.
struct Case<'a> {
    title: &'a str,
    refused: bool,
    text: &'a str,
    expected: String,
}

/// The cases of a file: a title between double rules, a text, a single rule, a tree.
fn cases(corpus: &str) -> Vec<Case<'_>> {
    let rule = "=".repeat(80);
    let parts: Vec<&str> = corpus.split(&rule).skip(1).collect();
    let (pairs, rest) = parts.as_chunks::<2>();
    assert!(rest.is_empty() && !pairs.is_empty());
    pairs
        .iter()
        .map(|[head, body]| {
            let (text, expected) = body.split_once(&"-".repeat(80)).unwrap();
            let (title, attributes) = head.trim().split_once('\n').unwrap_or((head.trim(), ""));
            Case {
                title,
                refused: attributes == ":error",
                text: text.trim(),
                expected: expected.split_whitespace().collect::<Vec<_>>().join(" "),
            }
        })
        .collect()
}

#[test]
fn the_trees_are_those_of_the_corpus() {
    let (mut sound, mut refused) = (0, 0);
    for (name, corpus) in files("grammar/tree-sitter/test/corpus", "txt") {
        for case in cases(&corpus) {
            assert_eq!(
                is_refused(case.text),
                case.refused,
                "{name}: {}",
                case.title
            );
            assert_eq!(
                !is_accepted(case.text),
                case.refused,
                "{name}: {}",
                case.title
            );
            if case.refused {
                refused += 1;
                continue;
            }
            let found = tree(case.text).root_node().to_sexp();
            assert_eq!(found, case.expected, "{name}: {}", case.title);
            sound += 1;
        }
    }
    assert!(
        sound > 20 && refused > 8,
        "{sound} sound, {refused} refused"
    );
}

#[test]
fn every_written_text_is_accepted() {
    for (name, text) in written() {
        let tree = tree(&text);
        assert!(
            !tree.root_node().has_error(),
            "{name}: {}",
            tree.root_node()
        );
    }
}

/// A number with a component is a sentence, but of no meaning; the tree-sitter grammar refuses it.
fn has_component_of_a_number(tokens: &[String]) -> bool {
    let is_number = |token: &str| token.starts_with(|c: char| c.is_ascii_digit());
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| is_number(&pair[0]) && pair[1] == ".")
}

#[test]
fn every_sentence_of_the_grammar_is_accepted() {
    let mut accepted = 0;
    for (tokens, text) in derived() {
        if has_component_of_a_number(&tokens) {
            continue;
        }
        assert!(!is_refused(&text), "{text:?}");
        assert!(is_accepted(&text), "{text:?}\n{}", tree(&text).root_node());
        accepted += 1;
    }
    assert!(accepted > 300, "{accepted}");
}

/// `0` with a name that begins with x is refused for what it means in other languages.
fn has_zero_and_x(tokens: &[String]) -> bool {
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| pair[0] == "0" && pair[1].starts_with('x'))
}

/// The tokens with one dropped, one doubled, and two swapped, at a place.
fn slips(tokens: &[String], at: usize) -> [Vec<String>; 3] {
    let [mut dropped, mut doubled, mut swapped] = [(); 3].map(|()| tokens.to_vec());
    dropped.remove(at);
    doubled.insert(at, tokens[at].clone());
    swapped.swap(at, (at + 1).min(tokens.len() - 1));
    [dropped, doubled, swapped]
}

#[test]
fn a_sentence_with_a_slip_is_judged_as_by_the_compiler() {
    let (mut accepted, mut refused) = (0, 0);
    for (sentence, _) in derived() {
        for at in (0..sentence.len()).step_by(11) {
            for tokens in slips(&sentence, at) {
                if has_component_of_a_number(&tokens) || has_zero_and_x(&tokens) {
                    continue;
                }
                let text = tokens.join(" ");
                let expected = is_refused(&text);
                assert_eq!(!is_accepted(&text), expected, "{text:?}");
                *(if expected {
                    &mut refused
                } else {
                    &mut accepted
                }) += 1;
            }
        }
    }
    assert!(
        accepted > 300 && refused > 600,
        "{accepted} accepted, {refused} refused"
    );
}
