//! What only one place may reach for: big integers, floating point, the outside world.

use crate::source::Source;
use crate::{Finding, hold, tree};

const BIGNUM: &[&str] = &["num_bigint", "num_rational", "num_integer", "num_traits"];
const FLOATS: &[&str] = &["f32", "f64"];
const FLOAT_FILES: &[&str] = &["src/export/approx.rs", "src/export/tessellate/samples.rs"];
/// Folders whose files may have floating point.
const FLOAT_FOLDERS: &[&str] = &["src/export/picture/"];
const OUTSIDE: &[&str] = &["fs", "io", "env", "process", "net", "time"];
const PRINTING: &[&str] = &["print", "println", "eprint", "eprintln"];

/// Modules of `std` that a file needs for their traits alone, each with the reason.
const LENT: &[(&str, &str, &str)] = &[(
    "src/report/json.rs",
    "io",
    "serde_json's `Formatter` is written against `io::Write`; the text stays in memory",
)];

/// The bignum crates stay below the floor `number`.
fn bignum(file: &Source) -> Vec<Finding> {
    if file.name.starts_with("src/number/") {
        return Vec::new();
    }
    let words = file
        .words()
        .into_iter()
        .filter(|word| BIGNUM.contains(&word.text));
    words
        .map(|word| format!("{}: `{}` outside src/number", file.at(word.line), word.text))
        .collect()
}

/// Floating point stays in a few places of the exporter.
fn floats(file: &Source) -> Vec<Finding> {
    let in_folder = FLOAT_FOLDERS.iter().any(|own| file.name.starts_with(own));
    if in_folder || FLOAT_FILES.contains(&file.name.as_str()) {
        return Vec::new();
    }
    let float = |word: &str| {
        let suffixed = word.starts_with(|c: char| c.is_ascii_digit());
        FLOATS.contains(&word) || suffixed && FLOATS.iter().any(|float| word.ends_with(float))
    };
    let words = file.words().into_iter().filter(|word| float(word.text));
    words
        .map(|word| {
            let place = [FLOAT_FILES, FLOAT_FOLDERS].concat().join(", ");
            format!("{}: `{}` outside {place}", file.at(word.line), word.text)
        })
        .collect()
}

/// Files, streams, the environment and the clock stay in `cli` and `main.rs`.
fn outside(file: &Source) -> Vec<Finding> {
    if file.name.starts_with("src/cli/") || file.name == "src/main.rs" {
        return Vec::new();
    }
    let mut findings = Vec::new();
    for word in file.words() {
        let after = file.code[word.start + word.text.len()..].trim_start();
        let finding = |what: &str| format!("{}: {what} outside src/cli", file.at(word.line));
        if PRINTING.contains(&word.text) && after.starts_with('!') {
            findings.push(finding(&format!("`{}!`", word.text)));
        }
        let path = after.strip_prefix("::").filter(|_| word.text == "std");
        for name in path.map(modules).unwrap_or_default() {
            let lent = LENT
                .iter()
                .any(|(path, module, _)| *path == file.name && *module == name);
            if OUTSIDE.contains(&name.as_str()) && !lent {
                findings.push(finding(&format!("`std::{name}`")));
            }
        }
    }
    findings
}

/// The modules of `std` that a path, or a group of paths, begins with.
fn modules(path: &str) -> Vec<String> {
    let path = path.trim_start();
    let scope = match path.strip_prefix('{') {
        Some(group) => group.split(';').next().unwrap_or_default(),
        None => path
            .split(|c: char| !c.is_alphanumeric() && c != '_')
            .next()
            .unwrap_or_default(),
    };
    crate::source::words(scope)
        .iter()
        .map(|word| word.text.to_owned())
        .collect()
}

#[test]
fn one_floor_knows_the_bignum_crates() {
    hold(&tree::rust_of_the_crate(), bignum);
}

#[test]
fn floating_point_stays_in_the_exporter() {
    hold(&tree::rust_of_the_crate(), floats);
}

#[test]
fn the_outside_world_stays_in_the_command_line() {
    hold(&tree::rust_of_the_crate(), outside);
}

#[test]
fn a_bignum_import_is_found() {
    let text = "use num_traits::Zero; // num_bigint\n";
    assert_eq!(bignum(&Source::new("src/poly/uni.rs", text)).len(), 1);
    assert!(bignum(&Source::new("src/number/rational.rs", text)).is_empty());
}

#[test]
fn a_float_is_found() {
    let text = "fn f(a: f64) -> f32 { 1f64; my_f64; \"f64\"; /* f32 */ }";
    assert_eq!(floats(&Source::new("src/net/knots.rs", text)).len(), 3);
    assert!(floats(&Source::new("src/export/approx.rs", text)).is_empty());
    assert!(floats(&Source::new("src/export/picture/grid.rs", text)).is_empty());
}

#[test]
fn input_and_output_are_found() {
    let found = |text: &str| outside(&Source::new("src/sema/scope.rs", text)).len();
    assert_eq!(found("use std::fs::File;"), 1);
    assert_eq!(found("use std::{fmt, io::Write};"), 1);
    assert_eq!(found("fn f() { std::env::var(\"HOME\"); println!(); }"), 2);
    assert_eq!(found("use std::fmt::Write; // std::fs"), 0);
    assert!(outside(&Source::new("src/cli/compile.rs", "use std::fs::File;")).is_empty());
}
