//! The example files and the compiler that runs on them.

#![allow(
    dead_code,
    clippy::unwrap_used,
    missing_docs,
    unreachable_pub,
    reason = "shared by several test files"
)]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The folder of the examples.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples")
}

/// Every file with the extension `.sweep` under a folder, sorted.
pub fn sweeps(folder: &Path) -> Vec<PathBuf> {
    let (mut found, mut folders) = (Vec::new(), vec![folder.to_path_buf()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|own| own == "sweep") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The path under the examples without extension, with `-` between folders.
pub fn name(path: &Path) -> String {
    let path = path.strip_prefix(folder()).unwrap().with_extension("");
    let parts = path.iter().map(|own| own.to_str().unwrap());
    parts.collect::<Vec<_>>().join("-")
}

/// Runs the compiler in a folder with a text on its standard input.
pub fn run(folder: &Path, arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_sweepc"))
        .args(arguments)
        .current_dir(folder)
        .env_remove("NO_COLOR")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A compiler that does not read its standard input may be gone already.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

/// Runs the compiler and returns what it prints; it must succeed in silence on standard error,
/// but for warnings where they are expected.
pub fn success(folder: &Path, arguments: &[&str], warns: bool) -> String {
    let output = run(folder, arguments, "");
    let errors = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {errors}");
    assert_eq!(!errors.is_empty(), warns, "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// Whether a character may stand in a name.
pub fn in_name(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}
