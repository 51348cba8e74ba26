#![allow(
    clippy::disallowed_types,
    reason = "the one place where exact numbers become doubles"
)]

use crate::number::{Field, Integer, Leading, LeadingWord, Rational, Real, Ring};

use super::rounded::Rounded;

/// The bits of a double below its exponent.
const FRACTION_BITS: i64 = Precision::Double.fraction_bits();
/// Every double is an integer times 2⁻¹⁰⁷⁴.
const LEAST_EXPONENT: i64 = Precision::Double.least_exponent();

/// A binary format of IEEE 754.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 32 bits; every such number is a [`Double`] too.
    Single,
    /// 64 bits.
    Double,
}

impl Precision {
    /// The bits below the exponent.
    #[must_use]
    pub const fn fraction_bits(self) -> i64 {
        match self {
            Self::Single => 23,
            Self::Double => 52,
        }
    }

    /// Every number is an integer times 2 to this power.
    const fn least_exponent(self) -> i64 {
        match self {
            Self::Single => -149,
            Self::Double => -1_074,
        }
    }

    /// Every number is less than 2 to this power.
    const fn exponent_bound(self) -> i64 {
        match self {
            Self::Single => 128,
            Self::Double => 1_024,
        }
    }
}

/// An IEEE 754 double that is a number: neither infinite nor −0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Double {
    bits: u64,
}

impl Double {
    /// The double nearest to a number, of two the one with an even last bit.
    ///
    /// None if the number is 2¹⁰²⁴ − 2⁹⁷⁰ or more in absolute value: beyond the last double by
    /// half a step. What rounds to zero is +0.
    ///
    /// - **holds** |q − d| ≤ |q − e| for every double e
    #[must_use]
    pub fn nearest(exact: &Real) -> Option<Self> {
        Self::nearest_in(Precision::Double, exact)
    }

    /// The number of a format nearest to a number, of two the one with an even last bit; none
    /// beyond the last one by half a step.
    #[must_use]
    pub fn nearest_in(precision: Precision, exact: &Real) -> Option<Self> {
        let (numerator, denominator) = (exact.numerator(), exact.denominator());
        Self::nearest_quotient(precision, numerator, &Ring::from_integer(denominator))
    }

    /// The number of a format nearest to n/d for numbers n and d ≠ 0 of a ring, as
    /// [`Double::nearest_in`]: without dividing wherever the leading digits decide, or an exact
    /// comparison with the one halfway point near them.
    #[must_use]
    pub fn nearest_quotient<R: Ring>(
        precision: Precision,
        numerator: &R,
        divisor: &R,
    ) -> Option<Self>
    where
        Real: Field<Ring = R>,
    {
        if let (Some(numerator), Some(divisor)) = (numerator.as_integer(), divisor.as_integer()) {
            return Self::nearest_to_quotient(precision, numerator, divisor);
        }
        if numerator.is_zero() {
            return Some(Self::default());
        }
        let nearest = || {
            let quotient = numerator.leading()?.times(divisor.leading()?.inverse()?)?;
            Self::led(precision, quotient, numerator, divisor)
        };
        nearest().or_else(|| {
            let whole = |own: &R| Real::from_parts(own.clone(), Integer::from(1));
            let exact = whole(numerator).times(&whole(divisor).inverse()?);
            // An irrational number is no tie, so its narrow enclosures round to one double; beyond
            // the doubles there are two ends.
            let nearest = |own: &Rational| {
                let (numerator, denominator) = (own.numerator(), own.denominator());
                let nearest = Self::nearest_to_quotient(precision, numerator, denominator);
                nearest.ok_or(Field::sign(own))
            };
            exact.decide(nearest).ok()
        })
    }

    /// The double nearest to every number with some leading digits; none where these do not decide,
    /// or where it is not normal.
    #[must_use]
    pub(super) fn nearest_to_leading(leading: Leading) -> Option<Self> {
        if leading.sign().is_eq() {
            return Some(Self::default());
        }
        let rounded = Self::rounded(Precision::Double, leading)?;
        let double = Self::of_parts(leading.sign().is_lt(), rounded.mantissa, rounded.step);
        rounded.decided.then_some(double)
    }

    /// The double nearest to every number with a leading word, as [`Double::nearest_to_leading`].
    ///
    /// Of 64 digits 11 are dropped. As there, the number below a power of two is no exception: the
    /// error is less than half of the short steps there.
    #[must_use]
    #[inline]
    pub(super) fn nearest_to_word(word: LeadingWord) -> Option<Self> {
        const DROPPED: u32 = 11;
        const HALF: u64 = 1 << (DROPPED - 1);
        let (size, error, exponent) = word.parts();
        if size == 0 {
            return Some(Self::default());
        }
        let rest = size & (2 * HALF - 1);
        let step = exponent + i64::from(DROPPED);
        let normal = LEAST_EXPONENT..Precision::Double.exponent_bound() - FRACTION_BITS - 1;
        if error >= HALF / 2 || rest.abs_diff(HALF) <= error || !normal.contains(&step) {
            return None;
        }
        let mantissa = (size >> DROPPED) + u64::from(rest > HALF);
        // The leading bit of the mantissa, or its carry, counts in the exponent.
        let binade = (step - LEAST_EXPONENT).unsigned_abs() << FRACTION_BITS;
        let sign = u64::from(word.is_negative()) << 63;
        Some(Self {
            bits: (binade + mantissa) | sign,
        })
    }

