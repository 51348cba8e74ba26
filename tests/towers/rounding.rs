//! Digits, intervals and doubles of irrational numbers.

use num_bigint::BigInt;
use proptest::prelude::*;
use sweepc::export::Double;
use sweepc::number::{Field as _, Integer, Rational, Surd};

use crate::cases::for_all;
use crate::fields::{field, triple};

#[test]
fn digits_are_those_of_the_number() {
    for_all(8_000, (triple(), 0_u32..80), |((index, specs), digits)| {
        for spec in &specs {
            let number = field(index).number(spec);
            let found = number.exact.decimal(digits);
            match number.ball.decimal(digits) {
                Some(expected) => prop_assert_eq!(found, expected),
                // A tie, or 0.
                None => prop_assert!(number.exact.is_rational()),
            }
        }
        Ok(())
    });
}

#[test]
fn intervals_hold_the_number() {
    for_all(
        8_000,
        (triple(), 1_u32..300),
        |((index, specs), precision)| {
            for spec in &specs {
                let number = field(index).number(spec);
                let interval = number.exact.enclose(precision);
                prop_assert_eq!(interval.precision(), precision);
                let [lower, upper] = interval.ends().map(|end| {
                    let (numerator, denominator) = Rational::parts(&end);
                    (BigInt::from(numerator), BigInt::from(denominator))
                });
                let meets = number
                    .ball
                    .meets((&lower.0, &lower.1), (&upper.0, &upper.1));
                prop_assert!(meets);
                if let Some(sign) = interval.sign() {
                    prop_assert_eq!(sign, number.ball.sign());
                }
            }
            Ok(())
        },
    );
}

/// The number that the bits of a double are; 2¹⁰²⁴ for infinity.
fn of_bits(value: f64) -> Surd {
    let bits = value.abs().to_bits();
    let (binade, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let mantissa = if binade == 0 {
        fraction
    } else {
        fraction | 1 << 52
    };
    let exponent = i64::try_from(binade.max(1)).unwrap() - 1_075;
    let size = &Surd::from(Integer::from(mantissa)) * &Surd::from(2).power(exponent).unwrap();
    if value < 0.0 { -&size } else { size }
}

#[test]
fn doubles_are_nearest() {
    let exponent = prop_oneof![2 => -60_i64..60, 2 => -1_120_i64..1_060, 1 => -1_085_i64..-1_060];
    for_all(6_000, (triple(), exponent), |((index, specs), exponent)| {
        let scale = Surd::from(2).power(exponent).unwrap();
        for spec in &specs {
            let exact = &field(index).number(spec).exact * &scale;
            let half = Surd::ratio(1.into(), 2.into());
            let Some(double) = Double::nearest(&exact) else {
                let edge = &of_bits(f64::INFINITY) + &of_bits(f64::MAX);
                prop_assert!(exact.absolute() >= &edge * &half);
                continue;
            };
            let value = double.value();
            let own = of_bits(value);
            prop_assert_eq!(&double.exact(), &own);
            let [below, above] = [value.next_down(), value.next_up()];
            let [below, above] = [below, above].map(|other| &(&of_bits(other) + &own) * &half);
            let even = value.to_bits() & 1 == 0;
            prop_assert!(below < exact || (below == exact && even));
            prop_assert!(exact < above || (exact == above && even));
        }
        Ok(())
    });
}
