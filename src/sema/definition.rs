use crate::diag::Span;
use crate::syntax::ast::{Declaration, Expr, Interval, Name, Plane, Role};

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

    pub(super) fn is_curve(&self, of: Role) -> bool {
        matches!(self.form, DefinitionForm::Curve { role, .. } if role == of)
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
