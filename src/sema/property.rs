use std::rc::Rc;

use crate::curve::{Axis, Curve, Parameter, Property};
use crate::diag::{Code, Diagnostic, Span};
use crate::sweep::{CurveProperty, Form, Scalar};
use crate::syntax::ast::{Argument, Name, Reference, Role};

use super::definition::DefinitionForm;
use super::lowerer::{Lowered, Lowerer, Reported, parameter_of};
use super::scope::{Binding, Scope};
use super::spelling;
use super::value::Value;

/// A property of curves by its name: a scalar, or three coordinates.
enum Named {
    Scalar(Property),
    Vector(fn(Axis) -> Property),
}

fn named(name: &str) -> Option<Named> {
    Some(match name {
        "x" => Named::Scalar(Property::Position(Axis::X)),
        "y" => Named::Scalar(Property::Position(Axis::Y)),
        "z" => Named::Scalar(Property::Position(Axis::Z)),
        "σ" => Named::Scalar(Property::Speed),
        "s" => Named::Scalar(Property::ArcLength),
        "κ" => Named::Scalar(Property::Curvature),
        "ρ" => Named::Scalar(Property::RadiusOfCurvature),
        "t" => Named::Vector(Property::Tangent),
        "n" => Named::Vector(Property::Normal),
        _ => return None,
    })
}

impl<'a> Lowerer<'a> {
    /// `c(E)`, `c'(E)`: the position or a derivative of it.
    pub(super) fn position(
        &mut self,
        curve: &Rc<Curve>,
        primes: u32,
        at: Scalar,
        span: Span,
        scope: &Scope<'_>,
    ) -> Lowered<Value> {
        let [x, y, z] = Axis::ALL
            .map(|axis| self.atom(curve, Property::Position(axis), primes, &at, span, scope));
        Ok(Value::Vector([x?, y?, z?]))
    }

    /// `c.σ(E)` and its like.
    pub(super) fn property(
        &mut self,
        curve: &Rc<Curve>,
        function: &Reference,
        at: Scalar,
        span: Span,
        scope: &Scope<'_>,
    ) -> Lowered<Value> {
        match named(&function.name.text) {
            Some(Named::Scalar(property)) => {
                self.warn_of_zero_coordinate(curve, property, function, scope);
                self.atom(curve, property, function.primes, &at, span, scope)
                    .map(Value::Scalar)
            }
            Some(Named::Vector(property)) => {
                let [x, y, z] = Axis::ALL.map(|axis| {
                    self.atom(curve, property(axis), function.primes, &at, span, scope)
                });
                Ok(Value::Vector([x?, y?, z?]))
            }
            None => Err(self.report_property(function, scope)),
        }
    }

    fn report_property(&mut self, function: &Reference, scope: &Scope<'_>) -> Reported {
        let name = &function.name;
        let finding = if ["f", "g", "e2", "e3"].contains(&name.text.as_str()) {
            let message = format!("the frame vector `{}` is not in this version", name.text);
            self.finding(scope, Code::E0110, name.span, message)
        } else {
            let message = format!("a curve has no property `{}`", name.text);
            let finding = self.finding(scope, Code::E0111, name.span, message);
            match spelling::property_meant(&name.text) {
                Some(meant) => finding
                    .help(format!("did you mean `{meant}`?"))
                    .fix(name.span, meant),
                None => finding.help("the properties are x, y, z, σ, s, t, n, κ and ρ"),
            }
        };
        self.report(finding)
    }

    /// A property without its curve's name: that of the only profile for a function of u, of the
    /// only sweep curve for a function of v.
    pub(super) fn bare_property(
        &mut self,
        span: Span,
        function: &'a Reference,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let at = self.argument(&function.name, arguments, parenthesis, scope)?;
        if scope.frame.is_some() {
            return Err(self.report_bare_inside(function, &at, scope));
        }
        let role = match (at.depends_on(Parameter::U), at.depends_on(Parameter::V)) {
            (true, false) => Role::Profile,
            (false, true) => Role::Sweep,
            (true, true) => return Err(self.report_unnamed(function, "depends on u and v", span)),
            (false, false) => return Err(self.report_unnamed(function, "is constant", span)),
        };
        match self.only_curve(role, span.file) {
            Ok(name) => {
                let curve = self.curve_named(name, scope)?;
                self.property(&curve, function, at, span, scope)
            }
            Err(count) => Err(self.report_ambiguous(function, role, count, &at, scope)),
        }
    }

