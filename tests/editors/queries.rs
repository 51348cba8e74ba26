//! The queries of the tree-sitter grammar: what they capture in the texts of the project.

use std::collections::{BTreeMap, BTreeSet};

use sweepc::syntax::lexer::{Keyword, TokenKind};
use tree_sitter::{Query, QueryCursor, StreamingIterator};
use tree_sitter_sweep::{FOLDS_QUERY, HIGHLIGHTS_QUERY, INDENTS_QUERY, LANGUAGE, LOCALS_QUERY};

use crate::texts::{comments, derived, tokens, written};
use crate::trees::tree;

/// Every capture of a query in a text: its bytes and its name.
pub(crate) fn captures(query: &Query, text: &str) -> Vec<(usize, usize, String)> {
    let tree = tree(text);
    let mut cursor = QueryCursor::new();
    let mut matches = cursor.captures(query, tree.root_node(), text.as_bytes());
    let mut found = Vec::new();
    while let Some((own, place)) = matches.next() {
        let capture = own.captures[*place];
        let name = query.capture_names()[capture.index as usize];
        let node = capture.node;
        found.push((node.start_byte(), node.end_byte(), name.to_owned()));
    }
    found
}

fn compiled(query: &str) -> Query {
    Query::new(&LANGUAGE.into(), query).unwrap()
}

/// The captures that a token of the compiler may have.
fn highlights(kind: TokenKind) -> &'static [&'static str] {
    use TokenKind::*;
    match kind {
        Keyword(self::Keyword::Import) => &["keyword.import"],
        Keyword(_) => &["keyword"],
        Number => &["number"],
        Text => &["string"],
        OpenParenthesis | CloseParenthesis | OpenBracket | CloseBracket => &["punctuation.bracket"],
        Comma | Colon | Dot => &["punctuation.delimiter"],
        Name => &[
            "constant",
            "constant.builtin",
            "constructor",
            "function",
            "function.builtin",
            "function.call",
            "label",
            "operator",
            "property",
            "type",
            "variable",
            "variable.parameter",
        ],
        _ => &["operator"],
    }
}

#[test]
fn every_token_has_one_highlight_of_its_kind() {
    let query = compiled(HIGHLIGHTS_QUERY);
    let texts = written().into_iter().map(|(_, text)| text);
    let derived = derived().into_iter().map(|(_, text)| text);
    for text in texts.chain(derived) {
        if tree(&text).root_node().has_error() {
            continue;
        }
        let mut captured = BTreeMap::new();
        for (start, end, name) in captures(&query, &text) {
            let former = captured.insert((start, end), name.clone());
            assert_eq!(former, None, "{:?}: {name} in {text:?}", &text[start..end]);
        }
        for own in comments(&text) {
            let found = captured.remove(&(own.start, own.end));
            assert_eq!(found.as_deref(), Some("comment"), "{text:?}");
        }
        for (kind, own) in tokens(&text) {
            let found = captured.remove(&(own.start, own.end));
            let fits = found
                .as_deref()
                .is_some_and(|found| highlights(kind).contains(&found));
            assert!(fits, "{:?}: {found:?} in {text:?}", &text[own]);
        }
        assert!(captured.is_empty(), "{captured:?} in {text:?}");
    }
}

#[test]
fn every_capture_of_every_query_is_found_somewhere() {
    let texts = written();
    for source in [HIGHLIGHTS_QUERY, LOCALS_QUERY, FOLDS_QUERY, INDENTS_QUERY] {
        let query = compiled(source);
        let mut found = BTreeSet::new();
        for (_, text) in &texts {
            found.extend(captures(&query, text).into_iter().map(|(.., name)| name));
        }
        let names = query.capture_names().iter().map(|own| (*own).to_owned());
        assert_eq!(found, names.collect());
    }
}

/// The highlights of the names of a text, in their order.
fn names(text: &str) -> Vec<(&str, String)> {
    let query = compiled(HIGHLIGHTS_QUERY);
    let mut found = captures(&query, text);
    found.sort();
    let names = found.into_iter().filter_map(|(start, end, name)| {
        let word = &text[start..end];
        let is_name = word.starts_with(char::is_alphabetic) && !name.starts_with("keyword");
        is_name.then_some((word, name))
    });
    names.collect()
}

#[test]
fn names_are_told_apart() {
    let text = "construction tube(p) = c.κ(v) a + turn(h, best: b).x k + line(u) dot(σ)";
    let expected = [
        ("tube", "function"),
        ("p", "variable.parameter"),
        ("c", "variable"),
        ("κ", "property"),
        ("v", "variable.parameter"),
        ("a", "variable"),
        ("turn", "function.call"),
        ("h", "variable"),
        ("best", "label"),
        ("b", "variable"),
        ("x", "property"),
        ("k", "constant.builtin"),
        ("line", "constructor"),
        ("u", "variable.parameter"),
        ("dot", "function.builtin"),
        ("σ", "property"),
    ];
    let found = names(text);
    let found: Vec<_> = found.iter().map(|own| (own.0, own.1.as_str())).collect();
    assert_eq!(found, expected);
    let text =
        "surface R on [0, 1] x [0, 1] = c\nunit mm\nlet a = 1\nlet f(u) = 1\ncurve d(v) in xy = a";
    let expected = [
        ("R", "type"),
        ("x", "operator"),
        ("c", "variable"),
        ("mm", "constant.builtin"),
        ("a", "constant"),
        ("f", "function"),
        ("u", "variable.parameter"),
        ("d", "function"),
        ("v", "variable.parameter"),
        ("xy", "constant.builtin"),
        ("a", "variable"),
    ];
    let found = names(text);
    let found: Vec<_> = found.iter().map(|own| (own.0, own.1.as_str())).collect();
    assert_eq!(found, expected);
}

#[test]
fn the_names_of_a_construction_are_its_own() {
    let text = "let q = 1\nconstruction f(p) = p q where q = 2";
    let query = compiled(LOCALS_QUERY);
    let of = |wanted: &str| -> Vec<&str> {
        let found = captures(&query, text).into_iter();
        found
            .filter(|(.., name)| name == wanted)
            .map(|(start, end, _)| &text[start..end])
            .collect()
    };
    assert_eq!(of("local.scope"), [text, &text[10..]]);
    assert_eq!(of("local.definition"), ["q", "p", "q"]);
    assert_eq!(of("local.reference"), ["p", "q"]);
}

#[test]
fn long_declarations_and_comments_fold() {
    let text = "# one\n# two\nlet a = f(\n  1)";
    let found = captures(&compiled(FOLDS_QUERY), text);
    let places: Vec<_> = found.iter().map(|own| &text[own.0..own.1]).collect();
    assert_eq!(places, ["# one", "# two", "let a = f(\n  1)", "(\n  1)"]);
}
