use std::ops::{Add, Mul, Sub};

use super::Integer;

/// An element of the prime field 𝔽ₚ with p = 2⁶¹ − 1.
///
/// Images there prove what is hard to see over the integers: if the images of two polynomials
/// keep their degrees and are coprime, the polynomials are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Residue(u64);

impl Residue {
    /// The prime 2⁶¹ − 1.
    pub const PRIME: u64 = (1 << 61) - 1;
    /// 0
    pub const ZERO: Self = Self(0);
    /// 1
    pub const ONE: Self = Self(1);

    /// The image of a machine integer.
    #[must_use]
    pub fn new(value: u64) -> Self {
        Self(value % Self::PRIME)
    }

    /// The image of an integer.
    #[must_use]
    pub fn of_integer(value: &Integer) -> Self {
        // 2⁶¹ ≡ 1, so the image is the sum of the digits to base 2⁶¹; with 64-bit digits d the
        // sum runs over d·2^(64 i mod 61) = d·8^i.
        let mut sum = Self::ZERO;
        let mut weight = Self::ONE;
        for digit in value.iter_u64_digits() {
            sum = sum + Self::new(digit) * weight;
            weight = weight * Self(8);
        }
        match value.sign() {
            num_bigint::Sign::Minus => Self::ZERO - sum,
            _ => sum,
        }
    }

    /// 1 / a by Fermat; 0 for 0.
    #[must_use]
    pub fn inverse(self) -> Self {
        let mut power = Self::ONE;
        let mut square = self;
        let mut exponent = Self::PRIME - 2;
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = power * square;
            }
            square = square * square;
            exponent >>= 1;
        }
        power
    }

    fn fold(value: u128) -> Self {
        let prime = u128::from(Self::PRIME);
        let once = (value & prime) + (value >> 61);
        let twice = (once & prime) + (once >> 61);
        let folded = u64::try_from(twice).unwrap_or_default();
        Self(if folded >= Self::PRIME {
            folded - Self::PRIME
        } else {
            folded
        })
    }
}

impl Add for Residue {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::fold(u128::from(self.0) + u128::from(other.0))
    }
}

impl Sub for Residue {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::fold(u128::from(self.0) + u128::from(Self::PRIME - other.0))
    }
}

impl Mul for Residue {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::fold(u128::from(self.0) * u128::from(other.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_agree_with_integer_remainders() {
        let prime = Integer::from(Residue::PRIME);
        let mut value = Integer::from(-3);
        for step in 0..40_u32 {
            value = &value * Integer::from(0x9e37_79b9_7f4a_7c15_u64) + Integer::from(step);
            let remainder = ((&value % &prime) + &prime) % &prime;
            assert_eq!(Integer::from(Residue::of_integer(&value).0), remainder);
        }
    }

    #[test]
    fn inverses_multiply_to_one() {
        for value in [1, 2, 3, 1 << 60, Residue::PRIME - 1] {
            assert_eq!(
                Residue::new(value) * Residue::new(value).inverse(),
                Residue::ONE
            );
        }
        assert_eq!(Residue::ZERO.inverse(), Residue::ZERO);
    }
}
