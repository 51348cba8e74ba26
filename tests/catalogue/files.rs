//! Rows about files: imports, names, folders, and disks that take no more.

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use crate::watched::{Run, command, finish, sweepc};

pub(crate) const SOUND: &str = "param a = 1\nsurface R = (u, a v, u v)\n";
const COMPILE: &[&str] = &["compile", "x.sweep"];

/// A folder with files in it.
pub(crate) fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// Every file under a folder with its bytes; a folder has none.
pub(crate) fn tree(folder: &Path) -> BTreeMap<OsString, Option<Vec<u8>>> {
    let mut tree = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(folder).unwrap().as_os_str().to_owned();
        if path.is_dir() {
            for (inner, bytes) in self::tree(&path) {
                tree.insert(Path::new(&name).join(inner).into_os_string(), bytes);
            }
            tree.insert(name, None);
        } else {
            tree.insert(name, fs::read(path).ok());
        }
    }
    tree
}

/// The run ends with a status and codes, says something, and leaves the folder as it is.
fn changes_nothing(folder: &Path, run: impl FnOnce() -> Run, status: i32, says: &[&str]) {
    let before = tree(folder);
    let run = run();
    assert_eq!(run.status, status, "{}", run.err);
    for part in says {
        assert!(run.err.contains(part), "no `{part}` in\n{}", run.err);
    }
    assert!(before == tree(folder), "{:?}", tree(folder).keys());
}

#[test]
fn row_44_imports_that_cannot_be_read() {
    for (import, status, says) in [
        (
            "no.sweep",
            3,
            &[
                "error[E0601]",
                "x.sweep:1:8",
                "looked for `parts/no.sweep` in the project",
            ][..],
        ),
        (".", 3, &["error[E0601]: `.` is not a file"]),
        ("../parts", 3, &["error[E0601]: `../parts` is not a file"]),
        (
            "null",
            1,
            &["error[E0603]: `null` lies outside the project folder"],
        ),
        ("/dev/null", 1, &["error[E0603]"]),
    ] {
        let text = format!("import \"{import}\"\n");
        let folder = folder(&[
            ("main.sweep", "import \"parts/x.sweep\"\n"),
            ("parts/x.sweep", &text),
        ]);
        std::os::unix::fs::symlink("/dev/null", folder.path().join("parts/null")).unwrap();
        let run = || sweepc(folder.path(), &["check", "main.sweep"], &[]);
        changes_nothing(folder.path(), run, status, says);
    }
}

#[test]
fn row_45_imports_in_circles() {
    let folder = folder(&[
        ("self.sweep", "import \"self.sweep\"\n"),
        ("a.sweep", "import \"b.sweep\"\n"),
        ("b.sweep", "import \"c.sweep\"\n"),
        ("c.sweep", "import \"a.sweep\"\n"),
        ("l.sweep", "import \"loop.sweep\"\n"),
    ]);
    std::os::unix::fs::symlink("loop.sweep", folder.path().join("loop.sweep")).unwrap();
    for (file, status, says) in [
        (
            "self.sweep",
            1,
            &["error[E0604]", "self.sweep → self.sweep\n"][..],
        ),
        (
            "a.sweep",
            1,
            &["error[E0604]", "a.sweep → b.sweep → c.sweep → a.sweep\n"],
        ),
        ("l.sweep", 3, &["error[E0601]: `loop.sweep` cannot be read"]),
        (
            "loop.sweep",
            3,
            &["error[E0601]: `loop.sweep` cannot be read"],
        ),
    ] {
        let run = || sweepc(folder.path(), &["check", file], &[]);
        changes_nothing(folder.path(), run, status, says);
    }
}

#[test]
fn row_46_imports_outside_the_project() {
    let outer = folder(&[("secret.sweep", "let a = 2\n"), ("in/deep/y.sweep", "")]);
    let absolute = outer.path().join("secret.sweep");
    let absolute = absolute.to_str().unwrap();
    for import in [
        "../secret.sweep",
        "deep/../../secret.sweep",
        absolute,
        "link.sweep",
    ] {
        let inner = outer.path().join("in");
        fs::write(
            inner.join("x.sweep"),
            format!("import \"{import}\"\n{SOUND}"),
        )
        .unwrap();
        let _ = std::os::unix::fs::symlink("../secret.sweep", inner.join("link.sweep"));
        let run = || sweepc(&inner, &["check", "x.sweep"], &[]);
        changes_nothing(
            outer.path(),
            run,
            1,
            &["error[E0603]", "outside the project folder"],
        );
    }
}

#[test]
fn row_50_folders_that_take_no_files() {
    let missing = folder(&[("x.sweep", SOUND)]);
    let into = |folder: &'static str| ["compile", "x.sweep", "-o", folder];
    let run = || sweepc(missing.path(), &into("no/such"), &[]);
    changes_nothing(
        missing.path(),
        run,
        3,
        &["error[E0602]: `no/such` cannot be written"],
    );
    let run = || sweepc(missing.path(), &into("x.sweep"), &[]);
    changes_nothing(
        missing.path(),
        run,
        3,
        &["error[E0602]: `x.sweep` is a file"],
    );

    // One output is a folder: the others are not written either.
    let taken = folder(&[
        ("x.sweep", SOUND),
        ("x-R.step/old", "old"),
        ("x-R.json", "old"),
    ]);
    let run = || sweepc(taken.path(), COMPILE, &[]);
    changes_nothing(
        taken.path(),
        run,
        3,
        &["error[E0602]: `x-R.step` cannot be written"],
    );
}

