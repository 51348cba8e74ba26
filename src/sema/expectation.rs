use crate::diag::{Code, Diagnostic, Span};
use crate::sweep::{Claim, Expectation, Quality, Quantity, Relation, SweptSurface};
use crate::syntax::ast::{self, Argument, Expr, ExprKind, Name, Reference};

use super::lowerer::{Lowered, Lowerer, Reported};
use super::scope::Scope;
use super::spelling;
use super::value::Value;

/// A side of an expectation before types are compared.
enum Side {
    Quantity(Quantity),
    Value(Value),
}

/// What an expectation may ask of a surface.
pub const QUERIES: [&str; 5] = [
    "bidegree",
    "common_factor",
    "positive_weights",
    "rational_offset",
    "regular",
];

impl<'a> Lowerer<'a> {
    pub(super) fn expectation(
        &mut self,
        text: String,
        span: Span,
        left: &'a Expr,
        relation: Option<&'a (ast::Relation, Expr)>,
        surfaces: &[SweptSurface],
    ) -> Lowered<Expectation> {
        self.mentioned.clear();
        for side in std::iter::once(left).chain(relation.map(|(_, right)| right)) {
            if let Some(finding) = self.conjunction(side) {
                return Err(self.report(finding));
            }
        }
        let claim = match relation {
            None => self.quality(left, surfaces)?,
            Some((relation, right)) => {
                if let Some(finding) = self.compared_quality(left, *relation, right) {
                    return Err(self.report(finding));
                }
                let sides = (self.side(left, surfaces), self.side(right, surfaces));
                self.comparison(
                    (sides.0?, left),
                    relation_of(*relation),
                    (sides.1?, right),
                    span,
                )?
            }
        };
        let mut mentioned = Vec::new();
        for (index, surface) in surfaces.iter().enumerate() {
            if self.mentioned.contains(&surface.name) {
                mentioned.push(index);
            }
        }
        Ok(Expectation {
            text,
            span,
            surfaces: mentioned,
            claim,
        })
    }

    /// E0107 where `and` stands between two claims, as a factor that nothing declares.
    fn conjunction(&self, side: &Expr) -> Option<Diagnostic> {
        let ExprKind::Product(factors) = &side.kind else {
            return None;
        };
        let mut pairs = factors.windows(2);
        let (before, and) = pairs.find_map(|pair| match &pair[1].1.kind {
            ExprKind::Reference(Reference { name, .. })
            | ExprKind::Apply {
                function: Reference { name, .. },
                ..
            } if name.text == "and" && name.span.start == pair[1].1.span.start => {
                Some((pair[0].1.span, name.span))
            }
            _ => None,
        })?;
        if self.definitions.contains("and") {
            return None;
        }
        let message = "`and` does not join claims: these are two expectations";
        let finding = Diagnostic::new(Code::E0107, and, message).help("write an `expect` for each");
        let between = Span {
            start: before.end,
            end: and.start,
            ..and
        };
        Some(
            match self.sources.map.slice(between).contains(['\n', '\r']) {
                true => finding.fix(and, "expect"),
                false => finding.fix(between.to(and), "\nexpect"),
            },
        )
    }

    /// E0107 where a predicate is compared with a truth value: `regular(R) == true`.
    fn compared_quality(
        &self,
        left: &Expr,
        relation: ast::Relation,
        right: &Expr,
    ) -> Option<Diagnostic> {
        let is_quality = |expr: &Expr| {
            plain_call(expr).is_some_and(|(name, ..)| {
                quality_of(&name.text).is_some() && !self.definitions.contains(&name.text)
            })
        };
        let (quality, other) = match (is_quality(left), is_quality(right)) {
            (true, false) => (left, right),
            (false, true) => (right, left),
            (true, true) => (left, right),
            (false, false) => return None,
        };
        let written = self.sources.map.slice(quality.span);
        let message = format!("`{written}` is a statement of its own, it compares with nothing");
        let span = left.span.to(right.span);
        let finding = Diagnostic::new(Code::E0107, span, message);
        let other = self.sources.map.slice(other.span);
        let (affirms, denies) = match relation {
            ast::Relation::Equal => (["true", "1"], ["false", "0"]),
            ast::Relation::NotEqual => (["false", "0"], ["true", "1"]),
            _ => return Some(finding.help(format!("write `expect {written}`"))),
        };
        if denies.contains(&other) {
            return Some(finding.help("a claim cannot be negated"));
        }
        if is_quality(left) && is_quality(right) {
            return Some(finding.help("write an `expect` for each"));
        }
        let finding = finding.help(format!("write `expect {written}`"));
        Some(match affirms.contains(&other) {
            true => finding.fix(span, written),
            false => finding,
        })
    }

