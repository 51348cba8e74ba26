//! Where the sweeps are singular: Bernstein coefficients of the factors that vanish there, and
//! what the compiler proves by another road.

use std::collections::BTreeSet;

use sweepc::curve::{Interval, Preimage};
use sweepc::number::{Field, Real, Tower};
use sweepc::poly::{BiPoly, UniPoly, ZeroKind, bernstein};

use crate::hermite::hermite_data;
use crate::reference::{Examples, interpolants, items, surfaces, text};

/// The curve of an example: σ, s and H.
struct Curve {
    speed: UniPoly<Real>,
    length: UniPoly<Real>,
    turning: UniPoly<Real>,
}

impl Curve {
    fn of(example: u64) -> Self {
        let all = interpolants();
        let data = items(&all["examples"])
            .iter()
            .find(|own| own["example"] == example);
        let (hermite, _) = hermite_data(&data.unwrap()["data"]);
        let (tower, unit) = (Tower::default(), Interval::unit());
        let (branch, _) = hermite.best(&unit, &tower).unwrap();
        let preimage: Preimage = hermite.preimage(branch, &unit, &tower).unwrap();
        let speed = preimage.speed(&tower).unwrap();
        let modulus = preimage.factor().modulus(&tower).unwrap();
        Self {
            length: speed.antiderivative(),
            turning: preimage.turning().scale(&(&modulus * &Real::from(2))),
            speed,
        }
    }
}

/// The polynomial of a case that vanishes at the singular points, in the parameters of its
/// surface.
fn factor(case: &str) -> BiPoly<Real> {
    let list = |own: &[i64]| -> UniPoly<Real> {
        let own: Vec<Real> = own.iter().copied().map(Real::from).collect();
        UniPoly::from_coefficients(&own)
    };
    let (weight, x) = (list(&[1, 0, 1]), list(&[1, 0, -1]));
    let own = Curve::of(if case == "E4" { 4 } else { 2 });
    let (one, square) = (UniPoly::one(), &own.speed * &own.speed);
    let offset = |distance: &[i64]| {
        let bent = BiPoly::product(&own.turning, &list(distance));
        &BiPoly::product(&square, &one) + &bent
    };
    match case {
        "E2" => &BiPoly::product(&weight, &square) + &BiPoly::product(&x, &own.turning),
        "E3" => offset(&[0, 1]),
        "E3b" => offset(&[0, 0, 1]),
        "E3c" => offset(&[0, 0, -1]),
        "E4" => &BiPoly::product(&weight, &own.length) + &BiPoly::product(&x, &one),
        other => panic!("{other}"),
    }
}

/// Bernstein coefficients on the unit square, i along u.
fn coefficients(polynomial: &BiPoly<Real>) -> Vec<Vec<Real>> {
    let (zero, one) = (Real::zero(), Real::one());
    let degree = polynomial.bidegree().unwrap();
    let columns = polynomial.columns();
    let columns: Vec<_> = columns
        .iter()
        .map(|own| bernstein(own, degree.u, &zero, &one))
        .collect();
    let row = |i: usize| {
        let powers: Vec<Real> = columns.iter().map(|own| own[i].clone()).collect();
        bernstein(&UniPoly::from_coefficients(&powers), degree.v, &zero, &one)
    };
    (0..=degree.u).map(row).collect()
}

fn sign(number: &Real) -> i64 {
    number.sign() as i64
}

#[test]
fn signs_of_bernstein_coefficients_are_the_reference() {
    let data = surfaces();
    assert_eq!(items(&data["regularity"]).len(), 5);
    for own in items(&data["regularity"]) {
        let case = text(&own["case"]);
        let found = coefficients(&factor(case));
        let signs: BTreeSet<i64> = found.iter().flatten().map(sign).collect();
        let expected = items(&own["signs"]).iter();
        let expected: BTreeSet<i64> = expected.map(|own| own.as_i64().unwrap()).collect();
        assert_eq!(signs, expected, "{case}");
        let mut zeros = Vec::new();
        for (i, row) in found.iter().enumerate() {
            for (j, number) in row.iter().enumerate() {
                if number.is_zero() {
                    zeros.push((i, j));
                }
            }
        }
        // The one zero is the coefficient of the corner (1, 0), the value there.
        let corner = [(found.len() - 1, 0)];
        let expected: &[_] = if own["zeros"].is_null() { &[] } else { &corner };
        assert_eq!(zeros, expected, "{case}");
    }
}

#[test]
fn curvatures_are_negative() {
    let (zero, one) = (Real::zero(), Real::one());
    for example in [2, 4] {
        let turning = Curve::of(example).turning;
        let found = bernstein(&turning, 2, &zero, &one);
        assert_eq!(found.iter().map(sign).collect::<Vec<_>>(), [-1; 3]);
    }
}

/// What the compiler proves of the examples themselves.
#[test]
fn the_examples_are_singular_where_the_reference_is() {
    let (data, mut examples) = (surfaces(), Examples::default());
    for own in items(&data["regularity"]) {
        let id = text(&own["case"]);
        let case = items(&data["cases"]).iter().find(|case| case["id"] == id);
        let (_, surface) = examples.case(case.unwrap());
        let singular: Vec<_> = surface
            .singular()
            .iter()
            .map(|own| (own.kind, own.u.clone(), own.v.clone()))
            .collect();
        if own["zeros"].is_null() {
            assert_eq!(surface.regular().holds(), Some(true), "{id}");
            assert_eq!(singular, [], "{id}");
        } else {
            let at = |index: usize| -> Real {
                let number = &own["zeros"][0][index];
                number.as_i64().unwrap().into()
            };
            let (u, v) = ((at(0), at(0)), (at(1), at(1)));
            assert_eq!(surface.regular().holds(), Some(false), "{id}");
            assert_eq!(singular, [(ZeroKind::Point, u, v)], "{id}");
        }
    }
}

/// A curve that bends too much is noticed: with twice the curvature of Example 2 the factor takes
/// both signs.
#[test]
fn a_change_of_sign_is_noticed() {
    let own = Curve::of(2);
    let bent = own.turning.scale(&Real::from(2));
    let square = BiPoly::in_v(&(&own.speed * &own.speed));
    let found = coefficients(&(&square + &BiPoly::in_v(&bent)));
    let signs: BTreeSet<i64> = found.iter().flatten().map(sign).collect();
    assert_eq!(signs, BTreeSet::from([-1, 1]));
}
