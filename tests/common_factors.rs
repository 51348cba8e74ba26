//! Common factors that were planted, found again exactly.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod support;

use serde_json::{Value, json};
use support::{compile, coprime, pairs, terms};

const QUARTER: &str = "profile p(u) in xz = ((1 - u^2) / (1 + u^2), 2u / (1 + u^2))\n";

type Terms<'a> = &'a [(usize, usize, i64)];

/// What is expected of a surface: its common factor and the bidegrees before and after.
struct Expected<'a> {
    factor: Terms<'a>,
    constructed: [(usize, usize); 4],
    reduced: [(usize, usize); 4],
}

fn listed(polynomial: Terms<'_>) -> Value {
    let terms: Vec<Value> = polynomial
        .iter()
        .map(|(i, j, c)| json!([i, j, c.to_string()]))
        .collect();
    Value::Array(terms)
}

/// Compiles a text and compares expansion and report with what was planted.
fn planted(text: &str, expected: &Expected<'_>) {
    let compiled = compile(text);
    let checked = compiled.surface();
    let expansion = checked.expansion();
    assert_eq!(expansion.common_factor, terms(expected.factor), "{text}");
    assert_eq!(
        pairs(expansion.constructed),
        expected.constructed.map(Some),
        "{text}"
    );
    assert_eq!(
        pairs(expansion.surface.bidegrees()),
        expected.reduced.map(Some),
        "{text}"
    );
    assert!(coprime(expansion.surface.coordinates()), "{text}");
    assert!(expansion.coprimality.is_some(), "{text}");
    let report = &compiled.report()["surfaces"][0];
    assert_eq!(
        report["common_factor"]["terms"],
        listed(expected.factor),
        "{text}"
    );
}

