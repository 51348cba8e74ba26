#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "many points of a surface for the eye, in doubles"
)]

use crate::export::Double;
use crate::net::ControlNet;
use crate::number::Real;

/// Parameters along v that are worked on together, so that the processor does several at a time.
const WIDTH: usize = 32;

/// Points and unit normals of a surface at equal steps of both parameters, in doubles.
///
/// The control points are rounded once; then R = P/W, and the normal is along
/// (P_u − W_u R) × (P_v − W_v R). Bernstein polynomials are tabulated for every parameter; a row of
/// equal u is contracted along u first, so that a point costs three sums along v.
///
/// Where W is 0 the numbers are not finite; where the surface has no normal, those of the normal mean
/// nothing.
///
/// - **cost** (4 · 3)(n + 1) products for a point, where n is the degree along v
pub struct Samples {
    homogeneous: Vec<[f64; 4]>,
    along_u: Vec<[Vec<f64>; 2]>,
    along_v: Vec<[Vec<f64>; 2]>,
    count: [usize; 2],
}

impl Samples {
    /// Samples of a net of one span at so many parameters along u and along v, both ends among
    /// them; none for a number beyond the last double, or a net of several spans.
    #[must_use]
    pub fn new(net: &ControlNet, count: [usize; 2]) -> Option<Self> {
        let simple = net.knots_u().is_bezier() && net.knots_v().is_bezier();
        let round = |own: &Real| Double::nearest(own).map(Double::value);
        let mut homogeneous = Vec::new();
        for i in 0..net.rows() {
            for j in 0..net.columns() {
                let [w, x, y, z] = net.homogeneous(i, j).each_ref().map(round);
                homogeneous.push([w?, x?, y?, z?]);
            }
        }
        simple.then(|| Self {
            homogeneous,
            along_u: transposed_tables(net.degree().u, count[0], 0),
            along_v: transposed_tables(net.degree().v, count[1], WIDTH),
            count,
        })
    }

    /// Each point with its normal as x, y, z and the normal's three, u by u and v by v within.
    #[must_use]
    pub fn points(&self) -> Vec<[f64; 6]> {
        let mut points = Vec::with_capacity(self.count[0] * self.count[1]);
        for i in 0..self.count[0] {
            let [row, slope] = [0, 1].map(|order| self.row(i, order));
            for start in (0..self.count[1]).step_by(WIDTH) {
                let sums = self.sums(&row, &slope, start);
                let values = values(&sums);
                let wanted = WIDTH.min(self.count[1] - start);
                points.extend((0..wanted).map(|k| values.each_ref().map(|own| own[k])));
            }
        }
        points
    }

    /// The control points along v where u is given, or their derivatives by u.
    fn row(&self, i: usize, order: usize) -> Vec<[f64; 4]> {
        let columns = self.along_v.len();
        let mut row = vec![[0.0; 4]; columns];
        let controls = self.homogeneous.chunks_exact(columns);
        for (controls, basis) in controls.zip(&self.along_u) {
            for (sum, control) in row.iter_mut().zip(controls) {
                for (own, coordinate) in sum.iter_mut().zip(control) {
                    *own += basis[order][i] * coordinate;
                }
            }
        }
        row
    }

    /// W, X, Y, Z, their derivatives by u and those by v.
    fn sums(&self, row: &[[f64; 4]], slope: &[[f64; 4]], start: usize) -> [[f64; WIDTH]; 12] {
        let mut sums = [[0.0; WIDTH]; 12];
        for ([value, rate], (own, by_u)) in self.along_v.iter().zip(row.iter().zip(slope)) {
            let (value, rate) = (&value[start..start + WIDTH], &rate[start..start + WIDTH]);
            for axis in 0..4 {
                for k in 0..WIDTH {
                    sums[axis][k] += own[axis] * value[k];
                    sums[4 + axis][k] += by_u[axis] * value[k];
                    sums[8 + axis][k] += own[axis] * rate[k];
                }
            }
        }
        sums
    }
}

/// Points and normals from the sums.
fn values(sums: &[[f64; WIDTH]; 12]) -> [[f64; WIDTH]; 6] {
    let mut values = [[0.0; WIDTH]; 6];
    for k in 0..WIDTH {
        let scale = 1.0 / sums[0][k];
        let point = [1, 2, 3].map(|axis| sums[axis][k] * scale);
        let tangent = |first: usize| {
            [0, 1, 2].map(|axis| sums[first + 1 + axis][k] - sums[first][k] * point[axis])
        };
        let (left, right) = (tangent(4), tangent(8));
        let normal = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| left[i] * right[j] - left[j] * right[i]);
        let square: f64 = normal.iter().map(|own| own * own).sum();
        let inverse = 1.0 / square.sqrt();
        for axis in 0..3 {
            values[axis][k] = point[axis];
            values[3 + axis][k] = normal[axis] * inverse;
        }
    }
    values
}

/// For each Bernstein polynomial its values at equal steps, and those of its derivative by the
/// parameter of the unit interval; some more behind the last.
fn transposed_tables(degree: usize, count: usize, more: usize) -> Vec<[Vec<f64>; 2]> {
    let mut tables = vec![[Vec::new(), Vec::new()]; degree + 1];
    for k in 0..count {
        let place = k as f64 / (count.max(2) - 1) as f64;
        let lower = if degree == 0 {
            Vec::new()
        } else {
            basis(degree - 1, place)
        };
        for (index, value) in basis(degree, place).into_iter().enumerate() {
            let at = |index: Option<usize>| index.and_then(|own| lower.get(own)).unwrap_or(&0.0);
            let rate = at(index.checked_sub(1)) - at(Some(index));
            tables[index][0].push(value);
            tables[index][1].push(degree as f64 * rate);
        }
    }
    for table in tables.iter_mut().flatten() {
        table.resize(count + more, 1.0);
    }
    tables
}

/// The Bernstein polynomials at a parameter, each degree from the one below.
fn basis(degree: usize, place: f64) -> Vec<f64> {
    let mut basis = vec![1.0];
    for step in 1..=degree {
        let mut next = vec![0.0; step + 1];
        for (index, own) in basis.iter().enumerate() {
            next[index] += (1.0 - place) * own;
            next[index + 1] += place * own;
        }
        basis = next;
    }
    basis
}
