//! Any bytes: a tree and findings whose places lie in the text and which can be shown.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sweepc::diag::{Diagnostics, Limits, SourceMap, Style, render_json, render_text};
use sweepc::syntax::{decode, parse};

fuzz_target!(|bytes: &[u8]| {
    let limits = Limits {
        nesting: 64,
        ..Limits::default()
    };
    let Ok(text) = decode(bytes, "fuzz.sweep", &limits) else {
        return;
    };
    let (mut sources, mut findings) = (SourceMap::default(), Diagnostics::default());
    let file = sources.add("fuzz.sweep", text.as_str());
    let document = parse(file, &text, &limits, &mut findings);
    for item in &document.items {
        assert!(text.get(item.span.range()).is_some(), "{:?}", item.span);
    }
    for finding in findings.iter() {
        let place = finding.primary.and_then(|own| text.get(own.range()));
        assert!(place.is_some(), "{finding:?}");
        assert!(!render_text(finding, &sources, Style::Coloured).is_empty());
        assert!(!render_json(finding, &sources).is_empty());
    }
});
