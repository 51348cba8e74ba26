//! Many files, or many variants of one, compiled by one run.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

#[cfg(unix)]
mod broken_off;
#[path = "../example_files/mod.rs"]
mod example_files;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use example_files::run;
use serde_json::Value;
use tempfile::TempDir;

/// A profile at the distance d from a Pythagorean-hodograph curve, scaled by e.
const RAIL: &str = "param d = 1/2
param e = 1
profile p(u) in xz = (e * (1 - u^2) / (1 + u^2), 2 e u / (1 + u^2))
sweep   c(v) in xy = ph(start: (0, 0), preimage: [(2, 2), (2, 1), (3, 1/2)])
surface R = c(v) + d n(v) + x(u) i + z(u) k
";
/// Fails where d is 1/2: the numerator is not zero there.
const POLE: &str = "param d = 1\nsurface R = (u, v, 1 / (d - u / 2))\n";

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// Standard output and standard error of a run that ends with this status.
fn compile(folder: &Path, arguments: &[&str], status: i32) -> (String, String) {
    let arguments = [&["compile"], arguments].concat();
    let output = run(folder, &arguments, "");
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let (out, err) = (text(output.stdout), text(output.stderr));
    assert_eq!(output.status.code(), Some(status), "{arguments:?}\n{err}");
    (out, err)
}

/// The files of a folder with their bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let entries = entries.filter(|entry| entry.path().is_file());
    let read = |entry: fs::DirEntry| {
        let name = entry.file_name().into_string().unwrap();
        (name, fs::read(entry.path()).unwrap())
    };
    entries.map(read).collect()
}

fn names(folder: &Path) -> BTreeSet<String> {
    files(folder).into_keys().collect()
}

fn set(names: &[&str]) -> BTreeSet<String> {
    names.iter().map(|own| (*own).to_owned()).collect()
}

/// The objects of a table.
fn objects(path: &Path) -> Vec<Value> {
    let text = fs::read_to_string(path).unwrap();
    let objects = text.lines().map(serde_json::from_str);
    objects.collect::<Result<_, _>>().unwrap()
}

/// The rows of a table by the names of its columns.
fn rows(path: &Path) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let rows = reader.deserialize();
    rows.collect::<Result<_, _>>().unwrap()
}

#[test]
fn the_product_of_ranges_in_their_order() {
    let folder = folder(&[("x.sweep", RAIL)]);
    let arguments = "x.sweep --grid d=-1/2:1:1/2 --grid e=1:2:1 --emit json -o out";
    let arguments: Vec<&str> = arguments.split(' ').collect();
    let (out, err) = compile(folder.path(), &arguments, 0);
    let table = Path::new("out").join("x.batch.csv");
    let lines = Path::new("out").join("x.batch.jsonl");
    assert_eq!(
        out,
        format!("{}\n{}\n", table.display(), lines.display()),
        "{err}"
    );
    assert_eq!(err, "");
    let rows = rows(&folder.path().join(table));
    let values = rows.iter().map(|row| {
        [&row["variant"], &row["parameters.d"], &row["parameters.e"]].map(String::as_str)
    });
    let expected = [
        ["1", "-1/2", "1"],
        ["2", "-1/2", "2"],
        ["3", "0", "1"],
        ["4", "0", "2"],
        ["5", "1/2", "1"],
        ["6", "1/2", "2"],
        ["7", "1", "1"],
        ["8", "1", "2"],
    ];
    assert_eq!(values.collect::<Vec<_>>(), expected);
    let mut wanted = set(&["x.batch.csv", "x.batch.jsonl"]);
    wanted.extend(expected.map(|[_, d, e]| format!("x-d={}-e={e}-R.json", d.replace('/', "_"))));
    assert_eq!(names(&folder.path().join("out")), wanted);
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = folder(&[("x.sweep", RAIL)]);
    let out = |threads: &str| {
        let arguments = [
            "x.sweep",
            "--grid",
            "d=0:1:1/60",
            "--jobs",
            threads,
            "-o",
            threads,
        ];
        compile(folder.path(), &arguments, 0);
        files(&folder.path().join(threads))
    };
    let one = out("1");
    assert_eq!(one.len(), 61 * 3 + 2);
    for threads in ["2", "8"] {
        assert!(out(threads) == one, "{threads}");
    }
}

