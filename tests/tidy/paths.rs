//! No file says where on a machine it was written.

use std::fs;

use crate::{Finding, settle, tree};

/// Folders that exist on one machine and not on the next.
const FOLDERS: &[&str] = &["work", "tmp", "root", "home"];

/// Absolute paths into [`FOLDERS`].
fn paths(name: &str, text: &str) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        for folder in FOLDERS {
            let needle = format!("/{folder}/");
            for (at, _) in content.match_indices(&needle) {
                let before = content[..at].chars().next_back();
                // In the middle of a longer path it is nobody's root.
                let inside = before.is_some_and(|c| c.is_alphanumeric() || "._-}/)*".contains(c));
                if !inside {
                    findings.push(format!("{name}:{line}: the path `{needle}`"));
                }
            }
        }
    }
    findings
}

#[test]
fn no_file_knows_its_machine() {
    let files = tree::tracked().into_iter();
    let findings = files.flat_map(|name| {
        let bytes = fs::read(tree::root().join(&name)).expect("a readable file");
        paths(&name, &String::from_utf8_lossy(&bytes))
    });
    settle(findings.collect());
}

#[test]
fn a_path_of_a_machine_is_found() {
    let bad = ["work", "tmp", "root", "home"].map(|folder| format!("cd \"/{folder}/x\""));
    assert!(bad.iter().all(|text| paths("a", text).len() == 1));
    assert!(paths("a", "see src/work/x and https://example.org/home/x").is_empty());
}