    fn quality(&mut self, expr: &'a Expr, surfaces: &[SweptSurface]) -> Lowered<Claim> {
        if let Some((name, arguments, parenthesis)) = plain_call(expr)
            && let Some(quality) = quality_of(&name.text)
        {
            self.check_arguments(name, 1, arguments, parenthesis, &Scope::constant())?;
            let (surface, coordinate) = self.surface_of(&arguments[0].value, surfaces)?;
            if coordinate.is_some() {
                return Err(self.report_not_surface(arguments[0].value.span));
            }
            return Ok(Claim::Quality { quality, surface });
        }
        let message = "an expectation compares two sides or names a quality of a surface";
        let is_negated = self.sources.map.slice(expr.span).starts_with("not ");
        let help = match is_negated && !self.definitions.contains("not") {
            true => "a claim cannot be negated",
            false => "write `A == B`, `regular(R)`, `rational_offset(R)` or `positive_weights(R)`",
        };
        let finding = Diagnostic::new(Code::E0107, expr.span, message).help(help);
        let meant = plain_call(expr).and_then(|(name, ..)| {
            let known = ["positive_weights", "rational_offset", "regular"].into_iter();
            Some((name.span, spelling::nearest(&name.text, known)?))
        });
        Err(self.report(match meant {
            Some((span, meant)) => finding.fix(span, meant),
            None => finding,
        }))
    }

    fn side(&mut self, expr: &'a Expr, surfaces: &[SweptSurface]) -> Lowered<Side> {
        if let Some((name, arguments, parenthesis)) = plain_call(expr)
            && !self.definitions.contains(&name.text)
        {
            let scope = Scope::constant();
            match name.text.as_str() {
                "bidegree" => {
                    self.check_arguments(name, 1, arguments, parenthesis, &scope)?;
                    let (surface, coordinate) = self.surface_of(&arguments[0].value, surfaces)?;
                    return Ok(Side::Quantity(Quantity::BiDegree {
                        surface,
                        coordinate,
                    }));
                }
                "common_factor" => {
                    self.check_arguments(name, 1, arguments, parenthesis, &scope)?;
                    return match self.surface_of(&arguments[0].value, surfaces)? {
                        (surface, None) => Ok(Side::Quantity(Quantity::CommonFactor { surface })),
                        _ => Err(self.report_not_surface(arguments[0].value.span)),
                    };
                }
                _ => {}
            }
        }
        self.value(expr, &Scope::surface()).map(Side::Value)
    }

    /// The surface, by index, that `R` or `R.W` names, and the coordinate.
    fn surface_of(
        &mut self,
        expr: &'a Expr,
        surfaces: &[SweptSurface],
    ) -> Lowered<(usize, Option<usize>)> {
        let ExprKind::Reference(Reference {
            qualifier,
            name,
            primes: 0,
            ..
        }) = &expr.kind
        else {
            return Err(self.report_not_surface(expr.span));
        };
        let surface = qualifier.as_deref().unwrap_or(name);
        if !self.is_surface(surface) {
            return Err(if self.definitions.contains(&surface.text) {
                self.report_not_surface(expr.span)
            } else {
                self.report_unknown(surface, &Scope::constant())
            });
        }
        let coordinate = match qualifier {
            None => None,
            Some(_) => match ["W", "X", "Y", "Z"]
                .iter()
                .position(|own| *own == name.text)
            {
                Some(index) => Some(index),
                None => {
                    let message = format!("a surface has no coordinate `{}`", name.text);
                    let finding = Diagnostic::new(Code::E0111, name.span, message);
                    let finding = finding.help("its homogeneous coordinates are W, X, Y and Z");
                    let upper = name.text.to_uppercase();
                    return Err(self.report(
                        match ["W", "X", "Y", "Z"].contains(&upper.as_str()) {
                            true => finding.fix(name.span, upper),
                            false => finding,
                        },
                    ));
                }
            },
        };
        self.mentioned.push(surface.text.clone());
        match surfaces.iter().position(|own| own.name == surface.text) {
            Some(index) => Ok((index, coordinate)),
            None => {
                // Its own finding has been reported, unless it belongs to an imported file.
                if self.surface(surface).is_ok() {
                    let message = format!("`{}` is a surface of an imported file", surface.text);
                    let finding = Diagnostic::new(Code::E0107, surface.span, message);
                    self.report(finding.help("expect it in its own file"));
                }
                Err(Reported)
            }
        }
    }

    fn report_not_surface(&mut self, span: Span) -> Reported {
        let finding = Diagnostic::new(Code::E0107, span, "the name of a surface is needed here");
        self.report(finding.help("write `R`, or `R.W` for the bidegree of a coordinate"))
    }

