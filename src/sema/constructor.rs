use crate::curve::kinds::{self, Arguments, Kind, Shape, Slot};
use crate::diag::{Code, Diagnostic, Span};
use crate::number::Real;
use crate::syntax::ast::{Argument, Expr, ExprKind, Name, ProductOp, Reference};

use super::lowerer::{Lowered, Lowerer, Reported};
use super::scope::Scope;
use super::spelling;
use super::value::Value;

impl<'a> Lowerer<'a> {
    /// The constructor that a name stands for, unless a declaration has taken the name.
    pub(super) fn constructor(&self, name: &Name) -> Option<&'static Kind> {
        if self.definitions.contains(&name.text) {
            return None;
        }
        kinds::ALL.iter().find(|kind| kind.name == name.text)
    }

    /// The finding about a curve constructor where no curve is declared, or one of a later version.
    pub(super) fn misplaced_constructor(
        &self,
        name: &Name,
        scope: &Scope<'_>,
    ) -> Option<Diagnostic> {
        if kinds::RESERVED.contains(&name.text.as_str()) {
            let message = format!("`{}` is not in this version", name.text);
            let finding = self.finding(scope, Code::E0110, name.span, message);
            return Some(match instead_of(&name.text) {
                Some(help) => finding.help(help),
                None => finding,
            });
        }
        self.constructor(name)?;
        let message = format!("`{}` makes a curve, it is no value", name.text);
        let finding = self.finding(scope, Code::E0107, name.span, message);
        Some(finding.help("declare the curve: `curve c(v) in xy = …`, and use `c(v)` here"))
    }

    /// The arguments of a constructor, slot by slot.
    pub(super) fn constructor_arguments(
        &mut self,
        kind: &Kind,
        arguments: &'a [Argument],
        parenthesis: Span,
    ) -> Lowered<Arguments> {
        let mut values = vec![None; kind.slots.len()];
        let mut position = 0;
        for argument in arguments {
            let slot = match &argument.label {
                Some(label) => kind
                    .slots
                    .iter()
                    .position(|own| own.label == Some(label.text.as_str())),
                None => {
                    position += 1;
                    (position - 1 < kind.slots.len() && kind.slots[position - 1].label.is_none())
                        .then_some(position - 1)
                }
            };
            let Some(slot) = slot else {
                let place = argument
                    .label
                    .as_ref()
                    .map_or(argument.value.span, |own| own.span);
                let meant = argument.label.as_ref().and_then(|label| {
                    let labels = kind.slots.iter().filter_map(|own| own.label);
                    Some((label.span, spelling::nearest(&label.text, labels)?))
                });
                let finding = usage(kind, place, "this argument has no place here");
                return Err(self.report(match meant {
                    Some((span, meant)) => finding.fix(span, meant),
                    None => finding,
                }));
            };
            if values[slot].is_some() {
                return Err(self.report_usage(
                    kind,
                    argument.value.span,
                    "this argument is given twice",
                ));
            }
            values[slot] = Some(self.shaped(kind, &kind.slots[slot], &argument.value)?);
        }
        let missing =
            |(slot, value): (&Slot, &Option<kinds::Value>)| value.is_none() && !slot.optional;
        if kind.slots.iter().zip(&values).any(missing) {
            return Err(self.report_usage(kind, parenthesis, "an argument is missing"));
        }
        Ok(Arguments(values))
    }

    fn report_usage(&mut self, kind: &Kind, span: Span, what: &str) -> Reported {
        self.report(usage(kind, span, what))
    }

    fn shaped(&mut self, kind: &Kind, slot: &Slot, expr: &'a Expr) -> Lowered<kinds::Value> {
        match slot.shape {
            Shape::Word => Ok(kinds::Value::Word(self.word(kind, expr)?)),
            Shape::Number => Ok(kinds::Value::Number(self.constant_number(expr)?)),
            Shape::Point => Ok(kinds::Value::Point(self.constant_point(expr)?)),
            Shape::Points | Shape::Pairs => {
                let entries = self.entries(kind, slot, expr)?;
                let points = entries.iter().map(|entry| self.constant_point(entry));
                // every entry is looked at, so that one run shows all errors
                let points = points.collect::<Vec<_>>();
                let points = points.into_iter().collect::<Lowered<Vec<Vec<Real>>>>()?;
                let length = if slot.shape == Shape::Pairs {
                    2
                } else {
                    points.first().map_or(2, Vec::len)
                };
                match points.iter().position(|own| own.len() != length) {
                    None => Ok(kinds::Value::Points(points)),
                    Some(index) => {
                        let message = format!(
                            "a point with {} coordinates where the others have {length}",
                            points[index].len()
                        );
                        Err(self.report(Diagnostic::new(Code::E0106, entries[index].span, message)))
                    }
                }
            }
            Shape::Numbers => {
                let entries = self.entries(kind, slot, expr)?;
                let numbers = entries.iter().map(|entry| self.constant_number(entry));
                let numbers = numbers.collect::<Vec<_>>();
                let numbers = numbers.into_iter().collect::<Lowered<Vec<Real>>>()?;
                Ok(kinds::Value::Numbers(numbers))
            }
        }
    }

    /// A bare word or a string.
    fn word(&mut self, kind: &Kind, expr: &'a Expr) -> Lowered<String> {
        match &expr.kind {
            ExprKind::Text(text) => Ok(text.clone()),
            ExprKind::Reference(Reference {
                qualifier: None,
                name,
                primes: 0,
                ..
            }) => Ok(name.text.clone()),
            _ => Err(self.report_usage(kind, expr.span, "a word or a string is needed")),
        }
    }

    fn entries(&mut self, kind: &Kind, slot: &Slot, expr: &'a Expr) -> Lowered<&'a [Expr]> {
        match &expr.kind {
            ExprKind::List(entries) if !entries.is_empty() => {
                let missing = entries.iter().filter_map(comma_missing);
                match missing.map(|own| self.report(own)).last() {
                    Some(reported) => Err(reported),
                    None => Ok(entries),
                }
            }
            ExprKind::List(_) => {
                let needed = match slot.shape {
                    Shape::Points => "two points or more are needed",
                    Shape::Pairs => "one pair or more is needed",
                    _ => "a number for each point is needed",
                };
                let what = format!("the list is empty, {needed}");
                Err(self.report_usage(kind, expr.span, &what))
            }
            _ => Err(self.report_usage(kind, expr.span, "a list in square brackets is needed")),
        }
    }

    pub(super) fn constant_number(&mut self, expr: &'a Expr) -> Lowered<Real> {
        let scope = Scope::constant();
        let scalar = self.scalar(expr, &scope)?;
        self.number(&scalar, &scope)
    }

    fn constant_point(&mut self, expr: &'a Expr) -> Lowered<Vec<Real>> {
        if let Some(point) = self.numeral_point(expr) {
            return Ok(point);
        }
        let value = self.constant(expr)?;
        match value {
            Value::Pair(_) | Value::Vector(_) => value
                .components()
                .iter()
                .map(|own| self.number(own, &Scope::constant()))
                .collect(),
            other => {
                let message = format!("a point is needed here, this is {}", other.type_name());
                Err(self.report(Diagnostic::new(Code::E0106, expr.span, message)))
            }
        }
    }
}

