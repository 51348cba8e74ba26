use std::cmp::Ordering;
use std::collections::VecDeque;
use std::fmt;

use super::root::middle;
use super::tensor::Tensor;
use super::touching::{edge_zeros, zeros_by_elimination};
use super::{BiPoly, UniPoly, real_roots};
use crate::number::Field;

/// The shape of a set of zeros.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ZeroKind {
    /// A line u = const over the whole range of v; the bounds in u isolate the constant.
    LineU,
    /// A line v = const over the whole range of u.
    LineV,
    /// A zero within the bounds; exact where they meet.
    Point,
    /// The polynomial vanishes somewhere in the bounds, where it takes both signs. The zero
    /// polynomial vanishes everywhere in them.
    Box,
}

impl ZeroKind {
    /// Whether a parameter is constant on it.
    #[must_use]
    pub fn is_line(self) -> bool {
        matches!(self, Self::LineU | Self::LineV)
    }
}

/// A set of zeros of a polynomial in u and v, within bounds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ZeroSet<F: Field> {
    /// Its shape.
    pub kind: ZeroKind,
    /// The lower and the upper bound in u.
    pub u: (F, F),
    /// The lower and the upper bound in v.
    pub v: (F, F),
}

impl<F: Field> ZeroSet<F> {
    /// Exchanges u and v.
    pub(super) fn transpose(&mut self) {
        std::mem::swap(&mut self.u, &mut self.v);
        self.kind = match self.kind {
            ZeroKind::LineU => ZeroKind::LineV,
            ZeroKind::LineV => ZeroKind::LineU,
            kind => kind,
        };
    }
}

/// `u = 1/2`, `v in [1/4, 3/8]`, `u = 1/2, v in [1/4, 3/8]`.
impl<F: Field> fmt::Display for ZeroSet<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let range = |name: &str, (lower, upper): &(F, F)| {
            if lower == upper {
                format!("{name} = {lower}")
            } else {
                format!("{name} in [{lower}, {upper}]")
            }
        };
        let (u, v) = (range("u", &self.u), range("v", &self.v));
        match self.kind {
            ZeroKind::LineU => formatter.write_str(&u),
            ZeroKind::LineV => formatter.write_str(&v),
            ZeroKind::Point | ZeroKind::Box => write!(formatter, "{u}, {v}"),
        }
    }
}

/// Whether a polynomial has zeros in a box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Zeros<F: Field> {
    /// It has none: proved.
    None,
    /// It has some. Every set listed holds a zero for certain; the lines are complete, of other
    /// zeros there may be more.
    Some(Vec<ZeroSet<F>>),
}

impl<F: Field> Zeros<F> {
    fn of(sets: Vec<ZeroSet<F>>) -> Self {
        if sets.is_empty() {
            Self::None
        } else {
            Self::Some(sets)
        }
    }
}

/// Subdivision stops refining where the polynomial takes both signs at this depth.
const LOCATED: u32 = 8;
/// Subdivision leaves pieces at this depth to elimination.
const DEEPEST: u32 = 64;
/// Subdivision looks at no more pieces than this before it leaves the rest to elimination.
const PIECES: usize = 1024;
/// Subdivision stops once it has located so many zeros.
const ENOUGH: usize = 16;

/// Decides whether p(u, v) has a zero in the closed box.
///
/// Divisors in one variable alone give lines. For the rest, tensor Bernstein coefficients of one
/// sign on all pieces of a subdivision prove that there are none; both signs at corners of a
/// piece prove that there is one. Zeros on the edges are univariate. What stays open, zeros at
/// which the polynomial does not change its sign, is decided by elimination.
///
/// - **holds** `None` if and only if there is no zero in the box
/// - **cost** one net of coefficients where they have one sign; elimination, in the worst case,
///   takes 4 degᵤ degᵥ univariate resultants
#[must_use]
pub fn zeros_in_box<F: Field>(polynomial: &BiPoly<F>, u: (&F, &F), v: (&F, &F)) -> Zeros<F> {
    let decided = search(
        polynomial,
        u,
        v,
        Effort {
            pieces: PIECES,
            eliminate: true,
        },
    );
    // With elimination everything is decided; the whole box is the honest answer otherwise.
    decided.unwrap_or_else(|| Zeros::of(vec![set(ZeroKind::Box, u, v)]))
}

/// As [`zeros_in_box`], but by subdivision into so many pieces only; none if that decides nothing.
#[must_use]
pub fn zeros_by_subdivision<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
    pieces: usize,
) -> Option<Zeros<F>> {
    search(
        polynomial,
        u,
        v,
        Effort {
            pieces,
            eliminate: false,
        },
    )
}