    /// E0105 where not one curve of a role is declared, but so many.
    fn report_ambiguous(
        &mut self,
        function: &Reference,
        role: Role,
        count: usize,
        at: &Scalar,
        scope: &Scope<'_>,
    ) -> Reported {
        let text = self.sources.map.slice(function.span).to_owned();
        let qualified = |curve: &str| format!("`{curve}.{text}(…)`");
        let what = if role == Role::Profile {
            "profile"
        } else {
            "sweep curve"
        };
        match count {
            // the curve that is meant may be one that could not be read
            _ if self.lacks_import || self.broken_roles.contains(&role) => Reported,
            0 => {
                let message = format!("`{text}` needs a {what}, and the file has none");
                let finding = self.finding(scope, Code::E0105, function.span, message);
                let curves = self.curves_in(|own| at.depends_on(own));
                let finding = match curves.as_slice() {
                    [] if role == Role::Profile => {
                        finding.help("declare it: `profile p(u) in xz = …`")
                    }
                    [] => finding.help("declare it: `sweep c(v) in xy = …`"),
                    [only] => finding
                        .help(format!("name the curve: {}", qualified(&only.text)))
                        .fix(function.span, format!("{}.{text}", only.text)),
                    several => {
                        finding.help(format!("name the curve: {}", choice(several, qualified)))
                    }
                };
                self.report(finding)
            }
            _ => {
                let all = choice(&self.curves_of(role), qualified);
                let message =
                    format!("the file has {count} {what}s: `{text}` must be named by its curve");
                let finding = self.finding(scope, Code::E0105, function.span, message);
                self.report(finding.help(format!("write {all}")))
            }
        }
    }

    /// E0105 where the argument of a property does not tell whether it is that of the profile or of
    /// the sweep curve.
    fn report_unnamed(&mut self, function: &Reference, why: &str, span: Span) -> Reported {
        let text = self.sources.map.slice(function.span);
        let qualified = |curve: &str| format!("`{curve}.{text}(…)`");
        let message = format!("the argument of `{text}` {why}: the curve must be named");
        let finding = Diagnostic::new(Code::E0105, span, message);
        let all = self.curves_in(|_| true);
        let near = match (self.only_curve(Role::Sweep, span.file), all.as_slice()) {
            (Ok(sweep), _) => Some(sweep),
            (Err(_), [only]) => Some(*only),
            _ => None,
        };
        let finding = match near {
            Some(near) => finding
                .help(format!("write {}", qualified(&near.text)))
                .fix(function.span, format!("{}.{text}", near.text)),
            None if all.is_empty() => finding.help(format!(
                "declare it: `curve c(v) in xy = …`, and write {}",
                qualified("c")
            )),
            None => finding.help(format!("write {}", choice(&all, qualified))),
        };
        self.report(finding)
    }

