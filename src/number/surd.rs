use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::str::FromStr;

use super::enclosure::refine;
use super::tower::root_within;
use super::{Enclosure, Field, Generator, Integer, Rational, Ring, SurdInteger, gcd};

/// A number of a tower of real fields ℚ(√a₁)(√a₂)…, in lowest terms.
///
/// Values are canonical: equal numbers compare equal, and a rational number knows that it is
/// one. Numbers of one computation belong to one [`Tower`](super::Tower).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Surd {
    numerator: SurdInteger,
    denominator: Integer,
}

impl Surd {
    /// n / d in lowest terms; d is not 0.
    fn lowest(numerator: SurdInteger, denominator: Integer) -> Self {
        let mut common = if denominator.is_one() {
            Integer::from(1)
        } else {
            numerator.content_with(&denominator)
        };
        if Ring::sign(&denominator).is_lt() {
            common = -common;
        }
        if common.is_one() {
            return Self {
                numerator,
                denominator,
            };
        }
        Self {
            numerator: numerator.divided(&common),
            denominator: denominator / common,
        }
    }

    /// A rational number; the denominator is not 0.
    #[must_use]
    pub fn ratio(numerator: Integer, denominator: Integer) -> Self {
        Self::from(Rational::new(numerator, denominator))
    }

    /// The number over the denominator 1.
    #[must_use]
    pub fn integral(numerator: SurdInteger) -> Self {
        Self {
            numerator,
            denominator: Integer::from(1),
        }
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &SurdInteger {
        &self.numerator
    }

    /// The positive denominator.
    #[must_use]
    pub fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// The generator of the level on which it lies; none for a rational number.
    #[must_use]
    pub fn level(&self) -> Option<&Generator> {
        self.numerator.level()
    }

    /// The number as a rational one; none if it is irrational.
    #[must_use]
    pub fn as_rational(&self) -> Option<Rational> {
        let numerator = self.numerator.as_integer()?;
        Some(Rational::in_lowest_terms(
            numerator.clone(),
            self.denominator.clone(),
        ))
    }

    /// The number as a small integer, if it is one.
    #[must_use]
    pub fn to_i64(&self) -> Option<i64> {
        let numerator = self.numerator.as_integer()?;
        (self.denominator.is_one()).then(|| i64::try_from(numerator).ok())?
    }

    /// Whether it is a rational integer.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        self.denominator.is_one() && self.numerator.as_integer().is_some()
    }

    /// a^n; none for 0 to a negative power
    #[must_use]
    pub fn power(&self, exponent: i64) -> Option<Self> {
        let base = if exponent < 0 {
            self.inverse()?
        } else {
            self.clone()
        };
        let exponent = exponent.unsigned_abs();
        if exponent == 1 {
            return Some(base);
        }
        let bits = (0..u64::BITS - exponent.leading_zeros()).rev();
        Some(bits.fold(Self::one(), |power, bit| {
            let square = &power * &power;
            if exponent >> bit & 1 == 1 {
                &square * &base
            } else {
                square
            }
        }))
    }

    /// The number that a literal denotes, see [`Rational::from_literal`].
    #[must_use]
    pub fn from_literal(literal: &str, limit: u32) -> Option<Self> {
        Rational::from_literal(literal, limit).map(Self::from)
    }

    /// An interval around it at the precision.
    #[must_use]
    pub fn enclose(&self, precision: u32) -> Enclosure {
        match self.as_rational() {
            Some(rational) => Enclosure::of_rational(&rational, precision),
            None => self.numerator.enclose(precision).divided(&self.denominator),
        }
    }

    /// The answer that both ends of a narrow enclosure of an irrational number agree on.
    ///
    /// The question must have the same answer everywhere near the number, and an answer that it
    /// has at two numbers at all numbers between them: the ends need not have the number's sign.
    #[must_use]
    pub fn decide<T: PartialEq>(&self, question: impl Fn(&Rational) -> T) -> T {
        if let Some(rational) = self.as_rational() {
            return question(&rational);
        }
        refine(|precision| {
            let [lower, upper] = self.enclose(precision).ends();
            let answer = question(&lower);
            (answer == question(&upper)).then_some(answer)
        })
    }

    /// The number to so many digits behind the point, the last one rounded half away from zero,
    /// for reading only.
    #[must_use]
    pub fn decimal(&self, digits: u32) -> String {
        self.decide(|own| own.decimal(digits))
    }

    /// About log₂ |a|, to the nearest integers; none for 0.
    #[must_use]
    pub fn binade(&self) -> Option<i64> {
        let bits = |own: &Integer| i64::try_from(own.bits()).unwrap_or(i64::MAX);
        (!self.is_zero()).then(|| {
            self.absolute()
                .decide(|own| bits(own.numerator()) - bits(own.denominator()))
        })
    }

    /// 2ᵏ
    #[must_use]
    pub fn power_of_two(exponent: i64) -> Self {
        let power = Integer::from(1) << exponent.unsigned_abs();
        if exponent < 0 {
            Self::ratio(1.into(), power)
        } else {
            Self::from(power)
        }
    }

    /// The number for a message: as it is, or, where that is long, its first digits.
    #[must_use]
    pub fn brief(&self) -> String {
        const LONGEST: usize = 40;
        let exact = self.to_string();
        if exact.chars().count() <= LONGEST {
            exact
        } else {
            format!("≈ {}", self.decimal(6))
        }
    }

    /// The size of the largest rational integer in it.
    #[must_use]
    pub fn bits(&self) -> u64 {
        Ring::bits(&self.numerator).max(self.denominator.bits())
    }

