use crate::number::Real;
use crate::poly::{
    BiPoly, ZeroSet, Zeros, common_zeros_of_products, never_vanish_together, zeros_by_subdivision,
};
use crate::sweep::Domain;

use super::Verdict;
use super::direction::NormalDirection;

/// Pieces into which the domain is cut at most.
const PIECES: usize = 64;

/// Whether R_u × R_v is nowhere zero on the closed domain, and places where it is zero.
///
/// R_u × R_v = a(u) b(v) F D / W³ vanishes where a, b, F or D does, and D where all its
/// components do. Where those are products f(u) g(v), as for all translations of a profile, their
/// common zeros are known; else subdivision decides for most surfaces, and what it leaves open stays
/// undecided here.
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
    // The whole domain is one piece, which is often enough.
    if !direction_is_regular(&vector.direction, domain, 1) {
        let known = known_zeros(&vector.direction, domain);
        let is_regular = match &known {
            Some(own) => own.is_empty(),
            None => direction_is_regular(&vector.direction, domain, PIECES),
        };
        if !is_regular {
            found.push(zeros(&direction.length()).or_else(|| known.map(Zeros::Some)));
        }
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

/// The zeros of D, if its components are products.
fn known_zeros(direction: &[BiPoly<Real>; 3], domain: &Domain) -> Option<Vec<ZeroSet<Real>>> {
    let (u, v) = (&domain.u, &domain.v);
    let (u, v) = ((u.start(), u.end()), (v.start(), v.end()));
    common_zeros_of_products(&direction.each_ref(), u, v)
}

/// Whether subdivision into so many pieces shows that D vanishes nowhere on the domain, without D·D.
fn direction_is_regular(direction: &[BiPoly<Real>; 3], domain: &Domain, pieces: usize) -> bool {
    let (u, v) = (&domain.u, &domain.v);
    let (u, v) = ((u.start(), u.end()), (v.start(), v.end()));
    never_vanish_together(&direction.each_ref(), u, v, pieces)
}
