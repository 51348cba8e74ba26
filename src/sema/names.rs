use std::collections::HashMap;

use crate::curve::kinds;
use crate::syntax::Reading;
use crate::syntax::ast::{Declaration, Document, Name, Reference};

use super::call::BUILT_IN;
use super::definition::{Definition, DefinitionForm, definition_of};
use super::expectation::QUERIES;
use super::library::Library;
use super::lowerer::{is_reserved, parameter_of};

/// What the names of a file stand for, as far as their declarations tell.
#[derive(Debug, Clone, Default)]
pub struct Names<'a> {
    /// Every declared name, and whether it is a constant.
    declared: HashMap<&'a str, bool>,
}

impl<'a> Names<'a> {
    /// The names of a file, the first one, of its imports, and of the standard library.
    #[must_use]
    pub fn of(documents: &'a [Document], library: &'a Library) -> Self {
        let mut declared = HashMap::new();
        let documents = documents.iter().chain([library.document()]);
        for item in documents.flat_map(|document| &document.items) {
            let Some(Definition { name, form }) = definition_of(&item.declaration) else {
                continue;
            };
            if !is_reserved(&name.text) {
                let constant = matches!(form, DefinitionForm::Constant { .. });
                declared.entry(name.text.as_str()).or_insert(constant);
            }
        }
        Self { declared }
    }

    /// How a name with a parenthesis behind it is read in a declaration. Unknown is what nothing
    /// declares, and the parameter of a construction, which may be a function or a value.
    #[must_use]
    pub fn reading(&self, reference: &Reference, declaration: &Declaration) -> Reading {
        let (parameters, bindings) = match declaration {
            Declaration::Construction {
                parameters,
                bindings,
                ..
            } => (parameters.as_slice(), bindings.as_slice()),
            _ => Default::default(),
        };
        let first = reference.first();
        let is_first = |own: &Name| own.text == first.text;
        if parameters.iter().any(is_first) {
            return Reading::Unknown;
        }
        let is_local = bindings.iter().any(|(own, _)| is_first(own));
        if !is_local && !self.is_known(&first.text) {
            return Reading::Unknown;
        }
        let stands_for_value =
            |name: &Name| is_local || self.declared.get(name.text.as_str()) == Some(&true);
        if applies(reference, stands_for_value) {
            Reading::Application
        } else {
            Reading::Product
        }
    }

    fn is_known(&self, name: &str) -> bool {
        self.declared.contains_key(name)
            || is_reserved(name)
            || BUILT_IN.contains(&name)
            || QUERIES.contains(&name)
            || kinds::RESERVED.contains(&name)
            || kinds::ALL.iter().any(|kind| kind.name == name)
    }
}

/// Whether a name with a parenthesis behind it is an application; if not, it is a product.
pub(super) fn applies(function: &Reference, stands_for_value: impl Fn(&Name) -> bool) -> bool {
    if let Some(qualifier) = &function.qualifier {
        return !stands_for_value(qualifier) && parameter_of(&qualifier.text).is_none();
    }
    match function.name.text.as_str() {
        _ if function.primes > 0 => true,
        "u" | "v" | "i" | "j" | "k" => false,
        name => is_reserved(name) || !stands_for_value(&function.name),
    }
}
