//! Surfaces whose files are known to be hard for readers.

#![allow(
    dead_code,
    clippy::unwrap_used,
    missing_docs,
    unreachable_pub,
    reason = "test data, shared by several test files"
)]

use serde_json::Value;
use sweepc::net::{ControlNet, Knots};
use sweepc::number::{Field, Real};
use sweepc::poly::{BiPoly, UniPoly};

pub fn number(text: &str) -> Real {
    text.parse().unwrap()
}

/// The polynomial of ascending coefficients.
pub fn poly(coefficients: &str) -> UniPoly<Real> {
    let coefficients: Vec<_> = coefficients.split_whitespace().map(number).collect();
    UniPoly::from_coefficients(&coefficients)
}

/// Σ f(u) g(v) of pairs of ascending coefficients.
pub fn sum(terms: &[(&str, &str)]) -> BiPoly<Real> {
    let terms = terms
        .iter()
        .map(|(in_u, in_v)| BiPoly::product(&poly(in_u), &poly(in_v)));
    terms.fold(BiPoly::zero(), |all, own| &all + &own)
}

/// The patch of W, X, Y, Z on [0, 1]².
pub fn patch(coordinates: &[BiPoly<Real>; 4]) -> ControlNet {
    on(coordinates, ("0", "1"), ("0", "1"))
}

pub fn on(coordinates: &[BiPoly<Real>; 4], u: (&str, &str), v: (&str, &str)) -> ControlNet {
    let (u, v) = ((number(u.0), number(u.1)), (number(v.0), number(v.1)));
    ControlNet::bezier(coordinates.each_ref(), (&u.0, &u.1), (&v.0, &v.1)).unwrap()
}

/// A quarter of a cylinder, bidegree (2, 1).
pub fn quarter_cylinder() -> [BiPoly<Real>; 4] {
    [
        sum(&[("1 0 1", "1")]),
        sum(&[("1 0 -1", "1")]),
        sum(&[("0 2", "1")]),
        sum(&[("1 0 1", "0 1")]),
    ]
}

/// A half-circle profile over a cubic with rational offset, bidegree (2, 3).
pub fn circle_over_cubic() -> [BiPoly<Real>; 4] {
    [
        sum(&[("1 0 1", "1")]),
        sum(&[("1 0 -1", "1 0 -3/5 -2/5")]),
        sum(&[("1 0 -1", "0 12/5 -9/5 2/5")]),
        sum(&[("0 2", "1")]),
    ]
}

/// A polynomial patch: all weights are 1.
pub fn polynomial() -> [BiPoly<Real>; 4] {
    [
        BiPoly::one(),
        sum(&[("0 1", "1")]),
        sum(&[("1", "0 1/3")]),
        sum(&[("0 0 1", "0 0 0 1/7")]),
    ]
}

/// W = 1 − 3u + 3u² is positive, its middle Bernstein coefficient is −1/2.
pub fn negative_weight() -> [BiPoly<Real>; 4] {
    [
        sum(&[("1 -3 3", "1")]),
        sum(&[("0 1", "1")]),
        sum(&[("1", "0 1")]),
        sum(&[("0 0 1", "1")]),
    ]
}

/// v^n along v.
pub fn of_degree(degree: usize) -> [BiPoly<Real>; 4] {
    [
        BiPoly::one(),
        sum(&[("0 1", "1")]),
        sum(&[("1", "0 1")]),
        BiPoly::in_v(&UniPoly::one().shift(degree)),
    ]
}

/// No surface: degree 0 along v.
pub fn line() -> [BiPoly<Real>; 4] {
    let along = sum(&[("0 1", "1")]);
    [BiPoly::one(), along.clone(), along.clone(), along]
}

/// A quarter of a cone: the side v = 0 is its apex.
pub fn cone() -> [BiPoly<Real>; 4] {
    [
        sum(&[("1 0 1", "1")]),
        sum(&[("1 0 -1", "0 1")]),
        sum(&[("0 2", "0 1")]),
        sum(&[("1 0 1", "0 1")]),
    ]
}

