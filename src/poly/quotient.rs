use crate::number::Field;

use super::{UniPoly, lcm};

/// A rational function n(x) / d(x) in one parameter, unreduced, with a d of coprime integers.
///
/// Products never cancel; sums go over the least common multiple of the denominators; 0 keeps its
/// denominator: as a [`Fraction`](super::Fraction) does in two parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quotient<F: Field> {
    numerator: UniPoly<F>,
    denominator: UniPoly<F>,
}

impl<F: Field> Quotient<F> {
    /// n / 1
    #[must_use]
    pub fn polynomial(numerator: UniPoly<F>) -> Self {
        Self {
            numerator,
            denominator: UniPoly::one(),
        }
    }

    /// n / d, nothing cancelled but a constant; none if d is 0.
    #[must_use]
    pub fn new(numerator: &UniPoly<F>, denominator: &UniPoly<F>) -> Option<Self> {
        if denominator.is_one() {
            return Some(Self::polynomial(numerator.clone()));
        }
        let (factor, integral) = denominator.split_integral();
        Some(Self {
            numerator: numerator.scale(&factor.inverse()?),
            denominator: integral,
        })
    }

    /// n
    #[must_use]
    pub fn numerator(&self) -> &UniPoly<F> {
        &self.numerator
    }

    /// d, of coprime integers
    #[must_use]
    pub fn denominator(&self) -> &UniPoly<F> {
        &self.denominator
    }

    /// The numerator when the function is written over a multiple of its denominator.
    #[must_use]
    pub fn numerator_over(&self, multiple: &UniPoly<F>) -> UniPoly<F> {
        if self.denominator == *multiple {
            return self.numerator.clone();
        }
        match multiple.exact_div(&self.denominator) {
            Some(cofactor) => &self.numerator * &cofactor,
            None => self.numerator.clone(),
        }
    }

    /// a + b + … over the least common multiple of the denominators; none for no terms.
    #[must_use]
    pub fn sum<'a>(mut terms: impl Iterator<Item = &'a Self> + Clone) -> Option<Self> {
        let all = terms.clone();
        let first = terms.next()?;
        if terms.clone().next().is_none() {
            return Some(first.clone());
        }
        let denominator = all
            .clone()
            .fold(UniPoly::one(), |common, own| lcm(&common, &own.denominator));
        let raised = all.map(|own| own.numerator_over(&denominator));
        let raised: Vec<_> = raised.collect();
        Some(Self {
            numerator: UniPoly::sum(raised.iter()),
            denominator,
        })
    }

    /// a + c
    #[must_use]
    pub fn shifted(&self, constant: &F) -> Self {
        if constant.is_zero() {
            return self.clone();
        }
        Self {
            numerator: &self.numerator + &self.denominator.scale(constant),
            denominator: self.denominator.clone(),
        }
    }

    /// c a
    #[must_use]
    pub fn scale(&self, factor: &F) -> Self {
        Self {
            numerator: self.numerator.scale(factor),
            denominator: self.denominator.clone(),
        }
    }

    /// a b
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        Self {
            numerator: &self.numerator * &other.numerator,
            denominator: &self.denominator * &other.denominator,
        }
        .with_integral_denominator()
    }

    /// aⁿ for n of either sign; none for 0 to a negative power
    #[must_use]
    pub fn power(&self, exponent: i64) -> Option<Self> {
        let size = u32::try_from(exponent.unsigned_abs()).ok()?;
        let (numerator, denominator) = (self.numerator.power(size), self.denominator.power(size));
        if exponent < 0 {
            Self::new(&denominator, &numerator)
        } else {
            Some(
                Self {
                    numerator,
                    denominator,
                }
                .with_integral_denominator(),
            )
        }
    }

    /// a′ = (n′d − nd′)/d²; a constant denominator stays.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let slope = self.numerator.derivative();
        if self.denominator.is_constant() {
            return Self {
                numerator: slope,
                denominator: self.denominator.clone(),
            };
        }
        let left = &slope * &self.denominator;
        let right = &self.numerator * &self.denominator.derivative();
        Self {
            numerator: &left - &right,
            denominator: self.denominator.power(2),
        }
        .with_integral_denominator()
    }

    /// Products of polynomials of coprime integers are such over the rationals (Gauss's lemma), but
    /// not over every field.
    fn with_integral_denominator(self) -> Self {
        if self.denominator.is_rational() {
            return self;
        }
        match Self::new(&self.numerator, &self.denominator) {
            Some(normal) => normal,
            None => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use crate::poly::{BiPoly, Fraction};

    fn polynomial(coefficients: &[i64]) -> UniPoly<Rational> {
        let coefficients: Vec<_> = coefficients.iter().copied().map(Rational::from).collect();
        UniPoly::from_coefficients(&coefficients)
    }

    /// The same function as one of u and v.
    fn fraction(own: &Quotient<Rational>) -> Option<Fraction<Rational>> {
        let place = BiPoly::in_v;
        Fraction::quotient(&place(own.numerator()), &place(own.denominator()))
    }

    #[test]
    fn one_parameter_agrees_with_two() {
        let left = Quotient::new(&polynomial(&[3, 0, 2]), &polynomial(&[-4, 6]));
        let right = Quotient::new(&polynomial(&[1, 1]), &polynomial(&[2, -1, -3]));
        let (Some(left), Some(right)) = (left, right) else {
            unreachable!("no denominator is 0");
        };
        let (Some(first), Some(second)) = (fraction(&left), fraction(&right)) else {
            unreachable!("no denominator is 0");
        };
        let same = |own: &Quotient<Rational>, other: &Fraction<Rational>| {
            let denominator = BiPoly::in_v(own.denominator());
            BiPoly::in_v(own.numerator()) == *other.numerator()
                && denominator == other.denominator().polynomial()
        };
        let sum = Quotient::sum([&left, &right].into_iter());
        assert!(sum.is_some_and(|own| same(&own, &first.plus(&second))));
        assert!(same(&left.times(&right), &first.times(&second)));
        assert!(same(&left.derivative(), &first.derivative_v()));
        for exponent in [-3, -1, 0, 2] {
            let powers = left.power(exponent).zip(first.power(exponent));
            assert!(powers.is_some_and(|(own, other)| same(&own, &other)));
        }
        let constant = Fraction::constant(&Rational::from(5));
        assert!(same(&left.shifted(&5.into()), &first.plus(&constant)));
        let zero = left.scale(&0.into());
        assert!(same(&zero, &first.times(&Fraction::constant(&0.into()))));
        assert_eq!(zero.power(-1), None);
        assert_eq!(Quotient::new(&polynomial(&[1]), &polynomial(&[])), None);
    }
}
