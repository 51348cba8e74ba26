//! The command line as other programs see it: exit status, standard output, files.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod example_files;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Output;

use example_files::run;
use serde_json::Value;
use tempfile::TempDir;

const SOUND: &str = "param a = 1\nsurface R = (u, a v, u v)\nsurface Q = (u, v, 0)\n";

/// A folder with a file `x.sweep` in it.
fn folder(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("x.sweep"), text).unwrap();
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

fn files(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

fn names(names: &[&str]) -> BTreeSet<String> {
    names.iter().map(|own| (*own).to_owned()).collect()
}

#[test]
fn exit_status_says_how_it_ended() {
    for (text, arguments, expected) in [
        (SOUND, &["check", "x.sweep"][..], 0),
        ("surface R = (u, v, w)", &["check", "x.sweep"], 1),
        (
            "surface R = (u, v, 0)\nexpect 1 == 2",
            &["check", "x.sweep"],
            1,
        ),
        (SOUND, &["frobnicate", "x.sweep"], 2),
        (SOUND, &["check"], 2),
        (SOUND, &["check", "x.sweep", "-D", "b=1"], 2),
        (SOUND, &["check", "x.sweep", "-D", "a=x"], 2),
        (SOUND, &["report", "x.sweep", "--surface", "S"], 2),
        (SOUND, &["compile", "x.sweep", "--emit", "jpeg"], 2),
        (SOUND, &["check", "y.sweep"], 3),
        (SOUND, &["compile", "x.sweep", "-o", "no/such"], 3),
        (SOUND, &["compile", "x.sweep", "-o", "x.sweep"], 3),
        ("surface R = (u, v, u^9999)", &["check", "x.sweep"], 4),
        ("surface R = (u, v, u^501)", &["check", "x.sweep"], 4),
        (
            "surface R = (u, v, u^501)",
            &["check", "x.sweep", "--max-degree", "600"],
            0,
        ),
        ("", &["check", "x.sweep"], 0),
        ("", &["report", "x.sweep"], 1),
        ("", &["compile", "x.sweep"], 1),
        (SOUND, &["--version"], 0),
    ] {
        let folder = folder(text);
        let output = run(folder.path(), arguments, "");
        assert_eq!(
            status(&output),
            expected,
            "{text} {arguments:?} {}",
            err(&output)
        );
    }
}

#[test]
fn compile_writes_a_file_for_each_surface_and_format() {
    let folder = folder(SOUND);
    let output = run(folder.path(), &["compile", "x.sweep", "-o", "out"], "");
    assert_eq!(status(&output), 0, "{}", err(&output));
    let expected = [
        "x.report.json",
        "x-R.json",
        "x-R.step",
        "x-Q.json",
        "x-Q.step",
        // both share an edge
        "x.step",
    ];
    assert_eq!(files(&folder.path().join("out")), names(&expected));
    assert_eq!(out(&output).lines().count(), expected.len());

    let output = run(
        folder.path(),
        &["compile", "x.sweep", "--emit", "json", "--surface", "Q"],
        "",
    );
    assert_eq!(status(&output), 0);
    assert_eq!(files(folder.path()), names(&["x.sweep", "out", "x-Q.json"]));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = folder(SOUND);
    for name in ["a", "b"] {
        let output = run(folder.path(), &["compile", "x.sweep", "-o", name], "");
        assert_eq!(status(&output), 0);
    }
    for file in files(&folder.path().join("a")) {
        let read = |name: &str| fs::read(folder.path().join(name).join(&file)).unwrap();
        assert_eq!(read("a"), read("b"), "{file}");
    }
}

#[test]
fn errors_leave_no_file() {
    for text in [
        "surface R = (u, v, 0)\nlet a = ",
        "surface R = (u, v, 0)\nexpect bidegree(R) == (7, 7)",
        "surface R = (u, v, 1/(u - 1/2))\nsurface Q = (u, v, zz)",
    ] {
        let folder = folder(text);
        let output = run(folder.path(), &["compile", "x.sweep"], "");
        assert_eq!(status(&output), 1, "{text}");
        assert_eq!(files(folder.path()), names(&["x.sweep"]), "{text}");
    }
}

#[test]
fn a_pole_spoils_its_own_surface_only() {
    let folder = folder("surface R = (u, v, 1/(u - 1/2))\nsurface Q = (u, v, 0)");
    let output = run(folder.path(), &["compile", "x.sweep"], "");
    assert_eq!(status(&output), 1);
    let expected = ["x.sweep", "x.report.json", "x-Q.json", "x-Q.step"];
    assert_eq!(files(folder.path()), names(&expected));
    let output = run(
        folder.path(),
        &["report", "x.sweep", "--format", "json"],
        "",
    );
    assert_eq!(status(&output), 1);
    let report: Value = serde_json::from_str(&out(&output)).unwrap();
    let pole = &report["surfaces"][0]["poles"][0];
    assert_eq!(pole["kind"], "u");
    assert_eq!(pole["u"], serde_json::json!(["1/2", "1/2"]));
    assert_eq!(pole["v"], serde_json::json!(["0", "1"]));
}

#[test]
fn a_format_that_cannot_carry_a_surface_is_refused_alone() {
    for (text, code) in [
        ("surface R = (u, v, u^26)", "E0305"),
        ("surface R = (u, v, 1/(1 + 10000000 u))", "E0304"),
    ] {
        let folder = folder(text);
        let output = run(folder.path(), &["compile", "x.sweep"], "");
        assert_eq!(status(&output), 1, "{text}");
        assert!(err(&output).contains(code), "{}", err(&output));
        let expected = ["x.sweep", "x.report.json", "x-R.json"];
        assert_eq!(files(folder.path()), names(&expected), "{text}");
    }
}

#[test]
fn standard_input_and_parameters() {
    let folder = TempDir::new().unwrap();
    let text = "param sigma1 = 1\nsurface R = (sigma1 u, v, 0)\nexpect sigma1 == 3/2\n";
    let output = run(folder.path(), &["check", "-"], text);
    assert_eq!(status(&output), 1);
    let output = run(folder.path(), &["check", "-", "-D", "sigma1=1.5"], text);
    assert_eq!(status(&output), 0, "{}", err(&output));
    let output = run(
        folder.path(),
        &["compile", "-", "--set", "sigma1=3/2"],
        text,
    );
    assert_eq!(status(&output), 0);
    assert!(files(folder.path()).contains("stdin-R.step"));
}

#[test]
fn diagnostics_as_json_have_the_documented_members() {
    let folder = folder("let a = 1\r\nlet σσ = b\nsurface R = (u, v, 0)\n");
    let output = run(folder.path(), &["check", "x.sweep", "--format", "json"], "");
    assert_eq!(status(&output), 1);
    let finding: Value = serde_json::from_str(out(&output).lines().next().unwrap()).unwrap();
    assert_eq!(finding["code"], "E0101");
    assert_eq!(finding["severity"], "error");
    assert_eq!(finding["file"], "x.sweep");
    let span = serde_json::json!({"start": 22, "end": 23, "line": 2, "column": 10});
    assert_eq!(finding["span"], span);
    assert!(finding["notes"].is_array());
    assert!(finding.get("fix").is_some());
}

#[test]
fn imports_stay_in_the_folder_and_may_not_run_in_circles() {
    let folder = folder("import \"parts/a.sweep\"\nsurface R = (u, v, a)\nexpect a == 2\n");
    let parts = folder.path().join("parts");
    fs::create_dir(&parts).unwrap();
    fs::write(parts.join("a.sweep"), "import \"b.sweep\"\nlet a = b\n").unwrap();
    fs::write(parts.join("b.sweep"), "let b = 2\n").unwrap();
    let output = run(folder.path(), &["check", "x.sweep"], "");
    assert_eq!(status(&output), 0, "{}", err(&output));

    for (text, code) in [
        ("import \"../x.sweep\"", "E0604"),
        ("import \"../../y.sweep\"", "E0601"),
        ("import \"../../../../../../../../../etc/passwd\"", "E0603"),
        ("import \"/etc/passwd\"", "E0603"),
        ("import \"b.sweep\"\nimport \"a.sweep\"", "E0604"),
        ("import \".\"", "E0601"),
    ] {
        fs::write(parts.join("a.sweep"), format!("{text}\nlet a = 2\n")).unwrap();
        let output = run(folder.path(), &["check", "x.sweep"], "");
        assert!(err(&output).contains(code), "{text}: {}", err(&output));
    }
}

#[test]
fn colours_only_where_they_are_wanted() {
    let folder = folder("surface R = (u, v, w)");
    let coloured = |arguments: &[&str]| err(&run(folder.path(), arguments, "")).contains('\u{1b}');
    assert!(!coloured(&["check", "x.sweep"]));
    assert!(!coloured(&["check", "x.sweep", "--color", "never"]));
    assert!(coloured(&["check", "x.sweep", "--color", "always"]));
}

#[test]
fn hostile_input_ends_at_a_limit_or_soon() {
    let doubling: String = (1..60)
        .map(|i| format!("let a{i}(u) = a{0}(u) + a{0}(u)\n", i - 1))
        .collect();
    let chain: String = (1..20_000)
        .map(|i| format!("let a{i}(u) = a{}(u) + 1\n", i - 1))
        .collect();
    let unknown: String = (0..5_000).map(|i| format!("let q{i} = zz{i}\n")).collect();
    let primes = "'".repeat(10_000);
    for (text, arguments, expected) in [
        (
            format!("let a0(u) = u\n{doubling}surface R = (u, v, a59(1 - u))"),
            &[][..],
            0,
        ),
        (
            format!("let a0(u) = u\n{chain}surface R = (u, v, a19999(u))"),
            &[],
            4,
        ),
        (unknown, &[], 1),
        (
            format!("let f(u) = u^3\nsurface R = (u, v, f{primes}(u))"),
            &[],
            4,
        ),
        (
            "surface R = (u, v, (u + v)^400)".to_owned(),
            &["--max-seconds", "1"],
            4,
        ),
        (
            format!("surface R = (u, v, 0.{} u)", "7".repeat(20_000)),
            &[],
            0,
        ),
    ] {
        let folder = folder(&text);
        let arguments = [&["check", "x.sweep"], arguments].concat();
        let output = run(folder.path(), &arguments, "");
        let start: String = text.chars().take(60).collect();
        assert_eq!(status(&output), expected, "{start} {}", err(&output));
    }
}

#[test]
fn endless_files_are_read_no_further_than_the_limit() {
    let folder = folder(SOUND);
    let arguments = ["check", "x.sweep", "--max-source", "10"];
    let output = run(folder.path(), &arguments, "");
    assert_eq!(status(&output), 4);
    #[cfg(unix)]
    assert_eq!(status(&run(folder.path(), &["check", "/dev/zero"], "")), 4);
}

#[test]
fn every_format_that_refuses_a_surface_is_named() {
    for (text, formats, code, note) in [
        (
            "surface R = (u / (1 + 20000000 u), v, u v)",
            "step,iges,3dm,obj",
            "E0304",
            "not written: `step`, `iges`, `3dm`, `obj`\n",
        ),
        (
            "surface R = (1e39 u, 1e39 v, 1e39 u v)",
            "stl,ply,glb",
            "E0306",
            "not written: `stl`, `glb`\n",
        ),
        (
            "surface R = (u, v, u^26)",
            "step,json",
            "E0305",
            "not written: `step`\n",
        ),
    ] {
        let folder = folder(text);
        let output = run(
            folder.path(),
            &["compile", "x.sweep", "--emit", formats],
            "",
        );
        let told = err(&output);
        assert_eq!(status(&output), 1, "{told}");
        assert_eq!(told.matches(&format!("error[{code}]")).count(), 1, "{told}");
        assert!(told.contains(note), "{told}");
    }
}

#[test]
fn every_format_that_warns_of_a_surface_is_named() {
    let text = "surface R = (u, v, 1 / (1 + 2000 u))\nsurface S = (u, v + 2, 1 / (1 + 2000 u))\n";
    let folder = folder(text);
    let arguments = ["compile", "x.sweep", "--emit", "step,iges,obj,json"];
    let output = run(folder.path(), &arguments, "");
    let told = err(&output);
    assert_eq!(status(&output), 0, "{told}");
    assert_eq!(told.matches("warning[W1006]").count(), 2, "{told}");
    let note = "in the files: `step`, `iges`, `obj`\n";
    assert_eq!(told.matches(note).count(), 2, "{told}");
}

#[test]
fn what_a_missing_import_declares_is_not_missed() {
    let uses = "surface R = (q u, v, x(u))\nsurface S = swept(p, c)\nexpect regular(T)\n\
                construction own(a) = a + w\n";
    let folder = folder(&format!("import \"y.sweep\"\n{uses}"));
    let only = |code: &str, arguments: &[&str]| {
        let output = run(folder.path(), arguments, "");
        let told = err(&output);
        assert_eq!(told.matches("error[").count(), 1, "{told}");
        assert!(told.contains(&format!("error[{code}]")), "{told}");
        assert!(told.contains("x.sweep:1:8"), "{told}");
    };
    for arguments in [&["check", "x.sweep"][..], &["check", "x.sweep", "-Dq=2"]] {
        only("E0601", arguments);
        fs::write(folder.path().join("y.sweep"), b"let q = \xff").unwrap();
        only("E0001", arguments);
        fs::remove_file(folder.path().join("y.sweep")).unwrap();
    }
    // An import with errors of syntax is there: what it does not declare is told.
    fs::write(folder.path().join("y.sweep"), "let q = = 2\nlet w 3\n").unwrap();
    let told = err(&run(folder.path(), &["check", "x.sweep"], ""));
    assert!(!told.contains("`q`") && !told.contains("`w`"), "{told}");
    assert!(told.contains("`swept` is not declared"), "{told}");
}

#[test]
fn a_refused_surface_leaves_out_the_file_of_all() {
    for (bad, emit, code) in [
        ("(u^26, v, u)", "step", "E0305"),
        ("(u^26, v, u)", "iges", "E0305"),
        ("(1e39 u, v, 0)", "stl", "E0306"),
    ] {
        let folder = folder(&format!("surface R = (u, v, u v)\nsurface Z = {bad}\n"));
        let output = run(folder.path(), &["compile", "x.sweep", "--emit", emit], "");
        let told = err(&output);
        assert_eq!(status(&output), 1, "{told}");
        assert_eq!(told.matches("error[").count(), 1, "{told}");
        assert!(told.contains(code) && told.contains("x.sweep:2:"), "{told}");
        let extension = if emit == "iges" { "igs" } else { emit };
        let expected = ["x.sweep", &format!("x-R.{extension}")];
        assert_eq!(files(folder.path()), names(&expected));
    }
}

#[test]
fn what_only_the_file_of_all_surfaces_exceeds_is_said_of_it() {
    let folder = folder("surface R = (u, v, u v)\nsurface S = (-u, v, u v)\n");
    let arguments = ["compile", "x.sweep", "--emit=glb", "--chord=1/8"];
    let alone = ["--max-triangles=8"];
    let output = run(folder.path(), &[&arguments[..], &alone].concat(), "");
    let told = err(&output);
    assert_eq!(status(&output), 4, "{told}");
    let note = "all surfaces in one file are not written: `glb`";
    assert!(told.contains(note) && !told.contains("note: not"), "{told}");
    assert_eq!(told.matches("error[").count(), 1, "{told}");
    let expected = ["x.sweep", "x-R.glb", "x-S.glb"];
    assert_eq!(files(folder.path()), names(&expected));
}

#[test]
fn values_of_parameters_keep_to_the_limits_of_numbers() {
    let folder = folder(SOUND);
    for (value, limit, expected, part) in [
        (
            "1234",
            "--max-digits=3",
            4,
            "error[E0503]: a number of 4 digits",
        ),
        (
            "1/1234",
            "--max-digits=3",
            4,
            "`--max-digits` raises the limit",
        ),
        ("1234", "--max-digits=4", 0, ""),
        ("1e40", "--max-exponent=3", 4, "error[E0504]"),
        ("1e40", "--max-exponent=3", 4, "given with `-D a=…`"),
        ("1e4097", "--max-digits=9", 4, "`--max-exponent`"),
        ("1e5000", "--max-exponent=10000", 0, ""),
        ("1_000", "--max-digits=9", 2, "is not an exact number"),
    ] {
        for command in ["check", "report", "compile"] {
            let value = format!("a={value}");
            let arguments = [command, "x.sweep", "-D", &value, limit];
            let output = run(folder.path(), &arguments, "");
            let told = err(&output);
            // No format but `json` carries so great a number.
            let refused = expected == 0 && told.contains("E0306");
            assert!(
                refused || status(&output) == expected,
                "{arguments:?} {told}"
            );
            assert!(told.contains(part), "{arguments:?} {told}");
        }
    }
    let arguments = [
        "check",
        "x.sweep",
        "--format=json",
        "-Da=12",
        "--max-digits=1",
    ];
    let output = run(folder.path(), &arguments, "");
    let finding: Value = serde_json::from_str(&out(&output)).unwrap();
    assert_eq!(finding["code"], "E0503");
    assert_eq!(status(&output), 4);
}

#[test]
fn imported_files_are_named_from_the_working_directory() {
    let folder = TempDir::new().unwrap();
    let parts = folder.path().join("project").join("parts");
    fs::create_dir_all(&parts).unwrap();
    let texts = [
        (
            "x.sweep",
            "import \"parts/y.sweep\"\nsurface R = (u, v, a)\n",
        ),
        ("parts/y.sweep", "import \"z.sweep\"\nlet a = b\n"),
        ("parts/z.sweep", "let b = c\n"),
    ];
    for (name, text) in texts {
        fs::write(folder.path().join("project").join(name), text).unwrap();
    }
    let absolute = fs::canonicalize(&parts).unwrap().join("z.sweep");
    let given = folder.path().join("project").join("x.sweep");
    for (directory, file, expected) in [
        ("", "project/x.sweep", Path::new("project/parts/z.sweep")),
        ("project", "x.sweep", Path::new("parts/z.sweep")),
        ("project", "./x.sweep", Path::new("./parts/z.sweep")),
        ("project/parts", "../x.sweep", Path::new("../parts/z.sweep")),
        ("", given.to_str().unwrap(), &absolute),
    ] {
        let directory = folder.path().join(directory);
        let output = run(&directory, &["check", file, "--format=json"], "");
        let first = out(&output).lines().next().unwrap().to_owned();
        let finding: Value = serde_json::from_str(&first).unwrap();
        let named = directory.join(finding["file"].as_str().unwrap());
        let same = fs::canonicalize(named).unwrap();
        assert_eq!(same, absolute, "{file} {first}");
        let told = err(&run(&directory, &["check", file], ""));
        let told = told.replace('\\', "/");
        let expected = format!("{}:1:9", expected.display()).replace('\\', "/");
        assert!(told.contains(&expected), "{file} {told}");
    }
}

#[test]
fn limits_may_be_as_high_as_their_numbers_go() {
    let folder = folder(SOUND);
    fs::write(folder.path().join("v.csv"), "a\n2\n").unwrap();
    let (most, largest) = (usize::MAX.to_string(), u32::MAX.to_string());
    let long = [
        "source",
        "digits",
        "degree",
        "terms",
        "bits",
        "field-degree",
    ];
    let longer = ["triangles", "imports", "variants", "seconds", "memory"];
    let limits = long.iter().chain(&longer).map(|own| (own, &most));
    for (limit, value) in limits.chain([(&"exponent", &largest)]) {
        let limit = format!("--max-{limit}={value}");
        let arguments = [
            "compile",
            "x.sweep",
            "--list=v.csv",
            "--emit=json,glb",
            &limit,
        ];
        let output = run(folder.path(), &arguments, "");
        assert_eq!(status(&output), 0, "{limit} {}", err(&output));
        let written = files(folder.path());
        assert!(written.contains("x-a=2-R.json"), "{limit} {written:?}");
        fs::remove_file(folder.path().join("x-a=2-R.json")).unwrap();
    }
    let output = run(
        folder.path(),
        &["check", "-", &format!("--max-source={most}")],
        "?",
    );
    assert_eq!(status(&output), 1);
}

#[test]
fn a_finding_in_a_very_long_line_is_short() {
    let text = format!("let a = 1,5 let b = 2,5 # {}\n", "x".repeat(1_000_000));
    let folder = folder(&text);
    let output = run(folder.path(), &["check", "x.sweep"], "");
    let told = err(&output);
    assert_eq!(status(&output), 1);
    assert!(told.contains("1.5 let b"), "{told}");
    assert!(told.len() < 10_000, "{}", told.len());
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_are_not_text_keep_their_bytes() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    use std::process::Command;

    let folder = TempDir::new().unwrap();
    let name = OsStr::from_bytes(b"a\xff.sweep");
    fs::write(folder.path().join(name), SOUND).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_sweepc"));
    let command = command.current_dir(folder.path()).arg("compile").arg(name);
    assert!(command.output().unwrap().status.success());
    let written = folder.path().join(OsStr::from_bytes(b"a\xff-R.step"));
    assert!(written.exists());
}
