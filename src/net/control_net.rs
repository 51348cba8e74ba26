use std::borrow::Cow;
use std::cell::OnceCell;

use crate::number::{Field, Integer, Real, Ring, lcm};
use crate::poly::{BiDegree, BiPoly};

use super::affine::affine;
use super::products::{Control, Numerator, Products};
use super::{CurveNet, Knots, LeadingPoints};

/// An exact rational tensor-product surface: knots, weights and affine control points.
///
/// Point (i, j) counts i along u and j along v. Weight (0, 0) is 1. Where a weight is 0 the point
/// is at infinity; there `point` holds its direction (X, Y, Z)/W₀₀.
///
/// The net of a polynomial surface is held as the products that its points are sums of. These are
/// multiplied out, and weights and points divided out, when they are first asked for: that costs
/// more than all that goes before it, and most doubles do not need it.
#[derive(Clone, Debug)]
pub struct ControlNet {
    knots_u: Knots,
    knots_v: Knots,
    /// What the control points are the sums of, if they were made so.
    products: Option<Products>,
    controls: OnceCell<Vec<Control>>,
    /// The first weight over the first factor.
    first: Numerator,
    weights: OnceCell<Vec<Real>>,
    points: OnceCell<Vec<[Real; 3]>>,
}

impl PartialEq for ControlNet {
    fn eq(&self, other: &Self) -> bool {
        self.knots_u == other.knots_u
            && self.knots_v == other.knots_v
            && self.weights() == other.weights()
            && self.points() == other.points()
    }
}