    /// The number of a format nearest to n/d, which is not 0, by its leading digits; none where few
    /// are known, or where it is not normal.
    fn led<R: Ring>(
        precision: Precision,
        quotient: Leading,
        numerator: &R,
        divisor: &R,
    ) -> Option<Self> {
        let rounded = Self::rounded(precision, quotient)?;
        let mantissa = rounded.decide(numerator, divisor);
        Some(Self::of_parts(
            quotient.sign().is_lt(),
            mantissa,
            rounded.step,
        ))
    }

    /// A mantissa of the length that normal numbers have, none for others.
    fn rounded(precision: Precision, leading: Leading) -> Option<Rounded> {
        let digits = precision.fraction_bits() + 1;
        let rounded = Rounded::of(leading, u32::try_from(digits).ok()?)?;
        let normal = precision.least_exponent()..precision.exponent_bound() - digits;
        normal.contains(&rounded.step).then_some(rounded)
    }

    /// The number of a format nearest to n/d with d ≠ 0, as [`Double::nearest_in`]; n and d may
    /// have a common factor.
    #[must_use]
    pub fn nearest_to_quotient(
        precision: Precision,
        numerator: &Integer,
        denominator: &Integer,
    ) -> Option<Self> {
        if Ring::is_zero(numerator) {
            return Some(Self::default());
        }
        // Small integers are numbers of every format.
        if let (Ok(own), true) = (i64::try_from(numerator), denominator.is_one())
            && own.unsigned_abs() < 1 << (precision.fraction_bits() + 1)
        {
            return Some(Self::of_parts(own < 0, own.unsigned_abs(), 0));
        }
        let nearest = || {
            let inverse = Leading::of_integer(denominator).inverse()?;
            let quotient = Leading::of_integer(numerator).times(inverse)?;
            Self::led(precision, quotient, numerator, denominator)
        };
        nearest().or_else(|| Self::by_division(precision, numerator, denominator))
    }

    /// The number of a format nearest to n/d, which is not 0, by exact division.
    fn by_division(
        precision: Precision,
        numerator: &Integer,
        denominator: &Integer,
    ) -> Option<Self> {
        let negative = Ring::sign(numerator) != Ring::sign(denominator);
        let (numerator, denominator) = (numerator.abs(), denominator.abs());
        let (above, below) = (length(&numerator), length(&denominator));
        if above - below > precision.exponent_bound() {
            return None;
        }
        // 2^top ≤ |q| < 2^(top + 1), and the mantissa counts steps of 2^step.
        let trial = above - below;
        let (left, right) = shifted(&numerator, &denominator, trial);
        let top = if left < right { trial - 1 } else { trial };
        let step = (top - precision.fraction_bits()).max(precision.least_exponent());
        let (dividend, divisor) = shifted(&numerator, &denominator, step);
        let quotient = &dividend / &divisor;
        let twice = (dividend - &quotient * &divisor) * 2_u8;
        let mantissa = u64::try_from(quotient).ok()?;
        let up = twice > divisor || (twice == divisor && mantissa & 1 == 1);
        let mantissa = mantissa + u64::from(up);
        let bits = i64::from(u64::BITS - mantissa.leading_zeros());
        if bits + step > precision.exponent_bound() {
            return None;
        }
        Some(Self::of_parts(negative, mantissa, step))
    }

    /// The number of a format nearest to √(p/q) or, if it is to be negative, to −√(p/q); p ≥ 0,
    /// q > 0.
    ///
    /// With t ≤ 2^e √(p/q) < t + 1 for an integer t of at least 64 digits, every number of the
    /// format near the root, and every middle between two of them, is a multiple of 2^−e. So none
    /// lies strictly between t and t + 1, and t + ½ rounds as the root does unless t² = 4^e p/q.
    /// For t the integral part of the quotient will do: ⌊√x⌋ = ⌊√⌊x⌋⌋.
    #[must_use]
    pub fn nearest_to_root(
        precision: Precision,
        negative: bool,
        square: (&Integer, &Integer),
    ) -> Option<Self> {
        let (above, below) = square;
        let digits = length(above) - length(below);
        let exponent = (2 * 65 - digits).div_euclid(2) + 1;
        let (dividend, divisor) = shifted(above, below, -2 * exponent);
        let root = (&dividend / &divisor).sqrt();
        let is_exact = &root * &root * &divisor == dividend;
        Self::of_root(precision, negative, (root, is_exact), exponent)
    }

