use crate::syntax::ast::{Declaration, Expr, Interval, Name, Relation};

use super::INDENT;
use super::columns::{Column, Table};
use super::doc::Doc;
use super::tokens::Tokens;

/// What `where` is moved in by.
const WHERE: usize = 2;
/// The width of `where` and a blank: further names stand below the first.
const BESIDE_WHERE: usize = 6;

impl Tokens<'_> {
    /// The layout of a declaration.
    pub(super) fn declaration(&mut self, declaration: &Declaration) -> Doc {
        match declaration {
            Declaration::Param { value, .. } => self.definition(&[], value),
            Declaration::Let {
                parameters, value, ..
            } => self.definition(parameters, value),
            Declaration::Curve {
                plane,
                domain,
                value,
                ..
            } => self.curve(plane.is_some(), domain.as_ref(), value),
            Declaration::Construction {
                parameters,
                body,
                bindings,
                ..
            } => self.construction(parameters, body, bindings),
            Declaration::Surface { domain, value, .. } => self.surface(domain.as_ref(), value),
            Declaration::Expect { left, relation } => self.expectation(left, relation.as_ref()),
            Declaration::Import { .. } | Declaration::Unit { .. } => {
                Doc::concat(vec![self.token(), Doc::space(), self.token()])
            }
        }
    }

    /// `let NAME(u, v) = EXPR`, `param NAME = CONST`
    fn definition(&mut self, parameters: &[Name], value: &Expr) -> Doc {
        let mut parts = vec![self.token(), Doc::space()];
        parts.push(Doc::mark(Table::Values, Column::Name));
        parts.push(self.token());
        self.parameters(parameters, &mut parts);
        parts.push(Doc::space());
        parts.push(Doc::mark(Table::Values, Column::Equals));
        parts.push(self.token());
        parts.push(self.value(value));
        Doc::concat(parts)
    }

    /// `(p, c)`, or nothing
    fn parameters(&mut self, parameters: &[Name], parts: &mut Vec<Doc>) {
        for place in 0..parameters.len() {
            if place > 0 {
                parts.push(Doc::space());
            }
            // what stands before the name, the name, and behind the last one the parenthesis
            if place == 0 {
                parts.push(self.token());
            }
            parts.push(self.token());
            parts.push(self.token());
        }
    }

    /// `profile NAME(u) in PLANE on [a, b] = CURVE`
    fn curve(&mut self, plane: bool, domain: Option<&Interval>, value: &Expr) -> Doc {
        let mut parts = vec![self.token(), Doc::space()];
        parts.push(Doc::mark(Table::Curves, Column::Name));
        for _name_and_parameter in 0..4 {
            parts.push(self.token());
        }
        parts.push(Doc::space());
        if plane {
            parts.push(Doc::mark(Table::Curves, Column::Plane));
            parts.extend([self.token(), Doc::space(), self.token(), Doc::space()]);
        }
        if let Some(domain) = domain {
            parts.push(Doc::mark(Table::Curves, Column::Domain));
            parts.extend([self.token(), Doc::space()]);
            parts.extend([self.interval(domain), Doc::space()]);
        }
        parts.push(Doc::mark(Table::Curves, Column::Equals));
        parts.push(self.token());
        parts.push(self.value(value));
        Doc::concat(parts)
    }

    /// `[a, b]`
    fn interval(&mut self, interval: &Interval) -> Doc {
        let mut parts = vec![self.token(), self.expression(&interval.start)];
        parts.extend([self.token(), Doc::space()]);
        parts.extend([self.expression(&interval.end), self.token()]);
        Doc::concat(parts)
    }

    /// `construction NAME(p, c) = EXPR` and its `where` below it
    fn construction(&mut self, names: &[Name], body: &Expr, bindings: &[(Name, Expr)]) -> Doc {
        let mut parts = vec![self.token(), Doc::space(), self.token()];
        self.parameters(names, &mut parts);
        parts.extend([Doc::space(), self.token(), self.value(body)]);
        let mut below = Vec::new();
        if !bindings.is_empty() {
            // a comment behind `where` puts the first name below it, in line with the others
            parts.push(Doc::nest(WHERE, Doc::newline()));
            below.extend([self.token(), Doc::space()]);
        }
        for (place, (_, value)) in bindings.iter().enumerate() {
            if place > 0 {
                below.extend([self.token(), Doc::newline()]);
            }
            below.extend([self.token(), Doc::space()]);
            below.push(Doc::mark(Table::Bindings, Column::Equals));
            below.extend([self.token(), self.value(value)]);
        }
        parts.push(Doc::nest(WHERE + BESIDE_WHERE, Doc::concat(below)));
        Doc::concat(parts)
    }

    /// `surface NAME on [a, b] x [c, d] = EXPR`
    fn surface(&mut self, domain: Option<&(Interval, Interval)>, value: &Expr) -> Doc {
        let mut parts = vec![self.token(), Doc::space(), self.token(), Doc::space()];
        if let Some((u, v)) = domain {
            parts.extend([self.token(), Doc::space()]);
            parts.extend([self.interval(u), Doc::space(), self.times()]);
            parts.extend([Doc::space(), self.interval(v), Doc::space()]);
        }
        parts.extend([self.token(), self.value(value)]);
        Doc::concat(parts)
    }

    /// `expect A == B`
    fn expectation(&mut self, left: &Expr, relation: Option<&(Relation, Expr)>) -> Doc {
        let keyword = self.token();
        let mut parts = vec![self.expression(left)];
        if let Some((_, right)) = relation {
            parts.extend([Doc::line(), self.token(), Doc::space()]);
            parts.push(self.expression(right));
        }
        let sides = Doc::group(Doc::nest(INDENT, Doc::concat(parts)));
        Doc::concat(vec![keyword, Doc::space(), sides])
    }
}
