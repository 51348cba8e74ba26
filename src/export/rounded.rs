use std::cmp::Ordering;

use crate::number::{Integer, Leading, Ring};

/// The number m · 2ˢ, m of so many digits, that all numbers with some leading digits round to; or,
/// if that is not decided, this or the next one: the halfway point (m + ½) 2ˢ may be among them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rounded {
    pub(super) mantissa: u64,
    pub(super) step: i64,
    pub(super) decided: bool,
}

impl Rounded {
    /// Of absolute values; none where few digits are known.
    ///
    /// The digits are decided where the halfway point is farther away than the error. The numbers
    /// below a power of two, where steps are half as long, are within a small part of a step of it,
    /// and round to it.
    #[inline]
    pub(super) fn of(leading: Leading, digits: u32) -> Option<Self> {
        const ERROR: u64 = 1 << 60;
        let (size, error, exponent) = leading.parts();
        let dropped = Leading::DIGITS.checked_sub(digits)?;
        let half = 1_u128 << dropped.checked_sub(1)?;
        let rest = size & ((half << 1) - 1);
        let decided = rest.abs_diff(half) > u128::from(error);
        let mantissa = u64::try_from(size >> dropped).ok()?;
        (error < ERROR).then(|| Self {
            mantissa: mantissa + u64::from(decided && rest > half),
            step: exponent + i64::from(dropped),
            decided,
        })
    }

    /// m, or m + 1 for a quotient |n/d| beyond the halfway point; the even one for that point.
    pub(super) fn decide<R: Ring>(self, numerator: &R, divisor: &R) -> u64 {
        if self.decided {
            return self.mantissa;
        }
        let size = |own: &R| {
            if own.sign().is_lt() {
                own.negated()
            } else {
                own.clone()
            }
        };
        let (mut above, mut below) = (size(numerator), size(divisor));
        below = below.scaled(&(Integer::from(self.mantissa) * 2_u8 + 1_u8));
        let power = Integer::from(1) << (self.step - 1).unsigned_abs();
        if self.step > 0 {
            below = below.scaled(&power);
        } else {
            above = above.scaled(&power);
        }
        self.mantissa
            + match above.minus(&below).sign() {
                Ordering::Less => 0,
                Ordering::Equal => self.mantissa & 1,
                Ordering::Greater => 1,
            }
    }
}
