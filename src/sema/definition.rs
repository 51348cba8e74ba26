use crate::diag::Span;
use crate::syntax::ast::{Expr, Interval, Name, Plane, Role};

/// The length unit of the exported files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Unit {
    /// Millimetre.
    #[default]
    Millimetre,
    /// Centimetre.
    Centimetre,
    /// Metre.
    Metre,
    /// Inch.
    Inch,
}

impl Unit {
    /// The units and the words for them.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Millimetre, "mm"),
        (Self::Centimetre, "cm"),
        (Self::Metre, "m"),
        (Self::Inch, "inch"),
    ];

    /// The unit that a word stands for.
    #[must_use]
    pub fn of(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, own)| *own == word).map(|(unit, _)| *unit)
    }

    /// The word.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|(unit, _)| *unit == self).map_or("mm", |(_, word)| word)
    }
}

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
    /// What kind of thing it is, with its article.
    pub(super) fn kind(&self) -> &'static str {
        match self.form {
            DefinitionForm::Constant { is_param: true, .. } => "a parameter",
            DefinitionForm::Constant { .. } => "a constant",
            DefinitionForm::Function { .. } => "a function",
            DefinitionForm::Curve { role: Role::Profile, .. } => "a profile",
            DefinitionForm::Curve { role: Role::Sweep, .. } => "a sweep curve",
            DefinitionForm::Curve { .. } => "a curve",
            DefinitionForm::Construction { .. } => "a construction",
            DefinitionForm::Surface { .. } => "a surface",
        }
    }

    pub(super) fn span(&self) -> Span {
        self.name.span
    }
}
