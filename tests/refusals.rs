//! What the compiler refuses or warns of, in the terms of the curve or surface it is about.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod support;

use support::compile;

const PROFILE: &str = "profile p(u) in xz = (u, u^2)\n";

/// The findings of a text are exactly these codes, and what is printed says all of this.
fn says(text: &str, codes: &[&str], parts: &[&str]) {
    let compiled = compile(text);
    let printed = compiled.all();
    let found: Vec<&str> = compiled.codes().iter().map(|own| own.as_str()).collect();
    assert_eq!(found, codes, "{text}\n{printed}");
    for part in parts {
        assert!(printed.contains(part), "no `{part}` in\n{printed}");
    }
}

/// A sweep whose only property of the curve is the one in the formula.
fn sweep(curve: &str, formula: &str) -> String {
    format!("{PROFILE}sweep c(v) {curve}\nsurface R = {formula}")
}
