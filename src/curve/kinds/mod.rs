//! The curve constructors of the language. A new kind is one file and one line in [`ALL`].

mod bezier;
mod line;
mod ph;

use crate::number::Real;
use crate::poly::UniPoly;

use super::{Interval, Plane};

/// The constructors.
pub const ALL: &[Kind] = &[bezier::KIND, line::KIND, ph::KIND];

/// Names of constructors that the language keeps for later versions.
pub const RESERVED: &[&str] = &[
    "arc",
    "bspline",
    "circle",
    "envelope",
    "join",
    "motion",
    "ph3",
    "ph_hermite",
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
    pub build: fn(&Arguments, &Interval) -> Result<Coordinates, String>,
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
}

impl Coordinates {
    /// The coordinates in space: pairs are placed in a plane's axes.
    #[must_use]
    pub fn in_space(&self, plane: Option<Plane>) -> Option<super::Homogeneous> {
        let mut coordinates = [UniPoly::zero(), UniPoly::zero(), UniPoly::zero()];
        match (self.numerators.as_slice(), plane) {
            ([a, b], Some(plane)) => {
                let (first, second) = plane.axes();
                coordinates[first.index()] = a.clone();
                coordinates[second.index()] = b.clone();
            }
            ([x, y, z], None) => coordinates = [x.clone(), y.clone(), z.clone()],
            _ => return None,
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
