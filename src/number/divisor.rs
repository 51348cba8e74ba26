use num_bigint::Sign;
use num_integer::Integer as _;

use super::{Integer, Ring};

/// The greatest common divisor, not negative.
#[must_use]
pub fn gcd(left: &Integer, right: &Integer) -> Integer {
    // A machine number on one side makes the other one, by one remainder.
    let remainder = |value: &Integer, divisor: i128| match u64::try_from(divisor.unsigned_abs()) {
        Ok(word) => value.remainder_by_word(word).into(),
        Err(_) => (value % Integer::from(divisor))
            .machine()
            .unwrap_or_default(),
    };
    match (left.machine(), right.machine()) {
        (Some(1 | -1), _) | (_, Some(1 | -1)) => Ring::one(),
        (Some(0), _) => right.abs(),
        (_, Some(0)) => left.abs(),
        (Some(first), Some(second)) => of_machine(first, second),
        (Some(first), None) => of_machine(first, remainder(right, first)),
        (None, Some(second)) => of_machine(second, remainder(left, second)),
        (None, None) => lehmer(left, right),
    }
}

fn of_machine(left: i128, right: i128) -> Integer {
    of_sizes(left.unsigned_abs(), right.unsigned_abs()).into()
}

/// The greatest common divisor of machine numbers, of which the second is positive.
#[must_use]
#[inline]
pub fn machine_gcd(left: i128, right: i128) -> i128 {
    // It is no greater than the second.
    of_sizes(left.unsigned_abs(), right.unsigned_abs()).cast_signed()
}

/// The greatest common divisor of double words.
pub(super) fn of_sizes(left: u128, right: u128) -> u128 {
    if let (Ok(left), Ok(right)) = (u64::try_from(left), u64::try_from(right)) {
        return of_words(left, right).into();
    }
    let (lesser, greater) = (left.min(right), left.max(right));
    match u64::try_from(lesser) {
        Ok(0) => greater,
        Ok(1) => 1,
        // One remainder makes a word of a longer number.
        Ok(word) => match u64::try_from(greater % lesser) {
            Ok(rest) => word.gcd(&rest).into(),
            Err(_) => lesser.gcd(&greater),
        },
        Err(_) => lesser.gcd(&greater),
    }
}

/// By binary digits, after one remainder that makes both about as long.
#[inline]
fn of_words(left: u64, right: u64) -> u64 {
    let (lesser, greater) = (left.min(right), left.max(right));
    match lesser {
        0 => greater,
        1 => 1,
        _ => lesser.gcd(&(greater % lesser)),
    }
}

/// Lehmer's method on the digits to the base 2⁶⁴: quotients are guessed from the leading digits of
/// both numbers for as long as they are certain, and applied together, in place, until one has two
/// digits.
fn lehmer(left: &Integer, right: &Integer) -> Integer {
    let (mut greater, mut lesser) = (left.digits(), right.digits());
    if is_less(&greater, &lesser) {
        std::mem::swap(&mut greater, &mut lesser);
    }
    while lesser.len() > 2 {
        let (first, second) = cosequence(leading(&greater, &lesser));
        if first.other == 0 {
            let rest = &positive(&greater) % &positive(&lesser);
            greater = std::mem::replace(&mut lesser, rest.digits());
        } else {
            lesser.resize(greater.len(), 0);
            combine(&mut greater, &mut lesser, first, second);
        }
        trim(&mut greater);
        trim(&mut lesser);
    }
    if lesser.is_empty() {
        return positive(&greater);
    }
    if greater.len() > 2 {
        greater = (positive(&greater) % positive(&lesser)).digits();
    }
    of_sizes(double_word(&greater), double_word(&lesser)).into()
}

/// The number of two digits at most.
fn double_word(digits: &[u64]) -> u128 {
    let higher_first = digits.iter().rev();
    higher_first.fold(0, |number, own| number << 64 | u128::from(*own))
}

fn positive(digits: &[u64]) -> Integer {
    Integer::of_digits(Sign::Plus, digits.iter().copied())
}

/// Drops leading zeros.
fn trim(digits: &mut Vec<u64>) {
    while digits.last() == Some(&0) {
        digits.pop();
    }
}

fn is_less(left: &[u64], right: &[u64]) -> bool {
    left.len() < right.len()
        || (left.len() == right.len() && left.iter().rev().lt(right.iter().rev()))
}

