use super::{Field, Integer, Modulus, Ring, divisor};

/// A list of machine numbers: the coefficients of most polynomials.
///
/// Each operation has a bound for all its results; where these may be longer than a machine number
/// there is no answer. So none asks of each sum how long it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MachineList(Vec<i128>);

/// The binary digits that every machine number may have; so −n is one too.
const DIGITS: u32 = i128::BITS - 1;

/// The least common multiples of 1, …, n, for n below their number: machine numbers.
const COMMON_MULTIPLES: [i128; 80] = {
    let mut multiples = [1; 80];
    let mut n = 1;
    while n < multiples.len() {
        let (mut left, mut right) = (multiples[n - 1], n as i128);
        while right != 0 {
            (left, right) = (right, left % right);
        }
        multiples[n] = multiples[n - 1] / left * n as i128;
        n += 1;
    }
    multiples
};

impl MachineList {
    /// All of a list, if all are machine numbers.
    #[must_use]
    pub fn of<R: Ring>(list: &[R]) -> Option<Self> {
        let mut numbers = Vec::with_capacity(list.len());
        for own in list {
            numbers.push(own.as_integer()?.machine()?);
        }
        Some(Self(numbers))
    }

    /// The numerators of fractions over their least common denominator, and that.
    #[must_use]
    pub fn of_fractions<F: Field>(values: &[F]) -> Option<(Self, i128)> {
        let mut fractions = Vec::with_capacity(values.len());
        let mut common = 1_i128;
        for own in values {
            let (above, below) = own.machine_parts()?;
            if below != common {
                common = lcm(common, below)?;
            }
            fractions.push((above, below));
        }
        let numerators = fractions.iter();
        let longest = bits_of(numerators.clone().map(|own| own.0));
        if longest + bits(&[common]) > DIGITS {
            return None;
        }
        let scaled = numerators.map(|(above, below)| match common / below {
            1 => *above,
            factor => above * factor,
        });
        Some((Self(scaled.collect()), common))
    }

    /// The numbers.
    #[must_use]
    #[inline]
    pub fn numbers(&self) -> &[i128] {
        &self.0
    }

    /// The same numbers as elements of a ring.
    #[must_use]
    pub fn elements<R: Ring>(&self) -> Vec<R> {
        self.0.iter().map(|own| element(*own)).collect()
    }

    /// Without the zeros at its end.
    #[must_use]
    pub fn trimmed(mut self) -> Self {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
        self
    }

    /// The least b with −2ᵇ ≤ n < 2ᵇ for all numbers.
    #[must_use]
    pub fn bits(&self) -> u32 {
        bits(&self.0)
    }

    /// The coefficients of the product of the polynomials with these coefficients, of which none is
    /// empty.
    #[must_use]
    pub fn convolution(left: &[i128], right: &[i128]) -> Option<Self> {
        Self::products(&[(1, left, right)])
    }

    /// The coefficients of Σ fₖ pₖ qₖ for factors fₖ and polynomials with these coefficients, of which
    /// none is empty.
    #[must_use]
    pub fn products(terms: &[(i128, &[i128], &[i128])]) -> Option<Self> {
        let (mut longest, mut length, mut count) = (0, 0, 0_usize);
        for &(factor, left, right) in terms {
            longest = longest.max(bits(left) + bits(right) + growth(factor));
            length = length.max(left.len() + right.len() - 1);
            count += left.len().min(right.len());
        }
        if longest + count.max(1).ilog2() + 1 > DIGITS {
            return None;
        }
        let mut sums = vec![0_i128; length];
        for &(factor, left, right) in terms {
            // −2⁶³ · −1 is no word.
            let first = bits(left) + growth(factor) + 1;
            let are_words = first < i64::BITS && bits(right) < i64::BITS;
            for (i, own) in left.iter().enumerate() {
                let own = own * factor;
                let places = sums[i..].iter_mut().zip(right);
                if are_words {
                    // One instruction multiplies two words.
                    let own = i128::from(word(own));
                    places.for_each(|(sum, other)| *sum += own * i128::from(word(*other)));
                } else {
                    places.for_each(|(sum, other)| *sum += own * other);
                }
            }
        }
        Some(Self(sums))
    }

    /// All numbers divided by one that divides them all, and is not 0, times a factor.
    #[must_use]
    pub fn times_ratio(&self, factor: i128, divisor: i128) -> Option<Self> {
        if self.bits() + bits(&[factor]) >= DIGITS {
            return None;
        }
        let numbers = self.0.iter();
        Some(Self(if divisor == 1 {
            numbers.map(|own| own * factor).collect()
        } else if self.bits() < i64::BITS - 1 && bits(&[divisor]) < i64::BITS {
            // One instruction divides words; −2⁶³/−1 is none.
            let divisor = word(divisor);
            let quotients = numbers.map(|own| i128::from(word(*own) / divisor));
            quotients.map(|own| own * factor).collect()
        } else {
            numbers.map(|own| own / divisor * factor).collect()
        }))
    }

