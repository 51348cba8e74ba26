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

/// The coefficients of the product of two polynomials with these coefficients, if it is worth
/// while to pack each into one long integer: its value at a power of two beyond all coefficients
/// of the product.   (Kronecker's substitution)
///
/// - **cost** one product of long integers, which grows less than the square of their length
pub(super) fn packed(left: &[&Integer], right: &[&Integer]) -> Option<Vec<Integer>> {
    let shorter = left.len().min(right.len());
    let size = |list: &[&Integer]| list.iter().map(|own| own.bits()).max().unwrap_or(0);
    let bits = size(left) + size(right) + u64::from(shorter.max(1).ilog2()) + 1;
    if shorter < SHORT || bits <= MACHINE {
        return None;
    }
    // One bit more for the sign.
    let width = usize::try_from(bits.div_ceil(DIGIT) + 1).ok()?;
    let product = value(left, width) * value(right, width);
    let coefficients = unpacked(&product, width, left.len() + right.len() - 1);
    Some(coefficients)
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
                for power in [64, 95, 96, 127, 128, 300] {
                    let (left, right) = (edges(first, power, seed), edges(second, power, seed + 3));
                    let [one, other] = [&left, &right].map(|own| own.iter().collect::<Vec<_>>());
                    let product = packed(&one, &other);
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
                let list: Vec<_> = left.iter().collect();
                assert_eq!(packed(&list, &list), Some(one_by_one(&left, &left)));
            }
        }
    }

    #[test]
    fn short_lists_and_small_numbers_are_left_alone() {
        let small = vec![Integer::from(3); 100];
        let list: Vec<_> = small.iter().collect();
        assert_eq!(packed(&list, &list), None);
        let long = vec![Integer::from(1) << 400; 7];
        assert_eq!(packed(&long.iter().collect::<Vec<_>>(), &list), None);
    }
}
