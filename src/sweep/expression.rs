use std::collections::HashSet;
use std::rc::Rc;

use crate::curve::{Axis, Curve, Parameter, Property};
use crate::diag::Span;
use crate::number::{Field, Real};

/// A vector expression: three scalar expressions.
pub type Vector = [Scalar; 3];

/// A scalar expression in u and v, shared where it occurs more than once.
///
/// Names, functions and constructions are gone; what is left are numbers, the parameters,
/// arithmetic, and properties of curves. Two expressions are equal if they are written alike,
/// wherever they stand.
#[derive(Debug, Clone)]
pub struct Scalar(Rc<Node>);

#[derive(Debug)]
struct Node {
    span: Span,
    form: Form,
}

/// The forms of a scalar expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Form {
    /// A number.
    Constant(Real),
    /// u or v
    Parameter(Parameter),
    /// a + b + …
    Sum(Vec<Scalar>),
    /// a b …
    Product(Vec<Scalar>),
    /// aⁿ for n of either sign; a quotient is a product with a power −1
    Power(Scalar, i64),
    /// A property of a curve at an argument.
    Property(CurveProperty, Scalar),
    /// ∂a/∂u or ∂a/∂v
    Partial(Parameter, Scalar),
    /// a(φ, ψ), after all derivatives in a are taken
    Substitution {
        /// a
        body: Scalar,
        /// φ
        u: Scalar,
        /// ψ
        v: Scalar,
    },
    /// The root that is not negative on the domain.
    SquareRoot(Scalar),
    /// A coordinate of the unit normal R_u × R_v / ‖R_u × R_v‖ of a surface.
    Normal(Rc<Vector>, Axis),
}

/// A property of a curve, or a derivative of one by the curve's parameter.
#[derive(Debug, Clone)]
pub struct CurveProperty {
    /// The curve.
    pub curve: Rc<Curve>,
    /// The property.
    pub property: Property,
    /// How often it is differentiated.
    pub derivative: u32,
}

impl PartialEq for CurveProperty {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.curve, &other.curve)
            && (self.property, self.derivative) == (other.property, other.derivative)
    }
}

impl Eq for CurveProperty {}

impl PartialEq for Scalar {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.0, &other.0) || self.0.form == other.0.form
    }
}

impl Eq for Scalar {}

impl Scalar {
    /// An expression that stands at a place in the source.
    #[must_use]
    pub fn new(span: Span, form: Form) -> Self {
        Self(Rc::new(Node { span, form }))
    }

    /// A number.
    #[must_use]
    pub fn constant(span: Span, value: Real) -> Self {
        Self::new(span, Form::Constant(value))
    }

    /// a + b + …; numbers are added at once.
    #[must_use]
    pub fn sum(span: Span, terms: Vec<Self>) -> Self {
        let terms = fold(span, terms, &Real::zero(), |left, right| left + right);
        match terms.as_slice() {
            [only] => only.clone(),
            _ => Self::new(span, Form::Sum(terms)),
        }
    }

    /// a b …; numbers are multiplied at once.
    #[must_use]
    pub fn product(span: Span, factors: Vec<Self>) -> Self {
        let factors = fold(span, factors, &Real::one(), |left, right| left * right);
        match factors.as_slice() {
            [only] => only.clone(),
            _ => Self::new(span, Form::Product(factors)),
        }
    }

    /// aⁿ; a power of a number is a number, but 0 to a negative power stays as it is and is
    /// found when it is expanded.
    #[must_use]
    pub fn power(span: Span, base: Self, exponent: i64) -> Self {
        match base.as_number().and_then(|number| number.power(exponent)) {
            Some(value) => Self::constant(span, value),
            None => Self::new(span, Form::Power(base, exponent)),
        }
    }

    /// a / b
    #[must_use]
    pub fn quotient(span: Span, numerator: Self, denominator: Self) -> Self {
        let inverse = Self::power(denominator.span(), denominator, -1);
        Self::product(span, vec![numerator, inverse])
    }

    /// −a
    #[must_use]
    pub fn negated(span: Span, value: &Self) -> Self {
        Self::product(
            span,
            vec![Self::constant(span, Real::from(-1)), value.clone()],
        )
    }

    /// Where it stands in the source.
    #[must_use]
    pub fn span(&self) -> Span {
        self.0.span
    }

    /// What it is.
    #[must_use]
    pub fn form(&self) -> &Form {
        &self.0.form
    }

