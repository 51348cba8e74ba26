//! `sweepc fmt`: the same tree, the same comments, the same text again.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test that cannot go on has failed"
)]

mod command;
mod layout;
mod mutations;

use std::path::{Path, PathBuf};

use sweepc::diag::{Diagnostics, FileId, Limits};
use sweepc::pipeline::standard_library;
use sweepc::sema::Names;
use sweepc::syntax::ast::Document;
use sweepc::syntax::{Formatter, Spelling, parse};

pub(crate) fn parsed(text: &str) -> Document {
    let mut findings = Diagnostics::default();
    let document = parse(FileId(0), text, &Limits::default(), &mut findings);
    assert!(!findings.has_errors(), "{text}\n{findings:?}");
    document
}

/// The canonical text, where the names of the text itself and of the library are known.
pub(crate) fn spelled(text: &str, spelling: Spelling) -> String {
    let (limits, library) = (Limits::default(), standard_library());
    let documents = [parsed(text)];
    let names = Names::of(&documents, &library);
    let formatter = Formatter {
        spelling,
        reading: &|name, declaration| names.reading(name, declaration),
        limits: &limits,
    };
    let formatted = formatter.format(&documents[0], text);
    formatted.unwrap_or_else(|| panic!("not formatted: {text:?}"))
}

pub(crate) fn formatted(text: &str) -> String {
    spelled(text, Spelling::AsWritten)
}

/// The files of the project in the language.
pub(crate) fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut found, mut folders) = (
        Vec::new(),
        vec![root.join("examples"), root.join("src/std")],
    );
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|own| own == "sweep") {
                found.push(path);
            }
        }
    }
    found.sort();
    assert!(found.len() > 15);
    found
}