/// The same, with the reduced coordinates themselves.
fn reduced(text: &str, coordinates: [Terms<'_>; 4]) {
    let compiled = compile(text);
    let expansion = compiled.surface().expansion();
    assert_eq!(
        expansion.surface.coordinates(),
        &coordinates.map(terms),
        "{text}"
    );
}

/// Σ cₖ vᵏ integrated from 0, as text; the coefficients are those of the hodograph.
fn integral(hodograph: &[i64]) -> String {
    let term = |(power, c): (usize, &i64)| format!("({c}/{}) v^{}", power + 1, power + 1);
    let terms: Vec<String> = hodograph.iter().enumerate().map(term).collect();
    terms.join(" + ")
}

fn product(left: &[i64], right: &[i64]) -> Vec<i64> {
    let mut product = vec![0; left.len() + right.len() - 1];
    for (i, a) in left.iter().enumerate() {
        for (j, b) in right.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// The curve with r′ = h (a + ib)², by explicit polynomials.
fn explicit(h: &[i64], a: &[i64], b: &[i64]) -> String {
    let square = |own: &[i64]| product(own, own);
    let real: Vec<i64> = square(a)
        .iter()
        .zip(square(b))
        .map(|(a, b)| a - b)
        .collect();
    let imaginary: Vec<i64> = product(a, b).iter().map(|own| 2 * own).collect();
    let (x, y) = (product(h, &real), product(h, &imaginary));
    format!("sweep c(v) in xy = ({}, {})\n", integral(&x), integral(&y))
}

/// gcd(σ, x′, y′) = h for ω = 1 + v + i (2 − 3v), whose parts are coprime: m = 1.
#[test]
fn hodographs_that_are_not_primitive() {
    let cases: [(&[i64], Terms<'_>); 4] = [
        (&[1, 0, 1], &[(0, 0, 1), (0, 2, 1)]),
        (&[1, 2, 1], &[(0, 0, 1), (0, 1, 2), (0, 2, 1)]),
        (&[3, 1], &[(0, 0, 3), (0, 1, 1)]),
        (
            &[2, -1, 2, -1],
            &[(0, 0, 2), (0, 1, -1), (0, 2, 2), (0, 3, -1)],
        ),
    ];
    for (h, factor) in cases {
        let e = h.len() - 1;
        let text = format!(
            "{QUARTER}{}surface R = oriented_translation(p, c)",
            explicit(h, &[1, 1], &[2, -3])
        );
        let expected = Expected {
            factor,
            constructed: [(2, 2 + e), (2, 5 + 2 * e), (2, 5 + 2 * e), (1, 2 + e)],
            reduced: [(2, 2), (2, 5 + e), (2, 5 + e), (1, 2)],
        };
        planted(&text, &expected);
    }
}

/// A profile that is not in lowest terms: 1 + u divides W and X, Y, Z.
#[test]
fn profile_not_in_lowest_terms() {
    let text = "profile p(u) in xz = ((1 - u^2) (1 + u) / ((1 + u^2) (1 + u)), 2u (1 + u) / ((1 + u^2) (1 + u)))
        sweep c(v) in xy = ph(start: (0, 0), preimage: [(1, 2), (3, 1)])
        surface R = oriented_translation(p, c)";
    let expected = Expected {
        factor: &[(0, 0, 1), (1, 0, 1)],
        constructed: [(3, 2), (3, 5), (3, 5), (2, 2)],
        reduced: [(2, 2), (2, 5), (2, 5), (1, 2)],
    };
    planted(text, &expected);
}

/// Factors in both parameters at once: (2 + u)(v² + 1).
#[test]
fn factors_in_both_parameters() {
    let profile = "profile p(u) in xz = ((1 - u^2) (2 + u) / ((1 + u^2) (2 + u)), 2u (2 + u) / ((1 + u^2) (2 + u)))\n";
    let text = format!(
        "{profile}{}surface R = oriented_translation(p, c)",
        explicit(&[1, 0, 1], &[1, 1], &[2, -3])
    );
    let expected = Expected {
        factor: &[(0, 0, 2), (0, 2, 2), (1, 0, 1), (1, 2, 1)],
        constructed: [(3, 4), (3, 9), (3, 9), (2, 4)],
        reduced: [(2, 2), (2, 7), (2, 7), (1, 2)],
    };
    planted(&text, &expected);
}

/// x(u) = 0: all of σ = |1 + v + i (2 − v)|² = 5 − 2v + 2v² cancels and an extrusion is left.
#[test]
fn the_whole_speed() {
    let sweep = explicit(&[1], &[1, 1], &[2, -1]);
    let text =
        format!("profile p(u) in xz = (0, u)\n{sweep}surface R = oriented_translation(p, c)");
    let expected = Expected {
        factor: &[(0, 0, 5), (0, 1, -2), (0, 2, 2)],
        constructed: [(0, 2), (0, 4), (0, 5), (1, 2)],
        reduced: [(0, 0), (0, 2), (0, 3), (1, 0)],
    };
    planted(&text, &expected);
    // x′ = −3 + 6v, y′ = 4 + 2v − 2v²
    let extrusion: [Terms<'_>; 4] = [
        &[(0, 0, 3)],
        &[(0, 1, -9), (0, 2, 9)],
        &[(0, 1, 12), (0, 2, 3), (0, 3, -2)],
        &[(1, 0, 3)],
    ];
    reduced(&text, extrusion);
}

/// r′ = (1 + i(v − ½))² with c₀ = c₂ = 1, c₁ = 87/425: σ divides the scale.
#[test]
fn the_speed_divides_the_scale() {
    let text = "profile p(u) in xz = (u, 1 - u)
        sweep c(v) in xy = ph(start: (0, 0), preimage: [(1, -1/2), (1, 1/2)])
        surface R = conical_quadratic(p, c, 1, 87/425, 1)
        expect bidegree(R.W) == (0, 0)
        expect length(c) == 13/12";
    let expected = Expected {
        factor: &[(0, 0, 5), (0, 1, -4), (0, 2, 4)],
        constructed: [(0, 2), (1, 7), (1, 8), (1, 8)],
        reduced: [(0, 0), (1, 5), (1, 6), (1, 6)],
    };
    planted(text, &expected);
    let near = text
        .replace("87/425", "87/424")
        .replace("expect bidegree(R.W) == (0, 0)", "");
    let near = support::expand(&near).1;
    assert_eq!(near.common_factor, terms(&[(0, 0, 1)]));
}

/// A factor in u and v together: 1 + uv, once and twice.
#[test]
fn truly_bivariate() {
    let factor: Terms<'_> = &[(0, 0, 1), (1, 1, 1)];
    let text = "let f(u, v) = (1 + u v) / ((1 + u v) (1 + u))
        surface R = (u f(u, v), v f(u, v), (u - v) f(u, v))";
    let expected = Expected {
        factor,
        constructed: [(2, 1), (2, 1), (1, 2), (2, 2)],
        reduced: [(1, 0), (1, 0), (0, 1), (1, 1)],
    };
    planted(text, &expected);
    reduced(
        text,
        [
            &[(0, 0, 1), (1, 0, 1)],
            &[(1, 0, 1)],
            &[(0, 1, 1)],
            &[(1, 0, 1), (0, 1, -1)],
        ],
    );
    let text = "let f(u, v) = (1 + u v) / ((1 + u v)^2 (1 + u))
        surface R = (u f(u, v), (1 + u v) f(u, v), (u - v) f(u, v))";
    let expected = Expected {
        factor,
        constructed: [(3, 2), (2, 1), (2, 2), (2, 2)],
        reduced: [(2, 1), (1, 0), (1, 1), (1, 1)],
    };
    planted(text, &expected);
}

/// The least multiplicity counts: (v − 2)⁴ below, (v − 2)³ and (v − 2)² above.
#[test]
fn double_root() {
    let text = "surface R = (
            u (v - 2)^3 / ((v - 2)^4 (1 + v)),
            (v - 2)^2 / ((v - 2)^4 (1 + v)),
            u^2 (v - 2)^3 / ((v - 2)^4 (1 + v)))";
    let expected = Expected {
        factor: &[(0, 0, 4), (0, 1, -4), (0, 2, 1)],
        constructed: [(0, 5), (1, 3), (0, 2), (2, 3)],
        reduced: [(0, 3), (1, 1), (0, 0), (2, 1)],
    };
    planted(text, &expected);
    reduced(
        text,
        [
            &[(0, 0, 4), (0, 2, -3), (0, 3, 1)],
            &[(1, 0, -2), (1, 1, 1)],
            &[(0, 0, 1)],
            &[(2, 0, -2), (2, 1, 1)],
        ],
    );
}

/// Linearly dependent coordinates, and one that is zero, do not hide the factor.
#[test]
fn dependent_coordinates() {
    let text = "let f(v) = (1 + 3v) / ((1 + 3v) (2 + v))
        surface R = (u f(v), (v - 2u) f(v), 0)";
    let compiled = compile(text);
    let expansion = compiled.surface().expansion();
    assert_eq!(expansion.common_factor, terms(&[(0, 0, 1), (0, 1, 3)]));
    let plane: [Terms<'_>; 4] = [
        &[(0, 0, 2), (0, 1, 1)],
        &[(1, 0, 1)],
        &[(0, 1, 1), (1, 0, -2)],
        &[],
    ];
    reduced(text, plane);
    // 2x + 3y = z
    let text = "let d(u, v) = (1 + u) (2 + v)
        surface R = ((1 + u) / d(u, v), (1 + u) u / d(u, v), (1 + u) (2 + 3u) / d(u, v))";
    let expected = Expected {
        factor: &[(0, 0, 1), (1, 0, 1)],
        constructed: [(1, 1), (1, 0), (2, 0), (2, 0)],
        reduced: [(0, 1), (0, 0), (1, 0), (1, 0)],
    };
    planted(text, &expected);
}

/// ω = (v − a)² with a = 2 + i: |v − a|² = 5 − 4v + v² divides σ and H.
#[test]
fn evolute_with_a_double_root() {
    let text = format!(
        "{QUARTER}sweep c(v) in xy = ph(start: (0, 0), preimage: [(3, 4), (1, 3), (0, 2)])
        surface R = evolute_sweep(p, c)"
    );
    let expected = Expected {
        factor: &[(0, 0, 5), (0, 1, -4), (0, 2, 1)],
        constructed: [(2, 6), (2, 11), (2, 12), (1, 6)],
        reduced: [(2, 4), (2, 9), (2, 10), (1, 4)],
    };
    planted(&text, &expected);
    let plain = text.replace("(0, 2)]", "(0, 3)]");
    assert_eq!(
        compile(&plain).surface().expansion().common_factor,
        terms(&[(0, 0, 1)])
    );
}

/// What has no common factor says so.
#[test]
fn nothing_in_common() {
    let text = "surface R = (u / (1 + v), v / (1 + u), 1 / (2 + u v))";
    let expected = Expected {
        factor: &[(0, 0, 1)],
        constructed: [(2, 2), (3, 1), (1, 3), (1, 1)],
        reduced: [(2, 2), (3, 1), (1, 3), (1, 1)],
    };
    planted(text, &expected);
}

/// The independent check itself can tell.
#[test]
fn the_check_sees_factors() {
    let shared = |factor: Terms<'_>| {
        let of = |own: Terms<'_>| &terms(own) * &terms(factor);
        [
            of(&[(0, 0, 1), (1, 0, 1)]),
            of(&[(0, 0, 2), (0, 1, 1)]),
            of(&[(0, 0, 3), (1, 1, 1)]),
            of(&[]),
        ]
    };
    assert!(coprime(&shared(&[(0, 0, 7)])));
    assert!(!coprime(&shared(&[(0, 0, 1), (1, 0, 3)])));
    assert!(!coprime(&shared(&[(0, 0, 1), (0, 2, 3)])));
    assert!(!coprime(&shared(&[(0, 0, 1), (1, 1, 3)])));
}
