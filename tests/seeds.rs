//! The published figures: generic bidegrees, Example 1, and degrees by counting.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod support;

use std::collections::HashMap;

use serde_json::Value;
use support::{Random, compile, coprime, expand, pairs};
use sweepc::net::ControlNet;

type Degrees = [Option<(usize, usize)>; 4];

const DEGREES: &str = include_str!("../seeds/farouki-nittler/degrees.json");
const EXAMPLES: &str = include_str!("../seeds/farouki-nittler/examples.json");
const QUARTER: &str = "profile p(u) in xz = ((1 - u^2) / (1 + u^2), 2u / (1 + u^2))\n";

/// A degree as the seeds write it: the largest of sums of products of symbols.
fn degree(list: &Value, symbols: &HashMap<char, i64>) -> usize {
    let product = |name: &str| -> i64 {
        if name == "1" {
            return 1;
        }
        name.chars().map(|own| symbols[&own]).product()
    };
    let sum = |terms: &Value| -> i64 {
        let terms = terms.as_object().unwrap().iter();
        terms
            .map(|(name, factor)| product(name) * factor.as_i64().unwrap())
            .sum()
    };
    let largest = list.as_array().unwrap().iter().map(sum).max().unwrap();
    usize::try_from(largest).unwrap()
}

/// The row of that name, for these values of its symbols.
fn row(name: &str, symbols: &[(char, i64)]) -> Degrees {
    let data: Value = serde_json::from_str(DEGREES).unwrap();
    let rows = data["generic"].as_array().unwrap();
    let row = rows.iter().find(|own| own["name"] == name).unwrap();
    let symbols = symbols.iter().copied().collect();
    ["W", "X", "Y", "Z"].map(|coordinate| {
        let own = &row[coordinate];
        (!own.is_null()).then(|| (degree(&own["u"], &symbols), degree(&own["v"], &symbols)))
    })
}

/// A profile and the degrees q, p, z of its homogeneous coordinates.
struct Profile {
    text: String,
    symbols: [(char, i64); 3],
}

fn profiles(random: &mut Random) -> Vec<Profile> {
    let quarter = Profile {
        text: QUARTER.to_owned(),
        symbols: [('q', 2), ('p', 2), ('z', 1)],
    };
    let mut list = vec![quarter];
    for degree in [2, 3] {
        let below = random.positive_polynomial(degree, "u");
        let (x, z) = (
            random.polynomial(degree, "u"),
            random.polynomial(degree, "u"),
        );
        let degree = i64::try_from(degree).unwrap();
        list.push(Profile {
            text: format!("profile p(u) in xz = ({x} / {below}, {z} / {below})\n"),
            symbols: [('q', degree), ('p', degree), ('z', degree)],
        });
    }
    let (x, z) = (random.polynomial(3, "u"), random.polynomial(3, "u"));
    list.push(Profile {
        text: format!("profile p(u) in xz = ({x}, {z})\n"),
        symbols: [('q', 0), ('p', 3), ('z', 3)],
    });
    list
}

/// Compares the reduced bidegrees of a text with a row.
fn agrees(name: &str, symbols: &[(char, i64)], text: &str) {
    let (_, expansion) = expand(text);
    let surface = expansion.surface;
    let expected = row(name, symbols);
    assert_eq!(
        pairs(surface.bidegrees()),
        expected,
        "{name} {symbols:?}\n{text}"
    );
    assert!(coprime(surface.coordinates()), "{name} {symbols:?}\n{text}");
}

/// A construction over every profile and PH curves with preimages of degree 1 to 4, from the
/// least degree on.
fn over_profiles(name: &str, least: usize, further: &[(char, i64)], surface: &str) {
    let mut random = Random(20_240_607);
    for m in least..=4 {
        for profile in profiles(&mut random) {
            let sweep = random.ph(m);
            let text = format!(
                "{}sweep c(v) in xy = {sweep}\nsurface R = {surface}",
                profile.text
            );
            let mut symbols = profile.symbols.to_vec();
            symbols.push(('m', i64::try_from(m).unwrap()));
            symbols.extend(further);
            agrees(name, &symbols, &text);
        }
    }
}

