//! Every example compiles, and what comes out is what was accepted.
//!
//! The accepted reports and nets lie in `tests/snapshots/examples`. To review a change, run
//! `cargo insta test --review --test examples`, or without that tool
//! `INSTA_UPDATE=always cargo test --test examples` and then read `git diff tests/snapshots`.
//! A missing, changed or left-over snapshot fails the test whatever the environment says.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod example_files;
mod exchange;
mod nets;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use example_files::{folder, in_name, name, success, sweeps};
use exchange::{Exchange, bits};
use serde_json::Value;

const LIBRARY: &str = include_str!("../src/std/constructions.sweep");

/// A compiled example.
struct Example {
    path: PathBuf,
    name: String,
    text: String,
    /// The codes of the warnings that lines `#~ W1003` announce.
    announced: Vec<String>,
    output: tempfile::TempDir,
}

impl Example {
    fn all() -> Vec<Self> {
        let all: Vec<_> = sweeps(&folder()).into_iter().map(Self::of).collect();
        assert!(!all.is_empty());
        all
    }

    fn of(path: PathBuf) -> Self {
        let text = fs::read_to_string(&path).unwrap();
        let announced = text.lines().filter_map(|line| line.split_once("#~"));
        let announced: Vec<_> = announced
            .map(|(_, code)| code.trim().to_owned())
            .filter(|code| code.starts_with('W'))
            .collect();
        let output = tempfile::tempdir().unwrap();
        let target = output.path().to_str().unwrap();
        let (file, warns) = (path.to_str().unwrap(), !announced.is_empty());
        success(&folder(), &["compile", file, "-o", target], warns);
        Self {
            name: name(&path),
            path,
            text,
            announced,
            output,
        }
    }

    fn print(&self, arguments: &[&str]) -> String {
        let file = self.path.to_str().unwrap();
        let arguments = [arguments, &[file]].concat();
        success(&folder(), &arguments, !self.announced.is_empty())
    }

    /// The names and texts of the written files with an extension, sorted.
    fn written(&self, extension: &str) -> Vec<(String, String)> {
        let entries = fs::read_dir(self.output.path()).unwrap();
        let paths = entries.map(|entry| entry.unwrap().path());
        let own = paths.filter(|path| path.extension().is_some_and(|own| own == extension));
        let mut files: Vec<_> = own
            .map(|path| {
                let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
                (stem, fs::read_to_string(&path).unwrap())
            })
            .collect();
        files.sort();
        files
    }

    /// The surfaces: their file name, the exact net and the STEP file.
    fn surfaces(&self) -> Vec<(String, String, String)> {
        let mut nets = self.written("json");
        nets.retain(|(stem, _)| !stem.ends_with(".report"));
        let mut steps = self.written("step");
        steps.retain(|(stem, _)| *stem != self.stem());
        assert_eq!(nets.len(), steps.len(), "{}", self.name);
        assert!(!nets.is_empty(), "{}", self.name);
        let pairs = nets.into_iter().zip(steps);
        let same = pairs.inspect(|(net, step)| assert_eq!(net.0, step.0));
        same.map(|(net, step)| (net.0, net.1, step.1)).collect()
    }

    /// The STEP file of all surfaces, if two of them share an edge.
    fn together(&self) -> Option<String> {
        let mut steps = self.written("step").into_iter();
        steps.find_map(|(stem, text)| (stem == self.stem()).then_some(text))
    }

    fn stem(&self) -> &str {
        self.path.file_stem().unwrap().to_str().unwrap()
    }

    /// The snapshots by name: the report, and the net of every surface without its doubles.
    fn facts(&self) -> Vec<(String, String)> {
        let folder = match self.name.rsplit_once('-') {
            Some((folder, _)) => format!("{folder}-"),
            None => String::new(),
        };
        let mut facts = vec![(format!("{}.report", self.name), self.print(&["report"]))];
        for (stem, net, _) in self.surfaces() {
            let exact = net.find("  \"float\"").expect("doubles behind the net");
            facts.push((format!("{folder}{stem}.net"), net[..exact].to_owned()));
        }
        facts
    }
}

fn snapshots() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots/examples")
}

/// The accepted text of a snapshot: what stands behind its header.
fn accepted(name: &str) -> Option<String> {
    let text = fs::read_to_string(snapshots().join(format!("{name}.snap"))).ok()?;
    let body = text.strip_prefix("---\n")?.split_once("\n---\n")?.1;
    Some(body.trim_end().to_owned())
}

#[test]
fn reports_and_nets_are_the_accepted_ones() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(snapshots());
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let mut names = BTreeSet::new();
    for example in Example::all() {
        for (name, fact) in example.facts() {
            settings.bind(|| insta::assert_snapshot!(name.as_str(), fact));
            assert_eq!(
                accepted(&name).as_deref(),
                Some(fact.trim_end()),
                "{name} is not accepted"
            );
            names.insert(format!("{name}.snap"));
        }
    }
    let files = fs::read_dir(snapshots()).unwrap();
    let files: BTreeSet<_> = files
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    assert_eq!(files, names, "a snapshot is left over");
}

#[test]
fn findings_are_the_announced_ones() {
    for example in Example::all() {
        let file = example.path.to_str().unwrap();
        let arguments = ["check", "--format", "json", file];
        let findings = example_files::run(&folder(), &arguments, "").stdout;
        let findings = String::from_utf8(findings).unwrap();
        let codes: Vec<String> = findings
            .lines()
            .map(|line| serde_json::from_str::<Value>(line).unwrap())
            .map(|finding| finding["code"].as_str().unwrap().to_owned())
            .collect();
        assert_eq!(codes, example.announced, "{}", example.name);
    }
}

