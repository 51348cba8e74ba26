//! Degrees by counting: what a paper prints before anything is multiplied out.

use std::collections::HashMap;
use std::fmt;
use std::rc::Rc;

use crate::curve::{Axis, Curve, Parameter, Property};
use crate::poly::BiDegree;

use super::{CurveProperty, Form, Scalar, Vector};

/// The bidegrees of W, X, Y, Z by counting; none for a coordinate that is zero as written.
pub type DegreeBound = [Option<BiDegree>; 4];

/// Counts the degrees of a surface's formula: products add, sums take the maximum over the least
/// common multiple of the denominators as symbols, nothing cancels.
#[must_use]
pub fn degree_bound(coordinates: &Vector) -> DegreeBound {
    Counter::default().bound(coordinates)
}

/// d + whole − part
fn raise(degree: BiDegree, whole: BiDegree, part: BiDegree) -> BiDegree {
    BiDegree::new(degree.u + whole.u - part.u, degree.v + whole.v - part.v)
}

/// A part of a formula that is known by what it is, not by its coefficients.
#[derive(Clone, PartialEq, Eq)]
enum Symbol {
    /// The numerator of an expression as it is written.
    Numerator(Scalar),
    /// The denominator of an expression that is not broken up any further.
    Denominator(Scalar),
    /// A part of a curve at an argument.
    Curve(CurveSymbol, Scalar),
}

#[derive(Clone)]
struct CurveSymbol {
    curve: Rc<Curve>,
    part: Part,
}

impl PartialEq for CurveSymbol {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.curve, &other.curve) && self.part == other.part
    }
}

impl Eq for CurveSymbol {}

/// The polynomials that the properties of a curve are made of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Position(Axis),
    Weight,
    Hodograph(Axis),
    HodographWeight,
    Speed,
    ArcLength,
    ArcLengthWeight,
    Turning,
    Derived(Property, u32),
}

#[derive(Clone)]
struct Factor {
    symbol: Symbol,
    degree: BiDegree,
    exponent: usize,
}

/// A product of powers of symbols.
#[derive(Clone, Default)]
struct Factors(Vec<Factor>);

impl Factors {
    fn one(symbol: Symbol, degree: BiDegree) -> Self {
        Self(vec![Factor {
            symbol,
            degree,
            exponent: 1,
        }])
    }

    fn degree(&self) -> BiDegree {
        self.0.iter().fold(BiDegree::default(), |sum, own| {
            sum.plus(times(own.degree, own.exponent))
        })
    }

    fn merge(&mut self, other: &Self, join: impl Fn(usize, usize) -> usize) {
        for factor in &other.0 {
            match self.0.iter_mut().find(|own| own.symbol == factor.symbol) {
                Some(own) => {
                    own.exponent = join(own.exponent, factor.exponent);
                    own.degree = own.degree.max(factor.degree);
                }
                None => self.0.push(factor.clone()),
            }
        }
    }

    fn multiply(&mut self, other: &Self) {
        self.merge(other, usize::saturating_add);
    }

    /// The least common multiple, in the place of the first.
    fn raise_to(&mut self, other: &Self) {
        self.merge(other, usize::max);
    }

    fn times(mut self, other: &Self) -> Self {
        self.multiply(other);
        self
    }

    fn power(&self, exponent: usize) -> Self {
        let mut power = self.clone();
        for factor in &mut power.0 {
            factor.exponent = factor.exponent.saturating_mul(exponent);
        }
        power
    }
}

fn times(degree: BiDegree, factor: usize) -> BiDegree {
    BiDegree::new(
        degree.u.saturating_mul(factor),
        degree.v.saturating_mul(factor),
    )
}

/// A fraction of which only degrees and denominators are known. Its numerator is none where it
/// is zero as written.
#[derive(Clone)]
struct Counted {
    numerator: Option<Factors>,
    denominator: Factors,
}

