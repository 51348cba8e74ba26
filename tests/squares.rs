//! Each sweep evaluated by three roads that must meet exactly: the formula itself, step by step;
//! the homogeneous coordinates that it expands to; and its control net.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod support;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use serde_json::Value;
use support::{Q, compile, coprime, lower, plain, rows, value};
use sweepc::curve::Interval;
use sweepc::diag::{Code, Limits};
use sweepc::net::ControlNet;
use sweepc::number::{Field, Real};
use sweepc::poly::{BiDegree, BiPoly};
use sweepc::sweep::{Expansion, SweptSurface, evaluate_slowly};

/// Numbers as text, with a taste for 0, 1 and −1.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        2 => Just("0".to_owned()),
        2 => Just("1".to_owned()),
        1 => Just("(-1)".to_owned()),
        3 => (-9_i64..=9, 1_i64..=5).prop_map(|(n, d)| format!("({n}/{d})")),
    ]
}

fn nonzero() -> impl Strategy<Value = String> {
    prop_oneof![
        Just("1".to_owned()),
        (1_i64..=9, 1_i64..=5).prop_map(|(n, d)| format!("({n}/{d})")),
        (1_i64..=9, 1_i64..=5).prop_map(|(n, d)| format!("(-{n}/{d})")),
    ]
}

/// Polynomials in a parameter, zero and constants among them.
fn polynomial(variable: &'static str, degree: usize) -> impl Strategy<Value = String> {
    prop::collection::vec(number(), 1..=degree + 1).prop_map(move |list| {
        let term = |(power, own): (usize, &String)| format!("{own} {variable}^{power}");
        let terms: Vec<String> = list.iter().enumerate().map(term).collect();
        format!("({})", terms.join(" + "))
    })
}

/// Profiles: lines, polynomials, fractions in lowest terms or not, weights of both signs.
fn profile() -> impl Strategy<Value = String> {
    let plain = (polynomial("u", 3), polynomial("u", 2)).prop_map(|(x, z)| format!("({x}, {z})"));
    let circle = Just("((1 - u^2) / (1 + u^2), 2u / (1 + u^2))".to_owned());
    let fraction =
        (polynomial("u", 2), polynomial("u", 2), nonzero(), nonzero()).prop_map(|(x, z, a, b)| {
            format!("({x} (1 + u) / ((1 + u) ({a} + {b} u)), {z} / ({a} + {b} u))")
        });
    let pair = (number(), number()).prop_map(|(x, z)| format!("({x}, {z})"));
    let weighted = (
        prop::collection::vec(pair, 3),
        prop::collection::vec(nonzero(), 3),
    )
        .prop_map(|(points, weights)| {
            format!(
                "bezier([{}], weights: [{}])",
                points.join(", "),
                weights.join(", ")
            )
        });
    prop_oneof![plain, circle, fraction, weighted]
        .prop_map(|curve| format!("profile p(u) in xz = {curve}\n"))
}

/// PH curves: lines, cusps, repeated roots of the preimage, hodographs that are not primitive.
fn ph(name: &'static str) -> impl Strategy<Value = String> {
    let random = (
        nonzero(),
        prop::collection::vec((number(), number()), 1..=3),
    )
        .prop_map(|(first, rest)| {
            let rest: Vec<String> = rest.iter().map(|(a, b)| format!("({a}, {b})")).collect();
            format!(
                "ph(start: (1, -2), preimage: [({first}, 1), {}])",
                rest.join(", ")
            )
        });
    let line =
        (number(), number()).prop_map(|(x, y)| format!("line(({x}, {y}), ({x} + 3, {y} - 4))"));
    let double = Just("ph(start: (0, 0), preimage: [(3, 4), (1, 3), (0, 2)])".to_owned());
    let factor = Just("(3 v + v^3, 4 v + 4/3 v^3)".to_owned());
    prop_oneof![5 => random, 1 => line, 1 => double, 1 => factor].prop_map(move |curve| {
        if name == "p" {
            format!(
                "profile p(u) in xy = {}\n",
                curve.replace("v^", "u^").replace(" v", " u")
            )
        } else {
            format!("sweep c(v) in xy = {curve}\n")
        }
    })
}

