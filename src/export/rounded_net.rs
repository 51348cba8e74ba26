use crate::diag::Code;
use crate::net::{ControlNet, LeadingPoints};
use crate::number::{Field, Rational, Real};

use super::approx::magnitude;
use super::rounding::{Rounding, distance, error, range, shape_stable};
use super::{Double, ExportFault, Fidelity};

/// The doubles of a net, each the one nearest to its exact number, and what was lost.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RoundedNet {
    /// The knots along u, with their repetitions.
    pub knots_u: Vec<Double>,
    /// The knots along v, with their repetitions.
    pub knots_v: Vec<Double>,
    /// The weights, row i by row i.
    pub weights: Vec<Vec<Double>>,
    /// The affine points, row i by row i.
    pub points: Vec<Vec<[Double; 3]>>,
    /// Numbers that become zero or subnormal (W1005), points that become equal (W1008).
    pub warnings: Vec<ExportFault>,
}

impl RoundedNet {
    /// Rounds every number of a net.
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub fn new(net: &ControlNet) -> Result<Self, ExportFault> {
        let mut rounding = Rounding::default();
        let knots_u = rounding.knots(net.knots_u(), "u")?;
        let knots_v = rounding.knots(net.knots_v(), "v")?;
        let known = net.leading();
        let known = known.as_ref();
        let (rows, columns) = (net.rows(), net.columns());
        let (mut weights, mut points) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
        for i in 0..rows {
            let mut row = (Vec::with_capacity(columns), Vec::with_capacity(columns));
            for place in (0..columns).map(|j| (i, j)) {
                let words = known.and_then(|own| own.weight_word(place));
                let quick = words.and_then(|(weight, _)| Double::nearest_to_word(weight));
                row.0.push(match quick {
                    Some(weight) => weight,
                    None => weight(&mut rounding, net, known, place)?,
                });
                let mut coordinate = |axis: usize| {
                    let word = || known?.coordinate_word(axis, place, words?.1);
                    match word().and_then(Double::nearest_to_word) {
                        Some(own) => Ok(own),
                        None => coordinate(&mut rounding, net, known, axis, place),
                    }
                };
                row.1.push([coordinate(0)?, coordinate(1)?, coordinate(2)?]);
            }
            weights.push(row.0);
            points.push(row.1);
        }
        let mut rounded = Self {
            knots_u,
            knots_v,
            weights,
            points,
            warnings: Vec::new(),
        };
        rounded.warnings.extend(rounding.warning());
        rounded.warnings.extend(rounded.merged_points(net));
        Ok(rounded)
    }

    /// How the doubles differ from the net that they were made of.
    #[must_use]
    pub fn fidelity(&self, net: &ControlNet) -> Fidelity {
        let weights = error(net.weights().iter().zip(self.weights.iter().flatten()));
        let points = [0, 1, 2].map(|axis| error(self.axis(net, axis)));
        let knots_u = net.knots_u().values().iter().zip(&self.knots_u);
        let knots_v = net.knots_v().values().iter().zip(&self.knots_v);
        let exact_knots = error(knots_u.chain(knots_v)).is_zero();
        if exact_knots && weights.is_zero() && points.iter().all(Field::is_zero) {
            return Fidelity::Exact;
        }
        let stable = exact_knots || (shape_stable(net.knots_u()) && shape_stable(net.knots_v()));
        let max_error = stable.then(|| self.bound(net, &points)).flatten();
        Fidelity::Rounded {
            max_error: max_error.map(Real::from),
        }
    }

    /// A bound of what a coordinate of a surface point moves by; none without positive weights.
    ///
    /// Let e bound the error of the points' coordinate, δ < 1 the relative error of the weights,
    /// and let s be the width of the coordinate. The mean of the rounded points is within e of the
    /// mean of the exact ones under equal weights, and Σ wᵢ(1+δᵢ)pᵢ / Σ wᵢ(1+δᵢ) − p =
    /// Σ wᵢδᵢ(pᵢ−p) / Σ wᵢ(1+δᵢ) is at most sδ/(1−δ). Together: e + sδ/(1−δ).
    fn bound(&self, net: &ControlNet, errors: &[Rational; 3]) -> Option<Rational> {
        if !net.all_positive() {
            return None;
        }
        let weights = net.weights().iter().zip(self.weights.iter().flatten());
        let relative = weights.map(|(exact, double)| {
            let [least, _] = range(exact);
            Some(distance(exact, double).times(&least.inverse()?))
        });
        let relative: Option<Vec<Rational>> = relative.collect();
        let relative = relative?.into_iter().max()?;
        let factor = Rational::one().minus(&relative);
        if !factor.sign().is_gt() {
            return None;
        }
        let factor = relative.times(&factor.inverse()?);
        let axes = errors.iter().enumerate().filter_map(|(axis, own)| {
            let ranges = || self.axis(net, axis).map(|(exact, _)| range(exact));
            let greatest = ranges().map(|[_, upper]| upper).max()?;
            let least = ranges().map(|[lower, _]| lower).min()?;
            Some(own.plus(&greatest.minus(&least).times(&factor)))
        });
        axes.max()
    }

