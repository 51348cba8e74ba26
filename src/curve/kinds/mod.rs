//! The curve constructors of the language. A new kind is one file and one line in [`ALL`].

mod arc;
mod bezier;
mod line;
mod ph;
mod ph_hermite;

use crate::number::{Real, RootFault, Tower};
use crate::poly::UniPoly;

use super::{Interpolant, Interval, Plane, Preimage};

/// The constructors.
pub const ALL: &[Kind] = &[
    arc::KIND,
    bezier::KIND,
    line::KIND,
    ph::KIND,
    ph_hermite::KIND,
];

/// Names of constructors that the language keeps for later versions.
pub const RESERVED: &[&str] = &[
    "bspline",
    "circle",
    "envelope",
    "join",
    "motion",
    "ph3",
    "ph_spline",
    "re_hermite",
    "rrmf",
    "solid",
];

/// A curve constructor of the language.
#[derive(Debug, Clone, Copy)]
pub struct Kind {
    /// The word in the language.
    pub name: &'static str,
    /// What one writes, for messages.
    pub usage: &'static str,
    /// The arguments, in order.
    pub slots: &'static [Slot],
    /// Builds the coordinates.
    pub build: fn(&Arguments, &Setting<'_>) -> Result<Coordinates, BuildFault>,
}

/// Where a curve is built.
#[derive(Debug, Clone, Copy)]
pub struct Setting<'a> {
    /// The domain of its parameter.
    pub domain: &'a Interval,
    /// The field, which grows where the curve needs square roots.
    pub tower: &'a Tower,
}

/// Why a constructor does not give a curve.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BuildFault {
    /// The arguments do not describe one, in words.
    Malformed(String),
    /// A square root would extend the field beyond the limit on its degree.
    FieldDegree,
}

impl BuildFault {
    fn malformed(message: &str) -> Self {
        Self::Malformed(message.to_owned())
    }
}

impl From<RootFault> for BuildFault {
    fn from(fault: RootFault) -> Self {
        match fault {
            RootFault::Negative => Self::malformed("a square root of a negative number"),
            RootFault::DegreeLimit { .. } => Self::FieldDegree,
        }
    }
}

/// What an argument of a constructor looks like.
#[derive(Debug, Clone, Copy)]
pub struct Slot {
    /// The label, if it is written `label: value`.
    pub label: Option<&'static str>,
    /// What the value is.
    pub shape: Shape,
    /// Whether it may be left out.
    pub optional: bool,
}

impl Slot {
    const fn positional(shape: Shape) -> Self {
        Self {
            label: None,
            shape,
            optional: false,
        }
    }

    const fn labelled(label: &'static str, shape: Shape) -> Self {
        Self {
            label: Some(label),
            shape,
            optional: false,
        }
    }

    const fn optional(label: &'static str, shape: Shape) -> Self {
        Self {
            label: Some(label),
            shape,
            optional: true,
        }
    }
}

/// The shape of a constructor's argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A constant scalar.
    Number,
    /// A point: a pair for a plane curve, else a triple.
    Point,
    /// A list of points.
    Points,
    /// A list of pairs of scalars that are not points.
    Pairs,
    /// A list of scalars.
    Numbers,
    /// A bare word or a string.
    Word,
}

/// The value of a constructor's argument. A point is a list of two or three coordinates.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Value {
    /// A constant scalar.
    Number(Real),
    /// A point.
    Point(Vec<Real>),
    /// Points, or pairs.
    Points(Vec<Vec<Real>>),
    /// Scalars.
    Numbers(Vec<Real>),
    /// A word.
    Word(String),
}

/// The values of all slots, in order; none where an optional one was left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Arguments(pub Vec<Option<Value>>);

impl Arguments {
    fn number(&self, slot: usize) -> Option<&Real> {
        match self.0.get(slot)? {
            Some(Value::Number(number)) => Some(number),
            _ => None,
        }
    }

    fn point(&self, slot: usize) -> &[Real] {
        match self.0.get(slot) {
            Some(Some(Value::Point(point))) => point,
            _ => &[],
        }
    }

    fn points(&self, slot: usize) -> &[Vec<Real>] {
        match self.0.get(slot) {
            Some(Some(Value::Points(points))) => points,
            _ => &[],
        }
    }

    fn word(&self, slot: usize) -> Option<&str> {
        match self.0.get(slot)? {
            Some(Value::Word(word)) => Some(word),
            _ => None,
        }
    }

    fn numbers(&self, slot: usize) -> Option<&[Real]> {
        match self.0.get(slot)? {
            Some(Value::Numbers(numbers)) => Some(numbers),
            _ => None,
        }
    }
}

/// The coordinates of a curve over a weight: two in a plane's axes (e₁, e₂), or three.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coordinates {
    /// The common denominator.
    pub weight: UniPoly<Real>,
    /// Two or three numerators.
    pub numerators: Vec<UniPoly<Real>>,
    /// The hodograph, where the curve was built from it.
    pub slopes: Option<[UniPoly<Real>; 2]>,
    /// The preimage of the hodograph, where the curve was built from it.
    pub preimage: Option<Preimage>,
    /// Which interpolant of Hermite data the curve is.
    pub interpolant: Option<Interpolant>,
}

impl Coordinates {
    /// Rational coordinates.
    #[must_use]
    pub fn rational(weight: UniPoly<Real>, numerators: Vec<UniPoly<Real>>) -> Self {
        Self {
            weight,
            numerators,
            slopes: None,
            preimage: None,
            interpolant: None,
        }
    }

    /// The plane curve r with r′ = g ω² from a start, by its preimage.
    #[must_use]
    pub fn pythagorean(preimage: Preimage, start: &[Real; 2], domain: &Interval) -> Self {
        let slopes = preimage.hodograph();
        let coordinates = slopes.iter().zip(start);
        let numerators = coordinates
            .map(|(slope, start)| slope.antiderivative_from(domain.start(), start))
            .collect();
        Self {
            slopes: Some(slopes),
            preimage: Some(preimage),
            ..Self::rational(UniPoly::one(), numerators)
        }
    }

    /// The coordinates in space: pairs are placed in a plane's axes.
    #[must_use]
    pub fn in_space(&self, plane: Option<Plane>) -> Option<super::Homogeneous> {
        let coordinates = match (self.numerators.as_slice(), plane) {
            ([a, b], Some(plane)) => plane.in_space([a.clone(), b.clone()], UniPoly::zero()),
            ([x, y, z], None) => [x.clone(), y.clone(), z.clone()],
            _ => return None,
        };
        if self.weight.is_one() {
            return Some(super::Homogeneous::polynomial(coordinates));
        }
        let scale = self.weight.primitive();
        let ratio = self.weight.leading_coefficient();
        let factor = crate::number::Field::inverse(&ratio)?;
        let factor = &scale.leading_coefficient() * &factor;
        Some(super::Homogeneous {
            weight: scale,
            coordinates: coordinates.map(|own| own.scale(&factor)),
        })
    }
}
