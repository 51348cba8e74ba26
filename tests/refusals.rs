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

const TRANSLATION: &str = "c(v) + x(u) n(v) + z(u) k";

#[test]
fn not_pythagorean() {
    // ‖c′‖² = 1 + 4v²
    says(
        &sweep("in xy = (v, v^2)", TRANSLATION),
        &["E0201"],
        &[
            "`c` is not a Pythagorean-hodograph curve",
            "an odd number of times: 4 v^2 + 1",
            ":3:25",
        ],
    );
    // ‖c′‖² = v² (4 + 9v²): only the odd part is shown
    says(
        &sweep("in xy = (v^2, v^3)", TRANSLATION),
        &["E0201"],
        &["an odd number of times: 9 v^2 + 4\n"],
    );
    // in the curve's own parameter
    says(
        "profile p(u) in xy = (u, u^2)\nsurface R = offset_translation(p, v)",
        &["E0201"],
        &["‖p′‖² has this factor an odd number of times: 4 u^2 + 1"],
    );
}

/// Told at the value. What the degrees are is for the author to say, so there is no edit.
#[test]
fn a_bidegree_compares_with_a_pair() {
    let scalar = "a bidegree compares with a pair, and this is a scalar";
    let degrees = "= help: write `bidegree(R) == (m, n)`, the degree in u before that in v";
    let claims: [(&str, &[&str]); 7] = [
        ("bidegree(R) == 1", &[scalar, ":2:23", degrees]),
        (
            "1 != bidegree(R.W)",
            &[scalar, ":2:8", "= help: write `(m, n) != bidegree(R.W)`"],
        ),
        ("bidegree(R) < 2", &[scalar, ":2:22", degrees]),
        ("bidegree(R) == u", &[scalar, ":2:23", degrees]),
        (
            "bidegree(R) == (1, 1, 1)",
            &["and this is a vector", degrees],
        ),
        (
            "common_factor(R) == (1, 1)",
            &[
                "a common factor compares with a polynomial, and this is a pair",
                "= help: write `common_factor(R) == 1`, or a polynomial in place of the `1`",
            ],
        ),
        (
            "bidegree(R) == common_factor(R)",
            &["a bidegree does not compare with a common factor"],
        ),
    ];
    for (claim, parts) in claims {
        let text = format!("surface R = (u, v, u v)\nexpect {claim}");
        says(&text, &["E0106"], parts);
    }
}

#[test]
fn arc_length_of_a_circle() {
    // σ = 2/(1 + v²)
    says(
        &sweep(
            "in xy = ((1 - v^2) / (1 + v^2), 2v / (1 + v^2))",
            "c(v) + s(v) x(u) k",
        ),
        &["E0203"],
        &[
            "the arc length of `c` is not a rational function",
            "from the poles v^2 + 1 = 0",
        ],
    );
}

#[test]
fn infinite_arc_length() {
    says(
        &sweep("in xy = (1 / (2v - 1), 0)", "c(v) + s(v) x(u) k"),
        &["E0203"],
        &[
            "the arc length of `c` is infinite on its domain",
            "σ has a pole at v = 1/2",
        ],
    );
}

#[test]
fn curvature_radius_of_a_line() {
    says(
        &sweep("in xy = line((0, 0), (3, 4))", "c(v) + ρ(v) n(v) + x(u) k"),
        &["E0207"],
        &["`c` is a straight line: its curvature is zero"],
    );
}

#[test]
fn no_motion() {
    says(
        &sweep("in xy = (1, 2)", TRANSLATION),
        &["E0204"],
        &["`c` is constant"],
    );
}

#[test]
fn domains() {
    says(
        &sweep("in xy on [1, 1] = (v, 0)", TRANSLATION),
        &["E0205"],
        &["the domain [1, 1] is empty", "2:21"],
    );
    says(
        &sweep("in xy on [2, 1/2] = (v, 0)", TRANSLATION),
        &["E0205"],
        &["the domain [2, 1/2] is reversed"],
    );
}

