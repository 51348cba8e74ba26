use std::collections::VecDeque;

use super::tensor::Tensor;
use super::zero_set::points;
use super::{BiPoly, UniPoly, ZeroKind, ZeroSet, gcd_all};
use crate::number::Field;

/// Whether subdivision into at most so many pieces shows that some polynomials have no common zero
/// in the closed box: on every piece the Bernstein coefficients of one of them have one sign.
#[must_use]
pub fn never_vanish_together<F: Field>(
    polynomials: &[&BiPoly<F>],
    u: (&F, &F),
    v: (&F, &F),
    pieces: usize,
) -> bool {
    let tensors = polynomials.iter().filter(|own| !own.is_zero());
    let whole: Vec<_> = tensors.map(|own| Tensor::of(own, u, v)).collect();
    let mut open = VecDeque::from([(whole, 0_u32)]);
    let mut looked = 0;
    while let Some((tensors, depth)) = open.pop_front() {
        looked += 1;
        let clear = tensors.iter().any(|own| {
            let signs = own.signs();
            !(signs.zero || signs.are_mixed())
        });
        if clear {
            continue;
        }
        if looked + open.len() >= pieces {
            return false;
        }
        let halves = tensors.into_iter().map(|own| {
            if depth.is_multiple_of(2) {
                own.halves_u()
            } else {
                own.halves_v()
            }
        });
        let (left, right): (Vec<_>, Vec<_>) = halves.unzip();
        open.extend([(left, depth + 1), (right, depth + 1)]);
    }
    true
}

/// How many products are looked at: each doubles the work.
const PRODUCTS: usize = 8;

/// All common zeros, in a closed box that is not empty, of polynomials that are products f(u) g(v);
/// none if one of them is not, or if all are 0.
///
/// At a common zero some of the f vanish together, and of the others the g: each choice of some is
/// two univariate greatest common divisors.
///
/// - **holds** the list is complete, and empty only if there is no common zero; a zero that several
///   choices find may stand in it several times, also on its line
#[must_use]
pub fn common_zeros_of_products<F: Field>(
    polynomials: &[&BiPoly<F>],
    u: (&F, &F),
    v: (&F, &F),
) -> Option<Vec<ZeroSet<F>>> {
    let products = polynomials.iter().filter(|own| !own.is_zero());
    let factors = products.map(|own| {
        let (in_u, in_v, rest) = own.split()?;
        rest.as_constant().map(|_| (in_u, in_v))
    });
    let factors: Vec<_> = factors.collect::<Option<_>>()?;
    if factors.is_empty() || factors.len() > PRODUCTS {
        return None;
    }
    let all = (1_u32 << factors.len()) - 1;
    let mut zeros = Vec::new();
    for choice in 0..=all {
        let (chosen, others): (Vec<_>, Vec<_>) = factors
            .iter()
            .enumerate()
            .partition(|(index, _)| choice >> index & 1 == 1);
        let in_u = places(chosen.iter().map(|(_, own)| &own.0), u);
        let in_v = places(others.iter().map(|(_, own)| &own.1), v);
        let kind = match choice {
            0 => ZeroKind::LineV,
            _ if choice == all => ZeroKind::LineU,
            _ => ZeroKind::Point,
        };
        for u in &in_u {
            let found = in_v.iter().map(|v| ZeroSet {
                kind,
                u: u.clone(),
                v: v.clone(),
            });
            let new: Vec<_> = found.filter(|own| !zeros.contains(own)).collect();
            zeros.extend(new);
        }
    }
    Some(zeros)
}

