//! Greatest common divisors over fields of square roots, from images at all places above primes
//! that split the field.

use super::UniPoly;
use super::image::{Image, image_gcd};
use super::modular::Lifted;
use crate::number::{Conjugates, Field, Integer, Modulus, Ring, lcm};

/// Generators of a field for which primes that split it are looked for: they become rare.
const GENERATORS: usize = 4;
/// Primes that are tried.
const PRIMES: usize = 4_000;

/// The monic gcd of two polynomials up to a constant factor; none if the field is too large for
/// this road, or no prime splits it.
///
/// At a place that keeps both leading coefficients the gcd of the images has at least the degree of
/// the gcd; where the degrees agree at all places above a prime, the images of the monic gcd's
/// coefficients give their components modulo the prime. The Chinese remainder theorem joins them,
/// rational reconstruction reads them, and division is the proof.
pub(super) fn gcd<F: Field>(left: &UniPoly<F>, right: &UniPoly<F>) -> Option<UniPoly<F>> {
    let basis = F::Ring::basis(left.numerators().iter().chain(right.numerators()));
    if basis.generators().len() > GENERATORS {
        return None;
    }
    let mut lifted = Lifted::default();
    let (mut primes, mut next) = (0_usize, 1);
    for modulus in Modulus::descending().take(PRIMES) {
        let Some(conjugates) = Conjugates::above(&basis, &modulus) else {
            continue;
        };
        let Some(images) = images(left, right, &conjugates) else {
            continue;
        };
        if images.is_empty() {
            return Some(UniPoly::one());
        }
        lifted.join(&images, &modulus);
        primes += 1;
        if primes < next {
            continue;
        }
        next = (primes * 3).div_ceil(2).max(primes + 1);
        let numbers = lifted.fractions(conjugates.places().len());
        let candidate = numbers.map(|rows| {
            let coefficients = rows.iter().map(|(components, denominator)| {
                let numerator = F::Ring::from_components(&basis, components);
                F::from_parts(numerator, denominator.clone())
            });
            let coefficients: Vec<F> = coefficients.chain([F::one()]).collect();
            UniPoly::from_coefficients(&coefficients).primitive()
        });
        if let Some(candidate) = candidate
            && left.exact_div(&candidate).is_some()
            && right.exact_div(&candidate).is_some()
        {
            return Some(candidate);
        }
    }
    None
}

/// The components of the monic gcd's coefficients below the leading one, modulo a prime, one
/// coefficient after the other; none if the prime is unlucky.
fn images<F: Field>(
    left: &UniPoly<F>,
    right: &UniPoly<F>,
    conjugates: &Conjugates,
) -> Option<Vec<u64>> {
    let modulus = conjugates.modulus();
    let mut rows: Vec<Vec<u64>> = Vec::new();
    for place in conjugates.places() {
        let (high, low) = (Image::of(left, place), Image::of(right, place));
        if high.degree() != left.degree() || low.degree() != right.degree() {
            return None;
        }
        let mut image = image_gcd(high.into_coefficients(), low.into_coefficients(), modulus);
        let inverse = modulus.inverse(image.pop()?);
        for own in &mut image {
            *own = modulus.times(*own, inverse);
        }
        if rows.first().is_some_and(|first| first.len() != image.len()) {
            return None;
        }
        rows.push(image);
    }
    let length = rows.first()?.len();
    let columns = (0..length).map(|index| {
        let column: Vec<u64> = rows.iter().map(|row| row[index]).collect();
        conjugates.components(&column)
    });
    Some(columns.flatten().collect())
}

impl Lifted {
    /// The numbers as fractions, in groups over one denominator; none if one of them is not known
    /// yet.
    fn fractions(&self, group: usize) -> Option<Vec<(Vec<Integer>, Integer)>> {
        let groups = self.coefficients.chunks(group).map(|own| {
            let parts = own.iter().map(|own| fraction(own, &self.product));
            let parts: Vec<(Integer, Integer)> = parts.collect::<Option<_>>()?;
            let one = Integer::from(1);
            let common = parts.iter().fold(one, |common, (_, own)| lcm(&common, own));
            let numerators = parts
                .iter()
                .map(|(numerator, own)| numerator * (&common / own));
            Some((numerators.collect(), common))
        });
        groups.collect()
    }
}

/// The n/d with n = a d modulo m and n, d at most √(m/2) in absolute value, if there is one.
///
/// It is among the remainders of Euclid's algorithm with their cofactors.   (Wang)
fn fraction(residue: &Integer, modulus: &Integer) -> Option<(Integer, Integer)> {
    let bound = (modulus >> 1_u32).sqrt();
    let (mut high, mut low) = (modulus.clone(), residue.div_mod_floor(modulus).1);
    let (mut before, mut cofactor) = (Integer::from(0), Integer::from(1));
    while low > bound {
        let quotient = &high / &low;
        let next = &before - &quotient * &cofactor;
        (before, cofactor) = (cofactor, next);
        let rest = &high - &quotient * &low;
        (high, low) = (low, rest);
    }
    if cofactor.abs() > bound || cofactor.is_zero() {
        return None;
    }
    Some(if Ring::sign(&cofactor).is_lt() {
        (-low, -cofactor)
    } else {
        (low, cofactor)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Surd, Tower};

    #[test]
    fn planted_divisors_over_nested_roots_are_found() {
        let tower = Tower::default();
        let number = |value: i64| Surd::from(value);
        let root = |own: &Surd| tower.square_root(own).unwrap_or_else(|_| Surd::from(0));
        let two = root(&number(2));
        let nested = root(&(&(&number(40) * &two) - &number(35)));
        let polynomial = |own: &[&Surd]| {
            let own: Vec<Surd> = own.iter().map(|own| (*own).clone()).collect();
            UniPoly::from_coefficients(&own)
        };
        let (one, three) = (number(1), &number(3) + &two);
        let common = polynomial(&[&nested, &three, &(&nested * &two), &one]);
        let left = &common * &polynomial(&[&two, &one, &three]);
        let right = &common * &polynomial(&[&one, &nested, &one, &two]);
        assert_eq!(gcd(&left, &right), Some(common.primitive()));
        let coprime = polynomial(&[&two, &one]);
        assert_eq!(gcd(&left, &(&coprime + &left)), Some(UniPoly::one()));
    }
}
