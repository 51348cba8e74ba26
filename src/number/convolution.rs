//! Products of polynomials, as lists of coefficients.

use num_bigint::{BigInt, Sign};

use super::words::{add_product, integer, subtract};
use super::{Integer, Ring};

/// The bits of a word.
const WORD: u64 = 64;
/// The digits of products that are machine numbers.
const MACHINE: u64 = 127;
/// Lists shorter than this are multiplied number by number.
const SHORT: usize = 8;
/// So are numbers whose products take no more products of words than this.
const FEW: u64 = 30;

/// The coefficients of the product of two polynomials with these coefficients, number by number.
pub(super) fn one_by_one<R: Ring>(left: &[R], right: &[R]) -> Vec<R> {
    let mut product = vec![R::zero(); left.len() + right.len() - 1];
    for (i, own) in left.iter().enumerate().filter(|(_, own)| !own.is_zero()) {
        for (sum, other) in product[i..].iter_mut().zip(right) {
            sum.add_product(own, other);
        }
    }
    product
}

/// The same for rational integers, by a bound on the digits of the product: in machine numbers, in
/// words, or packed; none where some number is irrational.
pub(super) fn of_integers<R: Ring>(
    left: &[R],
    right: &[R],
    whole: impl Fn(Integer) -> R,
) -> Option<Vec<R>> {
    let shorter = left.len().min(right.len());
    let count = u64::from(shorter.max(1).ilog2()) + 1;
    let (first, second) = (size(left)?, size(right)?);
    let bits = first + second + count;
    if bits <= MACHINE {
        let products = in_machine_numbers(left, right).into_iter();
        return Some(products.map(|own| whole(Integer::from(own))).collect());
    }
    // One bit more for the sign.
    let width = usize::try_from((bits + 1).div_ceil(WORD)).ok()?;
    let few = shorter < SHORT || first.div_ceil(WORD) * second.div_ceil(WORD) <= FEW;
    let words = if few {
        in_words(left, right, width)
    } else {
        packed(left, right, width)
    };
    let products = words.chunks_exact(width);
    Some(products.map(|own| whole(integer(own))).collect())
}

/// The digits of the longest number; none where one is irrational.
fn size<R: Ring>(list: &[R]) -> Option<u64> {
    let mut bits = 0;
    for own in list {
        bits = bits.max(own.as_integer()?.bits());
    }
    Some(bits)
}

fn in_machine_numbers<R: Ring>(left: &[R], right: &[R]) -> Vec<i128> {
    let machine = |own: &R| own.as_integer().and_then(Integer::machine);
    let right: Vec<i128> = right.iter().filter_map(machine).collect();
    let mut product = vec![0; left.len() + right.len() - 1];
    for (i, own) in left.iter().filter_map(machine).enumerate() {
        for (sum, other) in product[i..].iter_mut().zip(&right) {
            *sum += own * other;
        }
    }
    product
}

/// Absolute values in so many words each as are needed, and whether they are negative.
struct Signed {
    width: usize,
    words: Vec<u64>,
    negative: Vec<bool>,
}