/// A sweep of the standard library over a profile and a PH curve.
fn construction() -> impl Strategy<Value = String> {
    let surface = prop_oneof![
        Just("oriented_translation(p, c)".to_owned()),
        Just("oriented_involute(p, c)".to_owned()),
        Just("evolute_sweep(p, c)".to_owned()),
        Just("scaled_rotation(p, c)".to_owned()),
        Just("translation(p, c)".to_owned()),
        Just("canal_linear(p, c, 5/2, 3/5, 4/5)".to_owned()),
        (nonzero(), number()).prop_map(|(a, b)| format!("conical(p, c, {a}, {b})")),
        (nonzero(), number(), nonzero())
            .prop_map(|(a, b, d)| format!("conical_quadratic(p, c, {a}, {b}, {d})")),
        polynomial("v", 1).prop_map(|h| format!("turned_translation(p, c, {h})")),
        polynomial("v", 2).prop_map(|q| format!("scaled_translation(p, c, {q})")),
    ];
    (profile(), ph("c"), surface).prop_map(|(p, c, surface)| format!("{p}{c}surface R = {surface}"))
}

/// The offset of a plane PH profile by a function of u and v.
fn offset() -> impl Strategy<Value = String> {
    let distance = prop_oneof![
        polynomial("v", 2),
        (polynomial("u", 1), polynomial("v", 1)).prop_map(|(a, b)| format!("({a} {b} - 1)")),
        polynomial("v", 1).prop_map(|b| format!("(1 / (2 + u v) + {b})")),
    ];
    (ph("p"), distance).prop_map(|(p, d)| format!("{p}surface R = offset_translation(p, {d})"))
}

/// What a formula is made of.
fn atom() -> impl Strategy<Value = String> {
    prop_oneof![
        number(),
        Just("u".to_owned()),
        Just("v".to_owned()),
        prop::sample::select(vec![
            "x(u)",
            "z(u)",
            "σ(v)",
            "s(v)",
            "κ(v)",
            "c(1 - v).x",
            "c'(v).y",
            "c''(1/2 v).x",
            "p.x(1 - u)",
            "p.x(v)",
            "c.s(u)",
            "c.σ(u v)",
            "c.κ(u + v)",
            "f(u)",
            "f(1 - v)",
            "f'(u v)",
            "g(u, v)",
            "g(v, u)",
            "g(1 - v, f(u))",
            "n(v).x",
            "t(v).y",
            "c.σ'(v)",
            "dot(n(v), c(v))",
            "length(c)",
            "f(f(u))",
        ])
        .prop_map(str::to_owned),
    ]
}

/// Formulas without a plan: derivatives, substitutions, compositions, properties, quotients.
fn formula() -> impl Strategy<Value = String> {
    let part = atom().prop_recursive(2, 6, 3, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} + {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} - {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} * {b})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("(({a}) / ({b}))")),
            inner.clone().prop_map(|a| format!("du({a})")),
            inner.clone().prop_map(|a| format!("dv({a})")),
            inner.prop_map(|a| format!("({a})^2")),
        ]
    });
    let functions = (polynomial("u", 2), nonzero(), polynomial("v", 1)).prop_map(|(f, a, g)| {
        format!("let f(u) = {f} / ({a} + u)\nlet g(u, v) = (u + {g}) / (1 + u v)\n")
    });
    let parts = (part.clone(), part.clone(), part);
    let domain = prop::sample::select(vec![
        "",
        "",
        " on [-1, 2] x [1/3, 4]",
        " on [1/2, 1] x [-2, -1]",
    ]);
    (profile(), ph("c"), functions, parts, domain).prop_map(
        |(p, c, functions, (x, y, z), domain)| {
            format!("{p}{c}{functions}surface R{domain} = ({x} + u, {y} + v, {z})")
        },
    )
}

/// Points inside the domain, on its edges, and outside.
fn point() -> impl Strategy<Value = (Real, Real)> {
    let at = || {
        prop_oneof![
            1 => Just(Real::from(0)),
            1 => Just(Real::from(1)),
            4 => (0_i64..=7, 7_i64..=11).prop_map(|(n, d)| Real::ratio(n.into(), d.into())),
            1 => (-7_i64..=7, 1_i64..=3).prop_map(|(n, d)| Real::ratio(n.into(), d.into())),
        ]
    };
    (at(), at())
}

fn inside(value: &Real, range: &Interval) -> bool {
    value >= range.start() && value <= range.end()
}

