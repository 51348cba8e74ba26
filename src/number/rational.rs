use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::str::FromStr;

use num_rational::Ratio;
use num_traits::{One, Signed, Zero};

use super::{Field, Integer, gcd};

/// A rational number in lowest terms with a positive denominator.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Rational(Ratio<Integer>);

impl Rational {
    /// numerator / denominator; the denominator is not 0
    #[must_use]
    pub fn new(numerator: Integer, denominator: Integer) -> Self {
        let common = gcd(&numerator, &denominator);
        let common = if denominator.is_negative() {
            -common
        } else {
            common
        };
        if One::is_one(&common) {
            return Self(Ratio::new_raw(numerator, denominator));
        }
        Self(Ratio::new_raw(numerator / &common, denominator / &common))
    }

    /// numerator / denominator, coprime, the denominator positive
    pub(super) fn in_lowest_terms(numerator: Integer, denominator: Integer) -> Self {
        Self(Ratio::new_raw(numerator, denominator))
    }

    /// n / 2ᵏ
    #[must_use]
    pub fn dyadic(numerator: &Integer, exponent: u32) -> Self {
        let Some(twos) = numerator.trailing_zeros() else {
            return Field::zero();
        };
        let twos = u32::try_from(twos).map_or(exponent, |twos| twos.min(exponent));
        let denominator = Integer::from(1) << (exponent - twos);
        Self::in_lowest_terms(numerator >> twos, denominator)
    }

    /// The numerator, with the sign.
    #[must_use]
    pub fn numerator(&self) -> &Integer {
        self.0.numer()
    }

    /// The positive denominator.
    #[must_use]
    pub fn denominator(&self) -> &Integer {
        self.0.denom()
    }

    /// The number as a small integer, if it is one.
    #[must_use]
    pub fn to_i64(&self) -> Option<i64> {
        self.0
            .is_integer()
            .then(|| i64::try_from(self.numerator()).ok())?
    }

    /// Whether the denominator is 1.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        self.0.is_integer()
    }

    /// a^n; none for 0 to a negative power
    #[must_use]
    pub fn power(&self, exponent: i64) -> Option<Self> {
        if Zero::is_zero(&self.0) && exponent < 0 {
            return None;
        }
        let base = if exponent < 0 {
            self.0.recip()
        } else {
            self.0.clone()
        };
        let size = u32::try_from(exponent.unsigned_abs()).ok()?;
        let power = |part: &Integer| part.power(size);
        Some(Self(Ratio::new_raw(
            power(base.numer()),
            power(base.denom()),
        )))
    }

    /// The number that a literal `digits[.digits][e[±]digits]` denotes; none if it is malformed
    /// or its exponent exceeds `limit` in absolute value.
    #[must_use]
    pub fn from_literal(literal: &str, limit: u32) -> Option<Self> {
        if literal.bytes().all(|own| own.is_ascii_digit()) {
            return Integer::from_str(literal).ok().map(Self::from);
        }
        let (mantissa, exponent) = match literal.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
            None => (literal, 0),
        };
        if exponent.unsigned_abs() > u64::from(limit) {
            return None;
        }
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = Integer::from_str(&format!("{whole}{fraction}")).ok()?;
        let shift = exponent - i64::try_from(fraction.len()).ok()?;
        let size = u32::try_from(shift.unsigned_abs()).ok()?;
        Some(if shift < 0 {
            Self::over_power_of_ten(digits, size)
        } else {
            Self::from(digits * Integer::from(10).power(size))
        })
    }

    /// Reads `7`, `-3/2`, `0.25`, `1.5e-3`; none if it is malformed or an exponent exceeds `limit`
    /// in absolute value.
    #[must_use]
    pub fn from_text(text: &str, limit: u32) -> Option<Self> {
        let read = |part: &str| {
            let (sign, digits) = match part.strip_prefix(['-', '−']) {
                Some(digits) => (-1, digits),
                None => (1, part.strip_prefix('+').unwrap_or(part)),
            };
            if !digits.starts_with(|first: char| first.is_ascii_digit()) {
                return None;
            }
            let value = Self::from_literal(digits, limit)?;
            Some(Self::from(sign).times(&value))
        };
        match text.split_once('/') {
            None => read(text.trim()),
            Some((numerator, denominator)) => {
                let denominator = read(denominator.trim())?.inverse()?;
                Some(read(numerator.trim())?.times(&denominator))
            }
        }
    }

    /// n / 10ᵏ in lowest terms: only twos and fives can cancel.
    fn over_power_of_ten(mut numerator: Integer, exponent: u32) -> Self {
        if Zero::is_zero(&numerator) {
            return Field::zero();
        }
        let twos = numerator.trailing_zeros().unwrap_or(0);
        let twos = u32::try_from(twos).map_or(exponent, |twos| twos.min(exponent));
        numerator >>= twos;
        let five = Integer::from(5);
        let mut fives = 0;
        while fives < exponent && Zero::is_zero(&(&numerator % &five)) {
            numerator /= &five;
            fives += 1;
        }
        let denominator = five.power(exponent - fives) << (exponent - twos);
        Self(Ratio::new_raw(numerator, denominator))
    }

    /// The number to so many digits behind the point, the last one rounded half away from zero,
    /// for reading only.
    #[must_use]
    pub fn decimal(&self, digits: u32) -> String {
        let scale = Integer::from(10).power(digits);
        let scaled = Self(&self.0 * Ratio::from_integer(scale))
            .0
            .round()
            .to_integer();
        let width = digits as usize + 1;
        let text = format!("{:0>width$}", scaled.abs().to_string());
        let (whole, fraction) = text.split_at(text.len() - digits as usize);
        let sign = if scaled.is_negative() { "-" } else { "" };
        format!("{sign}{whole}.{fraction}")
    }

    /// The size of the larger of numerator and denominator.
    #[must_use]
    pub fn bits(&self) -> u64 {
        self.numerator().bits().max(self.denominator().bits())
    }
}