impl Eq for ControlNet {}

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
        if !sound || *weights.first()? != Real::one() {
            return None;
        }
        let control = |(weight, point): (&Real, &[Real; 3])| {
            let factor = if weight.is_zero() {
                &Real::one()
            } else {
                weight
            };
            let [x, y, z] = point.each_ref().map(|own| own.times(factor));
            over_one_denominator([weight.clone(), x, y, z])
        };
        let controls: Vec<Control> = weights.iter().zip(&points).map(control).collect();
        Some(Self {
            knots_u,
            knots_v,
            products: None,
            controls: controls.into(),
            first: Numerator::one(),
            weights: weights.into(),
            points: points.into(),
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
    /// - **cost**  one conversion to the Bernstein basis per factor of each term
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
        let products = Products::of(coordinates, degree, u, v);
        let first = products.coordinate(0, (0, 0));
        (!first.is_zero()).then(|| Self {
            knots_u,
            knots_v,
            products: Some(products),
            controls: OnceCell::new(),
            first,
            weights: OnceCell::new(),
            points: OnceCell::new(),
        })
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
        &self.weights()[i * self.columns() + j]
    }

    /// Control point (i, j) as (x, y, z), not multiplied by its weight; i < rows, j < columns.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> &[Real; 3] {
        &self.points()[i * self.columns() + j]
    }

    /// All weights, i by i and j within i.
    #[must_use]
    pub fn weights(&self) -> &[Real] {
        self.weights.get_or_init(|| {
            let scale = inverse(&self.first);
            let weight = |own: &Control| {
                Real::from_parts(own.coordinates[0].clone(), own.factor.clone()).times(&scale)
            };
            self.controls().iter().map(weight).collect()
        })
    }

    /// All control points, i by i and j within i.
    #[must_use]
    pub fn points(&self) -> &[[Real; 3]] {
        self.points.get_or_init(|| {
            let point = |(index, control): (usize, &Control)| {
                let place = (index / self.columns(), index % self.columns());
                let scale = inverse(&self.divisor(place));
                let [_, point @ ..] = &control.coordinates;
                point.each_ref().map(|own| whole(own).times(&scale))
            };
            self.controls().iter().enumerate().map(point).collect()
        })
    }

    /// The leading digits of weights and points, without multiplying out; none if the net was not
    /// made from polynomials, or if few digits are known.
    #[must_use]
    pub fn leading(&self) -> Option<LeadingPoints<'_>> {
        LeadingPoints::of(self.products.as_ref()?)
    }

    /// The numerator and the divisor of weight (i, j); i < rows, j < columns.
    #[must_use]
    pub fn weight_parts(&self, i: usize, j: usize) -> (Numerator, Numerator) {
        let weight = self.coordinate(0, (i, j)).into_owned();
        (weight, self.first.scaled(&self.factor((i, j))))
    }

    /// The numerator and the divisor of a coordinate of control point (i, j), x for axis 0; i < rows,
    /// j < columns.
    #[must_use]
    pub fn coordinate_parts(&self, axis: usize, (i, j): (usize, usize)) -> (Numerator, Numerator) {
        let numerator = self.coordinate(axis + 1, (i, j)).into_owned();
        (numerator, self.divisor((i, j)))
    }

    fn controls(&self) -> &[Control] {
        let all = || self.products.as_ref().map(Products::controls);
        self.controls.get_or_init(|| all().unwrap_or_default())
    }

    /// W, X, Y or Z of a control point, times its factor: one number, if the others are not
    /// multiplied out yet.
    fn coordinate(&self, axis: usize, (i, j): (usize, usize)) -> Cow<'_, Numerator> {
        match (&self.products, self.controls.get()) {
            (Some(products), None) => Cow::Owned(products.coordinate(axis, (i, j))),
            _ => Cow::Borrowed(&self.controls()[i * self.columns() + j].coordinates[axis]),
        }
    }

    /// The factor of a control point.
    fn factor(&self, (i, j): (usize, usize)) -> Cow<'_, Integer> {
        match (&self.products, self.controls.get()) {
            (Some(products), None) => Cow::Owned(products.factor((i, j))),
            _ => Cow::Borrowed(&self.controls()[i * self.columns() + j].factor),
        }
    }

    /// The weight of a point, or, where that is 0, the first weight with the factor of the point.
    fn divisor(&self, place: (usize, usize)) -> Numerator {
        let weight = self.coordinate(0, place);
        if weight.is_zero() {
            self.first.scaled(&self.factor(place))
        } else {
            weight.into_owned()
        }
    }

    /// Whether two control points are the same point, or directions of the same length.
    #[must_use]
    pub fn coincide(&self, one: (usize, usize), other: (usize, usize)) -> bool {
        if one == other {
            return true;
        }
        let (first, second) = (self.divisor(one), self.divisor(other));
        (1..=3).all(|axis| {
            let (left, right) = (self.coordinate(axis, one), self.coordinate(axis, other));
            left.times(&second) == right.times(&first)
        })
    }

    /// The homogeneous control point (W, X, Y, Z)/W₀₀; i < rows, j < columns.
    #[must_use]
    pub fn homogeneous(&self, i: usize, j: usize) -> [Real; 4] {
        let control = &self.controls()[i * self.columns() + j];
        let scale = inverse(&self.first.scaled(&control.factor));
        let coordinates = control.coordinates.each_ref();
        coordinates.map(|own| whole(own).times(&scale))
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
        let weights = self.weights();
        weights.iter().min().unwrap_or(&weights[0])
    }

    /// The greatest weight.
    #[must_use]
    pub fn max_weight(&self) -> &Real {
        let weights = self.weights();
        weights.iter().max().unwrap_or(&weights[0])
    }

    /// Whether every weight is positive: then the surface lies in the convex hull of its points.
    #[must_use]
    pub fn all_positive(&self) -> bool {
        let sign = self.first.sign();
        let mut weights = self.controls().iter().map(|own| &own.coordinates[0]);
        weights.all(|own| own.sign() == sign)
    }
}

/// A number of the ring as one of the field.
fn whole(numerator: &Numerator) -> Real {
    Real::from_parts(numerator.clone(), Integer::one())
}

/// 1/a for a ≠ 0.
fn inverse(divisor: &Numerator) -> Real {
    whole(divisor).inverse().unwrap_or_else(Real::one)
}

/// A control point as integers.
fn over_one_denominator(coordinates: [Real; 4]) -> Control {
    let parts = coordinates.each_ref().map(Field::parts);
    let denominators = parts.iter().map(|(_, below)| below);
    let factor = denominators.fold(Integer::one(), |all, below| lcm(&all, below));
    let coordinates = parts.map(|(numerator, below)| numerator.scaled(&(&factor / below)));
    Control {
        coordinates,
        factor,
    }
}
