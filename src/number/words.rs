//! Lists of integers in words of two's complement to the base 2⁶⁴, as many for each number, the
//! lowest first.

use num_bigint::Sign;

use super::{Integer, Ring};

/// a += b, the carry out of the last word dropped.
pub(super) fn add(sum: &mut [u64], other: &[u64]) {
    let mut carry = false;
    for (own, other) in sum.iter_mut().zip(other) {
        let (partial, first) = own.overflowing_add(*other);
        let (total, second) = partial.overflowing_add(u64::from(carry));
        (*own, carry) = (total, first | second);
    }
}

/// a −= b, the borrow from the last word dropped.
pub(super) fn subtract(difference: &mut [u64], other: &[u64]) {
    let mut borrow = false;
    for (own, other) in difference.iter_mut().zip(other) {
        let (partial, first) = own.overflowing_sub(*other);
        let (total, second) = partial.overflowing_sub(u64::from(borrow));
        (*own, borrow) = (total, first | second);
    }
}

/// a += b for the words of an integer; `room` is overwritten.
pub(super) fn add_integer(sum: &mut [u64], value: &Integer, room: &mut [u64]) {
    room.fill(0);
    value.write_digits(room);
    if Ring::sign(value).is_lt() {
        subtract(sum, room);
    } else {
        add(sum, room);
    }
}

/// a += b c for b and c without a sign, whose product has no more digits than a.
pub(super) fn add_product(sum: &mut [u64], left: &[u64], right: &[u64]) {
    for (shift, own) in left.iter().enumerate().filter(|(_, own)| **own != 0) {
        let mut carry = 0;
        let mut places = sum[shift..].iter_mut();
        for (other, place) in right.iter().zip(places.by_ref()) {
            let total = u128::from(*own) * u128::from(*other) + u128::from(*place) + carry;
            (*place, carry) = (low(total), total >> 64);
        }
        for place in places {
            if carry == 0 {
                break;
            }
            let total = u128::from(*place) + carry;
            (*place, carry) = (low(total), total >> 64);
        }
    }
}

fn low(value: u128) -> u64 {
    u64::try_from(value & u128::from(u64::MAX)).unwrap_or_default()
}

/// The number of these words.
pub(super) fn integer(words: &[u64]) -> Integer {
    let negative = words.last().is_some_and(|own| own >> 63 == 1);
    let fill = if negative { u64::MAX } else { 0 };
    let word = |index: usize| u128::from(words.get(index).copied().unwrap_or(fill));
    if words.iter().skip(2).all(|own| *own == fill) && word(1) >> 63 == u128::from(fill & 1) {
        return Integer::from((word(1) << 64 | word(0)).cast_signed());
    }
    // −a is the complement of a, and 1.
    let mut carry = negative;
    let digits = words.iter().map(|own| {
        let (digit, next) = (own ^ fill).overflowing_add(u64::from(carry));
        carry = next;
        digit
    });
    let sign = if negative { Sign::Minus } else { Sign::Plus };
    Integer::of_digits(sign, digits)
}

/// Integers as their absolute values, in as many words each, and whether they are negative.
pub(super) struct Signed {
    width: usize,
    words: Vec<u64>,
    negative: Vec<bool>,
}

impl Signed {
    /// The integers of a list, of no more than so many binary digits.
    pub(super) fn of<R: Ring>(list: &[R], bits: u64) -> Self {
        let width = usize::try_from(bits.max(1).div_ceil(64)).unwrap_or_default();
        let mut words = vec![0; list.len() * width];
        for (place, own) in words.chunks_exact_mut(width).zip(list) {
            if let Some(own) = own.as_integer() {
                own.write_digits(place);
            }
        }
        Self {
            width,
            words,
            negative: list.iter().map(|own| own.sign().is_lt()).collect(),
        }
    }

    /// How many numbers there are.
    pub(super) fn len(&self) -> usize {
        self.negative.len()
    }

    /// How many words each has.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// The words of each, and whether it is negative.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&[u64], &bool)> {
        self.words.chunks_exact(self.width).zip(&self.negative)
    }
}