    /// The greatest integer that divides all numbers, and a given one.
    #[must_use]
    pub fn content_with(&self, with: u128) -> u128 {
        let mut common = with;
        for own in self.0.iter().rev() {
            if common == 1 {
                break;
            }
            common = divisor::of_sizes(common, own.unsigned_abs());
        }
        common
    }

    /// Σ fₖ aₖ for lists aₖ and factors fₖ; none where one is not known.
    #[must_use]
    pub fn combination<'a>(
        terms: impl Iterator<Item = Option<(&'a [i128], i128)>> + Clone,
    ) -> Option<Self> {
        let (mut longest, mut length, mut count) = (0, 0, 0_usize);
        for term in terms.clone() {
            let (list, factor) = term?;
            longest = longest.max(bits(list) + bits(&[factor]));
            length = length.max(list.len());
            count += 1;
        }
        if longest + count.max(1).ilog2() + 1 > DIGITS {
            return None;
        }
        let mut sums = vec![0_i128; length];
        for (list, factor) in terms.flatten() {
            let places = sums.iter_mut().zip(list);
            if factor == 1 {
                places.for_each(|(sum, own)| *sum += own);
            } else {
                places.for_each(|(sum, own)| *sum += own * factor);
            }
        }
        Some(Self(sums))
    }

    /// The coefficients of Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ for n + 1 numbers aₖ or fewer: additions only.
    ///
    /// |Σ| < 2ⁿ Σ |aₖ|
    #[must_use]
    pub fn binomial_sums(powers: &[i128], degree: usize) -> Option<Self> {
        let growth = u32::try_from(degree).ok()?;
        let count = powers.len().max(1).ilog2() + 1;
        if bits(powers).checked_add(growth)?.checked_add(count)? > DIGITS {
            return None;
        }
        // Highest k last: f ← f (1+x) + aₖ xᵏ, beginning with the constant a₀.
        let mut sums = vec![0_i128; degree + 1];
        for order in 0..=degree {
            let own = powers.get(order).copied().unwrap_or(0);
            // Two at a time, so that neither has to be moved aside.
            let mut below = 0;
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
            sums[order] += own;
        }
        Some(Self(sums))
    }

    /// k aₖ for k ≥ 1: the coefficients of the derivative.
    #[must_use]
    pub fn derivative(list: &[i128]) -> Option<Self> {
        let length = i128::try_from(list.len()).ok()?;
        let fits = bits(list) + bits(&[length]) <= DIGITS;
        fits.then(|| {
            Self(
                (1..)
                    .zip(list.iter().skip(1))
                    .map(|(k, own)| k * own)
                    .collect(),
            )
        })
    }

    /// m and the integers 0, m a₀, m a₁ / 2, m a₂ / 3, …: the coefficients of an antiderivative.
    #[must_use]
    pub fn antiderivative(list: &[i128]) -> Option<(Self, i128)> {
        let common = *COMMON_MULTIPLES.get(list.len())?;
        if bits(list) + bits(&[common]) > DIGITS {
            return None;
        }
        let terms = (1..).zip(list).map(|(power, own)| common / power * own);
        Some((Self(std::iter::once(0).chain(terms).collect()), common))
    }

    /// f aₖ, but another number in the first place.
    #[must_use]
    pub fn with_first(&self, first: i128, factor: i128) -> Option<Self> {
        let mut scaled = self.times_ratio(factor, 1)?;
        *scaled.0.first_mut()? = first;
        Some(scaled)
    }

    /// Σ aₖ
    #[must_use]
    pub fn total(list: &[i128]) -> Option<i128> {
        let fits = bits(list) + list.len().max(1).ilog2() < DIGITS;
        fits.then(|| list.iter().sum())
    }

    /// The numbers cₖ = C(n, k) Δᵏb₀ for a list b₀ … bₙ: the way back from Bernstein coefficients.
    ///
    /// |Δᵏb₀| ≤ 2ⁿ max |bᵢ|
    #[must_use]
    pub fn differences(&self) -> Option<Self> {
        let growth = u32::try_from(self.0.len()).ok()?;
        // C(n, k) (n − k) < n 2ⁿ⁻¹ is there before a division.
        if growth + growth.max(1).ilog2() > DIGITS {
            return None;
        }
        let fits = |list: &[i128]| {
            bits(list)
                .checked_add(growth)
                .is_some_and(|own| own <= DIGITS)
        };
        if !fits(&self.0) {
            return None;
        }
        let mut row = self.0.clone();
        // Δᵏb₀ stays at place k.
        for first in 1..row.len() {
            for index in (first..row.len()).rev() {
                row[index] -= row[index - 1];
            }
        }
        // C(n, k) ≤ 2ⁿ
        if !fits(&row) {
            return None;
        }
        let mut binomial = 1_i128;
        for (left, (own, power)) in (0..row.len()).rev().zip(row.iter_mut().zip(1..)) {
            *own *= binomial;
            binomial = binomial * left as i128 / power;
        }
        Some(Self(row))
    }

