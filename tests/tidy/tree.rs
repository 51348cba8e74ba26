//! The files of the project.

use std::fs;
use std::path::{Path, PathBuf};

use crate::source::Source;

/// The folder of `Cargo.toml`.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every file that git would track, relative to the root, with `/` between folders, sorted.
pub(crate) fn tracked() -> Vec<String> {
    let ignored = ignored(&fs::read_to_string(root().join(".gitignore")).unwrap_or_default());
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root().join(&folder)).expect("a readable folder") {
            let entry = entry.expect("a readable entry");
            let path = folder.join(entry.file_name());
            let name = path.to_string_lossy().replace('\\', "/");
            if name == ".git" || ignored.contains(&name) {
                continue;
            }
            if entry.file_type().expect("a file type").is_dir() {
                folders.push(path);
            } else {
                found.push(name);
            }
        }
    }
    found.sort();
    found
}

/// The entries of a `.gitignore` that name a file or folder at the root.
fn ignored(text: &str) -> Vec<String> {
    let rooted = text
        .lines()
        .filter_map(|line| line.trim().strip_prefix('/'));
    rooted
        .map(|name| name.trim_end_matches('/').to_owned())
        .collect()
}

/// The Rust files under the folders `src` and `tests`.
pub(crate) fn rust() -> Vec<Source> {
    read(|name| name.ends_with(".rs") && (name.starts_with("src/") || name.starts_with("tests/")))
}

/// The Rust files under `src`.
pub(crate) fn rust_of_the_crate() -> Vec<Source> {
    read(|name| name.ends_with(".rs") && name.starts_with("src/"))
}

/// The Rust files under `src` and the standard library.
pub(crate) fn cited() -> Vec<Source> {
    read(|name| {
        name.starts_with("src/") && name.ends_with(".rs")
            || name.starts_with("src/std/") && name.ends_with(".sweep")
    })
}

/// The text of the standard library.
pub(crate) fn standard_library() -> String {
    let files = read(|name| name.starts_with("src/std/") && name.ends_with(".sweep"));
    files.into_iter().map(|file| file.text).collect()
}

/// The tracked files whose name is wanted.
fn read(wanted: impl Fn(&str) -> bool) -> Vec<Source> {
    let names = tracked().into_iter().filter(|name| wanted(name));
    names
        .map(|name| {
            let text = fs::read_to_string(root().join(&name)).expect("a text file");
            Source::new(&name, &text)
        })
        .collect()
}

#[test]
fn the_tree_is_found() {
    let files = tracked();
    assert!(files.iter().any(|name| name == "Cargo.toml"));
    assert!(files.iter().any(|name| name == "tests/tidy/tree.rs"));
    assert!(
        !files
            .iter()
            .any(|name| name.starts_with("target/") || name.starts_with(".git/"))
    );
    assert!(!rust_of_the_crate().is_empty());
}

#[test]
fn ignored_entries_are_read() {
    assert_eq!(ignored("/target\n/out/\n*.bak\n"), ["target", "out"]);
}
