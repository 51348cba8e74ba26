//! Rows about the same bytes everywhere.

use crate::files::{folder, tree};
use crate::watched::sweepc;

/// Irrational numbers, a warning, an expectation, and large and small doubles.
const TEXT: &str = "unit inch
profile p(u) in xz = (1.5u, u^2 / 1000000)
sweep c(v) in xy = (v, v)
surface R = c(v) + x(u) n(v) + z(u) k
surface Q = (u / 3, 123456789.25 v, u v)
surface S = ((3u - 1) u / (3u - 1), v, 0)
expect length(c)^2 == 2
";

const PLACES: &[&[(&str, &str)]] = &[
    &[("LANG", ""), ("LC_ALL", ""), ("TZ", "")],
    &[
        ("LANG", "de_DE.UTF-8"),
        ("LC_ALL", "de_DE.UTF-8"),
        ("TZ", "Asia/Kathmandu"),
    ],
    &[
        ("LANG", "tr_TR.ISO-8859-9"),
        ("LC_ALL", "C"),
        ("TZ", "America/St_Johns"),
        ("HOME", "nowhere"),
    ],
];

#[test]
fn row_61_every_place() {
    let runs = PLACES.iter().map(|place| {
        let folder = folder(&[("x.sweep", TEXT)]);
        let compile = sweepc(folder.path(), &["compile", "x.sweep", "-o", "out"], place);
        assert_eq!(compile.status, 0, "{}", compile.err);
        assert!(compile.err.contains("W1004"), "{}", compile.err);
        let report = sweepc(folder.path(), &["report", "x.sweep"], place);
        (compile, report, tree(folder.path()))
    });
    let runs: Vec<_> = runs.collect();
    assert!(runs[0].2.len() > 7, "{:?}", runs[0].2.keys());
    assert!(runs[0] == runs[1] && runs[0] == runs[2]);
}

#[test]
fn row_62_every_number_of_threads() {
    let names: Vec<String> = (0..20).map(|index| format!("{index}.sweep")).collect();
    let texts: Vec<(&str, String)> = names
        .iter()
        .map(|name| {
            (
                name.as_str(),
                format!("{TEXT}let a = {name}\n").replace(".sweep", " + b"),
            )
        })
        .collect();
    let files: Vec<(&str, &str)> = texts
        .iter()
        .map(|(name, text)| (*name, text.as_str()))
        .collect();
    let folder = folder(&files);
    let check = |threads: &str, format: &str| {
        let options = ["check", "--threads", threads, "--format", format];
        let names = names.iter().map(String::as_str);
        sweepc(
            folder.path(),
            &options.into_iter().chain(names).collect::<Vec<_>>(),
            &[],
        )
    };
    for format in ["text", "json"] {
        let one = check("1", format);
        assert_eq!(one.status, 1);
        let said = if format == "text" { &one.err } else { &one.out };
        assert_eq!(
            said.matches("E0101").count(),
            21 - usize::from(format == "json"),
            "{said}"
        );
        for threads in ["2", "8", "64"] {
            assert_eq!(check(threads, format), one);
        }
    }
    // A file of many surfaces and names, each of which has its place in some table.
    let lines = (0..50)
        .map(|index| format!("let a{index} = {index}\nsurface R{index} = (u, v, a{index})\n"));
    let text: String = lines.collect();
    let compiled = |threads: &str| {
        let folder = crate::files::folder(&[("x.sweep", &text)]);
        let arguments = ["compile", "x.sweep", "--threads", threads];
        assert_eq!(sweepc(folder.path(), &arguments, &[]).status, 0);
        tree(folder.path())
    };
    assert!(compiled("1") == compiled("64"));
}