/// A full turn in one span: the circle z = w²/|w|² of w = (1 − 2u) + 2iu(1 − u), times a factor
/// that makes the weights positive. With `1 1` the weights at the two ends differ.
pub fn tube(factor: &str) -> [BiPoly<Real>; 4] {
    let (real, imaginary) = (poly("1 -2"), poly("0 2 -2"));
    let squares = (&real * &real, &imaginary * &imaginary);
    let double = (&real * &imaginary).scale(&number("2"));
    let factor = poly(factor);
    let of_u = |own: &UniPoly<Real>| BiPoly::in_u(&(own * &factor));
    let weight = &(&squares.0 + &squares.1) * &factor;
    [
        BiPoly::in_u(&weight),
        of_u(&(&squares.0 - &squares.1)),
        of_u(&double),
        BiPoly::product(&weight, &poly("0 3")),
    ]
}

/// A circle of four quarters, as x, y, w.
const CIRCLE: &str = "1,0,1 1,1,1 0,1,2 -1,1,1 -1,0,1 -1,-1,1 0,-1,2 1,-1,1 1,0,1";
/// A half-circle from pole to pole, as radius, height, weight.
const MERIDIAN: &[(&str, &str, &str)] = &[
    ("0", "-1", "1"),
    ("1", "-1", "1"),
    ("1", "0", "2"),
    ("1", "1", "1"),
    ("0", "1", "1"),
];

/// A net of several spans: a part of a circle along u, turned by a profile along v.
pub fn revolved(circle: &str, profile: &[(&str, &str, &str)]) -> ControlNet {
    let (mut weights, mut points) = (Vec::new(), Vec::new());
    for corner in circle.split(' ') {
        let [x, y, w] = [0, 1, 2].map(|axis| number(corner.split(',').nth(axis).unwrap()));
        for (radius, height, weight) in profile {
            weights.push(w.times(&number(weight)));
            points.push([
                x.times(&number(radius)),
                y.times(&number(radius)),
                number(height),
            ]);
        }
    }
    let knots = |count: usize| {
        let spans = (count - 1) / 2;
        let values = (0..2 * spans + 4).map(|index| index.saturating_sub(1) / 2);
        let values = values.map(|own| i64::try_from(own.min(spans)).unwrap());
        Knots::new(2, &values.map(Real::from).collect::<Vec<_>>()).unwrap()
    };
    ControlNet::new(
        knots(circle.split(' ').count()),
        knots(profile.len()),
        weights,
        points,
    )
    .unwrap()
}

/// Closed along u, two apices.
pub fn sphere() -> ControlNet {
    revolved(CIRCLE, MERIDIAN)
}

/// Closed along u, one apex.
pub fn hemisphere() -> ControlNet {
    revolved(
        CIRCLE,
        &[("1", "0", "1"), ("1", "1", "1/2"), ("0", "1", "1/2")],
    )
}

/// Closed along u, in four spans.
pub fn cylinder() -> ControlNet {
    revolved(CIRCLE, &[("1", "0", "1"), ("1", "1", "1"), ("1", "2", "1")])
}

/// Closed in both directions.
pub fn torus() -> ControlNet {
    let profile: Vec<_> = CIRCLE
        .split(' ')
        .map(|corner| corner.split(',').collect::<Vec<_>>())
        .collect();
    let radii: Vec<_> = profile
        .iter()
        .map(|own| number(own[0]).plus(&number("3")).to_string())
        .collect();
    let profile: Vec<_> = profile
        .iter()
        .zip(&radii)
        .map(|(own, radius)| (radius.as_str(), own[1], own[2]))
        .collect();
    revolved(CIRCLE, &profile)
}

/// Two opposite sides are points, the others differ.
pub fn lune() -> ControlNet {
    revolved("1,0,1 1,1,1 0,1,2", MERIDIAN)
}

/// All four sides are the same point.
pub fn bag() -> [BiPoly<Real>; 4] {
    [
        BiPoly::one(),
        sum(&[("0 1 -1", "0 1 -1")]),
        sum(&[("0 0 1 -1", "0 1 -1")]),
        sum(&[("0 1 -1", "0 0 1 -1")]),
    ]
}

