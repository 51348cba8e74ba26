//! The words that have a meaning of their own are the same for the compiler and for editors.

use std::collections::BTreeSet;

use sweepc::curve::kinds;
use sweepc::number::Unit;
use sweepc::sema::{BUILT_IN, QUERIES, RESERVED};
use sweepc::syntax::canonical_name;
use sweepc::syntax::lexer::Keyword;
use tree_sitter::Query;
use tree_sitter_sweep::{HIGHLIGHTS_QUERY, LANGUAGE};

use crate::queries::captures;
use crate::textmate::TextMate;

/// A group of words, where they stand in a text, and what editors call them there.
struct Group {
    words: Vec<String>,
    before: &'static str,
    behind: &'static str,
    capture: &'static str,
    scope: &'static str,
}

fn group<'a>(
    words: impl IntoIterator<Item = &'a str>,
    (before, behind): (&'static str, &'static str),
    (capture, scope): (&'static str, &'static str),
) -> Group {
    Group {
        words: words.into_iter().map(str::to_owned).collect(),
        before,
        behind,
        capture,
        scope,
    }
}

/// The words of the compiler.
fn groups() -> Vec<Group> {
    let reserved = |kept: fn(&str) -> bool| RESERVED.into_iter().filter(move |own| kept(own));
    let applied = ("let a = ", "(b)");
    let constructors = kinds::ALL.iter().map(|own| own.name);
    let property = ("property", "support.variable.property");
    let properties = |own: &str| !is_parameter(own) && !is_unit_vector(own);
    vec![
        group(
            constructors.chain(kinds::RESERVED.iter().copied()),
            applied,
            ("constructor", "support.function.constructor"),
        ),
        group(
            BUILT_IN,
            applied,
            ("function.builtin", "support.function.builtin"),
        ),
        group(
            QUERIES,
            ("expect ", "(b)"),
            ("function.builtin", "support.function.query"),
        ),
        group(reserved(properties), applied, property),
        group(reserved(properties), ("let a = ", ""), property),
        group(["sigma", "kappa", "rho", "ϰ", "ϱ"], applied, property),
        group(
            reserved(is_parameter),
            applied,
            ("variable.parameter", "variable.parameter"),
        ),
        group(
            reserved(is_unit_vector),
            ("let a = ", ""),
            ("constant.builtin", "constant.language.unit-vector"),
        ),
        group(
            Unit::ALL.map(Unit::symbol),
            ("unit ", ""),
            ("constant.builtin", "constant.language.unit"),
        ),
        group(
            ["xy", "xz", "yz"],
            ("curve c(u) in ", " = a"),
            ("constant.builtin", "constant.language.plane"),
        ),
    ]
}

fn is_parameter(word: &str) -> bool {
    ["u", "v"].contains(&word)
}

fn is_unit_vector(word: &str) -> bool {
    ["i", "j", "k"].contains(&word)
}

#[test]
fn the_words_of_the_compiler_are_known_to_editors() {
    let highlights = Query::new(&LANGUAGE.into(), HIGHLIGHTS_QUERY).unwrap();
    let textmate = TextMate::new(include_str!("../../grammar/textmate/sweep.tmLanguage.json"));
    for group in groups() {
        assert!(!group.words.is_empty());
        for word in &group.words {
            let text = format!("{}{word}{}", group.before, group.behind);
            let place = group.before.len()..group.before.len() + word.len();
            let found = captures(&highlights, &text).into_iter();
            let found: Vec<_> = found
                .filter(|own| (own.0..own.1) == place)
                .map(|own| own.2)
                .collect();
            assert_eq!(found, [group.capture], "{text}");
            let scope = format!("{}.sweep", group.scope);
            let coloured = textmate.colour(&text);
            assert_eq!(coloured.scopes(place), [scope], "{text}");
        }
    }
}

/// The words in quotes behind `any-of?` in the query of the highlights.
fn listed() -> BTreeSet<String> {
    let lists = HIGHLIGHTS_QUERY.split("any-of? ").skip(1);
    let words = lists.flat_map(|list| {
        list.split(')')
            .next()
            .unwrap()
            .split('"')
            .skip(1)
            .step_by(2)
    });
    words.map(str::to_owned).collect()
}

/// The words of the TextMate grammar's lists of names.
fn matched() -> BTreeSet<String> {
    let grammar: serde_json::Value =
        serde_json::from_str(include_str!("../../grammar/textmate/sweep.tmLanguage.json")).unwrap();
    let rules = grammar["repository"]["name"]["patterns"]
        .as_array()
        .unwrap();
    let mut words = BTreeSet::new();
    for rule in rules {
        let source = rule["match"].as_str().unwrap();
        let list = match source.strip_prefix("(?:") {
            Some(rest) => rest.split(')').next().unwrap(),
            None => source.split(']').next().unwrap(),
        };
        for word in list.split('|').filter(|own| !own.contains('-')) {
            match word.strip_prefix('[') {
                Some(letters) => {
                    words.extend(letters.trim_end_matches(']').chars().map(String::from))
                }
                None => _ = words.insert(word.to_owned()),
            }
        }
    }
    words
}

#[test]
fn editors_know_no_other_words() {
    let groups = groups();
    let own = groups
        .iter()
        .filter(|own| !["unit ", "curve c(u) in "].contains(&own.before));
    let words: BTreeSet<String> = own.flat_map(|own| own.words.clone()).collect();
    assert_eq!(listed(), words);
    assert_eq!(matched(), words);
    for word in words {
        let known = RESERVED.contains(&canonical_name(&word).as_str());
        assert!(known || word.is_ascii(), "{word}");
    }
}

#[test]
fn the_keywords_are_those_of_the_lexer() {
    let keywords: Vec<&str> = Keyword::ALL.iter().map(|own| own.as_str()).collect();
    let grammar: serde_json::Value =
        serde_json::from_str(include_str!("../../grammar/tree-sitter/src/grammar.json")).unwrap();
    let reserved = grammar["reserved"]["global"].as_array().unwrap();
    let reserved: Vec<&str> = reserved
        .iter()
        .map(|own| own["value"].as_str().unwrap())
        .collect();
    assert_eq!(reserved, keywords);
    // and again wherever a name must not be one of them
    let list = format!("(?:{})", keywords.join("|"));
    let textmate = include_str!("../../grammar/textmate/sweep.tmLanguage.json");
    let places = textmate
        .match_indices("(?:param|")
        .map(|(at, _)| &textmate[at..]);
    let places = places
        .filter(|own| !own.starts_with("(?:param|let|profile|sweep|curve|construction|surface)"));
    let places: Vec<_> = places.collect();
    assert!(places.len() > 4 && places.iter().all(|own| own.starts_with(&list)));
}
