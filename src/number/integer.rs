use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use num_bigint::{BigInt, BigUint, Sign};

use super::{Basis, Leading, Place, Ring, binomial_sums, convolution, gcd, halves};

/// A rational integer of any size.
///
/// Below 2¹²⁷ in absolute value it is a machine number, which needs no memory of its own; most
/// coefficients stay there. Equality of values is equality of representations.
#[derive(PartialEq, Eq, Hash)]
pub struct Integer(Form);

#[derive(PartialEq, Eq, Hash)]
pub(super) enum Form {
    /// n ≠ −2¹²⁷, so that −n is one too.
    Machine(i128),
    /// Beyond that.
    Long(BigInt),
}

impl Clone for Integer {
    #[inline]
    fn clone(&self) -> Self {
        match &self.0 {
            Form::Machine(own) => Self(Form::Machine(*own)),
            Form::Long(own) => Self(Form::Long(own.clone())),
        }
    }
}

impl Integer {
    #[inline]
    pub(super) fn form(&self) -> &Form {
        &self.0
    }

    /// A number known to be no −2¹²⁷.
    #[inline]
    pub(super) const fn of_machine(value: i128) -> Self {
        Self(Form::Machine(value))
    }

    pub(super) fn of_long(value: BigInt) -> Self {
        if value.bits() > 127 {
            return Self(Form::Long(value));
        }
        match i128::try_from(&value) {
            Ok(machine) => Self(Form::Machine(machine)),
            _ => Self(Form::Long(value)),
        }
    }

    /// The number as a machine number, if it is one.
    #[must_use]
    #[inline]
    pub fn machine(&self) -> Option<i128> {
        match &self.0 {
            Form::Machine(own) => Some(*own),
            Form::Long(_) => None,
        }
    }

