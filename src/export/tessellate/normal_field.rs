use crate::export::{Double, Precision};
use crate::net::Face;
use crate::number::{Field, Real, Ring};
use crate::sweep::NormalVector;

use super::nearest::nearest_unit;
use super::tensor::{Numerator, Tensor};

/// The unit normals of a face: along R_u × R_v, and where that is 0 along its limit from inside, as
/// far as common factors in u and in v tell.
pub(super) struct NormalField {
    direction: Tensor<3>,
    factor: Tensor<1>,
    /// Whether the direction is to be turned around everywhere, if that is known.
    turned: Option<bool>,
    against: bool,
}

impl NormalField {
    /// The normals of a face, or their opposites.
    pub(super) fn of(face: &Face, normal: &NormalVector, opposite: bool) -> Self {
        let u = face.net.knots_u().domain();
        let v = face.net.knots_v().domain();
        let [x, y, z] = &normal.direction;
        // R_u × R_v = factor · D / W³, and W has one sign on the face. Its Bernstein coefficients
        // need not have it, where those of the face are of a higher degree.
        let weight = face.surface.weight().evaluate(u.0, v.0);
        let against = weight.sign().is_lt() != opposite;
        let factor = Tensor::of_polynomials([&normal.factor()], u, v);
        let signs = || factor.coefficients(0).map(Ring::sign);
        let turned = match (
            signs().any(|own| own.is_gt()),
            signs().any(|own| own.is_lt()),
        ) {
            (true, true) => None,
            (_, negative) => Some(negative != against),
        };
        Self {
            direction: Tensor::of_polynomials([x, y, z], u, v),
            factor,
            turned,
            against,
        }
    }

    /// The normal at a place of the unit square; none where it has no direction.
    pub(super) fn at(&self, precision: Precision, u: &Real, v: &Real) -> Option<[Double; 3]> {
        let vector = self.direction.at_v(v).at(u);
        nearest_unit(precision, &self.turned(vector, u, v))
    }

    /// The normals at places along both parameters.
    pub(super) fn grid(
        &self,
        precision: Precision,
        u: &[Real],
        v: &[Real],
        mut each: impl FnMut([usize; 2], Option<[Double; 3]>),
    ) {
        self.direction.grid(u, v, |i, j, vector| {
            let vector = self.turned(vector, &u[i], &v[j]);
            each([i, j], nearest_unit(precision, &vector));
        });
    }

    fn turned(&self, vector: [Numerator; 3], u: &Real, v: &Real) -> [Numerator; 3] {
        let turned = self.turned.unwrap_or_else(|| {
            let [factor] = self.factor.at_v(v).at(u);
            factor.sign().is_lt() != self.against
        });
        if turned {
            vector.map(|own| own.negated())
        } else {
            vector
        }
    }
}
