use std::rc::Rc;

use crate::curve::kinds::{Arguments, BuildFault, Coordinates, Kind, Setting};
use crate::curve::{self, Axis, Curve, Homogeneous, Parameter};
use crate::diag::{Code, Diagnostic, Span};
use crate::number::Real;
use crate::sweep::{Domain, Expanded, Expander, Scalar};
use crate::syntax::ast::{Argument, Expr, ExprKind, Interval, Name, Plane, Role};

use super::definition::{Definition, DefinitionForm};
use super::lowerer::{Lowered, Lowerer, Reported, parameter_of};
use super::scope::Scope;
use super::value::Value;

impl<'a> Lowerer<'a> {
    /// The curve that a declaration describes.
    pub(super) fn curve(&mut self, definition: &Definition<'a>) -> Lowered<Rc<Curve>> {
        let DefinitionForm::Curve {
            role,
            parameter,
            plane,
            domain,
            value,
        } = definition.form
        else {
            return Err(Reported);
        };
        let parameter = self.curve_parameter(role, parameter)?;
        let domain = match domain {
            Some(interval) => self.interval(interval)?,
            None => curve::Interval::unit(),
        };
        let plane = plane.map(|plane| match plane {
            Plane::Xy => curve::Plane::Xy,
            Plane::Xz => curve::Plane::Xz,
            Plane::Yz => curve::Plane::Yz,
        });
        let name = definition.name;
        let (position, coordinates) = match self.constructor_call(value) {
            Some((constructor, arguments, parenthesis)) => {
                let kind = self.constructor(constructor).ok_or(Reported)?;
                let values = self.constructor_arguments(kind, arguments, parenthesis)?;
                let coordinates = self.constructed(kind, &values, &domain, value.span)?;
                let position = self.placed(&coordinates, plane, value.span)?;
                (position, Some(coordinates))
            }
            None => (self.explicit(value, parameter, plane, &domain)?, None),
        };
        self.check_common_zero(name, parameter, &domain, &position);
        let tower = self.tower.clone();
        let curve = Curve::new(name.text.clone(), plane, parameter, domain, position, tower);
        let curve = match coordinates {
            Some(coordinates) => curve.built(coordinates),
            None => curve,
        };
        if curve.position().is_point() {
            let fault = curve::Fault::NoMotion;
            let finding = Diagnostic::new(fault.code(), name.span, fault.message(&name.text));
            return Err(self.report(finding));
        }
        Ok(Rc::new(curve))
    }

    fn curve_parameter(&mut self, role: Role, name: &Name) -> Lowered<Parameter> {
        let (kind, expected, help) = match role {
            Role::Profile => (
                "a profile",
                "`u`",
                "a sweep curve runs in `v`, a `curve` in either",
            ),
            Role::Sweep => (
                "a sweep curve",
                "`v`",
                "a profile runs in `u`, a `curve` in either",
            ),
            Role::Further => ("a curve", "`u` or `v`", "other parameters there are none"),
        };
        match (parameter_of(&name.text), role) {
            (Some(Parameter::U), Role::Profile | Role::Further) => Ok(Parameter::U),
            (Some(Parameter::V), Role::Sweep | Role::Further) => Ok(Parameter::V),
            _ => {
                let message = format!("{kind} runs in {expected}, not in `{}`", name.text);
                let finding = Diagnostic::new(Code::E0109, name.span, message);
                Err(self.report(finding.help(help)))
            }
        }
    }

    /// `[a, b]` with a < b.
    pub(super) fn interval(&mut self, interval: &'a Interval) -> Lowered<curve::Interval> {
        let start = self.constant_number(&interval.start);
        let end = self.constant_number(&interval.end);
        let (start, end) = (start?, end?);
        let what = match start.cmp(&end) {
            std::cmp::Ordering::Less => "",
            std::cmp::Ordering::Equal => "empty",
            std::cmp::Ordering::Greater => "reversed",
        };
        curve::Interval::new(start.clone(), end.clone()).ok_or_else(|| {
            let message = format!("the domain [{start}, {end}] is {what}");
            let finding = Diagnostic::new(Code::E0205, interval.span, message);
            let finding = finding.help("a domain [a, b] has a < b");
            if what == "empty" {
                return self.report(finding);
            }
            let slice = |expr: &Expr| self.sources.map.slice(expr.span);
            let turned = format!("[{}, {}]", slice(&interval.end), slice(&interval.start));
            self.report(finding.fix(interval.span, turned))
        })
    }

    /// The constructor call that a curve's value is, if it is one.
    fn constructor_call(&self, value: &'a Expr) -> Option<(&'a Name, &'a [Argument], Span)> {
        let ExprKind::Apply {
            function,
            arguments,
            parenthesis,
        } = &value.kind
        else {
            return None;
        };
        let name = &function.name;
        let plain = function.qualifier.is_none() && function.primes == 0;
        (plain && self.constructor(name).is_some()).then_some((
            name,
            arguments.as_slice(),
            *parenthesis,
        ))
    }