/// A variant is what a run of its own with `--set` writes, and its row says what its report says.
#[test]
fn a_variant_is_a_run_of_its_own() {
    let folder = folder(&[
        ("x.sweep", RAIL),
        ("list.csv", "e, d\n1, 0\n2/3, -0.25\n\"5\", 1e-2\n"),
    ]);
    let arguments = "x.sweep --list list.csv --emit report,json -o out";
    compile(folder.path(), &arguments.split(' ').collect::<Vec<_>>(), 0);
    let out = folder.path().join("out");
    let objects = objects(&out.join("x.batch.jsonl"));
    let rows = rows(&out.join("x.batch.csv"));
    assert_eq!((objects.len(), rows.len()), (3, 3));
    for (row, values) in objects
        .iter()
        .zip([["1", "0"], ["2/3", "-1/4"], ["5", "1/100"]])
    {
        let [e, d] = values;
        assert_eq!(row["parameters"], serde_json::json!({"e": e, "d": d}));
        let set = [format!("e={e}"), format!("d={d}")];
        let alone = format!("alone{}", row["variant"]);
        let arguments = [
            &["x.sweep", "--emit", "report,json", "-o", &alone][..],
            &["-D", &set[0], "-D", &set[1]],
        ];
        compile(folder.path(), &arguments.concat(), 0);
        let suffix = format!("-e={e}-d={d}").replace('/', "_");
        let mut written = Vec::new();
        for ending in ["-R.json", ".report.json"] {
            let name = format!("x{suffix}{ending}");
            let own = fs::read(out.join(&name)).unwrap();
            let single = fs::read(folder.path().join(&alone).join(format!("x{ending}")));
            assert!(own == single.unwrap(), "{name}");
            written.push(name);
        }
        assert_eq!(row["files"], serde_json::json!(written));
        says_what_the_report_says(row, &out.join(&written[1]));
    }
    for (row, object) in rows.iter().zip(&objects) {
        agrees(row, object);
    }
}

fn says_what_the_report_says(row: &Value, report: &Path) {
    let report: Value = serde_json::from_str(&fs::read_to_string(report).unwrap()).unwrap();
    let surface = &report["surfaces"][0];
    assert_eq!(row["surface"], surface["name"]);
    assert_eq!(row["bidegree"], surface["patch"]["bidegree"]);
    assert_eq!(row["common_factor"], surface["common_factor"]["bidegree"]);
    assert_eq!(row["positive_weights"], surface["weights"]["positive"]);
    assert_eq!(row["poles"], surface["poles"].as_array().unwrap().len());
    assert_eq!(row["regular"], surface["regular"]);
    assert_eq!(row["rational_offset"], surface["rational_offset"]);
    assert_eq!(row["field"], report["field"]);
    let curve = &report["curves"][0];
    assert_eq!(curve["name"], "c");
    assert_eq!(
        row["lengths"],
        serde_json::json!({"c": curve["arc_length"]})
    );
}

/// Every cell is the member of the object that its column names.
fn agrees(row: &BTreeMap<String, String>, object: &Value) {
    let text = |own: &Value| match own {
        Value::String(own) => own.clone(),
        Value::Null => String::new(),
        Value::Array(own) => {
            let own = own.iter().map(|own| own.as_str().unwrap());
            own.collect::<Vec<_>>().join(" ")
        }
        own => own.to_string(),
    };
    for (column, cell) in row {
        let steps = column.split('.');
        let member = steps.fold(object, |own, step| match (step, own) {
            ("u", Value::Array(pair)) => &pair[0],
            ("v", Value::Array(pair)) => &pair[1],
            _ => &own[step],
        });
        assert_eq!(*cell, text(member), "{column}");
    }
}