impl Counted {
    fn multiply(&mut self, other: &Self) {
        match (&mut self.numerator, &other.numerator) {
            (Some(own), Some(other)) => own.multiply(other),
            (own, _) => *own = None,
        }
        self.denominator.multiply(&other.denominator);
    }
}

/// Counts; what is shared is counted once.
#[derive(Default)]
pub(super) struct Counter {
    /// The expression is kept beside its count, so that its identity stays its own.
    counted: HashMap<usize, (Scalar, Rc<Counted>)>,
}

impl fmt::Debug for Counter {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Counter").finish_non_exhaustive()
    }
}

impl Counter {
    /// The bidegrees of W, X, Y, Z.
    pub(super) fn bound(&mut self, coordinates: &Vector) -> DegreeBound {
        let counted = coordinates.each_ref().map(|own| self.count(own));
        let mut common = Factors::default();
        for own in &counted {
            common.raise_to(&own.denominator);
        }
        let weight = common.degree();
        let over = |own: &Rc<Counted>| {
            let numerator = own.numerator.as_ref()?;
            Some(raise(numerator.degree(), weight, own.denominator.degree()))
        };
        let [x, y, z] = counted.each_ref().map(over);
        [Some(weight), x, y, z]
    }

    /// The largest bidegree that occurs when an expression is expanded.
    pub(super) fn largest(&mut self, expression: &Scalar) -> BiDegree {
        let counted = self.count(expression);
        let top = counted.numerator.as_ref().map(Factors::degree);
        top.unwrap_or_default().max(counted.denominator.degree())
    }

    fn count(&mut self, expression: &Scalar) -> Rc<Counted> {
        if !expression.is_shared() {
            return Rc::new(self.count_form(expression));
        }
        if let Some((_, counted)) = self.counted.get(&expression.identity()) {
            return Rc::clone(counted);
        }
        let counted = Rc::new(self.count_form(expression));
        let entry = (expression.clone(), Rc::clone(&counted));
        self.counted.insert(expression.identity(), entry);
        counted
    }

    fn count_form(&mut self, expression: &Scalar) -> Counted {
        let constant = |zero: bool| Counted {
            numerator: (!zero).then(Factors::default),
            denominator: Factors::default(),
        };
        match expression.form() {
            Form::Constant(value) => constant(crate::number::Field::is_zero(value)),
            Form::Parameter(parameter) => powers(expression, *parameter, 1),
            Form::Polynomial(parameter, own) => {
                powers(expression, *parameter, own.degree().unwrap_or_default())
            }
            Form::Sum(terms) => self.sum(expression, terms),
            Form::Product(factors) => {
                let mut product = constant(false);
                for own in factors {
                    product.multiply(&self.count(own));
                }
                product
            }
            Form::Power(base, exponent) => {
                let base = self.count(base);
                let size = usize::try_from(exponent.unsigned_abs()).unwrap_or(usize::MAX);
                let top = base.numerator.as_ref().map(|own| own.power(size));
                let bottom = base.denominator.power(size);
                if *exponent < 0 {
                    Counted {
                        numerator: Some(bottom),
                        denominator: top.unwrap_or_default(),
                    }
                } else {
                    Counted {
                        numerator: top,
                        denominator: bottom,
                    }
                }
            }
            Form::Property(property, argument) => {
                count_property(property, argument, &self.count(argument))
            }
            Form::Partial(_, body) => derivative(expression, &self.count(body)),
            Form::Substitution { body, u, v } => substitution(
                expression,
                &self.count(body),
                &self.count(u),
                &self.count(v),
            ),
            Form::SquareRoot(body) => root(expression, &self.count(body)),
            Form::Normal(surface, _) => normal(expression, surface),
            Form::OnDomain(body, _) => (*self.count(body)).clone(),
        }
    }

