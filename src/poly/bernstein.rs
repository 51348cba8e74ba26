use super::{Numerators, UniPoly};
use crate::number::{Field, Integer, MachineList, Ring, lcm};

/// The Bernstein coefficients bᵢ of p = Σ bᵢ C(n,i) (1−t)ⁿ⁻ⁱ tⁱ, with t = (x − from)/(to − from),
/// at a degree n not below that of p; a lower n is raised to it.
///
/// C(n,i) bᵢ is the coefficient of xⁱ in Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ, where aₖ are the power coefficients
/// in t: additions only.
#[must_use]
pub fn bernstein<F: Field>(polynomial: &UniPoly<F>, degree: usize, from: &F, to: &F) -> Vec<F> {
    let degree = polynomial.degree().unwrap_or(0).max(degree);
    let local = polynomial.restrict(from, to);
    scaled_bernstein(local.numerators(), degree)
        .into_iter()
        .zip(binomials(degree))
        .map(|(own, binomial)| F::from_parts(own, local.denominator() * binomial))
        .collect()
}

/// C(n,i) bᵢ on [0, 1] from ascending power coefficients.
#[must_use]
pub fn scaled_bernstein<R: Ring>(powers: &[R], degree: usize) -> Vec<R> {
    R::binomial_sums(powers, degree)
}

impl<F: Field> UniPoly<F> {
    /// C(n,i) bᵢ of the numerators on [0, 1], at a degree n not below that of the polynomial.
    #[must_use]
    pub fn scaled_bernstein(&self, degree: usize) -> Numerators<F::Ring> {
        let machine = self.machine();
        match machine.and_then(|own| MachineList::binomial_sums(own, degree)) {
            Some(sums) => sums.into(),
            None => scaled_bernstein(self.numerators(), degree).into(),
        }
    }
}

/// Up to this degree C(n,k) ≤ 2ⁿ and the factor before a division are machine numbers.
const MACHINE: usize = 120;

/// Up to this degree they are words.
const WORD: usize = 58;

/// C(n,0), …, C(n,n)
#[must_use]
pub fn binomials(degree: usize) -> Vec<Integer> {
    let mut row = Vec::with_capacity(degree + 1);
    if degree <= WORD {
        let mut next = 1_u64;
        for index in 0..=degree {
            row.push(Integer::from(next));
            next = next * (degree - index) as u64 / (index + 1) as u64;
        }
        return row;
    }
    row.push(Integer::from(1));
    for index in 0..degree {
        let next = &row[index] * Integer::from(degree - index) / Integer::from(index + 1);
        row.push(next);
    }
    row
}

/// C(n,k) for k ≤ n
#[must_use]
pub fn binomial(degree: usize, index: usize) -> Integer {
    let steps = 0..index.min(degree - index);
    if degree <= MACHINE {
        let factors = steps.map(|step| ((degree - step) as u128, (step + 1) as u128));
        return Integer::from(factors.fold(1_u128, |all, (above, below)| all * above / below));
    }
    steps.fold(Integer::from(1), |all, step| {
        all * Integer::from(degree - step) / Integer::from(step + 1)
    })
}

/// m / C(n, i) for the least common multiple m of the binomial coefficients.
pub(super) fn integral_scales(degree: usize) -> Vec<Integer> {
    let binomials = binomials(degree);
    let one = Integer::from(1);
    let common = binomials.iter().fold(one, |common, own| lcm(&common, own));
    binomials.iter().map(|own| &common / own).collect()
}

/// Σ bᵢ C(n,i) (1−t)ⁿ⁻ⁱ tⁱ at the local parameter t; 0 for no coefficients.
#[must_use]
pub fn de_casteljau<F: Field>(coefficients: &[F], at: &F) -> F {
    let (left, _) = subdivide(coefficients, at);
    left.into_iter().next_back().unwrap_or_else(F::zero)
}

/// The Bernstein coefficients of the same polynomial on [0, t] and on [t, 1].
///
/// De Casteljau's triangle bᵢ ← (1−t) bᵢ + t bᵢ₊₁ on integer numerators; its sides are the
/// coefficients sought.
#[must_use]
pub fn subdivide<F: Field>(coefficients: &[F], at: &F) -> (Vec<F>, Vec<F>) {
    let (mut row, mut denominator) = common_numerators(coefficients.iter());
    let (weight, scale) = at.parts();
    let complement = F::Ring::from_integer(scale).minus(weight);
    let (mut left, mut right) = (Vec::new(), Vec::new());
    while let (Some(first), Some(last)) = (row.first(), row.last()) {
        left.push(F::from_parts(first.clone(), denominator.clone()));
        right.push(F::from_parts(last.clone(), denominator.clone()));
        row = row
            .windows(2)
            .map(|pair| {
                let mut value = pair[0].times(&complement);
                value.add_product(&pair[1], weight);
                value
            })
            .collect();
        denominator *= scale;
    }
    right.reverse();
    (left, right)
}

