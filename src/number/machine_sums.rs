//! Sums of products of machine numbers, and the way to Bernstein coefficients and back.

use super::machine_list::{Form, growth, of_width};
use super::machine_numbers::{DOUBLE, WORD, Width};
use super::operators::machine_quotient;
use super::{MachineList, MachineNumbers};

impl MachineList {
    /// The coefficients of the product of the polynomials with these coefficients, of which none is
    /// empty.
    #[must_use]
    pub fn convolution(left: MachineNumbers<'_>, right: MachineNumbers<'_>) -> Option<Self> {
        Self::products(&[(1, left, right)])
    }

    /// The coefficients of Σ fₖ pₖ qₖ for factors fₖ and polynomials with these coefficients, of which
    /// none is empty.
    #[must_use]
    pub fn products(terms: &[(i128, MachineNumbers<'_>, MachineNumbers<'_>)]) -> Option<Self> {
        let (mut longest, mut length, mut count) = (0, 0, 0_usize);
        for &(factor, left, right) in terms {
            longest = longest.max(left.bits() + right.bits() + growth(factor));
            length = length.max(left.len() + right.len() - 1);
            count += left.len().min(right.len());
        }
        of_width!(longest + count.max(1).ilog2() + 1, Number => {
            let mut sums = vec![Number::default(); length];
            for &(factor, left, right) in terms {
                for (i, own) in left.iter().enumerate() {
                    right.add_multiple(own * factor, &mut sums[i..]);
                }
            }
            sums
        })
    }

