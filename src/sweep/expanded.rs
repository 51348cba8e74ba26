use std::rc::Rc;

use crate::curve::Parameter;
use crate::number::{Field, Real};
use crate::poly::{Fraction, Quotient, UniPoly};

/// What an expression expands to, held in as few parameters as it is written with: most parts of
/// a sweep are numbers or functions of one parameter, and only their products are surfaces.
///
/// The unreduced fraction is the same in each form, see [`Fraction`].
#[derive(Clone, Debug)]
pub enum Expanded {
    /// A number.
    Number(Real),
    /// A function of one parameter.
    InOne(Parameter, Quotient<Real>),
    /// A function of u and v.
    InBoth(Fraction<Real>),
}

/// The terms of a sum, by the parameters that they depend on.
struct Gathered<'a> {
    numbers: Vec<&'a Real>,
    in_one: [Vec<&'a Quotient<Real>>; 2],
    in_both: Vec<&'a Fraction<Real>>,
}

impl<'a> Gathered<'a> {
    fn of(parts: &'a [Rc<Expanded>]) -> Self {
        let mut gathered = Self {
            numbers: Vec::new(),
            in_one: [Vec::new(), Vec::new()],
            in_both: Vec::new(),
        };
        for part in parts {
            match &**part {
                Expanded::Number(own) => gathered.numbers.push(own),
                Expanded::InOne(Parameter::U, own) => gathered.in_one[0].push(own),
                Expanded::InOne(Parameter::V, own) => gathered.in_one[1].push(own),
                Expanded::InBoth(own) => gathered.in_both.push(own),
            }
        }
        gathered
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
            Self::InBoth(own) => own.clone(),
        }
    }

    /// As [`Expanded::fraction`], without a copy if nobody else holds it.
    #[must_use]
    pub(super) fn into_fraction(self: Rc<Self>) -> Fraction<Real> {
        match Rc::try_unwrap(self) {
            Ok(Self::InBoth(own)) => own,
            Ok(own) => own.fraction(),
            Err(shared) => shared.fraction(),
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
    pub(super) fn sum(terms: &[Rc<Self>]) -> Self {
        let gathered = Gathered::of(terms);
        let number = gathered.numbers.into_iter().fold(Real::zero(), |sum, own| {
            if sum.is_zero() {
                own.clone()
            } else {
                sum.plus(own)
            }
        });
        let mut sums = gathered.in_one.map(|own| match own.as_slice() {
            [] => None,
            all => Some(Quotient::sum(all)),
        });
        // The number joins a function of one parameter, if there is one.
        let host = sums.iter_mut().find_map(Option::as_mut);
        let rest = match host {
            Some(own) => {
                *own = own.shifted(&number);
                Real::zero()
            }
            None => number,
        };
        let [in_u, in_v] = sums;
        match (in_u, in_v, gathered.in_both.is_empty()) {
            (None, None, true) => Self::Number(rest),
            (Some(own), None, true) => Self::InOne(Parameter::U, own),
            (None, Some(own), true) => Self::InOne(Parameter::V, own),
            (in_u, in_v, _) => {
                let in_u = in_u.as_ref().map(Fraction::in_u);
                let in_v = in_v.as_ref().map(Fraction::in_v);
                let constant = (!rest.is_zero()).then(|| Fraction::constant(&rest));
                let single = [in_v, in_u, constant];
                let single = single.iter().flatten();
                Self::InBoth(Fraction::sum(
                    &single.chain(gathered.in_both).collect::<Vec<_>>(),
                ))
            }
        }
    }

    /// a b …
    #[must_use]
    pub(super) fn product(factors: &[Rc<Self>]) -> Self {
        let (mut number, mut in_u, mut in_v, mut in_both) = (None, None, None, None);
        for factor in factors {
            match &**factor {
                Self::Number(own) => join(&mut number, own, Real::times),
                Self::InOne(Parameter::U, own) => join(&mut in_u, own, Quotient::times),
                Self::InOne(Parameter::V, own) => join(&mut in_v, own, Quotient::times),
                Self::InBoth(own) => join(&mut in_both, own, Fraction::times),
            }
        }
        // The number joins a function of one parameter, if there is one.
        if let Some(host) = in_v.as_mut().or(in_u.as_mut())
            && let Some(own) = number.take()
        {
            *host = host.scale(&own);
        }
        let single = match (in_u, in_v) {
            (None, None) => Self::Number(number.unwrap_or_else(Real::one)),
            (Some(own), None) => Self::InOne(Parameter::U, own),
            (None, Some(own)) => Self::InOne(Parameter::V, own),
            (Some(in_u), Some(in_v)) => Self::InBoth(Fraction::product(&in_u, &in_v)),
        };
        match (in_both, single) {
            (None, single) => single,
            (Some(all), Self::Number(own)) if own.is_one() => Self::InBoth(all),
            (Some(all), Self::Number(own)) => Self::InBoth(all.scale(&own)),
            (Some(all), other) => Self::InBoth(all.times(&other.fraction())),
        }
    }

    /// aⁿ for n of either sign; none for 0 to a negative power
    #[must_use]
    pub(super) fn power(&self, exponent: i64) -> Option<Self> {
        Some(match self {
            Self::Number(own) => Self::Number(own.power(exponent)?),
            Self::InOne(parameter, own) => Self::InOne(*parameter, own.power(exponent)?),
            Self::InBoth(own) => Self::InBoth(own.power(exponent)?),
        })
    }

    /// ∂a/∂u or ∂a/∂v
    #[must_use]
    pub(super) fn partial(&self, by: Parameter) -> Self {
        match self {
            Self::Number(_) => Self::Number(Real::zero()),
            Self::InOne(own, quotient) if *own == by => Self::InOne(by, quotient.derivative()),
            Self::InOne(own, quotient) => Self::InOne(*own, quotient.scale(&Real::zero())),
            Self::InBoth(own) => Self::InBoth(match by {
                Parameter::U => own.derivative_u(),
                Parameter::V => own.derivative_v(),
            }),
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

    #[test]
    fn a_function_of_both_is_none_of_one() {
        let [u, v] = [Parameter::U, Parameter::V].map(|own| Rc::new(Expanded::variable(own)));
        let saddle = Rc::new(Expanded::product(&[Rc::clone(&u), Rc::clone(&v)]));
        assert!(saddle.in_one(Parameter::U).is_none() && saddle.in_one(Parameter::V).is_none());
        // u v / v is written with v in both parts; u v − u v + u is u.
        let inverse = v.power(-1).map(Rc::new);
        let quotient = inverse.map(|own| Expanded::product(&[Rc::clone(&saddle), own]));
        assert!(quotient.is_some_and(|own| own.in_one(Parameter::U).is_none()));
        let minus = Rc::new(Expanded::Number(Real::from(-1)));
        let opposite = Rc::new(Expanded::product(&[minus, Rc::clone(&saddle)]));
        let line = Expanded::sum(&[saddle, opposite, Rc::clone(&u)]);
        assert_eq!(line.in_one(Parameter::U), u.in_one(Parameter::U));
        assert!(line.in_one(Parameter::V).is_none());
    }
}
