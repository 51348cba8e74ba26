use crate::number::{Enclosure, Integer, Real};
use crate::poly::{bernstein, real_roots};

use super::{Interval, Preimage};

/// An interval around the absolute rotation index (1/2π) ∫|κ| ds of a plane Pythagorean-hodograph
/// curve; the higher the precision, the narrower.   [farouki-neff]
///
/// κ ds = 2 d(arg ω), so the index is the sum of |Δ arg ω| / π over the pieces between the
/// inflections, where Im(ω̄ω′) changes sign. Real factors of ω do not turn the tangent and are left
/// out.
#[must_use]
pub fn rotation_index(preimage: &Preimage, domain: &Interval, precision: u32) -> Enclosure {
    let (preimage, _) = preimage.primitive().normalised(domain);
    let (start, end) = (Real::from(0), Real::from(1));
    let turning = preimage.turning();
    let mut total = Enclosure::of_integer(&0.into(), precision);
    if turning.is_zero() {
        return total;
    }
    // There |Δ arg ω| falls with the square of the width.
    let step = Real::ratio(1.into(), Integer::from(1) << precision.div_ceil(2));
    let mut from = start.clone();
    for mut root in real_roots(&turning, &start, &end) {
        root.refine(&step);
        // Inside the isolating interval arg ω turns by less than it can turn on so short a way.
        let gap = Piece::of(&preimage, root.lower(), root.upper(), precision);
        total = total
            .plus(&Piece::of(&preimage, &from, root.lower(), precision).angle())
            .plus(&gap.spread());
        from = root.upper().clone();
    }
    total = total.plus(&Piece::of(&preimage, &from, &end, precision).angle());
    let inverse = Enclosure::pi(precision).inverse();
    inverse.map_or_else(|| total.clone(), |inverse| total.times(&inverse))
}

/// Pieces after which the precision, not the length of the pieces, is too small.
const PIECES: usize = 512;

/// ω on a piece of the domain: intervals around the Bernstein coefficients of a and b.
struct Piece {
    points: Vec<[Enclosure; 2]>,
}

impl Piece {
    fn of(preimage: &Preimage, from: &Real, to: &Real, precision: u32) -> Self {
        let parts = preimage.parts();
        let degree = parts
            .iter()
            .filter_map(|own| own.degree())
            .max()
            .unwrap_or(0);
        let [a, b] = parts.map(|own| bernstein(own, degree, from, to));
        let enclose = |own: &Real| own.enclose(precision);
        let points = a.iter().zip(&b).map(|(a, b)| [enclose(a), enclose(b)]);
        Self {
            points: points.collect(),
        }
    }

    /// |arg ω(end) − arg ω(start)| where arg ω is monotone: the piece is halved until ω stays in
    /// the half-plane around its start.
    fn angle(self) -> Enclosure {
        let precision = self.points[0][0].precision();
        let mut total = Enclosure::of_integer(&0.into(), precision);
        let mut pending = vec![self];
        for _ in 0..PIECES {
            let Some(piece) = pending.pop() else {
                return total;
            };
            match piece.small_angle() {
                Some(angle) => total = total.plus(&angle),
                None => {
                    let (left, right) = piece.halves();
                    pending.extend([right, left]);
                }
            }
        }
        // On each piece ω, of degree m, turns by less than mπ.
        let zero = Enclosure::of_integer(&0.into(), precision);
        let most = Enclosure::pi(precision);
        let rest = pending
            .iter()
            .flat_map(|own| own.points.iter().skip(1))
            .fold(zero.clone(), |sum, _| sum.plus(&most));
        total.plus(&zero.hull(&rest))
    }

    /// |arg ω(end) − arg ω(start)| if ω is seen to stay in the half-plane Re(ω̄(start) ω) > 0.
    fn small_angle(&self) -> Option<Enclosure> {
        let ([a, b], [c, d]) = (self.points.first()?, self.points.last()?);
        for [along, across] in &self.points {
            let real = a.times(along).plus(&b.times(across));
            real.sign()?.is_gt().then_some(())?;
        }
        let real = a.times(c).plus(&b.times(d));
        let imaginary = a.times(d).minus(&b.times(c));
        Some(imaginary.times(&real.inverse()?).arctangent().absolute())
    }

    /// An interval from 0 to a bound for ∫|d arg ω|: the sum of the angles between neighbouring
    /// control points, which the curve does not exceed.
    fn spread(&self) -> Enclosure {
        let precision = self.points[0][0].precision();
        let zero = Enclosure::of_integer(&0.into(), precision);
        let angles = self.points.windows(2).map(|pair| {
            let pair = Self {
                points: pair.to_vec(),
            };
            pair.small_angle()
                .unwrap_or_else(|| Enclosure::pi(precision))
        });
        let sum = angles.fold(zero.clone(), |sum, own| sum.plus(&own));
        zero.hull(&sum)
    }

    /// Both halves, by de Casteljau's construction.
    fn halves(&self) -> (Self, Self) {
        let two = Integer::from(2);
        let mut row = self.points.clone();
        let (mut left, mut right) = (Vec::new(), Vec::new());
        while let (Some(first), Some(last)) = (row.first(), row.last()) {
            left.push(first.clone());
            right.push(last.clone());
            let mean =
                |i: usize, [one, other]: [&[Enclosure; 2]; 2]| one[i].plus(&other[i]).divided(&two);
            row = row
                .windows(2)
                .map(|pair| [0, 1].map(|i| mean(i, [&pair[0], &pair[1]])))
                .collect();
        }
        right.reverse();
        (Self { points: left }, Self { points: right })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Complex;
    use crate::poly::UniPoly;

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
