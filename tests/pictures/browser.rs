//! The look of pages and drawings is tested in Chromium, by `tests/pictures/run`; whoever runs
//! only `cargo test` is told so.

use std::io::Write;
use std::process::{Command, Stdio};

fn answers(program: &str) -> bool {
    let mut command = Command::new(program);
    let quiet = command
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    quiet.status().is_ok_and(|own| own.success())
}

#[test]
fn the_browser_is_asked_elsewhere() {
    let script =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/pictures/run"));
    let script = script.unwrap();
    let names = ["chromium", "chromium-browser", "google-chrome"];
    assert!(names.iter().all(|own| script.contains(own)));
    if !answers("node") || !names.iter().any(|own| answers(own)) {
        // not `eprintln!`, which a test that passes keeps to itself
        let told = "\nNOT TESTED: node or Chromium is missing, so no picture was looked at.\n\n";
        std::io::stderr().write_all(told.as_bytes()).unwrap();
    }
}
