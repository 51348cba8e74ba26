//! Drawings and pages as files: what they hold, and what a drawing hides. How they look in a
//! browser is the affair of `run` beside this file.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_arithmetic,
    missing_docs,
    reason = "tests state facts"
)]

#[path = "../example_files/mod.rs"]
mod example_files;
#[path = "../nets/mod.rs"]
mod nets;

mod browser;
mod drawings;
mod pages;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use sweepc::export::{ALL, Context};
use sweepc::net::{ControlNet, Model, Part};
use tempfile::TempDir;

/// The files that a compilation of an example writes, by name.
fn compiled(example: &str, arguments: &[&str]) -> BTreeMap<String, String> {
    let folder = TempDir::new().unwrap();
    let file = example_files::folder().join(example);
    let fixed = ["compile", file.to_str().unwrap(), "-q", "-o", "."];
    let output = example_files::run(folder.path(), &[&fixed, arguments].concat(), "");
    assert!(output.status.success(), "{example}: {output:?}");
    texts(folder.path())
}

fn texts(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    entries
        .map(|own| {
            let text = fs::read_to_string(own.path()).unwrap();
            (own.file_name().into_string().unwrap(), text)
        })
        .collect()
}

/// The model of some nets, each with a name.
fn model(nets: &[(&str, ControlNet)]) -> Model {
    let parts = nets.iter();
    let parts = parts.map(|(name, net)| Part::of_net(name, net.clone()));
    Model::new(parts.collect())
}

fn written(format: &str, model: &Model, view: &str) -> String {
    let exporter = ALL.iter().find(|own| own.name == format).unwrap();
    let mut context = Context::whole("file");
    context.view = view.parse().unwrap();
    let exported = (exporter.write)(model, &context).unwrap();
    String::from_utf8(exported.bytes).unwrap()
}

/// Nets of every kind, several spans, poles at corners, folds and crossings among them.
fn odd_nets() -> Vec<(&'static str, ControlNet)> {
    vec![
        ("sphere", nets::sphere()),
        ("torus", nets::torus()),
        ("cone", nets::patch(&nets::cone())),
        ("negative", nets::patch(&nets::negative_weight())),
        ("bag", nets::patch(&nets::bag())),
        ("folded", nets::folded()),
        ("moebius", nets::moebius()),
        ("teardrop", nets::teardrop()),
        ("a<b & \"c\"", nets::patch(&nets::polynomial())),
    ]
}