/// The polynomial whose Bernstein coefficients on [from, to] these are; the constant one if the
/// interval is a point.
///
/// aₖ = C(n,k) Δᵏb₀ are the power coefficients in t = (x − from)/(to − from).
#[must_use]
pub fn from_bernstein<'a, F: Field>(
    coefficients: impl IntoIterator<Item = &'a F>,
    from: &F,
    to: &F,
) -> UniPoly<F> {
    let coefficients: Vec<&F> = coefficients.into_iter().collect();
    let Some(degree) = coefficients.len().checked_sub(1) else {
        return UniPoly::zero();
    };
    if from.is_zero() && to.is_one() {
        return in_local_powers(&coefficients, degree);
    }
    let Some(inverse) = to.minus(from).inverse() else {
        return UniPoly::constant(coefficients[0]);
    };
    // t runs from −from/(to−from) at x = 0 to (1−from)/(to−from) at x = 1.
    let local = in_local_powers(&coefficients, degree);
    let start = from.negated().times(&inverse);
    local.restrict(&start, &start.plus(&inverse))
}

/// Σ C(n,k) Δᵏb₀ tᵏ
fn in_local_powers<F: Field>(coefficients: &[&F], degree: usize) -> UniPoly<F> {
    if let Some((row, denominator)) = MachineList::of_fractions(coefficients.iter().copied())
        && let Some(powers) = row.differences()
    {
        return UniPoly::lowest(powers.trimmed().into(), denominator.into());
    }
    let (row, denominator) = common_numerators(coefficients.iter().copied());
    UniPoly::lowest(differences(row, &binomials(degree)), denominator)
}

/// C(n,k) Δᵏb₀, without zeros at the end.
fn differences<R: Ring>(mut row: Vec<R>, binomials: &[Integer]) -> Numerators<R> {
    let mut powers = Vec::with_capacity(row.len());
    for binomial in binomials {
        powers.push(row[0].scaled(binomial));
        row = row.windows(2).map(|pair| pair[1].minus(&pair[0])).collect();
    }
    while powers.last().is_some_and(Ring::is_zero) {
        powers.pop();
    }
    powers.into()
}

/// Numerators over one denominator.
fn common_numerators<'a, F: Field>(values: impl Iterator<Item = &'a F>) -> (Vec<F::Ring>, Integer) {
    let parts: Vec<_> = values.map(Field::parts).collect();
    let common = parts
        .iter()
        .fold(Integer::from(1), |common, (_, own)| lcm(&common, own));
    let numerators = parts
        .iter()
        .map(|(numerator, own)| numerator.scaled(&(&common / *own)));
    (numerators.collect(), common)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    fn numbers(values: &[i64]) -> Vec<Rational> {
        values.iter().copied().map(Rational::from).collect()
    }

    #[test]
    fn one_binomial_coefficient_is_that_of_the_row() {
        for degree in [0, 1, 2, 9, 60, 119, 120, 121, 130] {
            let row = binomials(degree);
            let each = (0..=degree).map(|index| binomial(degree, index));
            assert_eq!(each.collect::<Vec<_>>(), row);
            let sum = row.iter().fold(Integer::from(0), |all, own| all + own);
            assert_eq!(sum, Integer::from(1) << u32::try_from(degree).unwrap_or(0));
        }
    }

    #[test]
    fn the_parabola_has_its_textbook_coefficients() {
        let square = UniPoly::from_coefficients(&numbers(&[0, 0, 1]));
        let (zero, one, two) = (0.into(), 1.into(), 2.into());
        assert_eq!(bernstein(&square, 2, &zero, &one), numbers(&[0, 0, 1]));
        assert_eq!(bernstein(&square, 2, &one, &two), numbers(&[1, 2, 4]));
        let third = Rational::new(1.into(), 3.into());
        assert_eq!(
            bernstein(&square, 3, &zero, &one),
            [zero.clone(), zero.clone(), third, one.clone()]
        );
        assert_eq!(
            bernstein(&UniPoly::zero(), 1, &zero, &one),
            numbers(&[0, 0])
        );
    }

    #[test]
    fn coefficients_lead_back_to_the_polynomial() {
        let coefficients = numbers(&[3, -1, 4, 1, -5]);
        let (from, to) = (
            Rational::new((-1).into(), 3.into()),
            Rational::new(5.into(), 2.into()),
        );
        let polynomial = from_bernstein(&coefficients, &from, &to);
        assert_eq!(bernstein(&polynomial, 4, &from, &to), coefficients);
        let at = Rational::new(2.into(), 7.into());
        let global = &from + &(&at * &(&to - &from));
        assert_eq!(
            de_casteljau(&coefficients, &at),
            polynomial.evaluate(&global)
        );
        let (left, right) = subdivide(&coefficients, &at);
        assert_eq!(bernstein(&polynomial, 4, &from, &global), left);
        assert_eq!(bernstein(&polynomial, 4, &global, &to), right);
    }
}
