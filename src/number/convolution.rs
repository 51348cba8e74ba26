//! Products of polynomials, as lists of coefficients.

use num_bigint::{BigInt, Sign};

use super::words::{Signed, add_product, integer, subtract};
use super::{Integer, MachineList, Ring};

/// The bits of a word.
const WORD: u64 = 64;
/// Lists of at least so many numbers are packed, …
const SHORT: usize = 8;
/// … if a product of two of them takes more products of words than this.
const FEW: usize = 30;
/// Numbers of more words than this are multiplied faster than word by word.
const LONG: usize = 24;

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
/// words, or packed. None where some number is irrational, and for few long numbers.
pub(super) fn of_integers<R: Ring>(
    left: &[R],
    right: &[R],
    whole: impl Fn(Integer) -> R,
) -> Option<Vec<R>> {
    if let (Some(first), Some(second)) = (MachineList::of(left), MachineList::of(right))
        && let Some(product) = MachineList::convolution(first.numbers(), second.numbers())
    {
        return Some(product.elements());
    }
    let shorter = left.len().min(right.len());
    let count = u64::from(shorter.max(1).ilog2()) + 1;
    let (first, second) = (size(left)?, size(right)?);
    let bits = first + second + count;
    let (left, right) = (Signed::of(left, first), Signed::of(right, second));
    // One bit more for the sign.
    let width = usize::try_from((bits + 1).div_ceil(WORD)).ok()?;
    let words = if shorter >= SHORT && left.width() * right.width() > FEW {
        packed(&left, &right, width)
    } else if left.width().min(right.width()) <= LONG {
        in_words(&left, &right, width)
    } else {
        return None;
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

/// The product number by number, each of its coefficients in so many words of two's complement.
fn in_words(left: &Signed, right: &Signed, width: usize) -> Vec<u64> {
    let length = left.len() + right.len() - 1;
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
fn packed(left: &Signed, right: &Signed, width: usize) -> Vec<u64> {
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
    let mut taken = 0;
    for own in words.chunks_exact_mut(width) {
        let mut carry = taken;
        for word in own.iter_mut() {
            let (sum, overflow) = word.overflowing_add(carry);
            (*word, carry) = (sum, u64::from(overflow));
        }
        taken = own.last().map_or(0, |top| top >> 63).max(carry);
    }
    words
}

/// Σ aᵢ 2ʷⁱ for a width w of so many words, greater than all |aᵢ|.
fn value(list: &Signed, width: usize) -> BigInt {
    let mut digits = [vec![0; list.len() * width], vec![0; list.len() * width]];
    for (index, (words, negative)) in list.iter().enumerate() {
        let place = &mut digits[usize::from(*negative)][index * width..];
        place[..words.len()].copy_from_slice(words);
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
    fn both_roads_lead_to_the_same_product() {
        for (first, second) in [(1, 1), (3, 8), (16, 17), (40, 9)] {
            for power in [1, 63, 64, 191, 192, 500, 1_900] {
                for seed in 0..7 {
                    let (left, right) = (edges(first, power, seed), edges(second, power, seed + 3));
                    let bits = u64::from(power) + 1;
                    let whole = 2 * bits + 6;
                    let product = one_by_one(&left, &right);
                    let signed = [&left, &right].map(|own| Signed::of(own, bits));
                    let [left, right] = &signed;
                    let width = usize::try_from(whole.div_ceil(WORD)).unwrap_or_default();
                    for words in [in_words(left, right, width), packed(left, right, width)] {
                        let coefficients = words.chunks_exact(width).map(integer);
                        assert_eq!(coefficients.collect::<Vec<_>>(), product);
                    }
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
