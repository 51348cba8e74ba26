//! Decides by elimination whether a polynomial vanishes anywhere in a box.

use super::algebraic::Algebraic;
use super::root::middle;
use super::zero_set::{ZeroKind, ZeroSet, points};
use super::{BiPoly, bigcd, real_roots, resultant_v};
use crate::number::Field;

/// Some zeros of p in the closed box; none if there are none at all. The polynomial has no
/// divisor in one variable alone.
///
/// For the square-free part s let R(u) be the resultant of s and ∂s/∂v in v. If s has no zero at
/// the two edges v = const, then between neighbouring roots of R the number of zeros v in the
/// range stays the same: one sample decides there, and the roots of R are left. At a root that
/// is not a number of the field Sturm's theorem over F(α) decides.
pub(super) fn zeros_by_elimination<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
) -> Vec<ZeroSet<F>> {
    let swap = polynomial
        .bidegree()
        .is_some_and(|degree| degree.u < degree.v);
    if swap {
        // Eliminating the variable of lower degree is the cheaper way.
        let mut zeros = zeros_over_u(&polynomial.transpose(), v, u);
        zeros.iter_mut().for_each(ZeroSet::transpose);
        return zeros;
    }
    zeros_over_u(polynomial, u, v)
}

fn zeros_over_u<F: Field>(polynomial: &BiPoly<F>, u: (&F, &F), v: (&F, &F)) -> Vec<ZeroSet<F>> {
    let repeated = bigcd::gcd_bi(polynomial, &polynomial.derivative_v());
    let Some(simple) = bigcd::exact_div_bi(polynomial, &repeated) else {
        return Vec::new();
    };
    let mut zeros = edge_zeros(&simple, u, v);
    if !zeros.is_empty() {
        return zeros;
    }
    let discriminant = resultant_v(&simple, &simple.derivative_v());
    let candidates = real_roots(&discriminant, u.0, u.1);
    for pair in candidates.windows(2) {
        let sample = middle(pair[0].upper(), pair[1].lower());
        zeros.extend(points_at_u(&simple, &sample, v));
    }
    let narrow = |range: (&F, &F)| {
        let (numerator, denominator) = range.1.minus(range.0).into_parts();
        F::from_parts(numerator, denominator << 10_u32)
    };
    for mut root in candidates {
        if root.is_exact() {
            zeros.extend(points_at_u(&simple, root.lower(), v));
            continue;
        }
        root.refine(&narrow(u));
        let mut field = Algebraic::new(root);
        if let Some((lower, upper)) = field.some_root(&simple, v.0, v.1, &narrow(v)) {
            let root = field.root();
            zeros.push(ZeroSet {
                kind: ZeroKind::Point,
                u: (root.lower().clone(), root.upper().clone()),
                v: (lower, upper),
            });
        }
    }
    zeros
}

/// The zeros on the four edges of the box.
pub(super) fn edge_zeros<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
) -> Vec<ZeroSet<F>> {
    let mut zeros = Vec::new();
    for at in [u.0, u.1] {
        zeros.extend(points_at_u(polynomial, at, v));
    }
    let transpose = polynomial.transpose();
    for at in [v.0, v.1] {
        for mut zero in points_at_u(&transpose, at, u) {
            zero.transpose();
            if !zeros.contains(&zero) {
                zeros.push(zero);
            }
        }
    }
    zeros
}

/// The zeros (a, v) in the range of v, of a polynomial that u − a does not divide.
fn points_at_u<F: Field>(polynomial: &BiPoly<F>, at: &F, v: (&F, &F)) -> Vec<ZeroSet<F>> {
    points(&polynomial.at_u(at), v)
        .into_iter()
        .map(|v| ZeroSet {
            kind: ZeroKind::Point,
            u: (at.clone(), at.clone()),
            v,
        })
        .collect()
}