    /// The number of binary digits of |n|; 0 for 0.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Form::Machine(own) => (u128::BITS - own.unsigned_abs().leading_zeros()).into(),
            Form::Long(own) => own.bits(),
        }
    }

    /// |n|
    #[must_use]
    #[inline]
    pub fn abs(&self) -> Self {
        if Ring::sign(self).is_lt() {
            -self
        } else {
            self.clone()
        }
    }

    /// ⌊√n⌋; 0 for negative n
    #[must_use]
    pub fn sqrt(&self) -> Self {
        match &self.0 {
            Form::Machine(own) if *own <= 0 => Ring::zero(),
            Form::Machine(own) => own.unsigned_abs().isqrt().into(),
            Form::Long(own) if own.sign() == Sign::Minus => Ring::zero(),
            Form::Long(own) => Self::of_long(own.sqrt()),
        }
    }

    /// n to a power
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        let bits = (0..u32::BITS - exponent.leading_zeros()).rev();
        bits.fold(Self::from(1), |power, bit| {
            let square = &power * &power;
            if exponent >> bit & 1 == 1 {
                &square * self
            } else {
                square
            }
        })
    }

    /// How often 2 divides it; none for 0.
    #[must_use]
    pub fn trailing_zeros(&self) -> Option<u64> {
        match &self.0 {
            Form::Machine(0) => None,
            Form::Machine(own) => Some(own.trailing_zeros().into()),
            Form::Long(own) => own.trailing_zeros(),
        }
    }

    /// ⌊n/d⌋ and n − d ⌊n/d⌋; d is not 0
    #[must_use]
    pub fn div_mod_floor(&self, divisor: &Self) -> (Self, Self) {
        let (quotient, remainder) = (self / divisor, self % divisor);
        let signs = (Ring::sign(&remainder), Ring::sign(divisor));
        if signs.0.is_ne() && signs.0 != signs.1 {
            (quotient - 1, remainder + divisor)
        } else {
            (quotient, remainder)
        }
    }

    /// ⌊n/d⌋; d is not 0
    #[must_use]
    pub fn div_floor(&self, divisor: &Self) -> Self {
        self.div_mod_floor(divisor).0
    }

    /// The leading 128 digits of |n| for n ≠ 0, and how many follow: |n| = (m + ε) 2ᵏ with
    /// 2¹²⁷ ≤ m < 2¹²⁸ and 0 ≤ ε < 1. The second is negative for small numbers, whose ε is 0.
    #[must_use]
    pub fn leading_digits(&self) -> (u128, i64) {
        match &self.0 {
            Form::Machine(own) => {
                let size = own.unsigned_abs();
                let shift = size.leading_zeros().min(u128::BITS - 1);
                (size << shift, -i64::from(shift))
            }
            Form::Long(own) => {
                let mut digits = own.iter_u64_digits().rev();
                let mut next = || u128::from(digits.next().unwrap_or_default());
                let (high, middle, low) = (next(), next(), next());
                let shift = high.leading_zeros() - u64::BITS;
                let wide = (high << 64 | middle) << shift;
                let size = i64::try_from(own.bits()).unwrap_or(i64::MAX);
                (wide | (low << shift) >> 64, size - 128)
            }
        }
    }

    /// a += b, in the memory of a long number.
    #[inline(never)]
    fn add_long(&mut self, other: &Self) {
        if let Form::Long(own) = &mut self.0 {
            let mut sum = std::mem::take(own);
            match &other.0 {
                Form::Long(other) => sum += other,
                Form::Machine(other) => sum += *other,
            }
            *self = Self::of_long(sum);
        } else {
            *self = &*self + other;
        }
    }

    /// The number of these digits to the base 2⁶⁴, the lowest first.
    pub(super) fn of_digits(sign: Sign, digits: impl ExactSizeIterator<Item = u64>) -> Self {
        let half = |own: u64| u32::try_from(own & u64::from(u32::MAX)).unwrap_or_default();
        let mut halves = Vec::with_capacity(2 * digits.len());
        for own in digits {
            halves.extend([half(own), half(own >> 32)]);
        }
        Self::of_long(BigInt::from_biguint(sign, BigUint::new(halves)))
    }

    /// |n| modulo a number that is not 0.
    pub(super) fn remainder_by_word(&self, divisor: u64) -> u64 {
        let divisor = u128::from(divisor);
        let rest = match &self.0 {
            Form::Machine(own) => own.unsigned_abs() % divisor,
            Form::Long(_) => {
                self.fold_digits(0, |rest, own| (rest << 64 | u128::from(own)) % divisor)
            }
        };
        u64::try_from(rest).unwrap_or_default()
    }

    /// Goes through the digits of |n| to the base 2⁶⁴, the highest first.
    pub(super) fn fold_digits<T>(&self, first: T, mut step: impl FnMut(T, u64) -> T) -> T {
        match &self.0 {
            Form::Machine(own) => {
                let [low, high] = double_word(*own);
                let first = step(first, high);
                step(first, low)
            }
            Form::Long(own) => own.iter_u64_digits().rev().fold(first, step),
        }
    }

    /// Writes the digits of |n| to the base 2⁶⁴ into a list of zeros, the lowest first.
    pub(super) fn write_digits(&self, place: &mut [u64]) {
        let write = |(place, digit): (&mut u64, u64)| *place = digit;
        match &self.0 {
            Form::Machine(own) => place.iter_mut().zip(double_word(*own)).for_each(write),
            Form::Long(own) => place.iter_mut().zip(own.iter_u64_digits()).for_each(write),
        }
    }

    /// The digits of |n| to the base 2⁶⁴, the lowest first.
    pub(super) fn digits(&self) -> Vec<u64> {
        match &self.0 {
            Form::Machine(own) => double_word(*own).to_vec(),
            Form::Long(own) => own.iter_u64_digits().collect(),
        }
    }
}

/// The digits of |n|, the lower first.
fn double_word(value: i128) -> [u64; 2] {
    let size = value.unsigned_abs();
    let low = u64::try_from(size & u128::from(u64::MAX)).unwrap_or_default();
    let high = u64::try_from(size >> 64).unwrap_or_default();
    [low, high]
}

/// 0
impl Default for Integer {
    fn default() -> Self {
        Ring::zero()
    }
}

macro_rules! from_primitive {
    ($($type:ty)*) => {$(
        impl From<$type> for Integer {
            fn from(value: $type) -> Self {
                match i128::try_from(value) {
                    Ok(machine) if machine != i128::MIN => Self(Form::Machine(machine)),
                    _ => Self(Form::Long(BigInt::from(value))),
                }
            }
        }
    )*};
}

from_primitive!(i32 i64 i128 u8 u32 u64 u128 usize);

impl From<BigInt> for Integer {
    fn from(value: BigInt) -> Self {
        Self::of_long(value)
    }
}

impl From<&Integer> for BigInt {
    fn from(value: &Integer) -> Self {
        match value.form() {
            Form::Machine(own) => (*own).into(),
            Form::Long(own) => own.clone(),
        }
    }
}

