use std::rc::Rc;

use crate::curve::Parameter;
use crate::number::{Field, Real};
use crate::poly::{Fraction, Quotient, UniPoly};

/// What an expression expands to, held in as few parameters as it is written with: most parts of
/// a sweep are numbers or functions of one parameter, and only their products are surfaces.
///
/// The unreduced fraction is the same in each form, see [`Fraction`]. Copies share their memory.
#[derive(Clone, Debug)]
pub enum Expanded {
    /// A number.
    Number(Real),
    /// A function of one parameter.
    InOne(Parameter, Quotient<Real>),
    /// A function of u and v.
    InBoth(Rc<Fraction<Real>>),
}

impl From<Fraction<Real>> for Expanded {
    fn from(own: Fraction<Real>) -> Self {
        Self::InBoth(Rc::new(own))
    }
}

impl Expanded {
    /// u or v
    #[must_use]
    pub(super) fn variable(parameter: Parameter) -> Self {
        Self::InOne(parameter, Quotient::polynomial(UniPoly::variable()))
    }

    /// The function as a fraction in u and v.
    #[must_use]
    pub fn fraction(&self) -> Fraction<Real> {
        match self {
            Self::Number(own) => Fraction::constant(own),
            Self::InOne(Parameter::U, own) => Fraction::in_u(own),
            Self::InOne(Parameter::V, own) => Fraction::in_v(own),
            Self::InBoth(own) => (**own).clone(),
        }
    }

    /// As [`Expanded::fraction`], without a copy if nobody else holds it.
    #[must_use]
    pub(super) fn into_fraction(self) -> Fraction<Real> {
        match self {
            Self::InBoth(own) => Rc::unwrap_or_clone(own),
            own => own.fraction(),
        }
    }

    /// The function as a quotient in one parameter; none if it depends on the other one.
    #[must_use]
    pub fn in_one(&self, parameter: Parameter) -> Option<Quotient<Real>> {
        let zero = Real::zero();
        match self {
            Self::Number(own) => Some(Quotient::polynomial(UniPoly::constant(own))),
            Self::InOne(own, quotient) if *own == parameter => Some(quotient.clone()),
            Self::InOne(..) => None,
            Self::InBoth(own) => {
                let (numerator, denominator) = (own.numerator(), own.denominator());
                let degree = numerator.bidegree().unwrap_or_default();
                let (across, along, other, alone) = match parameter {
                    Parameter::U => (
                        degree.v,
                        denominator.in_u(),
                        denominator.in_v(),
                        numerator.at_v(&zero),
                    ),
                    Parameter::V => (
                        degree.u,
                        denominator.in_v(),
                        denominator.in_u(),
                        numerator.at_u(&zero),
                    ),
                };
                let fits = across == 0 && other.is_constant() && denominator.is_separable();
                fits.then(|| Quotient::new(&alone, along))?
            }
        }
    }

    /// Whether the function is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Number(own) => own.is_zero(),
            Self::InOne(_, own) => own.numerator().is_zero(),
            Self::InBoth(own) => own.is_zero(),
        }
    }

    /// a + b + …
    #[must_use]
    pub(super) fn sum(terms: &[Self]) -> Self {
        let number = terms.iter().fold(None, |sum: Option<Real>, own| match own {
            Self::Number(own) => Some(sum.map_or_else(|| own.clone(), |sum| sum.plus(own))),
            _ => sum,
        });
        let mut sums = [Parameter::U, Parameter::V].map(|along| {
            Quotient::sum(terms.iter().filter_map(move |own| match own {
                Self::InOne(parameter, own) if *parameter == along => Some(own),
                _ => None,
            }))
        });
        // The number joins a function of one parameter, if there is one.
        let host = sums.iter_mut().find_map(Option::as_mut);
        let rest = match (host, number) {
            (Some(host), Some(number)) => {
                *host = host.shifted(&number);
                None
            }
            (_, number) => number,
        };
        let mut in_both = terms.iter().filter_map(|own| match own {
            Self::InBoth(own) => Some(&**own),
            _ => None,
        });
        match (sums, in_both.next()) {
            ([None, None], None) => Self::Number(rest.unwrap_or_else(Real::zero)),
            ([Some(own), None], None) => Self::InOne(Parameter::U, own),
            ([None, Some(own)], None) => Self::InOne(Parameter::V, own),
            ([in_u, in_v], first) => {
                let in_u = in_u.as_ref().map(Fraction::in_u);
                let in_v = in_v.as_ref().map(Fraction::in_v);
                let rest = rest.filter(|own| !own.is_zero());
                let constant = rest.as_ref().map(Fraction::constant);
                let single = [&in_v, &in_u, &constant].into_iter().flatten();
                let all: Vec<_> = single.chain(first).chain(in_both).collect();
                Fraction::sum(&all).into()
            }
        }
    }

    /// a b …
    #[must_use]
    pub(super) fn product(factors: &[Self]) -> Self {
        let (mut number, mut in_u, mut in_v, mut in_both) = (None, None, None, None);
        for factor in factors {
            match factor {
                Self::Number(own) => join(&mut number, own, Real::times),
                Self::InOne(Parameter::U, own) => join(&mut in_u, own, Quotient::times),
                Self::InOne(Parameter::V, own) => join(&mut in_v, own, Quotient::times),
                Self::InBoth(own) => join(&mut in_both, own, |all, own| Rc::new(all.times(own))),
            }
        }
        // The number joins a function of one parameter, if there is one.
        if let Some(host) = in_v.as_mut().or(in_u.as_mut())
            && let Some(own) = number.take()
        {
            *host = host.scale(&own);
        }
        let one = || Quotient::polynomial(UniPoly::one());
        match (in_both, in_u, in_v) {
            (None, None, None) => Self::Number(number.unwrap_or_else(Real::one)),
            (None, Some(own), None) => Self::InOne(Parameter::U, own),
            (None, None, Some(own)) => Self::InOne(Parameter::V, own),
            (None, Some(in_u), Some(in_v)) => Fraction::product(&in_u, &in_v).into(),
            (Some(all), None, None) => match number {
                Some(own) if !own.is_one() => all.scale(&own).into(),
                _ => Self::InBoth(all),
            },
            (Some(all), in_u, in_v) => {
                let [in_u, in_v] = [in_u, in_v].map(|own| own.unwrap_or_else(one));
                all.times_separable(&in_u, &in_v).into()
            }
        }
    }

    /// aⁿ for n of either sign; none for 0 to a negative power
    #[must_use]
    pub(super) fn power(&self, exponent: i64) -> Option<Self> {
        Some(match self {
            Self::Number(own) => Self::Number(own.power(exponent)?),
            Self::InOne(parameter, own) => Self::InOne(*parameter, own.power(exponent)?),
            Self::InBoth(own) => own.power(exponent)?.into(),
        })
    }

    /// ∂a/∂u or ∂a/∂v
    #[must_use]
    pub(super) fn partial(&self, by: Parameter) -> Self {
        match self {
            Self::Number(_) => Self::Number(Real::zero()),
            Self::InOne(own, quotient) if *own == by => Self::InOne(by, quotient.derivative()),
            Self::InOne(own, quotient) => Self::InOne(*own, quotient.scale(&Real::zero())),
            Self::InBoth(own) => match by {
                Parameter::U => own.derivative_u().into(),
                Parameter::V => own.derivative_v().into(),
            },
        }
    }

    /// The number that the function is; none if it depends on u or v.
    #[must_use]
    pub(super) fn as_constant(&self) -> Option<Real> {
        match self {
            Self::Number(own) => Some(own.clone()),
            other => other.fraction().as_constant(),
        }
    }
}