#[test]
fn oriented_translation() {
    over_profiles("oriented_translation", 1, &[], "oriented_translation(p, c)");
}

#[test]
fn oriented_involute() {
    over_profiles("oriented_involute", 1, &[], "oriented_involute(p, c)");
}

#[test]
fn evolute_sweep() {
    over_profiles("evolute_sweep", 2, &[], "evolute_sweep(p, c)");
}

#[test]
fn curvature_weighted() {
    let surface = "c(v) + (2/3 + 5/7 κ(v)) x(u) n(v) + z(u) k";
    over_profiles("curvature_weighted", 2, &[], surface);
}

#[test]
fn conical() {
    over_profiles("conical", 1, &[('k', 1)], "conical(p, c, 3/4, 7/5)");
    over_profiles(
        "conical",
        1,
        &[('k', 2)],
        "conical_quadratic(p, c, 3/4, 7/5, 8/3)",
    );
}

#[test]
fn turned_translation() {
    over_profiles(
        "turned_translation",
        1,
        &[('l', 1)],
        "turned_translation(p, c, 2/3 - 3/5 v)",
    );
    over_profiles(
        "turned_translation",
        1,
        &[('l', 2)],
        "turned_translation(p, c, (2/3 - v) / (7/5 + v + v^2))",
    );
}

#[test]
fn scaled_rotation() {
    let mut random = Random(5);
    for n in [1, 2, 3, 4, 6] {
        for profile in profiles(&mut random) {
            let (x, y) = (random.polynomial(n, "v"), random.polynomial(n, "v"));
            let text = format!(
                "{}sweep c(v) in xy = ({x}, {y})\nsurface R = scaled_rotation(p, c)",
                profile.text
            );
            let mut symbols = profile.symbols.to_vec();
            symbols.push(('n', i64::try_from(n).unwrap()));
            agrees("scaled_rotation", &symbols, &text);
        }
    }
}

#[test]
fn offset_translation() {
    let mut random = Random(77);
    for m in 1..=4_usize {
        for (l, k) in [(0, 1), (0, 2), (0, 3), (1, 1), (3, 2), (9, 1), (12, 2)] {
            let (in_u, in_v) = (random.polynomial(l, "u"), random.polynomial(k, "v"));
            let (name, distance) = if l == 0 {
                ("offset_translation", in_v)
            } else {
                let mixed = format!("{in_u} {in_v} + {}", random.number());
                ("offset_translation_two_parameters", mixed)
            };
            let text = format!(
                "profile p(u) in xy = {}\nsurface R = offset_translation(p, {distance})",
                random.ph(m)
            );
            let number = |own: usize| i64::try_from(own).unwrap();
            agrees(
                name,
                &[('m', number(m)), ('k', number(k)), ('l', number(l))],
                &text,
            );
        }
    }
}

/// The evolute is a curve: its points do not depend on u, and there is no Z.
#[test]
fn evolute() {
    let mut random = Random(1);
    for m in 2..=4 {
        let text = format!(
            "sweep c(v) in xy = {}\nsurface R = c(v) - ρ(v) n(v)",
            random.ph(m)
        );
        agrees("evolute", &[('m', i64::try_from(m).unwrap())], &text);
    }
}

#[test]
fn canal() {
    let mut random = Random(3);
    for m in 1..=4 {
        let text = format!(
            "{QUARTER}sweep c(v) in xy = {}\nsurface R = canal_linear(p, c, 5/2, 3/5, 4/5)",
            random.ph(m)
        );
        agrees("canal_linear", &[('m', i64::try_from(m).unwrap())], &text);
    }
}

fn example(number: u64) -> Value {
    let data: Value = serde_json::from_str(EXAMPLES).unwrap();
    let examples = data["examples"].as_array().unwrap();
    examples
        .iter()
        .find(|own| own["example"] == number)
        .unwrap()
        .clone()
}

