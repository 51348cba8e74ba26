use super::{Integer, Leading, Ring};

/// A real number by its leading word: it differs from ± m · 2ᵏ by at most e · 2ᵏ, and m is 0 only
/// for the number 0.
///
/// As [`Leading`], with half the digits and in a fraction of the time: what it decides is proved,
/// and what it leaves open goes to that.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LeadingWord {
    negative: bool,
    /// m, which has 64 binary digits, or is 0
    mantissa: u64,
    /// e < [`LIMIT`]
    error: u64,
    /// k
    exponent: i64,
}

/// With a greater error nothing is decided any more.
const LIMIT: u64 = 1 << 16;

impl LeadingWord {
    /// 0
    pub const ZERO: Self = Self {
        negative: false,
        mantissa: 0,
        error: 0,
        exponent: 0,
    };

    /// A machine number.
    #[must_use]
    #[inline]
    pub fn of_machine(value: i128) -> Self {
        Self::normal(value, 0)
    }

    /// A rational integer.
    #[must_use]
    pub fn of_integer(value: &Integer) -> Self {
        match value.machine() {
            Some(own) => Self::of_machine(own),
            None => {
                let (digits, exponent) = value.leading_digits();
                Self {
                    negative: Ring::sign(value).is_lt(),
                    mantissa: high_word(digits),
                    error: 1,
                    exponent: exponent + 64,
                }
            }
        }
    }

    /// An element of a ring; none where few digits are known.
    #[must_use]
    pub fn of_element<R: Ring>(value: &R) -> Option<Self> {
        match value.as_integer() {
            Some(own) => Some(Self::of_integer(own)),
            None => value.leading().map(Self::of_leading),
        }
    }

    /// A number of which more digits are known.
    #[must_use]
    #[inline]
    pub fn of_leading(leading: Leading) -> Self {
        const DROPPED: u32 = Leading::DIGITS - u64::BITS;
        let (size, error, exponent) = leading.parts();
        if size == 0 {
            return Self::ZERO;
        }
        Self {
            negative: leading.sign().is_lt(),
            mantissa: high_word(size << (u64::BITS - DROPPED)),
            error: (error >> DROPPED) + 2,
            exponent: exponent + i64::from(DROPPED),
        }
    }

    /// The number n 2ᵏ.
    #[inline]
    fn normal(value: i128, exponent: i64) -> Self {
        let size = value.unsigned_abs();
        if size == 0 {
            return Self::ZERO;
        }
        let zeros = size.leading_zeros();
        let digits = size << zeros;
        Self {
            negative: value < 0,
            mantissa: high_word(digits),
            error: u64::from(digits << 64 != 0),
            exponent: exponent + 64 - i64::from(zeros),
        }
    }

    /// m, e and k with (m − e) 2ᵏ ≤ |a| ≤ (m + e) 2ᵏ; m has 64 digits, or is 0.
    #[must_use]
    #[inline]
    pub fn parts(self) -> (u64, u64, i64) {
        (self.mantissa, self.error, self.exponent)
    }

    /// Whether it is less than 0.
    #[must_use]
    #[inline]
    pub fn is_negative(self) -> bool {
        self.negative
    }

    #[inline]
    fn limited(self) -> Option<Self> {
        (self.error < LIMIT).then_some(self)
    }

    /// a b; none where few digits are sure
    ///
    /// |(m ± e)(n ± f) − mn| ≤ m f + n e + e f < (e + f + 1) 2⁶⁴, and 2⁶³ or 2⁶⁴ are a unit, of
    /// which less than one is dropped.
    #[must_use]
    #[inline]
    pub fn times(self, other: Self) -> Option<Self> {
        let product = u128::from(self.mantissa) * u128::from(other.mantissa);
        if product == 0 {
            return Some(Self::ZERO);
        }
        let error = self.error + other.error + 1;
        // Of two numbers of 64 digits the product has 127 or 128.
        let short = u64::from(product < 1 << 127);
        Self {
            negative: self.negative != other.negative,
            mantissa: high_word(product << short),
            error: (error << short) + 1,
            exponent: self.exponent + other.exponent + 64 - short.cast_signed(),
        }
        .limited()
    }

