//! Any text through all stages, under limits so small that a run is short.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sweepc::diag::{Diagnostics, Limits, SourceMap, Style, render_text};
use sweepc::export::{ALL, Exporter};
use sweepc::pipeline::{Options, compile};
use sweepc::report::{render_json, render_markdown, render_text as render_report};
use sweepc::syntax::parse;

fuzz_target!(|text: &str| {
    let limits = Limits {
        nesting: 48,
        digits: 20,
        exponent: 6,
        degree: 8,
        terms: 40,
        bits: 1_000,
        field_degree: 4,
        ..Limits::default()
    };
    let options = Options {
        limits,
        ..Options::default()
    };
    let (mut sources, mut findings) = (SourceMap::default(), Diagnostics::default());
    let file = sources.add("fuzz.sweep", text);
    let document = parse(file, text, &limits, &mut findings);
    let compilation = compile(&mut sources, &[document], &options, findings);
    for finding in compilation.diagnostics.iter() {
        assert!(!render_text(finding, &sources, Style::Plain).is_empty());
    }
    let report = compilation.report("fuzz.sweep", &sources);
    assert!(render_json(&report).is_ok());
    let _ = (render_report(&report), render_markdown(&report));
    let formats: Vec<&Exporter> = ALL.iter().collect();
    for surface in compilation.sound_surfaces() {
        for (format, result) in compilation.export(surface, &formats, "fuzz", &options) {
            if let Ok(exported) = result {
                assert!(!exported.bytes.is_empty(), "{}", format.name);
            }
        }
    }
});