fn rational(value: &Value) -> support::Q {
    value.as_str().unwrap().parse().unwrap()
}

/// Example 1: every printed term, up to one factor, and the printed control points.
#[test]
fn example_one() {
    let example = example(1);
    let lines: Vec<&str> = example["source"]
        .as_array()
        .unwrap()
        .iter()
        .map(|own| own.as_str().unwrap())
        .collect();
    let compiled = compile(&lines.join("\n"));
    let report = &compiled.report()["surfaces"][0];
    let printed = &example["printed"]["homogeneous"];
    let scale = rational(&report["homogeneous"]["W"]["terms"][0][2]);
    assert_eq!(rational(&printed["W"]["terms"][0][2]), support::q(1, 1));
    for coordinate in ["W", "X", "Y", "Z"] {
        let (own, paper) = (&report["homogeneous"][coordinate], &printed[coordinate]);
        assert_eq!(own["bidegree"], paper["bidegree"], "{coordinate}");
        let (own, paper) = (
            own["terms"].as_array().unwrap(),
            paper["terms"].as_array().unwrap(),
        );
        assert_eq!(own.len(), paper.len(), "{coordinate}");
        for (own, paper) in own.iter().zip(paper) {
            assert_eq!((&own[0], &own[1]), (&paper[0], &paper[1]));
            assert_eq!(
                rational(&own[2]),
                rational(&paper[2]) * &scale,
                "{coordinate}"
            );
        }
    }
    let unit = ("0".parse().unwrap(), "1".parse().unwrap());
    let coordinates = compiled.surface().surface().coordinates().each_ref();
    let net = ControlNet::bezier(coordinates, (&unit.0, &unit.1), (&unit.0, &unit.1)).unwrap();
    let expected = &example["derived"]["net"];
    assert_eq!((net.rows(), net.columns()), (3, 4));
    for (i, j) in (0..3).flat_map(|i| (0..4).map(move |j| (i, j))) {
        assert_eq!(
            support::plain(net.weight(i, j)),
            rational(&expected["weights"][i][j])
        );
        for (axis, own) in net.point(i, j).iter().enumerate() {
            assert_eq!(
                support::plain(own),
                rational(&expected["points"][i][j][axis])
            );
        }
    }
}

/// The exact degree report of Example 1.
#[test]
fn example_one_report() {
    let text = "profile p(u) in xz = ((1 - u^2) / (1 + u^2), 2u / (1 + u^2))
        sweep c(v) in xy = bezier([(1, 0), (1, 0.8), (0.8, 1), (0, 1)])
        surface R = scaled_rotation(p, c)";
    let report = &compile(text).report()["surfaces"][0];
    let four = serde_json::json!({"W": [2, 0], "X": [2, 3], "Y": [2, 3], "Z": [1, 0]});
    assert_eq!(report["as_constructed"], four);
    assert_eq!(
        report["common_factor"]["bidegree"],
        serde_json::json!([0, 0])
    );
    assert_eq!(report["patch"]["bidegree"], serde_json::json!([2, 3]));
    assert_eq!(report["patch"]["control_points"], serde_json::json!([3, 4]));
    let affine = serde_json::json!({
        "x": {"numerator": [2, 3], "denominator": [2, 0]},
        "y": {"numerator": [2, 3], "denominator": [2, 0]},
        "z": {"numerator": [1, 0], "denominator": [2, 0]},
    });
    assert_eq!(report["affine"], affine);
    assert_eq!(
        report["weights"],
        serde_json::json!({
            "positive": true, "min": "1", "max": "2",
            "certificate": {
                "bidegree": [2, 3],
                "rectangles": [{"u": ["0", "1"], "v": ["0", "1"]}],
            },
        })
    );
    let lengths = ["W", "X", "Y", "Z"].map(|own| {
        report["homogeneous"][own]["terms"]
            .as_array()
            .unwrap()
            .len()
    });
    assert_eq!(lengths, [2, 6, 6, 1]);
}

