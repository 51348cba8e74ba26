//! Greatest common divisors over the integers from images modulo many primes.

use super::UniPoly;
use super::image::image_gcd;
use crate::number::{Field, Integer, Modulus, Ring};

/// The primitive gcd of two primitive polynomials with rational integers for numerators; none
/// if a numerator is no such integer.
///
/// Modulo a prime that keeps both leading coefficients the monic gcd of the images has at least
/// the degree of the gcd, and for all but finitely many primes it is the image of the gcd. Its
/// multiples with leading coefficient gcd(lc, lc) are joined by the Chinese remainder theorem
/// until they stand still; division by the result is the proof.
pub(super) fn gcd<F: Field>(left: &UniPoly<F>, right: &UniPoly<F>) -> Option<UniPoly<F>> {
    let (high, low) = (integers(left)?, integers(right)?);
    let lead = crate::number::gcd(high.last()?, low.last()?);
    let mut lifted = Lifted::default();
    for modulus in Modulus::descending() {
        let (first, second) = (images(&high, &modulus), images(&low, &modulus));
        if first.last() == Some(&0) || second.last() == Some(&0) {
            continue;
        }
        let mut image = image_gcd(first, second, &modulus);
        if image.len() == 1 {
            return Some(UniPoly::one());
        }
        let scale = modulus.times(
            modulus.embed_integer(&lead),
            modulus.inverse(*image.last()?),
        );
        for own in &mut image {
            *own = modulus.times(*own, scale);
        }
        if lifted.join(&image, &modulus) {
            let numerators = lifted.coefficients.iter().map(F::Ring::from_integer);
            let candidate =
                UniPoly::from_numerators(numerators.collect(), Integer::from(1)).primitive();
            if left.exact_div(&candidate).is_some() && right.exact_div(&candidate).is_some() {
                return Some(candidate);
            }
        }
    }
    None
}

fn integers<F: Field>(polynomial: &UniPoly<F>) -> Option<Vec<&Integer>> {
    polynomial
        .numerators()
        .iter()
        .map(Ring::as_integer)
        .collect()
}

fn images(numerators: &[&Integer], modulus: &Modulus) -> Vec<u64> {
    numerators
        .iter()
        .map(|own| modulus.embed_integer(own))
        .collect()
}

/// Integers known modulo a product of primes, each the one of least absolute value.
#[derive(Default)]
pub(super) struct Lifted {
    pub(super) coefficients: Vec<Integer>,
    pub(super) product: Integer,
}

impl Lifted {
    /// Takes in one more image; true if no coefficient changed. An image of lower degree starts
    /// afresh, one of higher degree is dropped.
    pub(super) fn join(&mut self, image: &[u64], modulus: &Modulus) -> bool {
        if self.coefficients.is_empty() || image.len() < self.coefficients.len() {
            let lifted = image.iter().map(|own| Integer::from(modulus.lift(*own)));
            self.coefficients = lifted.collect();
            self.product = Integer::from(modulus.prime());
            return false;
        }
        if image.len() > self.coefficients.len() {
            return false;
        }
        let inverse = modulus.inverse(modulus.embed_integer(&self.product));
        let mut still = true;
        for (own, target) in self.coefficients.iter_mut().zip(image) {
            let gap = modulus.minus(*target, modulus.embed_integer(own));
            if gap != 0 {
                still = false;
                *own += &self.product * modulus.lift(modulus.times(gap, inverse));
            }
        }
        self.product *= modulus.prime();
        still
    }
}