    fn sum(&mut self, expression: &Scalar, terms: &[Scalar]) -> Counted {
        let terms: Vec<Rc<Counted>> = terms.iter().map(|own| self.count(own)).collect();
        let mut denominator = Factors::default();
        for own in &terms {
            denominator.raise_to(&own.denominator);
        }
        let whole = denominator.degree();
        let degree = terms
            .iter()
            .filter_map(|own| {
                Some(raise(
                    own.numerator.as_ref()?.degree(),
                    whole,
                    own.denominator.degree(),
                ))
            })
            .reduce(BiDegree::max);
        Counted {
            numerator: degree
                .map(|degree| Factors::one(Symbol::Numerator(expression.clone()), degree)),
            denominator,
        }
    }
}

/// A polynomial in one parameter.
fn powers(expression: &Scalar, parameter: Parameter, degree: usize) -> Counted {
    let degree = match parameter {
        Parameter::U => BiDegree::new(degree, 0),
        Parameter::V => BiDegree::new(0, degree),
    };
    Counted {
        numerator: Some(Factors::one(Symbol::Numerator(expression.clone()), degree)),
        denominator: Factors::default(),
    }
}

/// A fraction of the same degrees whose parts are not known any further.
fn opaque(expression: &Scalar, of: &Counted) -> Counted {
    let symbol = |make: fn(Scalar) -> Symbol, degree: BiDegree| {
        Factors::one(make(expression.clone()), degree)
    };
    Counted {
        numerator: of
            .numerator
            .as_ref()
            .map(|own| symbol(Symbol::Numerator, own.degree())),
        denominator: symbol(Symbol::Denominator, of.denominator.degree()),
    }
}

/// A root of a fraction in lowest terms: both parts are squares.
fn root(expression: &Scalar, of: &Counted) -> Counted {
    let half = |degree: BiDegree| BiDegree::new(degree.u / 2, degree.v / 2);
    let symbol = |make: fn(Scalar) -> Symbol, own: &Factors| {
        Factors::one(make(expression.clone()), half(own.degree()))
    };
    Counted {
        numerator: of
            .numerator
            .as_ref()
            .map(|own| symbol(Symbol::Numerator, own)),
        denominator: symbol(Symbol::Denominator, &of.denominator),
    }
}

/// (N′D − ND′)/D²; over a constant D only N′.
fn derivative(expression: &Scalar, of: &Counted) -> Counted {
    let bottom = of.denominator.degree();
    let numerator = of.numerator.as_ref().map(|own| {
        Factors::one(
            Symbol::Numerator(expression.clone()),
            own.degree().plus(bottom),
        )
    });
    Counted {
        numerator,
        denominator: of.denominator.power(2),
    }
}

/// Numerator and denominator as forms in the parts of the arguments.
fn substitution(expression: &Scalar, body: &Counted, u: &Counted, v: &Counted) -> Counted {
    let size = |own: &Counted| {
        own.numerator
            .as_ref()
            .map(Factors::degree)
            .unwrap_or_default()
            .max(own.denominator.degree())
    };
    let (in_u, in_v) = (size(u), size(v));
    let image = |degree: BiDegree| times(in_u, degree.u).plus(times(in_v, degree.v));
    let top = body
        .numerator
        .as_ref()
        .map(Factors::degree)
        .unwrap_or_default();
    let high = image(top.max(body.denominator.degree()));
    opaque(
        expression,
        &Counted {
            numerator: body
                .numerator
                .as_ref()
                .map(|_| Factors::one(Symbol::Numerator(expression.clone()), high)),
            denominator: Factors::one(Symbol::Denominator(expression.clone()), high),
        },
    )
}

/// Three times the surface in both numerator and denominator: M/√|M|², whose three coordinates share
/// their denominator.
fn normal(expression: &Scalar, surface: &Rc<Vector>) -> Counted {
    let degree = degree_bound(surface)
        .into_iter()
        .flatten()
        .fold(BiDegree::default(), BiDegree::max);
    let degree = times(degree, 3);
    let first = Form::Normal(Rc::clone(surface), Axis::X);
    let shared = Symbol::Denominator(Scalar::new(expression.span(), first));
    Counted {
        numerator: Some(Factors::one(Symbol::Numerator(expression.clone()), degree)),
        denominator: Factors::one(shared, degree),
    }
}

