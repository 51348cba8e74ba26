use std::cmp::Ordering;

use super::{Enclosure, Integer, Ring};

/// A real number by its leading digits: it differs from m · 2ᵏ by at most e · 2ᵏ, and m is 0 only
/// for the number 0.
///
/// Operations take machine numbers only, however long the number is, so the cost of an answer does
/// not depend on its size. What holds everywhere in the interval is proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Leading {
    /// m, which has [`Leading::DIGITS`] binary digits, or is 0
    mantissa: i128,
    /// e
    error: u64,
    /// k
    exponent: i64,
}

/// Products and inverses are bounded for errors below this; with a greater one no double is decided.
const LIMIT: u64 = 1 << 60;

impl Leading {
    /// The binary digits of a mantissa; all but 64 of them are sure.
    pub const DIGITS: u32 = 124;

    /// 0
    #[must_use]
    pub const fn zero() -> Self {
        Self {
            mantissa: 0,
            error: 0,
            exponent: 0,
        }
    }

    /// A rational integer.
    #[must_use]
    pub fn of_integer(value: &Integer) -> Self {
        const DROPPED: u32 = u128::BITS - Leading::DIGITS;
        let (digits, exponent) = value.leading_digits();
        let size = i128::try_from(digits >> DROPPED).unwrap_or_default();
        let exact = value.machine().is_some() && digits.trailing_zeros() >= DROPPED;
        Self {
            mantissa: if Ring::sign(value).is_lt() {
                -size
            } else {
                size
            },
            error: u64::from(!exact),
            exponent: exponent + i64::from(DROPPED),
        }
    }

    /// A number in an interval that does not hold 0; none if it is wider than a few units of the
    /// last digit.
    pub(super) fn of_enclosure(enclosure: &Enclosure) -> Option<Self> {
        enclosure.sign().filter(|own| own.is_ne())?;
        let lower = Self::of_integer(enclosure.lower());
        let width = u64::try_from(&enclosure.width()).ok()?;
        // A last digit counts as much as a step of the enclosure, or more.
        let error = lower.error.checked_add(width)?;
        (lower.exponent >= 0).then(|| Self {
            error,
            exponent: lower.exponent - i64::from(enclosure.precision()),
            ..lower
        })
    }

    /// The number m · 2ᵏ up to e · 2ᵏ with |m| < 2¹²⁷; none if few digits are sure.
    fn normal(mantissa: i128, error: u64, exponent: i64) -> Option<Self> {
        let size = mantissa.unsigned_abs();
        let digits = u128::BITS - size.leading_zeros();
        let (size, error) = if digits > Self::DIGITS {
            let dropped = digits - Self::DIGITS;
            (size >> dropped, (error >> dropped) + 2)
        } else {
            let missing = Self::DIGITS - digits;
            if error > 0 && error.leading_zeros() < missing {
                return None;
            }
            (
                size << missing,
                error.checked_shl(missing).unwrap_or_default(),
            )
        };
        let size = i128::try_from(size).ok()?;
        Some(Self {
            mantissa: if mantissa < 0 { -size } else { size },
            error,
            exponent: exponent + i64::from(digits) - i64::from(Self::DIGITS),
        })
    }

