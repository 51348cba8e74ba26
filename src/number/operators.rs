//! The arithmetic of [`Integer`]: on machine numbers as long as the result is one.

use std::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Shl, Shr, ShrAssign, Sub,
    SubAssign,
};

use num_bigint::BigInt;
use num_traits::{Num, One, Signed, Zero};

use super::integer::Form;
use super::{Integer, Ring, gcd, lcm};

/// The machine result of an operation, unless it is out of range.
fn machine(result: Option<i128>) -> Option<Integer> {
    result
        .filter(|own| *own != i128::MIN)
        .map(Integer::of_machine)
}

#[inline]
fn sum(left: &Integer, right: &Integer) -> Integer {
    if let (Form::Machine(left), Form::Machine(right)) = (left.form(), right.form())
        && let Some(sum) = machine(left.checked_add(*right))
    {
        return sum;
    }
    by_reference(left, right, |left, right| left + right)
}

#[inline]
fn difference(left: &Integer, right: &Integer) -> Integer {
    if let (Form::Machine(left), Form::Machine(right)) = (left.form(), right.form())
        && let Some(difference) = machine(left.checked_sub(*right))
    {
        return difference;
    }
    by_reference(left, right, |left, right| left - right)
}

/// The product of machine numbers, if it is one.
#[inline]
pub(super) fn machine_product(left: i128, right: i128) -> Option<i128> {
    // One instruction for two words; a double word takes a check.
    if let (Ok(left), Ok(right)) = (i64::try_from(left), i64::try_from(right)) {
        return Some(i128::from(left) * i128::from(right));
    }
    let product = left.checked_mul(right)?;
    (product != i128::MIN).then_some(product)
}

/// The quotient of machine numbers, truncated towards 0; the divisor is not 0, the dividend not
/// −2¹²⁷.
#[inline]
#[must_use]
pub fn machine_quotient(left: i128, right: i128) -> i128 {
    // One instruction divides words; −2⁶³/−1 is none.
    if let (Ok(left), Ok(right)) = (i64::try_from(left), i64::try_from(right))
        && let Some(quotient) = left.checked_div(right)
    {
        return quotient.into();
    }
    left / right
}

#[inline]
fn product(left: &Integer, right: &Integer) -> Integer {
    if let (Form::Machine(left), Form::Machine(right)) = (left.form(), right.form())
        && let (Ok(left), Ok(right)) = (i64::try_from(*left), i64::try_from(*right))
    {
        return Integer::of_machine(i128::from(left) * i128::from(right));
    }
    long_product(left, right)
}

fn long_product(left: &Integer, right: &Integer) -> Integer {
    Integer::of_long(match (left.form(), right.form()) {
        (Form::Machine(left), Form::Machine(right)) => {
            if let Some(product) = machine_product(*left, *right) {
                return Integer::of_machine(product);
            }
            BigInt::from(*left) * *right
        }
        (Form::Long(long), Form::Machine(other)) | (Form::Machine(other), Form::Long(long)) => {
            long * *other
        }
        (Form::Long(left), Form::Long(right)) => left * right,
    })
}

/// Truncated towards 0, like the quotient of machine numbers.
#[inline]
fn quotient(left: &Integer, right: &Integer) -> Integer {
    if Ring::is_one(right) {
        return left.clone();
    }
    if let (Form::Machine(left), Form::Machine(right)) = (left.form(), right.form()) {
        return Integer::of_machine(machine_quotient(*left, *right));
    }
    if let (Form::Long(left), Form::Machine(right)) = (left.form(), right.form())
        && let Ok(word) = i64::try_from(*right)
    {
        return Integer::of_long(left / word);
    }
    by_reference(left, right, |left, right| left / right)
}

/// With the sign of the dividend.
#[inline]
fn remainder(left: &Integer, right: &Integer) -> Integer {
    if let (Form::Machine(left), Form::Machine(right)) = (left.form(), right.form()) {
        if let (Ok(left), Ok(right)) = (i64::try_from(*left), i64::try_from(*right))
            && let Some(remainder) = left.checked_rem(right)
        {
            return Integer::of_machine(remainder.into());
        }
        return Integer::of_machine(left % right);
    }
    by_reference(left, right, |left, right| left % right)
}

/// An operation on long numbers, without a copy of those that are long already.
#[cold]
fn by_reference(
    left: &Integer,
    right: &Integer,
    operation: fn(&BigInt, &BigInt) -> BigInt,
) -> Integer {
    Integer::of_long(match (left.form(), right.form()) {
        (Form::Long(left), Form::Long(right)) => operation(left, right),
        (Form::Long(left), Form::Machine(right)) => operation(left, &(*right).into()),
        (Form::Machine(left), Form::Long(right)) => operation(&(*left).into(), right),
        (Form::Machine(left), Form::Machine(right)) => operation(&(*left).into(), &(*right).into()),
    })
}

