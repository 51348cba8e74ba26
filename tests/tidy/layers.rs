//! Which floor may import which.

use crate::source::{Source, words};
use crate::{Finding, hold, tree};

/// Each floor with the floors it may import, itself apart.
const FLOORS: &[(&str, &[&str])] = &[
    ("diag", &[]),
    ("number", &[]),
    ("poly", &["number"]),
    ("curve", &["number", "poly", "diag"]),
    ("sweep", &["curve", "number", "poly", "diag"]),
    ("check", &["sweep", "curve", "poly", "number", "diag"]),
    ("net", &["check", "sweep", "poly", "number"]),
    (
        "report",
        &["check", "sweep", "curve", "poly", "number", "diag"],
    ),
    (
        "export",
        &["net", "report", "check", "sweep", "number", "poly", "diag"],
    ),
    ("syntax", &["diag"]),
    ("sema", &["syntax", "sweep", "curve", "number", "diag"]),
    (
        "pipeline",
        &[
            "sema", "syntax", "export", "report", "net", "check", "sweep", "curve", "poly",
            "number", "diag",
        ],
    ),
    (
        "cli",
        &[
            "pipeline", "diag", "syntax", "sema", "report", "export", "number",
        ],
    ),
    (
        "lsp",
        &[
            "pipeline", "diag", "syntax", "sema", "report", "export", "number",
        ],
    ),
];

/// The floor a file stands on: its folder in `src`, or its own name at the top.
fn floor(name: &str) -> Option<&str> {
    let inside = name.strip_prefix("src/")?;
    match inside.split_once('/') {
        Some((folder, _)) => Some(folder),
        None => inside
            .strip_suffix(".rs")
            .filter(|stem| !["lib", "main"].contains(stem)),
    }
}

/// Imports that the table of floors does not allow.
fn layers(file: &Source) -> Vec<Finding> {
    let Some(floor) = floor(&file.name) else {
        return Vec::new();
    };
    let Some((_, allowed)) = FLOORS.iter().find(|(name, _)| *name == floor) else {
        return vec![format!("{}: `{floor}` is not a floor", file.at(1))];
    };
    let imports = imports(&file.code).into_iter().chain(escapes(file));
    let wrong =
        imports.filter(|(_, target)| target != floor && !allowed.contains(&target.as_str()));
    wrong
        .map(|(line, target)| {
            let known = FLOORS.iter().any(|(name, _)| *name == target);
            let reason = if known {
                "above it or beside it"
            } else {
                "not a floor"
            };
            format!(
                "{}: `{floor}` names `crate::{target}`, {reason}",
                file.at(line)
            )
        })
        .collect()
}

/// What follows each `crate::`, with its line; a group in braces counts entry by entry.
fn imports(code: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for word in words(code).into_iter().filter(|word| word.text == "crate") {
        let Some(path) = code[word.start + word.text.len()..]
            .trim_start()
            .strip_prefix("::")
        else {
            continue;
        };
        for entry in entries(path.trim_start()) {
            found.extend(
                words(&entry)
                    .first()
                    .map(|first| (word.line, first.text.to_owned())),
            );
        }
    }
    found
}

/// The entries of a group in braces, or the path itself.
fn entries(path: &str) -> Vec<String> {
    let Some(group) = path.strip_prefix('{') else {
        return vec![path.to_owned()];
    };
    let (mut depth, mut entries) = (0_usize, vec![String::new()]);
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => entries.push(String::new()),
            c => entries.last_mut().expect("never empty").push(c),
        }
    }
    entries
}

/// Chains of `super` that leave the floor, with what they name there.
fn escapes(file: &Source) -> Vec<(usize, String)> {
    let folders = file.name.matches('/').count();
    let named = usize::from(!file.name.ends_with("/mod.rs"));
    let (words, mut found) = (file.words(), Vec::new());
    let mut at = 0;
    while at < words.len() {
        let chain = words[at..]
            .iter()
            .take_while(|word| word.text == "super")
            .count();
        if chain > 0 && chain >= folders - 1 + named + usize::from(nested(file, words[at].start)) {
            let target = words.get(at + chain).map_or("super", |word| word.text);
            found.push((words[at].line, target.to_owned()));
        }
        at += chain.max(1);
    }
    found
}

/// Whether a module is written out before an offset, so that what follows is one step deeper.
fn nested(file: &Source, offset: usize) -> bool {
    let words = words(&file.code[..offset]);
    words.windows(2).any(|pair| {
        let after = &file.code[pair[1].start + pair[1].text.len()..];
        pair[0].text == "mod" && after.trim_start().starts_with('{')
    })
}

#[test]
fn the_floors_import_downwards() {
    hold(&tree::rust_of_the_crate(), layers);
}

#[test]
fn an_import_upwards_is_found() {
    let found = |name: &str, text: &str| layers(&Source::new(name, text)).len();
    assert_eq!(
        found(
            "src/poly/uni.rs",
            "use crate::number::Field;\nuse crate::curve::Curve;"
        ),
        1
    );
    assert_eq!(
        found(
            "src/number/field.rs",
            "fn f() { crate::diag::Code::parse() }"
        ),
        1
    );
    assert_eq!(
        found(
            "src/curve/mod.rs",
            "use crate::{number::{Real, Field}, sweep::Form};"
        ),
        1
    );
    assert_eq!(
        found(
            "src/curve/kinds/ph.rs",
            "use super::super::super::sema::Program;"
        ),
        1
    );
    assert_eq!(found("src/net/mod.rs", "use super::export::Double;"), 1);
    assert_eq!(
        found("src/poly/uni.rs", "use crate::UniPoly;"),
        1,
        "a root re-export"
    );
    assert_eq!(
        found("src/geometry/mod.rs", ""),
        1,
        "a floor that is not on the plan"
    );
    assert_eq!(found("src/pipeline.rs", "use crate::cli::run;"), 1);
}

#[test]
fn an_import_downwards_is_allowed() {
    let found = |name: &str, text: &str| layers(&Source::new(name, text));
    assert!(
        found(
            "src/poly/uni.rs",
            "// crate::curve\nuse crate::number::Field;"
        )
        .is_empty()
    );
    assert!(found("src/curve/kinds/ph.rs", "use super::super::Curve;").is_empty());
    assert!(
        found(
            "src/poly/uni.rs",
            "mod tests { use super::super::UniPoly; }"
        )
        .is_empty()
    );
    assert!(found("src/lib.rs", "pub use crate::cli::run;").is_empty());
}
