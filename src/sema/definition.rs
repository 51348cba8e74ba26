use crate::diag::Span;
use crate::syntax::ast::{Expr, Interval, Name, Plane, Role};

/// What a name stands for, as it is declared.
#[derive(Debug, Clone, Copy)]
pub(super) struct Definition<'a> {
    pub(super) name: &'a Name,
    pub(super) form: DefinitionForm<'a>,
    /// Whether it is part of the standard library.
    pub(super) library: bool,
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
