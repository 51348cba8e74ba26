//! Products of polynomials, as lists of coefficients.

use num_bigint::{BigInt, BigUint, Sign};

use super::integer::Form;
use super::{Integer, Ring};

/// The bits of a digit.
const DIGIT: u64 = 32;
/// Lists shorter than this are multiplied number by number.
const SHORT: usize = 8;
/// So are numbers whose products are machine numbers.
const MACHINE: u64 = 127;

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

/// The same for rational integers, by a bound on the digits of the product: in machine numbers, or
/// packed; none where some number is irrational, or where neither pays.
pub(super) fn of_integers<R: Ring>(
    left: &[R],
    right: &[R],
    whole: impl Fn(Integer) -> R,
) -> Option<Vec<R>> {
    let shorter = left.len().min(right.len());
    let count = u64::from(shorter.max(1).ilog2()) + 1;
    let bits = size(left)? + size(right)? + count;
    if bits <= MACHINE {
        let products = in_machine_numbers(left, right).into_iter();
        return Some(products.map(|own| whole(Integer::from(own))).collect());
    }
    if shorter < SHORT {
        return None;
    }
    let [left, right] = [left, right].map(|list| list.iter().filter_map(Ring::as_integer));
    let products = packed(&left.collect::<Vec<_>>(), &right.collect::<Vec<_>>(), bits)?;
    Some(products.into_iter().map(whole).collect())
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

/// The product by packing each list into one long integer: its value at a power of two beyond all
/// coefficients of the product, which have so many digits.   (Kronecker's substitution)
///
/// - **cost** one product of long integers, which grows less than the square of their length
fn packed(left: &[&Integer], right: &[&Integer], bits: u64) -> Option<Vec<Integer>> {
    // One bit more for the sign.
    let width = usize::try_from(bits.div_ceil(DIGIT) + 1).ok()?;
    let product = value(left, width) * value(right, width);
    Some(unpacked(&product, width, left.len() + right.len() - 1))
}

/// Σ aᵢ 2ʷⁱ for a width w of so many digits, greater than all |aᵢ|.
fn value(list: &[&Integer], width: usize) -> BigInt {
    let mut digits = [
        vec![0_u32; list.len() * width],
        vec![0_u32; list.len() * width],
    ];
    for (index, own) in list.iter().enumerate() {
        let negative = usize::from(Ring::sign(*own).is_lt());
        let place = &mut digits[negative][index * width..];
        for (place, digit) in place.iter_mut().zip(magnitude(own)) {
            *place = digit;
        }
    }
    let [positive, negative] = digits.map(BigUint::new);
    BigInt::from(positive) - BigInt::from(negative)
}

/// The digits of |n|, the lowest first.
fn magnitude(value: &Integer) -> Vec<u32> {
    match value.form() {
        Form::Machine(own) => BigUint::from(own.unsigned_abs()).to_u32_digits(),
        Form::Long(own) => own.magnitude().to_u32_digits(),
    }
}

/// The aᵢ of Σ aᵢ 2ʷⁱ with |aᵢ| < 2ʷ⁻¹: a chunk of digits from the half on stands for a negative
/// number, and one is carried.
fn unpacked(product: &BigInt, width: usize, count: usize) -> Vec<Integer> {
    let negative = product.sign() == Sign::Minus;
    let mut digits = product.magnitude().to_u32_digits();
    digits.resize(count * width, 0);
    let whole = BigUint::from(1_u32) << (width * 32);
    let mut carry = 0_u32;
    let chunks = digits.chunks_exact(width).map(|chunk| {
        let value = BigUint::new(chunk.to_vec()) + carry;
        let is_upper = value.bits() == whole.bits() - 1 || value == whole;
        carry = u32::from(is_upper);
        let (sign, size) = if is_upper {
            (Sign::Minus, &whole - value)
        } else {
            (Sign::Plus, value)
        };
        let value = BigInt::from_biguint(sign, size);
        Integer::of_long(if negative { -value } else { value })
    });
    chunks.collect()
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
            for (first, second) in [(8, 8), (8, 31), (64, 9), (17, 17)] {
                for power in [40, 64, 95, 96, 127, 128, 300] {
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
            for length in [8, 15, 16, 64] {
                let most = (Integer::from(1) << 160) - 1;
                let left = vec![&most * Integer::from(sign); length];
                let product = of_integers(&left, &left, |own| own);
                assert_eq!(product, Some(one_by_one(&left, &left)));
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
        let long = vec![Integer::from(1) << 400; 7];
        assert_eq!(of_integers(&long, &long, |own| own), None);
    }
}