    /// a + b; none where so much cancels that few digits are sure
    ///
    /// Added up in units of 2⁻⁶² at the last digit of the larger exponent, of which less than one
    /// is dropped.
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
        let shift = u32::try_from(high.exponent - low.exponent).unwrap_or(u32::MAX);
        let shift = shift.min(i128::BITS - 1);
        let signed = |own: Self, shift: u32| {
            let size = (u128::from(own.mantissa) << 62 >> shift).cast_signed();
            if own.negative { -size } else { size }
        };
        let sum = Self::normal(signed(high, 0) + signed(low, shift), high.exponent - 62);
        let error = high.error + low.error.checked_shr(shift).unwrap_or(0) + u64::from(shift > 0);
        if sum.mantissa == 0 {
            return (error == 0).then_some(sum);
        }
        // In units of the sum, which are 2 of the former at most.
        let lost = u32::try_from(high.exponent - sum.exponent).unwrap_or(0);
        Self {
            error: error.checked_mul(1_u64.checked_shl(lost)?)? + sum.error,
            ..sum
        }
        .limited()
    }

    /// 1/a; none for 0
    ///
    /// ⌊(2¹²⁷ − 1)/m⌋ has 64 digits and differs from 2¹²⁷/m by less than 2; an error e of m is one
    /// of less than 2e + 1 in that.
    #[must_use]
    #[inline]
    pub fn inverse(self) -> Option<Self> {
        let quotient = ((1 << 127) - 1_u128).checked_div(self.mantissa.into())?;
        Self {
            negative: self.negative,
            mantissa: u64::try_from(quotient).ok()?,
            error: 2 * self.error + 3,
            exponent: -self.exponent - 127,
        }
        .limited()
    }
}