#[test]
fn hodograph_that_changes_sign() {
    // c′ = (3v − 2) (v, 0)
    says(
        &sweep("in xy = (v^3 - v^2, 0)", TRANSLATION),
        &["E0202"],
        &["`c`", "the factor 3 v - 2 changes sign at v = 2/3"],
    );
    // c′ = (v² − 1/2, 0); 181/256 < √2/2 < 725/1024
    says(
        &sweep("in xy = (v^3/3 - v/2, 0)", TRANSLATION),
        &["E0202"],
        &["the factor 2 v^2 - 1 changes sign at v in [181/256, 725/1024]"],
    );
    // beyond the domain there is nothing wrong with it
    says(
        &sweep("in xy on [1, 2] = (v^3 - v^2, 0)", TRANSLATION),
        &[],
        &[],
    );
}

#[test]
fn the_field_grows_up_to_a_limit() {
    // the speed of (v, v) is √2, and six more square roots of primes make the degree 128
    let roots = ["3", "5", "7", "11", "13", "17"].map(|prime| format!("sqrt({prime})"));
    let wide = format!("({}) i + {TRANSLATION}", roots.join(" + "));
    let codes = &["E0509"];
    says(&sweep("in xy = (v, v)", TRANSLATION), &[], &[]);
    says(
        &sweep("in xy = (v, v)", &wide),
        codes,
        &[
            "the parametric speed of `c` needs √(2)",
            "`--max-field-degree`",
        ],
    );
    let sum = format!("let a = sqrt(2) + {}\n", roots.join(" + "));
    says(
        &format!("{sum}surface R = (u, v, a)"),
        codes,
        &["√(17) would make the degree of the number field greater than 64"],
    );
}

#[test]
fn normal_of_a_spatial_curve() {
    says(
        &sweep("= (v, v^2, v^3)", TRANSLATION),
        &["E0206"],
        &[
            "`c` is not given in a coordinate plane",
            "one in space has x, y, z",
        ],
    );
}

#[test]
fn poles() {
    let at = |formula: &str, places: &[&str]| {
        says(
            &format!("surface R = (u, v, {formula})"),
            &["E0301"],
            &["`R` has a pole"],
        );
        let places: Vec<String> = places
            .iter()
            .map(|own| format!("W = 0 at {own}\n"))
            .collect();
        let places: Vec<&str> = places.iter().map(String::as_str).collect();
        says(
            &format!("surface R = (u, v, {formula})"),
            &["E0301"],
            &places,
        );
    };
    at("1 / (3u - 1)", &["u = 1/3"]);
    at("1 / (2v^2 - 1)", &["v in [181/256, 725/1024]"]);
    at("1 / (1 - v)", &["v = 1"]);
    at("1 / u", &["u = 0"]);
    at("u / (u + v)", &["u = 0, v = 0"]);
    at("1 / ((3u - 1)^2 + (2v - 1)^2)", &["u = 1/3, v = 1/2"]);
    at("1 / ((3u - 1) (1 - 2v)^2)", &["u = 1/3", "v = 1/2"]);
    says("surface R = (u, v, 1 / (3u - 4) + 1 / (1 + v))", &[], &[]);
    says(
        "surface R = (u, v, (3u - 1) v / (3u - 1))",
        &["W1004"],
        &["numerators and denominator of `R` are all zero on the line u = 1/3"],
    );
    says(
        "surface R = (u, v, (3u - 1) (2v - 1) v / ((3u - 1) (2v - 1)))",
        &["W1004"],
        &["`R` are all zero on the lines u = 1/3, v = 1/2"],
    );
    says(
        "surface R = (u, v, (u - v) v / (u - v))",
        &["W1004"],
        &["`R` are all zero where -u + v = 0, as at u = 0, v = 0"],
    );
}

/// The report names the pole by rational bounds, and writes no less of the rest.
#[test]
fn poles_in_the_report() {
    let report = compile("surface R = (u, v, 1 / (2v^2 - 1))").report();
    let surface = &report["surfaces"][0];
    let pole = serde_json::json!({"kind": "v", "u": ["0", "1"], "v": ["181/256", "725/1024"]});
    assert_eq!(surface["poles"], serde_json::json!([pole]));
    assert_eq!(
        surface["homogeneous"]["W"]["bidegree"],
        serde_json::json!([0, 2])
    );
}

