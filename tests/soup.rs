//! Anything at all through the whole compiler: it ends, every finding can be shown, and what is
//! proved to be sound can be written.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

use proptest::prelude::*;
use proptest::sample::select;
use sweepc::diag::{Diagnostics, Limits, SourceMap, Style, render_json, render_text};
use sweepc::export::{ALL, Exporter};
use sweepc::pipeline::{Options, compile};
use sweepc::report::{render_json as json_report, render_text as text_report};
use sweepc::syntax::{decode, parse};

/// Limits under which every text is done with in an instant.
fn limits() -> Limits {
    Limits {
        nesting: 32,
        digits: 20,
        exponent: 4,
        degree: 6,
        terms: 24,
        bits: 500,
        field_degree: 4,
        triangles: 200,
        ..Limits::default()
    }
}

/// Compiles a text and shows all there is to show; how many surfaces are sound.
fn swallow(text: &str) -> usize {
    let options = Options {
        limits: limits(),
        chord: Some(sweepc::number::Real::from(1)),
        ..Options::default()
    };
    let (mut sources, mut findings) = (SourceMap::default(), Diagnostics::default());
    let file = sources.add("soup.sweep", text);
    let document = parse(file, text, &options.limits, &mut findings);
    let compilation = compile(&mut sources, &[document], &options, findings);
    for finding in compilation.diagnostics.iter() {
        let places = finding.primary.into_iter();
        let places = places.chain(finding.related.iter().map(|(span, _)| *span));
        for span in places.chain(finding.fix.iter().map(|fix| fix.span)) {
            let source = &sources.file(span.file).text;
            assert!(source.get(span.range()).is_some(), "{text}\n{finding:?}");
        }
        assert!(render_text(finding, &sources, Style::Plain).contains(finding.code.as_str()));
        let json = render_json(finding, &sources);
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(json["code"], finding.code.as_str());
    }
    let report = compilation.report("soup.sweep", &sources);
    let json: serde_json::Value = serde_json::from_str(&json_report(&report).unwrap()).unwrap();
    let made = compilation.surfaces.iter().flatten().count();
    assert_eq!(json["surfaces"].as_array().unwrap().len(), made);
    assert_eq!(text_report(&report).is_empty(), made == 0);
    let formats: Vec<&Exporter> = ALL.iter().collect();
    let sound = compilation.sound_surfaces();
    sound
        .map(|surface| {
            let files = compilation.export(surface, &formats, "soup", &options);
            assert_eq!(files.count(), ALL.len());
        })
        .count()
}

const TOKENS: &[&str] = &[
    "param",
    "let",
    "profile",
    "sweep",
    "curve",
    "construction",
    "where",
    "surface",
    "expect",
    "import",
    "unit",
    "in",
    "on",
    "xy",
    "xz",
    "p",
    "c",
    "R",
    "a",
    "q'",
    "u",
    "v",
    "(u)",
    "(v)",
    "(u, v)",
    "i",
    "j",
    "k",
    "x(u)",
    "z(u)",
    "n(v)",
    "c.n(v)",
    "σ",
    "kappa",
    "ρ(v)",
    "s(1)",
    "0",
    "1",
    "2",
    "1/2",
    "0.25",
    "1e3",
    "\"a.sweep\"",
    "=",
    "==",
    "!=",
    "<",
    "+",
    "-",
    "*",
    "/",
    "^",
    "^2",
    "^-1",
    "(",
    ")",
    "[",
    "]",
    "[0, 1]",
    ",",
    ":",
    ".",
    ".x",
    ".W",
    "line",
    "bezier",
    "ph",
    "start:",
    "preimage:",
    "weights:",
    "dot",
    "cross",
    "norm2",
    "matrix",
    "sqrt",
    "du",
    "dv",
    "normal",
    "offset",
    "turn",
    "length",
    "bidegree",
    "regular",
    "rational_offset",
    "oriented_translation(p, c)",
    "canal_linear",
    "mm",
    "#",
    "\n",
    "\r\n",
    "\u{feff}",
    "’",
    "·",
    "×",
    "ς",
    "х",
    "\u{202e}",
    "\0",
    "∞",
];

/// A scalar expression, mostly sound.
fn scalar() -> impl Strategy<Value = String> + Clone {
    let leaf = select(
        &[
            "u", "v", "1", "2", "1/3", "0", "x(u)", "z(u)", "σ(v)", "s(v)", "κ(v)", "a",
        ][..],
    );
    let leaf = leaf.prop_map(str::to_owned).boxed();
    leaf.prop_recursive(3, 12, 2, |inner| {
        let joint = select(&[" + ", " - ", " * ", " / "][..]);
        prop_oneof![
            (inner.clone(), joint, inner.clone())
                .prop_map(|(left, joint, right)| format!("({left}{joint}{right})")),
            (inner.clone(), -2_i32..4).prop_map(|(base, power)| format!("({base})^({power})")),
            inner.clone().prop_map(|own| format!("sqrt({own})")),
            inner.clone().prop_map(|own| format!("du({own})")),
            inner.prop_map(|own| format!("dot(c(v), {own} n(v))")),
        ]
    })
    .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bytes_at_random(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Ok(text) = decode(&bytes, "soup.sweep", &limits()) {
            swallow(&text);
        }
    }

    #[test]
    fn characters_at_random(text in any::<String>()) {
        swallow(&text);
    }

    #[test]
    fn tokens_at_random(tokens in prop::collection::vec(select(TOKENS), 0..60)) {
        swallow(&tokens.join(" "));
    }

    #[test]
    fn declarations_at_random(
        curve in select(&["(v, 2v)", "(3v - v^3, 3v^2)", "line((0, 0), (3, 4))", "(v, v^2)", "(v^2, v^2)"][..]),
        (x, y, z) in (scalar(), scalar(), scalar()),
    ) {
        let text = format!(
            "let a = 1/2\nprofile p(u) in xz = (u, u^2 - 1)\nsweep c(v) in xy = {curve}\n\
             surface R = ({x}, {y}, {z})\nsurface Q = R(v, u)\nexpect regular(R)\nexpect R == Q\n"
        );
        swallow(&text);
    }
}

/// The soup is not so thin that nothing in it is a surface.
#[test]
fn a_sound_text_is_written() {
    assert_eq!(
        swallow("surface R = (u, v, u v)\nsurface Q = (u, v, 1 / (1 - v))"),
        1
    );
}
