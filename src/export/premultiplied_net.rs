use crate::net::ControlNet;
use crate::number::{Field, Rational, Real};

use super::rounding::{Rounding, error, range, shape_stable};
use super::{Double, ExportFault, Fidelity};

/// The doubles of a net whose points are multiplied by their weights, each the one nearest to its
/// exact number: for formats that store (wx, wy, wz, w).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PremultipliedNet {
    /// The knots along u, with their repetitions.
    pub knots_u: Vec<Double>,
    /// The knots along v, with their repetitions.
    pub knots_v: Vec<Double>,
    /// The points (wx, wy, wz, w), row i by row i.
    pub points: Vec<Vec<[Double; 4]>>,
    /// Numbers that become zero or subnormal (W1005).
    pub warnings: Vec<ExportFault>,
}

impl PremultipliedNet {
    /// Rounds every number of a net.
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub fn new(net: &ControlNet) -> Result<Self, ExportFault> {
        let mut rounding = Rounding::default();
        let knots_u = rounding.knots(net.knots_u(), "u")?;
        let knots_v = rounding.knots(net.knots_v(), "v")?;
        let mut points = Vec::new();
        for i in 0..net.rows() {
            let mut row = Vec::new();
            for j in 0..net.columns() {
                let [w, x, y, z] = net.homogeneous(i, j);
                let mut coordinate = |exact, name| {
                    rounding.round(exact, &|| format!("{name} of control point ({i}, {j})"))
                };
                row.push([
                    coordinate(&x, "wx")?,
                    coordinate(&y, "wy")?,
                    coordinate(&z, "wz")?,
                    coordinate(&w, "w")?,
                ]);
            }
            points.push(row);
        }
        Ok(Self {
            knots_u,
            knots_v,
            points,
            warnings: rounding.warning().into_iter().collect(),
        })
    }

    /// How the doubles differ from the net that they were made of.
    #[must_use]
    pub fn fidelity(&self, net: &ControlNet) -> Fidelity {
        let exact = (0..net.rows()).flat_map(|i| (0..net.columns()).map(move |j| (i, j)));
        let exact: Vec<[Real; 4]> = exact.map(|(i, j)| net.homogeneous(i, j)).collect();
        // (W, X, Y, Z) is the order of the exact numbers, (wx, wy, wz, w) that of the doubles.
        let errors = [1, 2, 3, 0].map(|axis| {
            let doubles = self.points.iter().flatten();
            let doubles = doubles.map(|own| &own[(axis + 3) % 4]);
            error(exact.iter().map(|own| &own[axis]).zip(doubles))
        });
        let knots_u = net.knots_u().values().iter().zip(&self.knots_u);
        let knots_v = net.knots_v().values().iter().zip(&self.knots_v);
        let exact_knots = error(knots_u.chain(knots_v)).is_zero();
        if exact_knots && errors.iter().all(Field::is_zero) {
            return Fidelity::Exact;
        }
        let stable = exact_knots || (shape_stable(net.knots_u()) && shape_stable(net.knots_v()));
        let max_error = stable.then(|| bound(net, &errors)).flatten();
        Fidelity::Rounded {
            max_error: max_error.map(Real::from),
        }
    }
}

/// A bound of what a coordinate of a surface point moves by; none without positive weights.
///
/// Let e bound the error of the numerator N, d that of the denominator D ≥ m > d, and c the
/// coordinate. (N + ε)/(D + δ) − N/D = (ε − cδ)/(D + δ) is at most (e + |c| d)/(m − d).
fn bound(net: &ControlNet, [x, y, z, weight]: &[Rational; 4]) -> Option<Rational> {
    if !net.all_positive() {
        return None;
    }
    let [least, _] = range(net.min_weight());
    let rest = least.minus(weight);
    if !rest.sign().is_gt() {
        return None;
    }
    let scale = rest.inverse()?;
    let axes = [x, y, z].into_iter().enumerate().filter_map(|(axis, own)| {
        let sizes = net.points().iter().map(|own| own[axis].absolute());
        let [_, size] = range(&sizes.max()?);
        Some(own.plus(&size.times(weight)).times(&scale))
    });
    axes.max()
}
