use super::machine_numbers::{DOUBLE, WORD, Width, each_width};
use super::operators::machine_quotient;
use super::{Field, Integer, MachineNumbers, Modulus, Ring, divisor};

/// A list of machine numbers: the coefficients of most polynomials.
///
/// Each operation has a bound for all its results; where these may be longer than a machine number
/// there is no answer. So none asks of each sum how long it is, and words are added as words.
#[derive(Clone, Debug)]
pub struct MachineList(pub(super) Form);

#[derive(Clone, Debug)]
pub(super) enum Form {
    Words(Vec<i64>),
    /// Of which some may be longer than a word.
    Doubles(Vec<i128>),
}

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

/// How the numbers of a new list are held, which have at most so many binary digits; no answer where
/// they may be longer than a machine number.
macro_rules! of_width {
    ($bits:expr, $width:ident => $list:expr) => {
        match $bits {
            ..=WORD => {
                type $width = i64;
                Some(MachineList(Form::Words($list)))
            }
            ..=DOUBLE => {
                type $width = i128;
                Some(MachineList(Form::Doubles($list)))
            }
            _ => None,
        }
    };
}

pub(super) use of_width;

impl PartialEq for MachineList {
    fn eq(&self, other: &Self) -> bool {
        self.numbers() == other.numbers()
    }
}

impl Eq for MachineList {}

impl MachineList {
    /// All of a list, if all are machine numbers.
    #[must_use]
    pub fn of<R: Ring>(list: &[R]) -> Option<Self> {
        let mut numbers = Vec::with_capacity(list.len());
        for own in list {
            numbers.push(own.as_integer()?.machine()?);
        }
        let bits = MachineNumbers::Doubles(&numbers).bits();
        Self::collect(bits, numbers.iter().copied())
    }

    /// Numbers of which none has more binary digits than the given ones.
    #[inline]
    pub(super) fn collect(bits: u32, numbers: impl Iterator<Item = i128>) -> Option<Self> {
        of_width!(bits, Number => numbers.map(Number::of).collect())
    }

