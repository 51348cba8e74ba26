//! Intervals hold the exact results of what is done to the numbers in them.

use proptest::prelude::*;
use sweepc::number::{Enclosure, Field as _, Integer, Rational};

use crate::cases::for_all;

/// An interval and a number in it, most often at an end.
fn interval(precision: u32) -> impl Strategy<Value = (Enclosure, Rational)> {
    let end = prop_oneof![
        2 => -3_i64..=3,
        2 => -1_000_000_i64..=1_000_000,
        1 => any::<i32>().prop_map(|own| i64::from(own) << 20),
    ];
    let width = prop_oneof![2 => Just(0_i64), 2 => 1_i64..4, 1 => 0_i64..1 << 40];
    (end, width, 0_i64..=4).prop_map(move |(lower, width, step)| {
        let unit = Integer::from(1) << precision;
        let [from, to] = [lower, lower + width].map(Integer::from);
        let inside = Integer::from(lower) * 4 + Integer::from(width) * step;
        (
            Enclosure::new(from, to, precision),
            Rational::new(inside, unit * 4),
        )
    })
}

fn holds(interval: &Enclosure, value: &Rational) -> bool {
    let [lower, upper] = interval.ends();
    &lower <= value && value <= &upper
}

fn pair() -> impl Strategy<Value = ((Enclosure, Rational), (Enclosure, Rational), i64)> {
    prop_oneof![Just(1_u32), Just(8), Just(20), Just(64)]
        .prop_flat_map(|precision| (interval(precision), interval(precision), 1_i64..50))
}

#[test]
fn results_lie_in_the_intervals_of_the_results() {
    for_all(25_000, pair(), |((a, x), (b, y), divisor)| {
        prop_assert!(holds(&a, &x) && holds(&b, &y));
        prop_assert!(holds(&a.plus(&b), &(&x + &y)));
        prop_assert!(holds(&a.minus(&b), &(&x - &y)));
        prop_assert!(holds(&a.negated(), &-&x));
        prop_assert!(holds(&a.times(&b), &(&x * &y)));
        let quotient = &x / &Rational::from(divisor);
        prop_assert!(holds(&a.divided(&divisor.into()), &quotient));
        let size = if x.sign().is_lt() { -&x } else { x.clone() };
        prop_assert!(holds(&a.absolute(), &size));
        prop_assert!(a.absolute().ends()[0].sign().is_ge());
        let hull = a.hull(&b);
        prop_assert!(holds(&hull, &x) && holds(&hull, &y));
        let [lower, upper] = a.ends();
        let around = lower.sign().is_le() && upper.sign().is_ge();
        match a.inverse() {
            Some(inverse) => {
                prop_assert!(!around && holds(&inverse, &x.inverse().unwrap()));
            }
            None => prop_assert!(around),
        }
        if let Some(sign) = a.sign() {
            prop_assert_eq!(sign, x.sign());
        }
        Ok(())
    });
}

#[test]
fn roots_lie_between_the_ends() {
    for_all(10_000, pair(), |((a, x), _, _)| {
        let [lower, upper] = a.square_root().ends();
        let square = if x.sign().is_lt() {
            Rational::zero()
        } else {
            x
        };
        prop_assert!(lower.sign().is_ge());
        prop_assert!(&lower * &lower <= square && square <= &upper * &upper);
        Ok(())
    });
}

#[test]
fn rational_numbers_are_enclosed_to_one_step() {
    let cases = (any::<i64>(), 1_i64..i64::MAX, 0_u32..200);
    for_all(10_000, cases, |(n, d, precision)| {
        let value = Rational::new(n.into(), d.into());
        let interval = Enclosure::of_rational(&value, precision);
        prop_assert!(holds(&interval, &value));
        let scaled = &value * &Rational::from(Integer::from(1) << precision);
        prop_assert_eq!(
            interval.width(),
            Integer::from(i32::from(!scaled.is_integer()))
        );
        Ok(())
    });
}

#[test]
fn arctangents_add_up() {
    // arctan x + arctan y = arctan (x + y)/(1 − xy) for xy < 1
    for_all(3_000, pair(), |((a, _), (b, _), _)| {
        let [point, other] = [&a, &b].map(|own| own.ends()[0].clone());
        let interval = |value: &Rational| Enclosure::of_rational(value, 128).arctangent();
        let wide = a.arctangent();
        let narrow = Enclosure::of_rational(&point, a.precision()).arctangent();
        prop_assert!(narrow.width() <= Integer::from(2));
        prop_assert!(wide.minus(&narrow).absolute().ends()[0].is_zero());
        let room = &Rational::one() - &(&point * &other);
        if room.sign().is_gt() {
            let sum = &(&point + &other) / &room;
            let gap = interval(&sum).minus(&interval(&point).plus(&interval(&other)));
            prop_assert!(holds(&gap, &Rational::zero()));
            prop_assert!(gap.width() < Integer::from(16));
        }
        Ok(())
    });
}
