use std::cell::RefCell;
use std::rc::Rc;

use crate::curve::kinds;
use crate::diag::Span;
use crate::syntax::ast::{Expr, ExprKind, Name};

use super::call::BUILT_IN;
use super::circle::circle_behind_where;
use super::definition::{Definition, DefinitionForm};
use super::expectation::QUERIES;
use super::lowerer::{Lowerer, is_reserved};
use super::scope::{Binding, Frame, Scope};

impl<'a> Lowerer<'a> {
    /// Reports the names in constructions that stand for nothing, whatever is handed over, and those
    /// that need each other, whether or not the constructions are used.
    pub(super) fn check_names_of_constructions(&mut self) {
        let definitions: Vec<Definition<'a>> = self.definitions.of_files().copied().collect();
        for definition in definitions {
            let DefinitionForm::Construction {
                parameters,
                body,
                bindings,
            } = definition.form
            else {
                continue;
            };
            let values = bindings.iter().map(|(_, value)| value);
            for name in values.chain([body]).flat_map(names) {
                let own = bindings.iter().map(|(own, _)| own);
                let is_own = parameters
                    .iter()
                    .chain(own)
                    .any(|own| own.text == name.text);
                if !is_own && !self.means_something(&name.text) {
                    let scope = inside(name.span, definition.name, parameters, bindings);
                    self.report_unknown(name, &scope);
                    self.undeclared.insert(name.span);
                }
            }
            if let Some(finding) = circle_behind_where(bindings) {
                self.report(finding);
            }
        }
    }

    fn means_something(&self, name: &str) -> bool {
        self.definitions.contains(name)
            || is_reserved(name)
            || BUILT_IN.contains(&name)
            || QUERIES.contains(&name)
            || is_constructor(name)
    }
}

fn is_constructor(name: &str) -> bool {
    kinds::RESERVED.contains(&name) || kinds::ALL.iter().any(|kind| kind.name == name)
}

/// The scope of a construction of which nothing but the names is known, with findings at a place.
fn inside<'a>(
    site: Span,
    construction: &Name,
    parameters: &[Name],
    bindings: &'a [(Name, Expr)],
) -> Scope<'a> {
    let given = parameters.iter();
    let given = given.map(|own| (own.text.clone(), Binding::Failed));
    let own = bindings.iter();
    let own = own.map(|(own, value)| (own.text.clone(), Binding::Pending(value)));
    Scope {
        frame: Some(Rc::new(Frame {
            construction: construction.text.clone(),
            site,
            bindings: RefCell::new(given.chain(own).collect()),
            outer: None,
        })),
        ..Scope::surface()
    }
}

/// The names that an expression uses, those of properties and components left out.
pub(super) fn names(expr: &Expr) -> Vec<&Name> {
    let mut names = Vec::new();
    let mut open = vec![expr];
    while let Some(expr) = open.pop() {
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Text(_) => {}
            ExprKind::Sum(terms) => open.extend(terms.iter().map(|(_, own)| own)),
            ExprKind::Product(factors) => open.extend(factors.iter().map(|(_, own)| own)),
            ExprKind::Negate(own) | ExprKind::Group(own) | ExprKind::Component(own, _) => {
                open.push(own);
            }
            ExprKind::Power(base, exponent) => open.extend([&**base, &**exponent]),
            ExprKind::Tuple(entries) | ExprKind::List(entries) => open.extend(entries),
            ExprKind::Reference(own) => names.push(own.first()),
            ExprKind::Apply {
                function,
                arguments,
                ..
            } => {
                names.push(function.first());
                // words may be arguments of a constructor
                if !is_constructor(&function.name.text) {
                    open.extend(arguments.iter().map(|own| &own.value));
                }
            }
        }
    }
    names
}