    /// The sign.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        self.mantissa.cmp(&0)
    }

    /// m, e and k with (m − e) 2ᵏ ≤ |a| ≤ (m + e) 2ᵏ; m has [`Leading::DIGITS`] digits, or is 0.
    #[must_use]
    #[inline]
    pub fn parts(&self) -> (u128, u64, i64) {
        (self.mantissa.unsigned_abs(), self.error, self.exponent)
    }

    /// a + b; none where so much cancels that few digits are sure
    #[must_use]
    pub fn plus(self, other: Self) -> Option<Self> {
        if self.mantissa == 0 {
            return Some(other);
        }
        if other.mantissa == 0 {
            return Some(self);
        }
        let (high, low) = if self.exponent < other.exponent {
            (other, self)
        } else {
            (self, other)
        };
        let shift = high.exponent.checked_sub(low.exponent)?;
        let shift = u32::try_from(shift).unwrap_or(u32::MAX).min(i128::BITS - 1);
        let error = low.error.checked_shr(shift).unwrap_or_default();
        let error = error + 2 * u64::from(shift > 0);
        Self::normal(
            high.mantissa + (low.mantissa >> shift),
            high.error.checked_add(error)?,
            high.exponent,
        )
    }

    /// Itself, if enough digits are sure for a product or an inverse.
    #[inline]
    fn sure(self) -> Option<Self> {
        (self.error < LIMIT).then_some(self)
    }

    /// a b; none where few digits are sure
    ///
    /// |(m ± e)(n ± f) − mn| ≤ |m| f + |n| e + e f < (e + f + 1) 2¹²⁴, as e f ≤ 2¹²⁰, and 2¹²³ or 2¹²⁴
    /// are a unit, of which one more is dropped.
    #[must_use]
    #[inline]
    pub fn times(self, other: Self) -> Option<Self> {
        self.sure().and(other.sure())?;
        let (left, right) = (self.mantissa.unsigned_abs(), other.mantissa.unsigned_abs());
        let exponent = self.exponent.checked_add(other.exponent)?;
        let error = self.error + other.error + 1;
        // m n / 2¹²³
        let size = high_product(left << 4, right << 1);
        let (size, error, exponent) = if size >> Self::DIGITS == 0 {
            (size, 2 * error + 1, exponent + 123)
        } else {
            (size >> 1, error + 1, exponent + 124)
        };
        if size == 0 {
            return Some(Self::zero());
        }
        let size = size.cast_signed();
        let same = (self.mantissa < 0) == (other.mantissa < 0);
        Some(Self {
            mantissa: if same { size } else { -size },
            error,
            exponent,
        })
    }

    /// Σ aᵢ bᵢ; none where so much cancels that few digits are sure
    ///
    /// All products are added up in units of 2ᵍ at the last digit of the largest, where 2ᵍ exceeds
    /// their number: |(m ± e)(n ± f) − mn| < (e + f + 1) 2¹²⁴, and of m n / 2¹²⁴ and of its part
    /// above the unit less than one is dropped.
    #[must_use]
    pub fn sum_of_products(pairs: impl Iterator<Item = (Self, Self)> + Clone) -> Option<Self> {
        let exponents = pairs
            .clone()
            .filter(|(a, b)| a.mantissa != 0 && b.mantissa != 0);
        let exponents = exponents.map(|(a, b)| a.exponent.checked_add(b.exponent));
        let (mut count, mut top) = (0_u64, i64::MIN);
        for own in exponents {
            (count, top) = (count + 1, top.max(own?));
        }
        if count == 0 {
            return Some(Self::zero());
        }
        let guard = u64::BITS - count.leading_zeros();
        let (mut sum, mut error) = (0_i128, 0_u64);
        for (a, b) in pairs {
            let (left, right) = (a.mantissa.unsigned_abs(), b.mantissa.unsigned_abs());
            if left == 0 || right == 0 {
                continue;
            }
            a.sure().and(b.sure())?;
            let below = top.abs_diff(a.exponent + b.exponent);
            let shift = u32::try_from(below)
                .unwrap_or(u32::MAX)
                .saturating_add(guard);
            let size = high_product(left << 4, right)
                .checked_shr(shift)
                .unwrap_or_default();
            let size = size.cast_signed();
            sum += if (a.mantissa < 0) == (b.mantissa < 0) {
                size
            } else {
                -size
            };
            let own = (a.error + b.error + 2).checked_shr(shift);
            let own = own.unwrap_or_default();
            error = error.checked_add(own)?.checked_add(2)?;
        }
        let exponent = top.checked_add(i64::from(Self::DIGITS + guard))?;
        Self::normal(sum, error, exponent)
    }

    /// 1/a; none for 0, and where few digits are sure
    ///
    /// Newton's step from q = ⌊(2¹²⁷ − 1)/d⌋, where d are the leading 64 digits of m: with
    /// t = 2¹⁸⁷ − m q, r = 2⁶⁰q + qt/2¹²⁷ differs from 2²⁴⁷/m by (2²⁴⁷/m) (t/2¹⁸⁷)² < 1, as |t| is
    /// at most 2¹²⁴ + 2⁶¹; what is dropped is 1¼ at most. An error e < 2⁶⁰ of m ≥ 2¹²³ is
    /// one of e/(m − e) 2²⁴⁷/m < 2e + 1.
    #[must_use]
    pub fn inverse(self) -> Option<Self> {
        let size = self.sure()?.mantissa.unsigned_abs();
        let guess = ((1 << 127) - 1_u128).checked_div(size >> 60)?;
        let rest = size.wrapping_mul(guess).wrapping_neg().cast_signed();
        let guess = i128::try_from(guess).ok()?;
        let inverse = (guess << 60) + (((rest >> 61) * guess) >> 66);
        Self::normal(
            if self.mantissa < 0 { -inverse } else { inverse },
            2 * self.error + 4,
            self.exponent.checked_neg()?.checked_sub(247)?,
        )
    }
}

