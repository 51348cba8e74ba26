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
    if let Some(unit) = unit_by_leading(precision, vector) {
        return Some(unit);
    }
    let mut square = Numerator::zero();
    vector.iter().for_each(|own| square.add_product(own, own));
    if square.is_zero() {
        return None;
    }
    let [x, y, z] = vector;
    let nearest = |own| nearest_over_root(precision, own, &square);
    Some([nearest(x)?, nearest(y)?, nearest(z)?])
}

/// The same by leading digits; none where these do not decide, and for 0.
fn unit_by_leading(precision: Precision, vector: &[Numerator; 3]) -> Option<[Double; 3]> {
    let [x, y, z] = vector.each_ref().map(Ring::leading);
    let leading = [x?, y?, z?];
    let [x, y, z] = leading.map(|own| own.times(own));
    let squares = [x?, y?, z?];
    let inverse = squares[0].plus(squares[1])?.plus(squares[2])?.inverse()?;
    let nearest = |axis: usize| {
        let negative = leading[axis].sign().is_lt();
        Double::nearest_to_root_of_leading(precision, negative, squares[axis].times(inverse)?)
    };
    Some([nearest(0)?, nearest(1)?, nearest(2)?])
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Field, Tower};

    /// Numbers of all lengths and signs: rational, of two square roots, and such as nearly cancel.
    fn numerators() -> Vec<Numerator> {
        let tower = Tower::new(4);
        let root = |own: i64| {
            tower
                .square_root(&Real::from(own))
                .unwrap_or_else(|_| Real::zero())
        };
        let (two, five) = (root(2), root(5));
        let near = &(&two * &Real::from(985)) - &Real::from(1_393);
        let long = &near.power(9).unwrap_or_else(Real::zero) * &five;
        let numbers = [
            Real::zero(),
            Real::one(),
            Real::from(-48),
            Real::power_of_two(200),
            &Real::power_of_two(130) + &two,
            two,
            -&five,
            near,
            long,
        ];
        numbers.iter().map(|own| own.numerator().clone()).collect()
    }

    #[test]
    fn leading_digits_round_unit_vectors_as_exact_numbers_do() {
        let numbers = numerators();
        let mut decided = 0;
        for (index, x) in numbers.iter().enumerate() {
            for (y, z) in numbers.iter().zip(numbers.iter().cycle().skip(index)) {
                let vector = [x.clone(), y.clone(), z.clone()];
                for precision in [Precision::Single, Precision::Double] {
                    let Some(quick) = unit_by_leading(precision, &vector) else {
                        continue;
                    };
                    let mut square = Numerator::zero();
                    vector.iter().for_each(|own| square.add_product(own, own));
                    let exact = vector
                        .each_ref()
                        .map(|own| nearest_over_root(precision, own, &square));
                    assert_eq!(exact, quick.map(Some), "{vector:?}");
                    decided += 1;
                }
            }
        }
        assert!(decided > 100, "{decided}");
        let zero = || Numerator::zero();
        assert_eq!(
            nearest_unit(Precision::Double, &[zero(), zero(), zero()]),
            None
        );
    }
}
