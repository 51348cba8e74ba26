//! Which side of a closed shell is outside.

use std::cmp::Ordering;

use crate::net::{Face, Shell};
use crate::number::{Field, Integer, Rational, Ring};
use crate::poly::BernsteinGrid;

use super::{Double, RoundedNet};

/// The faces of a shell to be turned so that neighbours show the same side, and the outer one where
/// the shell is closed; none if there is no such choice.
///
/// The outer side is that to which the normals point where the volume
/// ⅓ Σ ∫∫ det(P, P_u, P_v)/W³ is positive. It is the volume of the doubles that a file holds, between
/// bounds that decide its sign; where these do not after a few halvings, for a shell that is very thin
/// or has long nets, the first face stays as it is.
pub(super) fn turned(shell: &Shell) -> Option<Vec<bool>> {
    let mut turned = shell.orientation()?;
    if shell.is_closed() && volume_sign(shell, &turned) == Some(Ordering::Less) {
        turned.iter_mut().for_each(|own| *own = !*own);
    }
    Some(turned)
}

/// How often cells are halved both ways at most.
const HALVINGS: usize = 3;

/// The control points that a face has at most, if a volume is asked for.
const CONTROL_POINTS: usize = 64;

/// Of more cells than these none is halved.
const CELLS: usize = 500;

/// The sign of the enclosed volume for normals that are turned like this.
fn volume_sign(shell: &Shell, turned: &[bool]) -> Option<Ordering> {
    let nets: Option<Vec<_>> = shell.faces.iter().map(homogeneous).collect();
    let nets = nets?;
    let centre = centre(&nets)?;
    let faces = nets.iter().zip(turned);
    let mut cells: Vec<Cell> = faces
        .map(|(net, turned)| Cell::of(&about(net, &centre), *turned))
        .collect();
    for _ in 0..HALVINGS {
        if let Some(sign) = sign(&cells) {
            return Some(sign);
        }
        if cells.len() > CELLS {
            return None;
        }
        cells = cells.iter().flat_map(Cell::quarters).collect();
    }
    sign(&cells)
}

/// W, X, Y, Z in rows of control points.
type Net = Vec<Vec<[Rational; 4]>>;

/// The doubles of a face; none for a long net, or one beyond the doubles.
fn homogeneous(face: &Face) -> Option<Net> {
    if face.net.rows() * face.net.columns() > CONTROL_POINTS {
        return None;
    }
    let net = RoundedNet::new(&face.net).ok()?;
    let rows = net.weights.iter().zip(&net.points);
    let row = |(weights, points): (&Vec<_>, &Vec<[_; 3]>)| {
        let places = weights.iter().zip(points);
        let place = |(weight, point): (&Double, &[Double; 3])| {
            let weight = weight.rational();
            let [x, y, z] = point.map(|own| own.rational().times(&weight));
            [weight, x, y, z]
        };
        places.map(place).collect()
    };
    Some(rows.map(row).collect())
}

/// A point among the corners of the faces.
fn centre(nets: &[Net]) -> Option<[Rational; 3]> {
    let corners = nets.iter().filter_map(|net| net.first()?.first());
    let points = corners.filter_map(|[weight, point @ ..]| {
        let inverse = weight.inverse()?;
        Some(point.each_ref().map(|own| own.times(&inverse)))
    });
    let points: Vec<[Rational; 3]> = points.collect();
    let count = Rational::from(i64::try_from(points.len()).ok()?).inverse()?;
    let mean = |axis: usize| {
        let sum = points
            .iter()
            .fold(Rational::zero(), |sum, own| sum.plus(&own[axis]));
        sum.times(&count)
    };
    Some([mean(0), mean(1), mean(2)])
}

/// P − c W in place of P.
fn about(net: &Net, centre: &[Rational; 3]) -> Net {
    let shifted = |[weight, point @ ..]: &[Rational; 4]| {
        let [x, y, z] = [0, 1, 2].map(|axis| point[axis].minus(&centre[axis].times(weight)));
        [weight.clone(), x, y, z]
    };
    net.iter()
        .map(|row| row.iter().map(shifted).collect())
        .collect()
}