/// ⌊a b / 2¹²⁸⌋
#[inline]
fn high_product(left: u128, right: u128) -> u128 {
    const LOW: u128 = u64::MAX as u128;
    let (a, b, c, d) = (left >> 64, left & LOW, right >> 64, right & LOW);
    let middle = a * d + ((b * d) >> 64);
    let carried = (middle & LOW) + b * c;
    a * c + (middle >> 64) + (carried >> 64)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::{Field, Rational, Real, SurdInteger, Tower};

    /// (m ± e) 2ᵏ holds a number, by enclosures that do not know of leading digits.
    fn holds(leading: Leading, number: &SurdInteger) -> bool {
        let (size, error, exponent) = leading.parts();
        let [least, greatest] = [size - u128::from(error), size + u128::from(error)];
        let power = Real::power_of_two(exponent);
        let [least, greatest] =
            [least, greatest].map(|own| Real::from(Integer::from(own)).times(&power));
        let precision = 256 + u32::try_from(exponent.unsigned_abs()).unwrap_or_default();
        let [lower, upper] = number.enclose(precision).absolute().ends().map(Real::from);
        let negative = number.enclose(precision).sign() == Some(Ordering::Less);
        least <= upper && lower <= greatest && negative == leading.sign().is_lt()
    }

    /// (m ± e) 2ᵏ holds the inverse of a number: then that, times the number, holds 1.
    fn inverts(leading: Leading, number: &SurdInteger) -> bool {
        let (size, error, exponent) = leading.parts();
        let [least, greatest] = [size - u128::from(error), size + u128::from(error)];
        let power = Real::power_of_two(exponent);
        let size = Real::from_parts(number.clone(), Integer::from(1)).absolute();
        let [least, greatest] =
            [least, greatest].map(|own| Real::from(Integer::from(own)).times(&power).times(&size));
        let one = Real::from(1);
        least <= one && one <= greatest && leading.sign() == number.sign()
    }

    /// Small numbers, long ones, and those about a power of two.
    fn integers() -> impl Strategy<Value = Integer> {
        let near =
            (0_u32..300, -2_i64..3).prop_map(|(power, step)| (Integer::from(1) << power) + step);
        let any = (any::<i128>(), 0_u32..200, any::<i64>())
            .prop_map(|(own, power, step)| (Integer::from(own) << power) + step);
        prop_oneof![
            (-9_i64..10).prop_map(Integer::from),
            near.clone(),
            near.prop_map(|own| -own),
            any
        ]
    }

    /// a + b√2 + (c + d√2) √(3 + √2), the first root alone, and sums that nearly cancel.
    fn numbers() -> impl Strategy<Value = SurdInteger> {
        let build = |parts: [Integer; 4]| {
            let tower = Tower::new(8);
            let root = |own: &Real| tower.square_root(own).unwrap_or_else(|_| Real::zero());
            let first = root(&Real::from(2));
            let second = root(&Real::from(3).plus(&first));
            let [a, b, c, d] = parts.map(Real::from);
            let slope = c.plus(&d.times(&first));
            a.plus(&b.times(&first))
                .plus(&slope.times(&second))
                .numerator()
                .clone()
        };
        let any = [integers(), integers(), integers(), integers()].prop_map(build);
        let unit = (0_u32..90).prop_map(move |power| {
            // (1 − √2)ⁿ = a − b√2 with positive a and b
            let (mut a, mut b) = (Integer::from(1), Integer::from(0));
            for _ in 0..power {
                (a, b) = (-&a - &b * 2_u8, -&a - &b);
            }
            build([a, b, Integer::from(0), Integer::from(0)])
        });
        prop_oneof![3 => any, 1 => unit]
    }

    proptest! {
        #[test]
        fn digits_lead_the_number(number in numbers()) {
            match number.leading() {
                Some(leading) => prop_assert!(holds(leading, &number), "{number} {leading:?}"),
                None => prop_assert!(number.as_integer().is_none()),
            }
        }

        #[test]
        fn sums_and_products_are_led_by_theirs(one in numbers(), other in numbers()) {
            if let (Some(left), Some(right)) = (one.leading(), other.leading()) {
                let inverse = left.inverse();
                prop_assert!(inverse.is_none_or(|own| inverts(own, &one)));
                let sure = [left, right].map(|own| own.error < LIMIT);
                prop_assert_eq!(inverse.is_some(), sure[0] && one.sign().is_ne());
                let product = left.times(right);
                prop_assert!(product.is_none_or(|own| holds(own, &one.times(&other))));
                prop_assert_eq!(product.is_some(), sure[0] && sure[1]);
                let sum = left.plus(right);
                prop_assert!(sum.is_none_or(|own| holds(own, &one.plus(&other))));
            }
        }

        #[test]
        fn sums_of_products_are_led_by_theirs(
            pairs in proptest::collection::vec((numbers(), integers()), 1..12),
        ) {
            let mut exact = SurdInteger::zero();
            let mut known = Vec::new();
            for (one, other) in &pairs {
                let other = SurdInteger::from_integer(other);
                exact.add_product(one, &other);
                known.extend(one.leading().zip(other.leading()));
            }
            prop_assume!(known.len() == pairs.len());
            let sum = Leading::sum_of_products(known.iter().copied());
            prop_assert!(sum.is_none_or(|own| holds(own, &exact)), "{exact} {sum:?}");
            let first = pairs[0].0.scaled(&pairs[0].1);
            let alone = Leading::sum_of_products(known.iter().copied().take(1));
            prop_assert!(alone.is_none_or(|own| holds(own, &first)), "{first}");
            let (one, other) = known[0];
            let known = one.times(other).is_some() || first.is_zero();
            prop_assert_eq!(alone.is_some(), known);
        }
    }

    /// Both ends of the interval of a positive number.
    fn ends(own: Leading) -> [Rational; 2] {
        let (size, error, exponent) = own.parts();
        let power = Rational::from(2).power(exponent);
        let end =
            |size: Integer| Rational::from(size).times(power.as_ref().unwrap_or(&Rational::zero()));
        [Integer::from(size) - error, Integer::from(size) + error].map(end)
    }

    /// Positive numbers of all sizes of m and e.
    fn intervals() -> Vec<Leading> {
        let least = 1_i128 << 123;
        let mantissas = [least, least + 1, least / 2 * 3 + 12_345, 2 * least - 1];
        let near = [1, 4, 16, 40, 59, 60, 62, 63].map(|power| 1_u64 << power);
        let near = near.into_iter().flat_map(|own| [own - 1, own, own + 1]);
        let errors: Vec<u64> = near.chain([0]).collect();
        let pairs = mantissas.into_iter().flat_map(|mantissa| {
            let with = move |error: &u64| Leading {
                mantissa,
                error: *error,
                exponent: -7,
            };
            errors.iter().map(with).collect::<Vec<_>>()
        });
        pairs.collect()
    }

    #[test]
    fn results_hold_what_the_ends_of_the_intervals_give() {
        let holds = |own: Leading, exact: &Rational| {
            let [least, greatest] = ends(own);
            least <= *exact && *exact <= greatest
        };
        let mut known = 0;
        for one in intervals() {
            let first = ends(one);
            for exact in first.iter().filter_map(Field::inverse) {
                let inverse = one.inverse();
                assert!(inverse.is_none_or(|own| holds(own, &exact)), "1/{one:?}");
                known += usize::from(inverse.is_some());
            }
            for other in intervals().into_iter().step_by(3) {
                let second = ends(other);
                let products = [
                    one.times(other),
                    Leading::sum_of_products([(one, other)].into_iter()),
                ];
                for own in products.into_iter().flatten() {
                    let exact = [0, 1].map(|end| first[end].times(&second[end]));
                    assert!(
                        exact.iter().all(|exact| holds(own, exact)),
                        "{one:?} {other:?}"
                    );
                    known += 1;
                }
                if let Some(own) = one.plus(other) {
                    let exact = [0, 1].map(|end| first[end].plus(&second[end]));
                    assert!(
                        exact.iter().all(|exact| holds(own, exact)),
                        "{one:?} {other:?}"
                    );
                }
            }
        }
        assert!(known > 3_000);
    }

    #[test]
    fn few_digits_are_no_answer() {
        let half = Leading::of_integer(&(Integer::from(1) << 300_u32));
        let near = Leading::of_integer(&((Integer::from(1) << 300_u32) + 1));
        assert_eq!(
            near.plus(Leading {
                mantissa: -half.mantissa,
                ..half
            }),
            None
        );
        let zero = Leading::of_integer(&Integer::from(0));
        assert_eq!(zero.sign(), Ordering::Equal);
        assert_eq!(near.plus(zero), Some(near));
        assert!(near.times(zero).is_some_and(|own| own.sign().is_eq()));
    }
}
