use std::cmp::Ordering;

use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};

use super::{Residue, Ring};

/// A rational integer of any size.
pub type Integer = num_bigint::BigInt;

/// The greatest common divisor, not negative.
#[must_use]
pub fn gcd(left: &Integer, right: &Integer) -> Integer {
    // A machine word on one side makes the other one, by one remainder.
    let word = |value: &Integer| u64::try_from(value.magnitude()).ok();
    let remainder = |value: &Integer, word: u64| {
        let rest = value.magnitude() % word;
        u64::try_from(rest).unwrap_or_default()
    };
    match (word(left), word(right)) {
        (Some(0), _) => right.abs(),
        (_, Some(0)) => left.abs(),
        (Some(first), Some(second)) => first.gcd(&second).into(),
        (Some(first), None) => first.gcd(&remainder(right, first)).into(),
        (None, Some(second)) => second.gcd(&remainder(left, second)).into(),
        (None, None) => left.gcd(right),
    }
}

/// The least common multiple, not negative.
#[must_use]
pub fn lcm(left: &Integer, right: &Integer) -> Integer {
    left.lcm(right)
}

impl Ring for Integer {
    const GAUSS: bool = true;

    fn zero() -> Self {
        Zero::zero()
    }

    fn one() -> Self {
        One::one()
    }

    fn from_integer(value: &Integer) -> Self {
        value.clone()
    }

    fn is_zero(&self) -> bool {
        Zero::is_zero(self)
    }

    fn is_one(&self) -> bool {
        One::is_one(self)
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn add_product(&mut self, left: &Self, right: &Self) {
        *self += left * right;
    }

    fn negated(&self) -> Self {
        -self
    }

    fn scaled(&self, factor: &Integer) -> Self {
        self * factor
    }

    fn divided(&self, divisor: &Integer) -> Self {
        self / divisor
    }

    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let (quotient, remainder) = self.div_rem(divisor);
        Zero::is_zero(&remainder).then_some(quotient)
    }

    fn content(&self) -> Integer {
        self.abs()
    }

    fn sign(&self) -> Ordering {
        self.cmp(&Zero::zero())
    }

    fn residue(&self) -> Option<Residue> {
        Some(Residue::of_integer(self))
    }

    fn bits(&self) -> u64 {
        num_bigint::BigInt::bits(self)
    }

    fn as_integer(&self) -> Option<&Integer> {
        Some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn divisors_of_words_and_of_long_integers_agree() {
        let long = Integer::from(6) << 200_u32;
        let values = [0, 1, -12, 18, 1_i64 << 40].map(Integer::from);
        for left in values.iter().chain([&long]) {
            for right in values.iter().chain([&long]) {
                assert_eq!(gcd(left, right), left.gcd(right));
                assert_eq!(gcd(left, &(right * &long)), left.gcd(&(right * &long)));
            }
        }
    }
}