#[test]
fn square_roots() {
    let root = |radicand: &str, code: &str, parts: &[&str]| {
        says(
            &format!("surface R = (u, v, sqrt({radicand}))"),
            &[code],
            parts,
        );
    };
    root(
        "(1 + u)^2 (1 + v^2)",
        "E0210",
        &["an odd number of times: v^2 + 1\n"],
    );
    root("3 u^2 + u^3", "E0210", &["an odd number of times: u + 3\n"]);
    root(
        "(2u - 1)^2",
        "E0210",
        &["does not keep its sign on the domain", "u = 1/2"],
    );
    root("-2", "E0210", &["the square root of a negative number"]);
    says("surface R = (u, v, sqrt(2 (u + 1)^2))", &[], &[]);
    says("surface R = (u, v, sqrt((u + 1)^2 (v + 2)^4))", &[], &[]);
}

#[test]
fn translations_are_singular_where_profile_and_curve_are_parallel() {
    let surface = |preimage: &str| {
        format!(
            "profile p(u) in xz = (u, u - u^3)
sweep c(v) in xy = ph(start: (0, 0), preimage: [{preimage}])
surface R = c(v) + 1/2 n(v) + (x(u), 0, z(u))"
        )
    };
    // z′ = 0 at u = 1/√3, and the curve runs along x at v = 1/2, or nowhere.
    says(
        &surface("(3, 1), (3, -1)"),
        &["W1011"],
        &["R_u × R_v is zero at u in [591/1024, 37/64], v = 1/2"],
    );
    let regular = surface("(3, 1), (3, 2)") + "\nexpect regular(R)";
    says(&regular, &[], &[]);
}

#[test]
fn cusps_and_shared_zeros_are_warnings() {
    // w = 1 − 2v
    says(
        &sweep(
            "in xy = ph(start: (0, 0), preimage: [(1, 0), (-1, 0)])",
            TRANSLATION,
        ),
        &["W1003", "W1011"],
        &[
            "`c` has a cusp: σ vanishes at v = 1/2",
            "2:7",
            "`R` is not regular: R_u × R_v is zero at v = 1/2",
        ],
    );
    says(
        &sweep(
            "in xy = ph(start: (0, 0), preimage: [(1, 0), (2, 0)])",
            TRANSLATION,
        ),
        &[],
        &[],
    );
    says(
        "profile p(u) in xz = (u (2u - 1) / ((2u - 1) (1 + u)), (2u - 1) / ((2u - 1) (1 + u)))
sweep c(v) in xy = (v, 0)
surface R = p(u) + c(v) + v^2 j",
        &["W1004"],
        &["`p` are all zero at u = 1/2"],
    );
}

#[test]
fn folds_and_coordinates_that_are_always_zero_are_warnings() {
    // κ = −1 for the clockwise unit circle, so 1 + κ x = 0 at x = 1, here at u = 1/2
    says(
        "profile p(u) in xz = (2u, u)
sweep c(v) in xy = (2v / (1 + v^2), (1 - v^2) / (1 + v^2))
surface R = c(v) + x(u) n(v) + z(u) k",
        &["W1011"],
        &["R_u × R_v is zero at u = 1/2"],
    );
    // A collapsed side is no fold; one along which the surface stops is.
    says("surface R = (u v, u (1 - v), 0)", &[], &[]);
    says(
        "surface R = (v^2, v^3, u)",
        &["W1011"],
        &["R_u × R_v is zero at v = 0"],
    );
    says("surface R = (u v^2 / (1 + u), v^2, v^3)", &[], &[]);
    says(
        "profile p(u) in xy = (u, 1)
sweep c(v) in xy = (v, 0)
surface R = c(v) + x(u) n(v) + (u^2 + z(u)) k",
        &["W1010"],
        &[
            "`z` of `p` is 0 everywhere",
            "`p` has the coordinates x and y",
        ],
    );
}