type Parts = Vec<(Part, usize, usize)>;

/// The parts of a property with degree and exponent: numerator and denominator.
/// The numerator is none where a plane curve has no such coordinate.
fn parts(of: &CurveProperty) -> Option<(Option<Parts>, Parts)> {
    let function = of.curve.property(of.property).ok()?;
    let (top, bottom) = function.bound;
    let absent = |axis: Axis| {
        of.curve.plane().is_some_and(|plane| {
            let (first, second) = plane.axes();
            axis != first && axis != second
        })
    };
    let weight = |part: Part, degree: usize| {
        if degree == 0 {
            vec![]
        } else {
            vec![(part, degree, 1)]
        }
    };
    Some(match of.property {
        Property::Position(axis) => (
            (!absent(axis)).then(|| vec![(Part::Position(axis), top, 1)]),
            weight(Part::Weight, bottom),
        ),
        Property::Hodograph(axis) => (
            (!absent(axis)).then(|| vec![(Part::Hodograph(axis), top, 1)]),
            weight(Part::HodographWeight, bottom),
        ),
        Property::Speed => (
            Some(vec![(Part::Speed, top, 1)]),
            weight(Part::HodographWeight, bottom),
        ),
        Property::ArcLength => (
            Some(vec![(Part::ArcLength, top, 1)]),
            weight(Part::ArcLengthWeight, bottom),
        ),
        Property::Tangent(axis) | Property::Normal(axis) => (
            (!absent(axis)).then(|| vec![(Part::Hodograph(axis), top, 1)]),
            vec![(Part::Speed, bottom, 1)],
        ),
        Property::Curvature => (
            Some(vec![(Part::Turning, top, 1)]),
            vec![(Part::Speed, bottom / 2, 2)],
        ),
        Property::RadiusOfCurvature => (
            Some(vec![(Part::Speed, top / 2, 2)]),
            vec![(Part::Turning, bottom, 1)],
        ),
    })
}

/// The degree of a product of parts.
fn total(parts: &Parts) -> usize {
    let degrees = parts.iter().map(|(_, degree, exponent)| degree * exponent);
    degrees.sum()
}

/// The parts of a derivative of a property, by the quotient rule.
fn derived_parts(of: &CurveProperty) -> Option<(Option<Parts>, Parts)> {
    let (mut top, mut bottom) = parts(of)?;
    for order in 1..=of.derivative {
        let below = total(&bottom);
        top = top.map(|top| {
            let degree = (total(&top) + below).saturating_sub(1);
            vec![(Part::Derived(of.property, order), degree, 1)]
        });
        for (_, _, exponent) in &mut bottom {
            *exponent *= 2;
        }
    }
    Some((top, bottom))
}

fn count_property(of: &CurveProperty, argument: &Scalar, inner: &Counted) -> Counted {
    let Some((top, bottom)) = derived_parts(of) else {
        return Counted {
            numerator: Some(Factors::default()),
            denominator: Factors::default(),
        };
    };
    let above = inner.numerator.as_ref().map(Factors::degree);
    let size = above.unwrap_or_default().max(inner.denominator.degree());
    let factors = |parts: &Parts| {
        let factor = |&(part, degree, exponent): &(Part, usize, usize)| {
            let curve = Rc::clone(&of.curve);
            Factor {
                symbol: Symbol::Curve(CurveSymbol { curve, part }, argument.clone()),
                degree: times(size, degree),
                exponent,
            }
        };
        Factors(parts.iter().map(factor).collect())
    };
    let (high, low) = (top.as_ref().map_or(0, total), total(&bottom));
    // bⁿ N(a/b) / bᵐ D(a/b): the surplus power of b stays on one side.
    let surplus_below = inner.denominator.power(high.saturating_sub(low));
    let surplus_above = inner.denominator.power(low.saturating_sub(high));
    Counted {
        numerator: top.map(|parts| factors(&parts).times(&surplus_above)),
        denominator: factors(&bottom).times(&surplus_below),
    }
}
