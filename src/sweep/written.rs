use crate::curve::Parameter;
use crate::number::{Field, Real};
use crate::poly::UniPoly;

use super::{Form, Scalar};

/// c xᵏ with c = 1 where none is written, and without x for k = 0.
#[derive(Clone, Copy, Default)]
struct Monomial<'a> {
    coefficient: Option<&'a Real>,
    parameter: Option<Parameter>,
    power: usize,
}

/// The polynomial Σ c xᵏ in one parameter that a sum is, if it is written as such.
#[must_use]
pub(super) fn written_polynomial(terms: &[Scalar]) -> Option<(Parameter, UniPoly<Real>)> {
    let monomials: Vec<_> = terms.iter().map(monomial).collect::<Option<_>>()?;
    let parameter = monomials.iter().find_map(|own| own.parameter)?;
    let foreign = |own: &Monomial<'_>| own.parameter.is_some_and(|other| other != parameter);
    if monomials.iter().any(foreign) {
        return None;
    }
    let degree = monomials.iter().map(|own| own.power).max()?;
    let mut coefficients = vec![Real::zero(); degree + 1];
    for Monomial {
        coefficient, power, ..
    } in monomials
    {
        let own = coefficient.cloned().unwrap_or_else(Real::one);
        let sum = &mut coefficients[power];
        *sum = if sum.is_zero() { own } else { sum.plus(&own) };
    }
    Some((parameter, UniPoly::from_coefficients(&coefficients)))
}

fn monomial(term: &Scalar) -> Option<Monomial<'_>> {
    match term.form() {
        Form::Constant(own) => Some(Monomial {
            coefficient: Some(own),
            ..Monomial::default()
        }),
        Form::Product(factors) => match factors.as_slice() {
            [number, power] => Some(Monomial {
                coefficient: Some(number.as_number()?),
                ..power_of_parameter(power)?
            }),
            _ => None,
        },
        _ => power_of_parameter(term),
    }
}

fn power_of_parameter(factor: &Scalar) -> Option<Monomial<'static>> {
    let (base, power) = match factor.form() {
        Form::Power(base, exponent) => (base, usize::try_from(*exponent).ok()?),
        _ => (factor, 1),
    };
    match base.form() {
        Form::Parameter(own) => Some(Monomial {
            coefficient: None,
            parameter: Some(*own),
            power,
        }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Limits, Span};
    use crate::number::Tower;
    use crate::sweep::{Domain, Expanded, Expander};

    fn power(parameter: Parameter, exponent: i64) -> Scalar {
        let span = Span::default();
        Scalar::power(
            span,
            Scalar::new(span, Form::Parameter(parameter)),
            exponent,
        )
    }

    fn times(number: i64, factor: Scalar) -> Scalar {
        let span = Span::default();
        Scalar::product(span, vec![Scalar::constant(span, number.into()), factor])
    }

    #[test]
    fn a_written_polynomial_is_what_its_terms_add_up_to() {
        let u = |exponent| power(Parameter::U, exponent);
        let constant = |own: i64| Scalar::constant(Span::default(), own.into());
        for terms in [
            vec![constant(3), times(-2, u(1)), u(4), times(7, u(1))],
            vec![u(1), times(-1, u(1))],
            vec![times(5, u(3)), u(0), constant(2)],
        ] {
            let (domain, tower, limits) = (Domain::unit(), Tower::new(2), Limits::default());
            let mut expander = Expander::new(&domain, &tower, &limits);
            let parts: Vec<_> = terms
                .iter()
                .map_while(|own| expander.expand(own).ok())
                .collect();
            let Some((Parameter::U, polynomial)) = written_polynomial(&terms) else {
                unreachable!("{terms:?}");
            };
            let sum = Expanded::sum(&parts).in_one(Parameter::U);
            assert!(
                sum.is_some_and(|own| *own.numerator() == polynomial && own.denominator().is_one())
            );
        }
        assert!(written_polynomial(&[u(1), power(Parameter::V, 2)]).is_none());
        assert!(written_polynomial(&[u(1), u(-1)]).is_none());
        assert!(written_polynomial(&[constant(1), constant(2)]).is_none());
    }
}
