//! A citation `[key, eq. 17]` in a comment names a folder of `seeds/`.

use crate::source::Source;
use crate::{Finding, hold, tree};

/// What may follow the key; anything else in brackets is not a citation.
const PLACES: &[&str] = &[
    "eq.", "eqs.", "sec.", "§", "thm.", "lemma", "prop.", "cor.", "def.", "alg.", "table", "fig.",
    "ex.", "ch.", "p.", "pp.",
];

/// Citations whose key is not among the given ones.
fn citations(file: &Source, keys: &[String]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (line, text) in (1..).zip(file.comments.lines()) {
        for (at, _) in text.match_indices('[') {
            let Some((key, place)) = text[at + 1..].split_once(',') else {
                continue;
            };
            let cited = PLACES
                .iter()
                .any(|word| place.trim_start().starts_with(word));
            let named = !key.is_empty() && !key.contains([' ', '[', ']', '(', ')']);
            if cited && named && !keys.iter().any(|known| known == key) {
                findings.push(format!("{}: no folder seeds/{key}", file.at(line)));
            }
        }
    }
    findings
}

/// The folders of `seeds/` that have a README.
fn keys() -> Vec<String> {
    let files = tree::tracked();
    let readmes = files
        .iter()
        .filter_map(|name| name.strip_prefix("seeds/")?.strip_suffix("/README.md"));
    readmes.map(str::to_owned).collect()
}

#[test]
fn citations_resolve() {
    let keys = keys();
    assert!(keys.iter().any(|key| key == "farouki-nittler"));
    hold(&tree::cited(), |file| citations(file, &keys));
}

#[test]
fn a_dead_citation_is_found() {
    let keys = ["farouki-nittler".to_owned()];
    let found = |name: &str, text: &str| citations(&Source::new(name, text), &keys).len();
    assert_eq!(found("src/a.rs", "/// κ = …   [nobody-1900, eq. 5]"), 1);
    assert_eq!(
        found("src/std/a.sweep", "# The sweep.  [nobody-1900, sec. 2]"),
        1
    );
    assert_eq!(found("src/a.rs", "/// κ = …   [farouki-nittler, eq. 5]"), 0);
    assert_eq!(found("src/a.rs", "/// on [a, b] let x = [nobody, eq]"), 0);
}
