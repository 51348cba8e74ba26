//! The nearest double, found by comparing the exact distances of its neighbours.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests state facts")]

use proptest::prelude::*;
use sweepc::export::{Double, Precision, RoundedNet};
use sweepc::net::ControlNet;
use sweepc::number::{Field, Integer, Real, Tower};
use sweepc::poly::{BiPoly, UniPoly};

/// The number that a double is, from its decimal digits: 767 of them are always enough.
fn decimal(value: f64) -> Real {
    format!("{value:.1074}").parse().unwrap()
}

fn distance(one: &Real, other: &Real) -> Real {
    let apart = one.minus(other);
    if apart.sign().is_lt() {
        apart.negated()
    } else {
        apart
    }
}

/// The next double towards ±∞, counting 2¹⁰²⁴ as one.
fn neighbours(value: f64) -> [Real; 2] {
    [value.next_down(), value.next_up()].map(|own| {
        if own.is_infinite() {
            let end = power_of_two(1_024);
            if own > 0.0 { end } else { end.negated() }
        } else {
            decimal(own)
        }
    })
}

fn power_of_two(exponent: i64) -> Real {
    Real::from(2).power(exponent).unwrap()
}

/// Whether the double is the nearest, with an even last bit where a neighbour is as near.
fn is_nearest(exact: &Real, double: Double) -> bool {
    let value = double.value();
    let own = distance(exact, &decimal(value));
    let even = value.to_bits() & 1 == 0;
    neighbours(value).iter().all(|neighbour| {
        let other = distance(exact, neighbour);
        own < other || (own == other && even)
    })
}

/// A double of any exponent, the smallest and the largest more often than the others.
fn doubles() -> impl Strategy<Value = f64> {
    let exponent = prop_oneof![0_u64..2_047, 0_u64..3, 2_044_u64..2_047];
    let fraction = prop_oneof![0_u64..1 << 52, 0_u64..3, (1_u64 << 52) - 3..1 << 52];
    (any::<bool>(), exponent, fraction).prop_map(|(sign, exponent, fraction)| {
        f64::from_bits(u64::from(sign) << 63 | exponent << 52 | fraction)
    })
}

/// a + b√2: often 0 or ±1, long, or nearly 0.
fn coefficients() -> impl Strategy<Value = Real> {
    let part = prop_oneof![
        4 => Just(0),
        3 => -1_i64..=1,
        2 => -40_i64..40,
        1 => any::<i64>(),
    ];
    let size = prop_oneof![3 => Just(0_i64), 1 => -200_i64..200];
    (
        part.clone(),
        prop_oneof![5 => Just(0), 1 => part],
        1_i64..30,
        size,
    )
        .prop_map(|(constant, slope, below, size)| {
            let root = Tower::new(2).square_root(&Real::from(2)).unwrap();
            let own = Real::from(constant).plus(&Real::from(slope).times(&root));
            let scale = Real::from(below).inverse().unwrap();
            own.times(&scale).times(&power_of_two(size))
        })
}

/// Up to three products of quadratic polynomials.
fn sums_of_products() -> impl Strategy<Value = BiPoly<Real>> {
    let factor = || proptest::collection::vec(coefficients(), 1..4);
    let terms = proptest::collection::vec((factor(), factor()), 0..4);
    terms.prop_map(|terms| {
        let polynomial = |own: &Vec<Real>| UniPoly::from_coefficients(own);
        let products = terms
            .iter()
            .map(|(in_u, in_v)| BiPoly::product(&polynomial(in_u), &polynomial(in_v)));
        products.fold(BiPoly::zero(), |all, own| &all + &own)
    })
}

