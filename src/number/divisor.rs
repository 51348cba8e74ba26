use num_integer::Integer as _;

use super::{Integer, Ring};

/// The greatest common divisor, not negative.
#[must_use]
pub fn gcd(left: &Integer, right: &Integer) -> Integer {
    // A machine number on one side makes the other one, by one remainder.
    let remainder = |value: &Integer, divisor: &Integer| (value % divisor).machine();
    match (left.machine(), right.machine()) {
        (Some(0), _) => right.abs(),
        (_, Some(0)) => left.abs(),
        (Some(first), Some(second)) => machine_gcd(first, second),
        (Some(first), None) => machine_gcd(first, remainder(right, left).unwrap_or_default()),
        (None, Some(second)) => machine_gcd(second, remainder(left, right).unwrap_or_default()),
        (None, None) => lehmer(left.abs(), right.abs()),
    }
}

fn machine_gcd(left: i128, right: i128) -> Integer {
    let (left, right) = (left.unsigned_abs(), right.unsigned_abs());
    match (u64::try_from(left), u64::try_from(right)) {
        (Ok(left), Ok(right)) => left.gcd(&right).into(),
        _ => left.gcd(&right).into(),
    }
}

/// Lehmer's method: quotients are guessed from the leading digits of both numbers for as long as
/// they are certain, and applied together; when a machine number is left, [`gcd`] goes on.
fn lehmer(mut greater: Integer, mut lesser: Integer) -> Integer {
    if greater < lesser {
        std::mem::swap(&mut greater, &mut lesser);
    }
    while lesser.machine().is_none() {
        let shift = greater.bits() - 62;
        let lead = |value: &Integer| (value >> shift).machine().unwrap_or_default();
        let [first, second] = cosequence(lead(&greater), lead(&lesser));
        (greater, lesser) = if first[1] == 0 {
            let rest = &greater % &lesser;
            (lesser, rest)
        } else {
            let combine =
                |[a, b]: [i128; 2]| &greater * &Integer::from(a) + &lesser * &Integer::from(b);
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
    if left.is_zero() || right.is_zero() {
        return Ring::zero();
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
