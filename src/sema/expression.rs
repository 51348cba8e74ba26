use crate::curve::Axis;
use crate::diag::{Code, Diagnostic, Span};
use crate::number::{Field, Rational, Real};
use crate::sweep::{Domain, Expander, Scalar};
use crate::syntax::ast::{Expr, ExprKind, Name, Sign};

use super::lowerer::{Lowered, Lowerer};
use super::scope::Scope;
use super::value::Value;

/// How deep expressions may nest once their definitions are put in: the stack is made for it.
const DEEPEST: usize = 4_096;

impl<'a> Lowerer<'a> {
    /// The value of an expression where it stands.
    pub(super) fn value(&mut self, expr: &'a Expr, scope: &Scope<'a>) -> Lowered<Value> {
        let value = self.descend(scope, expr.span, |own| own.value_of_kind(expr, scope))?;
        if value.depth() <= DEEPEST {
            return Ok(value);
        }
        let message = format!("definitions nest this expression more than {DEEPEST} levels deep");
        let finding = self.finding(scope, Code::E0502, expr.span, message);
        Err(self.report(finding.help(
            "no flag raises this limit: build the expression in fewer steps that stand on one another",
        )))
    }

    fn value_of_kind(&mut self, expr: &'a Expr, scope: &Scope<'a>) -> Lowered<Value> {
        match &expr.kind {
            ExprKind::Number(text) => self.literal(text, expr.span, scope),
            ExprKind::Text(_) => {
                let finding = self.finding(scope, Code::E0106, expr.span, "a string is no value");
                Err(self.report(finding.help("strings name files and branches")))
            }
            ExprKind::Sum(terms) => match self.polynomial(expr, terms, scope) {
                Some(own) => Ok(Value::Scalar(own)),
                None => self.sum(expr, terms, scope),
            },
            ExprKind::Product(factors) => {
                let constant = |own| Scalar::constant(scope.site(expr.span), Real::from(own));
                match self.numeral(expr).map(constant) {
                    Some(own) => Ok(Value::Scalar(own)),
                    None => self.product(expr.span, factors, scope),
                }
            }
            ExprKind::Negate(inner) => {
                let inner = self.value(inner, scope)?;
                let site = scope.site(expr.span);
                Ok(inner.map(|own| Scalar::negated(site, own)))
            }
            ExprKind::Power(base, exponent) => match super::product::split(base) {
                Some(_) if !self.is_application(base, scope) => {
                    self.product(expr.span, super::product::one(expr), scope)
                }
                _ => self.power(expr.span, base, exponent, scope),
            },
            ExprKind::Reference(reference) => self.reference(reference, scope),
            ExprKind::Apply {
                function,
                arguments,
                parenthesis,
            } => {
                if self.applies(function, scope) {
                    self.apply(expr.span, function, arguments, *parenthesis, scope)
                } else {
                    self.product(expr.span, super::product::one(expr), scope)
                }
            }
            ExprKind::Component(base, name) => {
                if super::product::split(base).is_some() && !self.is_application(base, scope) {
                    return self.product(expr.span, super::product::one(expr), scope);
                }
                let base = self.value(base, scope)?;
                self.component(&base, name, scope)
            }
            ExprKind::Tuple(entries) => self.tuple(expr.span, entries, scope),
            ExprKind::List(_) => {
                let finding = self.finding(scope, Code::E0106, expr.span, "a list is no value");
                Err(self.report(
                    finding.help("lists are arguments of `bezier` and other curve constructors"),
                ))
            }
            ExprKind::Group(inner) => self.value(inner, scope),
        }
    }

    /// The scalar that an expression is.
    pub(super) fn scalar(&mut self, expr: &'a Expr, scope: &Scope<'a>) -> Lowered<Scalar> {
        match self.value(expr, scope)? {
            Value::Scalar(own) => Ok(own),
            other => {
                let message = format!("a scalar is needed here, this is {}", other.type_name());
                let finding = self.finding(scope, Code::E0106, expr.span, message);
                Err(self.report(finding))
            }
        }
    }