    /// a n/d + b m/d, by the operation on numerators.
    fn combine(
        &self,
        other: &Self,
        join: impl Fn(&SurdInteger, &SurdInteger) -> SurdInteger,
    ) -> Self {
        if self.denominator == other.denominator {
            let numerator = join(&self.numerator, &other.numerator);
            return Self::lowest(numerator, self.denominator.clone());
        }
        let common = gcd(&self.denominator, &other.denominator);
        let (left, right) = (&other.denominator / &common, &self.denominator / &common);
        let numerator = join(
            &self.numerator.scaled(&left),
            &other.numerator.scaled(&right),
        );
        Self::lowest(numerator, &self.denominator * left)
    }
}

impl Field for Surd {
    type Ring = SurdInteger;

    fn from_parts(numerator: SurdInteger, denominator: Integer) -> Self {
        Self::lowest(numerator, denominator)
    }

    #[inline]
    fn parts(&self) -> (&SurdInteger, &Integer) {
        (&self.numerator, &self.denominator)
    }

    fn into_parts(self) -> (SurdInteger, Integer) {
        (self.numerator, self.denominator)
    }

    #[inline]
    fn machine_parts(&self) -> Option<(i128, i128)> {
        let numerator = self.numerator.as_integer()?.machine()?;
        Some((numerator, self.denominator.machine()?))
    }

    fn zero() -> Self {
        Self::integral(Ring::zero())
    }

    fn one() -> Self {
        Self::integral(Ring::one())
    }

    fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    fn is_one(&self) -> bool {
        self.denominator.is_one() && self.numerator.is_one()
    }

    fn is_rational(&self) -> bool {
        self.numerator.level().is_none()
    }

    fn plus(&self, other: &Self) -> Self {
        self.combine(other, Ring::plus)
    }

    fn minus(&self, other: &Self) -> Self {
        self.combine(other, Ring::minus)
    }

    fn times(&self, other: &Self) -> Self {
        if let (SurdInteger::Rational(left), SurdInteger::Rational(right)) =
            (&self.numerator, &other.numerator)
        {
            // Numbers in lowest terms: only crosswise is there something to cancel.
            let first = gcd(left, &other.denominator);
            let second = gcd(right, &self.denominator);
            return Self {
                numerator: SurdInteger::Rational((left / &first) * (right / &second)),
                denominator: (&self.denominator / second) * (&other.denominator / first),
            };
        }
        let numerator = self.numerator.times(&other.numerator);
        Self::lowest(numerator, &self.denominator * &other.denominator)
    }

    fn negated(&self) -> Self {
        Self {
            numerator: self.numerator.negated(),
            denominator: self.denominator.clone(),
        }
    }

    fn inverse(&self) -> Option<Self> {
        if let SurdInteger::Rational(own) = &self.numerator {
            // In lowest terms as it stands.
            let (above, below) = match Ring::sign(own) {
                Ordering::Greater => (self.denominator.clone(), own.clone()),
                Ordering::Less => (-&self.denominator, -own),
                Ordering::Equal => return None,
            };
            return Some(Self {
                numerator: SurdInteger::Rational(above),
                denominator: below,
            });
        }
        let (numerator, denominator) = self.numerator.inverse()?;
        Some(Self::lowest(
            numerator.scaled(&self.denominator),
            denominator,
        ))
    }

    fn sign(&self) -> Ordering {
        self.numerator.sign()
    }

    fn square_root(&self) -> Option<Self> {
        root_within(self, self.level())
    }
}

impl PartialOrd for Surd {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Surd {
    fn cmp(&self, other: &Self) -> Ordering {
        let left = self.numerator.scaled(&other.denominator);
        let right = other.numerator.scaled(&self.denominator);
        match (left.as_integer(), right.as_integer()) {
            (Some(left), Some(right)) => left.cmp(right),
            _ => left.minus(&right).sign(),
        }
    }
}

impl From<Rational> for Surd {
    fn from(value: Rational) -> Self {
        let (numerator, denominator) = value.into_parts();
        Self {
            numerator: SurdInteger::Rational(numerator),
            denominator,
        }
    }
}

impl From<i64> for Surd {
    fn from(value: i64) -> Self {
        Self::from(Integer::from(value))
    }
}

impl From<Integer> for Surd {
    fn from(value: Integer) -> Self {
        Self::integral(SurdInteger::Rational(value))
    }
}

/// `3/2 + 1/4*√2`, every radical written out.
impl fmt::Display for Surd {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&super::radicals(&self.numerator, &self.denominator))
    }
}

/// Reads a rational number: `7`, `-3/2`, `0.25`, `1.5e-3`.
impl FromStr for Surd {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        text.parse::<Rational>().map(Self::from)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $field:ident) => {
        impl $trait<&Surd> for &Surd {
            type Output = Surd;
            fn $method(self, other: &Surd) -> Surd {
                Field::$field(self, other)
            }
        }
    };
}

operator!(Add, add, plus);
operator!(Sub, sub, minus);
operator!(Mul, mul, times);

/// The quotient; the divisor is not 0.
impl Div<&Surd> for &Surd {
    type Output = Surd;
    fn div(self, other: &Surd) -> Surd {
        other
            .inverse()
            .map_or_else(Surd::zero, |inverse| self.times(&inverse))
    }
}

impl Neg for &Surd {
    type Output = Surd;
    fn neg(self) -> Surd {
        self.negated()
    }
}
