//! What the README shows is what happens.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests state facts")]

mod example_files;

use std::path::Path;

const README: &str = include_str!("../README.md");

/// The fenced blocks of a language.
fn blocks(language: &str) -> Vec<String> {
    let fence = format!("```{language}\n");
    let starts = README.split(&fence).skip(1);
    starts
        .map(|rest| rest.split_once("```").unwrap().0.to_owned())
        .collect()
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn every_sweep_compiles_without_a_finding() {
    let blocks = blocks("sweep");
    assert_eq!(blocks.len(), 3);
    for text in blocks {
        let output = example_files::run(root(), &["check", "-"], &text);
        let findings = String::from_utf8(output.stderr).unwrap();
        assert!(
            output.status.success() && findings.is_empty(),
            "{text}\n{findings}"
        );
        let output = example_files::run(root(), &["fmt", "--check", "-"], &text);
        let change = String::from_utf8(output.stdout).unwrap();
        assert_eq!(change, "", "not in the canonical layout");
    }
}

#[test]
fn the_report_is_that_of_the_example() {
    let file = "examples/paper/example_2.sweep";
    let output = example_files::run(root(), &["report", file], "");
    let report = String::from_utf8(output.stdout).unwrap();
    assert_eq!(blocks("text")[0], report);
}

#[test]
fn the_message_is_that_of_a_parabola() {
    let text = "sweep c(v) in xy = (v, v^2)\nsurface R = c(v) + u n(v)\n";
    let output = example_files::run(root(), &["check", "-"], text);
    let findings = String::from_utf8(output.stderr).unwrap();
    for line in blocks("text")[1].lines() {
        assert!(findings.contains(line), "{line}\n{findings}");
    }
}

#[test]
fn its_links_lead_somewhere() {
    let targets = README
        .split("](")
        .skip(1)
        .map(|rest| rest.split_once(')').unwrap().0);
    for target in targets {
        assert!(root().join(target).exists(), "{target}");
    }
}