#[test]
fn a_variant_that_fails_is_a_row_and_the_others_go_on() {
    let folder = folder(&[("x.sweep", POLE)]);
    let arguments = ["x.sweep", "--grid", "d=0:1:1/4", "--emit", "json"];
    let (_, err) = compile(folder.path(), &arguments, 1);
    assert_eq!(err.matches("error[E0301]").count(), 3, "{err}");
    assert!(err.contains("sweepc: x.sweep, d = 1/4\n"), "{err}");
    assert!(err.contains("sweepc: 3 of 5 variants failed\n"), "{err}");
    let rows = rows(&folder.path().join("x.batch.csv"));
    let told = rows
        .iter()
        .map(|row| ["status", "codes", "poles", "files"].map(|own| row[own].as_str()));
    let expected = [
        ["1", "E0301", "1", ""],
        ["1", "E0301", "1", ""],
        ["1", "E0301", "1", ""],
        ["0", "", "0", "x-d=3_4-R.json"],
        ["0", "", "0", "x-d=1-R.json"],
    ];
    assert_eq!(told.collect::<Vec<_>>(), expected);
    let written = [
        "x.sweep",
        "x.batch.csv",
        "x.batch.jsonl",
        "x-d=3_4-R.json",
        "x-d=1-R.json",
    ];
    assert_eq!(names(folder.path()), set(&written));
}

#[test]
fn many_failures_are_told_briefly() {
    let folder = folder(&[(
        "x.sweep",
        "param d = 1\nsurface R = (u, v, d)\nexpect d > 7\n",
    )]);
    let arguments = ["x.sweep", "--grid", "d=-7:12:1", "--emit", "table"];
    let (_, err) = compile(folder.path(), &arguments, 1);
    assert_eq!(err.matches("error[E0401]").count(), 10, "{err}");
    assert!(err.contains("of 5 more variants are not shown"), "{err}");
    assert!(err.contains("15 of 20 variants failed"), "{err}");
    let objects = objects(&folder.path().join("x.batch.jsonl"));
    let failed = objects
        .iter()
        .filter(|row| row["codes"] == serde_json::json!(["E0401"]));
    assert_eq!((objects.len(), failed.count()), (20, 15));
}

#[test]
fn many_files() {
    let folder = folder(&[
        ("a.sweep", RAIL),
        (
            "in/b.sweep",
            "surface Q = (u, v, 0)\nsurface P = (u, -v, 0)\n",
        ),
        ("c.sweep", "surface R = \n"),
    ]);
    let arguments = [
        "a.sweep",
        "in/b.sweep",
        "c.sweep",
        "no.sweep",
        "-o",
        "out",
        "--emit",
        "json",
    ];
    let (_, err) = compile(folder.path(), &arguments, 3);
    assert!(err.contains("c.sweep:1"), "{err}");
    let out = folder.path().join("out");
    let written = [
        "a-R.json",
        "b-Q.json",
        "b-P.json",
        "batch.csv",
        "batch.jsonl",
    ];
    assert_eq!(names(&out), set(&written));
    let objects = objects(&out.join("batch.jsonl"));
    let told = objects.iter().map(|row| {
        let text = |own: &str| row[own].as_str().map(str::to_owned);
        (
            row["variant"].as_u64().unwrap(),
            text("file"),
            text("surface"),
            row["status"].as_u64(),
        )
    });
    let row = |variant, file: &str, surface: Option<&str>, status| {
        (
            variant,
            Some(file.to_owned()),
            surface.map(str::to_owned),
            Some(status),
        )
    };
    let expected = [
        row(1, "a.sweep", Some("R"), 0),
        row(2, "b.sweep", Some("Q"), 0),
        row(2, "b.sweep", Some("P"), 0),
        row(3, "c.sweep", None, 1),
        row(4, "no.sweep", None, 3),
    ];
    assert_eq!(told.collect::<Vec<_>>(), expected);
    has_the_cells_of(&out.join("batch.csv"), &objects);
}

/// Where a cell is not empty, it says what the object says.
fn has_the_cells_of(table: &Path, objects: &[Value]) {
    let rows = rows(table);
    assert_eq!(rows.len(), objects.len());
    for (mut row, object) in rows.into_iter().zip(objects) {
        row.retain(|_, cell| !cell.is_empty());
        agrees(&row, object);
    }
}

#[test]
fn results_of_the_same_name_are_refused() {
    let folder = folder(&[
        ("a.sweep", "surface R = (u, v, 0)\n"),
        ("in/a.sweep", "surface R = (u, v, 1)\n"),
        ("a-R.sweep", "surface R = (u, v, 2)\n"),
    ]);
    let before = names(folder.path());
    for files in [["a.sweep", "in/a.sweep"], ["a-R.sweep", "a.sweep"]] {
        let (_, err) = compile(folder.path(), &[&files[..], &["-o", "out"]].concat(), 2);
        assert!(err.contains("have the same names"), "{err}");
    }
    let apart = ["a.sweep", "a-R.sweep", "-o", "apart", "--emit", "json"];
    compile(folder.path(), &apart, 0);
    // Beside their sources the first two do not meet.
    compile(
        folder.path(),
        &["a.sweep", "in/a.sweep", "--emit", "report"],
        0,
    );
    assert!(names(folder.path()).is_superset(&before));
    assert!(!folder.path().join("out").exists());
}

