//! Signals to a batch that is at work, limits, and what it leaves.

use crate::{compile, files, folder, names};

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

fn start(folder: &Path) -> Child {
    let arguments = "compile x.sweep --emit json --grid d=1/50000:1:1/50000 -o out";
    Command::new(env!("CARGO_BIN_EXE_sweepc"))
        .args(arguments.split(' '))
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

fn count(folder: &Path, is_counted: impl Fn(&str) -> bool) -> usize {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let names = entries.map(|own| own.unwrap().file_name().into_string().unwrap());
    names.filter(|own| is_counted(own)).count()
}

/// Waits until files of the first group have their names.
fn wait(folder: &Path) {
    let start = Instant::now();
    while count(folder, |own| own.ends_with("-R.json")) == 0 {
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "nothing is written"
        );
        sleep(Duration::from_millis(2));
    }
    sleep(Duration::from_millis(50));
}

fn every_net_is_whole(folder: &Path) {
    let mut whole = 0;
    for (name, bytes) in files(folder) {
        if name.ends_with("-R.json") {
            let net: Value = serde_json::from_slice(&bytes).unwrap();
            assert_eq!(net["degree"], serde_json::json!([1, 1]), "{name}");
            whole += 1;
        }
    }
    assert!(whole > 0);
}

#[test]
fn by_the_user() {
    for signal in ["INT", "TERM"] {
        let folder = folder(&[("x.sweep", "param d = 1\nsurface R = (d u, v, u v)\n")]);
        let mut child = start(folder.path());
        let out = folder.path().join("out");
        wait(&out);
        let line = format!("kill -{signal} {}", child.id());
        assert!(
            Command::new("sh")
                .args(["-c", &line])
                .status()
                .unwrap()
                .success()
        );
        assert_eq!(child.wait().unwrap().code(), Some(130));
        assert_eq!(
            count(&out, |own| !own.ends_with("-R.json")),
            0,
            "{:?}",
            names(&out)
        );
        // Whole groups.
        assert_eq!(count(&out, |own| own.ends_with("-R.json")) % 2_048, 0);
        every_net_is_whole(&out);
    }
}

#[test]
fn by_force() {
    let folder = folder(&[("x.sweep", "param d = 1\nsurface R = (d u, v, u v)\n")]);
    let mut child = start(folder.path());
    let out = folder.path().join("out");
    wait(&out);
    child.kill().unwrap();
    assert_eq!(child.wait().unwrap().code(), None);
    every_net_is_whole(&out);
    assert_eq!(count(&out, |own| own.contains("batch")), 0);
}

/// Time runs out in the middle.
#[test]
fn by_a_limit() {
    let folder = folder(&[("x.sweep", "param d = 1\nsurface R = (d u, v, (u + v)^9)\n")]);
    let arguments = "x.sweep --emit json --grid d=1/90000:1:1/90000 -o out --max-seconds 1";
    let arguments: Vec<&str> = arguments.split(' ').collect();
    let (_, err) = compile(folder.path(), &arguments, 4);
    assert!(
        err.starts_with("error[E0508]: this run takes more than 1 second\n"),
        "{err}"
    );
    let out = folder.path().join("out");
    assert_eq!(count(&out, |own| !own.ends_with("-R.json")), 0);
}