/// Multiplies a product under way by a factor.
fn join<T: Clone>(product: &mut Option<T>, factor: &T, times: impl Fn(&T, &T) -> T) {
    *product = Some(match product.take() {
        None => factor.clone(),
        Some(own) => times(&own, factor),
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Tower;

    fn quotient(above: &[Real], below: &[Real]) -> Quotient<Real> {
        let [above, below] = [above, below].map(UniPoly::from_coefficients);
        Quotient::new(&above, &below).unwrap_or_else(|| unreachable!("no denominator is 0"))
    }

    #[test]
    fn functions_of_one_parameter_multiply_as_fractions_do() {
        let root = Tower::new(2).square_root(&Real::from(2));
        let root = root.unwrap_or_else(|own| unreachable!("{own:?}"));
        let [zero, one, three] = [0, 1, 3].map(Real::from);
        let quotients = [
            quotient(&[], &[one.clone(), root.clone()]),
            quotient(std::slice::from_ref(&three), std::slice::from_ref(&one)),
            quotient(
                &[one.clone(), three.clone()],
                &[three.clone(), zero, one.clone()],
            ),
            quotient(&[root.clone(), one.clone()], &[three, root]),
        ];
        for (own, first) in quotients.iter().zip(quotients.iter().rev()) {
            let saddle = Fraction::product(own, first).plus(&Fraction::in_v(first));
            for (second, third) in quotients
                .iter()
                .flat_map(|a| quotients.iter().map(move |b| (a, b)))
            {
                let factors = [
                    saddle.clone().into(),
                    Expanded::InOne(Parameter::V, third.clone()),
                    Expanded::InOne(Parameter::U, second.clone()),
                    Expanded::Number(Real::from(-5)),
                ];
                let product = Expanded::product(&factors).into_fraction();
                let whole = factors.map(Expanded::into_fraction);
                let one_by_one = whole
                    .iter()
                    .fold(Fraction::constant(&one), |all, own| all.times(own));
                assert_eq!(product.denominator(), one_by_one.denominator());
                let difference = product.numerator() - one_by_one.numerator();
                assert!(difference.is_zero());
            }
        }
    }

    #[test]
    fn a_function_of_both_is_none_of_one() {
        let [u, v] = [Parameter::U, Parameter::V].map(Expanded::variable);
        let saddle = Expanded::product(&[u.clone(), v.clone()]);
        assert!(saddle.in_one(Parameter::U).is_none() && saddle.in_one(Parameter::V).is_none());
        // u v / v is written with v in both parts; u v − u v + u is u.
        let inverse = v.power(-1);
        let quotient = inverse.map(|own| Expanded::product(&[saddle.clone(), own]));
        assert!(quotient.is_some_and(|own| own.in_one(Parameter::U).is_none()));
        let minus = Expanded::Number(Real::from(-1));
        let opposite = Expanded::product(&[minus, saddle.clone()]);
        let line = Expanded::sum(&[saddle, opposite, u.clone()]);
        assert_eq!(line.in_one(Parameter::U), u.in_one(Parameter::U));
        assert!(line.in_one(Parameter::V).is_none());
    }
}