/// A folder in which even the superuser cannot make files.
#[cfg(target_os = "linux")]
#[test]
fn row_50_a_folder_that_is_read_only() {
    let folder = folder(&[("x.sweep", SOUND)]);
    let run = || sweepc(folder.path(), &["compile", "x.sweep", "-o", "/proc"], &[]);
    let says = ["error[E0602]: `/proc/x.report.json` cannot be written: "];
    changes_nothing(folder.path(), run, 3, &says);
    let run = sweepc(folder.path(), &["compile", "x.sweep", "-o", "/proc"], &[]);
    assert!(!run.err.contains(".partial"), "{}", run.err);
}

#[test]
fn row_51_an_output_that_is_an_input() {
    let main = format!("import \"x-R.json\"\n{SOUND}");
    let folder = folder(&[("x.sweep", main.as_str()), ("x-R.json", "let b = 1\n")]);
    let run = || sweepc(folder.path(), COMPILE, &[]);
    changes_nothing(
        folder.path(),
        run,
        3,
        &["error[E0602]: `x-R.json` is an input of this"],
    );
    // also under another name
    fs::rename(
        folder.path().join("x-R.json"),
        folder.path().join("b.sweep"),
    )
    .unwrap();
    std::os::unix::fs::symlink("b.sweep", folder.path().join("x-R.json")).unwrap();
    let run = || sweepc(folder.path(), COMPILE, &[]);
    changes_nothing(
        folder.path(),
        run,
        3,
        &["error[E0602]: `x-R.json` is an input of this"],
    );
}

/// The compiler in a folder, with files of no more than 512 or 1024 bytes.
fn with_small_files(folder: &Path, arguments: &[&str]) -> Run {
    let mut command = Command::new("sh");
    let limited = r#"ulimit -f 1 && exec "$0" "$@""#;
    command.args(["-c", limited, env!("CARGO_BIN_EXE_sweepc")]);
    command.args(arguments).current_dir(folder);
    finish(command)
}

#[test]
fn row_52_a_full_disk() {
    // The net of this surface takes more than a kilobyte.
    let large = "surface R = (u, v, u^5 v^5)\n";
    let folder = folder(&[
        ("x.sweep", large),
        ("x-R.json", "old"),
        ("kept/x-R.step", "old"),
    ]);
    for arguments in [
        COMPILE,
        &["compile", "x.sweep", "-o", "new"],
        &["compile", "x.sweep", "-o", "kept"],
    ] {
        let run = || with_small_files(folder.path(), arguments);
        changes_nothing(
            folder.path(),
            run,
            3,
            &["error[E0602]", "cannot be written: "],
        );
    }
    let long = format!("let a=1{}\n", "+1".repeat(2_000));
    fs::write(folder.path().join("long.sweep"), long).unwrap();
    let run = || with_small_files(folder.path(), &["fmt", "long.sweep"]);
    changes_nothing(
        folder.path(),
        run,
        3,
        &["error[E0602]: `long.sweep` cannot be written: "],
    );
}

#[cfg(target_os = "linux")]
#[test]
fn row_52_a_standard_output_that_is_full() {
    let folder = folder(&[("x.sweep", SOUND), ("bad.sweep", "let a = b\n")]);
    for (arguments, status) in [
        ("report x.sweep", 3),
        ("explain", 3),
        ("check --format json bad.sweep", 3),
        ("completions bash", 3),
        ("--help", 3),
        ("check x.sweep", 0),
    ] {
        let mut shell = Command::new("sh");
        let line = format!("exec \"$0\" {arguments} > /dev/full");
        shell.args(["-c", &line, env!("CARGO_BIN_EXE_sweepc")]);
        shell.current_dir(folder.path());
        assert_eq!(finish(shell).status, status, "{arguments}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn row_63_names_that_are_not_text() {
    let name = OsStr::from_bytes(b"a\xff.sweep");
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), SOUND).unwrap();
    let run = |verb: &str| {
        let mut command = command(folder.path());
        command.arg(verb).arg(name);
        finish(command)
    };
    assert_eq!(run("compile").status, 0);
    for written in [&b"a\xff-R.step"[..], b"a\xff-R.json", b"a\xff.report.json"] {
        assert!(folder.path().join(OsStr::from_bytes(written)).exists());
    }
    assert!(run("report").out.starts_with("R   a\u{fffd}.sweep   "));
    fs::write(folder.path().join(name), "let a=b\n").unwrap();
    assert!(run("check").err.contains("--> a\u{fffd}.sweep:1:7"));
    assert_eq!(run("fmt").status, 0);
    assert_eq!(fs::read(folder.path().join(name)).unwrap(), b"let a = b\n");
}

#[test]
fn row_64_names_in_a_step_string() {
    for (stem, written) in [
        ("it's", "it''s"),
        ("a\nb", r"a\X2\000A\X0\b"),
        ("bézier", r"b\X2\00E9\X0\zier"),
        ("back\\slash", r"back\\slash"),
    ] {
        let name = format!("{stem}.sweep");
        let folder = folder(&[(name.as_str(), SOUND)]);
        let run = sweepc(folder.path(), &["compile", &name, "--emit", "step"], &[]);
        assert_eq!(run.status, 0, "{}", run.err);
        let step = fs::read(folder.path().join(format!("{stem}-R.step"))).unwrap();
        let step = String::from_utf8(step).unwrap();
        assert!(
            step.is_ascii() && step.contains(written),
            "{written} in\n{step}"
        );
    }
}
