use crate::number::Real;
use crate::poly::{UniPoly, gcd_all, lcm};

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

    /// Brings three fractions over the least common multiple of their denominators, as they are
    /// written; none if a denominator is 0.
    #[must_use]
    pub fn over_common_denominator(fractions: &[(UniPoly<Real>, UniPoly<Real>); 3]) -> Option<Self> {
        let mut weight = UniPoly::one();
        for (_, denominator) in fractions {
            if denominator.is_zero() {
                return None;
            }
            weight = lcm(&weight, denominator);
        }
        let over = |(numerator, denominator): &(UniPoly<Real>, UniPoly<Real>)| {
            Some(numerator * &weight.exact_div(denominator)?)
        };
        let coordinates = [over(&fractions[0])?, over(&fractions[1])?, over(&fractions[2])?];
        Some(Self {
            weight,
            coordinates,
        })
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