    /// The number, if it is written as one.
    #[must_use]
    pub fn as_number(&self) -> Option<&Real> {
        match self.form() {
            Form::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// An identity of the shared node, the same for every clone.
    #[must_use]
    pub(super) fn identity(&self) -> usize {
        Rc::as_ptr(&self.0).addr()
    }

    /// Whether the expression mentions a parameter.
    #[must_use]
    pub fn depends_on(&self, parameter: Parameter) -> bool {
        match self.form() {
            Form::Constant(_) => false,
            Form::Parameter(own) => *own == parameter,
            Form::Sum(parts) | Form::Product(parts) => {
                parts.iter().any(|part| part.depends_on(parameter))
            }
            Form::Power(base, _) | Form::SquareRoot(base) | Form::Partial(_, base) => {
                base.depends_on(parameter)
            }
            Form::Property(_, argument) => argument.depends_on(parameter),
            Form::Substitution { body, u, v } => {
                (body.depends_on(Parameter::U) && u.depends_on(parameter))
                    || (body.depends_on(Parameter::V) && v.depends_on(parameter))
            }
            Form::Normal(surface, _) => surface.iter().any(|part| part.depends_on(parameter)),
        }
    }

    /// Calls a function for every curve that the expression uses, with the argument it is used at.
    pub fn visit_curves(&self, visit: &mut dyn FnMut(&Rc<Curve>, &Self)) {
        self.walk(&mut HashSet::new(), visit);
    }

    fn walk(&self, seen: &mut HashSet<usize>, visit: &mut dyn FnMut(&Rc<Curve>, &Self)) {
        if !seen.insert(self.identity()) {
            return;
        }
        match self.form() {
            Form::Constant(_) | Form::Parameter(_) => {}
            Form::Sum(parts) | Form::Product(parts) => {
                for part in parts {
                    part.walk(seen, visit);
                }
            }
            Form::Power(base, _) | Form::SquareRoot(base) | Form::Partial(_, base) => {
                base.walk(seen, visit);
            }
            Form::Property(property, argument) => {
                visit(&property.curve, argument);
                argument.walk(seen, visit);
            }
            Form::Substitution { body, u, v } => {
                for part in [body, u, v] {
                    part.walk(seen, visit);
                }
            }
            Form::Normal(surface, _) => {
                for part in surface.iter() {
                    part.walk(seen, visit);
                }
            }
        }
    }

    /// The expression with u and v replaced: at once where nothing is differentiated, else as a
    /// [`Form::Substitution`].
    #[must_use]
    pub fn substitute(&self, u: &Self, v: &Self) -> Self {
        let span = self.span();
        let replace = |part: &Self| part.substitute(u, v);
        match self.form() {
            Form::Constant(_) => self.clone(),
            Form::Parameter(Parameter::U) => u.clone(),
            Form::Parameter(Parameter::V) => v.clone(),
            Form::Sum(parts) => Self::sum(span, parts.iter().map(replace).collect()),
            Form::Product(parts) => Self::product(span, parts.iter().map(replace).collect()),
            Form::Power(base, exponent) => Self::power(span, replace(base), *exponent),
            Form::Property(property, argument) => {
                Self::new(span, Form::Property(property.clone(), replace(argument)))
            }
            Form::SquareRoot(base) => Self::new(span, Form::SquareRoot(replace(base))),
            Form::Partial(..) | Form::Substitution { .. } | Form::Normal(..) => Self::new(
                span,
                Form::Substitution {
                    body: self.clone(),
                    u: u.clone(),
                    v: v.clone(),
                },
            ),
        }
    }
}

/// Gathers the numbers among the parts into one, in the place of the first of them; a neutral one
/// is left out beside other parts.
fn fold(
    span: Span,
    parts: Vec<Scalar>,
    neutral: &Real,
    join: impl Fn(&Real, &Real) -> Real,
) -> Vec<Scalar> {
    let numbers = parts.iter().filter_map(Scalar::as_number);
    let value = numbers.fold(neutral.clone(), |value, own| join(&value, own));
    let rest: Vec<Scalar> = parts
        .iter()
        .filter(|own| own.as_number().is_none())
        .cloned()
        .collect();
    if rest.is_empty() {
        return vec![Scalar::constant(span, value)];
    }
    if value == *neutral {
        return rest;
    }
    std::iter::once(Scalar::constant(span, value))
        .chain(rest)
        .collect()
}
