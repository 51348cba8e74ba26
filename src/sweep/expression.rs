use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::rc::Rc;

use crate::curve::{Axis, Curve, Parameter, Property};
use crate::diag::Span;
use crate::number::{Field, Real};
use crate::poly::UniPoly;

use super::Domain;

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
    facts: Facts,
}

/// What is known of an expression when it is made, so that nobody has to walk through it again.
#[derive(Debug, Clone, Copy, Default)]
struct Facts {
    /// Whether it mentions u, and v.
    depends: [bool; 2],
    /// Whether a root or a normal in it takes its sign from the domain it is used on.
    rooted: bool,
    /// How many expressions are nested in it.
    depth: usize,
    /// What the degrees of its numerator and denominator do not exceed; greatest if not known.
    degree: u32,
}

/// The forms of a scalar expression.
#[derive(Debug, Clone)]
pub enum Form {
    /// A number.
    Constant(Real),
    /// u or v
    Parameter(Parameter),
    /// A polynomial in one parameter that is written in powers: its degree is the highest of them,
    /// and not 0.
    Polynomial(Parameter, UniPoly<Real>),
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
    /// A function whose roots and normals are those on a domain of its own.
    OnDomain(Scalar, Rc<Domain>),
}

impl Form {
    /// Calls a function for every expression that it is made of.
    fn visit<'a>(&'a self, visit: &mut dyn FnMut(&'a Scalar)) {
        match self {
            Self::Constant(_) | Self::Parameter(_) | Self::Polynomial(..) => {}
            Self::Sum(parts) | Self::Product(parts) => parts.iter().for_each(visit),
            Self::Power(own, _)
            | Self::Property(_, own)
            | Self::Partial(_, own)
            | Self::SquareRoot(own)
            | Self::OnDomain(own, _) => visit(own),
            Self::Substitution { body, u, v } => [body, u, v].into_iter().for_each(visit),
            Self::Normal(surface, _) => surface.iter().for_each(visit),
        }
    }

    /// The expressions that it is made of.
    fn parts(&self) -> Vec<&Scalar> {
        let mut parts = Vec::new();
        self.visit(&mut |own| parts.push(own));
        parts
    }

    /// Whether two forms differ at most in their parts.
    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => a == b,
            (Self::Parameter(a), Self::Parameter(b))
            | (Self::Partial(a, _), Self::Partial(b, _)) => a == b,
            (Self::Polynomial(a, p), Self::Polynomial(b, q)) => a == b && p == q,
            (Self::Power(_, a), Self::Power(_, b)) => a == b,
            (Self::Property(a, _), Self::Property(b, _)) => a == b,
            (Self::Normal(_, a), Self::Normal(_, b)) => a == b,
            (Self::OnDomain(_, a), Self::OnDomain(_, b)) => a == b,
            _ => std::mem::discriminant(self) == std::mem::discriminant(other),
        }
    }

    /// A degree that is not exceeded when it is expanded, by the sum of those of its parts: with
    /// n/d + a/b = (n b + a d) / d b that is one for sums, too.
    fn degree(&self, parts: u32) -> u32 {
        let least = |own: usize| u32::try_from(own).unwrap_or(u32::MAX);
        match self {
            Self::Constant(_) => 0,
            Self::Parameter(_) => 1,
            Self::Polynomial(_, own) => least(own.degree().unwrap_or_default()),
            Self::Sum(_) | Self::Product(_) => parts,
            Self::Power(_, exponent) => {
                let exponent = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
                parts.saturating_mul(exponent)
            }
            Self::Property(of, argument) if of.derivative == 0 => {
                let bound = of.curve.property(of.property).map(|own| own.bound);
                match (argument.form(), bound) {
                    (Self::Parameter(_), Ok((above, below))) => least(above.max(below)),
                    _ => u32::MAX,
                }
            }
            _ => u32::MAX,
        }
    }

    fn facts(&self) -> Facts {
        let mut facts = Facts::default();
        self.visit(&mut |part| {
            let own = part.0.facts;
            facts.depth = facts.depth.max(own.depth + 1);
            facts.rooted |= own.rooted;
            facts.depends[0] |= own.depends[0];
            facts.depends[1] |= own.depends[1];
            facts.degree = facts.degree.saturating_add(own.degree);
        });
        facts.degree = self.degree(facts.degree);
        match self {
            Self::Parameter(own) | Self::Polynomial(own, _) => {
                facts.depends = [*own == Parameter::U, *own == Parameter::V];
            }
            Self::SquareRoot(_) | Self::Normal(..) => facts.rooted = true,
            Self::OnDomain(..) => facts.rooted = false,
            Self::Substitution { body, u, v } => {
                let through = |index: usize| {
                    let [in_u, in_v] = body.0.facts.depends;
                    (in_u && u.0.facts.depends[index]) || (in_v && v.0.facts.depends[index])
                };
                facts.depends = [through(0), through(1)];
            }
            _ => {}
        }
        facts
    }
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
        self.is_same(other, &mut HashSet::new())
    }
}