    /// The numerators of fractions over their least common denominator, and that.
    #[must_use]
    pub fn of_fractions<'a, F: Field>(
        values: impl Iterator<Item = &'a F> + Clone,
    ) -> Option<(Self, i128)> {
        let (mut common, mut longest) = (1_i128, 0);
        for own in values.clone() {
            let (above, below) = own.machine_parts()?;
            if below != common {
                common = lcm(common, below)?;
            }
            longest = longest.max(bits(above));
        }
        let scaled = values.map(|own| {
            let (above, below) = own.machine_parts().unwrap_or((0, 1));
            if below == common {
                above
            } else {
                above * machine_quotient(common, below)
            }
        });
        Some((Self::collect(longest + bits(common), scaled)?, common))
    }

    /// The numbers.
    #[must_use]
    #[inline]
    pub fn numbers(&self) -> MachineNumbers<'_> {
        match &self.0 {
            Form::Words(own) => MachineNumbers::Words(own),
            Form::Doubles(own) => MachineNumbers::Doubles(own),
        }
    }

    /// How many they are.
    #[must_use]
    #[inline]
    pub fn len(&self) -> usize {
        match &self.0 {
            Form::Words(own) => own.len(),
            Form::Doubles(own) => own.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The same numbers as elements of a ring.
    #[must_use]
    pub fn elements<R: Ring>(&self) -> Vec<R> {
        self.numbers().iter().map(element).collect()
    }

    /// Without the zeros at its end.
    #[must_use]
    pub fn trimmed(mut self) -> Self {
        fn trim<N: Width + PartialEq>(list: &mut Vec<N>) {
            while list.last() == Some(&N::default()) {
                list.pop();
            }
        }
        match &mut self.0 {
            Form::Words(own) => trim(own),
            Form::Doubles(own) => trim(own),
        }
        self
    }

    /// All numbers divided by one that divides them all, and is not 0, times a factor.
    #[must_use]
    pub fn times_ratio(&self, factor: i128, divisor: i128) -> Option<Self> {
        let numbers = self.numbers();
        let longest = numbers.bits() + growth(factor) + 1;
        if longest > DOUBLE {
            return None;
        }
        // |n/d| ≤ 2ᵇ⁻ᶜ⁺¹ for a divisor of c digits.
        let longest = (longest + 1).saturating_sub(bits(divisor));
        each_width!(numbers, list => {
            let numbers = list.iter().map(|own| own.wide());
            if divisor == 1 {
                Self::collect(longest, numbers.map(|own| own * factor))
            } else {
                let quotients = numbers.map(|own| machine_quotient(own, divisor));
                Self::collect(longest, quotients.map(|own| own * factor))
            }
        })
    }

    /// The greatest integer that divides all numbers, and a given one.
    #[must_use]
    pub fn content_with(&self, with: u128) -> u128 {
        let mut common = with;
        each_width!(self.numbers(), list => for own in list.iter().rev() {
            if common == 1 {
                break;
            }
            common = divisor::of_sizes(common, own.wide().unsigned_abs());
        });
        common
    }

    /// k aₖ for k ≥ 1: the coefficients of the derivative.
    #[must_use]
    pub fn derivative(list: MachineNumbers<'_>) -> Option<Self> {
        let length = i128::try_from(list.len()).ok()?;
        let terms = (0..).zip(list.iter()).skip(1);
        Self::collect(list.bits() + bits(length), terms.map(|(k, own)| k * own))
    }

    /// m and the integers 0, m a₀, m a₁ / 2, m a₂ / 3, …: the coefficients of an antiderivative.
    #[must_use]
    pub fn antiderivative(list: MachineNumbers<'_>) -> Option<(Self, i128)> {
        let common = *COMMON_MULTIPLES.get(list.len())?;
        let terms = (1..).zip(list.iter());
        let terms = terms.map(|(power, own)| machine_quotient(common, power) * own);
        let longest = list.bits() + bits(common);
        let rise = Self::collect(longest, std::iter::once(0).chain(terms))?;
        Some((rise, common))
    }

    /// f aₖ, but another number in the first place.
    #[must_use]
    pub fn with_first(&self, first: i128, factor: i128) -> Option<Self> {
        let numbers = self.numbers();
        let longest = (numbers.bits() + growth(factor) + 1).max(growth(first) + 1);
        let scaled = numbers.iter().skip(1).map(|own| own * factor);
        Self::collect(longest, std::iter::once(first).chain(scaled))
    }

    /// Σ aₖ
    #[must_use]
    pub fn total(list: MachineNumbers<'_>) -> Option<i128> {
        let fits = list.bits() + list.len().max(1).ilog2() < DOUBLE;
        fits.then(|| list.iter().sum())
    }

    /// The images modulo a prime.
    #[must_use]
    pub fn images(&self, modulus: &Modulus) -> Vec<u64> {
        each_width!(self.numbers(), list => {
            let numbers = list.iter().map(|own| own.wide());
            numbers.map(|own| modulus.embed_machine(own)).collect()
        })
    }
}

/// A machine number as an element of a ring.
#[inline]
fn element<R: Ring>(own: i128) -> R {
    R::from_integer(&Integer::of_machine(own))
}

/// The least b with −2ᵇ ≤ n < 2ᵇ.
#[inline]
pub(super) fn bits(number: i128) -> u32 {
    u128::BITS - (number ^ (number >> DOUBLE)).leading_zeros()
}

/// The least b with |n| ≤ 2ᵇ.
#[inline]
pub(super) fn growth(factor: i128) -> u32 {
    u128::BITS - factor.unsigned_abs().saturating_sub(1).leading_zeros()
}

/// The least common multiple of positive numbers.
fn lcm(left: i128, right: i128) -> Option<i128> {
    let common = divisor::of_sizes(left.unsigned_abs(), right.unsigned_abs());
    let factor = machine_quotient(right, i128::try_from(common).ok()?);
    (bits(left) + bits(factor) <= DOUBLE).then(|| left * factor)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::number::Rational;

    /// Lists of numbers near ±2ᵏ, 0 and ±1: as double words, and as words where they are such.
    pub(in crate::number) fn edges() -> Vec<MachineList> {
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
        lists.flat_map(|own: Vec<i128>| held(&own)).collect()
    }

    pub(in crate::number) fn held(list: &[i128]) -> Vec<MachineList> {
        let words: Result<Vec<i64>, _> = list.iter().map(|own| i64::try_from(*own)).collect();
        let words = words.ok().map(Form::Words);
        let doubles = Form::Doubles(list.to_vec());
        words
            .into_iter()
            .chain([doubles])
            .map(MachineList)
            .collect()
    }

    pub(in crate::number) fn whole(list: MachineNumbers<'_>) -> Vec<Integer> {
        list.iter().map(Integer::from).collect()
    }

    /// An answer is the exact one, and where there is none some number is long.
    pub(in crate::number) fn agrees(answer: Option<&MachineList>, exact: &[Integer], margin: u64) {
        match answer {
            Some(own) => assert_eq!(whole(own.numbers()), exact),
            None => {
                let bits = exact.iter().map(Integer::bits).max().unwrap_or(0);
                assert!(bits + margin > u64::from(DOUBLE), "{exact:?}");
            }
        }
    }

    #[test]
    fn multiples_and_sums_are_exact_or_none() {
        let factors = [1, -1, 3, -12, 1 << 40, -(1 << 62), (1 << 63) - 1, 1 << 100];
        let lists = edges();
        for (index, own) in lists.iter().enumerate() {
            let (list, factor) = (own.numbers(), factors[index % factors.len()]);
            let scaled = own.times_ratio(factor, 1);
            let times = |list: MachineNumbers<'_>| -> Vec<Integer> {
                let factor = Integer::from(factor);
                whole(list).iter().map(|own| own * &factor).collect()
            };
            agrees(scaled.as_ref(), &times(list), 2);
            if let Some(scaled) = scaled {
                let back = scaled.times_ratio(-1, factor);
                let opposite = list.iter().map(|own| -own);
                assert!(back.is_none_or(|own| own.numbers().iter().eq(opposite)));
                let content = scaled.content_with(0);
                assert!(content.is_multiple_of(factor.unsigned_abs()) || content == 0);
            }
            let other = lists[(3 * index + 1) % lists.len()].numbers();
            let terms = [Some((list, factor)), Some((other, 1))];
            let sum = MachineList::combination(terms.into_iter());
            let mut exact = times(list);
            exact.resize(list.len().max(other.len()), Integer::from(0));
            for (sum, own) in exact.iter_mut().zip(other.iter()) {
                *sum = &*sum + Integer::from(own);
            }
            let longest = list.bits() + bits(factor);
            match &sum {
                Some(own) => assert_eq!(whole(own.numbers()), exact),
                None => assert!(longest.max(other.bits()) + 2 > DOUBLE),
            }
            let total = MachineList::total(list).map(Integer::from);
            let exact = whole(list)
                .iter()
                .fold(Integer::from(0), |all, own| all + own);
            assert!(total.is_none_or(|own| own == exact));
        }
    }

    #[test]
    fn derivatives_and_differences_are_exact_or_none() {
        let binomials = [1, 8, 28, 56, 70, 56, 28, 8, 1_i128];
        for own in edges() {
            let list = own.numbers();
            let (rise, common) = match MachineList::antiderivative(list) {
                Some((own, common)) => (own, common),
                None => {
                    assert!(list.bits() + 12 > DOUBLE);
                    continue;
                }
            };
            let slope = MachineList::derivative(rise.numbers());
            let exact: Vec<Integer> = whole(list)
                .iter()
                .map(|own| own * Integer::from(common))
                .collect();
            agrees(slope.as_ref(), &exact, 5);
            if list.len() == binomials.len() {
                // Σ cₖ xᵏ (1+x)ⁿ⁻ᵏ leads back to C(n, i) bᵢ.
                let powers = own.differences();
                let back = powers.and_then(|own| MachineList::binomial_sums(own.numbers(), 8));
                let pairs = list.iter().zip(&binomials);
                let scaled =
                    pairs.map(|(own, binomial)| Integer::from(own) * Integer::from(*binomial));
                assert!(back.is_none_or(|own| whole(own.numbers()).into_iter().eq(scaled)));
            }
        }
    }

    #[test]
    fn words_stay_words_where_their_bound_is_one() {
        let words = |own: &MachineList| matches!(own.0, Form::Words(_));
        let list = MachineList(Form::Words(vec![3, -(1 << 30), 0, 7]));
        let square = MachineList::convolution(list.numbers(), list.numbers());
        assert!(square.is_some_and(|own| words(&own)));
        let product = |factor: i128| list.times_ratio(factor, 1);
        assert!(product(1 << 32).is_some_and(|own| words(&own)));
        assert!(product(1 << 33).is_some_and(|own| !words(&own)));
        let back = product(1 << 33).and_then(|own| own.times_ratio(1, 1 << 33));
        assert!(back.is_some_and(|own| words(&own) && own == list));
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
            let found = MachineList::of_fractions(list.iter());
            let expected = expected.map(|(own, below)| (MachineList(Form::Doubles(own)), below));
            assert_eq!(found, expected);
        }
    }
}
