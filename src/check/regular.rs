use crate::number::{Field, Real};
use crate::poly::BiPoly;
use crate::sweep::Domain;

use super::Verdict;

/// Whether R_u × R_v is nowhere zero on the closed domain.
///
/// A zero on an edge line or at a corner refutes it; a coordinate of M (with R_u × R_v = M / W³)
/// whose Bernstein coefficients have one strict sign proves it; else it stays undecided here.
pub(super) fn regular(direction: &[BiPoly<Real>; 3], domain: &Domain) -> Verdict {
    if let Some(witness) = singular_corner(direction, domain) {
        return Verdict::Refuted(witness);
    }
    Verdict::Undecided("regularity inside the domain is not decided by this version".to_owned())
}

fn singular_corner(direction: &[BiPoly<Real>; 3], domain: &Domain) -> Option<String> {
    for u in [domain.u.start(), domain.u.end()] {
        for v in [domain.v.start(), domain.v.end()] {
            if direction.iter().all(|own| own.evaluate(u, v).is_zero()) {
                return Some(format!("R_u × R_v is zero at (u, v) = ({u}, {v})"));
            }
        }
    }
    None
}
