#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use crate::export::Double;
use crate::net::{ControlNet, Knots};
use crate::number::{Field, Real};

/// Homogeneous control points over knots, exact; unlike a [`ControlNet`] also of a derivative,
/// which may jump at a knot.
pub(super) struct Lattice {
    along: [(usize, Vec<Real>); 2],
    rows: Vec<Vec<[Real; 4]>>,
}

impl Lattice {
    /// The control points (W, X, Y, Z) of a net.
    pub(super) fn of(net: &ControlNet) -> Self {
        let knots = |own: &Knots| (own.degree(), own.values().to_vec());
        let row = |i| (0..net.columns()).map(move |j| net.homogeneous(i, j));
        Self {
            along: [knots(net.knots_u()), knots(net.knots_v())],
            rows: (0..net.rows()).map(|i| row(i).collect()).collect(),
        }
    }

    /// ∂/∂u
    pub(super) fn derivative_u(&self) -> Self {
        let [(degree, knots), along_v] = &self.along;
        let columns = self.rows.first().map_or(0, Vec::len);
        let Some(lower) = degree.checked_sub(1) else {
            let zero = std::array::from_fn(|_| Real::zero());
            return Self {
                along: self.along.clone(),
                rows: vec![vec![zero; columns]; self.rows.len()],
            };
        };
        let factor = Real::from(i64::try_from(*degree).unwrap_or(i64::MAX));
        let row = |(index, pair): (usize, &[Vec<[Real; 4]>])| {
            let width = knots[index + degree + 1].minus(&knots[index + 1]);
            let scale = width
                .inverse()
                .map_or_else(Real::zero, |own| own.times(&factor));
            let pairs = pair[0].iter().zip(&pair[1]);
            pairs
                .map(|(low, high)| {
                    std::array::from_fn(|axis| high[axis].minus(&low[axis]).times(&scale))
                })
                .collect()
        };
        Self {
            along: [(lower, knots[1..knots.len() - 1].to_vec()), along_v.clone()],
            rows: self.rows.windows(2).enumerate().map(row).collect(),
        }
    }

    /// u and v exchanged.
    pub(super) fn transposed(&self) -> Self {
        let [u, v] = self.along.clone();
        let columns = self.rows.first().map_or(0, Vec::len);
        let column = |j: usize| self.rows.iter().map(|row| row[j].clone()).collect();
        Self {
            along: [v, u],
            rows: (0..columns).map(column).collect(),
        }
    }

    /// Every number as the double nearest to it; beyond the last double 0.
    pub(super) fn rounded(&self) -> Spline {
        let round = |own: &Real| Double::nearest(own).map_or(0.0, Double::value);
        let [u, v] = self.along.each_ref().map(|(degree, knots)| Axis {
            degree: *degree,
            knots: knots.iter().map(round).collect(),
        });
        let rows = self.rows.iter();
        Spline {
            u,
            v,
            rows: rows
                .map(|row| row.iter().map(|own| own.each_ref().map(round)).collect())
                .collect(),
        }
    }
}

/// A tensor-product spline in doubles.
pub(super) struct Spline {
    u: Axis,
    v: Axis,
    rows: Vec<Vec<[f64; 4]>>,
}

impl Spline {
    /// The ends of the domain along u and along v.
    pub(super) fn domain(&self) -> [[f64; 2]; 2] {
        [self.u.domain(), self.v.domain()]
    }

    /// (W, X, Y, Z) at parameters of the domain.
    pub(super) fn at(&self, u: f64, v: f64) -> [f64; 4] {
        let ((first_u, in_u), (first_v, in_v)) = (self.u.basis(u), self.v.basis(v));
        let mut sum = [0.0; 4];
        for (row, left) in self.rows[first_u..].iter().zip(&in_u) {
            for (point, right) in row[first_v..].iter().zip(&in_v) {
                for (own, coordinate) in sum.iter_mut().zip(point) {
                    *own += left * right * coordinate;
                }
            }
        }
        sum
    }
}

/// One direction of a spline.
struct Axis {
    degree: usize,
    knots: Vec<f64>,
}

impl Axis {
    fn domain(&self) -> [f64; 2] {
        [self.knots[0], self.knots[self.knots.len() - 1]]
    }

    /// The basis functions that are not 0 at a parameter, with the index of the first.
    ///
    /// N of degree d from those of degree d − 1, each divided among its two neighbours.
    fn basis(&self, at: f64) -> (usize, Vec<f64>) {
        let (degree, knots) = (self.degree, &self.knots);
        let last = knots.len() - degree - 2;
        let span = knots.partition_point(|own| *own <= at).clamp(1, last + 1) - 1;
        let span = span.max(degree);
        let mut basis = vec![1.0];
        for step in 1..=degree {
            let mut next = vec![0.0; step + 1];
            for (index, own) in basis.iter().enumerate() {
                let low = knots[span + 1 + index - step];
                let high = knots[span + 1 + index];
                let ratio = (at - low) / (high - low);
                next[index] += (1.0 - ratio) * own;
                next[index + 1] += ratio * own;
            }
            basis = next;
        }
        (span - degree, basis)
    }
}
