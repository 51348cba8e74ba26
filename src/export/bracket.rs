use std::cmp::Ordering;

use crate::number::{Integer, Leading, Ring};

/// Integers l and h of at most 64 digits, l of 62 at least, and an exponent e: what is known of a
/// number with l · 2ᵉ < |q| < h · 2ᵉ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Bracket {
    low: u64,
    high: u64,
    exponent: i64,
}

impl Bracket {
    /// Of the quotient n/d of rational integers that are not 0; none where it takes 65 digits.
    ///
    /// Let |n| = (a + ε) 2ʲ and |d| = (b + δ) 2ᵏ with 128 digits a and b, and let a′ = ⌊a/2⌋ and
    /// b′ = ⌊b/2⁶⁴⌋ ≥ 2⁶³. Then |n/d| = r 2ᵉ with e = j − k − 63 and a′/(b′ + 1) < r < (a′ + 1)/b′.
    /// For t = ⌊a′/b′⌋ < 2⁶⁴ the right side is at most t + 1, and the left one more than t − 2, as
    /// a′/b′ − a′/(b′ + 1) = (a′/b′)/(b′ + 1) < 2.
    pub(super) fn of_integers(numerator: &Integer, divisor: &Integer) -> Option<Self> {
        let ((a, j), (b, k)) = (numerator.leading_digits(), divisor.leading_digits());
        let quotient = u64::try_from((a >> 1) / (b >> 64)).ok()?;
        Some(Self {
            low: quotient - 2,
            high: quotient.checked_add(1)?,
            exponent: j.checked_sub(k)? - 63,
        })
    }

    /// Of the quotient n/d of numbers known by their leading digits; none where it takes 65 digits.
    ///
    /// With |n| in [a, a′] 2ʲ and |d| in [b, b′] 2ᵏ, a′ < 2¹²⁵, and ⌊b/2⁶⁰⌋ ≥ 2⁶²: |n/d| = r 2ᵉ
    /// with e = j − k − 63 and 2³a/(⌊b′/2⁶⁰⌋ + 1) < r < ⌊2³a′/⌊b/2⁶⁰⌋⌋ + 1.
    pub(super) fn of_leading(numerator: Leading, divisor: Leading) -> Option<Self> {
        let ((a_low, a_high, j), (b_low, b_high, k)) = (numerator.ends(), divisor.ends());
        let low = (a_low << 3) / ((b_high >> 60) + 1);
        let high = (a_high << 3) / (b_low >> 60) + 1;
        Some(Self {
            low: u64::try_from(low).ok()?,
            high: u64::try_from(high).ok()?,
            exponent: j.checked_sub(k)? - 63,
        })
    }

    /// What its numbers round to, of the numbers m · 2ˢ with m of so many digits.
    ///
    /// Halfway points are integers here, and the ends are no numbers of the bracket: so all up to
    /// h round at most as h − 1 does, and all from l on at least as l does where that is a tie.
    pub(super) fn rounded(self, digits: u32) -> Option<Rounded> {
        let dropped = (u64::BITS - self.low.leading_zeros()).checked_sub(digits)?;
        let twice = dropped.checked_sub(1)?;
        let [least, greatest] = [self.low, self.high - 1].map(|own| ((own >> twice) + 1) >> 1);
        (greatest - least < 2).then(|| Rounded {
            mantissa: least,
            step: self.exponent + i64::from(dropped),
            decided: least == greatest,
        })
    }
}

/// The number m · 2ˢ that all of a bracket rounds to; or, if that is not decided, this or the next
/// one: the halfway point (m + ½) 2ˢ lies in the bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rounded {
    pub(super) mantissa: u64,
    pub(super) step: i64,
    pub(super) decided: bool,
}

impl Rounded {
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