impl Signed {
    fn of<R: Ring>(list: &[R]) -> Self {
        let bits = size(list).unwrap_or_default().max(1);
        let width = usize::try_from(bits.div_ceil(WORD)).unwrap_or_default();
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

    fn iter(&self) -> impl Iterator<Item = (&[u64], &bool)> {
        self.words.chunks_exact(self.width).zip(&self.negative)
    }
}

/// The product number by number, each of its coefficients in so many words of two's complement.
fn in_words<R: Ring>(left: &[R], right: &[R], width: usize) -> Vec<u64> {
    let length = left.len() + right.len() - 1;
    let (left, right) = (Signed::of(left), Signed::of(right));
    let mut sums = vec![0; length * width];
    let mut negative = vec![0; length * width];
    for (i, (own, below)) in left.iter().enumerate() {
        for (j, (other, also)) in right.iter().enumerate() {
            let list = if below == also {
                &mut sums
            } else {
                &mut negative
            };
            add_product(&mut list[(i + j) * width..(i + j + 1) * width], own, other);
        }
    }
    let pairs = sums
        .chunks_exact_mut(width)
        .zip(negative.chunks_exact(width));
    pairs.for_each(|(own, other)| subtract(own, other));
    sums
}

/// The same by packing each list into one long integer: its value at a power of two beyond all
/// coefficients of the product.   (Kronecker's substitution)
///
/// - **cost** one product of long integers, which grows less than the square of their length
fn packed<R: Ring>(left: &[R], right: &[R], width: usize) -> Vec<u64> {
    let product = value(left, width) * value(right, width);
    let length = left.len() + right.len() - 1;
    let mut words = vec![0; length * width];
    let digits = product.iter_u64_digits();
    for (place, digit) in words.iter_mut().zip(digits) {
        *place = digit;
    }
    if product.sign() == Sign::Minus {
        let size = words.clone();
        words.fill(0);
        subtract(&mut words, &size);
    }
    // A negative number has taken one from the next.
    let mut borrowed = 0;
    for own in words.chunks_exact_mut(width) {
        let mut carry = borrowed;
        for word in own.iter_mut() {
            (*word, carry) = match word.overflowing_add(carry) {
                (sum, overflow) => (sum, u64::from(overflow)),
            };
        }
        borrowed = own.last().map_or(0, |top| top >> 63).max(carry);
    }
    words
}

/// Σ aᵢ 2ʷⁱ for a width w of so many words, greater than all |aᵢ|.
fn value<R: Ring>(list: &[R], width: usize) -> BigInt {
    let mut digits = [vec![0; list.len() * width], vec![0; list.len() * width]];
    for (index, own) in list.iter().enumerate() {
        let negative = usize::from(own.sign().is_lt());
        if let Some(own) = own.as_integer() {
            own.write_digits(&mut digits[negative][index * width..]);
        }
    }
    let [positive, negative] =
        digits.map(|own| BigInt::from(&Integer::of_digits(Sign::Plus, own.into_iter())));
    positive - negative
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A list of numbers near ±2ᵏ and 0, which borrow from and carry to their neighbours.
    fn edges(length: usize, power: u32, seed: usize) -> Vec<Integer> {
        let edge = |index: usize| {
            let power = Integer::from(1) << power;
            match (index * index + seed * index + seed) % 7 {
                0 => Integer::from(0),
                1 => power,
                2 => -power,
                3 => power - 1,
                4 => Integer::from(1) - power,
                5 => Integer::from(-1),
                _ => Integer::from(1),
            }
        };
        (0..length).map(edge).collect()
    }

    #[test]
    fn packed_products_are_those_number_by_number() {
        for seed in 0..40 {
            for (first, second) in [(1, 5), (7, 3), (8, 8), (8, 31), (64, 9), (17, 17)] {
                for power in [40, 64, 95, 96, 127, 128, 300, 383, 384, 447, 448] {
                    let (left, right) = (edges(first, power, seed), edges(second, power, seed + 3));
                    let product = of_integers(&left, &right, |own| own);
                    assert_eq!(
                        product,
                        Some(one_by_one(&left, &right)),
                        "{left:?} {right:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn all_signs_alike_fill_the_width() {
        for sign in [1, -1] {
            for length in [1, 7, 8, 15, 16, 64] {
                for power in [124, 160, 446, 447, 448] {
                    let most = (Integer::from(1) << power) - 1;
                    let left = vec![&most * Integer::from(sign); length];
                    let product = of_integers(&left, &left, |own| own);
                    assert_eq!(product, Some(one_by_one(&left, &left)));
                }
            }
        }
    }

    #[test]
    fn machine_numbers_are_multiplied_up_to_their_last_digit() {
        for (length, power) in [(1, 63), (2, 62), (5, 62), (7, 62), (100, 59)] {
            for sign in [1, -1] {
                let most = (Integer::from(1) << power) - 1;
                let list = vec![most * Integer::from(sign); length];
                let product = of_integers(&list, &list, |own| own);
                assert_eq!(product, Some(one_by_one(&list, &list)));
            }
        }
        let small = edges(100, 40, 3);
        let product = of_integers(&small, &small, |own| own);
        assert_eq!(product, Some(one_by_one(&small, &small)));
    }
}