macro_rules! operators {
    ($($trait:ident $method:ident $function:ident $assign:ident $assign_method:ident;)*) => {$(
        impl $trait<&Integer> for &Integer {
            type Output = Integer;
            #[inline]
            fn $method(self, other: &Integer) -> Integer {
                $function(self, other)
            }
        }
        impl $trait<Integer> for &Integer {
            type Output = Integer;
            #[inline]
            fn $method(self, other: Integer) -> Integer {
                $function(self, &other)
            }
        }
        impl $trait<&Integer> for Integer {
            type Output = Integer;
            #[inline]
            fn $method(self, other: &Integer) -> Integer {
                $function(&self, other)
            }
        }
        impl $trait for Integer {
            type Output = Integer;
            #[inline]
            fn $method(self, other: Integer) -> Integer {
                $function(&self, &other)
            }
        }
        impl $assign<&Integer> for Integer {
            fn $assign_method(&mut self, other: &Integer) {
                *self = $function(self, other);
            }
        }
        impl $assign for Integer {
            fn $assign_method(&mut self, other: Integer) {
                *self = $function(self, &other);
            }
        }
        operators!(@small $trait $method $function $assign $assign_method i32 i64 u8 u32 u64);
    )*};
    (@small $trait:ident $method:ident $function:ident $assign:ident $assign_method:ident $($type:ty)*) => {$(
        impl $trait<$type> for &Integer {
            type Output = Integer;
            fn $method(self, other: $type) -> Integer {
                $function(self, &Integer::of_machine(other.into()))
            }
        }
        impl $trait<$type> for Integer {
            type Output = Integer;
            fn $method(self, other: $type) -> Integer {
                $function(&self, &Integer::of_machine(other.into()))
            }
        }
        impl $assign<$type> for Integer {
            fn $assign_method(&mut self, other: $type) {
                *self = $function(self, &Integer::of_machine(other.into()));
            }
        }
    )*};
}

operators! {
    Add add sum AddAssign add_assign;
    Sub sub difference SubAssign sub_assign;
    Mul mul product MulAssign mul_assign;
    Div div quotient DivAssign div_assign;
    Rem rem remainder RemAssign rem_assign;
}

impl Neg for &Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        match self.form() {
            Form::Machine(own) => Integer::of_machine(-own),
            Form::Long(own) => Integer::of_long(-own),
        }
    }
}

impl Neg for Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        -&self
    }
}

/// n 2ᵏ
fn shifted_left(value: &Integer, shift: u64) -> Integer {
    match value.form() {
        Form::Machine(own) if value.bits() + shift < 127 => Integer::of_machine(own << shift),
        Form::Machine(own) => Integer::of_long(BigInt::from(*own) << shift),
        Form::Long(own) => Integer::of_long(own << shift),
    }
}

/// ⌊n / 2ᵏ⌋
fn shifted_right(value: &Integer, shift: u64) -> Integer {
    match value.form() {
        Form::Machine(own) => Integer::of_machine(own >> shift.min(127)),
        Form::Long(own) => Integer::of_long(own >> shift),
    }
}

macro_rules! shifts {
    ($($type:ty)*) => {$(
        impl Shl<$type> for &Integer {
            type Output = Integer;
            fn shl(self, shift: $type) -> Integer {
                shifted_left(self, u64::try_from(shift).unwrap_or_default())
            }
        }
        impl Shl<$type> for Integer {
            type Output = Integer;
            fn shl(self, shift: $type) -> Integer {
                &self << shift
            }
        }
        impl Shr<$type> for &Integer {
            type Output = Integer;
            fn shr(self, shift: $type) -> Integer {
                shifted_right(self, u64::try_from(shift).unwrap_or_default())
            }
        }
        impl Shr<$type> for Integer {
            type Output = Integer;
            fn shr(self, shift: $type) -> Integer {
                &self >> shift
            }
        }
        impl ShrAssign<$type> for Integer {
            fn shr_assign(&mut self, shift: $type) {
                *self = &*self >> shift;
            }
        }
    )*};
}

shifts!(i32 i64 u32 u64 usize);

impl PartialEq<i64> for Integer {
    fn eq(&self, other: &i64) -> bool {
        self.machine() == Some((*other).into())
    }
}