/// A part of a face: D = det(P, P_u, P_v), with the sign of the face, and W, by their Bernstein
/// coefficients on it; and its share of the face.
struct Cell {
    determinant: BernsteinGrid<Rational>,
    weight: BernsteinGrid<Rational>,
    share: Rational,
}

impl Cell {
    fn of(net: &Net, turned: bool) -> Self {
        let grid = |axis: usize| {
            let rows = net.iter();
            let rows = rows.map(|row| row.iter().map(|own| own[axis].clone()).collect());
            BernsteinGrid::new(rows.collect())
        };
        let point = [1, 2, 3].map(grid);
        let along_u = point.each_ref().map(BernsteinGrid::derivative_u);
        let along_v = point.each_ref().map(BernsteinGrid::derivative_v);
        let [x, y, z] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|(i, j, k)| {
            let left = along_u[j].times(&along_v[k]);
            let right = along_u[k].times(&along_v[j]);
            let (left, right) = if turned { (right, left) } else { (left, right) };
            point[i].times(&left.minus(&right))
        });
        Self {
            determinant: x.plus(&y).plus(&z),
            weight: grid(0),
            share: Rational::one(),
        }
    }

    /// The four quarters.
    fn quarters(&self) -> Vec<Self> {
        let [determinants, weights] =
            [&self.determinant, &self.weight].map(BernsteinGrid::quarters);
        let share = self.share.times(&Rational::new(1.into(), 4.into()));
        let pairs = determinants.into_iter().zip(weights);
        let cell = |(determinant, weight)| Self {
            determinant,
            weight,
            share: share.clone(),
        };
        pairs.map(cell).collect()
    }

    /// Bounds of ∫∫ D/W³: the mean of the coefficients is that of the function. None where a
    /// coefficient of W is not positive.
    fn bounds(&self) -> Option<[Rational; 2]> {
        let all = || self.determinant.coefficients();
        let count = Rational::from(i64::try_from(all().count()).ok()?).inverse()?;
        let sum = |positive: bool| {
            let chosen = all().filter(|own| own.sign().is_gt() == positive);
            let sum = chosen.fold(Rational::zero(), |sum, own| sum.plus(own));
            sum.times(&count).times(&self.share)
        };
        let (above, below) = (sum(true), sum(false));
        let weights = || self.weight.coefficients();
        let (least, greatest) = (weights().min()?, weights().max()?);
        if !least.sign().is_gt() {
            return None;
        }
        let cube = |own: &Rational| own.times(own).times(own).inverse();
        let (most, fewest) = (cube(least)?, cube(greatest)?);
        let lower = above.times(&fewest).plus(&below.times(&most));
        let upper = above.times(&most).plus(&below.times(&fewest));
        Some([lower, upper])
    }
}

/// The sign of the sum over cells, if their bounds decide it.
fn sign(cells: &[Cell]) -> Option<Ordering> {
    let bounds: Option<Vec<[Rational; 2]>> = cells.iter().map(Cell::bounds).collect();
    let bounds = bounds?;
    let size = |own: &Rational| own.clone().max(own.negated());
    let greatest = bounds.iter().flatten().map(size).max()?;
    // In units that are small beside the greatest, so that sums stay short.
    let unit = greatest.times(&Rational::new(1.into(), Integer::from(1) << 40_u32));
    let inverse = unit.inverse()?;
    let floor = |own: &Rational| {
        let scaled = own.times(&inverse);
        scaled.numerator().div_floor(scaled.denominator())
    };
    let mut sums = [Integer::from(0), Integer::from(0)];
    for [lower, upper] in &bounds {
        sums[0] += floor(lower);
        sums[1] += floor(upper) + 1;
    }
    match sums.map(|own| Ring::sign(&own)) {
        [Ordering::Greater, _] => Some(Ordering::Greater),
        [_, Ordering::Less] => Some(Ordering::Less),
        _ => None,
    }
}