    /// The vector that an expression is.
    pub(super) fn vector(&mut self, expr: &'a Expr, scope: &Scope<'a>) -> Lowered<[Scalar; 3]> {
        match self.value(expr, scope)? {
            Value::Vector(own) => Ok(own),
            other => {
                let message = format!("a vector is needed here, this is {}", other.type_name());
                let finding = self.finding(scope, Code::E0106, expr.span, message);
                Err(self.report(finding))
            }
        }
    }

    /// The number that a scalar is.
    pub(super) fn number(&mut self, scalar: &Scalar, scope: &Scope<'_>) -> Lowered<Real> {
        if let Some(number) = scalar.as_number() {
            return Ok(number.clone());
        }
        let domain = Domain::unit();
        let limits = self.sources.limits;
        match Expander::new(&domain, &self.tower, limits).constant(scalar) {
            Ok(Some(number)) => Ok(number),
            Ok(None) => {
                let finding = self.finding(
                    scope,
                    Code::E0108,
                    scalar.span(),
                    "a constant is needed here",
                );
                Err(self.report(finding.label("this depends on u or v")))
            }
            Err(finding) => Err(self.report(*finding)),
        }
    }

    fn literal(&mut self, text: &str, span: Span, scope: &Scope<'_>) -> Lowered<Value> {
        let limit = self.sources.limits.exponent;
        match Rational::from_literal(text, limit) {
            Some(number) => Ok(Value::Scalar(Scalar::constant(
                scope.site(span),
                Real::from(number),
            ))),
            None => {
                let message = format!("the exponent of this number exceeds {limit}");
                let finding = self.finding(scope, Code::E0504, span, message);
                Err(self.report(finding.help("raise the limit with `--max-exponent`")))
            }
        }
    }

    fn sum(
        &mut self,
        expr: &'a Expr,
        terms: &'a [(Sign, Expr)],
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let mut values = Vec::with_capacity(terms.len());
        let mut failed = None;
        for (sign, term) in terms {
            match self.value(term, scope) {
                Ok(value) => values.push(match sign {
                    Sign::Plus => value,
                    Sign::Minus => {
                        let site = scope.site(term.span);
                        value.map(|own| Scalar::negated(site, own))
                    }
                }),
                Err(reported) => failed = Some(reported),
            }
        }
        if let Some(reported) = failed {
            return Err(reported);
        }
        if let Some(sum) = Value::sum(scope.site(expr.span), &values) {
            return Ok(sum);
        }
        let first = &values[0];
        let differs = |own: &Value| std::mem::discriminant(own) != std::mem::discriminant(first);
        let index = values.iter().position(differs).unwrap_or(0);
        let (kind, other) = (first.type_name(), values[index].type_name());
        let (start, at) = (terms[0].1.span, terms[index].1.span);
        let message = if index == 0 {
            "matrices are not added".to_owned()
        } else {
            format!("{other} is added to {kind}")
        };
        let finding = self
            .finding(scope, Code::E0106, at, message)
            .label(format!("this is {other}"));
        let finding = if index == 0 || scope.frame.is_some() {
            finding
        } else {
            finding.related(start, format!("this is {kind}"))
        };
        Err(self.report(finding))
    }

    pub(super) fn power(
        &mut self,
        span: Span,
        base: &'a Expr,
        exponent: &'a Expr,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let value = self.value(base, scope)?;
        self.power_of(span, base.span, value, exponent, scope)
    }

    pub(super) fn power_of(
        &mut self,
        span: Span,
        at: Span,
        value: Value,
        exponent: &'a Expr,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let exponent = self.exponent(exponent, (span, at), scope)?;
        let Value::Scalar(base_scalar) = value else {
            let message = format!("only a scalar has powers, this is {}", value.type_name());
            let finding = self.finding(scope, Code::E0106, at, message);
            return Err(self.report(finding.help("the square of a vector is `norm2(…)`")));
        };
        if let Some(number) = base_scalar.as_number() {
            let limit = self.sources.limits.bits;
            if number.is_zero() && exponent < 0 {
                let finding = self.finding(scope, Code::E0207, span, "division by zero");
                return Err(self.report(finding.label("zero to a negative power")));
            }
            if number.bits().saturating_mul(exponent.unsigned_abs()) > limit {
                let finding = self.finding(
                    scope,
                    Code::E0507,
                    span,
                    format!("this number has more than {limit} bits"),
                );
                return Err(self.report(finding.help("raise the limit with `--max-bits`")));
            }
        }
        Ok(Value::Scalar(Scalar::power(
            scope.site(span),
            base_scalar,
            exponent,
        )))
    }

