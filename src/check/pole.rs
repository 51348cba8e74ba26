use crate::poly::{ZeroSet, Zeros, zeros_in_box};
use crate::sweep::{Domain, HomogeneousSurface};

/// Where W vanishes on the closed domain. The common factor is gone, so these are true poles or
/// base points. Every place listed is one, and the list is empty only if there is none; lines are
/// complete, on a curve of poles only some places are named.
pub(super) fn poles(
    surface: &HomogeneousSurface,
    domain: &Domain,
) -> Vec<ZeroSet<crate::number::Real>> {
    if surface.weight().as_constant().is_some() {
        return Vec::new();
    }
    let (u, v) = (&domain.u, &domain.v);
    match zeros_in_box(surface.weight(), (u.start(), u.end()), (v.start(), v.end())) {
        Zeros::None => Vec::new(),
        Zeros::Some(places) => places,
    }
}
