//! Polynomials over a tower of fields, as lists of coefficients, level by level.

use super::{Generator, Ring, SurdInteger, binomial_sums};

/// Lists shorter than this are multiplied number by number.
const SHORT: usize = 3;

/// The coefficients of the product of two polynomials p + q√a and r + s√a whose parts lie below
/// the level of √a, the highest of any coefficient; none if that is the ground, or for short lists.
///
/// p r + a q s + ((p + q)(r + s) − p r − q s) √a.   (Karatsuba)
pub(super) fn by_parts(left: &[SurdInteger], right: &[SurdInteger]) -> Option<Vec<SurdInteger>> {
    if left.len().min(right.len()) < SHORT {
        return None;
    }
    let generators = left.iter().chain(right).filter_map(SurdInteger::level);
    let generator = generators.max_by_key(|own| own.level())?.clone();
    let [(p, q), (r, s)] = [left, right].map(|list| parts(list, &generator));
    let product = |one: &[_], other: &[_]| SurdInteger::convolution(one, other);
    let join = |(constant, slope)| SurdInteger::binomial(constant, slope, &generator);
    if vanishes(&q) || vanishes(&s) {
        let constants = product(&p, &r);
        let slopes = if vanishes(&q) {
            product(&p, &s)
        } else {
            product(&q, &r)
        };
        return Some(constants.into_iter().zip(slopes).map(join).collect());
    }
    let (constants, squares) = (product(&p, &r), product(&q, &s));
    let mixed = product(&sums(&p, &q), &sums(&r, &s));
    let parts = constants.into_iter().zip(squares).zip(mixed);
    let coefficients = parts.map(|((mut constant, square), mixed)| {
        let slope = mixed.minus(&constant).minus(&square);
        constant.add_product(&square, generator.square());
        join((constant, slope))
    });
    Some(coefficients.collect())
}

/// The coefficients of Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ, where some aₖ is irrational.
pub(super) fn sums_by_parts(powers: &[SurdInteger], degree: usize) -> Vec<SurdInteger> {
    let generators = powers.iter().filter_map(SurdInteger::level);
    let Some(generator) = generators.max_by_key(|own| own.level()).cloned() else {
        return binomial_sums::one_by_one(powers, degree);
    };
    let (constants, slopes) = parts(powers, &generator);
    let [constants, slopes] =
        [constants, slopes].map(|own| SurdInteger::binomial_sums(&own, degree));
    let pairs = constants.into_iter().zip(slopes);
    pairs
        .map(|(constant, slope)| SurdInteger::binomial(constant, slope, &generator))
        .collect()
}

/// The a and the b of numbers a + b√aₖ.
fn parts(list: &[SurdInteger], generator: &Generator) -> (Vec<SurdInteger>, Vec<SurdInteger>) {
    let part = |own: &SurdInteger| match own {
        SurdInteger::Irrational(own) if own.generator.level() == generator.level() => {
            (own.constant.clone(), own.slope.clone())
        }
        own => (own.clone(), SurdInteger::zero()),
    };
    list.iter().map(part).unzip()
}

fn vanishes(list: &[SurdInteger]) -> bool {
    list.iter().all(Ring::is_zero)
}

fn sums(one: &[SurdInteger], other: &[SurdInteger]) -> Vec<SurdInteger> {
    one.iter().zip(other).map(|(a, b)| a.plus(b)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Integer, Real, Tower, binomial_sums, convolution};

    /// a + b√2 + (c + d√2) √3 with numbers that grow, of any sign, and many of them 0.
    fn list(length: usize, seed: usize, levels: usize) -> Vec<SurdInteger> {
        let tower = Tower::new(4);
        let roots = [2, 3].map(|own| tower.square_root(&Real::from(own)));
        let [two, three] = roots.map(|own| own.map(|own| own.numerator().clone()));
        let (Ok(two), Ok(three)) = (two, three) else {
            return Vec::new();
        };
        let number = |index: usize| {
            let digit = |step: usize| {
                let own = (index * index + seed * step + 5 * step) % 7;
                let sign = if (index + step).is_multiple_of(2) {
                    1
                } else {
                    -1
                };
                let power = u32::try_from(40 * (own % 3)).unwrap_or_default();
                SurdInteger::from_integer(
                    &((Integer::from(own * usize::from(own > 2)) * sign) << power),
                )
            };
            let below = |step: usize| match levels {
                0 => digit(step),
                _ => digit(step).plus(&two.times(&digit(step + 1))),
            };
            match levels {
                2 => below(1).plus(&three.times(&below(3))),
                _ => below(1),
            }
        };
        (0..length).map(number).collect()
    }

    #[test]
    fn what_is_made_by_parts_is_what_is_made_number_by_number() {
        for seed in 0..30 {
            for lengths in [(3, 3), (3, 9), (12, 10)] {
                for levels in [(0, 1), (1, 1), (2, 0), (2, 1), (2, 2)] {
                    let left = list(lengths.0, seed, levels.0);
                    let right = list(lengths.1, seed + 1, levels.1);
                    let product = by_parts(&left, &right);
                    let expected = convolution::one_by_one(&left, &right);
                    assert!(
                        product.is_none_or(|own| own == expected),
                        "{left:?} {right:?}"
                    );
                }
            }
        }
        for levels in 0..3 {
            let powers = list(12, 5, levels);
            let expected = binomial_sums::one_by_one(&powers, 14);
            assert_eq!(SurdInteger::binomial_sums(&powers, 14), expected);
        }
        let (left, right) = (list(12, 1, 2), list(9, 2, 2));
        assert!(by_parts(&left, &right).is_some());
    }
}
