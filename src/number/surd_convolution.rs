//! Products of polynomials over a tower of fields, level by level.

use super::{Generator, Ring, SurdInteger};

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
    use crate::number::{Integer, Real, Tower, convolution};

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
                let sign = if (index + step) % 2 == 0 { 1 } else { -1 };
                let power = u32::try_from(40 * (own % 3)).unwrap_or_default();
                SurdInteger::from_integer(
                    &(Integer::from(own * usize::from(own > 2)) * sign << power),
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
    fn products_by_parts_are_those_number_by_number() {
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
        let (left, right) = (list(12, 1, 2), list(9, 2, 2));
        assert!(by_parts(&left, &right).is_some());
    }
}
