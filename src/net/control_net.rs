use crate::number::{Field, Integer, Real, Ring, lcm};
use crate::poly::{BiDegree, BiPoly, UniPoly, bernstein};

use super::affine::affine;
use super::{CurveNet, Knots};

/// The numerators of exact numbers.
type Numerator = <Real as Field>::Ring;

/// An exact rational tensor-product surface: knots, weights and affine control points.
///
/// Point (i, j) counts i along u and j along v. Weight (0, 0) is 1. Where a weight is 0 the point
/// is at infinity; there `point` holds its direction (X, Y, Z)/W₀₀.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ControlNet {
    knots_u: Knots,
    knots_v: Knots,
    weights: Vec<Real>,
    points: Vec<[Real; 3]>,
}

impl ControlNet {
    /// The net of given knots, weights and points, listed i by i and j within i.
    ///
    /// None if the numbers of weights and points are not those that the knots ask for, or if the
    /// first weight is not 1.
    #[must_use]
    pub fn new(
        knots_u: Knots,
        knots_v: Knots,
        weights: Vec<Real>,
        points: Vec<[Real; 3]>,
    ) -> Option<Self> {
        let count = knots_u.control_points() * knots_v.control_points();
        let sound = weights.len() == count && points.len() == count;
        (sound && *weights.first()? == Real::one()).then_some(Self {
            knots_u,
            knots_v,
            weights,
            points,
        })
    }

    /// The net of homogeneous control points (W, X, Y, Z), listed i by i and j within i, scaled so
    /// that the first weight is 1.
    ///
    /// None if the number of points is not what the knots ask for, or if the first weight is 0.
    #[must_use]
    pub fn from_homogeneous(
        knots_u: Knots,
        knots_v: Knots,
        controls: &[[Real; 4]],
    ) -> Option<Self> {
        let (weights, points) = affine(controls)?;
        Self::new(knots_u, knots_v, weights, points)
    }

    /// The one Bézier patch of the surface (W, X, Y, Z) over the domain u × v.
    ///
    /// None if W is 0 at the domain's first corner, or if the domain is empty.
    ///
    /// - **shape** the bidegree is the componentwise maximum of the four
    /// - **holds** [`ControlNet::de_casteljau`] equals (X, Y, Z)/W wherever W is not 0
    /// - **cost**  one conversion to the Bernstein basis per factor of each term, then an outer
    ///   product in integers
    #[must_use]
    pub fn bezier(
        coordinates: [&BiPoly<Real>; 4],
        u: (&Real, &Real),
        v: (&Real, &Real),
    ) -> Option<Self> {
        let bidegrees = coordinates.iter().filter_map(|own| own.bidegree());
        let degree = bidegrees.reduce(BiDegree::max)?;
        let knots_u = Knots::bezier(degree.u, u.0, u.1)?;
        let knots_v = Knots::bezier(degree.v, v.0, v.1)?;
        let tensors = coordinates.map(|own| Tensor::bernstein(own, degree, u, v));
        let [weights, points @ ..] = Tensor::over_one_denominator(tensors);
        let whole = |numerator: &Numerator| Real::from_parts(numerator.clone(), Integer::one());
        let scale = whole(weights.first()?).inverse()?;
        let divisors = weights
            .iter()
            .map(|own| whole(own).inverse().unwrap_or_else(|| scale.clone()));
        let points = divisors.enumerate().map(|(index, divisor)| {
            std::array::from_fn(|axis| whole(&points[axis][index]).times(&divisor))
        });
        let points = points.collect();
        let weights = weights.iter().map(|own| whole(own).times(&scale)).collect();
        Self::new(knots_u, knots_v, weights, points)
    }

    /// The same control points over other knots; none if those ask for another number of points.
    #[must_use]
    pub fn with_knots(&self, knots_u: Knots, knots_v: Knots) -> Option<Self> {
        let same =
            knots_u.control_points() == self.rows() && knots_v.control_points() == self.columns();
        same.then(|| Self {
            knots_u,
            knots_v,
            ..self.clone()
        })
    }

    /// The bidegree.
    #[must_use]
    pub fn degree(&self) -> BiDegree {
        BiDegree::new(self.knots_u.degree(), self.knots_v.degree())
    }

    /// The knots along u.
    #[must_use]
    pub fn knots_u(&self) -> &Knots {
        &self.knots_u
    }

    /// The knots along v.
    #[must_use]
    pub fn knots_v(&self) -> &Knots {
        &self.knots_v
    }

