//! A text without errors of syntax: its layout keeps the tree, and the layout of a layout is
//! itself.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sweepc::diag::{Diagnostics, FileId, Limits};
use sweepc::pipeline::standard_library;
use sweepc::sema::Names;
use sweepc::syntax::{Formatter, Spelling, parse};

fuzz_target!(|text: &str| {
    let limits = Limits {
        nesting: 64,
        ..Limits::default()
    };
    let Some(formatted) = layout(text, Spelling::AsWritten, &limits) else {
        return;
    };
    assert_eq!(
        layout(&formatted, Spelling::AsWritten, &limits),
        Some(formatted)
    );
    let spelled = layout(text, Spelling::Ascii, &limits);
    let again = spelled
        .as_deref()
        .and_then(|own| layout(own, Spelling::Ascii, &limits));
    assert_eq!(again, spelled);
});

/// The canonical text; none if the text has errors.
fn layout(text: &str, spelling: Spelling, limits: &Limits) -> Option<String> {
    let mut findings = Diagnostics::default();
    let documents = [parse(FileId(0), text, limits, &mut findings)];
    if findings.has_errors() {
        return None;
    }
    let library = standard_library();
    let names = Names::of(&documents, &library);
    let formatter = Formatter {
        spelling,
        reading: &|name, declaration| names.reading(name, declaration),
        limits,
    };
    let formatted = formatter.format(&documents[0], text);
    assert!(
        formatted.is_some(),
        "the layout would change what the text says"
    );
    formatted
}