/// The common zeros of some polynomials in a range; of none, the whole range.
fn places<'a, F: Field>(
    polynomials: impl ExactSizeIterator<Item = &'a UniPoly<F>>,
    range: (&F, &F),
) -> Vec<(F, F)> {
    if polynomials.len() == 0 {
        return vec![(range.0.clone(), range.1.clone())];
    }
    let common = gcd_all(polynomials);
    if common.is_constant() {
        Vec::new()
    } else {
        points(&common, range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    fn polynomial(own: &[i64]) -> UniPoly<Rational> {
        let own: Vec<_> = own.iter().map(|own| Rational::from(*own)).collect();
        UniPoly::from_coefficients(&own)
    }

    fn product(in_u: &[i64], in_v: &[i64]) -> BiPoly<Rational> {
        BiPoly::product(&polynomial(in_u), &polynomial(in_v))
    }

    /// On [0, 1] × [0, 1].
    fn zeros(list: &[&BiPoly<Rational>]) -> Option<Vec<ZeroSet<Rational>>> {
        let (zero, one) = (Rational::from(0), Rational::from(1));
        common_zeros_of_products(list, (&zero, &one), (&zero, &one))
    }

    #[test]
    fn crossing_lines_meet_and_parallel_lines_do_not() {
        let line = |constant: i64, u: i64, v: i64| {
            BiPoly::from_rows(&[polynomial(&[constant, v]), polynomial(&[u])])
        };
        let (zero, one) = (Rational::from(0), Rational::from(1));
        let apart = |first: &BiPoly<Rational>, second: &BiPoly<Rational>| {
            never_vanish_together(&[first, second], (&zero, &one), (&zero, &one), 256)
        };
        // u = v against 3u + 3v = 2, 3u = 3v + 1 and 5u = 5v + 1
        let diagonal = line(0, 1, -1);
        assert!(!apart(&diagonal, &line(-2, 3, 3)));
        assert!(apart(&diagonal, &line(-1, 3, -3)));
        assert!(apart(&diagonal, &line(-1, 5, -5)));
        assert!(!apart(&diagonal, &diagonal));
    }

    #[test]
    fn products_vanish_together_where_their_factors_do() {
        // the normal of c(v) + p(u) with z′ = 2u² − 1 and a tangent along x at v = 1/3:
        // (−z′ c′_y, z′ c′_x, x′ c′_y)
        let (slope, rise, run) = ([-1, 0, 2], [-1, 3], [1, 1]);
        let normal = [(&slope[..], rise), (&slope, run), (&[1], rise)];
        let normal = normal.map(|(in_u, in_v)| product(in_u, &in_v));
        let found = zeros(&normal.each_ref()).unwrap_or_default();
        let third = Rational::new(1.into(), 3.into());
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].kind, ZeroKind::Point);
        assert_eq!(found[0].v, (third.clone(), third));
        let square = |own: &Rational| own * own;
        let half = Rational::new(1.into(), 2.into());
        assert!(square(&found[0].u.0) < half && half < square(&found[0].u.1));
        // A product may be written as a sum.
        let written = &product(&[0, 0, 2], &rise) + &product(&[-1], &rise);
        assert_eq!(zeros(&[&written, &normal[1], &normal[2]]), Some(found));
        // With a tangent that never points along x there is none.
        let other = [(&slope[..], run), (&slope, rise), (&[1], run)];
        let other = other.map(|(in_u, in_v)| product(in_u, &in_v));
        assert_eq!(zeros(&other.each_ref()), Some(Vec::new()));
    }

    #[test]
    fn lines_are_among_the_zeros_and_sums_are_not_looked_at() {
        let line = [product(&[-1, 2], &[1]), product(&[-1, 2], &[0, 1])];
        let found = zeros(&[&line[0], &line[1], &BiPoly::zero()]).unwrap_or_default();
        let half = Rational::new(1.into(), 2.into());
        assert!(found.iter().any(|own| own.kind == ZeroKind::LineU));
        assert!(
            found
                .iter()
                .all(|own| own.u == (half.clone(), half.clone()))
        );
        let sum = &product(&[0, 1], &[1]) + &product(&[1], &[0, 1]);
        assert_eq!(zeros(&[&sum]), None);
        assert_eq!(zeros(&[&BiPoly::zero()]), None);
    }
}