/// How far a search goes.
#[derive(Clone, Copy)]
struct Effort {
    pieces: usize,
    eliminate: bool,
}

/// The zeros that are found; none if the effort does not suffice to find one or to exclude all.
fn search<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
    effort: Effort,
) -> Option<Zeros<F>> {
    if u.0 > u.1 || v.0 > v.1 {
        return Some(Zeros::None);
    }
    if polynomial.is_zero() {
        return Some(Zeros::of(vec![set(ZeroKind::Box, u, v)]));
    }
    if u.0 == u.1 || v.0 == v.1 {
        return Some(Zeros::of(zeros_in_flat_box(polynomial, u, v)));
    }
    if polynomial.terms().len() > 1 {
        let signs = Tensor::of(polynomial, u, v).signs();
        if !(signs.zero || signs.are_mixed()) {
            return Some(Zeros::None);
        }
    }
    let (in_u, in_v, rest) = polynomial.split()?;
    let mut zeros = Vec::new();
    for (lower, upper) in points(&in_u, u) {
        zeros.push(set(ZeroKind::LineU, (&lower, &upper), v));
    }
    for (lower, upper) in points(&in_v, v) {
        zeros.push(set(ZeroKind::LineV, u, (&lower, &upper)));
    }
    if rest.as_constant().is_none() {
        let (found, open) = zeros_of_primitive(&rest, u, v, effort, zeros.is_empty());
        zeros.extend(found);
        if open && zeros.is_empty() {
            return None;
        }
    }
    Some(Zeros::of(zeros))
}

/// The isolating bounds of the roots in a range, no wider than 1/1024 of it; of all
/// multiplicities.
pub(super) fn points<F: Field>(polynomial: &UniPoly<F>, range: (&F, &F)) -> Vec<(F, F)> {
    let (numerator, denominator) = range.1.minus(range.0).into_parts();
    let width = F::from_parts(numerator, denominator * 1024);
    real_roots(polynomial, range.0, range.1)
        .into_iter()
        .map(|mut root| {
            root.refine(&width);
            (root.lower().clone(), root.upper().clone())
        })
        .collect()
}

fn set<F: Field>(kind: ZeroKind, u: (&F, &F), v: (&F, &F)) -> ZeroSet<F> {
    ZeroSet {
        kind,
        u: (u.0.clone(), u.1.clone()),
        v: (v.0.clone(), v.1.clone()),
    }
}

/// The zeros in a box without extent in u or in v.
fn zeros_in_flat_box<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
) -> Vec<ZeroSet<F>> {
    if u.0 != u.1 {
        let mut zeros = zeros_in_flat_box(&polynomial.transpose(), v, u);
        zeros.iter_mut().for_each(ZeroSet::transpose);
        return zeros;
    }
    let edge = polynomial.at_u(u.0);
    if edge.is_zero() {
        return vec![set(ZeroKind::LineU, u, v)];
    }
    let zeros = points(&edge, v).into_iter();
    zeros
        .map(|(lower, upper)| set(ZeroKind::Point, u, (&lower, &upper)))
        .collect()
}

/// Some zeros of a polynomial without divisors in one variable alone, and whether pieces of the
/// box are open still. The empty list and no open piece prove that there are none.
fn zeros_of_primitive<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
    effort: Effort,
    decide: bool,
) -> (Vec<ZeroSet<F>>, bool) {
    let mut zeros = edge_zeros(polynomial, u, v);
    let open = subdivide(polynomial, u, v, effort.pieces, &mut zeros);
    if !zeros.is_empty() || !decide || !effort.eliminate {
        return (zeros, !open.is_empty());
    }
    let Some((u, v)) = hull(&open) else {
        return (zeros, false);
    };
    let found = zeros_by_elimination(polynomial, (&u.0, &u.1), (&v.0, &v.1));
    (found, false)
}

/// A part of the box, with the coefficients there.
struct Piece<F: Field> {
    tensor: Tensor<F::Ring>,
    bounds: ZeroSet<F>,
    depth: u32,
}