    /// The number of a format nearest to √q for all q ≥ 0 with some leading digits, or to −√q; none
    /// where there are two.
    ///
    /// As [`Double::nearest_to_root`] for both ends, with a t of 60 digits or more.
    #[must_use]
    pub(super) fn nearest_to_root_of_leading(
        precision: Precision,
        negative: bool,
        square: Leading,
    ) -> Option<Self> {
        let (size, error, exponent) = square.parts();
        if size == 0 {
            return Some(Self::default());
        }
        let odd = exponent.rem_euclid(2);
        let nearest = |size: u128| {
            let root = (size >> odd).isqrt();
            let is_exact = (root * root) << odd == size;
            let root = (Integer::from(root), is_exact);
            Self::of_root(precision, negative, root, -(exponent + odd) / 2)
        };
        let lower = nearest(size.checked_sub(error.into())?)?;
        let upper = nearest(size.checked_add(error.into())?)?;
        (lower == upper).then_some(lower)
    }

    /// The number of a format nearest to ±t 2^−e for an exact t, else to ±(t + ½) 2^−e.
    fn of_root(
        precision: Precision,
        negative: bool,
        (root, is_exact): (Integer, bool),
        exponent: i64,
    ) -> Option<Self> {
        let twice = root * 2_u8 + u8::from(!is_exact);
        let twice = if negative { -twice } else { twice };
        let (numerator, denominator) = shifted(&twice, &Integer::from(1), exponent + 1);
        Self::nearest_to_quotient(precision, &numerator, &denominator)
    }

    /// ± m · 2^step, which is a double.
    fn of_parts(negative: bool, mantissa: u64, step: i64) -> Self {
        let digits = i64::from(u64::BITS - mantissa.leading_zeros());
        let shift = (FRACTION_BITS + 1 - digits).min(step - LEAST_EXPONENT);
        // A carry has left a zero below.
        let mantissa = if shift < 0 {
            mantissa >> shift.unsigned_abs()
        } else {
            mantissa << shift.unsigned_abs()
        };
        // The exponent is added to the mantissa with its leading bit.
        let binade = (step - shift - LEAST_EXPONENT).unsigned_abs() << FRACTION_BITS;
        let bits = if mantissa == 0 { 0 } else { binade + mantissa };
        let sign = u64::from(negative && bits != 0) << 63;
        Self { bits: bits | sign }
    }

    /// The number that it is.
    #[must_use]
    pub fn exact(self) -> Real {
        Real::from(self.rational())
    }

    /// The number that it is, as a rational one.
    #[must_use]
    pub fn rational(self) -> Rational {
        let (mantissa, step) = self.parts();
        let (numerator, denominator) = shifted(&mantissa, &Integer::from(1), -step);
        Rational::new(numerator, denominator)
    }

    /// m and s with the number m · 2^s; m has the sign.
    #[must_use]
    pub fn parts(self) -> (Integer, i64) {
        let biased = i64::try_from(self.bits << 1 >> (FRACTION_BITS + 1)).unwrap_or_default();
        let fraction = self.bits & ((1 << FRACTION_BITS) - 1);
        let leading = u64::from(biased > 0) << FRACTION_BITS;
        let mantissa = Integer::from(fraction | leading);
        let mantissa = if self.bits >> 63 == 1 {
            -mantissa
        } else {
            mantissa
        };
        (mantissa, biased.max(1) - 1 + LEAST_EXPONENT)
    }

    /// The bytes of the number, the lowest first: four in the format of 32 bits, which holds it
    /// if it was rounded so, or eight.
    #[must_use]
    pub fn bytes(self, precision: Precision) -> Vec<u8> {
        match precision {
            Precision::Single => (self.value() as f32).to_le_bytes().to_vec(),
            Precision::Double => self.value().to_le_bytes().to_vec(),
        }
    }

    /// The double itself.
    #[must_use]
    pub fn value(self) -> f64 {
        f64::from_bits(self.bits)
    }

    /// The number of the other sign.
    #[must_use]
    pub fn negated(self) -> Self {
        let sign = u64::from(self.bits != 0) << 63;
        Self {
            bits: self.bits ^ sign,
        }
    }

    /// Whether it is at least as large as another, signs left out.
    #[must_use]
    pub fn reaches(self, other: Self) -> bool {
        self.bits << 1 >= other.bits << 1
    }

