use crate::number::Real;
use crate::poly::{BiPoly, BiSquareTest, square_test_bi, sum_of_squares_refuted};
use crate::sweep::{HomogeneousSurface, NormalVector};

/// The normal of a surface in factors, and whether its length is rational.
#[derive(Debug, Clone)]
pub(super) struct NormalDirection {
    /// R_u × R_v = a(u) b(v) F(u, v) D / W³
    pub(super) vector: NormalVector,
    /// Whether D·D is a square up to a constant.
    pub(super) square: BiSquareTest<Real>,
}

impl NormalDirection {
    /// The direction for a surface; none if R_u × R_v is zero identically.
    ///
    /// An image of D·D refutes most surfaces before it is multiplied out.
    pub(super) fn of(surface: &HomogeneousSurface) -> Option<Self> {
        let vector = surface.normal_vector()?.clone();
        let square = match sum_of_squares_refuted(&vector.direction) {
            Some(reason) => BiSquareTest::NotSquare { reason },
            None => square_test_bi(&vector.squared_direction()),
        };
        Some(Self { vector, square })
    }

    /// A polynomial with the zeros of D: √(D·D) where that is a polynomial, so that a fold shows
    /// as a change of sign.
    pub(super) fn length(&self) -> BiPoly<Real> {
        match &self.square {
            BiSquareTest::Square { root, .. } => root.clone(),
            BiSquareTest::NotSquare { .. } => self.vector.squared_direction(),
        }
    }
}
