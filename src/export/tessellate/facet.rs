use crate::export::{Double, Precision};
use crate::number::Integer;

use super::nearest::nearest_unit;
use super::tensor::Numerator;

/// The unit normal of a triangle, of its own points, each component rounded once; none if they lie
/// on a line.
pub(in crate::export) fn facet_normal(
    precision: Precision,
    points: [[Double; 3]; 3],
) -> Option<[Double; 3]> {
    let parts = points.map(|point| point.map(Double::parts));
    let numbers = || parts.iter().flatten();
    let steps = numbers()
        .filter(|(own, _)| *own != 0)
        .map(|(_, step)| *step);
    let least = steps.min().unwrap_or_default();
    // All coordinates in the same steps.
    let [start, second, third] = parts.each_ref().map(|point| {
        point.each_ref().map(|(own, step)| match step - least {
            shift if shift > 0 => own << shift,
            _ => own.clone(),
        })
    });
    let from_start = |end: [Integer; 3]| [0, 1, 2].map(|axis| &end[axis] - &start[axis]);
    let (left, right) = (from_start(second), from_start(third));
    let cross = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &left[i] * &right[j] - &left[j] * &right[i]);
    nearest_unit(precision, &cross.map(Numerator::Rational))
}
