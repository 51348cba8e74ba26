use super::image::{Image, place_of, rank};
use super::{BiPoly, Coprimality, UniPoly, gcd};
use crate::number::{Field, Place};

/// The point at which images are taken: an accident, so that few polynomials are singular there.
pub(super) const POINT: u64 = 0x1234_5678_9abc_def1;

/// The greatest divisor d(u) of a polynomial in u alone and of others in u and v, primitive, and
/// how it was proved to be 1 if it is.
///
/// - **cost** one image modulo a prime, at one point v, if the divisor is 1
#[must_use]
pub fn common_factor_u<F: Field>(
    in_u: &UniPoly<F>,
    others: &[&BiPoly<F>],
) -> (UniPoly<F>, Option<Coprimality>) {
    shared(in_u, others, Image::at_v, BiPoly::parts_u)
}

/// The greatest divisor d(v) of a polynomial in v alone and of others in u and v, as
/// [`common_factor_u`] finds that in u.
#[must_use]
pub fn common_factor_v<F: Field>(
    in_v: &UniPoly<F>,
    others: &[&BiPoly<F>],
) -> (UniPoly<F>, Option<Coprimality>) {
    shared(in_v, others, Image::at_u, BiPoly::parts_v)
}

type AtPoint<F> = fn(&BiPoly<F>, u64, &Place) -> Option<Image>;

fn shared<F: Field>(
    alone: &UniPoly<F>,
    others: &[&BiPoly<F>],
    at_point: AtPoint<F>,
    parts: fn(&BiPoly<F>) -> Vec<UniPoly<F>>,
) -> (UniPoly<F>, Option<Coprimality>) {
    if let Some(proof) = coprime_at_point(alone, others, at_point) {
        return (UniPoly::one(), Some(proof));
    }
    let mut common = alone.primitive();
    for part in others.iter().flat_map(|own| parts(own)) {
        if common.degree() == Some(0) {
            break;
        }
        common = gcd(&common, &part);
    }
    let proof = (common.degree() == Some(0)).then_some(Coprimality::Euclid);
    (common, proof)
}

/// The proof by an image at one point that no divisor of a polynomial in one parameter divides all
/// the others: it would divide their values at the point too, and keeps its degree in the image
/// where the first polynomial does, which is not 0.
fn coprime_at_point<F: Field>(
    alone: &UniPoly<F>,
    others: &[&BiPoly<F>],
    at_point: AtPoint<F>,
) -> Option<Coprimality> {
    alone.degree()?;
    let terms = others.iter().flat_map(|own| own.terms());
    let parts = terms.flat_map(|(in_u, in_v)| [in_u, in_v]);
    let place = place_of(parts.chain([alone]))?;
    let mut common = Image::of(alone, &place);
    if common.degree() != alone.degree() {
        return None;
    }
    for other in others {
        if common.degree() == Some(0) {
            break;
        }
        common = common.gcd(at_point(other, POINT, &place)?);
    }
    (common.degree() == Some(0)).then(|| Coprimality::Modular(*place.modulus()))
}

impl<F: Field> BiPoly<F> {
    /// Polynomials in u that have the same common divisors as the coefficients of the powers of v.
    ///
    /// In Σ fₖ(u) gₖ(v) with linearly independent gₖ they are the fₖ: each of these is a
    /// combination of the coefficients, and the other way round.
    pub(super) fn parts_u(&self) -> Vec<UniPoly<F>> {
        let (in_u, in_v): (Vec<_>, Vec<_>) = self.terms().iter().map(|(f, g)| (f, g)).unzip();
        if are_independent(&in_v) {
            in_u.into_iter().cloned().collect()
        } else {
            self.columns()
        }
    }

    /// Polynomials in v that have the same common divisors as the coefficients of the powers of u.
    pub(super) fn parts_v(&self) -> Vec<UniPoly<F>> {
        let (in_u, in_v): (Vec<_>, Vec<_>) = self.terms().iter().map(|(f, g)| (f, g)).unzip();
        if are_independent(&in_u) {
            in_v.into_iter().cloned().collect()
        } else {
            self.rows()
        }
    }
}

/// Whether polynomials are shown to be linearly independent, by their images modulo a prime: an
/// integral relation with coprime coefficients would hold there too.
fn are_independent<F: Field>(polynomials: &[&UniPoly<F>]) -> bool {
    if polynomials.len() == 1 {
        return true;
    }
    let Some(place) = place_of(polynomials.iter().copied()) else {
        return false;
    };
    let images = polynomials.iter().map(|own| Image::of(own, &place));
    rank(images.collect()) == polynomials.len()
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
    fn dependent_factors_do_not_hide_a_divisor() {
        // (1 + u) v + u (v + 2) − (1 + 2u) (v − 1) = 1 + 4u: the terms share no divisor in v, nor
        // do the coefficients, and in u they do
        let terms = [
            (polynomial(&[1, 1]), polynomial(&[0, 1])),
            (polynomial(&[0, 1]), polynomial(&[2, 1])),
            (polynomial(&[1, 2]), polynomial(&[1, -1])),
        ];
        let products = terms.map(|(in_u, in_v)| BiPoly::product(&in_u, &in_v));
        let sum = products.iter().fold(BiPoly::zero(), |sum, own| &sum + own);
        let line = polynomial(&[1, 4]);
        let start = &line * &polynomial(&[-3, 1]);
        assert_eq!(common_factor_u(&start, &[&sum]), (line.clone(), None));
        let (in_v, proof) = common_factor_v(&line, &[&sum]);
        assert!(in_v.is_constant() && proof.is_some());
    }

    #[test]
    fn what_divides_nothing_but_0_too_is_found() {
        // (p u + 1)(v + 2), whose factor in u is lost modulo p
        let prime = Rational::from((crate::number::Integer::from(1) << 61_u32) - 1);
        let line = UniPoly::from_coefficients(&[1.into(), prime]);
        let other = BiPoly::product(&line, &polynomial(&[2, 1]));
        let zero = polynomial(&[]);
        assert_eq!(common_factor_u(&zero, &[&other]), (line.clone(), None));
        assert_eq!(
            common_factor_v(&zero, &[&other]),
            (polynomial(&[2, 1]), None)
        );
        assert_eq!(common_factor_u(&line, &[&other]), (line, None));
    }

    #[test]
    fn planted_divisors_are_found_and_others_refuted_at_a_point() {
        let (in_u, in_v) = (polynomial(&[2, 0, 3]), polynomial(&[-5, 7]));
        let rest = &BiPoly::product(&polynomial(&[1, 1]), &polynomial(&[4, 1]))
            + &BiPoly::product(&polynomial(&[0, 2]), &polynomial(&[1, 0, 6]));
        let whole = &BiPoly::product(&in_u, &in_v) * &rest;
        let (found, proof) = common_factor_u(&(&in_u * &polynomial(&[9, 1])), &[&whole, &whole]);
        assert_eq!((found, proof), (in_u.clone(), None));
        let (found, proof) = common_factor_v(&(&in_v * &polynomial(&[9, 1])), &[&whole]);
        assert_eq!((found, proof), (in_v.clone(), None));
        let (found, proof) = common_factor_u(&in_u, &[&whole, &rest]);
        assert!(found.is_constant());
        assert!(matches!(proof, Some(Coprimality::Modular(_))));
    }
}
