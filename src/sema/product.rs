use crate::diag::{Code, Span};
use crate::number::Real;
use crate::sweep::Scalar;
use crate::syntax::ast::{Argument, Expr, ExprKind, Name, ProductOp, Reference};

use super::lowerer::{Lowered, Lowerer};
use super::scope::Scope;
use super::value::Value;

/// A factor of a product, after `NAME (…)` has been decided.
enum Part<'a> {
    /// An expression as it stands.
    Expr(&'a Expr),
    /// The name of `NAME (…)` where that is a product.
    Name(&'a Reference),
    /// The parenthesis of `NAME (…)` where that is a product, with the powers and components
    /// that are written behind it.
    Rest(&'a Expr),
    /// The sign of `-NAME (…)` where that is a product: it belongs to the name.
    Sign(Span),
}

/// One factor on its own.
pub(super) fn one(expr: &Expr) -> Factors<'_> {
    Factors::One(expr)
}

/// The factors of a product.
#[derive(Clone, Copy)]
pub(super) enum Factors<'a> {
    One(&'a Expr),
    Many(&'a [(ProductOp, Expr)]),
}

impl<'a> From<&'a Vec<(ProductOp, Expr)>> for Factors<'a> {
    fn from(factors: &'a Vec<(ProductOp, Expr)>) -> Self {
        Self::Many(factors)
    }
}

/// The `NAME (…)` at the start of a factor such as `u (1 - v)^2`, below powers and components.
pub(super) fn split(expr: &Expr) -> Option<(&Reference, &[Argument])> {
    match &expr.kind {
        ExprKind::Apply {
            function,
            arguments,
            ..
        } => Some((function, arguments)),
        ExprKind::Power(base, _) => split(base),
        ExprKind::Component(base, _) => split(base),
        _ => None,
    }
}

impl<'a> Lowerer<'a> {
    /// Whether the `NAME (…)` at the start of a factor is an application.
    pub(super) fn is_application(&self, expr: &Expr, scope: &Scope<'a>) -> bool {
        split(expr).is_none_or(|(function, _)| self.applies(function, scope))
    }

    /// The product of factors, from the left.
    pub(super) fn product(
        &mut self,
        span: Span,
        factors: impl Into<Factors<'a>>,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let mut parts = Vec::new();
        match factors.into() {
            Factors::One(expr) => self.push_parts(ProductOp::Times, expr, scope, &mut parts),
            Factors::Many(factors) => {
                for (op, expr) in factors {
                    self.push_parts(*op, expr, scope, &mut parts);
                }
            }
        }
        let mut product = Product::new(scope.site(span));
        let mut failed = None;
        for (op, part) in parts {
            let (value, at) = match part {
                Part::Expr(expr) => (self.value(expr, scope), expr.span),
                Part::Name(reference) => (self.reference(reference, scope), reference.span),
                Part::Rest(expr) => (self.rest(expr, scope), expr.span),
                Part::Sign(span) => {
                    let minus = Scalar::constant(scope.site(span), Real::from(-1));
                    (Ok(Value::Scalar(minus)), span)
                }
            };
            let joined = value.and_then(|value| self.join(&mut product, op, value, at, scope));
            product.reach = Some(product.reach.map_or(at, |reach| reach.to(at)));
            if let Err(reported) = joined {
                failed = Some(reported);
            }
        }
        match failed {
            Some(reported) => Err(reported),
            None => Ok(product.finish()),
        }
    }

    /// Whether a factor, after its signs, begins with a `NAME (…)` that is a product.
    fn leads_product(&self, expr: &Expr, scope: &Scope<'a>) -> bool {
        match &expr.kind {
            ExprKind::Negate(inner) => self.leads_product(inner, scope),
            _ => !self.is_application(expr, scope),
        }
    }

    fn push_parts(
        &self,
        op: ProductOp,
        expr: &'a Expr,
        scope: &Scope<'a>,
        parts: &mut Vec<(ProductOp, Part<'a>)>,
    ) {
        if let ExprKind::Negate(inner) = &expr.kind
            && self.leads_product(inner, scope)
        {
            parts.push((ProductOp::Times, Part::Sign(expr.span)));
            return self.push_parts(op, inner, scope, parts);
        }
        match split(expr) {
            Some((function, _)) if !self.applies(function, scope) => {
                parts.push((op, Part::Name(function)));
                parts.push((ProductOp::Juxtapose, Part::Rest(expr)));
            }
            _ => parts.push((op, Part::Expr(expr))),
        }
    }

    /// What stands behind the name in `NAME (…)^2` where that is a product.
    fn rest(&mut self, expr: &'a Expr, scope: &Scope<'a>) -> Lowered<Value> {
        match &expr.kind {
            ExprKind::Power(base, exponent) => {
                let value = self.rest(base, scope)?;
                self.power_of(expr.span, base.span, value, exponent, scope)
            }
            ExprKind::Component(base, name) => {
                let base = self.rest(base, scope)?;
                self.component(&base, name, scope)
            }
            ExprKind::Apply {
                arguments,
                parenthesis,
                ..
            } => self.parenthesis(arguments, *parenthesis, scope),
            _ => self.value(expr, scope),
        }
    }

    /// `(a)`, `(a, b)` or `(a, b, c)` where the parser saw arguments.
    fn parenthesis(
        &mut self,
        arguments: &'a [Argument],
        span: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        if let Some(label) = arguments.iter().find_map(|own| own.label.as_ref()) {
            let finding = self.finding(
                scope,
                Code::E0107,
                label.span,
                "a label has no place in a product",
            );
            return Err(self.report(finding));
        }
        if let [only] = arguments {
            return self.value(&only.value, scope);
        }
        let values = arguments
            .iter()
            .map(|own| self.scalar(&own.value, scope))
            .collect::<Lowered<Vec<Scalar>>>()?;
        self.tuple_of(span, values, scope)
    }

    fn join(
        &mut self,
        product: &mut Product,
        op: ProductOp,
        value: Value,
        span: Span,
        scope: &Scope<'a>,
    ) -> Lowered<()> {
        let quotient = product.reach.map_or(span, |reach| reach.to(span));
        let value = match (op, value) {
            (ProductOp::Divide, Value::Scalar(own)) => {
                if own.as_number().is_some_and(crate::number::Field::is_zero) {
                    let mut finding = self.finding(scope, Code::E0207, span, "division by zero");
                    finding = finding.label("this is zero");
                    if scope.frame.is_none() {
                        finding = finding.related(quotient, "in this quotient");
                    }
                    return Err(self.report(finding));
                }
                Value::Scalar(Scalar::power(scope.site(quotient), own, -1))
            }
            (ProductOp::Divide, other) => {
                let message = format!("one cannot divide by {}", other.type_name());
                let finding = self.finding(scope, Code::E0106, span, message);
                return Err(self.report(finding));
            }
            (_, value) => value,
        };
        match product.times(value) {
            Ok(()) => Ok(()),
            Err((left, right)) => {
                let message = format!("{left} is multiplied by {right}");
                let finding = self
                    .finding(scope, Code::E0106, span, message)
                    .label(format!("this is {right}"));
                let finding = if left == "a vector" && right == "a vector" {
                    finding.help("write `dot(a, b)` or `cross(a, b)`")
                } else {
                    finding
                };
                Err(self.report(finding))
            }
        }
    }

    /// The unknown or ambiguous name in front of a parenthesis is not a product.
    pub(super) fn names_constant(&self, name: &Name) -> bool {
        use super::definition::DefinitionForm;
        let definition = self.definitions.get(&name.text);
        definition.is_some_and(|own| matches!(own.form, DefinitionForm::Constant { .. }))
    }
}

/// A product under way: scalars, and at most one factor of another type.
struct Product {
    span: Span,
    /// Where its factors so far stand.
    reach: Option<Span>,
    scalars: Vec<Scalar>,
    other: Option<Value>,
}

impl Product {
    fn new(span: Span) -> Self {
        Self {
            span,
            reach: None,
            scalars: Vec::new(),
            other: None,
        }
    }

    /// Multiplies by a value from the right, or names the two types that do not multiply.
    fn times(&mut self, value: Value) -> Result<(), (&'static str, &'static str)> {
        match (self.other.take(), value) {
            (other, Value::Scalar(own)) => {
                self.scalars.push(own);
                self.other = other;
            }
            (None, value) => self.other = Some(value),
            (Some(Value::Matrix(columns)), Value::Vector(vector)) => {
                self.other = Some(Value::Vector(matrix_times(self.span, &columns, &vector)));
            }
            (Some(other), value) => {
                let names = (other.type_name(), value.type_name());
                self.other = Some(other);
                return Err(names);
            }
        }
        Ok(())
    }

    fn finish(self) -> Value {
        let span = self.span;
        match self.other {
            None => Value::Scalar(Scalar::product(span, self.scalars)),
            Some(other) if self.scalars.is_empty() => other,
            Some(other) => {
                let factor = Scalar::product(span, self.scalars);
                other.map(|own| Scalar::product(span, vec![factor.clone(), own.clone()]))
            }
        }
    }
}

fn matrix_times(span: Span, columns: &[[Scalar; 3]; 3], vector: &[Scalar; 3]) -> [Scalar; 3] {
    [0, 1, 2].map(|row| {
        let terms = columns.iter().zip(vector);
        let terms = terms
            .map(|(column, own)| Scalar::product(span, vec![column[row].clone(), own.clone()]));
        Scalar::sum(span, terms.collect())
    })
}
