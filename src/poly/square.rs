use super::UniPoly;
use super::image::{Image, place_of};
use super::squarefree::odd_part;
use crate::number::{Field, Integer, Ring};

/// Whether a polynomial is a square up to a constant factor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SquareTest<F: Field> {
    /// p = factor · root², the root primitive; 0 is 0 · 1².
    Square {
        /// The constant factor, of either sign.
        factor: F,
        /// The primitive root, of positive leading coefficient.
        root: UniPoly<F>,
    },
    /// p is no such square.
    NotSquare {
        /// The product of the factors of odd multiplicity, primitive and not constant.
        odd_part: UniPoly<F>,
    },
}

/// Decides whether p = factor · root².
///
/// The candidate is the power-series root of p at infinity, which the upper half of the
/// coefficients determines; squaring it is the proof, and its failure leads to
/// [`odd_part`].
///
/// - **cost** half a multiplication for the root, and one for the proof
#[must_use]
pub fn square_test<F: Field>(polynomial: &UniPoly<F>) -> SquareTest<F> {
    let lead = polynomial.leading_coefficient();
    if polynomial.is_constant() {
        return SquareTest::Square {
            factor: lead,
            root: UniPoly::one(),
        };
    }
    if let Some((factor, root)) = primitive_root(polynomial) {
        return SquareTest::Square { factor, root };
    }
    SquareTest::NotSquare {
        odd_part: odd_part(polynomial),
    }
}

/// The c and the primitive r of positive leading coefficient with p = c r², p not constant.
pub(super) fn primitive_root<F: Field>(polynomial: &UniPoly<F>) -> Option<(F, UniPoly<F>)> {
    let degree = polynomial.degree()?;
    // An image that is no square up to a constant, and not 0, refutes p.
    if degree % 2 == 1 || is_refuted(polynomial) {
        return None;
    }
    let primitive = polynomial.primitive();
    let (root, square, same);
    if primitive.is_rational() {
        root = ring_root(&primitive)?;
        square = &root * &root;
        same = square == primitive;
    } else {
        root = series_root(&primitive)?;
        square = &root * &root;
        same = square.primitive() == primitive;
    }
    let factor = polynomial
        .leading_coefficient()
        .times(&square.leading_coefficient().inverse()?);
    same.then_some((factor, root))
}

/// Whether the image at a place is no square up to a constant.
fn is_refuted<F: Field>(polynomial: &UniPoly<F>) -> bool {
    place_of([polynomial]).is_some_and(|place| !Image::of(polynomial, &place).is_square())
}

/// The candidate over the rational integers. There the square of a primitive polynomial is
/// primitive, so p = r² without a factor: lc(r) = √lc(p), and the next coefficients are
/// (p₂ₙ₋ₖ − Σ rₙ₋ᵢ rₙ₋ₖ₊ᵢ) / 2 lc(r), all in the ring.
fn ring_root<F: Field>(primitive: &UniPoly<F>) -> Option<UniPoly<F>> {
    let (lead, denominator) = primitive.leading_coefficient().square_root()?.into_parts();
    if !denominator.is_one() {
        return None;
    }
    let divisor = lead.plus(&lead);
    let descending = root_series(lead, half_descending(primitive), |rest| {
        rest.quotient(&divisor)
    })?;
    let numerators = descending.into_iter().rev().collect();
    Some(UniPoly::from_numerators(numerators, Integer::from(1)).primitive())
}

/// The candidate over any field, from the primitive p with the rational leading coefficient d.
///
/// In s with 1/x = 4 d s the series p / (d x²ⁿ) = 1 + Σ 4ᵏ dᵏ⁻¹ nₖ sᵏ has the form 1 + 4 X with X
/// over the ring, and √(1 + 4X) has integer coefficients in X.
fn series_root<F: Field>(primitive: &UniPoly<F>) -> Option<UniPoly<F>> {
    let lead = primitive.numerators().last()?.content();
    let mut scale = Integer::from(1);
    let mut scaled = half_descending(primitive);
    for own in scaled.iter_mut().skip(1) {
        scale *= 4;
        *own = own.scaled(&scale);
        scale *= &lead;
    }
    let two = F::Ring::one().plus(&F::Ring::one());
    let descending = root_series(F::Ring::one(), scaled, |rest| rest.quotient(&two))?;
    let mut scale = Integer::from(1);
    let step = lead * 4;
    let mut numerators = Vec::with_capacity(descending.len());
    for own in descending.iter().rev() {
        numerators.push(own.scaled(&scale));
        scale *= &step;
    }
    Some(UniPoly::from_numerators(numerators, Integer::from(1)).primitive())
}

/// p₂ₙ, …, pₙ
fn half_descending<F: Field>(polynomial: &UniPoly<F>) -> Vec<F::Ring> {
    let half = polynomial.numerators().len() / 2;
    polynomial.numerators()[half..]
        .iter()
        .rev()
        .cloned()
        .collect()
}

/// r₀, r₁, … with (Σ rₖ sᵏ)² = Σ cₖ sᵏ as far as the cₖ go, from r₀ = √c₀ and a division by 2 r₀.
fn root_series<R: Ring>(
    lead: R,
    coefficients: Vec<R>,
    halve: impl Fn(R) -> Option<R>,
) -> Option<Vec<R>> {
    let mut series = vec![lead];
    for (order, own) in coefficients.into_iter().enumerate().skip(1) {
        // Σ r_i r_{k−i} over 0 < i < k, each unequal pair once and doubled.
        let mut pairs = R::zero();
        for index in 1..order.div_ceil(2) {
            pairs.add_product(&series[index], &series[order - index]);
        }
        let mut sum = pairs.plus(&pairs);
        if order % 2 == 0 {
            sum.add_product(&series[order / 2], &series[order / 2]);
        }
        series.push(halve(own.minus(&sum))?);
    }
    Some(series)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    fn polynomial(coefficients: &[i64]) -> UniPoly<Rational> {
        let coefficients: Vec<_> = coefficients.iter().copied().map(Rational::from).collect();
        UniPoly::from_coefficients(&coefficients)
    }

    #[test]
    fn both_roads_find_the_planted_root() {
        for root in [&[1, -2, 0, 3][..], &[0, 0, 1], &[5, 1], &[-1, 7, 2, 2, 6]] {
            let root = polynomial(root);
            let square = (&root * &root).scale(&Rational::new((-3).into(), 7.into()));
            let primitive = square.primitive();
            assert_eq!(ring_root(&primitive), Some(root.clone()));
            assert_eq!(series_root(&primitive), Some(root.clone()));
            let SquareTest::Square { factor, root } = square_test(&square) else {
                unreachable!("a square by construction");
            };
            assert_eq!((&root * &root).scale(&factor), square);
        }
    }

    #[test]
    fn near_squares_are_refused_with_their_odd_part() {
        let root = polynomial(&[1, -2, 0, 3]);
        let near = &(&root * &root) + &polynomial(&[1]);
        assert_eq!(
            square_test(&near),
            SquareTest::NotSquare {
                odd_part: near.clone()
            }
        );
        let odd = polynomial(&[-2, 0, 3]);
        let refused = square_test(&(&(&root * &root) * &odd));
        assert_eq!(refused, SquareTest::NotSquare { odd_part: odd });
    }

    #[test]
    fn constants_are_squares_up_to_themselves() {
        for value in [0, 1, -5] {
            let expected = SquareTest::Square {
                factor: Rational::from(value),
                root: polynomial(&[1]),
            };
            assert_eq!(square_test(&polynomial(&[value])), expected);
        }
    }
}