    /// The exponent of the power at the first place, whose base stands at the second.
    fn exponent(
        &mut self,
        expr: &'a Expr,
        (power, base): (Span, Span),
        scope: &Scope<'a>,
    ) -> Lowered<i64> {
        let limit = self.sources.limits.exponent;
        let number = match self.numeral(expr) {
            Some(number) => Real::from(number),
            None => {
                let scalar = self.scalar(expr, scope)?;
                self.number(&scalar, scope)?
            }
        };
        match number.to_i64() {
            Some(exponent) if exponent.unsigned_abs() <= u64::from(limit) => Ok(exponent),
            None if !number.is_integer() => {
                let message = format!("the exponent {number} is not an integer");
                let finding = self.finding(scope, Code::E0009, expr.span, message);
                let finding = finding.help("write `sqrt(…)` for a square root");
                let twice = number.times(&Real::from(2));
                if twice != Real::one() || power.start != base.start {
                    return Err(self.report(finding));
                }
                let base = self.sources.map.slice(base);
                let inner = base.strip_prefix('(').and_then(|own| own.strip_suffix(')'));
                let inner = inner
                    .filter(|own| !own.contains(['(', ')']))
                    .unwrap_or(base);
                Err(self.report(finding.fix(power, format!("sqrt({inner})"))))
            }
            _ => {
                let finding = self.finding(
                    scope,
                    Code::E0504,
                    expr.span,
                    format!("this exponent exceeds {limit}"),
                );
                Err(self.report(finding.help("raise the limit with `--max-exponent`")))
            }
        }
    }

    fn tuple(&mut self, span: Span, entries: &'a [Expr], scope: &Scope<'a>) -> Lowered<Value> {
        let values = entries
            .iter()
            .map(|entry| self.scalar(entry, scope))
            .collect::<Vec<_>>()
            .into_iter()
            .collect::<Lowered<Vec<Scalar>>>()?;
        if values.len() > 3 {
            let finding = self.entry_count(span, values.len(), scope);
            return Err(self.report(self.with_decimal_points(finding, entries)));
        }
        self.tuple_of(span, values, scope)
    }

    /// E0106.
    fn entry_count(&self, span: Span, count: usize, scope: &Scope<'_>) -> Diagnostic {
        let message = format!("{count} entries: a pair has two, a vector three");
        self.finding(scope, Code::E0106, span, message)
    }

    pub(super) fn tuple_of(
        &mut self,
        span: Span,
        values: Vec<Scalar>,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        match <[Scalar; 3]>::try_from(values) {
            Ok(vector) => Ok(Value::Vector(vector)),
            Err(values) => match <[Scalar; 2]>::try_from(values) {
                Ok(pair) => Ok(Value::Pair(pair)),
                Err(values) => Err(self.report(self.entry_count(span, values.len(), scope))),
            },
        }
    }

    /// `a.x` of a value.
    pub(super) fn component(
        &mut self,
        base: &Value,
        name: &Name,
        scope: &Scope<'_>,
    ) -> Lowered<Value> {
        let index = match name.text.as_str() {
            "x" => Some(Axis::X),
            "y" => Some(Axis::Y),
            "z" => Some(Axis::Z),
            _ => None,
        };
        let components = base.components();
        match index.and_then(|axis| components.get(axis.index())) {
            Some(own) if matches!(base, Value::Pair(_) | Value::Vector(_)) => {
                Ok(Value::Scalar(own.clone()))
            }
            _ => {
                let message = format!("{} has no component `{}`", base.type_name(), name.text);
                let finding = self.finding(scope, Code::E0111, name.span, message);
                Err(self
                    .report(finding.help("a vector has the components x, y and z, a pair x and y")))
            }
        }
    }
}