/// What may go wrong with a formula that was made up.
fn excused(code: Code) -> bool {
    matches!(code, Code::E0204 | Code::E0207 | Code::E0302 | Code::E0505)
}

/// The expansion of a text; none if it asks for what does not exist, like the evolute of a line.
fn expansion(text: &str) -> Option<(SweptSurface, Expansion)> {
    let (program, found) = lower(text);
    for finding in found.errors() {
        assert!(excused(finding.code), "{text}\n{finding:?}");
    }
    let surface = program.surfaces.first()?.clone();
    match Expansion::of(&surface, &Limits::default()) {
        Ok(expansion) => Some((surface, expansion)),
        Err(finding) => {
            assert!(excused(finding.code), "{text}\n{finding:?}");
            None
        }
    }
}

/// W, X, Y, Z evaluated in plain rationals.
fn homogeneous(coordinates: &[BiPoly<Real>; 4], u: &Q, v: &Q) -> [Q; 4] {
    coordinates.each_ref().map(|own| {
        let in_u: Vec<Q> = rows(own).iter().map(|row| value(row, v)).collect();
        value(&in_u, u)
    })
}

/// Compares the roads at points; the number of points at which the formula has a value.
fn roads_meet(
    text: &str,
    surface: &SweptSurface,
    expansion: &Expansion,
    points: &[(Real, Real)],
) -> u32 {
    let coordinates = expansion.surface.coordinates();
    let (in_u, in_v) = (&surface.domain.u, &surface.domain.v);
    let net = ControlNet::bezier(
        coordinates.each_ref(),
        (in_u.start(), in_u.end()),
        (in_v.start(), in_v.end()),
    );
    let corner = expansion
        .surface
        .weight()
        .evaluate(in_u.start(), in_v.start());
    assert_eq!(net.is_none(), corner.is_zero(), "{text}");
    let mut met = 0;
    for (u, v) in points {
        let [w, x, y, z] = homogeneous(coordinates, &plain(u), &plain(v));
        let own = (!w.is_zero()).then(|| [x, y, z].map(|own| own / &w));
        if let Some(slow) = evaluate_slowly(&surface.coordinates, u, v, &surface.tower) {
            met += 1;
            assert_eq!(Some(slow.map(|own| plain(&own))), own, "({u}, {v})\n{text}");
        }
        if let Some(net) = &net
            && inside(u, in_u)
            && inside(v, in_v)
        {
            let blended = net.de_casteljau(u, v).map(|own| own.map(|own| plain(&own)));
            assert_eq!(blended, own, "net at ({u}, {v})\n{text}");
        }
    }
    met
}

fn within(low: Option<BiDegree>, high: Option<BiDegree>) -> bool {
    match (low, high) {
        (None, _) => true,
        (Some(low), Some(high)) => low.u <= high.u && low.v <= high.v,
        (Some(_), None) => false,
    }
}

fn degrees_agree(text: &str, expansion: &Expansion) {
    let factor = expansion.common_factor.bidegree().unwrap();
    let reduced = expansion.surface.bidegrees();
    for (index, constructed) in expansion.constructed.iter().enumerate() {
        let (bound, reduced) = (expansion.bound()[index], reduced[index]);
        assert!(
            within(*constructed, bound),
            "{constructed:?} over {bound:?}\n{text}"
        );
        let sum = reduced.map(|own| BiDegree::new(own.u + factor.u, own.v + factor.v));
        assert_eq!(sum, *constructed, "{text}");
    }
    assert!(coprime(expansion.surface.coordinates()), "{text}");
    assert!(expansion.coprimality.is_some(), "{text}");
}

/// W is positive at the first corner, or begins with a positive term if it vanishes there, and the
/// coefficients are coprime integers.
fn is_normal(text: &str, surface: &SweptSurface, expansion: &Expansion) {
    let all = expansion.surface.coordinates().each_ref().map(rows);
    let mut common = BigInt::zero();
    for own in all.iter().flatten().flatten() {
        assert!(own.is_integer(), "{text}");
        common = common.gcd(own.numer());
    }
    assert!(common.is_one(), "{text}");
    let (u, v) = (surface.domain.u.start(), surface.domain.v.start());
    let [corner, ..] = homogeneous(expansion.surface.coordinates(), &plain(u), &plain(v));
    let term = all[0].iter().flatten().find(|own| !own.is_zero()).unwrap();
    let leading = if corner.is_zero() { term } else { &corner };
    assert!(leading.is_positive(), "W begins with {leading}\n{text}");
}