impl<F: Field> Piece<F> {
    /// The halves, in u at even depth and in v at odd depth.
    fn halve(self) -> [Self; 2] {
        let (ZeroSet { u, v, .. }, depth) = (&self.bounds, self.depth + 1);
        let piece = |tensor, u: (&F, &F), v: (&F, &F)| Self {
            tensor,
            bounds: set(ZeroKind::Box, u, v),
            depth,
        };
        if self.depth.is_multiple_of(2) {
            let middle = middle(&u.0, &u.1);
            let (left, right) = self.tensor.halves_u();
            let v = (&v.0, &v.1);
            [
                piece(left, (&u.0, &middle), v),
                piece(right, (&middle, &u.1), v),
            ]
        } else {
            let middle = middle(&v.0, &v.1);
            let (left, right) = self.tensor.halves_v();
            let u = (&u.0, &u.1);
            [
                piece(left, u, (&v.0, &middle)),
                piece(right, u, (&middle, &v.1)),
            ]
        }
    }

    /// The corners at which the polynomial vanishes.
    fn zero_corners(&self) -> impl Iterator<Item = ZeroSet<F>> {
        let ZeroSet { u, v, .. } = &self.bounds;
        let places = [(&u.0, &v.0), (&u.0, &v.1), (&u.1, &v.0), (&u.1, &v.1)];
        let corners = self.tensor.corners().into_iter().zip(places);
        corners
            .filter(|(sign, _)| sign.is_eq())
            .map(|(_, (u, v))| set(ZeroKind::Point, (u, u), (v, v)))
    }
}

/// Adds zeros that subdivision locates, and returns the pieces it leaves open: without certain
/// zero and without proof that there is none.
///
/// Coefficients of one sign, some of them 0, leave only the corners. For inside the piece and on
/// the inside of an edge every basis function that belongs there is positive, and an edge whose
/// coefficients all vanish would be a divisor.
fn subdivide<F: Field>(
    polynomial: &BiPoly<F>,
    u: (&F, &F),
    v: (&F, &F),
    most: usize,
    zeros: &mut Vec<ZeroSet<F>>,
) -> Vec<ZeroSet<F>> {
    let mut open = Vec::new();
    let mut pieces = VecDeque::from([Piece {
        tensor: Tensor::of(polynomial, u, v),
        bounds: set(ZeroKind::Box, u, v),
        depth: 0,
    }]);
    let mut looked = 0;
    while let Some(piece) = pieces.pop_front() {
        looked += 1;
        let signs = piece.tensor.signs();
        let corners = piece.tensor.corners();
        if !signs.are_mixed() || piece.depth >= LOCATED {
            for zero in piece.zero_corners() {
                if !zeros.contains(&zero) {
                    zeros.push(zero);
                }
            }
        }
        if !signs.are_mixed() {
            continue;
        }
        let both = [Ordering::Less, Ordering::Greater].map(|sign| corners.contains(&sign));
        if piece.depth >= LOCATED && both == [true, true] {
            zeros.push(piece.bounds);
        } else if piece.depth >= DEEPEST || looked > most || zeros.len() >= ENOUGH {
            open.push(piece.bounds);
        } else {
            pieces.extend(piece.halve());
        }
    }
    open
}

