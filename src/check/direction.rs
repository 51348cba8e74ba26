use crate::number::Real;
use crate::poly::{BiPoly, BiSquareTest, UniPoly, gcd_all, square_test_bi};
use crate::sweep::{HomogeneousSurface, normal_direction};

/// The direction of the normal: R_u × R_v = a(u) b(v) M / W³ with a polynomial vector M that has
/// no factor in u or in v alone.
#[derive(Debug, Clone)]
pub(super) struct NormalDirection {
    /// a(u)
    pub(super) in_u: UniPoly<Real>,
    /// b(v)
    pub(super) in_v: UniPoly<Real>,
    /// M·M
    pub(super) squared: BiPoly<Real>,
    /// Whether M·M is a square up to a constant.
    pub(super) square: BiSquareTest<Real>,
}

impl NormalDirection {
    /// The direction for a surface; none if R_u × R_v is zero identically.
    pub(super) fn of(surface: &HomogeneousSurface) -> Option<Self> {
        let whole = normal_direction(surface);
        if whole.iter().all(BiPoly::is_zero) {
            return None;
        }
        let contents = |content: fn(&BiPoly<Real>) -> UniPoly<Real>| {
            let parts: Vec<_> = whole
                .iter()
                .filter(|own| !own.is_zero())
                .map(content)
                .collect();
            gcd_all(&parts)
        };
        let (in_u, in_v) = (contents(BiPoly::content_u), contents(BiPoly::content_v));
        let vector = whole.map(|own| {
            let own = own.exact_div_u(&in_u).unwrap_or(own);
            own.exact_div_v(&in_v).unwrap_or(own)
        });
        let squares = vector.iter().map(|own| own * own);
        let squared = squares.fold(BiPoly::zero(), |sum, own| &sum + &own);
        Some(Self {
            square: square_test_bi(&squared),
            in_u,
            in_v,
            squared,
        })
    }
}
