use std::cmp::Ordering;

use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};

use super::{Place, Ring};

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
        (None, None) => lehmer(left.abs(), right.abs()),
    }
}

/// Lehmer's method: quotients are guessed from the leading digits of both numbers for as long as
/// they are certain, and applied together; when a machine word is left, [`gcd`] goes on.
fn lehmer(mut greater: Integer, mut lesser: Integer) -> Integer {
    if greater < lesser {
        std::mem::swap(&mut greater, &mut lesser);
    }
    while lesser.bits() > u64::from(u64::BITS) {
        let shift = greater.bits() - 62;
        let lead = |value: &Integer| i128::try_from(value >> shift).unwrap_or_default();
        let [first, second] = cosequence(lead(&greater), lead(&lesser));
        (greater, lesser) = if first[1] == 0 {
            let rest = &greater % &lesser;
            (lesser, rest)
        } else {
            let combine = |[a, b]: [i128; 2]| &greater * a + &lesser * b;
            (combine(first), combine(second))
        };
    }
    gcd(&greater, &lesser)
}

/// The steps of Euclid's algorithm that two numbers with the leading digits x ≥ y share for
/// certain, as two combinations: the quotient is certain while ⌊(x + a)/(y + c)⌋ and
/// ⌊(x + b)/(y + d)⌋ agree.   Knuth, The Art of Computer Programming, 4.5.2, algorithm L.
fn cosequence(mut x: i128, mut y: i128) -> [[i128; 2]; 2] {
    let (mut first, mut second) = ([1, 0], [0, 1]);
    while y + second[0] != 0 && y + second[1] != 0 {
        let quotient = (x + first[0]) / (y + second[0]);
        if quotient != (x + first[1]) / (y + second[1]) {
            break;
        }
        let next = [0, 1].map(|index| first[index] - quotient * second[index]);
        (first, second) = (second, next);
        (x, y) = (y, x - quotient * y);
    }
    [first, second]
}

/// The least common multiple, not negative.
#[must_use]
pub fn lcm(left: &Integer, right: &Integer) -> Integer {
    if Zero::is_zero(left) || Zero::is_zero(right) {
        return Zero::zero();
    }
    (left / gcd(left, right) * right).abs()
}

impl Ring for Integer {
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

    fn height(&self) -> usize {
        0
    }

    fn place(&self) -> Option<Place> {
        Some(Place::rational())
    }

    fn image(&self, place: &Place) -> u64 {
        place.modulus().embed_integer(self)
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

    /// A number of many digits, from a linear congruence.
    fn digits(seed: u64, words: u32) -> Integer {
        let step = |value: Integer, index: u32| {
            let word = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(index);
            (value << 64) + word.wrapping_mul(u64::from(index) + 0x2545_f491_4f6c_dd1d)
        };
        (0..words).fold(Integer::from(seed), step)
    }

    #[test]
    fn divisors_agree_with_the_library() {
        for seed in 1..200_u64 {
            let words = u32::try_from(seed % 7).unwrap_or_default();
            let (left, right) = (digits(seed, words), digits(seed + 1_000, 6 - words));
            let common = digits(seed * 77, words / 2);
            for (a, b) in [
                (left.clone(), right.clone()),
                (&left * &common, &right * &common),
                (&left * &common, common.clone()),
                (-&left, &left + Integer::from(1)),
            ] {
                assert_eq!(gcd(&a, &b), num_integer::Integer::gcd(&a, &b), "{a} {b}");
            }
        }
    }

    #[test]
    fn neighbours_of_the_golden_ratio_take_the_most_steps() {
        let (mut a, mut b) = (Integer::from(1), Integer::from(1));
        for _ in 0..1_000 {
            (a, b) = (&a + &b, a);
            assert!(One::is_one(&gcd(&a, &b)));
        }
    }
}
