//! The TextMate grammar: its scopes, line by line and token by token.

use std::ops::Range;

use serde_json::Value;
use sweepc::syntax::lexer::{Keyword, TokenKind};

use crate::textmate::TextMate;
use crate::texts::{comments, derived, files, tokens, written};

const GRAMMAR: &str = include_str!("../../grammar/textmate/sweep.tmLanguage.json");

/// What the scope of a token of the compiler begins with.
fn scopes(kind: TokenKind) -> &'static [&'static str] {
    use TokenKind::*;
    match kind {
        Keyword(self::Keyword::Import) => &["keyword.control.import"],
        Keyword(_) => &["storage.type", "keyword.other"],
        Number => &["constant.numeric"],
        Text => &["string.quoted"],
        Prime | DoublePrime => &["keyword.operator.derivative"],
        Plus | Minus | Star | Slash | Caret => &["keyword.operator.arithmetic"],
        Equal => &["keyword.operator.assignment"],
        DoubleEqual | NotEqual | Less | LessOrEqual | Greater | GreaterOrEqual => {
            &["keyword.operator.comparison"]
        }
        OpenParenthesis | CloseParenthesis => &["punctuation.section.parens"],
        OpenBracket | CloseBracket => &["punctuation.section.brackets"],
        Comma => &["punctuation.separator.comma"],
        Colon => &["punctuation.separator.key-value"],
        Dot => &["punctuation.accessor"],
        Name => &[
            "constant.language",
            "entity.name",
            "support",
            "variable",
            // between the two intervals of a surface
            "keyword.operator.arithmetic",
        ],
        _ => &[],
    }
}

#[test]
fn every_token_has_a_scope_of_its_kind() {
    let textmate = TextMate::new(GRAMMAR);
    let texts = written().into_iter().map(|(_, text)| text);
    for text in texts.chain(derived().into_iter().map(|(_, text)| text)) {
        let coloured = textmate.colour(&text);
        let mut bare = vec![true; text.len()];
        let mut take = |range: Range<usize>, wanted: &[&str]| {
            // the quotes of a string have a scope of their own
            let first = &coloured.scopes(range.start..range.start + 1)[0];
            let fits = wanted.iter().any(|own| first.starts_with(own));
            assert!(fits, "{:?}: {first} in {text:?}", &text[range.clone()]);
            for at in range.clone() {
                assert_eq!(&coloured.scopes(at..at + 1)[0], first, "{text:?}");
            }
            bare[range].fill(false);
        };
        for own in comments(&text) {
            take(own, &["comment.line.number-sign"]);
        }
        for (kind, own) in tokens(&text) {
            take(own, scopes(kind));
        }
        for (at, _) in bare.iter().enumerate().filter(|(_, bare)| **bare) {
            let found = coloured.scopes(at..at + 1);
            assert!(found.is_empty(), "{found:?} for a blank of {text:?}");
        }
    }
}

/// What a line of a test says about the line before: columns, and scopes in their order.
fn assertion(line: &str) -> Option<(Range<usize>, Vec<&str>)> {
    let behind = line.strip_prefix('#')?.trim_start();
    let (mark, scopes) = behind.split_once(' ')?;
    let start = line.chars().count() - behind.chars().count();
    let columns = match mark.strip_prefix('<') {
        Some(dashes) if !dashes.is_empty() && dashes.chars().all(|c| c == '-') => 0..dashes.len(),
        None if mark.chars().all(|c| c == '^') => start..start + mark.len(),
        _ => return None,
    };
    Some((columns, scopes.split_whitespace().collect()))
}

/// The format of `vscode-tmgrammar-test`, which can run the same files on VS Code's own engine.
#[test]
fn the_scopes_are_those_of_the_test_lines() {
    let textmate = TextMate::new(GRAMMAR);
    let mut checked = 0;
    for (name, text) in files("grammar/textmate/test", "sweep") {
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[0].starts_with("# SYNTAX TEST \"source.sweep\""));
        let is_source = |line: &&str| assertion(line).is_none();
        let source: Vec<&str> = lines.iter().copied().filter(is_source).collect();
        let coloured = textmate.colour(&source.join("\n"));
        let (mut start, mut next) = (0, 0);
        for line in lines {
            let Some((columns, wanted)) = assertion(line) else {
                start = next;
                next += line.len() + 1;
                continue;
            };
            let content = &source.join("\n")[start..next - 1];
            let byte = |column| {
                content
                    .char_indices()
                    .nth(column)
                    .map_or(content.len(), |own| own.0)
            };
            for at in start + byte(columns.start)..start + byte(columns.end) {
                let mut found = coloured.scopes(at..at + 1).iter();
                let fits = wanted.iter().all(|own| found.any(|scope| scope == own));
                assert!(
                    fits,
                    "{name}: {content}\n{line}\n{:?}",
                    coloured.scopes(at..at + 1)
                );
            }
            checked += 1;
        }
    }
    assert!(checked > 80, "{checked}");
}

#[test]
fn every_part_of_the_grammar_is_used() {
    assert_eq!(TextMate::new(GRAMMAR).unused(), Vec::<&str>::new());
}

#[test]
fn the_extension_is_whole() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/grammar/textmate/");
    let read = |name: &str| -> Value {
        let text = std::fs::read_to_string(format!("{folder}{name}")).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    let contributed = &read("package.json")["contributes"];
    let (language, grammar) = (&contributed["languages"][0], &contributed["grammars"][0]);
    assert_eq!(language["id"], grammar["language"]);
    assert_eq!(language["extensions"][0], ".sweep");
    let path = grammar["path"].as_str().unwrap();
    assert_eq!(read(path)["scopeName"], grammar["scopeName"]);
    let configuration = read(language["configuration"].as_str().unwrap());
    assert_eq!(configuration["comments"]["lineComment"], "#");
    for key in ["increaseIndentPattern", "decreaseIndentPattern"] {
        let pattern = configuration["indentationRules"][key].as_str().unwrap();
        fancy_regex::Regex::new(pattern).unwrap();
    }
    let word = fancy_regex::Regex::new(configuration["wordPattern"].as_str().unwrap()).unwrap();
    for own in ["σ_1", "ph3", "1.5e−3", "7"] {
        assert_eq!(word.find(own).unwrap().unwrap().as_str(), own);
    }
}