#[test]
fn values_too_long_for_a_name_give_way_to_numbers() {
    let folder = folder(&[("x.sweep", RAIL)]);
    let digits = "3".repeat(130);
    fs::write(folder.path().join("l.csv"), format!("d\n1/{digits}\n2\n")).unwrap();
    compile(
        folder.path(),
        &["x.sweep", "--list", "l.csv", "--emit", "json", "-o", "o"],
        0,
    );
    let written = [
        "x-variant=1-R.json",
        "x-variant=2-R.json",
        "x.batch.csv",
        "x.batch.jsonl",
    ];
    assert_eq!(names(&folder.path().join("o")), set(&written));
}

#[test]
fn wrong_usage_writes_nothing() {
    let folder = folder(&[
        ("x.sweep", RAIL),
        ("l.csv", "d\n1\n"),
        ("y.sweep", "param dist = 1\n"),
    ]);
    for (arguments, part) in [
        (
            "x.sweep --grid f=0:1:1",
            "`f` is not a parameter of `x.sweep`; there are: d, e",
        ),
        ("y.sweep --grid disd=0:1:1", "did you mean `dist`?"),
        ("x.sweep --grid d=0:1", "NAME=START:END:STEP"),
        ("x.sweep --grid d=0:1:-1", "leads away"),
        (
            "x.sweep --grid d=0:1:1 --grid d=0:1:1",
            "`d` is given its values twice",
        ),
        (
            "x.sweep --grid d=0:1:1 -D d=2",
            "`d` is given its values twice",
        ),
        (
            "x.sweep --grid d=0:1:1 --list l.csv",
            "`d` is given its values twice",
        ),
        ("x.sweep --grid d=0:1:1 --surface S", "`S` is not a surface"),
        ("- - --emit json", "standard input can be read only once"),
    ] {
        let (_, err) = compile(folder.path(), &arguments.split(' ').collect::<Vec<_>>(), 2);
        assert!(err.contains(part), "{arguments}: {err}");
    }
    assert_eq!(names(folder.path()), set(&["x.sweep", "y.sweep", "l.csv"]));
}

#[test]
fn lists_that_are_none() {
    let folder = folder(&[("x.sweep", RAIL)]);
    for (list, status, codes, part) in [
        (
            "d\n1\n2\n0.5\n1/2\n",
            1,
            &["E0605"][..],
            "variant 4 has the values of variant 3",
        ),
        (
            "d\n1\nx\n1,5\n",
            1,
            &["E0605", "E0605"],
            "`x` is not an exact number",
        ),
        (
            "d,e\n1\n",
            1,
            &["E0605"],
            "has 1 value, the first line 2 names",
        ),
        (
            "d\n1,2\n",
            1,
            &["E0605"],
            "has 2 values, the first line 1 name\n",
        ),
        ("d,\n1,\n2\n", 1, &["E0605"], "column 2 has no name"),
        ("1\n2\n", 1, &["E0605"], "the first line names the"),
        ("d;e\n1;2\n", 1, &["E0605"], "separated by commas"),
        ("d,d\n1,2\n", 1, &["E0605"], "`d` has two columns"),
        ("d\n", 1, &["E0605"], "lists no variant"),
        ("", 1, &["E0605"], "lists no variant"),
        ("d,h\n1,1\n", 1, &["E0112"], "there are: d, e"),
        ("d\n\u{0}\n", 1, &["E0605"], ""),
        ("d\n1e5000\n", 4, &["E0504"], "`--max-exponent`"),
        ("d\nx\n\"2\n", 1, &["E0605", "E0605"], "l.csv:3:1"),
        (
            "\u{feff}d\n\"2\n",
            1,
            &["E0605"],
            "this quote is never closed",
        ),
        ("\"d\n2\n", 1, &["E0605"], "l.csv:1:1"),
        ("\"d\", \"e\"\n1,2\n", 1, &["E0605"], "remove the space"),
        ("d,e\n1, \"2\"\n", 1, &["E0605"], "remove the space"),
    ] {
        fs::write(folder.path().join("l.csv"), list).unwrap();
        let (_, err) = compile(folder.path(), &["x.sweep", "--list", "l.csv"], status);
        let found: Vec<&str> = err.split("error[").skip(1).map(|own| &own[..5]).collect();
        assert_eq!(found, codes, "{list}\n{err}");
        assert!(err.contains(part), "{list}\n{err}");
    }
    fs::write(folder.path().join("l.csv"), b"d\n\xff\n").unwrap();
    let (_, err) = compile(folder.path(), &["x.sweep", "--list", "l.csv"], 1);
    assert!(err.contains("error[E0001]"), "{err}");
    let (_, err) = compile(folder.path(), &["x.sweep", "--list", "no.csv"], 3);
    assert!(err.contains("error[E0601]"), "{err}");
    assert_eq!(names(folder.path()), set(&["x.sweep", "l.csv"]));
}