impl PartialOrd<i64> for Integer {
    fn partial_cmp(&self, other: &i64) -> Option<std::cmp::Ordering> {
        Some(self.cmp(&Self::from(*other)))
    }
}

impl Zero for Integer {
    fn zero() -> Self {
        Ring::zero()
    }

    fn is_zero(&self) -> bool {
        Ring::is_zero(self)
    }
}

impl One for Integer {
    fn one() -> Self {
        Ring::one()
    }
}

impl Num for Integer {
    type FromStrRadixErr = <BigInt as Num>::FromStrRadixErr;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        BigInt::from_str_radix(text, radix).map(Self::of_long)
    }
}

impl Signed for Integer {
    fn abs(&self) -> Self {
        Self::abs(self)
    }

    fn abs_sub(&self, other: &Self) -> Self {
        if self > other {
            self - other
        } else {
            Ring::zero()
        }
    }

    fn signum(&self) -> Self {
        match Ring::sign(self) {
            std::cmp::Ordering::Less => Self::of_machine(-1),
            std::cmp::Ordering::Equal => Self::of_machine(0),
            std::cmp::Ordering::Greater => Self::of_machine(1),
        }
    }

    fn is_positive(&self) -> bool {
        Ring::sign(self).is_gt()
    }

    fn is_negative(&self) -> bool {
        Ring::sign(self).is_lt()
    }
}

/// What fractions of integers ask for.
impl num_integer::Integer for Integer {
    fn div_floor(&self, other: &Self) -> Self {
        Self::div_floor(self, other)
    }

    fn mod_floor(&self, other: &Self) -> Self {
        self.div_mod_floor(other).1
    }

    fn gcd(&self, other: &Self) -> Self {
        gcd(self, other)
    }

    fn lcm(&self, other: &Self) -> Self {
        lcm(self, other)
    }

    fn is_multiple_of(&self, other: &Self) -> bool {
        Ring::is_zero(&(self % other))
    }

    fn is_even(&self) -> bool {
        !self.is_odd()
    }

    fn is_odd(&self) -> bool {
        self.trailing_zeros() == Some(0)
    }

    fn div_rem(&self, other: &Self) -> (Self, Self) {
        (self / other, self % other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers at the edges of words and double words, and beyond.
    fn edges() -> Vec<Integer> {
        let powers = [0, 1, 31, 62, 63, 64, 65, 125, 126, 127, 128, 190_u32];
        let near = |power: u32| {
            let power = BigInt::from(1) << power;
            [-1, 0, 1].map(|step| &power + step)
        };
        let positive = powers.into_iter().flat_map(near);
        let signed = positive.flat_map(|own: BigInt| [own.clone(), -own]);
        signed.map(Integer::of_long).collect()
    }

    fn long(value: &Integer) -> BigInt {
        value.to_string().parse().unwrap_or(BigInt::ZERO)
    }

    #[test]
    fn machine_numbers_and_long_numbers_agree() {
        for left in edges() {
            let own = long(&left);
            assert_eq!(long(&-&left), -&own);
            assert_eq!(left.bits(), own.bits());
            assert_eq!(left.trailing_zeros(), own.trailing_zeros());
            for shift in [0_u32, 1, 63, 64, 126, 127, 200] {
                assert_eq!(long(&(&left << shift)), &own << shift, "{left} << {shift}");
                assert_eq!(long(&(&left >> shift)), &own >> shift, "{left} >> {shift}");
            }
            for right in edges() {
                let other = long(&right);
                assert_eq!(long(&(&left + &right)), &own + &other, "{left} + {right}");
                assert_eq!(long(&(&left - &right)), &own - &other, "{left} - {right}");
                assert_eq!(long(&(&left * &right)), &own * &other, "{left} * {right}");
                assert_eq!(left.cmp(&right), own.cmp(&other), "{left} {right}");
                if !Ring::is_zero(&right) {
                    assert_eq!(long(&(&left / &right)), &own / &other, "{left} / {right}");
                    assert_eq!(long(&(&left % &right)), &own % &other, "{left} % {right}");
                    let floor = num_integer::Integer::div_mod_floor(&own, &other);
                    let (quotient, rest) = left.div_mod_floor(&right);
                    assert_eq!((long(&quotient), long(&rest)), floor, "{left} {right}");
                }
            }
        }
    }

    #[test]
    fn representations_are_canonical() {
        for left in edges() {
            for right in edges() {
                assert_eq!(&(&left + &right) - &right, left);
                if !Ring::is_zero(&right) {
                    assert_eq!(&(&left * &right) / &right, left);
                }
            }
        }
    }
}