/// A fixed number of cases, the same in every run; most of them must say something.
fn for_all(cases: u32, texts: impl Strategy<Value = String>, least: u32) {
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let (sound, values) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    let cases = (texts, prop::collection::vec(point(), 4));
    let outcome = TestRunner::new_with_rng(config, rng).run(&cases, |(text, points)| {
        if let Some((surface, expansion)) = expansion(&text) {
            sound.set(sound.get() + 1);
            let met = roads_meet(&text, &surface, &expansion, &points);
            values.set(values.get() + met);
            degrees_agree(&text, &expansion);
            is_normal(&text, &surface, &expansion);
        }
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
    assert!(
        sound.get() >= least,
        "only {} cases were sound",
        sound.get()
    );
    assert!(
        values.get() >= 2 * least,
        "only {} values were compared",
        values.get()
    );
}

#[test]
fn constructions() {
    for_all(160, construction(), 120);
}

#[test]
fn offsets() {
    for_all(80, offset(), 70);
}

#[test]
fn formulas() {
    for_all(160, formula(), 100);
}

fn json_value(polynomial: &Value, u: &Q, v: &Q) -> Q {
    let power = |base: &Q, exponent: &Value| {
        let exponent = usize::try_from(exponent.as_u64().unwrap()).unwrap();
        num_traits::pow(base.clone(), exponent)
    };
    let terms = polynomial["terms"].as_array().unwrap().iter();
    terms.fold(Q::zero(), |sum, term| {
        let coefficient: Q = term[2].as_str().unwrap().parse().unwrap();
        sum + coefficient * power(u, &term[0]) * power(v, &term[1])
    })
}

/// The report as a reader of its JSON sees it: the same point, the same degrees.
#[test]
fn reports() {
    let config = Config {
        cases: 24,
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let cases = (prop_oneof![construction(), offset()], point());
    let outcome = TestRunner::new_with_rng(config, rng).run(&cases, |(text, (u, v))| {
        let Some((surface, _)) = expansion(&text) else {
            return Ok(());
        };
        let compiled = compile(&text);
        if compiled.codes().contains(&Code::E0302) {
            return Ok(());
        }
        let report = &compiled.report()["surfaces"][0];
        let own = ["W", "X", "Y", "Z"]
            .map(|own| json_value(&report["homogeneous"][own], &plain(&u), &plain(&v)));
        if let Some(slow) = evaluate_slowly(&surface.coordinates, &u, &v, &surface.tower) {
            for (coordinate, slow) in own[1..].iter().zip(&slow) {
                assert_eq!(coordinate / &own[0], plain(slow), "{text}");
            }
        }
        let patch = &report["patch"];
        for axis in 0..2 {
            let degree = ["W", "X", "Y", "Z"].map(|own| {
                report["homogeneous"][own]["bidegree"][axis]
                    .as_u64()
                    .unwrap_or(0)
            });
            let degree = degree.into_iter().max().unwrap();
            assert_eq!(patch["bidegree"][axis].as_u64(), Some(degree), "{text}");
            assert_eq!(
                patch["control_points"][axis].as_u64(),
                Some(degree + 1),
                "{text}"
            );
        }
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

#[test]
fn a_root_counts_half_of_its_radicand() {
    let curve = "sweep c(v) in xy = ph(start: (0, 0), preimage: [(2, 2), (2, 1)])\nsurface R = ";
    let bound =
        |formula: &str| support::pairs(support::expand(&format!("{curve}{formula}\n")).1.bound());
    let speed = bound("c(v) + (u / σ(v)) k");
    assert_eq!(bound("c(v) + (u / sqrt(norm2(c'(v)))) k"), speed);
    assert_eq!(
        speed,
        [Some((0, 2)), Some((0, 5)), Some((0, 5)), Some((1, 0))]
    );
    // Three times (1, 3), once for all coordinates of the normal.
    let offset = bound("offset(c(v) + u k, 1)");
    assert_eq!(
        offset,
        [Some((3, 9)), Some((3, 12)), Some((3, 12)), Some((4, 9))]
    );
}
