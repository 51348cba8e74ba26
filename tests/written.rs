//! What is written in different ways means the same.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod support;

use support::{compile, expand};

/// Numbers and powers as one writes them, and what is wrong with some.
const NUMBERS: [&str; 8] = ["0", "1", "-1", "3", "0.5", "(-3/4)", "((7))", "(1/0)"];
const POWERS: [&str; 9] = [
    "u", "u^0", "u^1", "u^3", "u^(-2)", "u^(4/2)", "v", "u^(1/2)", "u^99999",
];

#[test]
fn a_monomial_is_the_product_of_its_factors_in_any_order() {
    let text = |term: &str| {
        format!(
            "profile p(u) on [1, 2] in xz = (u + {term}, u^5)\n\
             surface R on [1, 2] x [0, 1] = (x(u), v, z(u))"
        )
    };
    for number in NUMBERS {
        for power in POWERS {
            let terms = [
                format!("({number} * {power})"),
                format!("({number} {power})"),
                format!("({power} * ({number}))"),
            ];
            let codes = terms.each_ref().map(|own| compile(&text(own)).codes());
            assert!(codes[0] == codes[1] && codes[0] == codes[2], "{terms:?}");
            if codes[0].iter().any(|own| own.as_str().starts_with('E')) {
                continue;
            }
            let [first, other, turned] = terms.map(|own| expand(&text(&own)).1);
            for own in [other, turned] {
                assert_eq!(own.bound(), first.bound(), "{number} {power}");
                assert_eq!(own.constructed, first.constructed);
                assert_eq!(own.surface, first.surface);
            }
        }
    }
}
