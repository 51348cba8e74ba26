use crate::number::{Field, Rational, Real};
use crate::syntax::ast::{Expr, ExprKind, ProductOp, Sign};

use super::lowerer::Lowerer;

/// How many parentheses and signs a numeral may have around it.
const NESTING: usize = 4;

impl Lowerer<'_> {
    /// The number that `7`, `-0.5` or `(3/4)` is: numerals with a sign or one stroke between them.
    /// None for all else, and for what a finding is to be reported of.
    pub(super) fn numeral(&self, expr: &Expr) -> Option<Rational> {
        let limits = self.sources.limits;
        let left = limits.nesting.saturating_sub(self.depth);
        nested(expr, limits.exponent, left.min(NESTING))
    }

    /// The point whose two or three coordinates are numerals, none of them too long.
    pub(super) fn numeral_point(&self, expr: &Expr) -> Option<Vec<Real>> {
        let limits = self.sources.limits;
        let left = limits.nesting.saturating_sub(self.depth).checked_sub(1)?;
        let ExprKind::Tuple(entries) = &expr.kind else {
            return None;
        };
        let coordinate = |own| {
            let number = nested(own, limits.exponent, left.min(NESTING)).map(Real::from);
            number.filter(|own| own.bits() <= limits.bits)
        };
        let is_point = matches!(entries.len(), 2 | 3);
        is_point.then(|| entries.iter().map(coordinate).collect())?
    }
}

fn nested(expr: &Expr, limit: u32, depth: usize) -> Option<Rational> {
    let inner = |expr: &Expr| nested(expr, limit, depth.checked_sub(1)?);
    match &expr.kind {
        ExprKind::Number(text) => Rational::from_literal(text, limit),
        ExprKind::Group(own) => inner(own),
        ExprKind::Negate(own) => Some(inner(own)?.negated()),
        ExprKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, only)] => Some(inner(only)?.negated()),
            _ => None,
        },
        ExprKind::Product(factors) => match factors.as_slice() {
            [(_, above), (ProductOp::Divide, below)] => {
                let (above, below) = (inner(above)?, inner(below)?);
                let nonzero = !below.is_zero();
                nonzero.then(|| {
                    let numerator = above.numerator() * below.denominator();
                    Rational::new(numerator, above.denominator() * below.numerator())
                })
            }
            _ => None,
        },
        _ => None,
    }
}
