use crate::number::Real;
use crate::poly::{BiPoly, BiSquareTest, ZeroSet, Zeros, zeros_by_subdivision};
use crate::sweep::Domain;

use super::Verdict;
use super::direction::NormalDirection;

/// Pieces into which the domain is cut at most.
const PIECES: usize = 64;

/// Whether R_u × R_v is nowhere zero on the closed domain, and places where it is zero.
///
/// R_u × R_v = a(u) b(v) M / W³ vanishes where a, b or M does, and M where M·M does. If M·M = c q²,
/// the zeros of q are asked for, so that a fold shows as a change of sign. Subdivision decides
/// this for most surfaces; what it leaves open stays undecided here.
pub(super) fn regular(
    direction: &NormalDirection,
    domain: &Domain,
) -> (Verdict, Vec<ZeroSet<Real>>) {
    let lines = BiPoly::product(&direction.in_u, &direction.in_v);
    let found = [&lines, zeros_of_m(direction)].map(|own| {
        let (u, v) = (&domain.u, &domain.v);
        zeros_by_subdivision(own, (u.start(), u.end()), (v.start(), v.end()), PIECES)
    });
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

/// A polynomial with the zeros of M.
fn zeros_of_m(direction: &NormalDirection) -> &BiPoly<Real> {
    match &direction.square {
        BiSquareTest::Square { root, .. } => root,
        BiSquareTest::NotSquare { .. } => &direction.squared,
    }
}
