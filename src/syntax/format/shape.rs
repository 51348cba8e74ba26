//! Trees without their places, so that they can be compared, and with every product of a name and
//! a parenthesis written as one.

use super::Reading;
use crate::diag::Span;
use crate::syntax::ast::{
    Argument, Declaration, Document, Expr, ExprKind, Interval, Item, Name, ProductOp, Reference,
};

/// The tree without places.
pub(super) fn bare(document: &Document) -> Document {
    starred(document, &|_, _| Reading::Unknown)
}

/// The tree without places, where each name that multiplies a parenthesis is joined to it by `*`.
pub(super) fn starred(
    document: &Document,
    reading: &dyn Fn(&Reference, &Declaration) -> Reading,
) -> Document {
    let items = document.items.iter().map(|item| {
        let declaration = &item.declaration;
        let shape = Shape {
            multiplies: &|name| reading(name, declaration) == Reading::Product,
        };
        Item {
            span: Span::default(),
            declaration: shape.declaration(declaration),
        }
    });
    Document {
        file: document.file,
        items: items.collect(),
        comments: Vec::new(),
        broken: Vec::new(),
    }
}

struct Shape<'a> {
    multiplies: &'a dyn Fn(&Reference) -> bool,
}

impl Shape<'_> {
    fn declaration(&self, declaration: &Declaration) -> Declaration {
        let mut own = declaration.clone();
        unplaced(&mut own);
        match &mut own {
            Declaration::Param { value, .. } | Declaration::Let { value, .. } => {
                self.replace(value);
            }
            Declaration::Curve { domain, value, .. } => {
                domain.iter_mut().for_each(|own| self.interval(own));
                self.replace(value);
            }
            Declaration::Construction { body, bindings, .. } => {
                self.replace(body);
                bindings.iter_mut().for_each(|(_, own)| self.replace(own));
            }
            Declaration::Surface { domain, value, .. } => {
                if let Some((u, v)) = domain {
                    self.interval(u);
                    self.interval(v);
                }
                self.replace(value);
            }
            Declaration::Expect { left, relation } => {
                self.replace(left);
                if let Some((_, right)) = relation {
                    self.replace(right);
                }
            }
            Declaration::Import { .. } | Declaration::Unit { .. } => {}
        }
        own
    }

    fn interval(&self, interval: &mut Interval) {
        self.replace(&mut interval.start);
        self.replace(&mut interval.end);
        interval.span = Span::default();
    }

    fn replace(&self, expr: &mut Expr) {
        *expr = self.expression(expr);
    }

    fn all(&self, list: &[Expr]) -> Vec<Expr> {
        list.iter().map(|own| self.expression(own)).collect()
    }

    fn boxed(&self, expr: &Expr) -> Box<Expr> {
        Box::new(self.expression(expr))
    }

    fn expression(&self, expr: &Expr) -> Expr {
        if self.leads_product(expr) {
            let mut factors = Vec::new();
            self.factors(ProductOp::Times, expr, &mut factors);
            return placed(ExprKind::Product(factors));
        }
        placed(match &expr.kind {
            ExprKind::Number(_) | ExprKind::Text(_) => expr.kind.clone(),
            ExprKind::Sum(terms) => {
                let terms = terms.iter();
                ExprKind::Sum(
                    terms
                        .map(|(sign, own)| (*sign, self.expression(own)))
                        .collect(),
                )
            }
            ExprKind::Product(product) => {
                let mut factors = Vec::new();
                for (op, factor) in product {
                    self.factors(*op, factor, &mut factors);
                }
                ExprKind::Product(factors)
            }
            ExprKind::Negate(inner) => ExprKind::Negate(self.boxed(inner)),
            ExprKind::Power(base, exponent) => {
                ExprKind::Power(self.boxed(base), self.boxed(exponent))
            }
            ExprKind::Reference(own) => ExprKind::Reference(reference(own)),
            ExprKind::Apply {
                function,
                arguments,
                ..
            } => ExprKind::Apply {
                function: reference(function),
                arguments: arguments.iter().map(|own| self.argument(own)).collect(),
                parenthesis: Span::default(),
            },
            ExprKind::Component(base, own) => {
                let mut own = own.clone();
                name(&mut own);
                ExprKind::Component(self.boxed(base), own)
            }
            ExprKind::Tuple(entries) => ExprKind::Tuple(self.all(entries)),
            ExprKind::List(entries) => ExprKind::List(self.all(entries)),
            ExprKind::Group(inner) => ExprKind::Group(self.boxed(inner)),
        })
    }

    fn argument(&self, argument: &Argument) -> Argument {
        let mut label = argument.label.clone();
        label.iter_mut().for_each(name);
        Argument {
            label,
            value: self.expression(&argument.value),
        }
    }

    /// The factors of a factor: two if it begins with a name that multiplies, else itself.
    fn factors(&self, op: ProductOp, expr: &Expr, factors: &mut Vec<(ProductOp, Expr)>) {
        if !self.leads_product(expr) {
            return factors.push((op, self.plain(expr)));
        }
        let (first, rest) = self.split(expr);
        factors.push((op, first));
        factors.extend(rest.map(|rest| (ProductOp::Times, rest)));
    }

    /// A factor as it is, but for what stands in its brackets.
    fn plain(&self, expr: &Expr) -> Expr {
        match &expr.kind {
            ExprKind::Negate(inner) => placed(ExprKind::Negate(Box::new(self.plain(inner)))),
            ExprKind::Power(base, exponent) => {
                let base = Box::new(self.plain(base));
                placed(ExprKind::Power(base, self.boxed(exponent)))
            }
            ExprKind::Component(base, own) => {
                let mut own = own.clone();
                name(&mut own);
                placed(ExprKind::Component(Box::new(self.plain(base)), own))
            }
            ExprKind::Apply {
                function,
                arguments,
                ..
            } => placed(ExprKind::Apply {
                function: reference(function),
                arguments: arguments.iter().map(|own| self.argument(own)).collect(),
                parenthesis: Span::default(),
            }),
            _ => self.expression(expr),
        }
    }

    /// Whether an expression begins with `NAME (…)` that is a product and can be written as one.
    fn leads_product(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Negate(inner) => self.leads_product(inner),
            ExprKind::Power(base, _) | ExprKind::Component(base, _) => self.leads_product(base),
            ExprKind::Apply {
                function,
                arguments,
                ..
            } => {
                let is_factor = |own: &Argument| {
                    let value = &own.value.kind;
                    own.label.is_none() && !matches!(value, ExprKind::List(_) | ExprKind::Text(_))
                };
                !arguments.is_empty()
                    && arguments.iter().all(is_factor)
                    && (self.multiplies)(function)
            }
            _ => false,
        }
    }

    /// The name, with the signs before it, and the parenthesis, with the powers and components
    /// behind it.
    fn split(&self, expr: &Expr) -> (Expr, Option<Expr>) {
        match &expr.kind {
            ExprKind::Negate(inner) => {
                let (first, rest) = self.split(inner);
                (placed(ExprKind::Negate(Box::new(first))), rest)
            }
            ExprKind::Power(base, exponent) => {
                let (first, rest) = self.split(base);
                let raised = |rest| {
                    placed(ExprKind::Power(
                        Box::new(rest),
                        Box::new(self.expression(exponent)),
                    ))
                };
                (first, rest.map(raised))
            }
            ExprKind::Component(base, own) => {
                let (first, rest) = self.split(base);
                let mut own = own.clone();
                name(&mut own);
                let component = |rest| placed(ExprKind::Component(Box::new(rest), own));
                (first, rest.map(component))
            }
            ExprKind::Apply {
                function,
                arguments,
                ..
            } => {
                let mut entries: Vec<Expr> = arguments
                    .iter()
                    .map(|own| self.expression(&own.value))
                    .collect();
                let rest = match (entries.len(), entries.pop()) {
                    (1, Some(only)) => ExprKind::Group(Box::new(only)),
                    (_, last) => {
                        entries.extend(last);
                        ExprKind::Tuple(entries)
                    }
                };
                let first = ExprKind::Reference(reference(function));
                (placed(first), Some(placed(rest)))
            }
            _ => (self.expression(expr), None),
        }
    }
}