    /// `Σ aₖ[i] bₖ[j]` for as many rows i and columns j, row by row; what lists lack is 0.
    #[must_use]
    pub fn outer_products(
        terms: &[[MachineNumbers<'_>; 2]],
        (rows, columns): (usize, usize),
    ) -> Option<Self> {
        let bits = |[left, right]: &[MachineNumbers<'_>; 2]| left.bits() + right.bits();
        let longest = terms.iter().map(bits).max().unwrap_or(0);
        of_width!(longest + terms.len().max(1).ilog2() + 1, Number => {
            let mut sums = vec![Number::default(); rows * columns];
            for [left, right] in terms {
                for (own, row) in left.iter().zip(sums.chunks_exact_mut(columns.max(1))) {
                    right.add_multiple(own, row);
                }
            }
            sums
        })
    }

    /// Σ fₖ aₖ for lists aₖ and factors fₖ; none where one is not known.
    #[must_use]
    pub fn combination<'a>(
        terms: impl Iterator<Item = Option<(MachineNumbers<'a>, i128)>> + Clone,
    ) -> Option<Self> {
        let (mut longest, mut length, mut count) = (0, 0, 0_usize);
        for term in terms.clone() {
            let (list, factor) = term?;
            longest = longest.max(list.bits() + growth(factor));
            length = length.max(list.len());
            count += 1;
        }
        of_width!(longest + count.max(1).ilog2() + 1, Number => {
            let mut sums = vec![Number::default(); length];
            for (list, factor) in terms.flatten() {
                list.add_multiple(factor, &mut sums);
            }
            sums
        })
    }

    /// The coefficients of Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ for n + 1 numbers aₖ or fewer: additions only.
    ///
    /// |Σ| < 2ⁿ Σ |aₖ|
    #[must_use]
    pub fn binomial_sums(powers: MachineNumbers<'_>, degree: usize) -> Option<Self> {
        let growth = u32::try_from(degree).ok()?;
        let count = powers.len().max(1).ilog2() + 1;
        let longest = powers.bits().checked_add(growth)?.checked_add(count)?;
        of_width!(longest, Number => binomial_sums::<Number>(powers, degree))
    }

    /// The numbers cₖ = C(n, k) Δᵏb₀ for a list b₀ … bₙ: the way back from Bernstein coefficients.
    ///
    /// |Δᵏb₀| ≤ 2ⁿ max |bᵢ|
    #[must_use]
    pub fn differences(&self) -> Option<Self> {
        let numbers = self.numbers();
        let growth = u32::try_from(numbers.len()).ok()?;
        // C(n, k) (n − k) < n 2ⁿ⁻¹ is there before a division.
        if growth + growth.max(1).ilog2() > DOUBLE {
            return None;
        }
        let differences = of_width!(numbers.bits().checked_add(growth)?, Number => {
            differences::<Number>(numbers)
        })?;
        // C(n, k) ≤ 2ⁿ
        let longest = differences.numbers().bits().checked_add(growth)?;
        let mut binomial = 1_i128;
        let left = (0..numbers.len()).rev().map(|own| own as i128);
        let terms = differences.numbers().iter().zip(left.zip(1..));
        let scaled = terms.map(|(own, (left, power))| {
            let product = own * binomial;
            binomial = machine_quotient(binomial * left, power);
            product
        });
        Self::collect(longest, scaled)
    }
}

/// Highest k last: f ← f (1+x) + aₖ xᵏ, beginning with the constant a₀.
fn binomial_sums<N: Width>(powers: MachineNumbers<'_>, degree: usize) -> Vec<N> {
    let mut sums = vec![N::default(); degree + 1];
    for order in 0..=degree {
        // Two at a time, so that neither has to be moved aside.
        let mut below = N::default();
        let mut pairs = sums[..=order].chunks_exact_mut(2);
        for pair in &mut pairs {
            let [first, second] = [pair[0], pair[1]];
            pair[0] = first + below;
            pair[1] = second + first;
            below = second;
        }
        if let [last] = pairs.into_remainder() {
            *last += below;
        }
        if order < powers.len() {
            sums[order] += N::of(powers.at(order));
        }
    }
    sums
}

/// Δᵏb₀ at place k.
fn differences<N: Width>(list: MachineNumbers<'_>) -> Vec<N> {
    let mut row: Vec<N> = list.iter().map(N::of).collect();
    for first in 1..row.len() {
        for index in (first..row.len()).rev() {
            let before = row[index - 1];
            row[index] -= before;
        }
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Integer;
    use crate::number::machine_list::tests::{agrees, edges, held, whole};

    #[test]
    fn outer_products_are_exact_or_none() {
        let lists = edges();
        for (index, first) in lists.iter().enumerate() {
            let others = [3 * index + 1, 5 * index + 2, index + 11];
            let [second, third, fourth] = others.map(|own| lists[own % lists.len()].numbers());
            let terms = [[first.numbers(), second], [third, fourth]];
            let size = (first.len().max(third.len()), second.len().max(fourth.len()));
            let mut exact = vec![Integer::from(0); size.0 * size.1];
            for [left, right] in terms {
                for (i, own) in left.iter().enumerate() {
                    for (j, other) in right.iter().enumerate() {
                        let place = &mut exact[i * size.1 + j];
                        *place = &*place + Integer::from(own) * Integer::from(other);
                    }
                }
            }
            let sums = MachineList::outer_products(&terms, size);
            agrees(sums.as_ref(), &exact, 130);
            let longest = terms
                .iter()
                .map(|[left, right]| left.bits() + right.bits())
                .max();
            assert_eq!(sums.is_none(), longest > Some(DOUBLE - 2));
        }
        let none = MachineList::outer_products(&[], (2, 3));
        assert!(none.is_some_and(|own| own.numbers().iter().eq([0; 6])));
    }

    #[test]
    fn sums_of_products_are_exact_or_none() {
        let (lists, factors) = (edges(), [1, -1, 2, -2, 3, 1 << 62, -(1 << 63), 1 << 100]);
        for (index, list) in lists.iter().enumerate() {
            let factor = factors[index % factors.len()];
            let others = [7 * index + 3, index + 40].map(|own| lists[own % lists.len()].numbers());
            let list = list.numbers();
            let terms = [(factor, list, others[0]), (1, others[1], list)];
            let length = others.iter().map(|own| list.len() + own.len() - 1).max();
            let mut exact = vec![Integer::from(0); length.unwrap_or(0)];
            for (factor, left, right) in terms {
                for (i, own) in left.iter().enumerate() {
                    for (j, other) in right.iter().enumerate() {
                        let product = Integer::from(factor) * Integer::from(own);
                        exact[i + j] = &exact[i + j] + product * Integer::from(other);
                    }
                }
            }
            let longest = list.bits() + others[0].bits() + growth(factor);
            let longest = longest.max(list.bits() + others[1].bits());
            match MachineList::products(&terms) {
                Some(own) => assert_eq!(whole(own.numbers()), exact),
                None => assert!(longest + 6 > DOUBLE),
            }
        }
    }

    #[test]
    fn long_lists_of_nothing_have_no_differences() {
        for length in [1, 2, 60, 119, 120, 121, 126, 127, 128, 300] {
            let nothing = vec![0; length];
            // tⁿ, whose Bernstein coefficients are 0, …, 0, 1
            let mut last = nothing.clone();
            last[length - 1] = 1;
            for own in held(&nothing).iter().chain(&held(&last)) {
                assert!(own.differences().is_none_or(|powers| powers == *own));
            }
        }
    }
}
