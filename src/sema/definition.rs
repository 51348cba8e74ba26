use std::collections::{BTreeMap, BTreeSet};

use crate::diag::Span;
use crate::syntax::ast::{Declaration, Expr, Interval, Name, Plane, Role};

use super::library::Library;

/// What a name stands for, as it is declared.
#[derive(Debug, Clone, Copy)]
pub(super) struct Definition<'a> {
    pub(super) name: &'a Name,
    pub(super) form: DefinitionForm<'a>,
}

/// The forms of a declaration that gives a name a meaning.
#[derive(Debug, Clone, Copy)]
pub(super) enum DefinitionForm<'a> {
    Constant {
        value: &'a Expr,
        is_param: bool,
    },
    Function {
        parameters: &'a [Name],
        value: &'a Expr,
    },
    Curve {
        role: Role,
        parameter: &'a Name,
        plane: Option<Plane>,
        domain: Option<&'a Interval>,
        value: &'a Expr,
    },
    Construction {
        parameters: &'a [Name],
        body: &'a Expr,
        bindings: &'a [(Name, Expr)],
    },
    Surface {
        domain: Option<&'a (Interval, Interval)>,
        value: &'a Expr,
    },
}

impl Definition<'_> {
    pub(super) fn span(&self) -> Span {
        self.name.span
    }
}

/// What a declaration gives a name; none if it names nothing.
pub(super) fn definition_of(declaration: &Declaration) -> Option<Definition<'_>> {
    use Declaration as D;
    use DefinitionForm as F;
    #[rustfmt::skip]
    let (name, form) = match declaration {
        D::Param { name, value } => (name, F::Constant { value, is_param: true }),
        D::Let { name, parameters, value } if parameters.is_empty() => {
            (name, F::Constant { value, is_param: false })
        }
        D::Let { name, parameters, value } => (name, F::Function { parameters, value }),
        D::Curve { role, name, parameter, plane, domain, value } => {
            let plane = plane.map(|(plane, _)| plane);
            (name, F::Curve { role: *role, parameter, plane, domain: domain.as_ref(), value })
        }
        D::Construction { name, parameters, body, bindings } => {
            (name, F::Construction { parameters, body, bindings })
        }
        D::Surface { name, domain, value } => {
            (name, F::Surface { domain: domain.as_ref(), value })
        }
        D::Expect { .. } | D::Import { .. } | D::Unit { .. } => return None,
    };
    Some(Definition { name, form })
}

/// What is declared by name: in the files, and in the standard library where they do not replace it.
pub(super) struct Definitions<'a> {
    library: &'a Library,
    own: BTreeMap<&'a str, Definition<'a>>,
}

impl<'a> Definitions<'a> {
    pub(super) fn new(library: &'a Library) -> Self {
        Self {
            library,
            own: BTreeMap::new(),
        }
    }

    /// Declares a name of a file.
    pub(super) fn insert(&mut self, definition: Definition<'a>) {
        self.own.insert(&definition.name.text, definition);
    }

    pub(super) fn get(&self, name: &str) -> Option<Definition<'a>> {
        let own = self.own.get(name).copied();
        own.or_else(|| self.library.get(name))
    }

    pub(super) fn contains(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// The definitions of the files, by name.
    pub(super) fn of_files(&self) -> impl Iterator<Item = &Definition<'a>> {
        self.own.values()
    }

    /// What a file declares by a name.
    pub(super) fn of_file(&self, name: &str) -> Option<&Definition<'a>> {
        self.own.get(name)
    }

    /// All names, in order.
    pub(super) fn names(&self) -> BTreeSet<&'a str> {
        let own = self.own.keys().copied();
        own.chain(self.library.names()).collect()
    }
}
