//! The written grammar is the grammar: `grammar/sweep.ebnf` is read, and what it derives parses.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on has failed"
)]

mod derivation;
mod ebnf;
mod near_misses;
mod recognition;
#[path = "../syntax/show.rs"]
mod show;

use std::collections::BTreeSet;

use derivation::Derivation;
use ebnf::Grammar;
use show::show_document;
use sweepc::diag::{Diagnostics, FileId, Limits};
use sweepc::syntax::ast::Document;
use sweepc::syntax::lexer::Keyword;
use sweepc::syntax::{Formatter, Reading, Spelling, parse};

const SEED: u64 = 20_260_102;
/// How many sentences are derived of a document, and of each declaration.
const DOCUMENTS: usize = 400;
const DECLARATIONS: usize = 150;
/// The rules that say which characters make tokens, and that no rule of a declaration names.
const CATALOGUE: [&str; 5] = ["Text", "Blank", "Comment", "Token", "Sign"];

pub(crate) fn grammar() -> Grammar {
    Grammar::read(include_str!("../../grammar/sweep.ebnf"))
}

pub(crate) fn parsed(text: &str) -> (Document, Diagnostics) {
    let mut diagnostics = Diagnostics::default();
    let document = parse(FileId(0), text, &Limits::default(), &mut diagnostics);
    (document, diagnostics)
}

/// The starts of a derivation: whole documents, and each declaration on its own.
pub(crate) fn starts(grammar: &Grammar) -> Vec<String> {
    let mut starts = vec!["Document".to_owned(); DOCUMENTS];
    let ebnf::Part::Choice(_, declarations) = grammar.rule("Declaration") else {
        panic!("`Declaration` is no choice");
    };
    for declaration in declarations {
        let ebnf::Part::Rule(name) = declaration else {
            panic!("a declaration without a rule");
        };
        starts.extend(vec![name.clone(); DECLARATIONS]);
    }
    starts
}

/// Whether two tokens would become another one if they touched.
fn would_merge(before: &str, after: &str) -> bool {
    let is_wordy = |c: char| c == '_' || c.is_alphanumeric();
    let number = before.starts_with(|c: char| c.is_ascii_digit());
    before.ends_with(is_wordy) && (after.starts_with(is_wordy) || number && after == ".")
}

/// The text of a sentence, with blanks and comments between its tokens.
fn text(derivation: &mut Derivation<'_>, tokens: &[String]) -> String {
    let mut text = String::new();
    if derivation.random.next(8) == 0 {
        text.push('\u{feff}');
    }
    let comments = derivation.random.next(2) == 0;
    for (place, token) in tokens.iter().enumerate() {
        let before = place.checked_sub(1).map_or("", |own| tokens[own].as_str());
        let mut gap = String::new();
        while derivation.random.next(3) == 0 {
            gap += &derivation.word("Blank");
        }
        if comments && derivation.random.next(5) == 0 {
            gap += &derivation.word("Comment");
            gap += ["\n", "\r\n", "\r"][derivation.random.next(3)];
        } else if gap.is_empty() && would_merge(before, token) {
            gap += &derivation.word("Blank");
        }
        text += &gap;
        text += token;
    }
    if derivation.random.next(4) == 0 {
        text += &derivation.word("Comment");
    }
    text
}

/// The canonical text; it has the same tree and stays as it is.
fn check_format(text: &str, spelling: Spelling) {
    let limits = Limits::default();
    let formatter = Formatter {
        spelling,
        reading: &|_, _| Reading::Unknown,
        limits: &limits,
    };
    let document = parsed(text).0;
    let Some(formatted) = formatter.format(&document, text) else {
        panic!("not formatted: {text:?}");
    };
    let (again, findings) = parsed(&formatted);
    assert!(!findings.has_errors(), "{text:?}\n{formatted}");
    assert_eq!(
        show_document(&document),
        show_document(&again),
        "{formatted}"
    );
    let twice = formatter.format(&again, &formatted);
    assert_eq!(twice.as_deref(), Some(formatted.as_str()), "{text:?}");
    assert!(!formatted.contains(['\r', '\u{feff}']), "{formatted:?}");
    assert!(!formatted.contains(" \n"), "{formatted:?}");
    assert!(
        !formatted.contains("\n\n\n") && !formatted.starts_with('\n'),
        "{formatted:?}"
    );
    assert!(formatted.is_empty() || formatted.ends_with('\n') && !formatted.ends_with("\n\n"));
}

#[test]
fn every_production_is_derived_and_every_sentence_parses() {
    let grammar = grammar();
    let mut derivation = Derivation::new(&grammar, SEED);
    let mut seen: BTreeSet<String> = BTreeSet::new();
    for (place, start) in starts(&grammar).iter().enumerate() {
        let tokens = derivation.sentence(start);
        let text = text(&mut derivation, &tokens);
        let (document, findings) = parsed(&text);
        let errors: Vec<_> = findings.errors().collect();
        assert!(errors.is_empty(), "{text:?}\n{errors:#?}");
        assert!(start == "Document" || document.items.len() == 1, "{text:?}");
        assert!(recognition::is_document(&grammar, &tokens), "{tokens:?}");
        let spellings = [Spelling::AsWritten, Spelling::Ascii, Spelling::Unicode];
        check_format(&text, spellings[place % 3]);
        seen.extend(tokens);
    }
    let mut choices = grammar.choices("Document");
    choices.extend(grammar.choices("Blank"));
    choices.extend(grammar.choices("Comment"));
    for (number, (rule, outcomes)) in choices {
        for outcome in 0..outcomes {
            let taken = derivation.taken.contains_key(&(number, outcome));
            assert!(
                taken,
                "{rule}: outcome {outcome} of a choice is never taken"
            );
        }
    }
    for rule in ["Keyword", "Sign", "Minus", "Times", "Prime"] {
        for word in grammar.literals(rule) {
            assert!(seen.contains(&word), "no sentence has `{word}`");
        }
    }
}

#[test]
fn the_keywords_are_those_of_the_lexer() {
    let mut written = grammar().literals("Keyword");
    let mut known: Vec<_> = Keyword::ALL.iter().map(|own| own.as_str()).collect();
    written.sort();
    known.sort_unstable();
    assert_eq!(written, known);
}

#[test]
fn no_rule_is_dead() {
    let grammar = grammar();
    let mut reached = BTreeSet::from(["Document".to_owned()]);
    let mut new = vec!["Document".to_owned()];
    while let Some(name) = new.pop() {
        for rule in grammar.named(&name) {
            if reached.insert(rule.clone()) {
                new.push(rule);
            }
        }
    }
    for name in &grammar.names {
        let known = reached.contains(name) || CATALOGUE.contains(&name.as_str());
        assert!(known, "{name} is part of no declaration");
    }
}
