use super::interpolation::Interpolation;
use super::subresultant::Subresultant;
use super::{BiPoly, UniPoly};
use crate::number::{Field, Integer};

/// The resultant: lc(p)ⁿ ∏ q(α) over the roots α of p, n = deg q; 0 if p or q is 0.
#[must_use]
pub fn resultant<F: Field>(left: &UniPoly<F>, right: &UniPoly<F>) -> F {
    let (Some(high), Some(low)) = (left.degree(), right.degree()) else {
        return F::zero();
    };
    let integral = Subresultant::of(left.numerators(), right.numerators()).resultant;
    // Homogeneous of degree n in the coefficients of p, and of degree m in those of q.
    let denominator = (0..low).fold(Integer::from(1), |all, _| all * left.denominator());
    let denominator = (0..high).fold(denominator, |all, _| all * right.denominator());
    F::from_parts(integral, denominator)
}

/// The resultant of p(u, v) and q(u, v) as polynomials in v: a polynomial in u whose roots are
/// the u at which p and q have a common root v, or both lose their degree. 0 if p or q is 0 or
/// they have a common factor in v.
///
/// - **shape** degree ≤ degᵤ p · degᵥ q + degᵤ q · degᵥ p
/// - **cost**  that many univariate resultants, at integers that keep both degrees
#[must_use]
pub fn resultant_v<F: Field>(left: &BiPoly<F>, right: &BiPoly<F>) -> UniPoly<F> {
    let (Some(first), Some(second)) = (left.bidegree(), right.bidegree()) else {
        return UniPoly::zero();
    };
    let bound = first.u * second.v + second.u * first.v;
    let mut interpolation = Interpolation::new();
    for point in Interpolation::<F>::integers() {
        let at = F::from_integer(&Integer::from(point));
        let (high, low) = (left.at_u(&at), right.at_u(&at));
        if high.degree() != Some(first.v) || low.degree() != Some(second.v) {
            continue;
        }
        interpolation.push(point, &UniPoly::constant(&resultant(&high, &low)));
        if interpolation.len() > bound {
            break;
        }
    }
    let rows = interpolation.rows();
    let coefficients: Vec<F> = rows.iter().map(|row| row.coefficient(0)).collect();
    UniPoly::from_coefficients(&coefficients)
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
    fn resultants_are_products_over_the_roots() {
        // roots 1, 2, −3 of 2 (x−1)(x−2)(x+3); times q there and 2 to the degree of q
        let left = polynomial(&[12, -14, 0, 2]);
        for right in [&[5, 0, 1, 1, -1][..], &[3, 1], &[7], &[1, 0, 4], &[-1, 1]] {
            let right = polynomial(right);
            let degree = right.degree().unwrap_or_default();
            let product = [1, 2, -3].map(|root| right.evaluate(&root.into()));
            let product = product
                .iter()
                .fold(Rational::from(1 << degree), |all, own| &all * own);
            assert_eq!(resultant(&left, &right), product);
            let sign = Rational::from(if degree % 2 == 1 { -1 } else { 1 });
            assert_eq!(resultant(&right, &left), &sign * &product);
        }
    }

    #[test]
    fn the_discriminant_of_the_circle_vanishes_at_its_ends() {
        // v² + u² − 1 and 2v: 4 (u² − 1)
        let circle =
            BiPoly::from_rows(&[polynomial(&[-1, 0, 1]), polynomial(&[]), polynomial(&[1])]);
        let found = resultant_v(&circle, &circle.derivative_v());
        assert_eq!(found, polynomial(&[-4, 0, 4]));
    }
}