    /// Whether it is 0.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.bits == 0
    }

    /// Whether it is 0 or less than 2⁻¹⁰²² in absolute value, where doubles lose digits.
    #[must_use]
    pub fn is_tiny(self) -> bool {
        self.bits << 1 >> (FRACTION_BITS + 1) == 0
    }

    /// The shortest decimal that reads back as this double, for JSON: `1.0`, `0.1`, `1.5e-7`.
    #[must_use]
    pub fn json(self) -> String {
        format!("{:?}", self.value())
    }

    /// The shortest decimal that reads back as this double, for STEP: always with a point, an
    /// upper-case E: `1.`, `0.1`, `1.5E-7`.
    #[must_use]
    pub fn step(self) -> String {
        let text = self.json();
        let (mantissa, exponent) = match text.split_once('e') {
            Some((mantissa, exponent)) => (mantissa, format!("E{exponent}")),
            None => (text.as_str(), String::new()),
        };
        let mantissa = mantissa.strip_suffix(".0").unwrap_or(mantissa);
        let point = if mantissa.contains('.') { "" } else { "." };
        format!("{mantissa}{point}{exponent}")
    }
}

/// The power of ten at or below the absolute value of a number that is not 0: `1e308`.
pub(super) fn magnitude(exact: &Real) -> String {
    let question = |own: &Rational| {
        let positive = Field::sign(own).is_gt();
        positive.then(|| magnitude_of_rational(own))
    };
    exact.absolute().decide(question).unwrap_or_default()
}

fn magnitude_of_rational(exact: &Rational) -> String {
    let (numerator, denominator) = (exact.numerator().abs(), exact.denominator());
    let digits = |quotient: Integer| quotient.to_string().len() - 1;
    if numerator >= *denominator {
        return format!("1e{}", digits(&numerator / denominator));
    }
    // 10⁻ᵏ ≤ n/d exactly if d/n ≤ 10ᵏ, so k counts the digits of ⌈d/n⌉ − 1.
    let below = (denominator - 1_u8) / numerator;
    format!("1e-{}", digits(below) + 1)
}

/// n and d with n/d divided by 2^exponent.
fn shifted(numerator: &Integer, denominator: &Integer, exponent: i64) -> (Integer, Integer) {
    if exponent >= 0 {
        (numerator.clone(), denominator << exponent)
    } else {
        (numerator << -exponent, denominator.clone())
    }
}

/// The number of bits.
fn length(value: &Integer) -> i64 {
    i64::try_from(value.bits()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::Tower;

    /// Numbers of all lengths, and those near ties of doubles and near powers of two.
    fn integers() -> impl Strategy<Value = Integer> {
        let near = (0_u32..1_200, 0_u32..70, -3_i64..4).prop_map(|(power, last, step)| {
            (Integer::from(1) << power) + (Integer::from(step) << last)
        });
        let tie = (any::<u64>(), 0_u32..1_100, -1_i64..2)
            .prop_map(|(own, power, step)| (Integer::from(own >> 10 | 1) << power) + step);
        let any = (any::<i128>(), 0_u32..1_100)
            .prop_map(|(own, power)| Integer::from(own >> (power % 120) >> 1) << (power / 4));
        prop_oneof![near, tie, any]
    }

    proptest! {
        #[test]
        fn a_leading_word_decides_only_what_is_so(above in integers(), below in integers()) {
            prop_assume!(!Ring::is_zero(&below));
            let [word, inverse] = [&above, &below].map(LeadingWord::of_integer);
            let quotient = inverse.inverse().and_then(|own| own.times(word));
            let exact = Real::ratio(above.clone(), below.clone());
            for (word, exact) in [(Some(word), Real::from(above)), (quotient, exact)] {
                if let Some(double) = word.and_then(Double::nearest_to_word) {
                    prop_assert_eq!(Some(double), Double::nearest(&exact), "{}", exact);
                }
            }
        }
    }

    /// (1 − √2)ⁿ
    fn power(exponent: i64) -> Real {
        let root = Tower::new(2).square_root(&Real::from(2));
        let base = root.map(|root| &Real::one() - &root);
        let power = base.ok().and_then(|base| base.power(exponent));
        power.unwrap_or_else(Real::zero)
    }

    #[test]
    fn conjugates_that_nearly_cancel_have_doubles() {
        // 1000 log₁₀(1 + √2) = 382.7757…; the coefficients of the power have as many digits
        assert_eq!(magnitude(&power(100)), "1e-39");
        assert_eq!(magnitude(&power(-1_001)), "1e383");
        assert_eq!(magnitude(&power(1_001)), "1e-384");
        let double = |own: &Real| Double::nearest(own).map(Double::json);
        // 10⁷⁰⁰ cancels down to a number of the size 1
        let near = &power(2_000) + &power(0);
        assert_eq!(double(&near).as_deref(), Some("1.0"));
        assert_eq!(double(&power(2_001)).as_deref(), Some("0.0"));
        assert_eq!(double(&power(-2_001)), None);
    }
}
