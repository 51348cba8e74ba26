use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use crate::curve::{Curve, Parameter};
use crate::diag::Span;
use crate::syntax::ast::Expr;

use super::value::Value;

/// What a name means inside a construction.
#[derive(Debug, Clone)]
pub(super) enum Binding<'a> {
    /// A curve that was handed over.
    Curve(Rc<Curve>),
    /// A function that was handed over under its name.
    Function(Rc<Function>),
    /// A value.
    Value(Value),
    /// A `where` name that nobody has asked for yet.
    Pending(&'a Expr),
    /// A `where` name that is being worked out.
    InProgress,
    /// A `where` name whose expression has an error.
    Failed,
}

/// A declared function: its value in its own parameters.
#[derive(Debug)]
pub(super) struct Function {
    pub(super) parameters: Vec<Parameter>,
    pub(super) value: Value,
}

/// What may be used where an expression stands.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope<'a> {
    /// Whether u and v stand for the surface parameters here.
    pub(super) u: bool,
    pub(super) v: bool,
    /// The names of the construction that the expression is part of.
    pub(super) frame: Option<Rc<Frame<'a>>>,
}

/// One use of a construction.
#[derive(Debug)]
pub(super) struct Frame<'a> {
    /// The construction's name.
    pub(super) construction: String,
    /// Where a file uses it; findings inside are reported there.
    pub(super) site: Span,
    pub(super) bindings: RefCell<BTreeMap<String, Binding<'a>>>,
    /// The constructions around this one.
    pub(super) outer: Option<Rc<Frame<'a>>>,
}

impl<'a> Scope<'a> {
    /// No parameters: constants only.
    pub(super) fn constant() -> Self {
        Self::default()
    }

    /// Both parameters.
    pub(super) fn surface() -> Self {
        Self {
            u: true,
            v: true,
            frame: None,
        }
    }

    /// These parameters.
    pub(super) fn of(parameters: &[Parameter]) -> Self {
        Self {
            u: parameters.contains(&Parameter::U),
            v: parameters.contains(&Parameter::V),
            frame: None,
        }
    }

    pub(super) fn allows(&self, parameter: Parameter) -> bool {
        match parameter {
            Parameter::U => self.u,
            Parameter::V => self.v,
        }
    }

    /// What a name means in the construction around, if it means anything there.
    pub(super) fn binding(&self, name: &str) -> Option<Binding<'a>> {
        self.frame.as_ref()?.bindings.borrow().get(name).cloned()
    }

    pub(super) fn bind(&self, name: &str, binding: Binding<'a>) {
        if let Some(frame) = &self.frame {
            frame.bindings.borrow_mut().insert(name.to_owned(), binding);
        }
    }

    /// The place that a finding at `span` is reported at: inside a construction, its use.
    pub(super) fn site(&self, span: Span) -> Span {
        self.frame.as_ref().map_or(span, |frame| frame.site)
    }
}
