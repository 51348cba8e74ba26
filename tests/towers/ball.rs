//! Real numbers in fixed point, with a bound for the error.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_traits::{Signed, Zero};

/// Bits behind the point: 480 digits.
const BITS: u32 = 1_600;
/// Numbers below 2⁻⁷²⁰ (10⁻²¹⁶) are taken for 0.
const SMALL: u32 = BITS - 720;

/// The numbers within r of m, in units of 2⁻¹⁶⁰⁰.
#[derive(Clone, Debug)]
pub(crate) struct Ball {
    middle: BigInt,
    radius: BigInt,
}

impl Ball {
    pub(crate) fn ratio(numerator: &BigInt, denominator: &BigInt) -> Self {
        Self {
            middle: (numerator << BITS) / denominator,
            radius: BigInt::from(1),
        }
    }

    pub(crate) fn integer(value: i64) -> Self {
        Self::ratio(&value.into(), &1.into())
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            middle: &self.middle + &other.middle,
            radius: &self.radius + &other.radius,
        }
    }

    pub(crate) fn negated(&self) -> Self {
        Self {
            middle: -&self.middle,
            radius: self.radius.clone(),
        }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let error = self.middle.abs() * &other.radius
            + other.middle.abs() * &self.radius
            + &self.radius * &other.radius;
        Self {
            middle: (&self.middle * &other.middle) >> BITS,
            radius: (error >> BITS) + 2,
        }
    }

    /// 1/a of a ball without 0.
    pub(crate) fn inverse(&self) -> Self {
        let unit = BigInt::from(1) << (2 * BITS);
        let size = self.middle.abs();
        let least = &size - &self.radius;
        Self {
            middle: &unit / &self.middle,
            radius: &self.radius * unit / (size * least) + 2,
        }
    }

    /// √a of a positive ball.
    pub(crate) fn root(&self) -> Self {
        let least = ((&self.middle - &self.radius) << BITS).sqrt();
        Self {
            middle: (&self.middle << BITS).sqrt(),
            radius: (&self.radius << BITS) / least + 2,
        }
    }

    pub(crate) fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::integer(1), |power, _| power.times(self))
    }

    /// The sign; a ball around 0 is taken for 0, and has to be small.
    pub(crate) fn sign(&self) -> Ordering {
        if self.middle.abs() > self.radius {
            return self.middle.cmp(&BigInt::zero());
        }
        let limit = BigInt::from(1) << SMALL;
        assert!(self.radius < limit, "more bits are needed");
        Ordering::Equal
    }

    /// Whether some number of [l, u] lies in it.
    pub(crate) fn meets(&self, lower: (&BigInt, &BigInt), upper: (&BigInt, &BigInt)) -> bool {
        let left = (lower.0 << BITS) <= (&self.middle + &self.radius) * lower.1;
        left && (upper.0 << BITS) >= (&self.middle - &self.radius) * upper.1
    }

    /// The digits that both ends round to, half away from zero; none if they differ.
    pub(crate) fn decimal(&self, digits: u32) -> Option<String> {
        let ends = [&self.middle - &self.radius, &self.middle + &self.radius];
        let [lower, upper] = ends.map(|end| {
            let twice = end.abs() * BigInt::from(10).pow(digits) * 2;
            let rounded: BigInt = ((twice >> BITS) + 1) >> 1_u32;
            let width = digits as usize + 1;
            let mut text = format!("{:0>width$}", rounded.to_string());
            text.insert(text.len() - digits as usize, '.');
            let minus = end.sign() == Sign::Minus && !rounded.is_zero();
            format!("{}{text}", if minus { "-" } else { "" })
        });
        (lower == upper).then_some(lower)
    }
}
