use super::conjugate_gcd;
use super::image::{Image, place_of};
use super::modular;
use super::subresultant::Subresultant;
use super::{Coprimality, UniPoly};
use crate::number::{Field, Ring};

/// The greatest common divisor in the normal form of [`UniPoly::primitive`]; gcd(0, 0) = 0.
///
/// - **holds** it divides both, and every common divisor divides it
/// - **cost** one image modulo a prime if the polynomials are coprime; images modulo many primes
///   over ℚ and fields of few square roots, a subresultant sequence over others
#[must_use]
pub fn gcd<F: Field>(left: &UniPoly<F>, right: &UniPoly<F>) -> UniPoly<F> {
    if left.is_zero() {
        return right.primitive();
    }
    if right.is_zero() {
        return left.primitive();
    }
    if left.is_constant() || right.is_constant() {
        return UniPoly::one();
    }
    match image_gcd_degree(&[left, right]) {
        Some(0) => UniPoly::one(),
        bound => gcd_exact(left, right, bound),
    }
}

/// The greatest common divisor of all, primitive; 0 for none. Stops at 1.
///
/// The first two polynomials of lowest degree decide most lists.
#[must_use]
pub fn gcd_all<'a, F: Field>(polynomials: impl IntoIterator<Item = &'a UniPoly<F>>) -> UniPoly<F> {
    let mut list: Vec<_> = polynomials
        .into_iter()
        .filter(|polynomial| !polynomial.is_zero())
        .collect();
    list.sort_by_key(|polynomial| polynomial.degree());
    let Some((first, rest)) = list.split_first() else {
        return UniPoly::zero();
    };
    if first.is_constant() || (list.len() > 1 && image_gcd_degree(&list) == Some(0)) {
        return UniPoly::one();
    }
    let mut common = first.primitive();
    for polynomial in rest {
        if common.is_constant() {
            break;
        }
        common = gcd(&common, polynomial);
    }
    common
}

/// The least common multiple, of coprime integers as [`UniPoly::integral`] has them; 0 if one of
/// them is 0.
#[must_use]
pub fn lcm<F: Field>(left: &UniPoly<F>, right: &UniPoly<F>) -> UniPoly<F> {
    if right.is_constant() && !right.is_zero() {
        return left.integral();
    }
    if left == right || (left.is_constant() && !left.is_zero()) {
        return right.integral();
    }
    let common = gcd(left, right);
    left.exact_div(&common)
        .map_or_else(UniPoly::zero, |quotient| (&quotient * right).integral())
}

/// The evidence that no non-constant polynomial divides every polynomial of the list; none if
/// one does.
#[must_use]
pub fn certify_coprime<F: Field>(polynomials: &[&UniPoly<F>]) -> Option<Coprimality> {
    let list: Vec<_> = polynomials
        .iter()
        .copied()
        .filter(|polynomial| !polynomial.is_zero())
        .collect();
    if image_gcd_degree(&list) == Some(0) {
        let place = place_of(list.iter().copied())?;
        return Some(Coprimality::Modular(*place.modulus()));
    }
    (gcd_all(list).degree() == Some(0)).then_some(Coprimality::Euclid)
}

/// The degree of the gcd of the images at a place, an upper bound for the degree of the gcd;
/// none if there are no images or every leading coefficient vanishes in them.
///
/// The bound holds as soon as one leading coefficient is kept. For let g divide every pᵢ, take a
/// valuation ring above the prime and scale g to be primitive over it. By Gauss's lemma the
/// cofactors pᵢ / g lie over that ring too; where lc(pᵢ) is a unit, so is lc(g): the image of g
/// keeps its degree, and divides all images.
fn image_gcd_degree<F: Field>(polynomials: &[&UniPoly<F>]) -> Option<usize> {
    let place = place_of(polynomials.iter().copied())?;
    let mut kept = false;
    let mut common: Option<Image> = None;
    for polynomial in polynomials {
        let image = Image::of(polynomial, &place);
        kept |= image.degree() == polynomial.degree() && !polynomial.is_zero();
        common = Some(match common {
            Some(common) => common.gcd(image),
            None => image,
        });
        if kept && common.as_ref().and_then(Image::degree) == Some(0) {
            return Some(0);
        }
    }
    if kept { common?.degree() } else { None }
}