#[test]
fn ranges_keep_to_the_limits_of_numbers() {
    let folder = folder(&[("x.sweep", RAIL)]);
    for (arguments, status, part) in [
        ("d=1:1234:1234 --max-digits=3", 4, "error[E0503]"),
        ("d=1:2:1e-40 --max-exponent=3", 4, "error[E0504]"),
        ("d=1:2:1e-5000", 4, "given with `--grid d=…`"),
        ("d=1:1e5000:1e5000 --max-exponent=5000", 0, ""),
        (
            "d=1:2:1 --chord=1e-40 --max-exponent=30",
            4,
            "given with `--chord`",
        ),
    ] {
        let arguments = format!("x.sweep --emit table --grid {arguments}");
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let (_, err) = compile(folder.path(), &arguments, status);
        assert!(err.contains(part), "{arguments:?}: {err}");
    }
}

#[test]
fn lists_as_other_programs_write_them() {
    let folder = folder(&[("x.sweep", RAIL)]);
    for list in [
        "d,e\n1,2\n",
        "\u{feff}d,e\r\n1,2\r\n",
        "\"d\",\"e\"\n\"1\",\"2\"",
        " d , e \n\n 1 , 2 \n\n",
    ] {
        fs::write(folder.path().join("l.csv"), list).unwrap();
        compile(
            folder.path(),
            &["x.sweep", "--list", "l.csv", "--emit", "json", "-o", "o"],
            0,
        );
        let written = ["x-d=1-e=2-R.json", "x.batch.csv", "x.batch.jsonl"];
        assert_eq!(names(&folder.path().join("o")), set(&written), "{list:?}");
        fs::remove_dir_all(folder.path().join("o")).unwrap();
    }
}

#[test]
fn inputs_are_not_written_over() {
    let list = "x.batch.csv";
    let folder = folder(&[("x.sweep", RAIL), (list, "d\n1\n")]);
    let before = files(folder.path());
    let (_, err) = compile(folder.path(), &["x.sweep", "--list", list], 3);
    assert!(err.contains("`x.batch.csv` is an input"), "{err}");
    assert!(files(folder.path()) == before);
}

#[test]
fn the_number_of_variants_is_limited_before_anything_starts() {
    let folder = folder(&[("x.sweep", RAIL)]);
    for (arguments, part) in [
        ("x.sweep --grid d=1:1e30:1", "more than 100000 variants"),
        (
            "x.sweep --grid d=1:1e5:1 --grid e=1:1e4:1",
            "1000000000 variants; 100000 are allowed",
        ),
        (
            "x.sweep --grid d=1:3:1 --max-variants 2",
            "3 variants; 2 are allowed",
        ),
    ] {
        let (_, err) = compile(folder.path(), &arguments.split(' ').collect::<Vec<_>>(), 4);
        assert!(
            err.contains("error[E0510]") && err.contains("--max-variants"),
            "{err}"
        );
        assert!(err.contains(part), "{err}");
    }
    assert_eq!(names(folder.path()), set(&["x.sweep"]));
    let arguments = "x.sweep --grid d=1:3:1 --max-variants 3 --emit table";
    compile(folder.path(), &arguments.split(' ').collect::<Vec<_>>(), 0);
}
