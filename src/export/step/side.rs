use crate::export::Double;
use crate::number::{Field, Real};

use super::entities::Id;

/// Points closer than 1/NEARNESS coincide for readers, in the unit of length.
const NEARNESS: i64 = 10_000_000;

/// One side of a patch: the control points along it, by the rising parameter.
pub(super) struct Side {
    /// Whether u runs along it, or v.
    pub(super) along_u: bool,
    /// The control points as entities.
    pub(super) points: Vec<Id>,
    /// The control points.
    pub(super) places: Vec<[Double; 3]>,
    /// Their weights.
    pub(super) weights: Vec<Double>,
}

impl Side {
    /// Whether it is a point: the patch has an apex there and no edge.
    pub(super) fn is_point(&self) -> bool {
        self.places.iter().all(|own| *own == self.places[0])
    }

    /// Whether readers may take it for a point.
    pub(super) fn is_nearly_point(&self) -> bool {
        self.places.iter().all(|own| near(own, &self.places[0]))
    }

    /// Whether its end is its start.
    pub(super) fn is_closed(&self) -> bool {
        self.places.first() == self.places.last()
    }

    /// Whether its weights say nothing.
    pub(super) fn is_polynomial(&self) -> bool {
        self.weights.iter().all(|own| *own == self.weights[0])
    }

    /// Whether both are the same in every number: the patch closes there.
    pub(super) fn meets(&self, other: &Self) -> bool {
        self.places == other.places && self.weights == other.weights
    }

    /// Whether readers may take both for the same.
    pub(super) fn nearly_meets(&self, other: &Self) -> bool {
        let mut places = self.places.iter().zip(&other.places);
        places.all(|(own, other)| near(own, other))
    }
}

/// Whether no coordinate differs by more than 1/NEARNESS.
fn near(one: &[Double; 3], other: &[Double; 3]) -> bool {
    one.iter().zip(other).all(|(own, other)| {
        let apart = own.exact().minus(&other.exact());
        let apart = if apart.sign().is_lt() {
            apart.negated()
        } else {
            apart
        };
        apart.times(&Real::from(NEARNESS)) <= Real::one()
    })
}