macro_rules! into_primitive {
    ($($type:ty)*) => {$(
        /// Fails beyond the range of the type.
        impl TryFrom<&Integer> for $type {
            type Error = ();
            fn try_from(value: &Integer) -> Result<Self, ()> {
                <$type>::try_from(value.machine().ok_or(())?).map_err(|_| ())
            }
        }

        /// Fails beyond the range of the type.
        impl TryFrom<Integer> for $type {
            type Error = ();
            fn try_from(value: Integer) -> Result<Self, ()> {
                Self::try_from(&value)
            }
        }
    )*};
}

into_primitive!(i64 u32 u64 usize);

impl PartialOrd for Integer {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Integer {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Machine(left), Form::Machine(right)) => left.cmp(right),
            (Form::Long(left), Form::Long(right)) => left.cmp(right),
            // A long number is beyond every machine number, on the side of its sign.
            (Form::Long(_), Form::Machine(_)) => Ring::sign(self),
            (Form::Machine(_), Form::Long(_)) => Ring::sign(other).reverse(),
        }
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            // A word is spelled faster than two.
            Form::Machine(own) => match i64::try_from(*own) {
                Ok(word) => fmt::Display::fmt(&word, formatter),
                Err(_) => fmt::Display::fmt(own, formatter),
            },
            Form::Long(own) => fmt::Display::fmt(own, formatter),
        }
    }
}

impl fmt::Debug for Integer {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}

impl FromStr for Integer {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        if let Ok(word) = i64::from_str(text) {
            return Ok(word.into());
        }
        match i128::from_str(text) {
            Ok(machine) if machine != i128::MIN => Ok(Self::of_machine(machine)),
            _ => BigInt::from_str(text).map(Self::of_long).map_err(|_| ()),
        }
    }
}

impl Ring for Integer {
    #[inline]
    fn zero() -> Self {
        Self::of_machine(0)
    }

    #[inline]
    fn one() -> Self {
        Self::of_machine(1)
    }

    fn unit() -> &'static Self {
        static ONE: Integer = Integer::of_machine(1);
        &ONE
    }

    fn from_integer(value: &Integer) -> Self {
        value.clone()
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.machine() == Some(0)
    }

    #[inline]
    fn is_one(&self) -> bool {
        self.machine() == Some(1)
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    #[inline]
    fn times(&self, other: &Self) -> Self {
        self * other
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        if let (Form::Machine(own), Form::Machine(other)) = (&mut self.0, &other.0)
            && let Some(sum) = own.checked_add(*other)
            && sum != i128::MIN
        {
            *own = sum;
        } else {
            self.add_long(other);
        }
    }

    #[inline]
    fn add_product(&mut self, left: &Self, right: &Self) {
        if let (Form::Machine(own), Form::Machine(left), Form::Machine(right)) =
            (&mut self.0, &left.0, &right.0)
            && let Some(product) = super::operators::machine_product(*left, *right)
            && let Some(sum) = own.checked_add(product)
            && sum != i128::MIN
        {
            *own = sum;
        } else {
            self.add_long(&(left * right));
        }
    }

    fn convolution(left: &[Self], right: &[Self]) -> Vec<Self> {
        convolution::of_integers(left, right, |own| own)
            .unwrap_or_else(|| convolution::one_by_one(left, right))
    }

    fn binomial_sums(powers: &[Self], degree: usize) -> Vec<Self> {
        binomial_sums::of_integers(powers, degree, |own| own)
            .unwrap_or_else(|| binomial_sums::one_by_one(powers, degree))
    }

    fn halves(coefficients: Vec<Self>) -> (Vec<Self>, Vec<Self>) {
        halves::in_machine_numbers(&coefficients, |own| own)
            .unwrap_or_else(|| halves::one_by_one(coefficients))
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
        let quotient = self / divisor;
        (&quotient * divisor == *self).then_some(quotient)
    }

    fn content(&self) -> Integer {
        self.abs()
    }

    #[inline]
    fn content_with(&self, other: &Integer) -> Integer {
        gcd(other, self)
    }

    #[inline]
    fn sign(&self) -> Ordering {
        match &self.0 {
            Form::Machine(own) => own.cmp(&0),
            Form::Long(own) if own.sign() == Sign::Minus => Ordering::Less,
            Form::Long(_) => Ordering::Greater,
        }
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

    fn basis<'a>(_: impl IntoIterator<Item = &'a Self>) -> Basis {
        Basis::default()
    }

    fn from_components(_: &Basis, components: &[Integer]) -> Self {
        components.first().cloned().unwrap_or_default()
    }

    fn bits(&self) -> u64 {
        Self::bits(self)
    }

    fn as_integer(&self) -> Option<&Integer> {
        Some(self)
    }

    fn leading(&self) -> Option<Leading> {
        Some(Leading::of_integer(self))
    }
}