    /// One coordinate of all points, exact and rounded.
    fn axis<'a>(
        &'a self,
        net: &'a ControlNet,
        axis: usize,
    ) -> impl Iterator<Item = (&'a Real, &'a Double)> {
        let points = net.points().iter().zip(self.points.iter().flatten());
        points.map(move |(exact, rounded)| (&exact[axis], &rounded[axis]))
    }

    /// Says that different control points have the same doubles.
    fn merged_points(&self, net: &ControlNet) -> Option<ExportFault> {
        let mut count = 0_usize;
        let mut first = None;
        for (earlier, later) in self.equal_points() {
            if net.coincide(earlier, later) {
                continue;
            }
            let (one, other) = (net.point(earlier.0, earlier.1), net.point(later.0, later.1));
            let apart = [0, 1, 2].map(|axis| one[axis].minus(&other[axis]).absolute());
            let apart = apart.into_iter().max().filter(|own| !own.is_zero());
            if let Some(apart) = apart {
                count += 1;
                first.get_or_insert((earlier, later, apart));
            }
        }
        let (one, other, apart) = first?;
        let more = if count > 1 {
            format!(" ({count} such points)")
        } else {
            String::new()
        };
        let message = format!(
            "control points {one:?} and {other:?} differ by about {} and become equal as doubles{more}",
            magnitude(&apart)
        );
        let help =
            "move the surface nearer to the origin, or read the exact numbers of the `json` file";
        Some(ExportFault::new(Code::W1008, message, help))
    }

    /// The places of equal points, each with the first one of its kind, in the order of the later.
    fn equal_points(&self) -> Vec<((usize, usize), (usize, usize))> {
        let columns = self.points.first().map_or(0, Vec::len);
        // Most points differ in their first coordinate.
        let bits = |own: Double| own.value().to_bits();
        let mut order = Vec::with_capacity(self.points.len() * columns);
        for (i, row) in self.points.iter().enumerate() {
            order.extend(
                row.iter()
                    .enumerate()
                    .map(|(j, own)| (bits(own[0]), (i, j))),
            );
        }
        order.sort_unstable_by_key(|own| own.0);
        let mut pairs = Vec::new();
        for alike in order.chunk_by_mut(|left, right| left.0 == right.0) {
            if alike.len() == 1 {
                continue;
            }
            let rest = |(i, j): (usize, usize)| [1, 2].map(|axis| bits(self.points[i][j][axis]));
            alike.sort_unstable_by_key(|own| (rest(own.1), own.1));
            for kind in alike.chunk_by(|left, right| rest(left.1) == rest(right.1)) {
                pairs.extend(kind[1..].iter().map(|later| (kind[0].1, later.1)));
            }
        }
        pairs.sort_unstable_by_key(|(_, later)| *later);
        pairs
    }
}

/// A weight, where its leading word does not decide.
#[cold]
fn weight(
    rounding: &mut Rounding,
    net: &ControlNet,
    known: Option<&LeadingPoints<'_>>,
    (i, j): (usize, usize),
) -> Result<Double, ExportFault> {
    rounding.quotient(
        known.and_then(|own| own.weight((i, j))),
        &|| net.weight_parts(i, j),
        &|| net.weight(i, j).clone(),
        &|| format!("weight ({i}, {j})"),
    )
}

/// A coordinate of a point, where its leading word does not decide.
#[cold]
fn coordinate(
    rounding: &mut Rounding,
    net: &ControlNet,
    known: Option<&LeadingPoints<'_>>,
    axis: usize,
    (i, j): (usize, usize),
) -> Result<Double, ExportFault> {
    rounding.quotient(
        known.and_then(|own| own.coordinate(axis, (i, j))),
        &|| net.coordinate_parts(axis, (i, j)),
        &|| net.point(i, j)[axis].clone(),
        &|| format!("{} of control point ({i}, {j})", ["x", "y", "z"][axis]),
    )
}
