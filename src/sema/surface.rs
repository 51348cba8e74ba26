use std::rc::Rc;

use crate::curve::{Curve, Interval, Parameter};
use crate::diag::{Code, Diagnostic};
use crate::sweep::{Domain, Form, Scalar, SweptSurface};
use crate::syntax::ast::{self, Expr, Name, Role};

use super::definition::DefinitionForm;
use super::lowerer::{Lowered, Lowerer, Meaning, Reported};
use super::scope::Scope;
use super::value::Value;

impl<'a> Lowerer<'a> {
    /// Whether a name is declared as a surface.
    pub(super) fn is_surface(&self, name: &Name) -> bool {
        let definition = self.definitions.get(&name.text);
        definition.is_some_and(|own| matches!(own.form, DefinitionForm::Surface { .. }))
    }

    /// The surface of that name.
    pub(super) fn surface(&mut self, name: &Name) -> Lowered<Rc<SweptSurface>> {
        match self.meaning(name, &Scope::constant())? {
            Meaning::Surface(surface) => Ok(surface),
            _ => Err(Reported),
        }
    }

    pub(super) fn define_surface(
        &mut self,
        name: &Name,
        domain: Option<&'a (ast::Interval, ast::Interval)>,
        value: &'a Expr,
    ) -> Lowered<SweptSurface> {
        let given = match domain {
            Some((u, v)) => {
                let (u, v) = (self.interval(u), self.interval(v));
                Some(Domain { u: u?, v: v? })
            }
            None => None,
        };
        let coordinates = match self.value(value, &Scope::surface())? {
            Value::Vector(vector) => vector,
            other => {
                let message = format!(
                    "a surface is a vector expression, this is {}",
                    other.type_name()
                );
                return Err(self.report(Diagnostic::new(Code::E0302, value.span, message)));
            }
        };
        let domain = match given {
            Some(domain) => domain,
            None => {
                let used = curves_used(&coordinates);
                Domain {
                    u: self.domain_of_curves(name, &used, Parameter::U)?,
                    v: self.domain_of_curves(name, &used, Parameter::V)?,
                }
            }
        };
        Ok(SweptSurface {
            name: name.text.clone(),
            span: name.span,
            domain,
            coordinates,
            tower: self.tower.clone(),
        })
    }

    /// The domain of the profile (sweep curve) that a surface uses, else of the curves it uses in
    /// that parameter, else [0, 1].
    fn domain_of_curves(
        &mut self,
        name: &Name,
        used: &[(Rc<Curve>, [bool; 2])],
        parameter: Parameter,
    ) -> Lowered<Interval> {
        let index = usize::from(parameter == Parameter::V);
        let used = used.iter().filter(|(_, own)| own[index]);
        let used: Vec<&Rc<Curve>> = used.map(|(curve, _)| curve).collect();
        let leading = |curve: &&&Rc<Curve>| {
            let role = match parameter {
                Parameter::U => Role::Profile,
                Parameter::V => Role::Sweep,
            };
            let definition = self.definitions.get(curve.name());
            curve.parameter() == parameter && definition.is_some_and(|own| own.is_curve(role))
        };
        let chosen: Vec<&Rc<Curve>> = used.iter().filter(leading).copied().collect();
        let chosen = if chosen.is_empty() { used } else { chosen };
        let Some(first) = chosen.first() else {
            return Ok(Interval::unit());
        };
        let Some(other) = chosen.iter().find(|curve| curve.domain() != first.domain()) else {
            return Ok(first.domain().clone());
        };
        let message = format!(
            "`{}` is defined on {} and `{}` on {}: the domain of this surface in {parameter} is not clear",
            first.name(),
            first.domain(),
            other.name(),
            other.domain()
        );
        let finding = Diagnostic::new(Code::E0211, name.span, message);
        Err(self.report(finding.help("give the surface its domain: `on [a, b] x [c, d]`")))
    }
}

/// The curves that a surface uses, and whether it uses them in u, and in v: each in its own
/// parameter, and in the one it is used at.
fn curves_used(coordinates: &[Scalar; 3]) -> Vec<(Rc<Curve>, [bool; 2])> {
    let mut used: Vec<(Rc<Curve>, [bool; 2])> = Vec::new();
    Scalar::visit_curves(coordinates, &mut |curve, argument| {
        let is_in = |parameter| {
            curve.parameter() == parameter
                || matches!(argument.form(), Form::Parameter(own) if *own == parameter)
        };
        let now = [is_in(Parameter::U), is_in(Parameter::V)];
        match used.iter_mut().find(|(own, _)| Rc::ptr_eq(own, curve)) {
            Some((_, known)) => *known = [known[0] || now[0], known[1] || now[1]],
            None => used.push((Rc::clone(curve), now)),
        }
    });
    used
}
