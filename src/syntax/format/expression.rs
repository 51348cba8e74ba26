use crate::syntax::ast::{Argument, Expr, ExprKind, ProductOp, Sign};
use crate::syntax::lexer::TokenKind;

use super::INDENT;
use super::doc::Doc;
use super::tokens::Tokens;

impl Tokens<'_> {
    /// What stands behind the `=` of a declaration.
    pub(super) fn value(&mut self, expr: &Expr) -> Doc {
        let hugs = is_bracketed(expr) || matches!(expr.kind, ExprKind::Apply { .. });
        Doc::value(hugs, self.alone(expr))
    }

    /// An expression on lines of its own: further terms begin where the first one does.
    fn alone(&mut self, expr: &Expr) -> Doc {
        match &expr.kind {
            ExprKind::Sum(terms) => {
                let terms = self.sum(terms);
                Doc::group(terms)
            }
            _ => self.expression(expr),
        }
    }

    /// The layout of an expression.
    pub(super) fn expression(&mut self, expr: &Expr) -> Doc {
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Text(_) => self.token(),
            ExprKind::Sum(terms) => {
                let terms = self.sum(terms);
                Doc::group(Doc::nest(INDENT, terms))
            }
            ExprKind::Product(factors) => {
                let factors = self.product(factors);
                Doc::group(Doc::nest(INDENT, factors))
            }
            ExprKind::Negate(inner) => Doc::concat(vec![self.token(), self.expression(inner)]),
            ExprKind::Power(base, exponent) => {
                let parts = vec![
                    self.expression(base),
                    self.token(),
                    self.expression(exponent),
                ];
                Doc::concat(parts)
            }
            ExprKind::Reference(reference) => self.reference(reference.qualifier.is_some()),
            ExprKind::Apply {
                function,
                arguments,
                ..
            } => {
                let mut parts = vec![self.reference(function.qualifier.is_some())];
                if self.is_apart(function) {
                    parts.push(Doc::space());
                }
                parts.push(self.arguments(arguments));
                Doc::concat(parts)
            }
            ExprKind::Component(base, _) => {
                let mut parts = vec![self.expression(base)];
                if let ExprKind::Number(_) = base.kind {
                    // `2.x` would be half a number
                    parts.push(Doc::space());
                }
                parts.extend([self.token(), self.token()]);
                Doc::concat(parts)
            }
            ExprKind::Tuple(entries) | ExprKind::List(entries) => self
                .bracketed(entries.len(), |tokens, place| {
                    tokens.expression(&entries[place])
                }),
            ExprKind::Group(inner) => self.bracketed(1, |tokens, _| tokens.alone(inner)),
        }
    }

    /// Terms; a line ends before a sign.
    fn sum(&mut self, terms: &[(Sign, Expr)]) -> Doc {
        let mut parts = Vec::new();
        for (place, (sign, term)) in terms.iter().enumerate() {
            if place > 0 {
                let own = vec![Doc::line(), self.token(), Doc::space()];
                let own = own.into_iter().chain([self.expression(term)]);
                parts.push(Doc::group(Doc::concat(own.collect())));
                continue;
            }
            if *sign == Sign::Minus {
                parts.push(self.token());
            }
            parts.push(self.expression(term));
        }
        Doc::concat(parts)
    }

    /// Factors; a line ends before a sign or between neighbours.
    fn product(&mut self, factors: &[(ProductOp, Expr)]) -> Doc {
        let mut parts = Vec::new();
        for (place, (op, factor)) in factors.iter().enumerate() {
            let before = place.checked_sub(1).map(|before| &factors[before]);
            let Some(before) = before else {
                parts.push(self.expression(factor));
                continue;
            };
            let tight = self.is_tight(before, *op, factor);
            let mut own = Vec::new();
            if !tight {
                own.push(Doc::line());
            }
            match op {
                ProductOp::Times if self.kind() != TokenKind::Star => own.push(Doc::added("*")),
                ProductOp::Times | ProductOp::Divide => own.push(self.token()),
                ProductOp::Juxtapose => {}
            }
            if !tight && *op != ProductOp::Juxtapose {
                own.push(Doc::space());
            }
            own.push(self.expression(factor));
            parts.push(Doc::group(Doc::concat(own)));
        }
        Doc::concat(parts)
    }

    /// Whether nothing stands between two factors but their sign: `1/2`, `2u`, `3v^2`.
    fn is_tight(&self, before: &(ProductOp, Expr), op: ProductOp, factor: &Expr) -> bool {
        let (ProductOp::Times, ExprKind::Number(digits)) = (before.0, &unsigned(&before.1).kind)
        else {
            return false;
        };
        match op {
            ProductOp::Times => false,
            ProductOp::Divide => matches!(unsigned(factor).kind, ExprKind::Number(_)),
            ProductOp::Juxtapose => {
                let base = match &factor.kind {
                    ExprKind::Power(base, _) => base,
                    _ => factor,
                };
                let ExprKind::Reference(reference) = &base.kind else {
                    return false;
                };
                let plain = reference.qualifier.is_none() && reference.primes == 0;
                let name = self.spelled();
                // `2e` is too near to a number
                let letter = name.chars().count() == 1 && !matches!(name.as_str(), "e" | "E" | "_");
                plain && letter && !digits.contains('e')
            }
        }
    }

    /// `c.σ'`
    fn reference(&mut self, is_qualified: bool) -> Doc {
        let mut parts = vec![self.token()];
        if is_qualified {
            parts.extend([self.token(), self.token()]);
        }
        while matches!(self.kind(), TokenKind::Prime | TokenKind::DoublePrime) {
            parts.push(self.token());
        }
        Doc::concat(parts)
    }

    /// `(start: P, preimage: [P, …])`; a single bracket opens and closes with its parenthesis.
    fn arguments(&mut self, arguments: &[Argument]) -> Doc {
        if let [only] = arguments
            && only.label.is_none()
            && is_bracketed(&only.value)
        {
            let parts = vec![self.token(), self.expression(&only.value), self.token()];
            return Doc::concat(parts);
        }
        let only = arguments.len() == 1;
        self.bracketed(arguments.len(), |tokens, place| {
            let Argument { label, value } = &arguments[place];
            if label.is_some() {
                let mut parts = vec![tokens.token(), tokens.token(), Doc::space()];
                parts.push(tokens.expression(value));
                return Doc::concat(parts);
            }
            if only {
                tokens.alone(value)
            } else {
                tokens.expression(value)
            }
        })
    }

    /// Entries in brackets: on one line, or moved in on as few lines as they need.
    fn bracketed(&mut self, count: usize, mut entry: impl FnMut(&mut Self, usize) -> Doc) -> Doc {
        let open = self.token();
        let mut entries = vec![Doc::seam()];
        for place in 0..count {
            let mut own = Vec::new();
            if place > 0 {
                own.push(Doc::line());
            }
            own.push(Doc::group(entry(self, place)));
            if place + 1 < count {
                own.push(self.token());
            }
            entries.push(Doc::group(Doc::concat(own)));
        }
        if count == 0 {
            entries.clear();
        }
        let inside = Doc::nest(INDENT, Doc::concat(entries));
        Doc::group(Doc::concat(vec![open, inside, self.token()]))
    }
}

/// Whether an expression is a pair of brackets.
fn is_bracketed(expr: &Expr) -> bool {
    use ExprKind::{Group, List, Tuple};
    matches!(expr.kind, Group(_) | List(_) | Tuple(_))
}

/// What stands behind the signs.
fn unsigned(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Negate(inner) => unsigned(inner),
        _ => expr,
    }
}