#[test]
fn properties_that_need_a_name() {
    let profiles = "profile p(u) in xz = (u, 1)\nprofile q(u) in xz = (1, u)\n";
    let curve = "sweep c(v) in xy = (v, 0)\n";
    says(
        &format!("{profiles}{curve}surface R = c(v) + x(u) n(v)"),
        &["E0105"],
        &["the file has 2 profiles", "write `p.x(…)` or `q.x(…)`"],
    );
    says(
        &sweep("in xy = (v, 0)", "c(v) + x(u v) n(v)"),
        &["E0105"],
        &["depends on u and v", ".x(…)`"],
    );
    says(
        &sweep("in xy = (v, 0)", "c(v) + x(u) k + κ(1) i"),
        &["E0105"],
        &["is constant", "write `c.κ(…)`"],
    );
    says(
        "surface R = (x(u), u, v)",
        &["E0105"],
        &["`x` needs a profile"],
    );
    says(
        &format!(
            "construction mine(p, c) = c(v) + x(u) c.n(v)\n{PROFILE}{curve}surface R = mine(p, c)"
        ),
        &["E0105"],
        &["inside a construction `x` needs its curve's name"],
    );
}

/// What a construction needs is reported where it is used, and shown where it is needed.
#[test]
fn properties_inside_a_construction() {
    says(
        &sweep("in xy = (v, v^2)", "oriented_translation(p, c)"),
        &["E0201"],
        &[
            "test.sweep:3:13",
            "surface R = oriented_translation(p, c)",
            "`oriented_translation` needs `c.n(v)` here",
        ],
    );
    let own = "construction outer(a, b) = evolute_sweep(a, b)\n";
    says(
        &format!(
            "{own}{}",
            sweep("in xy = line((0, 0), (0, 1))", "outer(p, c)")
        ),
        &["E0207"],
        &[
            "test.sweep:4:13",
            "`c` is a straight line",
            "`evolute_sweep` needs `c.ρ(v)` here",
        ],
    );
}

#[test]
fn roots_keep_their_sign() {
    // Roots that vanish at a corner, along a touching line or not at all are sound.
    for root in ["(u^2 + v^2)^2", "(u - v)^4", "(u + v)^2", "(1 + u v)^2"] {
        says(&format!("surface R = (u, v, sqrt({root}))"), &[], &[]);
    }
    let same = "surface R = (u, v, sqrt((1 + u v)^2))\nexpect R == (u, v, 1 + u v)";
    says(same, &[], &[]);
    for (root, codes) in [("(u - v)^2", ["E0210"]), ("(u + v^2 - 1/2)^2", ["E0210"])] {
        let text = format!("surface R = (u, v, sqrt({root}))");
        says(&text, &codes, &["does not keep its sign"]);
    }
    // A root has the sign of the place where it is used, and a surface that of its own domain.
    let root = "let f(v) = sqrt((v - 2)^2)\nsurface R = (u, v, 0)\n";
    says(
        &format!("{root}expect f(v + 2) == v\nexpect f(v) == 2 - v"),
        &[],
        &[],
    );
    let differentiated = format!("{root}expect f'(v + 2) == 1");
    says(&differentiated, &["E0210"], &["is not decided here"]);
    let elsewhere = "surface Q on [0, 1] x [3, 4] = (u, v, sqrt((v - 2)^2))
surface P = Q(u, v)
expect P == (u, v, v - 2)";
    says(elsewhere, &[], &[]);
    let normals = "surface N on [0, 1] x [-2, -1] = (u, v^2, 0)
surface Z on [0, 1] x [1, 2] = offset(N, 1)
expect Z == (u, v^2, -1)";
    says(normals, &[], &[]);
}

#[test]
fn a_bidegree_is_two_numbers() {
    for pair in ["(u, 1)", "(1/2, v)"] {
        says(
            &format!("surface R = (u, v, 0)\nexpect bidegree(R.Z) == {pair}"),
            &["E0108"],
            &[],
        );
    }
}

#[test]
fn a_sign_before_a_product_belongs_to_its_first_factor() {
    let claims = [
        "1 / a (3) == 3/2",
        "1 / -a (3) == -3/2",
        "-a (3) == -6",
        "2 - -a (3)^2 == 20",
    ];
    let claims = claims.map(|own| format!("expect {own}\n"));
    let text = format!("let a = 2\nsurface R = (u, v, 1)\n{}", claims.concat());
    says(&text, &[], &[]);
}