/// The leading 62 binary digits of the greater of two numbers, and the digits of the other at the
/// same places.
fn leading(greater: &[u64], lesser: &[u64]) -> (i64, i64) {
    let top = greater.len() - 1;
    let zeros = greater[top].leading_zeros();
    let digits = |own: &[u64]| {
        let digit = |index: usize| u128::from(own.get(index).copied().unwrap_or(0));
        let window = (digit(top) << 64 | digit(top.wrapping_sub(1))) << zeros >> 66;
        i64::try_from(window).unwrap_or(i64::MAX)
    };
    (digits(greater), digits(lesser))
}

/// a x + b y for numbers x and y.
#[derive(Clone, Copy)]
struct Combination {
    own: i64,
    other: i64,
}

/// The steps of Euclid's algorithm that two numbers with the leading digits x ≥ y share for
/// certain, as two combinations with integers of opposite signs: the quotient is certain while
/// ⌊(x + a)/(y + c)⌋ and ⌊(x + b)/(y + d)⌋ agree.   Knuth, The Art of Computer Programming, 4.5.2,
/// algorithm L.
fn cosequence((mut x, mut y): (i64, i64)) -> (Combination, Combination) {
    let mut first = Combination { own: 1, other: 0 };
    let mut second = Combination { own: 0, other: 1 };
    while y + second.own != 0 && y + second.other != 0 {
        let quotient = (x + first.own) / (y + second.own);
        if quotient != (x + first.other) / (y + second.other) {
            break;
        }
        let next = Combination {
            own: first.own - quotient * second.own,
            other: first.other - quotient * second.other,
        };
        (first, second) = (second, next);
        (x, y) = (y, x - quotient * y);
    }
    (first, second)
}

/// Replaces two numbers of as many digits by two combinations of them that are not negative.
fn combine(greater: &mut [u64], lesser: &mut [u64], first: Combination, second: Combination) {
    let mut carries = [0_i128; 2];
    for (x, y) in greater.iter_mut().zip(lesser) {
        let mut step = |index: usize, by: Combination| {
            // Of opposite signs, and each less than 2¹²⁶.
            let sum = carries[index] + times(by.own, *x) + times(by.other, *y);
            carries[index] = sum >> 64;
            sum.cast_unsigned() & u128::from(u64::MAX)
        };
        let next = [step(0, first), step(1, second)];
        let [first, second] = next.map(|own| u64::try_from(own).unwrap_or_default());
        (*x, *y) = (first, second);
    }
}

fn times(factor: i64, digit: u64) -> i128 {
    let size = (u128::from(factor.unsigned_abs()) * u128::from(digit)).cast_signed();
    if factor < 0 { -size } else { size }
}

/// The least common multiple, not negative.
#[must_use]
pub fn lcm(left: &Integer, right: &Integer) -> Integer {
    match (left.machine(), right.machine()) {
        (Some(0), _) | (_, Some(0)) => return Ring::zero(),
        (Some(1), _) => return right.abs(),
        (_, Some(1)) => return left.abs(),
        _ => {}
    }
    (left / gcd(left, right) * right).abs()
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::*;

    /// The library's divisor, by way of decimals.
    fn library(left: &Integer, right: &Integer) -> Integer {
        let read = |own: &Integer| own.to_string().parse().unwrap_or(BigInt::ZERO);
        Integer::of_long(read(left).gcd(&read(right)))
    }

    #[test]
    fn divisors_of_words_and_of_long_integers_agree() {
        let long = Integer::from(6) << 200_u32;
        let values = [0, 1, -12, 18, 1_i64 << 40].map(Integer::from);
        for left in values.iter().chain([&long]) {
            for right in values.iter().chain([&long]) {
                assert_eq!(gcd(left, right), library(left, right));
                assert_eq!(gcd(left, &(right * &long)), library(left, &(right * &long)));
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
                assert_eq!(gcd(&a, &b), library(&a, &b), "{a} {b}");
            }
        }
    }

    #[test]
    fn neighbours_of_the_golden_ratio_take_the_most_steps() {
        let (mut a, mut b) = (Integer::from(1), Integer::from(1));
        for _ in 0..1_000 {
            (a, b) = (&a + &b, a);
            assert!(gcd(&a, &b).is_one());
        }
    }
}
