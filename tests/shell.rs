//! The command line as a good neighbour: several files, threads, how much is said, completions and
//! manual pages.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod example_files;

use std::collections::BTreeSet;
use std::fs;
use std::process::Output;

use example_files::{folder, run, sweeps};
use tempfile::TempDir;

const SOUND: &str = "param a = 1\nsurface R = (u, a v, u v)\n";
const UNKNOWN: &str = "surface R = (u, v, w)\n";
const SHELLS: &[&str] = &["bash", "elvish", "fish", "powershell", "zsh"];

fn files(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn status(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The commands that the main help lists, `help` apart.
fn commands() -> BTreeSet<String> {
    let help = out(&run(&folder(), &["--help"], ""));
    let list = help.split("Commands:\n").nth(1).unwrap();
    let list = list.split("\n\n").next().unwrap();
    let lines = list.lines().filter(|line| !line.starts_with("   "));
    let names = lines.map(|line| line.split_whitespace().next().unwrap().to_owned());
    names.filter(|name| name != "help").collect()
}

#[test]
fn an_error_in_one_file_does_not_hide_the_others() {
    let folder = files(&[
        ("a.sweep", UNKNOWN),
        ("b.sweep", SOUND),
        ("d.sweep", UNKNOWN),
    ]);
    let arguments = ["check", "a.sweep", "c.sweep", "b.sweep", "d.sweep"];
    let output = run(folder.path(), &arguments, "");
    assert_eq!(status(&output), 3);
    let said = err(&output);
    let places = [
        "--> a.sweep:1:20",
        "`c.sweep` cannot be read",
        "--> d.sweep:1:20",
    ];
    let found: Vec<usize> = places.map(|own| said.find(own).unwrap()).to_vec();
    assert!(found.is_sorted(), "{said}");
    assert!(
        said.ends_with("\nfor more: sweepc explain E0101 E0601\n"),
        "{said}"
    );

    // A parameter that only one file has is an error of use in the others.
    let output = run(
        folder.path(),
        &["check", "d.sweep", "b.sweep", "a.sweep", "-D", "a=2"],
        "",
    );
    assert_eq!(status(&output), 2);
    assert_eq!(
        err(&output),
        "sweepc: `a` is not a parameter of `d.sweep`; the file has none\n\
         sweepc: `a` is not a parameter of `a.sweep`; the file has none\n"
    );
    // What is wrong for all is said once.
    let output = run(
        folder.path(),
        &["check", "a.sweep", "b.sweep", "-D", "a"],
        "",
    );
    assert_eq!(status(&output), 2);
    assert_eq!(
        err(&output),
        "sweepc: `-D a` is not of the form NAME=VALUE\n"
    );
}

#[test]
fn any_number_of_threads_says_the_same() {
    let folder = folder();
    let examples = sweeps(&folder);
    let names = examples
        .iter()
        .map(|own| own.strip_prefix(&folder).unwrap().to_str().unwrap());
    let names: Vec<&str> = names.chain(["none.sweep"]).collect();
    assert!(names.len() > 20);
    for format in ["text", "json"] {
        // Without surfaces to prove, each file is quick and says something.
        let said = ["1", "8", "64"].map(|threads| {
            let options = ["check", "--surface", "No", "--format", format];
            let arguments = [&options, names.as_slice(), &["--threads", threads]].concat();
            run(&folder, &arguments, "")
        });
        let first = err(&said[0]);
        let lines = first.lines();
        let refused = lines.filter(|line| line.starts_with("sweepc: `No` is not a surface of `"));
        assert_eq!(refused.count(), names.len() - 1, "{first}");
        assert_eq!(said[0], said[1]);
        assert_eq!(said[0], said[2]);
    }
    assert_eq!(
        status(&run(&folder, &["check", "--threads", "0", names[0]], "")),
        2
    );
}

#[test]
fn standard_input_may_be_one_of_the_files_but_once() {
    let folder = files(&[("a.sweep", UNKNOWN)]);
    let output = run(folder.path(), &["check", "a.sweep", "-"], "let a = b\n");
    assert_eq!(status(&output), 1);
    let said = err(&output);
    assert!(said.find("--> a.sweep:1:20").unwrap() < said.find("--> <stdin>:1:9").unwrap());
    for command in ["check", "fmt"] {
        let output = run(folder.path(), &[command, "-", "-"], SOUND);
        assert_eq!(status(&output), 2);
        assert_eq!(
            err(&output),
            "sweepc: standard input can be read only once\n"
        );
    }
}

#[test]
fn standard_input_has_one_name() {
    let folder = files(&[]);
    for (arguments, status_of_it, text, message) in [
        (
            &["check", "-"][..],
            0,
            "",
            "warning[W1007]: `<stdin>` declares no surface",
        ),
        (
            &["report", "-"],
            1,
            "",
            "error[E0303]: nothing to build: `<stdin>` declares no surface",
        ),
        (
            &["check", "-", "-D", "b=1"],
            2,
            SOUND,
            "sweepc: `b` is not a parameter of `<stdin>`; there are: a",
        ),
    ] {
        let output = run(folder.path(), arguments, text);
        assert_eq!(status(&output), status_of_it);
        assert!(err(&output).starts_with(message), "{}", err(&output));
    }
}

#[test]
fn quiet_runs_tell_errors_only() {
    // κ = −1 for the clockwise unit circle: the surface folds, which is a warning
    let warned = "profile p(u) in xz = (2u, u)
sweep c(v) in xy = (2v / (1 + v^2), (1 - v^2) / (1 + v^2))
surface R = c(v) + x(u) n(v) + z(u) k\n";
    let both = format!("{warned}let b = zz\n");
    let folder = files(&[("a.sweep", warned), ("b.sweep", &both)]);
    let loud = run(folder.path(), &["check", "a.sweep"], "");
    assert!(err(&loud).contains("warning[W1011]"));
    for arguments in [
        &["check", "a.sweep", "-q"][..],
        &["compile", "a.sweep", "--quiet"],
    ] {
        let output = run(folder.path(), arguments, "");
        assert_eq!(
            (status(&output), out(&output), err(&output)),
            (0, String::new(), String::new())
        );
    }
    assert!(folder.path().join("a-R.step").exists());
    let quiet = err(&run(folder.path(), &["check", "b.sweep", "-q"], ""));
    assert!(
        quiet.starts_with("error[E0101]") && !quiet.contains("W1011"),
        "{quiet}"
    );
    assert!(!quiet.contains("for more"), "{quiet}");
    let json = run(
        folder.path(),
        &["check", "b.sweep", "-q", "--format", "json"],
        "",
    );
    assert_eq!(out(&json).lines().count(), 1);
    // What was asked for is no message.
    let report = out(&run(folder.path(), &["report", "a.sweep", "-q"], ""));
    assert!(report.starts_with("R   a.sweep"), "{report}");
}

#[test]
fn verbose_runs_tell_the_time_of_every_stage() {
    let folder = files(&[("a.sweep", SOUND)]);
    let quiet = run(folder.path(), &["report", "a.sweep"], "");
    for (arguments, last) in [
        (&["check", "a.sweep"][..], "expectations decided"),
        (&["report", "a.sweep"], "report made"),
        (&["compile", "a.sweep"], "files written"),
        (&["fmt", "a.sweep"], "laid out"),
    ] {
        let output = run(folder.path(), &[arguments, &["-v"]].concat(), "");
        assert_eq!(status(&output), 0);
        let said = err(&output);
        let lines: Vec<&str> = said.lines().collect();
        assert!(lines[0].ends_with("s  a.sweep: read and parsed"), "{said}");
        assert!(
            lines[lines.len() - 1].ends_with(&format!("s  a.sweep: {last}")),
            "{said}"
        );
        let timed = |line: &&str| line.starts_with("sweepc: ") && line.contains(" s  a.sweep: ");
        assert!(lines.iter().all(timed), "{said}");
    }
    let said = err(&run(folder.path(), &["check", "a.sweep", "-v"], ""));
    assert!(
        said.contains("a.sweep: `R` expanded and checked\n"),
        "{said}"
    );
    let verbose = run(folder.path(), &["report", "a.sweep", "-v"], "");
    assert_eq!(out(&verbose), out(&quiet));
    assert_eq!(
        status(&run(folder.path(), &["report", "a.sweep", "-v", "-q"], "")),
        2
    );
}

#[test]
fn completions_know_every_command() {
    let commands = commands();
    for expected in [
        "check",
        "report",
        "compile",
        "explain",
        "fmt",
        "completions",
        "man",
    ] {
        assert!(commands.contains(expected), "{commands:?}");
    }
    let scripts = SHELLS.iter().map(|shell| {
        let output = run(&folder(), &["completions", shell], "");
        assert_eq!(
            (status(&output), err(&output)),
            (0, String::new()),
            "{shell}"
        );
        out(&output)
    });
    let scripts: BTreeSet<String> = scripts.collect();
    assert_eq!(scripts.len(), SHELLS.len());
    for script in &scripts {
        for word in commands
            .iter()
            .map(String::as_str)
            .chain(["max-degree", "sweepc"])
        {
            assert!(script.contains(word), "{word} in\n{script}");
        }
    }
    assert_eq!(status(&run(&folder(), &["completions", "cmd"], "")), 2);
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = TempDir::new().unwrap();
    let output = run(folder.path(), &["man", "pages"], "");
    assert_eq!((status(&output), err(&output)), (0, String::new()));
    let written = fs::read_dir(folder.path().join("pages")).unwrap();
    let written: BTreeSet<String> = written
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let named = commands()
        .into_iter()
        .map(|name| format!("sweepc-{name}.1"));
    let named: BTreeSet<String> = named.chain(["sweepc.1".to_owned()]).collect();
    assert_eq!(written, named);
    for name in &named {
        let page = fs::read_to_string(folder.path().join("pages").join(name)).unwrap();
        assert!(
            page.contains(&format!(".TH {}", name.trim_end_matches(".1"))),
            "{page}"
        );
    }
    let main = fs::read_to_string(folder.path().join("pages/sweepc.1")).unwrap();
    for command in commands() {
        assert!(
            main.contains(&format!("sweepc\\-{command}(1)")),
            "{command} in\n{main}"
        );
    }
    // Nothing that runs twice differs, and a file in the way is told.
    let output = run(folder.path(), &["man", "pages/sweepc.1"], "");
    assert_eq!(status(&output), 3);
}

#[test]
fn the_readme_lists_every_limit() {
    let help = out(&run(&folder(), &["check", "--help"], ""));
    let limits = help.split("Limits:\n").nth(1).unwrap();
    let words = limits.split_whitespace();
    let flags: Vec<&str> = words.filter(|own| own.starts_with("--max-")).collect();
    assert!(
        flags.contains(&"--max-field-degree") && flags.len() >= 11,
        "{flags:?}"
    );
    let readme = include_str!("../README.md");
    for flag in flags {
        assert!(readme.contains(&format!("`{flag}`")), "{flag}");
    }
}