/// The quarter torus, by hand: (1 + u²)(1 + v²), (3 + u²)(1 − v²), 2v (3 + u²), 2u (1 + v²).
#[test]
fn quarter_torus() {
    let text = "profile p(u) in xz = ((3 + u^2) / (1 + u^2), 2u / (1 + u^2))
        sweep c(v) in xy = ((1 - v^2) / (1 + v^2), 2v / (1 + v^2))
        surface R = scaled_rotation(p, c)";
    let (_, expansion) = expand(text);
    let circle = [(0, 0, 1), (2, 0, 1), (0, 2, 1), (2, 2, 1)];
    let expected = [
        support::terms(&circle),
        support::terms(&[(0, 0, 3), (2, 0, 1), (0, 2, -3), (2, 2, -1)]),
        support::terms(&[(0, 1, 6), (2, 1, 2)]),
        support::terms(&[(1, 0, 2), (1, 2, 2)]),
    ];
    assert_eq!(expansion.surface.coordinates(), &expected);
}

/// What the paper prints for its examples is what counting gives; it errs in Z of Example 5.
#[test]
fn printed_degrees_are_counted() {
    let data: Value = serde_json::from_str(DEGREES).unwrap();
    let sweep = format!("sweep c(v) in xy = {}\n", Random(9).ph(2));
    let profile = format!("profile p(u) in xy = {}\n", Random(9).ph(2));
    let texts = [
        format!("{QUARTER}{sweep}surface R = oriented_translation(p, c)"),
        format!("{profile}surface R = offset_translation(p, v)"),
        format!("{profile}surface R = offset_translation(p, v^2 + 1)"),
        format!("{profile}surface R = offset_translation(p, 3v - 2v^2)"),
        format!("{QUARTER}{sweep}surface R = oriented_involute(p, c)"),
        format!("{QUARTER}{sweep}surface R = conical(p, c, 1, 1/2)"),
    ];
    let examples = data["examples"].as_array().unwrap();
    for (text, example) in texts.iter().zip(&examples[1..]) {
        let bound = pairs(expand(text).1.bound());
        for (coordinate, own) in ["W", "X", "Y", "Z"].iter().zip(bound) {
            let printed = &example[coordinate];
            let counted = if printed["verdict"] == "erratum" {
                serde_json::json!([2, 9])
            } else {
                printed["printed"].clone()
            };
            let own = own.unwrap();
            assert_eq!(
                serde_json::json!([own.0, own.1]),
                counted,
                "{coordinate}\n{text}"
            );
        }
    }
}

/// Counting over m: the involute's 4m + 1 is what cancellation lowers to 4m.
#[test]
fn counted_degrees() {
    let mut random = Random(8);
    for m in 1..=4_usize {
        let sweep = random.ph(m);
        let text =
            |surface: &str| format!("{QUARTER}sweep c(v) in xy = {sweep}\nsurface R = {surface}");
        let counted = |surface: &str| pairs(expand(&text(surface)).1.bound()).map(Option::unwrap);
        let plain = [(2, 2 * m), (2, 4 * m + 1), (2, 4 * m + 1), (2, 2 * m)];
        assert_eq!(counted("oriented_translation(p, c)"), plain);
        assert_eq!(counted("oriented_involute(p, c)"), plain);
        for (k, surface) in [
            (1, "conical(p, c, 2, 3)"),
            (2, "conical_quadratic(p, c, 2, 3, 5)"),
        ] {
            let high = 2 * m + k * (2 * m + 1);
            let expected = [(2, 2 * m), (2, high), (2, high), (2, high)];
            assert_eq!(counted(surface), expected, "k = {k}, m = {m}");
        }
        let constructed = expand(&text("oriented_involute(p, c)")).1.constructed;
        let lower = [(2, 2 * m), (2, 4 * m), (2, 4 * m), (1, 2 * m)];
        assert_eq!(pairs(constructed).map(Option::unwrap), lower);
    }
}