impl Eq for Scalar {}

impl Scalar {
    /// An expression that stands at a place in the source.
    #[must_use]
    pub fn new(span: Span, form: Form) -> Self {
        let facts = form.facts();
        Self(Rc::new(Node { span, form, facts }))
    }

    /// A number.
    #[must_use]
    pub fn constant(span: Span, value: Real) -> Self {
        Self::new(span, Form::Constant(value))
    }

    /// Σ cₖ uᵏ or Σ cₖ vᵏ from ascending coefficients, of degree 1 at least.
    #[must_use]
    pub fn polynomial(span: Span, parameter: Parameter, coefficients: &[Real]) -> Self {
        let polynomial = UniPoly::from_coefficients(coefficients);
        Self::new(span, Form::Polynomial(parameter, polynomial))
    }

    /// Σ cₖ aᵏ
    fn polynomial_of(span: Span, polynomial: &UniPoly<Real>, at: &Self) -> Self {
        if let Form::Parameter(parameter) = at.form() {
            return Self::new(span, Form::Polynomial(*parameter, polynomial.clone()));
        }
        let term = |(power, own): (i64, Real)| {
            let power = match power {
                0 => return Self::constant(span, own),
                1 => at.clone(),
                _ => Self::power(span, at.clone(), power),
            };
            Self::product(span, vec![Self::constant(span, own), power])
        };
        let coefficients = (0..).zip(polynomial.coefficients());
        let terms = coefficients.filter(|(_, own)| !own.is_zero()).map(term);
        Self::sum(span, terms.collect())
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
        if let Some(number) = value.as_number() {
            return Self::constant(span, number.negated());
        }
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

    /// Whether something else holds the expression too, so that it may be asked for again.
    #[must_use]
    pub(super) fn is_shared(&self) -> bool {
        Rc::strong_count(&self.0) > 1
    }

    /// Whether two expressions are written alike; pairs that were seen are not compared again.
    fn is_same(&self, other: &Self, seen: &mut HashSet<(usize, usize)>) -> bool {
        let pair = (self.identity(), other.identity());
        if pair.0 == pair.1 {
            return true;
        }
        if self.depth() == 0 || other.depth() == 0 {
            return self.form().is_like(other.form());
        }
        if !seen.insert(pair) {
            return true;
        }
        let (left, right) = (self.form().parts(), other.form().parts());
        self.form().is_like(other.form())
            && left.len() == right.len()
            && left
                .iter()
                .zip(right)
                .all(|(left, right)| left.is_same(right, seen))
    }

    /// Whether the expression mentions a parameter.
    #[must_use]
    pub fn depends_on(&self, parameter: Parameter) -> bool {
        self.0.facts.depends[match parameter {
            Parameter::U => 0,
            Parameter::V => 1,
        }]
    }

    /// Whether the sign of a root or a normal in it depends on where it is used.
    #[must_use]
    pub fn is_rooted(&self) -> bool {
        self.0.facts.rooted
    }

    /// A degree in either parameter that numerator and denominator do not exceed when it is expanded;
    /// none where it takes more than a sum to tell.
    #[must_use]
    pub(super) fn degree_at_most(&self) -> Option<usize> {
        let degree = self.0.facts.degree;
        (degree < u32::MAX).then(|| usize::try_from(degree).ok())?
    }

    /// How many expressions are nested in it.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.0.facts.depth
    }

