//! Names that say nothing, and words that mean the work is not done.

use crate::source::{Source, words};
use crate::{Finding, hold, tree};

const EMPTY_NAMES: &[&str] = &[
    "util", "utils", "common", "helper", "helpers", "misc", "manager",
];
const UNFINISHED: &[&str] = &["todo", "unimplemented", "dbg"];
const MARKS: &[&str] = &["FIXME", "XXX"];
const ATTRIBUTES: &[&str] = &["ignore", "should_panic"];

/// Files, folders and modules with a name that fits anything, and functions `get_…`.
fn empty_names(file: &Source) -> Vec<Finding> {
    let mut findings = Vec::new();
    for part in file.name.trim_end_matches(".rs").split('/') {
        if EMPTY_NAMES.contains(&part) {
            findings.push(format!("{}: the name `{part}`", file.at(1)));
        }
    }
    for pair in file.words().windows(2) {
        let name = pair[1].text;
        let module = pair[0].text == "mod" && EMPTY_NAMES.contains(&name);
        if module || pair[0].text == "fn" && name.starts_with("get_") {
            findings.push(format!("{}: the name `{name}`", file.at(pair[1].line)));
        }
    }
    findings
}

/// Macros, marks and attributes of unfinished work.
fn unfinished(file: &Source) -> Vec<Finding> {
    let mut findings = Vec::new();
    for word in file.words() {
        let before = file.code[..word.start].trim_end();
        let after = &file.code[word.start + word.text.len()..];
        let call = UNFINISHED.contains(&word.text) && after.starts_with('!');
        let attribute = ATTRIBUTES.contains(&word.text) && before.ends_with("#[");
        if call || attribute || MARKS.contains(&word.text) {
            findings.push(format!("{}: `{}`", file.at(word.line), word.text));
        }
    }
    for word in words(&file.comments)
        .into_iter()
        .filter(|word| MARKS.contains(&word.text))
    {
        findings.push(format!("{}: `{}`", file.at(word.line), word.text));
    }
    findings
}

#[test]
fn names_say_something() {
    hold(&tree::rust(), empty_names);
}

#[test]
fn work_is_finished() {
    hold(&tree::rust(), unfinished);
}

#[test]
fn an_empty_name_is_found() {
    let found = |name: &str, text: &str| empty_names(&Source::new(name, text)).len();
    assert_eq!(found("src/poly/utils.rs", ""), 1);
    assert_eq!(found("src/common/mod.rs", ""), 1);
    assert_eq!(
        found("src/poly/uni.rs", "mod helpers { fn get_degree() {} }"),
        2
    );
    assert_eq!(
        found("src/poly/uni.rs", "mod help; fn get() {} // mod util"),
        0
    );
}

#[test]
fn unfinished_work_is_found() {
    let found = |text: &str| unfinished(&Source::new("src/a.rs", text)).len();
    assert_eq!(
        found("fn f() { todo!() } fn g() { unimplemented!(); dbg!(1); }"),
        3
    );
    assert_eq!(found("// FIXME later\n/* XXX */"), 2);
    assert_eq!(
        found("#[test]\n#[ignore]\n#[should_panic(expected = \"x\")]\nfn f() {}"),
        2
    );
    assert_eq!(found("fn todo() { \"todo!()\"; ignore(); }"), 0);
}