    /// The names of the curves that run in such a parameter, in the order of the text.
    fn curves_in(&self, runs: impl Fn(Parameter) -> bool) -> Vec<&'a Name> {
        let definitions = self.definitions.of_files();
        let curves = definitions.filter_map(|own| match own.form {
            DefinitionForm::Curve { parameter, .. } => Some((own.name, parameter)),
            _ => None,
        });
        let curves = curves.filter(|(_, own)| parameter_of(&own.text).is_some_and(&runs));
        let mut names: Vec<_> = curves.map(|(name, _)| name).collect();
        names.sort_by_key(|own| own.span);
        names
    }

    /// E0105 inside a construction, where no curve is the only one.
    fn report_bare_inside(
        &mut self,
        function: &Reference,
        at: &Scalar,
        scope: &Scope<'_>,
    ) -> Reported {
        let text = self.sources.map.slice(function.span);
        let message = format!("inside a construction `{text}` needs its curve's name");
        let finding = self.finding(scope, Code::E0105, function.span, message);
        let finding = match only_curve_handed_over(scope, at) {
            Some(curve) => finding
                .help(format!("write `{curve}.{text}(…)`"))
                .fix(function.span, format!("{curve}.{text}")),
            None => finding.help(format!("write `c.{text}(…)`")),
        };
        self.report(finding)
    }

    /// One property at an argument, differentiated by the curve's parameter. That the curve has
    /// the property is checked here, where it is asked for.
    fn atom(
        &mut self,
        curve: &Rc<Curve>,
        property: Property,
        primes: u32,
        at: &Scalar,
        span: Span,
        scope: &Scope<'_>,
    ) -> Lowered<Scalar> {
        let (property, derivative) = match property {
            Property::Position(axis) if primes > 0 => (Property::Hodograph(axis), primes - 1),
            other => (other, primes),
        };
        if let Err(fault) = curve.property(property) {
            let mut finding = self.finding(scope, fault.code(), span, fault.message(curve.name()));
            finding
                .notes
                .extend(fault.evidence(curve.name(), curve.parameter()));
            if let Some(help) = fault.help() {
                finding = finding.help(help);
            }
            return Err(self.report(finding));
        }
        self.warn_of_cusps(curve, property);
        let property = CurveProperty {
            curve: Rc::clone(curve),
            property,
            derivative,
        };
        Ok(Scalar::new(
            scope.site(span),
            Form::Property(property, at.clone()),
        ))
    }

    /// A warning where a coordinate is asked for that is 0 because of the curve's plane.
    fn warn_of_zero_coordinate(
        &mut self,
        curve: &Curve,
        property: Property,
        function: &Reference,
        scope: &Scope<'_>,
    ) {
        let (Property::Position(axis), Some(plane)) = (property, curve.plane()) else {
            return;
        };
        let (first, second) = plane.axes();
        if axis == first || axis == second {
            return;
        }
        let name = curve.name();
        let message =
            format!("`{axis}` of `{name}` is 0 everywhere: `{name}` lies in another plane");
        let finding = self.finding(scope, Code::W1010, function.span, message);
        self.report(finding.help(format!("`{name}` has the coordinates {first} and {second}")));
    }

    /// A warning for every curve whose speed is used and vanishes somewhere.
    fn warn_of_cusps(&mut self, curve: &Curve, property: Property) {
        if matches!(property, Property::Position(_) | Property::Hodograph(_)) {
            return;
        }
        if self.cusps_reported.iter().any(|own| own == curve.name()) {
            return;
        }
        self.cusps_reported.push(curve.name().to_owned());
        let cusps = curve.cusps();
        let Some(definition) = self.definitions.get(curve.name()) else {
            return;
        };
        if cusps.is_empty() {
            return;
        }
        for cusp in &cusps {
            let bounds = (cusp.lower().clone(), cusp.upper().clone());
            self.shared_zeros.push((curve.parameter(), bounds));
        }
        let places: Vec<String> = cusps
            .iter()
            .map(|own| own.place(&curve.parameter().to_string()))
            .collect();
        let message = format!(
            "`{}` has a cusp: σ vanishes at {}",
            curve.name(),
            places.join(", ")
        );
        self.report(Diagnostic::new(Code::W1003, definition.span(), message));
    }
}

/// Up to three names, as they are to be written.
fn choice(names: &[&Name], written: impl Fn(&str) -> String) -> String {
    let names: Vec<String> = names.iter().take(3).map(|own| written(&own.text)).collect();
    names.join(" or ")
}

/// The only curve among the parameters of the construction around that runs in the parameter on
/// which an argument depends.
fn only_curve_handed_over(scope: &Scope<'_>, at: &Scalar) -> Option<String> {
    let runs_in = |parameter: Parameter| at.depends_on(parameter);
    let bindings = scope.frame.as_ref()?.bindings.borrow();
    let mut names = bindings.iter().filter_map(|(name, binding)| match binding {
        Binding::Curve(curve) if runs_in(curve.parameter()) => Some(name.clone()),
        _ => None,
    });
    let only = names.next()?;
    names.next().is_none().then_some(only)
}
