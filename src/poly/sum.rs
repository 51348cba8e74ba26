use std::ops::{Add, Sub};

use super::UniPoly;
use crate::number::{Field, Integer, MachineList, Ring, lcm};

impl<F: Field> UniPoly<F> {
    /// p + q + …
    #[must_use]
    pub fn sum<'a>(terms: impl Iterator<Item = &'a Self> + Clone) -> Self {
        let mut rest = terms.clone();
        match (rest.next(), rest.next()) {
            (None, _) => return Self::zero(),
            (Some(only), None) => return only.clone(),
            _ => {}
        }
        let denominators = terms.clone().map(Self::denominator);
        let common = denominators.fold(Integer::one(), |all, own| lcm(&all, own));
        let scaled = terms.map(|own| (own, &common / own.denominator()));
        Self::combination(scaled, &common)
    }

    /// Σ fₖ pₖ qₖ for integers fₖ, brought to lowest terms once.
    #[must_use]
    pub fn sum_of_products(terms: &[(i64, &Self, &Self)]) -> Self {
        let in_machine_numbers = || {
            let mut common = Integer::one();
            let mut products = Vec::with_capacity(terms.len());
            for (factor, left, right) in terms {
                let below = left.denominator() * right.denominator();
                if !left.is_zero() && !right.is_zero() {
                    common = lcm(&common, &below);
                    let (left, right) = (left.machine()?, right.machine()?);
                    products.push((Integer::from(*factor), below, left, right));
                }
            }
            let products = products.into_iter().map(|(factor, below, left, right)| {
                Some(((factor * (&common / below)).machine()?, left, right))
            });
            let sums = MachineList::products(&products.collect::<Option<Vec<_>>>()?)?;
            Some(Self::lowest(sums.trimmed().into(), common))
        };
        in_machine_numbers().unwrap_or_else(|| {
            terms
                .iter()
                .fold(Self::zero(), |sum, (factor, left, right)| {
                    &sum + &(*left * *right).scale(&F::from_integer(&Integer::from(*factor)))
                })
        })
    }

    /// a² − b², 2ab and a² + b²: real part, imaginary part and norm of (a + ib)².
    #[must_use]
    pub fn complex_squares(a: &Self, b: &Self) -> [Self; 3] {
        let in_machine_numbers = || {
            let common = lcm(a.denominator(), b.denominator());
            let raised = |own: &Self| {
                let factor = (&common / own.denominator()).machine()?;
                own.numerators_held()?.machine()?.times_ratio(factor, 1)
            };
            let (left, right) = (raised(a)?, raised(b)?);
            let (left, right) = (left.numbers(), right.numbers());
            let first = MachineList::convolution(left, left)?;
            let second = MachineList::convolution(right, right)?;
            let cross = MachineList::products(&[(2, left, right)])?;
            let sum = |sign| {
                let terms = [Some((first.numbers(), 1)), Some((second.numbers(), sign))];
                MachineList::combination(terms.into_iter())
            };
            let lists = [sum(-1)?, cross, sum(1)?].map(MachineList::trimmed);
            let below = &common * &common;
            Some(lists.map(|own| Self::lowest(own.into(), below.clone())))
        };
        in_machine_numbers().unwrap_or_else(|| {
            let (first, second, cross) = (a * a, b * b, a * b);
            [&first - &second, &cross + &cross, &first + &second]
        })
    }

    /// Σ fₖ pₖ / d for the numerators pₖ of polynomials.
    fn combination<'a>(
        terms: impl Iterator<Item = (&'a Self, Integer)> + Clone,
        denominator: &Integer,
    ) -> Self {
        let machine = terms
            .clone()
            .map(|(own, factor)| Some((own.machine()?, factor.machine()?)));
        if let Some(sums) = MachineList::combination(machine) {
            return Self::lowest(sums.trimmed().into(), denominator.clone());
        }
        let length = terms.clone().map(|(own, _)| own.numerators().len()).max();
        let mut sums = vec![F::Ring::zero(); length.unwrap_or(0)];
        for (term, factor) in terms {
            let factor = F::Ring::from_integer(&factor);
            for (sum, own) in sums.iter_mut().zip(term.numerators()) {
                if !own.is_zero() {
                    sum.add_product(own, &factor);
                }
            }
        }
        Self::from_numerators(sums, denominator.clone())
    }
}

impl<F: Field> Add for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn add(self, other: Self) -> UniPoly<F> {
        match (self.is_zero(), other.is_zero()) {
            (true, _) => other.clone(),
            (_, true) => self.clone(),
            _ => UniPoly::sum([self, other].into_iter()),
        }
    }
}

impl<F: Field> Sub for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn sub(self, other: Self) -> UniPoly<F> {
        if other.is_zero() {
            return self.clone();
        }
        let common = lcm(self.denominator(), other.denominator());
        let (left, right) = (
            &common / self.denominator(),
            -(&common / other.denominator()),
        );
        UniPoly::combination([(self, left), (other, right)].into_iter(), &common)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Real, Tower};

    /// 0, 1, constants, short and long numerators over several denominators, irrational ones.
    fn polynomials() -> Vec<UniPoly<Real>> {
        let tower = Tower::new(4);
        let root = tower.square_root(&Real::from(2));
        let root = root.unwrap_or_else(|_| Real::zero());
        let power = |exponent: i64| Real::power_of_two(exponent);
        let third = Real::ratio(1.into(), 3.into());
        let rows = [
            vec![],
            vec![Real::one()],
            vec![Real::from(-6)],
            vec![Real::from(2), third.clone()],
            vec![Real::from(-1), Real::zero(), Real::from(5)],
            vec![&power(61) * &third, -&power(62), Real::one()],
            vec![power(-9), &power(126) - &Real::one(), third],
            vec![power(150), Real::from(7)],
            vec![root.clone(), Real::from(4), &root * &Real::from(-3)],
        ];
        rows.iter()
            .map(|own| UniPoly::from_coefficients(own))
            .collect()
    }

    #[test]
    fn sums_of_products_are_those_of_products() {
        let all = polynomials();
        for (a, b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
            let [square, cross, norm] = UniPoly::complex_squares(a, b);
            assert_eq!(square, &(a * a) - &(b * b), "{a} {b}");
            assert_eq!(cross, (a * b).scale(&2.into()), "{a} {b}");
            assert_eq!(norm, &(a * a) + &(b * b), "{a} {b}");
            for (c, d) in all.iter().zip(all.iter().rev()) {
                let sum = UniPoly::sum_of_products(&[(3, a, b), (-2, c, d), (1, b, d)]);
                let terms = [(a * b).scale(&3.into()), (c * d).scale(&(-2).into()), b * d];
                assert_eq!(sum, UniPoly::sum(terms.iter()), "{a} {b} {c} {d}");
            }
        }
    }

    #[test]
    fn antiderivatives_begin_where_they_are_told_to() {
        let values = [
            Real::zero(),
            Real::from(-7),
            Real::ratio(5.into(), 12.into()),
        ];
        let values = values.into_iter().chain([Real::power_of_two(140)]);
        for value in values.collect::<Vec<_>>() {
            for own in polynomials() {
                for at in [Real::zero(), Real::one(), Real::ratio(2.into(), 3.into())] {
                    let rise = own.antiderivative_from(&at, &value);
                    assert_eq!(rise.derivative(), own);
                    assert_eq!(rise.evaluate(&at), value);
                    let canonical = UniPoly::from_coefficients(&rise.coefficients());
                    assert_eq!(rise, canonical);
                }
            }
        }
    }
}
