use crate::number::{Field, Real};
use crate::poly::from_bernstein;

use super::{Arguments, BuildFault, Coordinates, Kind, Setting, Shape, Slot};

/// `arc(center: C, start: P, end: Q)`: the circular arc below 180° from P to Q, as the rational
/// quadratic with end weights 1.
///
/// With a = P − C, b = Q − C, r² = a·a = b·b and the angle θ between them the middle weight is
/// cos θ/2 = √((r² + a·b)/2r²), and the middle control point is C + (a + b) r²/(r² + a·b).
///
/// - **holds** every point has the distance r from C
pub(super) const KIND: Kind = Kind {
    name: "arc",
    usage: "arc(center: C, start: P, end: Q)",
    slots: &[
        Slot::labelled("center", Shape::Point),
        Slot::labelled("start", Shape::Point),
        Slot::labelled("end", Shape::Point),
    ],
    build,
};

fn build(arguments: &Arguments, setting: &Setting<'_>) -> Result<Coordinates, BuildFault> {
    let [center, start, end] = [0, 1, 2].map(|slot| arguments.point(slot));
    if start.len() != center.len() || end.len() != center.len() {
        let message = "center, start and end need the same number of coordinates";
        return Err(BuildFault::malformed(message));
    }
    let (first, last) = (difference(start, center), difference(end, center));
    let square = dot(&first, &first);
    let other = dot(&last, &last);
    if square != other {
        return Err(BuildFault::Malformed(format!(
            "start and end differ in their distance from the center: the squares are {} and {}",
            square.brief(),
            other.brief()
        )));
    }
    let cosine = dot(&first, &last);
    let sum = &square + &cosine;
    if first == last || sum.is_zero() {
        let message = "an arc turns by more than 0° and less than 180°";
        return Err(BuildFault::malformed(message));
    }
    let weight = &sum / &(&square * &Real::from(2));
    let weight = setting.tower.square_root(&weight)?;
    let stretch = &square / &sum;
    let on_domain = |coefficients: &[Real]| {
        from_bernstein(coefficients, setting.domain.start(), setting.domain.end())
    };
    let coordinate = |axis: usize| {
        let middle = &(&first[axis] + &last[axis]) * &stretch;
        let middle = &(&center[axis] + &middle) * &weight;
        on_domain(&[start[axis].clone(), middle, end[axis].clone()])
    };
    let numerators = (0..center.len()).map(coordinate).collect();
    let weights = on_domain(&[Real::one(), weight.clone(), Real::one()]);
    Ok(Coordinates::rational(weights, numerators))
}

fn difference(point: &[Real], from: &[Real]) -> Vec<Real> {
    point
        .iter()
        .zip(from)
        .map(|(own, from)| own - from)
        .collect()
}

fn dot(left: &[Real], right: &[Real]) -> Real {
    let products = left.iter().zip(right).map(|(left, right)| left * right);
    products.fold(Real::zero(), |sum, own| &sum + &own)
}
