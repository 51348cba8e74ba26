use crate::number::{Field, Real};
use crate::poly::UniPoly;

use super::Double;

/// A curve that surfaces are made of, for pictures of them: the points (X, Y, Z)/W.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Guide {
    /// The name of the curve in the source.
    pub name: String,
    /// Whether it is a profile, in u, or else a sweep curve, in v.
    pub is_profile: bool,
    /// The ends of its domain.
    pub domain: (Real, Real),
    /// W, X, Y, Z
    pub coordinates: [UniPoly<Real>; 4],
}

impl Guide {
    /// Points of the curve at `count` + 1 equal steps of its parameter, computed exactly and
    /// rounded once; without those at a pole or beyond the last double.
    #[must_use]
    pub fn points(&self, count: u16) -> Vec<[Double; 3]> {
        let (from, to) = &self.domain;
        let step = Real::from(i64::from(count)).inverse();
        let step = step.map_or_else(Real::zero, |own| own.times(&to.minus(from)));
        let at = |index: u16| from.plus(&step.times(&Real::from(i64::from(index))));
        let point = |parameter: Real| {
            let [weight, point @ ..] = self
                .coordinates
                .each_ref()
                .map(|own| own.evaluate(&parameter));
            let scale = weight.inverse()?;
            let [x, y, z] = point.map(|own| Double::nearest(&own.times(&scale)));
            Some([x?, y?, z?])
        };
        (0..=count).map(at).filter_map(point).collect()
    }
}