impl Field for Rational {
    type Ring = Integer;

    fn from_parts(numerator: Integer, denominator: Integer) -> Self {
        Self::new(numerator, denominator)
    }

    #[inline]
    fn parts(&self) -> (&Integer, &Integer) {
        (self.numerator(), self.denominator())
    }

    fn into_parts(self) -> (Integer, Integer) {
        self.0.into_raw()
    }

    fn machine_parts(&self) -> Option<(i128, i128)> {
        Some((self.numerator().machine()?, self.denominator().machine()?))
    }

    fn zero() -> Self {
        Self(Zero::zero())
    }

    fn one() -> Self {
        Self(One::one())
    }

    fn is_zero(&self) -> bool {
        Zero::is_zero(&self.0)
    }

    fn is_one(&self) -> bool {
        One::is_one(&self.0)
    }

    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0)
    }

    fn minus(&self, other: &Self) -> Self {
        Self(&self.0 - &other.0)
    }

    fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0)
    }

    fn negated(&self) -> Self {
        Self(-&self.0)
    }

    fn inverse(&self) -> Option<Self> {
        (!Zero::is_zero(&self.0)).then(|| Self(self.0.recip()))
    }

    fn sign(&self) -> Ordering {
        self.0.cmp(&Zero::zero())
    }

    fn square_root(&self) -> Option<Self> {
        if self.0.is_negative() {
            return None;
        }
        let root = Self(Ratio::new_raw(
            self.numerator().sqrt(),
            self.denominator().sqrt(),
        ));
        (root.times(&root) == *self).then_some(root)
    }
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self(Ratio::from_integer(value.into()))
    }
}

impl From<Integer> for Rational {
    fn from(value: Integer) -> Self {
        Self(Ratio::from_integer(value))
    }
}

/// `p` or `p/q` in lowest terms.
impl fmt::Display for Rational {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, formatter)
    }
}

/// As [`Rational::from_text`], with exponents up to 4096.
impl FromStr for Rational {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        Self::from_text(text, 4_096).ok_or(())
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $symbol:tt) => {
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                Rational(&self.0 $symbol &other.0)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(-&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_exact() {
        let read = |text: &str| text.parse::<Rational>().map(|value| value.to_string());
        assert_eq!(read("0.8").as_deref(), Ok("4/5"));
        assert_eq!(read("1.5e-3").as_deref(), Ok("3/2000"));
        assert_eq!(read("-6/4").as_deref(), Ok("-3/2"));
        assert_eq!(read("2e3").as_deref(), Ok("2000"));
        assert_eq!(read("1/0"), Err(()));
        assert_eq!(read("x"), Err(()));
        assert_eq!(Rational::from_literal("1e5000", 4096), None);
        for text in [
            "0.0", "0.500", "12.50", "1000.000", "0.03125", "2.4e-3", "7e-2",
        ] {
            let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
            let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
            let digits: i64 = format!("{whole}{fraction}").parse().unwrap_or_default();
            let exponent: i64 = exponent.parse().unwrap_or_default();
            let ten = Rational::from(10).power(exponent - fraction.len() as i64);
            let expected = ten.map(|ten| &Rational::from(digits) * &ten);
            assert_eq!(Rational::from_literal(text, 99), expected, "{text}");
        }
    }

    #[test]
    fn roots_are_exact_or_refused() {
        let root = |text: &str| text.parse::<Rational>().ok()?.square_root();
        assert_eq!(
            root("9/4").map(|root| root.to_string()).as_deref(),
            Some("3/2")
        );
        assert_eq!(root("2"), None);
        assert_eq!(root("-4"), None);
        assert_eq!(root("0"), Some(Rational::from(0)));
    }
}
