use crate::export::{Double, Precision};
use crate::number::{Integer, Rational, Real, Ring};

use super::tensor::Numerator;

/// Digits behind the point of the first enclosures of irrational numbers that are tried.
const BITS: [u32; 3] = [32, 128, 384];

/// The point of homogeneous coordinates W > 0, X, Y, Z, each coordinate rounded once; none beyond
/// the last number of the format.
pub(super) fn nearest_point(
    precision: Precision,
    [weight, point @ ..]: &[Numerator; 4],
) -> Option<[Double; 3]> {
    let [x, y, z] = point;
    let nearest = |own| Double::nearest_quotient(precision, own, weight);
    Some([nearest(x)?, nearest(y)?, nearest(z)?])
}

/// The unit vector along a vector, each component rounded once; none for 0.
pub(super) fn nearest_unit(precision: Precision, vector: &[Numerator; 3]) -> Option<[Double; 3]> {
    let mut square = Numerator::zero();
    vector.iter().for_each(|own| square.add_product(own, own));
    if square.is_zero() {
        return None;
    }
    let [x, y, z] = vector;
    let nearest = |own| nearest_over_root(precision, own, &square);
    Some([nearest(x)?, nearest(y)?, nearest(z)?])
}

/// The number nearest to a/√s for s > 0.
fn nearest_over_root(
    precision: Precision,
    above: &Numerator,
    square: &Numerator,
) -> Option<Double> {
    let negative = Ring::sign(above).is_lt();
    let nearest = |own: (&Integer, &Integer)| Double::nearest_to_root(precision, negative, own);
    let squared = above.times(above);
    if let (Some(above), Some(below)) = (squared.as_integer(), square.as_integer()) {
        return nearest((above, below));
    }
    let quotient = |left: Rational, right: Rational| {
        let above = left.numerator() * right.denominator();
        let below = left.denominator() * right.numerator();
        let sound = !Ring::sign(&above).is_lt() && Ring::sign(&below).is_gt();
        sound.then(|| nearest((&above, &below)))?
    };
    let agreed = BITS.iter().find_map(|bits| {
        let [[low, high], [least, greatest]] = ends(&squared, square, *bits);
        let (lower, upper) = (quotient(low, greatest)?, quotient(high, least)?);
        (lower == upper).then_some(lower)
    });
    let exact = || &Real::integral(squared.clone()) / &Real::integral(square.clone());
    let decided = || exact().decide(|own| nearest((&own.numerator().abs(), own.denominator())));
    agreed.or_else(decided)
}

/// Bounds of two numbers.
fn ends(one: &Numerator, other: &Numerator, bits: u32) -> [[Rational; 2]; 2] {
    [one, other].map(|own| Real::integral(own.clone()).enclose(bits).ends())
}