    /// The images modulo a prime.
    #[must_use]
    pub fn images(&self, modulus: &Modulus) -> Vec<u64> {
        let numbers = self.0.iter();
        numbers.map(|own| modulus.embed_machine(*own)).collect()
    }
}

/// A machine number as an element of a ring.
#[inline]
fn element<R: Ring>(own: i128) -> R {
    R::from_integer(&Integer::of_machine(own))
}

/// The least b with −2ᵇ ≤ n < 2ᵇ for all numbers.
#[inline]
fn bits(list: &[i128]) -> u32 {
    bits_of(list.iter().copied())
}

#[inline]
fn bits_of(numbers: impl Iterator<Item = i128>) -> u32 {
    // n, or −n − 1 for a negative one
    let all = numbers.fold(0, |all, own| all | (own ^ (own >> DIGITS)));
    u128::BITS - all.leading_zeros()
}

/// The least b with |n| ≤ 2ᵇ.
#[inline]
fn growth(factor: i128) -> u32 {
    u128::BITS - factor.unsigned_abs().saturating_sub(1).leading_zeros()
}

/// The least common multiple of positive numbers.
fn lcm(left: i128, right: i128) -> Option<i128> {
    let common = divisor::of_sizes(left.unsigned_abs(), right.unsigned_abs());
    let factor = right / i128::try_from(common).ok()?;
    if bits(&[left]) + bits(&[factor]) > DIGITS {
        return None;
    }
    Some(left * factor)
}

