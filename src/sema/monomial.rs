use crate::curve::Parameter;
use crate::number::Real;
use crate::sweep::{Form, Scalar};
use crate::syntax::ast::{Expr, ExprKind, ProductOp, Reference};

use super::lowerer::{Lowerer, parameter_of};
use super::scope::Scope;

/// How deep what is read at once may be nested.
const NESTING: usize = 6;

impl<'a> Lowerer<'a> {
    /// The scalar that `3 u` or `(-3/4) * v^2` is: a numeral before a parameter or a power of one.
    /// None for all else, and for what a finding is to be reported of.
    pub(super) fn monomial(
        &self,
        expr: &Expr,
        factors: &[(ProductOp, Expr)],
        scope: &Scope<'a>,
    ) -> Option<Scalar> {
        let [
            (_, number),
            (ProductOp::Times | ProductOp::Juxtapose, power),
        ] = factors
        else {
            return None;
        };
        if scope.frame.is_some() || self.depth + NESTING > self.sources.limits.nesting {
            return None;
        }
        let coefficient = Real::from(self.numeral(number)?);
        let power = match &power.kind {
            ExprKind::Power(base, exponent) => {
                let exponent = self.numeral(exponent)?.to_i64()?;
                let limit = u64::from(self.sources.limits.exponent);
                let fits = exponent.unsigned_abs() <= limit;
                fits.then(|| Some(Scalar::power(power.span, parameter(base, scope)?, exponent)))??
            }
            _ => parameter(power, scope)?,
        };
        let coefficient = Scalar::constant(number.span, coefficient);
        Some(Scalar::product(expr.span, vec![coefficient, power]))
    }
}

/// u or v, where it may be used.
fn parameter(expr: &Expr, scope: &Scope<'_>) -> Option<Scalar> {
    let ExprKind::Reference(Reference {
        qualifier: None,
        name,
        primes: 0,
        ..
    }) = &expr.kind
    else {
        return None;
    };
    let parameter: Parameter = parameter_of(&name.text)?;
    let allowed = scope.allows(parameter);
    allowed.then(|| Scalar::new(name.span, Form::Parameter(parameter)))
}