/// Two adjacent sides are the same point.
pub fn corner_apex() -> [BiPoly<Real>; 4] {
    [
        BiPoly::one(),
        sum(&[("0 1", "0 1")]),
        sum(&[("0 0 1", "0 1")]),
        sum(&[("0 1", "0 0 1")]),
    ]
}

/// A polynomial net of rows of points, written `x,y,z x,y,z …`.
pub fn polynomial_net(rows: &[&str]) -> ControlNet {
    let columns = rows[0].split(' ').count();
    let points: Vec<_> = rows
        .iter()
        .flat_map(|row| row.split(' '))
        .map(|point| {
            let values: Vec<_> = point.split(',').map(number).collect();
            <[Real; 3]>::try_from(values).unwrap()
        })
        .collect();
    let knots = |count| Knots::bezier(count - 1, &number("0"), &number("1")).unwrap();
    let weights = vec![Real::one(); points.len()];
    ControlNet::new(knots(rows.len()), knots(columns), weights, points).unwrap()
}

/// Two adjacent sides are the same curve.
pub fn folded() -> ControlNet {
    polynomial_net(&[
        "0,0,0 0,1,0 1,2,0",
        "0,1,0 2,2,5 1,3,0",
        "1,2,0 2,3,1 3,4,1",
    ])
}

/// Two opposite sides are the same curve in opposite directions.
pub fn moebius() -> ControlNet {
    polynomial_net(&[
        "1,0,-1/4 1,0,1/4",
        "1,2,-1/2 1,2,1/2",
        "-2,3,-1/3 -2,2,1/2",
        "1,0,1/4 1,0,-1/4",
    ])
}

/// Two opposite corners touch.
pub fn touching_corners() -> ControlNet {
    polynomial_net(&[
        "0,0,0 2,-1,0 3,0,1",
        "-1,2,0 1,1,3 2,3,5",
        "0,3,1 2,2,4 0,0,0",
    ])
}

/// Two opposite sides are the same point.
pub fn petal() -> ControlNet {
    polynomial_net(&[
        "0,0,0 0,0,0 0,0,0",
        "0,1,0 2,2,5 1,3,0",
        "0,0,0 0,0,0 0,0,0",
    ])
}

/// Closed but for a gap of 10⁻⁹, with another weight at its end.
pub fn nearly_closed() -> ControlNet {
    let circle = CIRCLE.rsplit_once(' ').unwrap().0;
    revolved(
        &format!("{circle} 1,1e-9,3"),
        &[("1", "0", "1"), ("1", "1", "1"), ("1", "2", "1")],
    )
}

/// One side is a closed curve, and the patch is not closed.
pub fn teardrop() -> ControlNet {
    polynomial_net(&["0,0,0 0,0,1", "3,-2,0 3,-2,1", "3,2,0 3,2,2", "0,0,0 1,1,3"])
}

fn exact(value: &Value) -> Real {
    number(value.as_str().unwrap())
}

fn array(value: &Value) -> &Vec<Value> {
    value.as_array().unwrap()
}

/// The net of a file `sweepc-net/1` without square roots.
pub fn read_json(text: &str) -> ControlNet {
    let file: Value = serde_json::from_str(text).unwrap();
    assert_eq!(file["format"], "sweepc-net/1");
    let knots = |index: usize, along: &str| {
        let degree = usize::try_from(file["degree"][index].as_u64().unwrap()).unwrap();
        Knots::new(
            degree,
            &array(&file["knots"][along])
                .iter()
                .map(exact)
                .collect::<Vec<_>>(),
        )
        .unwrap()
    };
    let weights = array(&file["weights"]).iter().flat_map(array).map(exact);
    let points = array(&file["points"]).iter().flat_map(array);
    let points = points.map(|own| [exact(&own[0]), exact(&own[1]), exact(&own[2])]);
    ControlNet::new(
        knots(0, "u"),
        knots(1, "v"),
        weights.collect(),
        points.collect(),
    )
    .unwrap()
}
