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

/// A unit normal at a place of a face.
#[derive(Clone, Copy)]
pub(super) struct PlaceNormal {
    /// The normal; along D where its side is open.
    pub(super) vector: [Double; 3],
    /// Whether it is against D. Open where the factor is 0 and has both signs on the face: sides
    /// that meet there may face opposite ways, as those of a cone on both sides of its apex.
    pub(super) turned: Option<bool>,
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
    pub(super) fn at(&self, precision: Precision, u: &Real, v: &Real) -> Option<PlaceNormal> {
        let vector = self.direction.at_v(v).at(u);
        self.directed(precision, vector, u, v)
    }

    /// The normals at places along both parameters.
    pub(super) fn grid(
        &self,
        precision: Precision,
        u: &[Real],
        v: &[Real],
        mut each: impl FnMut([usize; 2], Option<PlaceNormal>),
    ) {
        self.direction.grid(u, v, |i, j, vector| {
            each([i, j], self.directed(precision, vector, &u[i], &v[j]));
        });
    }

    fn directed(
        &self,
        precision: Precision,
        vector: [Numerator; 3],
        u: &Real,
        v: &Real,
    ) -> Option<PlaceNormal> {
        let turned = self.turned.or_else(|| {
            let [factor] = self.factor.at_v(v).at(u);
            let sign = factor.sign();
            sign.is_ne().then(|| sign.is_lt() != self.against)
        });
        let vector = match turned {
            Some(true) => vector.map(|own| own.negated()),
            _ => vector,
        };
        let vector = nearest_unit(precision, &vector)?;
        Some(PlaceNormal { vector, turned })
    }
}
