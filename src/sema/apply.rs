use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use crate::curve::{Curve, Parameter};
use crate::diag::{Code, Diagnostic, Fix, Span};
use crate::number::{Field, Real};
use crate::sweep::{Form, Scalar};
use crate::syntax::ast::{Argument, Expr, ExprKind, Name, Reference, Role};

use super::call::BUILT_IN;
use super::definition::{Definition, DefinitionForm};
use super::lowerer::{Lowered, Lowerer, Meaning, Reported, is_reserved};
use super::scope::{Binding, Frame, Function, Scope};
use super::value::Value;

impl<'a> Lowerer<'a> {
    /// Whether a name with a parenthesis behind it is an application; if not, it is a product.
    pub(super) fn applies(&self, function: &Reference, scope: &Scope<'a>) -> bool {
        let stands_for_value = |name: &Name| match scope.binding(&name.text) {
            Some(Binding::Curve(_) | Binding::Function(_)) => false,
            Some(_) => true,
            None => self.names_constant(name),
        };
        super::names::applies(function, stands_for_value)
    }

    /// What a name means in the construction around it; a `where` name is worked out now.
    pub(super) fn binding(
        &mut self,
        name: &Name,
        scope: &Scope<'a>,
    ) -> Lowered<Option<Binding<'a>>> {
        match scope.binding(&name.text) {
            Some(Binding::Pending(expr)) => {
                scope.bind(&name.text, Binding::InProgress);
                let value = self.value(expr, scope);
                let binding = value.map_or(Binding::Failed, Binding::Value);
                scope.bind(&name.text, binding.clone());
                match binding {
                    Binding::Failed => Err(Reported),
                    known => Ok(Some(known)),
                }
            }
            // a circle is reported where it is written
            Some(Binding::InProgress | Binding::Failed) => Err(Reported),
            other => Ok(other),
        }
    }

    /// The curve that a name stands for; nothing is reported if it stands for something else.
    pub(super) fn curve_named(&mut self, name: &Name, scope: &Scope<'a>) -> Lowered<Rc<Curve>> {
        match scope.binding(&name.text) {
            Some(Binding::Curve(curve)) => return Ok(curve),
            Some(_) => return Err(Reported),
            None => {}
        }
        match self.definitions.get(&name.text).map(|own| own.form) {
            Some(DefinitionForm::Curve { .. }) => match self.meaning(name, scope)? {
                Meaning::Curve(curve) => Ok(curve),
                _ => Err(Reported),
            },
            _ => Err(Reported),
        }
    }

    /// `NAME (…)` where it is an application.
    pub(super) fn apply(
        &mut self,
        span: Span,
        function: &'a Reference,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        if let Some(qualifier) = &function.qualifier {
            return self.apply_qualified(span, function, qualifier, arguments, parenthesis, scope);
        }
        let name = &function.name;
        if is_reserved(&name.text) {
            return self.bare_property(span, function, arguments, parenthesis, scope);
        }
        match self.binding(name, scope)? {
            Some(Binding::Curve(curve)) => {
                let at = self.argument(name, arguments, parenthesis, scope)?;
                return self.position(&curve, function.primes, at, span, scope);
            }
            Some(Binding::Function(own)) => {
                return self.call_function(&own, function, arguments, parenthesis, scope);
            }
            _ => {}
        }
        if let Some(definition) = self.definitions.get(&name.text) {
            return self.apply_definition(
                span,
                &definition,
                function,
                arguments,
                parenthesis,
                scope,
            );
        }
        if BUILT_IN.contains(&name.text.as_str()) {
            return self.call_built_in(span, name, arguments, parenthesis, scope);
        }
        if let Some(finding) = self.misplaced_constructor(name, scope) {
            return Err(self.report(finding));
        }
        // The arguments may hold findings of their own, but a bare name may stand for a curve.
        for argument in arguments {
            if !matches!(argument.value.kind, ExprKind::Reference(_)) {
                let _ = self.value(&argument.value, scope);
            }
        }
        Err(self.report_unknown(name, scope))
    }

    fn apply_qualified(
        &mut self,
        span: Span,
        function: &'a Reference,
        qualifier: &Name,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let declared = |own: &Self| own.definitions.contains(&qualifier.text);
        match self.curve_named(qualifier, scope) {
            Ok(curve) => {
                let at = self.argument(&function.name, arguments, parenthesis, scope)?;
                self.property(&curve, function, at, span, scope)
            }
            Err(_) if scope.binding(&qualifier.text).is_none() && !declared(self) => {
                Err(self.report_unknown(qualifier, scope))
            }
            Err(reported) => {
                let failed = matches!(
                    self.meanings.get(qualifier.text.as_str()),
                    Some(Meaning::Failed)
                );
                if failed {
                    return Err(reported);
                }
                let message = format!(
                    "`{}` is not a curve, it has no `{}`",
                    qualifier.text, function.name.text
                );
                let finding = self.finding(scope, Code::E0107, qualifier.span, message);
                Err(self.report(finding))
            }
        }
    }

    fn apply_definition(
        &mut self,
        span: Span,
        definition: &Definition<'a>,
        function: &'a Reference,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let name = &function.name;
        if let DefinitionForm::Construction {
            parameters,
            body,
            bindings,
        } = definition.form
        {
            if function.primes > 0 {
                return Err(self.report_prime(function, scope));
            }
            return self.construct(
                span,
                definition.name,
                (parameters, body, bindings),
                arguments,
                parenthesis,
                scope,
            );
        }
        match self.meaning(name, scope)? {
            Meaning::Curve(curve) => {
                let at = self.argument(name, arguments, parenthesis, scope)?;
                self.position(&curve, function.primes, at, span, scope)
            }
            Meaning::Function(own) => {
                self.call_function(&own, function, arguments, parenthesis, scope)
            }
            Meaning::Surface(surface) => {
                if function.primes > 0 {
                    return Err(self.report_prime(function, scope));
                }
                self.mentioned.push(surface.name.clone());
                let [u, v] = self.arguments::<2>(name, arguments, parenthesis, scope)?;
                let point = Value::Vector(surface.function());
                Ok(point.map(|own| own.substitute(&u, &v)))
            }
            Meaning::Constant(_) | Meaning::InProgress | Meaning::Failed => Err(Reported),
        }
    }

    fn report_prime(&mut self, function: &Reference, scope: &Scope<'_>) -> Reported {
        let message = format!(
            "`{}` depends on u and v, a prime is not enough",
            function.name.text
        );
        let finding = self.finding(scope, Code::E0107, function.span, message);
        self.report(finding.help("write `du(…)` or `dv(…)`"))
    }

    /// `f(E)`, `f'(E)`, `f(E, F)`
    fn call_function(
        &mut self,
        function: &Function,
        reference: &Reference,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let site = scope.site(reference.span);
        let zero = || Scalar::constant(site, Real::zero());
        let (u, v) = match function.parameters.as_slice() {
            [Parameter::U] => (
                self.argument(&reference.name, arguments, parenthesis, scope)?,
                zero(),
            ),
            [Parameter::V] => (
                zero(),
                self.argument(&reference.name, arguments, parenthesis, scope)?,
            ),
            both => {
                if reference.primes > 0 {
                    return Err(self.report_prime(reference, scope));
                }
                let [first, second] =
                    self.arguments::<2>(&reference.name, arguments, parenthesis, scope)?;
                if both.first() == Some(&Parameter::U) {
                    (first, second)
                } else {
                    (second, first)
                }
            }
        };
        let own = function.parameters.first().copied().unwrap_or(Parameter::U);
        Ok(function.value.map(|value| {
            let differentiated = (0..reference.primes).fold(value.clone(), |value, _| {
                Scalar::new(site, Form::Partial(own, value))
            });
            differentiated.substitute(&u, &v)
        }))
    }

    /// The only argument, a scalar.
    pub(super) fn argument(
        &mut self,
        name: &Name,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Scalar> {
        self.check_arguments(name, 1, arguments, parenthesis, scope)?;
        self.scalar(&arguments[0].value, scope)
    }

    /// Exactly so many scalar arguments.
    pub(super) fn arguments<const COUNT: usize>(
        &mut self,
        name: &Name,
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<[Scalar; COUNT]> {
        self.check_arguments(name, COUNT, arguments, parenthesis, scope)?;
        let values = arguments
            .iter()
            .map(|own| self.scalar(&own.value, scope))
            .collect::<Vec<_>>();
        let values = values.into_iter().collect::<Lowered<Vec<Scalar>>>()?;
        <[Scalar; COUNT]>::try_from(values).map_err(|_| Reported)
    }

    /// Reports a wrong number of arguments, and labels.
    pub(super) fn check_arguments(
        &mut self,
        name: &Name,
        count: usize,
        arguments: &[Argument],
        parenthesis: Span,
        scope: &Scope<'_>,
    ) -> Lowered<()> {
        let labelled = |own: &Argument| Some((own.label.clone()?, own.value.span));
        if let Some((label, value)) = arguments.iter().find_map(labelled) {
            let message = format!("`{}` has no argument `{}`", name.text, label.text);
            let finding = self.finding(scope, Code::E0107, label.span, message);
            let written = self.sources.map.slice(value).to_owned();
            let finding = finding.help("write the value alone");
            return Err(self.report(finding.fix(label.span.to(value), written)));
        }
        if arguments.len() == count {
            return Ok(());
        }
        let finding = self.argument_count(name, count, arguments, parenthesis, scope);
        Err(self.report(finding))
    }

    fn argument_count(
        &self,
        name: &Name,
        count: usize,
        arguments: &[Argument],
        parenthesis: Span,
        scope: &Scope<'_>,
    ) -> Diagnostic {
        let (plural, are) = (
            if count == 1 { "" } else { "s" },
            if arguments.len() == 1 { "is" } else { "are" },
        );
        let message = format!(
            "`{}` takes {count} argument{plural}, here {are} {}",
            name.text,
            arguments.len()
        );
        self.finding(scope, Code::E0107, parenthesis, message)
    }

    /// The body of a construction with its parameters bound to the arguments.
    fn construct(
        &mut self,
        span: Span,
        name: &'a Name,
        (parameters, body, bindings): (&'a [Name], &'a Expr, &'a [(Name, Expr)]),
        arguments: &'a [Argument],
        parenthesis: Span,
        scope: &Scope<'a>,
    ) -> Lowered<Value> {
        let mut outer = scope.frame.as_ref();
        while let Some(frame) = outer {
            if frame.construction == name.text {
                let message = format!("the construction `{}` uses itself", name.text);
                let finding = self.finding(scope, Code::E0104, span, message);
                return Err(self.report(finding));
            }
            outer = frame.outer.as_ref();
        }
        if arguments.len() != parameters.len() {
            let usage: Vec<&str> = parameters.iter().map(|own| own.text.as_str()).collect();
            let usage = format!("it is `{}({})`", name.text, usage.join(", "));
            let finding =
                self.argument_count(name, parameters.len(), arguments, parenthesis, scope);
            return Err(self.report(finding.help(usage)));
        }
        self.check_arguments(name, parameters.len(), arguments, parenthesis, scope)?;
        let mut bound: BTreeMap<String, Binding<'a>> = BTreeMap::new();
        for (parameter, argument) in parameters.iter().zip(arguments) {
            let binding = self.hand_over(&argument.value, scope)?;
            self.bind_once(&mut bound, parameter, binding, scope)?;
        }
        for (own, value) in bindings {
            self.bind_once(&mut bound, own, Binding::Pending(value), scope)?;
        }
        let inner = Scope {
            frame: Some(Rc::new(Frame {
                construction: name.text.clone(),
                site: scope.site(span),
                bindings: RefCell::new(bound),
                outer: scope.frame.clone(),
            })),
            ..scope.clone()
        };
        let exchanged = match scope.frame {
            None => self.exchanged(parameters, arguments),
            Some(_) => None,
        };
        let known = self.diagnostics.len();
        let value = self.value(body, &inner);
        if let Some((help, fix)) = exchanged {
            self.diagnostics.explain_from(known, &help, &fix);
        }
        value
    }

    /// The way out where a sweep curve was handed over for a profile `p`, and a profile for a
    /// sweep curve `c`, as the library calls them: the words, and the arguments exchanged.
    fn exchanged(&self, parameters: &[Name], arguments: &[Argument]) -> Option<(String, Fix)> {
        let place = |word: &str| parameters.iter().position(|own| own.text == word);
        let (p, c) = (place("p")?, place("c")?);
        let role = |index: usize| {
            let ExprKind::Reference(reference) = &arguments[index].value.kind else {
                return None;
            };
            let definition = self.definitions.get(&reference.name.text)?;
            match definition.form {
                DefinitionForm::Curve { role, .. } => Some(role),
                _ => None,
            }
        };
        if (role(p)?, role(c)?) != (Role::Sweep, Role::Profile) {
            return None;
        }
        let written = |index: usize| self.sources.map.slice(arguments[index].value.span);
        let (first, last) = (p.min(c), p.max(c));
        let (start, end) = (arguments[first].value.span, arguments[last].value.span);
        let between = Span {
            start: start.end,
            end: end.start,
            ..start
        };
        let text = [
            written(last),
            self.sources.map.slice(between),
            written(first),
        ]
        .concat();
        let help = format!(
            "the arguments are exchanged: `{}` is a sweep curve and `{}` a profile",
            written(p),
            written(c)
        );
        let span = start.to(end);
        Some((help, Fix { span, text }))
    }

    fn bind_once(
        &mut self,
        bound: &mut BTreeMap<String, Binding<'a>>,
        name: &Name,
        binding: Binding<'a>,
        scope: &Scope<'_>,
    ) -> Lowered<()> {
        if is_reserved(&name.text) {
            let finding = self.finding(
                scope,
                Code::E0103,
                name.span,
                format!("`{}` is reserved", name.text),
            );
            return Err(self.report(finding.help("choose another name")));
        }
        if bound.insert(name.text.clone(), binding).is_some() {
            let finding = self.finding(
                scope,
                Code::E0102,
                name.span,
                format!("`{}` is declared twice", name.text),
            );
            return Err(self.report(finding));
        }
        Ok(())
    }

    /// An argument of a construction: a curve or a function under its name, or a value.
    fn hand_over(&mut self, expr: &'a Expr, scope: &Scope<'a>) -> Lowered<Binding<'a>> {
        if let ExprKind::Reference(Reference {
            qualifier: None,
            name,
            primes: 0,
            ..
        }) = &expr.kind
        {
            if let Some(binding) = self.binding(name, scope)? {
                return Ok(binding);
            }
            match self.definitions.get(&name.text).map(|own| own.form) {
                Some(DefinitionForm::Curve { .. }) => {
                    return Ok(Binding::Curve(self.curve_named(name, scope)?));
                }
                Some(DefinitionForm::Function { .. }) => {
                    if let Meaning::Function(function) = self.meaning(name, scope)? {
                        return Ok(Binding::Function(function));
                    }
                }
                _ => {}
            }
        }
        self.value(expr, scope).map(Binding::Value)
    }
}