/// The gcd of two non-constant polynomials whose gcd has at most the given degree.
fn gcd_exact<F: Field>(left: &UniPoly<F>, right: &UniPoly<F>, bound: Option<usize>) -> UniPoly<F> {
    let (high, low) = if left.degree() < right.degree() {
        (right, left)
    } else {
        (left, right)
    };
    if bound.is_none_or(|bound| Some(bound) == low.degree()) && high.exact_div(low).is_some() {
        return low.primitive();
    }
    let (high, low) = (high.primitive(), low.primitive());
    let road = if high.is_rational() && low.is_rational() {
        modular::gcd(&high, &low)
    } else {
        conjugate_gcd::gcd(&high, &low)
    };
    if let Some(common) = road {
        return common;
    }
    let last = Subresultant::of(high.numerators(), low.numerators());
    UniPoly::from_numerators(last.polynomial, F::Ring::one().content()).primitive()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Modulus, Rational};

    fn polynomial(coefficients: &[i64]) -> UniPoly<Rational> {
        let coefficients: Vec<_> = coefficients.iter().copied().map(Rational::from).collect();
        UniPoly::from_coefficients(&coefficients)
    }

    #[test]
    fn the_planted_divisor_is_found_on_every_road() {
        let common = polynomial(&[-3, 0, 2, 5]);
        let (left, right) = (polynomial(&[1, 1, 4, 1]), polynomial(&[7, -2, 0, 0, 3]));
        let (high, low) = (&right * &common, &left * &common);
        assert_eq!(gcd(&high, &low), common);
        assert_eq!(modular::gcd(&high, &low), Some(common.clone()));
        let road = Subresultant::of(high.numerators(), low.numerators());
        let road = UniPoly::<Rational>::from_numerators(road.polynomial, 1.into());
        assert_eq!(road.primitive(), common);
        assert_eq!(lcm(&high, &low), (&(&left * &right) * &common).primitive());
    }

    #[test]
    fn zeros_and_constants_have_the_conventional_divisors() {
        let (zero, two) = (polynomial(&[]), polynomial(&[2]));
        let line = polynomial(&[2, -4]);
        assert_eq!(gcd(&zero, &zero), zero);
        assert_eq!(gcd(&zero, &line), polynomial(&[-1, 2]));
        assert_eq!(gcd(&two, &line), polynomial(&[1]));
        assert_eq!(gcd_all([&zero, &line, &zero]), polynomial(&[-1, 2]));
        assert_eq!(gcd_all(std::iter::empty::<&UniPoly<Rational>>()), zero);
        assert_eq!(lcm(&zero, &line), zero);
        assert_eq!(certify_coprime(&[&zero, &line]), None);
        assert_eq!(
            certify_coprime(&[&zero, &two]),
            Some(Coprimality::Modular(Modulus::mersenne()))
        );
    }

    #[test]
    fn a_bad_prime_proves_nothing() {
        // p x + 1 and p x + 2 become constants modulo p = 2⁶¹ − 1: coprime all the same, but
        // not by that image.
        let prime = (1 << 61) - 1;
        let (left, right) = (polynomial(&[1, prime]), polynomial(&[2, prime]));
        assert_eq!(certify_coprime(&[&left, &right]), Some(Coprimality::Euclid));
        let common = &left * &polynomial(&[1, 1]);
        assert_eq!(certify_coprime(&[&left, &common]), None);
        assert_eq!(gcd(&left, &common), left);
    }

    #[test]
    fn a_list_may_be_coprime_though_no_pair_is() {
        let (x, y, z) = (
            polynomial(&[1, 1]),
            polynomial(&[2, 1]),
            polynomial(&[3, 1]),
        );
        let list = [&x * &y, &y * &z, &z * &x];
        assert_eq!(gcd_all(&list), polynomial(&[1]));
        assert_eq!(
            certify_coprime(&list.iter().collect::<Vec<_>>()),
            Some(Coprimality::Modular(Modulus::mersenne()))
        );
    }
}