/// Takes the places from the names of a declaration; those in its expressions stay.
fn unplaced(declaration: &mut Declaration) {
    match declaration {
        Declaration::Param { name: own, .. }
        | Declaration::Surface { name: own, .. }
        | Declaration::Unit { name: own } => name(own),
        Declaration::Let {
            name: own,
            parameters,
            ..
        } => {
            name(own);
            parameters.iter_mut().for_each(name);
        }
        Declaration::Construction {
            name: own,
            parameters,
            bindings,
            ..
        } => {
            name(own);
            parameters.iter_mut().for_each(name);
            bindings.iter_mut().for_each(|(own, _)| name(own));
        }
        Declaration::Curve {
            name: own,
            parameter,
            plane,
            ..
        } => {
            name(own);
            name(parameter);
            if let Some((_, span)) = plane {
                *span = Span::default();
            }
        }
        Declaration::Import { path_span, .. } => *path_span = Span::default(),
        Declaration::Expect { .. } => {}
    }
}

fn placed(kind: ExprKind) -> Expr {
    Expr {
        span: Span::default(),
        kind,
    }
}

fn name(name: &mut Name) {
    name.span = Span::default();
}

fn reference(of: &Reference) -> Reference {
    let mut own = of.clone();
    own.qualifier.as_deref_mut().into_iter().for_each(name);
    name(&mut own.name);
    own.span = Span::default();
    own
}
