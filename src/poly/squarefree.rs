use super::UniPoly;
use super::gcd::gcd;
use crate::number::Field;

/// The square-free factorisation p = c ∏ fᵢⁱ: primitive non-constant fᵢ, square-free and pairwise
/// coprime, with ascending multiplicities i. Empty for a constant.
///
/// With c = gcd(p, p′), w = p/c, y = p′/c the difference y − w′ = Σ (i−1) fᵢ′ w/fᵢ shares with w
/// just f₁; and so on. (Yun's method)
#[must_use]
pub fn square_free<F: Field>(polynomial: &UniPoly<F>) -> Vec<(UniPoly<F>, u32)> {
    if polynomial.is_constant() {
        return Vec::new();
    }
    let primitive = polynomial.primitive();
    let derivative = primitive.derivative();
    let common = gcd(&primitive, &derivative);
    if common.is_constant() {
        return vec![(primitive, 1)];
    }
    let divide = |dividend: &UniPoly<F>, divisor: &UniPoly<F>| {
        dividend.exact_div(divisor).unwrap_or_else(UniPoly::zero)
    };
    let mut radical = divide(&primitive, &common);
    let mut rest = &divide(&derivative, &common) - &radical.derivative();
    let mut factors = Vec::new();
    for multiplicity in 1.. {
        if radical.is_constant() {
            break;
        }
        let factor = gcd(&radical, &rest);
        radical = divide(&radical, &factor);
        rest = &divide(&rest, &factor) - &radical.derivative();
        if !factor.is_constant() {
            factors.push((factor, multiplicity));
        }
    }
    factors
}

/// The product of the factors of odd multiplicity, primitive; 1 if there is none.
#[must_use]
pub fn odd_part<F: Field>(polynomial: &UniPoly<F>) -> UniPoly<F> {
    square_free(polynomial)
        .iter()
        .filter(|(_, multiplicity)| multiplicity % 2 == 1)
        .fold(UniPoly::one(), |product, (factor, _)| &product * factor)
        .primitive()
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
    fn planted_multiplicities_are_found() {
        let (first, third, fourth) = (
            polynomial(&[-2, 0, 1]),
            polynomial(&[1, 3]),
            polynomial(&[0, 1]),
        );
        let product = &(&first * &third.power(3)) * &fourth.power(4);
        let product = product.scale(&Rational::from(-7));
        assert_eq!(
            square_free(&product),
            [(first.clone(), 1), (third.clone(), 3), (fourth, 4)]
        );
        assert_eq!(odd_part(&product), &first * &third);
    }

    #[test]
    fn constants_have_no_factors() {
        assert_eq!(square_free(&polynomial(&[])), []);
        assert_eq!(square_free(&polynomial(&[-3])), []);
        assert_eq!(odd_part(&polynomial(&[0, 0, 5])), polynomial(&[1]));
    }
}
