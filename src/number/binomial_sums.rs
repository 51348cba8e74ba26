//! Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ, as lists of coefficients: the way from powers to Bernstein coefficients.

use super::words::{add, add_integer, integer};
use super::{Integer, MachineList, Ring};

/// The coefficients of Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ for as many k as there are, n + 1 at most: additions only.
pub(super) fn one_by_one<R: Ring>(powers: &[R], degree: usize) -> Vec<R> {
    // Highest k last: f ← f (1+x) + aₖ xᵏ, beginning with the constant a₀.
    let mut sums = vec![R::zero(); degree + 1];
    for order in 0..=degree {
        for index in (1..=order).rev() {
            let (below, above) = sums.split_at_mut(index);
            if let (Some(own), Some(other)) = (above.first_mut(), below.last()) {
                own.add(other);
            }
        }
        if let Some(own) = powers.get(order) {
            sums[order].add(own);
        }
    }
    sums
}

/// The same for rational integers, without asking of each sum how long it is; none where some
/// aₖ is irrational. As |Σ| < 2ⁿ Σ |aₖ|, machine numbers will do for all, or words of two's
/// complement, as many for each number.
pub(super) fn of_integers<R: Ring>(
    powers: &[R],
    degree: usize,
    whole: impl Fn(Integer) -> R,
) -> Option<Vec<R>> {
    if let Some(own) = MachineList::of(powers)
        && let Some(sums) = MachineList::binomial_sums(own.numbers(), degree)
    {
        return Some(sums.elements());
    }
    let mut bits = 0;
    for own in powers {
        bits = bits.max(own.as_integer()?.bits());
    }
    let count = u64::from(powers.len().max(1).ilog2()) + 1;
    // One digit more for the sign.
    let digits = bits + count + u64::try_from(degree).ok()? + 1;
    let width = usize::try_from(digits.div_ceil(64)).ok()?;
    let words = in_words(powers, degree, width);
    let sums = words.chunks_exact(width);
    Some(sums.map(|own| whole(integer(own))).collect())
}

fn in_words<R: Ring>(powers: &[R], degree: usize, width: usize) -> Vec<u64> {
    let mut words = vec![0_u64; width * (degree + 1)];
    let mut room = vec![0_u64; width];
    for order in 0..=degree {
        for index in (1..=order).rev() {
            let (below, above) = words.split_at_mut(index * width);
            add(&mut above[..width], &below[(index - 1) * width..]);
        }
        if let Some(own) = powers.get(order).and_then(Ring::as_integer) {
            let place = &mut words[order * width..(order + 1) * width];
            add_integer(place, own, &mut room);
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers near the ends of one, two and more words, of either sign.
    fn edge(seed: usize, power: u32) -> Integer {
        let power = Integer::from(1) << power;
        match seed % 7 {
            0 => Integer::from(0),
            1 => power,
            2 => -power,
            3 => power - 1,
            4 => Integer::from(1) - power,
            5 => Integer::from(-1),
            _ => Integer::from(1),
        }
    }

    fn sums(powers: &[Integer], degree: usize) -> Vec<Integer> {
        of_integers(powers, degree, |own| own).unwrap_or_default()
    }

    #[test]
    fn words_add_up_to_what_numbers_do() {
        for power in [0, 1, 31, 52, 60, 62, 63, 64, 120, 126, 127, 128, 190, 300] {
            for degree in [0, 1, 2, 9, 40, 70] {
                for seed in 0..21 {
                    let number = |index: usize| edge(index * index + seed * (index + 1), power);
                    let powers: Vec<Integer> =
                        (0..=degree - degree.min(seed % 3)).map(number).collect();
                    assert_eq!(
                        sums(&powers, degree),
                        one_by_one(&powers, degree),
                        "{powers:?}"
                    );
                }
            }
        }
        assert_eq!(sums(&[], 3), vec![Integer::from(0); 4]);
    }

    #[test]
    fn all_alike_fill_the_words() {
        for sign in [1, -1] {
            for power in [20, 53, 54, 117, 118, 180] {
                let powers = vec![((Integer::from(1) << power) - 1) * sign; 10];
                assert_eq!(sums(&powers, 9), one_by_one(&powers, 9));
            }
        }
    }
}
