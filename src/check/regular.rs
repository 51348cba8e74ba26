use crate::number::Real;
use crate::poly::{BiPoly, ZeroSet, Zeros, never_vanish_together, zeros_by_subdivision};
use crate::sweep::Domain;

use super::Verdict;
use super::direction::NormalDirection;

/// Pieces into which the domain is cut at most.
const PIECES: usize = 64;

/// Whether R_u × R_v is nowhere zero on the closed domain, and places where it is zero.
///
/// R_u × R_v = a(u) b(v) F D / W³ vanishes where a, b, F or D does, and D where all its
/// components do. Subdivision decides this for most surfaces; what it leaves open stays undecided
/// here.
pub(super) fn regular(
    direction: &NormalDirection,
    domain: &Domain,
) -> (Verdict, Vec<ZeroSet<Real>>) {
    let zeros = |own: &BiPoly<Real>| {
        let (u, v) = (&domain.u, &domain.v);
        zeros_by_subdivision(own, (u.start(), u.end()), (v.start(), v.end()), PIECES)
    };
    let vector = &direction.vector;
    let lines = BiPoly::product(&vector.in_u, &vector.in_v);
    let mut found = vec![zeros(&lines), zeros(&vector.mixed)];
    if !direction_is_regular(&vector.direction, domain) {
        found.push(zeros(&direction.length()));
    }
    let mut places = Vec::new();
    for zeros in found.iter().flatten() {
        if let Zeros::Some(sets) = zeros {
            places.extend(sets.iter().cloned());
        }
    }
    let verdict = match (places.first(), found.iter().all(Option::is_some)) {
        (Some(place), _) => Verdict::Refuted(format!("R_u × R_v is zero at {place}")),
        (None, true) => Verdict::Proven("R_u × R_v is nowhere zero on the domain".to_owned()),
        (None, false) => Verdict::Undecided(format!(
            "{PIECES} pieces of the domain neither show nor exclude a zero of R_u × R_v"
        )),
    };
    (verdict, places)
}

/// Whether subdivision shows that D vanishes nowhere on the domain, without D·D.
fn direction_is_regular(direction: &[BiPoly<Real>; 3], domain: &Domain) -> bool {
    let (u, v) = (&domain.u, &domain.v);
    let (u, v) = ((u.start(), u.end()), (v.start(), v.end()));
    never_vanish_together(&direction.each_ref(), u, v, PIECES)
}