/// A number that is known to be a word: the lower half of its digits.
#[inline]
fn word(own: i128) -> i64 {
    let half = own.cast_unsigned() & u128::from(u64::MAX);
    u64::try_from(half).unwrap_or_default().cast_signed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    /// Lists of numbers near ±2ᵏ, 0 and ±1.
    fn edges() -> Vec<Vec<i128>> {
        let number = |power: u32, index: usize| {
            let power = 1_i128 << power;
            match index % 7 {
                0 => 0,
                1 => power,
                2 => -power,
                3 => power - 1,
                4 => 1 - power,
                5 => -1,
                _ => 1,
            }
        };
        let powers = [0, 1, 31, 61, 62, 63, 64, 100, 116, 120, 124, 125, 126];
        let lists = powers.into_iter().flat_map(|power| {
            (0..21).map(move |seed: usize| {
                let length = 1 + seed % 9;
                let place = |index: usize| index * index + seed * index + seed;
                (0..length).map(|own| number(power, place(own))).collect()
            })
        });
        lists.collect()
    }

    fn whole(list: &[i128]) -> Vec<Integer> {
        list.iter().copied().map(Integer::from).collect()
    }

    /// An answer is the exact one, and where there is none some number is long.
    fn agrees(answer: Option<&[i128]>, exact: &[Integer], margin: u64) {
        match answer {
            Some(own) => assert_eq!(whole(own), exact),
            None => {
                let bits = exact.iter().map(Integer::bits).max().unwrap_or(0);
                assert!(bits + margin > u64::from(DIGITS), "{exact:?}");
            }
        }
    }

    #[test]
    fn multiples_and_sums_are_exact_or_none() {
        let factors = [1, -1, 3, -12, 1 << 40, -(1 << 62), (1 << 63) - 1, 1 << 100];
        for (index, list) in edges().into_iter().enumerate() {
            let (own, factor) = (MachineList(list.clone()), factors[index % factors.len()]);
            let scaled = own.times_ratio(factor, 1);
            let times = |list: &[i128]| -> Vec<Integer> {
                let factor = Integer::from(factor);
                whole(list).iter().map(|own| own * &factor).collect()
            };
            agrees(scaled.as_ref().map(MachineList::numbers), &times(&list), 2);
            if let Some(scaled) = scaled {
                let back = scaled.times_ratio(-1, factor);
                let opposite: Vec<i128> = list.iter().map(|own| -own).collect();
                assert!(back.is_none_or(|own| own.numbers() == opposite));
                let content = scaled.content_with(0);
                assert!(content.is_multiple_of(factor.unsigned_abs()) || content == 0);
            }
            let other = &edges()[(3 * index + 1) % 200];
            let sum =
                MachineList::combination([Some((&*list, factor)), Some((other, 1))].into_iter());
            let mut exact = times(&list);
            exact.resize(list.len().max(other.len()), Integer::from(0));
            for (sum, own) in exact.iter_mut().zip(other) {
                *sum = &*sum + Integer::from(*own);
            }
            let longest = bits(&list) + bits(&[factor]);
            match &sum {
                Some(own) => assert_eq!(whole(own.numbers()), exact),
                None => assert!(longest.max(bits(other)) + 2 > DIGITS),
            }
            let total = MachineList::total(&list).map(Integer::from);
            let exact = whole(&list)
                .iter()
                .fold(Integer::from(0), |all, own| all + own);
            assert!(total.is_none_or(|own| own == exact));
        }
    }

    #[test]
    fn derivatives_and_differences_are_exact_or_none() {
        let binomials = [1, 8, 28, 56, 70, 56, 28, 8, 1_i128];
        for list in edges() {
            let (rise, common) = match MachineList::antiderivative(&list) {
                Some((own, common)) => (own, common),
                None => {
                    assert!(bits(&list) + 12 > DIGITS);
                    continue;
                }
            };
            let slope = MachineList::derivative(rise.numbers());
            let exact: Vec<Integer> = whole(&list)
                .iter()
                .map(|own| own * Integer::from(common))
                .collect();
            agrees(slope.as_ref().map(MachineList::numbers), &exact, 5);
            if list.len() == binomials.len() {
                // Σ cₖ xᵏ (1+x)ⁿ⁻ᵏ leads back to C(n, i) bᵢ.
                let powers = MachineList(list.clone()).differences();
                let back = powers.and_then(|own| MachineList::binomial_sums(own.numbers(), 8));
                let pairs = list.iter().zip(&binomials);
                let scaled =
                    pairs.map(|(own, binomial)| Integer::from(*own) * Integer::from(*binomial));
                assert!(back.is_none_or(|own| whole(own.numbers()).into_iter().eq(scaled)));
            }
        }
    }

    #[test]
    fn long_lists_of_nothing_have_no_differences() {
        for length in [1, 2, 60, 119, 120, 121, 126, 127, 128, 300] {
            let powers = MachineList(vec![0; length]).differences();
            assert!(powers.is_none_or(|own| own.numbers() == vec![0; length]));
            let mut last = vec![0; length];
            last[length - 1] = 1;
            // tⁿ, whose Bernstein coefficients are 0, …, 0, 1
            let powers = MachineList(last.clone()).differences();
            assert!(powers.is_none_or(|own| own.numbers() == last));
        }
    }

    #[test]
    fn sums_of_products_are_exact_or_none() {
        let (lists, factors) = (edges(), [1, -1, 2, -2, 3, 1 << 62, -(1 << 63), 1 << 100]);
        for (index, list) in lists.iter().enumerate() {
            let factor = factors[index % factors.len()];
            let others = [
                &lists[(7 * index + 3) % lists.len()],
                &lists[(index + 40) % lists.len()],
            ];
            let terms = [(factor, list, others[0]), (1, others[1], list)];
            let machine = terms.map(|(factor, left, right)| (factor, &left[..], &right[..]));
            let length = |left: &[i128], right: &[i128]| left.len() + right.len() - 1;
            let count = length(list, others[0]).max(length(list, others[1]));
            let mut exact = vec![Integer::from(0); count];
            for (factor, left, right) in terms {
                for (i, own) in left.iter().enumerate() {
                    for (j, other) in right.iter().enumerate() {
                        let product = Integer::from(factor) * Integer::from(*own);
                        exact[i + j] = &exact[i + j] + product * Integer::from(*other);
                    }
                }
            }
            let sums = MachineList::products(&machine);
            let longest = bits(list) + bits(others[0]) + growth(factor);
            let longest = longest.max(bits(list) + bits(others[1]));
            match sums {
                Some(own) => assert_eq!(whole(own.numbers()), exact),
                None => assert!(longest + 6 > DIGITS),
            }
        }
    }

    #[test]
    fn fractions_come_over_their_least_common_denominator() {
        let fraction = |above: i128, below: i128| Rational::new(above.into(), below.into());
        let long = i128::MAX;
        for (list, expected) in [
            (
                vec![fraction(1, 6), fraction(-3, 4), fraction(0, 1)],
                Some((vec![2, -9, 0], 12)),
            ),
            (vec![fraction(5, 1)], Some((vec![5], 1))),
            (Vec::new(), Some((Vec::new(), 1))),
            (vec![fraction(long, 2), fraction(1, 3)], None),
            (vec![fraction(1, long), fraction(1, long - 1)], None),
        ] {
            let found = MachineList::of_fractions(&list);
            assert_eq!(
                found,
                expected.map(|(own, below)| (MachineList(own), below))
            );
        }
    }
}
