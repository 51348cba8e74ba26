use crate::number::Real;
use crate::poly::{Quotient, RealRoot, UniPoly, gcd_all, lcm, real_roots};

use super::Interval;

/// A curve in homogeneous coordinates (w; x, y, z): the points (x/w, y/w, z/w).
///
/// The coordinates may share a factor; [`Homogeneous::reduce`] removes it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Homogeneous {
    /// w, primitive
    pub weight: UniPoly<Real>,
    /// x, y, z
    pub coordinates: [UniPoly<Real>; 3],
}

impl Homogeneous {
    /// A polynomial curve.
    #[must_use]
    pub fn polynomial(coordinates: [UniPoly<Real>; 3]) -> Self {
        Self {
            weight: UniPoly::one(),
            coordinates,
        }
    }

    /// Brings three coordinates over the least common multiple of their denominators, as they are
    /// written.
    #[must_use]
    pub fn from_quotients(quotients: &[Quotient<Real>; 3]) -> Self {
        let weight = quotients.iter().fold(UniPoly::one(), |common, own| {
            lcm(&common, own.denominator())
        });
        let coordinates = quotients.each_ref().map(|own| own.numerator_over(&weight));
        Self {
            weight,
            coordinates,
        }
    }

    /// The zeros on an interval that all four coordinates share.
    #[must_use]
    pub fn common_zeros(&self, domain: &Interval) -> Vec<RealRoot<Real>> {
        let common = gcd_all(std::iter::once(&self.weight).chain(&self.coordinates));
        if common.is_constant() {
            return Vec::new();
        }
        real_roots(&common, domain.start(), domain.end())
    }

    /// Whether all points are the same: each coordinate is a multiple of w.
    #[must_use]
    pub fn is_point(&self) -> bool {
        let proportional = |own: &UniPoly<Real>| {
            own.is_zero()
                || (own.degree() == self.weight.degree() && own.monic() == self.weight.monic())
        };
        self.coordinates.iter().all(proportional)
    }

    /// The same curve without the common factor of w, x, y, z.
    #[must_use]
    pub fn reduce(&self) -> Self {
        let all = std::iter::once(&self.weight).chain(&self.coordinates);
        let common = gcd_all(all);
        let divide = |own: &UniPoly<Real>| own.exact_div(&common).unwrap_or_else(|| own.clone());
        Self {
            weight: divide(&self.weight),
            coordinates: self.coordinates.each_ref().map(divide),
        }
    }

    /// The degree of the curve: the largest of its homogeneous coordinates.
    #[must_use]
    pub fn degree(&self) -> usize {
        let all = std::iter::once(&self.weight).chain(&self.coordinates);
        all.filter_map(UniPoly::degree).max().unwrap_or(0)
    }

    /// Whether w is constant.
    #[must_use]
    pub fn is_polynomial(&self) -> bool {
        self.weight.is_constant()
    }
}