proptest! {
    #[test]
    fn the_doubles_of_a_net_are_nearest_to_its_numbers(
        coordinates in [sums_of_products(), sums_of_products(), sums_of_products(), sums_of_products()],
    ) {
        let (zero, one) = (Real::from(0), Real::from(1));
        let net = ControlNet::bezier(coordinates.each_ref(), (&zero, &one), (&zero, &one));
        let Some(net) = net else {
            return Ok(());
        };
        let rounded = RoundedNet::new(&net).unwrap();
        for (exact, double) in net.weights().iter().zip(rounded.weights.iter().flatten()) {
            prop_assert!(is_nearest(exact, *double), "{exact}");
        }
        let points = net.points().iter().flatten();
        for (exact, double) in points.zip(rounded.points.iter().flatten().flatten()) {
            prop_assert!(is_nearest(exact, *double), "{exact}");
        }
    }

    #[test]
    fn doubles_are_their_own_nearest(value in doubles()) {
        let double = Double::nearest(&decimal(value)).unwrap();
        prop_assert_eq!(double.exact(), decimal(value));
        prop_assert!(double.value() == value && !(double.is_zero() && double.value().is_sign_negative()));
        prop_assert_eq!(double.is_tiny(), value.abs() < f64::MIN_POSITIVE);
    }

    #[test]
    fn ties_go_to_even_and_a_hair_decides(value in doubles(), hair in 1_i64..400) {
        let tie = decimal(value).plus(&neighbours(value)[1]).times(&power_of_two(-1));
        let hair = power_of_two(-1_080 - hair);
        for exact in [tie.clone(), tie.plus(&hair), tie.minus(&hair)] {
            match Double::nearest(&exact) {
                Some(double) => prop_assert!(is_nearest(&exact, double)),
                None => prop_assert!(exact >= edge()),
            }
        }
    }

    #[test]
    fn quotients_round_to_nearest(
        numerator in any::<i128>(),
        denominator in 1_i128..,
        exponent in -1_300_i64..1_100,
    ) {
        let exact = Real::ratio(Integer::from(numerator), Integer::from(denominator));
        let exact = exact.times(&power_of_two(exponent));
        match Double::nearest(&exact) {
            Some(double) => prop_assert!(is_nearest(&exact, double)),
            None => prop_assert!(distance(&exact, &Real::from(0)) >= edge()),
        }
    }

    #[test]
    fn quotients_of_irrational_numbers_round_to_nearest(
        parts in any::<[i64; 4]>(),
        size in 0_u32..120,
        exponent in -1_300_i64..1_200,
    ) {
        let tower = Tower::new(4);
        let [two, three] = [2, 3].map(|own| tower.square_root(&Real::from(own)).unwrap());
        let [a, b, c, d] = parts.map(|own| Real::from(Integer::from(own) << size));
        let scale = power_of_two(exponent.abs());
        let mut above = a.plus(&b.times(&two)).plus(&three.times(&c));
        let mut below = d.plus(&two.times(&three));
        if exponent < 0 {
            below = below.times(&scale);
        } else {
            above = above.times(&scale);
        }
        let exact = above.times(&below.inverse().unwrap());
        match Double::nearest_quotient(Precision::Double, above.numerator(), below.numerator()) {
            Some(double) => prop_assert!(is_nearest(&exact, double)),
            None => prop_assert!(distance(&exact, &Real::from(0)) >= edge()),
        }
    }

    #[test]
    fn ties_between_irrational_numbers_go_to_even(value in doubles(), hair in -1_i64..=1) {
        let tie = decimal(value).plus(&neighbours(value)[1]).times(&power_of_two(-1));
        let scale = power_of_two(1_200);
        let root = Tower::new(2).square_root(&Real::from(2)).unwrap();
        let below = scale.times(&root.minus(&Real::one()));
        let above = tie.times(&below).plus(&Real::from(hair));
        let exact = tie.plus(&Real::from(hair).times(&below.inverse().unwrap()));
        let rounded = Double::nearest_quotient(Precision::Double, above.numerator(), below.numerator());
        match rounded {
            Some(double) => prop_assert!(is_nearest(&exact, double)),
            None => prop_assert!(distance(&exact, &Real::from(0)) >= edge()),
        }
    }

    #[test]
    fn texts_read_back(value in doubles()) {
        let double = Double::nearest(&decimal(value)).unwrap();
        prop_assert_eq!(double.json().parse::<f64>().unwrap(), value);
        let step = double.step();
        prop_assert!(step.contains('.') && !step.contains('e') && !step.starts_with("-0.E"));
        prop_assert_eq!(step.replace(".E", ".0E").parse::<f64>().unwrap(), value);
    }
}

/// 2¹⁰²⁴ − 2⁹⁷⁰: halfway between the last double and the next.
fn edge() -> Real {
    power_of_two(1_024).minus(&power_of_two(970))
}

#[test]
fn the_ends_of_the_range_are_sharp() {
    let below = edge().minus(&power_of_two(-2_000));
    assert_eq!(Double::nearest(&edge()), None);
    assert_eq!(Double::nearest(&edge().negated()), None);
    assert_eq!(Double::nearest(&below).unwrap().value(), f64::MAX);
    assert_eq!(Double::nearest(&below.negated()).unwrap().value(), f64::MIN);
    assert_eq!(Double::nearest(&power_of_two(1_000_000)), None);
    let half = power_of_two(-1_075);
    for small in [half.clone(), half.negated(), power_of_two(-1_000_000)] {
        let zero = Double::nearest(&small).unwrap();
        assert_eq!(zero.value().to_bits(), 0);
        assert!(zero.is_tiny());
    }
    let above = half.plus(&power_of_two(-2_000));
    assert_eq!(Double::nearest(&above).unwrap().value().to_bits(), 1);
}

#[test]
fn texts_are_shortest() {
    for (exact, json, step) in [
        ("0", "0.0", "0."),
        ("1", "1.0", "1."),
        ("-1/10", "-0.1", "-0.1"),
        ("1/3", "0.3333333333333333", "0.3333333333333333"),
        ("1.5e-7", "1.5e-7", "1.5E-7"),
        ("1e-7", "1e-7", "1.E-7"),
        ("1e23", "1e23", "1.E23"),
        ("-123456789", "-123456789.0", "-123456789."),
        ("5e-324", "5e-324", "5.E-324"),
    ] {
        let double = Double::nearest(&exact.parse().unwrap()).unwrap();
        assert_eq!(
            (double.json().as_str(), double.step().as_str()),
            (json, step)
        );
    }
}
