use crate::number::{Enclosure, Field, Integer, Real};
use crate::poly::{UniPoly, bernstein, real_roots};

use super::{Interval, Preimage};

/// An interval around the absolute rotation index (1/2π) ∫|κ| ds of a plane Pythagorean-hodograph
/// curve; the higher the precision, the narrower.   [farouki-neff]
///
/// κ ds = 2 d(arg ω), so the index is the sum of |Δ arg ω| / π over the pieces between the
/// inflections, where Im(ω̄ω′) changes sign. Real factors of ω do not turn the tangent and are left
/// out.
#[must_use]
pub fn rotation_index(preimage: &Preimage, domain: &Interval, precision: u32) -> Enclosure {
    let preimage = preimage.primitive();
    let turning = preimage.turning();
    let zero = Enclosure::of_integer(&0.into(), precision);
    if turning.is_zero() {
        return zero;
    }
    let step = Real::ratio(1.into(), Integer::from(1) << precision.div_ceil(2));
    let mut total = zero;
    let mut from = domain.start().clone();
    for mut root in real_roots(&turning, domain.start(), domain.end()) {
        root.refine(&step);
        total = total.plus(&angle(&preimage, &from, root.lower(), precision));
        total = total.plus(&wobble(&preimage, root.lower(), root.upper(), precision));
        from = root.upper().clone();
    }
    total = total.plus(&angle(&preimage, &from, domain.end(), precision));
    let inverse = Enclosure::pi(precision).inverse();
    inverse.map_or_else(|| total.clone(), |inverse| total.times(&inverse))
}

/// |arg ω(b) − arg ω(a)| where arg ω is monotone on [a, b].
///
/// Halved until ω stays in the half-plane around ω(a), where Re(ω̄(a) ω) > 0.
fn angle(preimage: &Preimage, from: &Real, to: &Real, precision: u32) -> Enclosure {
    let mut total = Enclosure::of_integer(&0.into(), precision);
    let mut pending = vec![(from.clone(), to.clone())];
    while let Some((from, to)) = pending.pop() {
        if from == to {
            continue;
        }
        let [a, b] = preimage.parts();
        let (start_a, start_b) = (a.evaluate(&from), b.evaluate(&from));
        let along = &a.scale(&start_a) + &b.scale(&start_b);
        if !is_positive(&along, &from, &to) {
            let middle = &(&from + &to) / &Real::from(2);
            pending.push((middle.clone(), to));
            pending.push((from, middle));
            continue;
        }
        let across = &b.scale(&start_a) - &a.scale(&start_b);
        let ratio = &across.evaluate(&to) / &along.evaluate(&to);
        let piece = ratio.enclose(precision).arctangent();
        total = total.plus(&piece.absolute());
    }
    total
}

/// An interval around ∫|d arg ω| over a narrow interval: at most its length times the greatest
/// |Im(ω̄ω′)| over the least |ω|².
fn wobble(preimage: &Preimage, from: &Real, to: &Real, precision: u32) -> Enclosure {
    let zero = Enclosure::of_integer(&0.into(), precision);
    if from == to {
        return zero;
    }
    let coefficients = |polynomial: &UniPoly<Real>| {
        bernstein(polynomial, polynomial.degree().unwrap_or(0), from, to)
    };
    let most = coefficients(&preimage.turning());
    let most = most.iter().map(Real::absolute).max();
    let least = coefficients(&preimage.norm()).into_iter().min();
    match (most, least) {
        (Some(most), Some(least)) if least.sign().is_gt() => {
            let bound = &(&most * &(to - from)) / &least;
            zero.hull(&bound.enclose(precision))
        }
        // |ω| nearly vanishes: both halves are narrower.
        _ => {
            let middle = &(from + to) / &Real::from(2);
            let first = wobble(preimage, from, &middle, precision);
            first.plus(&wobble(preimage, &middle, to, precision))
        }
    }
}

/// Whether the Bernstein coefficients on an interval are all positive.
fn is_positive(polynomial: &UniPoly<Real>, from: &Real, to: &Real) -> bool {
    let degree = polynomial.degree().unwrap_or(0);
    let coefficients = bernstein(polynomial, degree, from, to);
    coefficients.iter().all(|own| own.sign().is_gt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Complex;

    /// The preimage with rational coefficients, ascending.
    fn preimage(real: &[i64], imaginary: &[i64]) -> Preimage {
        let polynomial = |own: &[i64]| {
            UniPoly::from_coefficients(&own.iter().copied().map(Real::from).collect::<Vec<_>>())
        };
        Preimage::new(Complex::one(), polynomial(real), polynomial(imaginary))
    }

    #[test]
    fn angles_of_simple_preimages_are_known() {
        let index = |real: &[i64], imaginary: &[i64]| {
            let found = rotation_index(&preimage(real, imaginary), &Interval::unit(), 96);
            found.decimal(20)
        };
        // ω = 1 + it turns by π/4, and by as much again under any real factor
        let quarter = Some("0.25000000000000000000".to_owned());
        assert_eq!(index(&[1], &[0, 1]), quarter);
        assert_eq!(index(&[1, -2], &[0, 1, -2]), quarter);
        // ω = 1 + i(t − t²) turns by arctan 1/4 to t = 1/2 and back
        assert_eq!(
            index(&[1], &[0, 1, -1]).as_deref(),
            Some("0.15595826075473865092")
        );
        assert_eq!(
            index(&[2, 1], &[]).as_deref(),
            Some("0.00000000000000000000")
        );
    }
}
