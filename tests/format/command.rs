//! The command: files, streams, exit status.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

use crate::files;

const UGLY: &str = "let  a=2\nsurface R=(u,v,a (u))\n";
const PRETTY: &str = "let a = 2\nsurface R = (u, v, a * (u))\n";

fn run(folder: &Path, arguments: &[&str], input: &str) -> (i32, String, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_sweepc"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A compiler that does not read its standard input may be gone already.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let Output {
        status,
        stdout,
        stderr,
    } = child.wait_with_output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn read(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).unwrap()
}

#[test]
fn files_are_formatted_in_place() {
    let folder = folder(&[("a.sweep", UGLY), ("b.sweep", PRETTY)]);
    let (status, out, err) = run(folder.path(), &["fmt", "a.sweep", "b.sweep"], "");
    assert_eq!((status, out.as_str(), err.as_str()), (0, "", ""));
    assert_eq!(read(&folder, "a.sweep"), PRETTY);
    assert_eq!(read(&folder, "b.sweep"), PRETTY);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn check_lists_what_would_change_and_writes_nothing() {
    let folder = folder(&[("a.sweep", UGLY), ("b.sweep", PRETTY)]);
    let (status, out, _) = run(folder.path(), &["fmt", "--check", "b.sweep"], "");
    assert_eq!((status, out.as_str()), (0, ""));
    let (status, out, err) = run(folder.path(), &["fmt", "--check", "a.sweep", "b.sweep"], "");
    assert_eq!((status, err.as_str()), (1, ""));
    let expected = "a.sweep\n@@ -1,2 +1,2 @@\n-let  a=2\n-surface R=(u,v,a (u))\n\
        +let a = 2\n+surface R = (u, v, a * (u))\n";
    assert_eq!(out, expected);
    assert_eq!(read(&folder, "a.sweep"), UGLY);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let folder = folder(&[("b.sweep", "let a = 2\n")]);
    let (status, out, _) = run(folder.path(), &["fmt", "-"], UGLY);
    assert_eq!((status, out.as_str()), (0, PRETTY));
    let imported = "import \"b.sweep\"\nlet c(u) = a (u)\n";
    let (status, out, _) = run(folder.path(), &["fmt", "-"], imported);
    assert_eq!(
        (status, out.as_str()),
        (0, "import \"b.sweep\"\nlet c(u) = a * (u)\n")
    );
    // what an import means that cannot be read is unknown
    let missing = imported.replace("b.sweep", "c.sweep");
    let (status, out, err) = run(folder.path(), &["fmt", "-"], &missing);
    assert_eq!(
        (status, out.as_str(), err.as_str()),
        (0, missing.as_str(), "")
    );
    let (status, out, _) = run(folder.path(), &["fmt", "--check", "-"], UGLY);
    assert!(status == 1 && out.starts_with("<stdin>\n"), "{out}");
}

#[test]
fn what_cannot_be_formatted_stays_as_it_is() {
    let broken = "let  a = (2\n";
    let folder = folder(&[("a.sweep", UGLY), ("x.sweep", broken)]);
    let (status, out, err) = run(folder.path(), &["fmt", "x.sweep", "a.sweep"], "");
    assert_eq!((status, out.as_str()), (1, ""));
    assert!(err.contains("E0005"), "{err}");
    assert_eq!(read(&folder, "x.sweep"), broken);
    assert_eq!(read(&folder, "a.sweep"), PRETTY);
    for (arguments, expected) in [
        (&["fmt", "missing.sweep"][..], 3),
        (&["fmt"], 2),
        (&["fmt", "--ascii", "--unicode", "a.sweep"], 2),
        (&["fmt", "--max-source", "3", "a.sweep"], 4),
    ] {
        assert_eq!(
            run(folder.path(), arguments, "").0,
            expected,
            "{arguments:?}"
        );
    }
}

#[test]
fn errors_of_names_do_not_matter() {
    let folder = folder(&[]);
    let (status, out, err) = run(folder.path(), &["fmt", "-"], "let a=b\nlet a=c");
    assert_eq!(
        (status, out.as_str(), err.as_str()),
        (0, "let a = b\nlet a = c\n", "")
    );
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let folder = folder(&[("a.sweep", UGLY)]);
    let (file, link) = (folder.path().join("a.sweep"), folder.path().join("b.sweep"));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, &link).unwrap();
    assert_eq!(run(folder.path(), &["fmt", "b.sweep"], "").0, 0);
    assert!(link.is_symlink());
    assert_eq!(read(&folder, "a.sweep"), PRETTY);
    assert_eq!(file.metadata().unwrap().permissions().mode() & 0o777, 0o640);
}

#[test]
fn a_report_is_the_same_before_and_after() {
    for path in files()
        .iter()
        .filter(|own| !own.ends_with("constructions.sweep"))
    {
        let folder = TempDir::new().unwrap();
        for own in fs::read_dir(path.parent().unwrap()).unwrap() {
            let own = own.unwrap().path();
            if own.is_file() {
                fs::copy(&own, folder.path().join(own.file_name().unwrap())).unwrap();
            }
        }
        let name = path.file_name().unwrap().to_str().unwrap();
        let text = fs::read_to_string(path).unwrap();
        // every `*` before a parenthesis may go where a name stands before it, and comes again
        let squeezed = text
            .replace(" * (", " (")
            .replace(" = ", "=")
            .replace(", ", " ,");
        fs::write(folder.path().join(name), &squeezed).unwrap();
        let report = |what: &str| {
            let (status, out, err) = run(folder.path(), &["report", "--format", "json", name], "");
            assert_eq!(status, 0, "{what} {name}: {err}");
            let mut report: serde_json::Value = serde_json::from_str(&out).unwrap();
            for surface in report["surfaces"].as_array_mut().unwrap() {
                for own in surface["expectations"].as_array_mut().unwrap() {
                    own["line"] = 0.into();
                    let text = own["text"].as_str().unwrap().replace([' ', '*', '\n'], "");
                    own["text"] = text.into();
                }
            }
            report
        };
        let before = report("before");
        let (status, _, err) = run(folder.path(), &["fmt", name], "");
        assert_eq!(status, 0, "{err}");
        assert_eq!(report("after"), before, "{name}");
        assert_eq!(
            read(&folder, name).lines().count(),
            text.lines().count(),
            "{name}"
        );
    }
}
