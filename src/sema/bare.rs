use std::rc::Rc;

use crate::curve::{Curve, Parameter};
use crate::diag::Code;
use crate::number::Real;
use crate::sweep::{Form, Scalar};
use crate::syntax::ast::{Name, Reference};

use super::definition::DefinitionForm;
use super::lowerer::{Lowered, Lowerer, Meaning, Reported, is_reserved, parameter_of};
use super::scope::{Binding, Function, Scope};
use super::value::Value;

impl<'a> Lowerer<'a> {
    /// A name without a parenthesis, `a`, `d'`, `a.x`.
    pub(super) fn reference(
        &mut self,
        reference: &'a Reference,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let name = &reference.name;
        let Some(qualifier) = &reference.qualifier else {
            return self.bare_value(name, reference.primes, scope);
        };
        if let Ok(curve) = self.curve_named(qualifier, scope) {
            let text = self.sources.map.slice(reference.span);
            let help = format!("write `{text}({})`", curve.parameter());
            let message = format!("`{}` of a curve needs an argument", name.text);
            let finding = self.finding(scope, Code::E0107, reference.span, message);
            let finding = finding.help(help);
            return Err(self.report(if scope.allows(curve.parameter()) {
                let written = format!("{text}({})", curve.parameter());
                finding.fix(reference.span, written)
            } else {
                finding
            }));
        }
        let base = self.bare_value(qualifier, 0, scope)?;
        self.component(&base, name, scope)
    }

    /// The value that a name stands for: a constant, a parameter, a unit vector; or a function, a
    /// curve or a surface at its own parameters.
    fn bare_value(&mut self, name: &Name, primes: u32, scope: &Scope<'a>) -> Lowered<Value> {
        if is_reserved(&name.text) {
            return self.reserved_value(name, scope);
        }
        match self.binding(name, scope)? {
            Some(Binding::Function(function)) => {
                return self.bare_function(&function, name, primes, scope);
            }
            Some(Binding::Curve(curve)) => return self.bare_curve(&curve, name, primes, scope),
            Some(Binding::Value(value)) if primes == 0 => return Ok(value),
            Some(_) => return Err(self.report_prime_of_value(name, scope)),
            None => {}
        }
        self.declared_value(name, primes, scope)
    }

    /// A parameter or a unit vector; the other reserved names are properties.
    fn reserved_value(&mut self, name: &Name, scope: &Scope<'a>) -> Lowered<Value> {
        let site = scope.site(name.span);
        if let Some(parameter) = parameter_of(&name.text) {
            if scope.allows(parameter) {
                let form = Form::Parameter(parameter);
                return Ok(Value::Scalar(Scalar::new(site, form)));
            }
            let message = format!("`{}` is not a parameter here", name.text);
            let finding = self.finding(scope, Code::E0109, name.span, message);
            let help = match (scope.u, scope.v) {
                (false, false) => "a constant is needed here",
                (true, _) => "only `u` may be used here",
                (_, true) => "only `v` may be used here",
            };
            return Err(self.report(finding.help(help)));
        }
        if let Some(axis) = ["i", "j", "k"].iter().position(|own| *own == name.text) {
            let component =
                |index: usize| Scalar::constant(site, Real::from(i64::from(index == axis)));
            return Ok(Value::Vector([component(0), component(1), component(2)]));
        }
        let message = format!("`{}` is a property and needs an argument", name.text);
        let finding = self.finding(scope, Code::E0107, name.span, message);
        let help = format!("write `{0}(u)`, `{0}(v)` or `c.{0}(v)`", name.text);
        Err(self.report(finding.help(help)))
    }

    fn declared_value(&mut self, name: &Name, primes: u32, scope: &Scope<'a>) -> Lowered<Value> {
        let Some(definition) = self.definitions.get(&name.text) else {
            return Err(self.report_unknown(name, scope));
        };
        if let DefinitionForm::Construction { .. } = definition.form {
            let message = format!("the construction `{}` needs its arguments", name.text);
            let finding = self.finding(scope, Code::E0107, name.span, message);
            return Err(self.report(finding));
        }
        match self.meaning(name, scope)? {
            Meaning::Constant(_) if primes > 0 => Err(self.report_prime_of_value(name, scope)),
            Meaning::Constant(value) => {
                let site = scope.site(name.span);
                Ok(value.map(|own| Scalar::new(site, own.form().clone())))
            }
            Meaning::Function(function) => self.bare_function(&function, name, primes, scope),
            Meaning::Curve(curve) => self.bare_curve(&curve, name, primes, scope),
            Meaning::Surface(surface) => {
                if primes > 0 {
                    return Err(self.report_prime_of_value(name, scope));
                }
                self.check_parameters(&[Parameter::U, Parameter::V], name, scope)?;
                self.mentioned.push(surface.name.clone());
                Ok(Value::Vector(surface.function()))
            }
            Meaning::InProgress | Meaning::Failed => Err(Reported),
        }
    }

    fn bare_function(
        &mut self,
        function: &Function,
        name: &Name,
        primes: u32,
        scope: &Scope<'_>,
    ) -> Lowered<Value> {
        self.check_parameters(&function.parameters, name, scope)?;
        let site = scope.site(name.span);
        match function.parameters.as_slice() {
            [own] => Ok(function.value.map(|value| {
                (0..primes).fold(value.clone(), |value, _| {
                    Scalar::new(site, Form::Partial(*own, value))
                })
            })),
            _ if primes > 0 => Err(self.report_prime_of_value(name, scope)),
            _ => Ok(function.value.clone()),
        }
    }

    fn bare_curve(
        &mut self,
        curve: &Rc<Curve>,
        name: &Name,
        primes: u32,
        scope: &Scope<'_>,
    ) -> Lowered<Value> {
        let parameter = curve.parameter();
        self.check_parameters(&[parameter], name, scope)?;
        let at = Scalar::new(scope.site(name.span), Form::Parameter(parameter));
        self.position(curve, primes, at, name.span, scope)
    }

    fn check_parameters(
        &mut self,
        needed: &[Parameter],
        name: &Name,
        scope: &Scope<'_>,
    ) -> Lowered<()> {
        let Some(missing) = needed.iter().find(|own| !scope.allows(**own)) else {
            return Ok(());
        };
        let message = format!(
            "`{}` depends on `{missing}`, which is not a parameter here",
            name.text
        );
        let finding = self.finding(scope, Code::E0109, name.span, message);
        Err(self.report(finding))
    }

    fn report_prime_of_value(&mut self, name: &Name, scope: &Scope<'_>) -> Reported {
        let message = format!("`{}` is not a function of one parameter", name.text);
        let finding = self.finding(scope, Code::E0107, name.span, message);
        self.report(finding.help("a prime differentiates functions and curves; of more parameters write `du(…)` or `dv(…)`"))
    }
}
