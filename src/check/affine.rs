use crate::number::Real;
use crate::poly::{BiDegree, BiPoly, Denominator, Fraction};
use crate::sweep::HomogeneousSurface;

/// The bidegrees of a Cartesian coordinate in lowest terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AffineDegree {
    /// Of the numerator; none for a zero coordinate.
    pub numerator: Option<BiDegree>,
    /// Of the denominator.
    pub denominator: BiDegree,
}

/// X/W, Y/W and Z/W, each in lowest terms on its own.
pub(super) fn affine_degrees(surface: &HomogeneousSurface) -> [AffineDegree; 3] {
    let weight = Denominator::split(surface.weight());
    let weight = weight.map_or_else(Denominator::one, |(_, weight)| weight);
    surface.point().map(|own| of(own, weight.clone()))
}

/// The degrees of a fraction; constant factors do not matter.
fn of(numerator: BiPoly<Real>, weight: Denominator<Real>) -> AffineDegree {
    let reduced = Fraction::new(numerator, weight).reduce();
    let denominator = reduced.denominator().polynomial().bidegree();
    AffineDegree {
        numerator: reduced.numerator().bidegree(),
        denominator: denominator.unwrap_or_default(),
    }
}
