//! Rows about runs that do not end by themselves, and about two at once.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::files::{SOUND, folder, tree};
use crate::watched::sweepc;

/// So many surfaces that their files cannot be written in an instant.
const MANY: usize = 400;
/// The same for runs that come to their end.
const SOME: usize = 100;

fn surfaces(count: usize) -> String {
    let surfaces = (0..count).map(|index| format!("surface R{index} = (u, a v, u v)\n"));
    format!("param a = 1\n{}", surfaces.collect::<String>())
}

fn spawn(folder: &Path, arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_sweepc"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn send(signal: &str, child: &Child) {
    let line = format!("kill -{signal} {}", child.id());
    let status = Command::new("sh").args(["-c", &line]).status();
    assert!(status.unwrap().success());
}

/// Asks a run to end where it stands, however fast it writes.
fn end_at_once(signal: &str, child: &Child) {
    send("STOP", child);
    // longer than it takes to look for signals
    sleep(Duration::from_millis(100));
    send(signal, child);
    send("CONT", child);
}

/// How many temporary files there are; none where there is no folder.
fn partial(folder: &Path) -> usize {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let names = entries.map(|own| own.unwrap().file_name().into_string().unwrap());
    names.filter(|own| own.ends_with(".partial")).count()
}

/// Waits until the run has begun to write.
fn wait_for_writing(folder: &Path) {
    let start = Instant::now();
    while partial(folder) < 3 {
        assert!(
            start.elapsed() < Duration::from_secs(20),
            "nothing is written"
        );
        sleep(Duration::from_micros(200));
    }
}

#[test]
fn row_53_asked_to_end_while_working() {
    for signal in ["INT", "TERM"] {
        let folder = folder(&[("x.sweep", "surface R = (u, v, (u + v)^400)\n")]);
        let child = spawn(folder.path(), &["compile", "x.sweep", "-o", "out"]);
        sleep(Duration::from_millis(300));
        send(signal, &child);
        let start = Instant::now();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{signal}");
        assert!(start.elapsed() < Duration::from_secs(5));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}

/// Asks a run to end while it writes into a folder that it may have to make; whether it was cut
/// short. One that has come to give its files their names does so for all of them.
fn is_cut_short(signal: &str, output: &str) -> bool {
    let folder = folder(&[("x.sweep", &surfaces(MANY)), ("old/x-R7.json", "old")]);
    let before = tree(folder.path());
    let child = spawn(folder.path(), &["compile", "x.sweep", "-o", output]);
    let written = folder.path().join(output);
    wait_for_writing(&written);
    end_at_once(signal, &child);
    let ended = child.wait_with_output().unwrap();
    let after = tree(folder.path());
    if after == before {
        assert_eq!(ended.status.code(), Some(130), "{signal}");
        return true;
    }
    assert_eq!(partial(&written), 0);
    let files = fs::read_dir(&written).unwrap().count();
    assert_eq!(files, 2 * MANY + 1, "{:?}", after.keys());
    false
}

#[test]
fn row_53_asked_to_end_while_writing() {
    for (signal, output) in [("INT", "old"), ("TERM", "old"), ("TERM", "new")] {
        assert!((0..10).any(|_| is_cut_short(signal, output)), "{signal}");
    }
}

/// Everything in a folder after a run that must succeed.
fn compiled(folder: &Path, value: &str) -> BTreeMap<OsString, Option<Vec<u8>>> {
    let run = sweepc(folder, &["compile", "x.sweep", "-D", value], &[]);
    assert_eq!(run.status, 0, "{}", run.err);
    tree(folder)
}

/// Kills a run while it writes over the files of another; whether none had its new name by then.
fn is_killed_early() -> bool {
    let folder = folder(&[("x.sweep", &surfaces(SOME))]);
    let old = compiled(folder.path(), "a=1");
    let mut child = spawn(folder.path(), &["compile", "x.sweep", "-D", "a=2"]);
    wait_for_writing(folder.path());
    child.kill().unwrap();
    let _ = child.wait().unwrap();
    let after = tree(folder.path());
    let stale = partial(folder.path());
    // The next run does not mind what was not finished.
    let new = compiled(folder.path(), "a=2");
    assert_eq!(partial(folder.path()), stale);
    // Every file was whole all the time.
    for (name, bytes) in &old {
        let found = &after[name];
        assert!(found == bytes || *found == new[name], "{name:?}");
    }
    assert!(old.iter().any(|(name, bytes)| new[name] != *bytes));
    stale > 0 && old.iter().all(|(name, bytes)| after[name] == *bytes)
}

#[test]
fn row_54_killed_while_writing() {
    assert!((0..10).any(|_| is_killed_early()));
}

#[test]
fn row_55_two_runs_with_the_same_output() {
    let text = surfaces(SOME);
    let alone = |value: &str| {
        let folder = folder(&[("x.sweep", &text)]);
        compiled(folder.path(), value)
    };
    let (one, two) = (alone("a=1"), alone("a=2"));
    let together = folder(&[("x.sweep", &text)]);
    let runs =
        ["a=1", "a=2"].map(|value| spawn(together.path(), &["compile", "x.sweep", "-D", value]));
    for run in runs {
        assert!(run.wait_with_output().unwrap().status.success());
    }
    let written = tree(together.path());
    assert!(written.keys().eq(one.keys()));
    for (name, bytes) in &written {
        assert!(*bytes == one[name] || *bytes == two[name], "{name:?}");
    }
}

#[test]
fn row_57_a_reader_that_has_gone_away() {
    let folder = TempDir::new().unwrap();
    let bad = "let a = b\n".repeat(2_000);
    for (arguments, input, status) in [
        (&["report", "-"][..], SOUND, 0),
        (&["report", "-", "--format", "json"], SOUND, 0),
        (&["fmt", "-"], "let a=1\n", 0),
        (&["check", "-", "--format", "json"], bad.as_str(), 1),
    ] {
        let mut child = spawn(folder.path(), arguments);
        drop(child.stdout.take());
        child
            .stdin
            .take()
            .unwrap()
            .write_all(input.as_bytes())
            .unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(status), "{arguments:?}");
        assert_eq!(
            String::from_utf8(output.stderr).unwrap(),
            "",
            "{arguments:?}"
        );
    }
    // no standard output at all
    let mut shell = Command::new("sh");
    shell.args([
        "-c",
        "exec \"$0\" explain >&-",
        env!("CARGO_BIN_EXE_sweepc"),
    ]);
    let output = shell.stdin(Stdio::null()).output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}