    fn comparison(
        &mut self,
        left: (Side, &Expr),
        relation: Relation,
        right: (Side, &Expr),
        span: Span,
    ) -> Lowered<Claim> {
        if let Some(finding) = self.unlike_quantity([&left, &right], relation) {
            return Err(self.report(finding));
        }
        let places = (left.1.span, right.1.span);
        let bidegree = |side: &Side| matches!(side, Side::Quantity(Quantity::BiDegree { .. }));
        if bidegree(&left.0) || bidegree(&right.0) {
            for side in [&left.0, &right.0] {
                if let Side::Value(value) = side {
                    for own in value.components() {
                        self.number(&own, &Scope::constant())?;
                    }
                }
            }
        }
        match incomparable(&left.0, relation, &right.0) {
            None => Ok(Claim::Comparison {
                left: quantity(left.0),
                relation,
                right: quantity(right.0),
            }),
            Some(what) => {
                let finding = Diagnostic::new(Code::E0106, span, what);
                let finding = finding.related(places.0, "one side");
                Err(self.report(finding.related(places.1, "the other")))
            }
        }
    }

    /// E0106 at a value beside a bidegree that is no pair, or beside a common factor that is no
    /// scalar. The degrees are for the author to say, so there is no edit.
    fn unlike_quantity(
        &self,
        sides: [&(Side, &Expr); 2],
        relation: Relation,
    ) -> Option<Diagnostic> {
        let (asked, quantity, value, place) = match sides {
            [(Side::Quantity(own), asked), (Side::Value(value), place)]
            | [(Side::Value(value), place), (Side::Quantity(own), asked)] => {
                (asked, own, value, place)
            }
            _ => return None,
        };
        let (what, kind, form, help) = match (quantity, value) {
            (Quantity::BiDegree { .. }, Value::Pair(_))
            | (Quantity::CommonFactor { .. }, Value::Scalar(_))
            | (Quantity::Value(_), _) => return None,
            (Quantity::BiDegree { .. }, _) => {
                let help = "the degree in u before that in v";
                ("bidegree", "a pair", "(m, n)", help)
            }
            (Quantity::CommonFactor { .. }, _) => {
                let help = "or a polynomial in place of the `1`";
                ("common factor", "a polynomial", "1", help)
            }
        };
        let sign = match relation {
            Relation::NotEqual => "!=",
            _ => "==",
        };
        let written = self.sources.map.slice(asked.span);
        let (left, right) = match asked.span == sides[0].1.span {
            true => (written, form),
            false => (form, written),
        };
        let own = value.type_name();
        let message = format!("a {what} compares with {kind}, and this is {own}");
        let finding = Diagnostic::new(Code::E0106, place.span, message);
        let finding = finding.related(asked.span, kind);
        Some(finding.help(format!("write `{left} {sign} {right}`, {help}")))
    }
}

/// Why two sides do not compare; none if they do.
fn incomparable(left: &Side, relation: Relation, right: &Side) -> Option<String> {
    if let (Side::Value(left), Side::Value(right)) = (left, right) {
        if std::mem::discriminant(left) != std::mem::discriminant(right) {
            let (left, right) = (left.type_name(), right.type_name());
            return Some(format!("{left} is compared with {right}"));
        }
        let ordered = !relation.is_order() || matches!(left, Value::Scalar(_));
        return (!ordered).then(|| format!("{} has no order", left.type_name()));
    }
    let is_bidegree = |side: &Side| match side {
        Side::Quantity(own) => matches!(own, Quantity::BiDegree { .. }),
        Side::Value(value) => matches!(value, Value::Pair(_)),
    };
    if is_bidegree(left) != is_bidegree(right) {
        return Some("a bidegree does not compare with a common factor".to_owned());
    }
    let what = "bidegrees and common factors have no order";
    relation.is_order().then(|| what.to_owned())
}

fn quantity(side: Side) -> Quantity {
    match side {
        Side::Quantity(quantity) => quantity,
        Side::Value(value) => Quantity::Value(value.components()),
    }
}

fn relation_of(relation: ast::Relation) -> Relation {
    match relation {
        ast::Relation::Equal => Relation::Equal,
        ast::Relation::NotEqual => Relation::NotEqual,
        ast::Relation::Less => Relation::Less,
        ast::Relation::LessOrEqual => Relation::LessOrEqual,
        ast::Relation::Greater => Relation::Greater,
        ast::Relation::GreaterOrEqual => Relation::GreaterOrEqual,
    }
}

/// The predicate of that name.
pub(super) fn quality_of(name: &str) -> Option<Quality> {
    match name {
        "rational_offset" => Some(Quality::RationalOffset),
        "positive_weights" => Some(Quality::PositiveWeights),
        "regular" => Some(Quality::Regular),
        _ => None,
    }
}

/// `NAME(…)` with nothing else around it.
fn plain_call(expr: &Expr) -> Option<(&Name, &[Argument], Span)> {
    match &expr.kind {
        ExprKind::Apply {
            function:
                Reference {
                    qualifier: None,
                    name,
                    primes: 0,
                    ..
                },
            arguments,
            parenthesis,
        } => Some((name, arguments, *parenthesis)),
        _ => None,
    }
}