    /// Calls a function for every curve that expressions use, with the argument it is used at.
    pub fn visit_curves(of: &[Self], visit: &mut dyn FnMut(&Rc<Curve>, &Self)) {
        let mut seen = BTreeSet::new();
        of.iter().for_each(|own| own.walk(&mut seen, visit));
    }

    fn walk(&self, seen: &mut BTreeSet<usize>, visit: &mut dyn FnMut(&Rc<Curve>, &Self)) {
        if self.depth() == 0 || (self.is_shared() && !seen.insert(self.identity())) {
            return;
        }
        if let Form::Property(property, argument) = self.form() {
            visit(&property.curve, argument);
        }
        self.form().visit(&mut |part| part.walk(seen, visit));
    }

    /// The expression with u and v replaced: at once where nothing is differentiated, else as a
    /// [`Form::Substitution`]. What is shared stays shared.
    #[must_use]
    pub fn substitute(&self, u: &Self, v: &Self) -> Self {
        self.replace(u, v, &mut BTreeMap::new())
    }

    fn replace(&self, u: &Self, v: &Self, known: &mut BTreeMap<usize, Self>) -> Self {
        let stays = |parameter, by: &Self| {
            !self.depends_on(parameter)
                || matches!(by.form(), Form::Parameter(own) if *own == parameter)
        };
        if stays(Parameter::U, u) && stays(Parameter::V, v) {
            return self.clone();
        }
        if let Some(known) = known.get(&self.identity()) {
            return known.clone();
        }
        let span = self.span();
        let mut replace = |part: &Self| part.replace(u, v, known);
        let replaced = match self.form() {
            Form::Constant(_) => self.clone(),
            Form::Parameter(Parameter::U) => u.clone(),
            Form::Parameter(Parameter::V) => v.clone(),
            Form::Polynomial(parameter, own) => {
                let at = match parameter {
                    Parameter::U => u,
                    Parameter::V => v,
                };
                Self::polynomial_of(span, own, at)
            }
            Form::Sum(parts) => Self::sum(span, parts.iter().map(replace).collect()),
            Form::Product(parts) => Self::product(span, parts.iter().map(replace).collect()),
            Form::Power(base, exponent) => Self::power(span, replace(base), *exponent),
            Form::Property(property, argument) => {
                Self::new(span, Form::Property(property.clone(), replace(argument)))
            }
            Form::SquareRoot(base) => Self::new(span, Form::SquareRoot(replace(base))),
            _ => {
                let (body, u, v) = (self.clone(), u.clone(), v.clone());
                Self::new(span, Form::Substitution { body, u, v })
            }
        };
        known.insert(self.identity(), replaced.clone());
        replaced
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
    let count = parts.iter().filter(|own| own.as_number().is_some()).count();
    if count == 0 || (count == 1 && parts.len() == 1) {
        return if parts.is_empty() {
            vec![Scalar::constant(span, neutral.clone())]
        } else {
            parts
        };
    }
    let leads = |own: &Scalar| own.as_number().is_some_and(|own| own != neutral);
    if count == 1 && parts.first().is_some_and(leads) {
        return parts;
    }
    let mut value: Option<Real> = None;
    let mut rest = Vec::with_capacity(parts.len());
    for part in parts {
        match part.as_number() {
            None => rest.push(part),
            Some(own) => {
                value = Some(match value {
                    Some(known) => join(&known, own),
                    None => own.clone(),
                });
            }
        }
    }
    match value {
        Some(value) if rest.is_empty() || value != *neutral => {
            rest.insert(0, Scalar::constant(span, value));
            rest
        }
        _ => rest,
    }
}
