use std::rc::Rc;

use crate::curve::{Axis, Parameter};
use crate::diag::{Code, Span};
use crate::sweep::{Domain, Form, Scalar, Vector};
use crate::syntax::ast::{Argument, Expr, ExprKind, Name, Reference};

use super::lowerer::{Lowered, Lowerer, Meaning, Reported};
use super::scope::Scope;
use super::value::Value;

/// The functions that the language has of its own. A declared name hides them.
pub const BUILT_IN: [&str; 12] = [
    "cross", "dot", "du", "dv", "end", "length", "matrix", "norm2", "normal", "offset", "sqrt",
    "start",
];

impl<'a> Lowerer<'a> {
    /// A built-in function at its arguments.
    pub(super) fn call_built_in(
        &mut self,
        span: Span,
        name: &'a Name,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let count = match name.text.as_str() {
            "cross" | "dot" | "offset" => 2,
            "matrix" => 3,
            _ => 1,
        };
        self.check_arguments(name, count, arguments, parenthesis, scope)?;
        let first = &arguments[0].value;
        let site = scope.site(span);
        match name.text.as_str() {
            "cross" => {
                let (a, b) = (
                    self.vector(first, scope)?,
                    self.vector(&arguments[1].value, scope)?,
                );
                Ok(Value::Vector(cross(site, &a, &b)))
            }
            "dot" => {
                let (a, b) = (
                    self.value(first, scope)?,
                    self.value(&arguments[1].value, scope)?,
                );
                self.dot(span, &a, &b, scope)
            }
            "norm2" => {
                let a = self.value(first, scope)?;
                self.dot(span, &a, &a, scope)
            }
            "matrix" => {
                let mut column = |index: usize| self.vector(&arguments[index].value, scope);
                let columns = [column(0)?, column(1)?, column(2)?];
                Ok(Value::Matrix(Box::new(columns)))
            }
            "du" => self.partial(Parameter::U, span, first, scope),
            "dv" => self.partial(Parameter::V, span, first, scope),
            "sqrt" => self.square_root(span, first, scope),
            "normal" => {
                let (surface, domain) = self.surface_argument(name, first, scope)?;
                Ok(Value::Vector(normal(site, &surface, domain.as_ref())))
            }
            "offset" => self.offset(span, name, arguments, scope),
            _ => self.curve_constant(span, name, first, scope),
        }
    }

    fn dot(&mut self, span: Span, a: &Value, b: &Value, scope: &Scope<'_>) -> Lowered<Value> {
        let (left, right) = (a.components(), b.components());
        let vectors = matches!(
            (a, b),
            (Value::Vector(_), Value::Vector(_)) | (Value::Pair(_), Value::Pair(_))
        );
        if !vectors {
            let message = format!(
                "the scalar product of {} and {}",
                a.type_name(),
                b.type_name()
            );
            let finding = self.finding(scope, Code::E0106, span, message);
            return Err(self.report(finding.help("both must be vectors, or both pairs")));
        }
        let site = scope.site(span);
        let terms = left
            .iter()
            .zip(&right)
            .map(|(l, r)| Scalar::product(site, vec![l.clone(), r.clone()]));
        Ok(Value::Scalar(Scalar::sum(site, terms.collect())))
    }

    fn partial(
        &mut self,
        parameter: Parameter,
        span: Span,
        of: &'a Expr,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let site = scope.site(span);
        let value = self.value(of, scope)?;
        Ok(value.map(|own| Scalar::new(site, Form::Partial(parameter, own.clone()))))
    }

    /// `sqrt(E)`: of a number at once, else where the surface is expanded.
    fn square_root(&mut self, span: Span, of: &'a Expr, scope: &Scope<'a>) -> Lowered<Value> {
        let scalar = self.scalar(of, scope)?;
        let root = Scalar::new(scope.site(span), Form::SquareRoot(scalar.clone()));
        if scalar.depends_on(Parameter::U) || scalar.depends_on(Parameter::V) {
            return Ok(Value::Scalar(root));
        }
        let number = self.number(&root, scope)?;
        Ok(Value::Scalar(Scalar::constant(scope.site(span), number)))
    }

    /// `length(c)`, `start(c)`, `end(c)`
    fn curve_constant(
        &mut self,
        span: Span,
        name: &Name,
        of: &'a Expr,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let curve = match &of.kind {
            ExprKind::Reference(Reference {
                qualifier: None,
                name,
                primes: 0,
                ..
            }) => {
                if scope.binding(&name.text).is_none() && !self.definitions.contains(&name.text) {
                    return Err(self.report_unknown(name, scope));
                }
                let known = self.curve_named(name, scope);
                if known.is_err()
                    && matches!(self.meanings.get(name.text.as_str()), Some(Meaning::Failed))
                {
                    return Err(Reported);
                }
                known.ok()
            }
            _ => None,
        };
        let Some(curve) = curve else {
            let message = format!("`{}` is a constant of a curve", name.text);
            let finding = self.finding(scope, Code::E0107, of.span, message);
            return Err(self
                .report(finding.help(format!("give it the name of a curve: `{}(c)`", name.text))));
        };
        let value = match name.text.as_str() {
            "start" => curve.domain().start().clone(),
            "end" => curve.domain().end().clone(),
            _ => match curve.length() {
                Ok(length) => length,
                Err(fault) => {
                    let mut finding =
                        self.finding(scope, fault.code(), span, fault.message(curve.name()));
                    finding
                        .notes
                        .extend(fault.evidence(curve.name(), curve.parameter()));
                    return Err(self.report(finding));
                }
            },
        };
        Ok(Value::Scalar(Scalar::constant(scope.site(span), value)))
    }

    /// R + r N
    fn offset(
        &mut self,
        span: Span,
        name: &Name,
        arguments: &'a [Argument],
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let (surface, domain) = self.surface_argument(name, &arguments[0].value, scope)?;
        let distance = self.scalar(&arguments[1].value, scope)?;
        if distance.depends_on(Parameter::U) || distance.depends_on(Parameter::V) {
            let finding = self.finding(
                scope,
                Code::E0108,
                arguments[1].value.span,
                "an offset has a constant distance",
            );
            return Err(self.report(finding));
        }
        let site = scope.site(span);
        let normal = normal(site, &surface, domain.as_ref());
        let moved = |index: usize| {
            let shift = Scalar::product(site, vec![distance.clone(), normal[index].clone()]);
            Scalar::sum(site, vec![surface[index].clone(), shift])
        };
        Ok(Value::Vector([moved(0), moved(1), moved(2)]))
    }

    /// A surface by its name, with its domain, or any vector expression.
    fn surface_argument(
        &mut self,
        function: &Name,
        of: &'a Expr,
        scope: &Scope<'a>,
    ) -> Lowered<(Vector, Option<Rc<Domain>>)> {
        if let ExprKind::Reference(Reference {
            qualifier: None,
            name,
            primes: 0,
            ..
        }) = &of.kind
            && self.is_surface(name)
        {
            self.mentioned.push(name.text.clone());
            let surface = self.surface(name)?;
            return Ok((surface.function(), Some(Rc::new(surface.domain.clone()))));
        }
        match self.value(of, scope)? {
            Value::Vector(vector) => Ok((vector, None)),
            other => {
                let message = format!(
                    "`{}` applies to a surface, this is {}",
                    function.text,
                    other.type_name()
                );
                let finding = self.finding(scope, Code::E0106, of.span, message);
                Err(self.report(finding))
            }
        }
    }
}

fn cross(span: Span, a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| {
        let left = Scalar::product(span, vec![a[i].clone(), b[j].clone()]);
        let right = Scalar::product(span, vec![a[j].clone(), b[i].clone()]);
        Scalar::sum(span, vec![left, Scalar::negated(span, &right)])
    })
}

/// The unit normal of a surface; that of a named one keeps the sign that it has on its domain.
fn normal(span: Span, surface: &Vector, domain: Option<&Rc<Domain>>) -> Vector {
    let shared = Rc::new(surface.clone());
    Axis::ALL.map(|axis| {
        let own = Scalar::new(span, Form::Normal(Rc::clone(&shared), axis));
        match domain {
            Some(domain) => Scalar::new(span, Form::OnDomain(own, Rc::clone(domain))),
            None => own,
        }
    })
}