    /// The number of control points along u.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.knots_u.control_points()
    }

    /// The number of control points along v.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.knots_v.control_points()
    }

    /// The weight of control point (i, j); i < rows, j < columns.
    #[must_use]
    pub fn weight(&self, i: usize, j: usize) -> &Real {
        &self.weights[i * self.columns() + j]
    }

    /// Control point (i, j) as (x, y, z), not multiplied by its weight; i < rows, j < columns.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> &[Real; 3] {
        &self.points[i * self.columns() + j]
    }

    /// All weights, i by i and j within i.
    #[must_use]
    pub fn weights(&self) -> &[Real] {
        &self.weights
    }

    /// All control points, i by i and j within i.
    #[must_use]
    pub fn points(&self) -> &[[Real; 3]] {
        &self.points
    }

    /// The homogeneous control point (W, X, Y, Z)/W₀₀; i < rows, j < columns.
    #[must_use]
    pub fn homogeneous(&self, i: usize, j: usize) -> [Real; 4] {
        let (weight, [x, y, z]) = (self.weight(i, j), self.point(i, j));
        let factor = if weight.is_zero() {
            &Real::one()
        } else {
            weight
        };
        [
            weight.clone(),
            x.times(factor),
            y.times(factor),
            z.times(factor),
        ]
    }

    /// The Bézier curve of the control points at these indices; the first weight among them is not
    /// 0 on a surface without poles.
    pub(super) fn curve(&self, indices: impl Iterator<Item = (usize, usize)>) -> Option<CurveNet> {
        let controls = indices.map(|(i, j)| self.homogeneous(i, j));
        CurveNet::from_homogeneous(&controls.collect::<Vec<_>>())
    }

    /// The surface point at (u, v), by repeated affine combination of the control points; none
    /// outside the domain or at a pole.
    #[must_use]
    pub fn de_casteljau(&self, u: &Real, v: &Real) -> Option<[Real; 3]> {
        let row = |i| (0..self.columns()).map(move |j| self.homogeneous(i, j));
        let column: Option<Vec<_>> = (0..self.rows())
            .map(|i| self.knots_v.blend(&row(i).collect::<Vec<_>>(), v))
            .collect();
        let [weight, point @ ..] = self.knots_u.blend(&column?, u)?;
        let scale = weight.inverse()?;
        Some(point.map(|own| own.times(&scale)))
    }

    /// The least weight.
    #[must_use]
    pub fn min_weight(&self) -> &Real {
        self.weights.iter().min().unwrap_or(&self.weights[0])
    }

    /// The greatest weight.
    #[must_use]
    pub fn max_weight(&self) -> &Real {
        self.weights.iter().max().unwrap_or(&self.weights[0])
    }

    /// Whether every weight is positive: then the surface lies in the convex hull of its points.
    #[must_use]
    pub fn all_positive(&self) -> bool {
        self.min_weight().sign().is_gt()
    }
}

/// Bernstein coefficients of a polynomial, i by i and j within i, over one denominator.
struct Tensor {
    numerators: Vec<Numerator>,
    denominator: Integer,
}

impl Tensor {
    /// Σ fₖ gₖ in the Bernstein basis of a bidegree that is at least its own: each factor is
    /// converted alone, the terms are outer products.
    fn bernstein(
        polynomial: &BiPoly<Real>,
        degree: BiDegree,
        u: (&Real, &Real),
        v: (&Real, &Real),
    ) -> Self {
        let fits = |(in_u, in_v): &(UniPoly<Real>, UniPoly<Real>)| {
            in_u.degree() <= Some(degree.u) && in_v.degree() <= Some(degree.v)
        };
        let dense;
        let terms = if polynomial.terms().iter().all(fits) {
            polynomial.terms()
        } else {
            // The terms cancel above the bidegree; the dense form has no such terms.
            dense = BiPoly::from_rows(&polynomial.rows());
            dense.terms()
        };
        let factors: Vec<_> = terms
            .iter()
            .map(|(in_u, in_v)| {
                let (in_u, below_u) = common(&bernstein(in_u, degree.u, u.0, u.1));
                let (in_v, below_v) = common(&bernstein(in_v, degree.v, v.0, v.1));
                (in_u, in_v, below_u * below_v)
            })
            .collect();
        let denominators = factors.iter().map(|(_, _, below)| below);
        let denominator = denominators.fold(Integer::one(), |all, below| lcm(&all, below));
        let columns = degree.v + 1;
        let mut numerators = vec![Numerator::zero(); (degree.u + 1) * columns];
        for (in_u, in_v, below) in &factors {
            let scale = &denominator / below;
            let in_v: Vec<_> = in_v.iter().map(|own| own.scaled(&scale)).collect();
            for (row, left) in numerators.chunks_exact_mut(columns).zip(in_u) {
                for (sum, right) in row.iter_mut().zip(&in_v) {
                    sum.add_product(left, right);
                }
            }
        }
        Self {
            numerators,
            denominator,
        }
    }

    /// The numerators of four tensors over their common denominator.
    fn over_one_denominator(tensors: [Self; 4]) -> [Vec<Numerator>; 4] {
        let denominators = tensors.iter().map(|own| &own.denominator);
        let denominator = denominators.fold(Integer::one(), |all, own| lcm(&all, own));
        tensors.map(|own| {
            let scale = &denominator / own.denominator;
            let scaled = own.numerators.iter().map(|value| value.scaled(&scale));
            scaled.collect()
        })
    }
}

/// The numerators of numbers over their common denominator.
fn common(values: &[Real]) -> (Vec<Numerator>, Integer) {
    let parts: Vec<_> = values.iter().map(Field::parts).collect();
    let denominators = parts.iter().map(|(_, below)| below);
    let denominator = denominators.fold(Integer::one(), |all, below| lcm(&all, below));
    let numerators = parts
        .iter()
        .map(|(numerator, below)| numerator.scaled(&(&denominator / below)));
    (numerators.collect(), denominator)
}