#[test]
fn every_example_states_what_it_expects() {
    for example in Example::all() {
        let report = example.print(&["report", "--format", "json"]);
        let report: Value = serde_json::from_str(&report).unwrap();
        let surfaces = report["surfaces"].as_array().unwrap();
        let expectations = surfaces
            .iter()
            .flat_map(|own| own["expectations"].as_array().unwrap());
        assert!(expectations.clone().count() >= 2, "{}", example.name);
        for expectation in expectations {
            assert_eq!(expectation["holds"], Value::Bool(true), "{}", example.name);
        }
        assert!(example.text.starts_with("# "), "{}", example.name);
    }
}

#[test]
fn step_files_hold_the_doubles_of_the_nets() {
    for example in Example::all() {
        for (stem, net, step) in example.surfaces() {
            let json: Value = serde_json::from_str(&net).unwrap();
            let patches = Exchange::read(&step).patches();
            if let [patch] = patches.as_slice()
                && bits(&json["float"]["weights"]) == patch.weights
            {
                assert_eq!(patch.points, bits(&json["float"]["points"]), "{stem}");
                continue;
            }
            let net = nets::read_json(&net);
            for patch in &patches {
                assert!(patch.is_part_of(&net), "{stem}");
            }
        }
    }
}

#[test]
fn surfaces_together_share_edges() {
    let mut count = 0;
    for example in Example::all() {
        let Some(step) = example.together() else {
            continue;
        };
        let together = Exchange::read(&step);
        let surfaces = example.surfaces();
        let alone = surfaces.iter().map(|(_, _, step)| Exchange::read(step));
        let alone: Vec<_> = alone.collect();
        let sum = |name: &str| alone.iter().map(|own| own.all(name).len()).sum::<usize>();
        let name = &example.name;
        let faces = together.all("ADVANCED_FACE").len();
        assert_eq!(faces, sum("ADVANCED_FACE"), "{name}");
        let edges = together.all("EDGE_CURVE").len();
        assert!(edges < sum("EDGE_CURVE"), "{name}");
        let patches = together.patches();
        for patch in alone.iter().flat_map(Exchange::patches) {
            let same = patches.iter().any(|own| own.points == patch.points);
            assert!(same, "{name}");
        }
        count += 1;
    }
    assert!(count >= 2);
}

/// The constructions of the standard library: name and text.
fn library() -> Vec<(&'static str, &'static str)> {
    let paragraphs = LIBRARY.split("\n\n").filter_map(|own| {
        let start = own.find("construction ")?;
        (start == 0 || own[..start].ends_with('\n')).then(|| &own[start..])
    });
    let named = paragraphs.map(|text| {
        let head = text.trim_start_matches("construction ");
        (head.split_once('(').unwrap().0, text)
    });
    named.collect()
}

/// A text in which an applied name is replaced.
fn rename(text: &str, from: &str, to: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(from) {
        let (before, behind) = (&rest[..at], &rest[at + from.len()..]);
        let whole = !before.ends_with(in_name) && behind.starts_with('(');
        out.push_str(before);
        out.push_str(if whole { to } else { from });
        rest = behind;
    }
    out + rest
}

/// The constructions that a text applies, by itself or through others.
fn applied(text: &str) -> BTreeSet<&'static str> {
    let mut found = BTreeSet::new();
    let mut texts = vec![text];
    while let Some(text) = texts.pop() {
        for (name, own) in library() {
            if rename(text, name, "") != text && found.insert(name) {
                texts.push(own);
            }
        }
    }
    found
}

/// The statements of a file, without its comments.
fn statements(text: &str) -> String {
    let lines = text
        .lines()
        .map(|line| line.split_once('#').map_or(line, |own| own.0));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn every_construction_has_its_example() {
    let examples = Example::all();
    let used: BTreeSet<_> = examples
        .iter()
        .flat_map(|own| applied(&statements(&own.text)))
        .collect();
    let all: BTreeSet<_> = library().into_iter().map(|own| own.0).collect();
    assert_eq!(all.len(), LIBRARY.matches("\nconstruction ").count());
    assert_eq!(used, all);
}

#[test]
fn a_construction_of_the_library_is_one_of_the_user() {
    let mut tried = 0;
    for example in Example::all() {
        let used = applied(&statements(&example.text));
        if used.is_empty() {
            continue;
        }
        let pasted = library().into_iter().filter(|own| used.contains(own.0));
        let pasted: Vec<_> = pasted.map(|own| own.1).collect();
        let mut text = format!("{}\n{}\n", example.text, pasted.join("\n"));
        for name in &used {
            text = rename(&text, name, &format!("my_{name}"));
        }
        let folder = tempfile::tempdir().unwrap();
        let file = example.path.file_name().unwrap().to_str().unwrap();
        for own in sweeps(example.path.parent().unwrap()) {
            fs::copy(&own, folder.path().join(own.file_name().unwrap())).unwrap();
        }
        fs::write(folder.path().join(file), text).unwrap();
        let arguments = ["report", "--format", "json", file];
        let mut report = success(folder.path(), &arguments, !example.announced.is_empty());
        for name in &used {
            report = rename(&report, &format!("my_{name}"), name);
        }
        let expected = example.print(&["report", "--format", "json"]);
        assert_eq!(report, expected, "{}", example.name);
        tried += 1;
    }
    assert!(tried > 0);
}
