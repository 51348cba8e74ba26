use crate::poly::{BiDegree, BiPoly, Fraction};
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
    surface
        .point()
        .each_ref()
        .map(|own| of(own, surface.weight()))
}

fn of(
    numerator: &BiPoly<crate::number::Real>,
    weight: &BiPoly<crate::number::Real>,
) -> AffineDegree {
    let reduced = Fraction::quotient(numerator, weight).map(|own| own.reduce());
    AffineDegree {
        numerator: reduced.as_ref().and_then(|own| own.numerator().bidegree()),
        denominator: reduced
            .and_then(|own| own.denominator().polynomial().bidegree())
            .unwrap_or_default(),
    }
}
