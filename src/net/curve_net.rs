use crate::number::{Field, Real};
use crate::poly::{RealRoot, UniPoly, bernstein, from_bernstein, gcd_all, real_roots};

use super::Knots;
use super::affine::affine;

/// An exact rational Bézier curve over [0, 1]: weights and affine control points.
///
/// The first weight is 1. Where a weight is 0 the point is at infinity; there `point` holds its
/// direction (X, Y, Z)/W₀.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CurveNet {
    weights: Vec<Real>,
    points: Vec<[Real; 3]>,
}

impl CurveNet {
    /// The curve of homogeneous control points (W, X, Y, Z), scaled so that the first weight is 1.
    ///
    /// None without points, or if the first weight is 0.
    #[must_use]
    pub fn from_homogeneous(controls: &[[Real; 4]]) -> Option<Self> {
        let (weights, points) = affine(controls)?;
        Some(Self { weights, points })
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.weights.len() - 1
    }

    /// All weights; the first is 1.
    #[must_use]
    pub fn weights(&self) -> &[Real] {
        &self.weights
    }

    /// All control points as (x, y, z), not multiplied by their weights.
    #[must_use]
    pub fn points(&self) -> &[[Real; 3]] {
        &self.points
    }

    /// The homogeneous control points (W, X, Y, Z)/W₀.
    #[must_use]
    pub fn homogeneous(&self) -> Vec<[Real; 4]> {
        let pairs = self.weights.iter().zip(&self.points);
        pairs
            .map(|(weight, [x, y, z])| {
                let one = Real::one();
                let factor = if weight.is_zero() { &one } else { weight };
                let times = |own: &Real| own.times(factor);
                [weight.clone(), times(x), times(y), times(z)]
            })
            .collect()
    }

    /// The first point.
    #[must_use]
    pub fn start(&self) -> &[Real; 3] {
        &self.points[0]
    }

    /// The last point; the last weight is not 0 on a curve without poles.
    #[must_use]
    pub fn end(&self) -> &[Real; 3] {
        &self.points[self.points.len() - 1]
    }

    /// Whether it is one point throughout.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.reduced().degree() == 0
    }

    /// Whether every weight is positive.
    #[must_use]
    pub fn all_positive(&self) -> bool {
        self.weights.iter().all(|own| own.sign().is_gt())
    }

    /// The curve point at a parameter of [0, 1], by repeated affine combination; none at a pole.
    #[must_use]
    pub fn de_casteljau(&self, at: &Real) -> Option<[Real; 3]> {
        let knots = Knots::bezier(self.degree(), &Real::zero(), &Real::one())?;
        let [weight, point @ ..] = knots.blend(&self.homogeneous(), at)?;
        let scale = weight.inverse()?;
        Some(point.map(|own| own.times(&scale)))
    }

    /// Whether a point lies in the box of the control points, which holds the curve if the weights
    /// are positive.
    pub(super) fn may_pass(&self, point: &[Real; 3]) -> bool {
        [0, 1, 2].into_iter().all(|axis| {
            let values = || self.points.iter().map(|own| &own[axis]);
            let (least, greatest) = (values().min(), values().max());
            least <= Some(&point[axis]) && Some(&point[axis]) <= greatest
        })
    }

    /// The parameters inside (0, 1), ascending, where the curve passes a point, as far as they lie
    /// in the field of its numbers.
    #[must_use]
    pub fn parameters_of(&self, point: &[Real; 3]) -> Vec<Real> {
        let [weight, coordinates @ ..] = self.polynomials();
        let apart = coordinates.iter().zip(point);
        let apart = apart.map(|(own, place)| own - &weight.scale(place));
        let common = gcd_all(&apart.collect::<Vec<_>>());
        let (zero, one) = (Real::zero(), Real::one());
        let roots = real_roots(&common, &zero, &one).into_iter();
        let roots = roots.filter(RealRoot::is_exact);
        let places = roots.map(|own| own.lower().clone());
        places.filter(|own| *own != zero && *own != one).collect()
    }

    /// W, X, Y, Z as polynomials.
    #[must_use]
    pub fn polynomials(&self) -> [UniPoly<Real>; 4] {
        let controls = self.homogeneous();
        [0, 1, 2, 3].map(|axis| {
            let coefficients: Vec<_> = controls.iter().map(|own| own[axis].clone()).collect();
            from_bernstein(&coefficients, &Real::zero(), &Real::one())
        })
    }

    /// The same curve in lowest degree: W, X, Y, Z without their common factor.
    ///
    /// - **holds** equal curves with equal parameters have equal reduced nets
    #[must_use]
    pub fn reduced(&self) -> Self {
        let coordinates = self.polynomials();
        let factor = gcd_all(&coordinates);
        let divided = coordinates
            .each_ref()
            .map(|own| own.exact_div(&factor).unwrap_or_else(|| own.clone()));
        Self::of_polynomials(&divided, 0, &Real::zero(), &Real::one())
            .unwrap_or_else(|| self.clone())
    }

    /// The same curve in a degree that is not lower than its own.
    #[must_use]
    pub fn elevated(&self, degree: usize) -> Self {
        let coordinates = self.polynomials();
        let degree = degree.max(self.degree());
        Self::of_polynomials(&coordinates, degree, &Real::zero(), &Real::one())
            .unwrap_or_else(|| self.clone())
    }

    /// The part between two parameters, from < to; none if a pole is at its start.
    #[must_use]
    pub fn between(&self, from: &Real, to: &Real) -> Option<Self> {
        Self::of_polynomials(&self.polynomials(), self.degree(), from, to)
    }

    /// The same curve, run through from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut controls = self.homogeneous();
        controls.reverse();
        Self::from_homogeneous(&controls).unwrap_or_else(|| self.clone())
    }

    /// The curve (X, Y, Z)/W over [from, to] in a degree that is at least its own.
    fn of_polynomials(
        coordinates: &[UniPoly<Real>; 4],
        degree: usize,
        from: &Real,
        to: &Real,
    ) -> Option<Self> {
        let own = coordinates.iter().filter_map(UniPoly::degree).max()?;
        let degree = degree.max(own);
        let rows = coordinates
            .each_ref()
            .map(|own| bernstein(own, degree, from, to));
        let controls = (0..=degree).map(|index| rows.each_ref().map(|row| row[index].clone()));
        Self::from_homogeneous(&controls.collect::<Vec<_>>())
    }
}