/// What to write instead of a constructor of a later version.
fn instead_of(name: &str) -> Option<&'static str> {
    Some(match name {
        "circle" => "write `arc(center: C, start: P, end: Q)` for each part below 180°",
        "bspline" => "write a `bezier` for each span",
        "join" => "declare each curve, and a surface for each",
        "ph_spline" => "write a `ph_hermite` for each span",
        "ph3" | "re_hermite" | "rrmf" => "state the curve by its coordinates, `(x, y, z)`",
        "envelope" | "motion" => "state the surface by a formula, or by a `construction`",
        _ => return None,
    })
}

/// E0107, with the right form of the constructor.
fn usage(kind: &Kind, span: Span, what: &str) -> Diagnostic {
    let message = format!("`{}`: {what}", kind.name);
    Diagnostic::new(Code::E0107, span, message).help(format!("write {}", kind.usage))
}

/// E0106 for an entry of a list that is two points side by side.
fn comma_missing(entry: &Expr) -> Option<Diagnostic> {
    let ExprKind::Product(factors) = &entry.kind else {
        return None;
    };
    let is_point = |own: &Expr| matches!(own.kind, ExprKind::Tuple(_));
    factors.windows(2).find_map(|pair| match pair {
        [(_, left), (ProductOp::Juxtapose, right)] if is_point(left) && is_point(right) => {
            let behind = Span {
                start: left.span.end,
                ..left.span
            };
            let message = "a comma is missing between two points of a list";
            let finding = Diagnostic::new(Code::E0106, left.span.to(right.span), message);
            Some(finding.help("write `,`").fix(behind, ","))
        }
        _ => None,
    })
}