/// The least box around all.
fn hull<F: Field>(sets: &[ZeroSet<F>]) -> Option<((F, F), (F, F))> {
    let least = |bound: fn(&ZeroSet<F>) -> &F| sets.iter().map(bound).min().cloned();
    let greatest = |bound: fn(&ZeroSet<F>) -> &F| sets.iter().map(bound).max().cloned();
    Some((
        (least(|set| &set.u.0)?, greatest(|set| &set.u.1)?),
        (least(|set| &set.v.0)?, greatest(|set| &set.v.1)?),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    fn rows(rows: &[&[i64]]) -> BiPoly<Rational> {
        let row = |row: &&[i64]| {
            let row: Vec<_> = row.iter().copied().map(Rational::from).collect();
            UniPoly::from_coefficients(&row)
        };
        BiPoly::from_rows(&rows.iter().map(row).collect::<Vec<_>>())
    }

    fn zeros(polynomial: &BiPoly<Rational>, from: i64, to: i64) -> Vec<ZeroSet<Rational>> {
        let (from, to) = (Rational::from(from), Rational::from(to));
        match zeros_in_box(polynomial, (&from, &to), (&from, &to)) {
            Zeros::None => Vec::new(),
            Zeros::Some(sets) => sets,
        }
    }

    #[test]
    fn univariate_divisors_are_lines() {
        // (2u−1)(v²−2)(u+v+9)
        let product = &rows(&[&[-1], &[2]]) * &rows(&[&[-2, 0, 1]]);
        let product = &product * &rows(&[&[9, 1], &[1]]);
        let found = zeros(&product, 0, 2);
        let kinds: Vec<_> = found.iter().map(|set| set.kind).collect();
        assert_eq!(kinds, [ZeroKind::LineU, ZeroKind::LineV]);
        let half = Rational::new(1.into(), 2.into());
        assert_eq!(found[0].u, (half.clone(), half));
        assert_eq!(found[0].v, (0.into(), 2.into()));
        assert_eq!(found[1].u, (0.into(), 2.into()));
    }

    #[test]
    fn curves_of_zeros_are_located() {
        let circle = rows(&[&[-1, 0, 1], &[], &[1]]);
        let found = zeros(&circle, 0, 1);
        assert!(found.iter().any(|set| set.kind == ZeroKind::Box));
        let hyperbola = rows(&[&[-1], &[0, 1]]);
        let corner = zeros(&hyperbola, 1, 2);
        assert!(corner.iter().all(|set| set.kind == ZeroKind::Point) && !corner.is_empty());
        assert_eq!(zeros(&circle, 2, 3), []);
        // a circle of radius 1/1000 in the middle of nothing
        let tiny = rows(&[
            &[3_000_000 - 1, -2_000_000, 1_000_000],
            &[-4_000_000],
            &[2_000_000],
        ]);
        assert!(!zeros(&tiny, 0, 3).is_empty());
    }

    #[test]
    fn touching_zeros_are_decided() {
        // (3u−1)² + (3v−2)²: one rational point; with 1/1000 more, none
        let point = rows(&[&[5, -12, 9], &[-6], &[9]]);
        let found = zeros(&point, 0, 1);
        let third = |numerator: i64| Rational::new(numerator.into(), 3.into());
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].kind, ZeroKind::Point);
        assert_eq!(found[0].u, (third(1), third(1)));
        assert_eq!(found[0].v, (third(2), third(2)));
        let above = &point.scale(&1000.into()) + &rows(&[&[1]]);
        assert_eq!(zeros(&above, 0, 1), []);
    }

    #[test]
    fn touching_zeros_off_the_field_are_decided() {
        // (u²−2)² + (v²−3)²: (√2, √3) in [1, 2]²; with 10⁻⁹ more, none
        let line = rows(&[&[-2], &[], &[1]]);
        let other = rows(&[&[-3, 0, 1]]);
        let point = &line.power(2) + &other.power(2);
        let found = zeros(&point, 1, 2);
        assert!(!found.is_empty());
        for set in &found {
            let two = Rational::from(2);
            assert!(&set.u.0 * &set.u.0 < two && two < &set.u.1 * &set.u.1);
            let three = Rational::from(3);
            assert!(&set.v.0 * &set.v.0 < three && three < &set.v.1 * &set.v.1);
        }
        let above = &point.scale(&1_000_000_000.into()) + &rows(&[&[1]]);
        assert_eq!(zeros(&above, 1, 2), []);
    }

    #[test]
    fn touching_zeros_over_a_cubic_are_decided() {
        // (u³−2)² + (v²−u)²: u = ∛2, v = 2^(1/6)
        let cubic = rows(&[&[-2], &[], &[], &[1]]);
        let parabola = rows(&[&[0, 0, 1], &[-1]]);
        let point = &cubic.power(2) + &parabola.power(2);
        let found = zeros(&point, 1, 2);
        assert!(!found.is_empty());
        for set in &found {
            assert!(set.u.0.power(3) < Some(2.into()) && Some(2.into()) < set.u.1.power(3));
            assert!(set.v.0.power(6) < Some(2.into()) && Some(2.into()) < set.v.1.power(6));
        }
        let above = &point.scale(&1_000_000.into()) + &rows(&[&[1]]);
        assert_eq!(zeros(&above, 1, 2), []);
    }

    #[test]
    fn flat_boxes_and_the_zero_polynomial_have_their_answers() {
        let saddle = rows(&[&[], &[0, 1]]);
        let (zero, one) = (Rational::from(0), Rational::from(1));
        let on_axis = zeros_in_box(&saddle, (&zero, &zero), (&zero, &one));
        assert!(matches!(on_axis, Zeros::Some(sets) if sets[0].kind == ZeroKind::LineU));
        let beside = zeros_in_box(&saddle, (&one, &one), (&one, &one));
        assert_eq!(beside, Zeros::None);
        let found = zeros(&BiPoly::zero(), 0, 1);
        assert_eq!(found[0].kind, ZeroKind::Box);
        assert_eq!(zeros(&BiPoly::one(), 0, 1), []);
    }
}
