use crate::number::Real;
use crate::poly::{BiPoly, ZeroSet, Zeros, zeros_in_box};
use crate::sweep::Domain;

/// Where W, or the common factor of W, X, Y, Z, vanishes on the closed domain.
///
/// Once the common factor is gone, the zeros of W are true poles or base points. Every place listed
/// is a zero, and the list is empty only if there is none; lines are complete, on a curve of zeros
/// only some places are named.
pub(super) fn zeros_on(polynomial: &BiPoly<Real>, domain: &Domain) -> Vec<ZeroSet<Real>> {
    if polynomial.as_constant().is_some() {
        return Vec::new();
    }
    let (u, v) = (&domain.u, &domain.v);
    match zeros_in_box(polynomial, (u.start(), u.end()), (v.start(), v.end())) {
        Zeros::None => Vec::new(),
        Zeros::Some(places) => places,
    }
}
