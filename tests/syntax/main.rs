//! The grammar, production by production; every diagnostic with its place; recovery and limits.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on has failed"
)]

mod characters;
mod declarations;
mod expressions;
mod limits;
mod random;
mod recovery;
mod show;
mod slips;

use show::{show_document, show_expression};
use sweepc::diag::{Code, Diagnostics, FileId, Limits, SourceMap, Style, render_text};
use sweepc::syntax::ast::{Declaration, Document};
use sweepc::syntax::parse;

const FILE: FileId = FileId(0);

fn parsed(text: &str) -> (Document, Diagnostics) {
    parsed_within(text, &Limits::default())
}

fn parsed_within(text: &str, limits: &Limits) -> (Document, Diagnostics) {
    let mut diagnostics = Diagnostics::default();
    let document = parse(FILE, text, limits, &mut diagnostics);
    (document, diagnostics)
}

/// The tree of a text without findings.
#[track_caller]
fn tree(text: &str) -> String {
    let (document, diagnostics) = parsed(text);
    let findings: Vec<_> = diagnostics.iter().collect();
    assert!(findings.is_empty(), "{text}: {findings:#?}");
    show_document(&document)
}

/// The tree of an expression, warnings allowed.
#[track_caller]
fn expression(text: &str) -> String {
    let (document, diagnostics) = parsed(&format!("let a = {text}"));
    assert!(!diagnostics.has_errors(), "{text}: {diagnostics:#?}");
    match &document.items[..] {
        [item] => match &item.declaration {
            Declaration::Let { value, .. } => show_expression(value),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    }
}

/// Codes, marked text and messages of all findings.
fn findings(text: &str) -> Vec<(String, String, String)> {
    let (_, diagnostics) = parsed(text);
    let list = diagnostics.iter().map(|finding| {
        let marked = &text[finding.primary.unwrap().range()];
        let code = finding.code.to_string();
        (code, marked.to_owned(), finding.message.clone())
    });
    list.collect()
}

/// Exactly one finding: its code, its place (between `«` and `»` in the text), words of its message
/// or its help.
#[track_caller]
fn one(code: Code, marked: &str, words: &str) {
    let start = marked.find('«').expect("a mark");
    let end = marked.find('»').expect("a mark") - '«'.len_utf8();
    let text = marked.replace(['«', '»'], "");
    let (_, diagnostics) = parsed(&text);
    let list: Vec<_> = diagnostics.iter().collect();
    let [finding] = list[..] else {
        panic!("{text}: {list:#?}");
    };
    assert_eq!(finding.code, code, "{text}: {finding:#?}");
    let primary = finding.primary.unwrap();
    assert_eq!(
        (primary.file, primary.range()),
        (FILE, start..end),
        "{text}: {finding:#?}"
    );
    let said = format!(
        "{}; {}",
        finding.message,
        finding.help.as_deref().unwrap_or("")
    );
    assert!(said.contains(words), "{text}: {said}");
    let mut sources = SourceMap::default();
    sources.add("a.sweep", text);
    assert!(render_text(finding, &sources, Style::Plain).contains(&finding.message));
}

/// The text after the fix of its only finding.
#[track_caller]
fn fixed(text: &str) -> String {
    let (_, diagnostics) = parsed(text);
    let list: Vec<_> = diagnostics.iter().collect();
    let [finding] = list[..] else {
        panic!("{text}: {list:#?}");
    };
    let fix = finding.fix.as_ref().expect("a fix");
    let mut text = text.to_owned();
    text.replace_range(fix.span.range(), &fix.text);
    text
}