#[inline]
fn high_word(digits: u128) -> u64 {
    u64::try_from(digits >> 64).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::{Field, Rational};

    /// ± (m ± e) 2ᵏ holds a number.
    fn holds(word: LeadingWord, number: &Rational) -> bool {
        let (size, error, exponent) = word.parts();
        let power = Integer::from(1) << exponent.unsigned_abs();
        let power = if exponent < 0 {
            Rational::new(Integer::from(1), power)
        } else {
            Rational::from(power)
        };
        let size = Rational::from(Integer::from(size)).times(&power);
        let error = Rational::from(Integer::from(error)).times(&power);
        let own = if word.is_negative() {
            number.negated()
        } else {
            number.clone()
        };
        let gap = own.minus(&size);
        let is_long = word.parts().0 >> 63 == 1 || number.is_zero();
        is_long && gap <= error && gap.negated() <= error
    }

    fn known(number: &Integer) -> [LeadingWord; 2] {
        let leading = LeadingWord::of_leading(Leading::of_integer(number));
        [LeadingWord::of_integer(number), leading]
    }

    /// Small numbers, long ones, and those about a power of two.
    fn integers() -> impl Strategy<Value = Integer> {
        let near = (0_u32..300, -2_i64..3, any::<bool>()).prop_map(|(power, step, negative)| {
            let own = (Integer::from(1) << power) + step;
            if negative { -own } else { own }
        });
        let any = (any::<i128>(), 0_u32..200, any::<i64>())
            .prop_map(|(own, power, step)| (Integer::from(own >> 1) << power) + step);
        prop_oneof![(-9_i64..10).prop_map(Integer::from), near, any]
    }

    proptest! {
        #[test]
        fn operations_hold_the_exact_result(one in integers(), other in integers()) {
            let [first, second] = [&one, &other].map(|own| Rational::from(own.clone()));
            for left in known(&one) {
                prop_assert!(holds(left, &first), "{one} {left:?}");
                let inverse = left.inverse();
                prop_assert_eq!(inverse.is_none(), one.sign().is_eq());
                if let (Some(own), Some(exact)) = (inverse, Field::inverse(&first)) {
                    prop_assert!(holds(own, &exact), "1/{one} {own:?}");
                }
                for right in known(&other) {
                    let product = left.times(right);
                    let exact = first.times(&second);
                    prop_assert!(product.is_some_and(|own| holds(own, &exact)), "{one} {other}");
                    let sum = left.plus(right);
                    let exact = first.plus(&second);
                    prop_assert!(sum.is_none_or(|own| holds(own, &exact)), "{one} {other}");
                }
            }
        }

        #[test]
        fn errors_add_up(numbers in proptest::collection::vec(integers(), 1..9)) {
            // ((a + b) c + d) e …
            let mut known = Some(LeadingWord::of_machine(1));
            let mut exact = Rational::one();
            for (index, own) in numbers.iter().enumerate() {
                let word = LeadingWord::of_integer(own);
                let own = Rational::from(own.clone());
                if index % 2 == 0 {
                    known = known.and_then(|all| all.plus(word));
                    exact = exact.plus(&own);
                } else {
                    known = known.and_then(|all| all.times(word));
                    exact = exact.times(&own);
                }
                prop_assert!(known.is_none_or(|own| holds(own, &exact)), "{numbers:?}");
            }
        }
    }

    /// Both ends of the interval of a number.
    fn ends(own: LeadingWord) -> [Rational; 2] {
        let (size, error, exponent) = own.parts();
        let sign = if own.is_negative() { -1 } else { 1 };
        let power = Rational::from(2).power(exponent);
        let end = |size: Integer| {
            Rational::from(size * sign).times(power.as_ref().unwrap_or(&Rational::zero()))
        };
        [Integer::from(size) - error, Integer::from(size) + error].map(end)
    }

    /// Numbers of all sizes of m and e, with an exponent.
    fn intervals(negative: bool, exponent: i64) -> Vec<LeadingWord> {
        let least = 1 << 63;
        let mantissas = [least, least + 1, least / 2 * 3, u64::MAX - 65_536, u64::MAX];
        let with = move |mantissa: u64| {
            [0, 1, 2, 1_023, 32_767, 65_534, 65_535].map(|error| LeadingWord {
                negative,
                mantissa,
                error,
                exponent,
            })
        };
        mantissas.into_iter().flat_map(with).collect()
    }

    #[test]
    fn results_hold_what_the_ends_of_the_intervals_give() {
        let mut known = 0;
        for one in intervals(false, 0) {
            let first = ends(one);
            for exact in first.iter().filter_map(Field::inverse) {
                assert!(
                    one.inverse().is_none_or(|own| holds(own, &exact)),
                    "1/{one:?}"
                );
                known += usize::from(one.inverse().is_some());
            }
            for (exponent, negative) in [0, 1, 15, 16, 17, 62, 63, 64, 65, 127, 128]
                .into_iter()
                .flat_map(|own| [(-own, false), (-own, true)])
            {
                for other in intervals(negative, exponent).into_iter().step_by(4) {
                    let second = ends(other);
                    for (left, right) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        let (left, right) = (&first[left], &second[right]);
                        let product = one.times(other);
                        let sum = one.plus(other);
                        assert!(product.is_none_or(|own| holds(own, &left.times(right))));
                        assert!(sum.is_none_or(|own| holds(own, &left.plus(right))));
                        known += usize::from(product.is_some()) + usize::from(sum.is_some());
                    }
                }
            }
        }
        assert!(known > 3_000);
    }

    #[test]
    fn few_digits_are_no_answer() {
        let power = Integer::from(1) << 300_u32;
        let near = LeadingWord::of_integer(&(&power + 1));
        assert_eq!(near.plus(LeadingWord::of_integer(&-power)), None);
        assert_eq!(near.plus(LeadingWord::ZERO), Some(near));
        assert_eq!(near.times(LeadingWord::ZERO), Some(LeadingWord::ZERO));
    }
}
