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

/// Sums of powers as one writes them, in `#`.
const SUMS: [&str; 11] = [
    "1 - (3/4) # + 2 #^3",
    "-#^2/2 + # - 5",
    "#^2/3 * 2 + 0 #^5 + 0.5",
    "#^3 + # - #^3",
    "# - #",
    "#^0 + 3",
    "# + 2 # - 1/7 #",
    "3 #^2 * 4 - #^1 * (-2)",
    "# # + 1",
    "1 + #^(-1)",
    "# + (1/0)",
];

/// A power of a parameter in parentheses is no written polynomial; its value is the same.
#[test]
fn a_sum_of_powers_is_the_sum_of_its_terms() {
    let text = |sum: &str, of: &str| {
        format!(
            "let f(v) = {sum}\n\
             surface R on [1, 2] x [1, 2] = ({of}, v + 3 u, u^5)"
        )
    };
    let mut compared = 0;
    for sum in SUMS {
        for of in ["f(v)", "f(u)", "f(1 - v/3)", "f'(v) u", "f(2)"] {
            let roads = ["v", "(v)"].map(|by| text(&sum.replace('#', by), of));
            let codes = roads.each_ref().map(|text| compile(text).codes());
            assert_eq!(codes[0], codes[1], "{}", roads[0]);
            if codes[0].iter().any(|own| own.as_str().starts_with('E')) {
                continue;
            }
            compared += 1;
            let [own, other] = roads.each_ref().map(|text| expand(text).1);
            assert_eq!(own.bound(), other.bound(), "{}", roads[0]);
            assert_eq!(own.constructed, other.constructed, "{}", roads[0]);
            assert_eq!(own.surface, other.surface, "{}", roads[0]);
        }
    }
    assert!(compared > 40, "{compared}");
}

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