    /// The coordinates that a constructor gives.
    fn constructed(
        &mut self,
        kind: &Kind,
        arguments: &Arguments,
        domain: &curve::Interval,
        span: Span,
    ) -> Lowered<Coordinates> {
        let setting = Setting {
            domain,
            tower: &self.tower,
        };
        (kind.build)(arguments, &setting).map_err(|fault| {
            let finding = match fault {
                BuildFault::Malformed(what) => {
                    Diagnostic::new(Code::E0208, span, what).help(format!("write {}", kind.usage))
                }
                BuildFault::FieldDegree => {
                    let limit = self.sources.limits.field_degree;
                    let message = format!(
                        "this curve would make the degree of the number field greater than {limit}"
                    );
                    Diagnostic::new(Code::E0509, span, message)
                        .help("raise the limit with `--max-field-degree`")
                }
            };
            self.report(finding)
        })
    }

    /// The coordinates in space.
    fn placed(
        &mut self,
        coordinates: &Coordinates,
        plane: Option<curve::Plane>,
        span: Span,
    ) -> Lowered<Homogeneous> {
        let pairs = coordinates.numerators.len() == 2;
        match coordinates.in_space(plane) {
            Some(position) => Ok(position),
            None => Err(self.report_plane(pairs, span)),
        }
    }

    fn report_plane(&mut self, pairs: bool, span: Span) -> Reported {
        let finding = if pairs {
            Diagnostic::new(Code::E0208, span, "a curve given by pairs needs its plane")
                .help("write `in xy`, `in xz` or `in yz` before the `=`")
        } else {
            Diagnostic::new(
                Code::E0208,
                span,
                "a curve in a plane is given by pairs, this is a vector",
            )
            .help("give pairs, or leave out the plane")
        };
        self.report(finding)
    }

    /// A curve given by an expression in its parameter.
    fn explicit(
        &mut self,
        value: &'a Expr,
        parameter: Parameter,
        plane: Option<curve::Plane>,
        domain: &curve::Interval,
    ) -> Lowered<Homogeneous> {
        let scope = Scope::of(&[parameter]);
        let lowered = self.value(value, &scope)?;
        let fractions = self.expand_on(&lowered, parameter, domain)?;
        let fractions = match (lowered, plane) {
            (Value::Pair(_), Some(plane)) => {
                let (first, second) = plane.axes();
                Axis::ALL.map(|axis| {
                    let index = [first, second].iter().position(|own| *own == axis);
                    index.map_or_else(
                        || Expanded::Number(Real::from(0)),
                        |index| fractions[index].clone(),
                    )
                })
            }
            (Value::Vector(_), None) => [
                fractions[0].clone(),
                fractions[1].clone(),
                fractions[2].clone(),
            ],
            (Value::Vector(_), Some(plane)) => {
                let (first, second) = plane.axes();
                let across = |axis: &&Axis| **axis != first && **axis != second;
                let other = Axis::ALL.iter().find(across).map_or(0, |axis| axis.index());
                if !fractions[other].is_zero() {
                    let message = format!(
                        "the {}-coordinate of this curve is not 0: it does not lie in its plane",
                        Axis::ALL[other]
                    );
                    return Err(self.report(Diagnostic::new(Code::E0208, value.span, message)));
                }
                [
                    fractions[0].clone(),
                    fractions[1].clone(),
                    fractions[2].clone(),
                ]
            }
            (Value::Pair(_), None) => return Err(self.report_plane(true, value.span)),
            (other, _) => {
                let message = format!(
                    "a curve is given by a pair or a vector, this is {}",
                    other.type_name()
                );
                return Err(self.report(Diagnostic::new(Code::E0106, value.span, message)));
            }
        };
        let [x, y, z] = fractions.map(|own| own.in_one(parameter).ok_or(Reported));
        Ok(Homogeneous::from_quotients(&[x?, y?, z?]))
    }

    fn expand_on(
        &mut self,
        value: &Value,
        parameter: Parameter,
        domain: &curve::Interval,
    ) -> Lowered<Vec<Expanded>> {
        let mut rectangle = Domain::unit();
        match parameter {
            Parameter::U => rectangle.u = domain.clone(),
            Parameter::V => rectangle.v = domain.clone(),
        }
        let limits = self.sources.limits;
        let mut expander = Expander::new(&rectangle, &self.tower, limits);
        let expand = |own: &Scalar| expander.expand(own);
        let expanded: Result<Vec<_>, _> = value.components().iter().map(expand).collect();
        expanded.map_err(|finding| self.report(*finding))
    }

    /// A warning where numerator and denominator of a curve share a zero on the domain.
    fn check_common_zero(
        &mut self,
        name: &Name,
        parameter: Parameter,
        domain: &curve::Interval,
        position: &Homogeneous,
    ) {
        if position.is_polynomial() {
            return;
        }
        let roots = position.common_zeros(domain);
        if roots.is_empty() {
            return;
        }
        for root in &roots {
            let bounds = (root.lower().clone(), root.upper().clone());
            self.shared_zeros.push((parameter, bounds));
        }
        let places = roots.iter().map(|own| own.place(&parameter.to_string()));
        let message = format!(
            "numerators and denominator of `{}` are all zero at {}",
            name.text,
            places.collect::<Vec<_>>().join(", ")
        );
        let finding = Diagnostic::new(Code::W1004, name.span, message);
        self.report(finding.note("the common factor cancels, the curve is sound there"));
    }
}
