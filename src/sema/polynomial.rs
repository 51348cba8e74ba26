use crate::curve::Parameter;
use crate::number::{Field, Rational, Real};
use crate::sweep::Scalar;
use crate::syntax::ast::{Expr, ExprKind, ProductOp, Reference, Sign};

use super::lowerer::{Lowerer, parameter_of};
use super::scope::Scope;

/// How deep what is read at once may be nested.
const NESTING: usize = 8;

/// c xᵏ, without x for a number.
struct Monomial {
    coefficient: Rational,
    parameter: Option<Parameter>,
    power: usize,
}

impl<'a> Lowerer<'a> {
    /// The polynomial that a sum such as `1 - (3/4) u + 2 u^3` is: numerals times powers of one
    /// parameter. None for all else, for what a finding is to be reported of, and where the
    /// highest power cancels, so that the degree is the one that is written.
    pub(super) fn polynomial(
        &self,
        expr: &Expr,
        terms: &[(Sign, Expr)],
        scope: &Scope<'a>,
    ) -> Option<Scalar> {
        if scope.frame.is_some() || self.depth + NESTING > self.sources.limits.nesting {
            return None;
        }
        let mut of = None;
        let mut coefficients: Vec<Rational> = Vec::with_capacity(terms.len());
        for (sign, term) in terms {
            let own = self.monomial(term, scope)?;
            if own.power > self.sources.limits.degree || (of.is_some() && own.other_than(of)) {
                return None;
            }
            of = of.or(own.parameter);
            if coefficients.len() <= own.power {
                coefficients.resize_with(own.power + 1, Rational::zero);
            }
            let coefficient = match sign {
                Sign::Plus => own.coefficient,
                Sign::Minus => own.coefficient.negated(),
            };
            let sum = &mut coefficients[own.power];
            *sum = if sum.is_zero() {
                coefficient
            } else {
                sum.plus(&coefficient)
            };
        }
        let leads = coefficients.len() > 1 && coefficients.last().is_some_and(|own| !own.is_zero());
        if !leads {
            return None;
        }
        let coefficients: Vec<_> = coefficients.into_iter().map(Real::from).collect();
        Some(Scalar::polynomial(expr.span, of?, &coefficients))
    }

    fn monomial(&self, term: &Expr, scope: &Scope<'a>) -> Option<Monomial> {
        if let Some(coefficient) = self.numeral(term) {
            return Some(Monomial::number(coefficient));
        }
        match &term.kind {
            ExprKind::Product(factors) => {
                let mut product = Monomial::number(Rational::one());
                for (op, factor) in factors {
                    match self.numeral(factor) {
                        Some(number) => product.scale(*op, number)?,
                        None if *op == ProductOp::Divide => return None,
                        None => product.raise(self.power_of_parameter(factor, scope)?)?,
                    }
                }
                Some(product)
            }
            _ => self.power_of_parameter(term, scope),
        }
    }

    /// `u` or `v^2`, where the parameter may be used.
    fn power_of_parameter(&self, expr: &Expr, scope: &Scope<'a>) -> Option<Monomial> {
        let (base, power) = match &expr.kind {
            ExprKind::Power(base, exponent) => {
                let exponent = self.numeral(exponent)?.to_i64()?;
                let fits = exponent <= i64::from(self.sources.limits.exponent);
                (&**base, usize::try_from(exponent).ok().filter(|_| fits)?)
            }
            _ => (expr, 1),
        };
        let ExprKind::Reference(Reference {
            qualifier: None,
            name,
            primes: 0,
            ..
        }) = &base.kind
        else {
            return None;
        };
        let parameter: Parameter = parameter_of(&name.text)?;
        scope.allows(parameter).then(|| Monomial {
            coefficient: Rational::one(),
            parameter: Some(parameter),
            power,
        })
    }
}

impl Monomial {
    fn number(coefficient: Rational) -> Self {
        Self {
            coefficient,
            parameter: None,
            power: 0,
        }
    }

    /// Whether it has a parameter, and that is not the given one.
    fn other_than(&self, parameter: Option<Parameter>) -> bool {
        self.parameter.is_some() && self.parameter != parameter
    }

    /// Multiplies by a number or divides by one; none for division by zero.
    fn scale(&mut self, op: ProductOp, number: Rational) -> Option<()> {
        let factor = match op {
            ProductOp::Divide => number.inverse()?,
            _ => number,
        };
        self.coefficient = if self.coefficient.is_one() {
            factor
        } else {
            self.coefficient.times(&factor)
        };
        Some(())
    }

    /// Multiplies by a power of a parameter; none if it has one already.
    fn raise(&mut self, power: Self) -> Option<()> {
        let free = self.parameter.is_none();
        (self.parameter, self.power) = (power.parameter, power.power);
        free.then_some(())
    }
}
