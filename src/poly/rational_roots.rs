use super::UniPoly;
use crate::number::{Field, Integer, Modulus, Rational, Ring};

/// The roots of a square-free polynomial that are seen to lie in the field: the rational roots
/// if its numerators are rational integers, and those of linear and quadratic polynomials.
///
/// - **holds** each is a root; over ℚ no rational root is missing
pub(super) fn roots_in_field<F: Field>(polynomial: &UniPoly<F>) -> Vec<F> {
    match polynomial.degree() {
        Some(0) | None => Vec::new(),
        Some(1 | 2) => quadratic_roots(polynomial).unwrap_or_default(),
        Some(_) => integer_roots(polynomial).unwrap_or_default(),
    }
}

/// The roots −c₀/c₁, or (−c₁ ± √(c₁² − 4 c₀ c₂)) / 2 c₂ where the square root lies in the field.
fn quadratic_roots<F: Field>(polynomial: &UniPoly<F>) -> Option<Vec<F>> {
    let [constant, linear, square] = [0, 1, 2].map(|power| polynomial.coefficient(power));
    let Some(inverse) = square.plus(&square).inverse() else {
        return Some(vec![constant.negated().times(&linear.inverse()?)]);
    };
    let four = F::from_integer(&Integer::from(4));
    let product = four.times(&constant).times(&square);
    let radical = linear.times(&linear).minus(&product).square_root()?;
    let roots = [radical.clone(), radical.negated()];
    Some(roots.map(|own| own.minus(&linear).times(&inverse)).to_vec())
}

/// The rational roots of a square-free polynomial with integer numerators, by Newton's
/// iteration in the q-adic integers from the roots modulo a small prime q.
///
/// A rational root r = a/b has b | lc and a | c₀, so lc · r is an integer of absolute value at
/// most |lc c₀|, and its residue modulo a number above 2 |lc c₀| shows it.
fn integer_roots<F: Field>(polynomial: &UniPoly<F>) -> Option<Vec<F>> {
    let mut numerators: Vec<Integer> = polynomial
        .primitive()
        .numerators()
        .iter()
        .map(|own| own.as_integer().cloned())
        .collect::<Option<_>>()?;
    let mut roots = Vec::new();
    if Ring::is_zero(&numerators[0]) {
        numerators.remove(0);
        roots.push(F::zero());
    }
    let (lead, constant) = (numerators.last()?.clone(), numerators.first()?.clone());
    let bound = Ring::content(&(&lead * &constant)) * 2;
    let (prime, simple) = simple_roots_modulo_a_prime(&numerators)?;
    for root in simple {
        let (root, modulus) = lift(&numerators, root, prime, &bound);
        let numerator = symmetric(&(&root * &lead), &modulus);
        if vanishes_modulo(&numerators, &numerator, &lead) {
            let root = Rational::new(numerator, lead.clone());
            let line = [-root.numerator(), root.denominator().clone()];
            let line = line.iter().map(F::Ring::from_integer).collect();
            let line = UniPoly::<F>::from_numerators(line, Integer::from(1));
            if polynomial.exact_div(&line).is_some() {
                let numerator = F::Ring::from_integer(root.numerator());
                roots.push(F::from_parts(numerator, root.denominator().clone()));
            }
        }
    }
    Some(roots)
}

/// The roots modulo a prime that keeps the leading coefficient and modulo which every root is
/// simple. Only the primes that divide the leading coefficient or the discriminant fail.
fn simple_roots_modulo_a_prime(numerators: &[Integer]) -> Option<(u32, Vec<u32>)> {
    let is_prime = |number: &u32| {
        (2..*number)
            .take_while(|d| d * d <= *number)
            .all(|d| !number.is_multiple_of(d))
    };
    for prime in (5..1 << 16).filter(is_prime) {
        let images: Vec<u64> = numerators.iter().map(|own| remainder(own, prime)).collect();
        if images.last() == Some(&0) {
            continue;
        }
        let mut roots = Vec::new();
        let mut simple = true;
        for at in 0..prime {
            let (value, slope) = horner(&images, at.into(), prime.into());
            if value == 0 {
                simple &= slope != 0;
                roots.push(at);
            }
        }
        if simple {
            return Some((prime, roots));
        }
    }
    None
}

fn remainder(value: &Integer, modulus: u32) -> u64 {
    let remainder = ((value % modulus) + modulus) % modulus;
    u64::try_from(remainder).unwrap_or_default()
}

/// p(a) and p′(a) modulo a small prime.
fn horner(images: &[u64], at: u64, prime: u64) -> (u64, u64) {
    images.iter().rev().fold((0, 0), |(value, slope), own| {
        ((value * at + own) % prime, (slope * at + value) % prime)
    })
}

/// The root of p above a simple root modulo q, to a power of q above the bound: Newton's
/// iteration for the root and for the inverse of p′ there, doubling the precision.
fn lift(numerators: &[Integer], root: u32, prime: u32, bound: &Integer) -> (Integer, Integer) {
    let images: Vec<u64> = numerators.iter().map(|own| remainder(own, prime)).collect();
    let (_, slope) = horner(&images, root.into(), prime.into());
    let inverse = (1..prime).find(|&own| u64::from(own) * slope % u64::from(prime) == 1);
    let (mut root, mut modulus) = (Integer::from(root), Integer::from(prime));
    let mut inverse = Integer::from(inverse.unwrap_or(1));
    while modulus <= *bound {
        modulus = &modulus * &modulus;
        let (mut value, mut slope) = (Integer::from(0), Integer::from(0));
        for own in numerators.iter().rev() {
            slope = (slope * &root + &value) % &modulus;
            value = (value * &root + own) % &modulus;
        }
        // The inverse belongs to the last root, whose slope agrees with this one to half the
        // digits; one step makes it good to all digits of this root.
        inverse = (&inverse * (Integer::from(2) - slope * &inverse)) % &modulus;
        root = (&root - value * &inverse) % &modulus;
    }
    (root, modulus)
}

/// The residue of least absolute value.
fn symmetric(value: &Integer, modulus: &Integer) -> Integer {
    let remainder = ((value % modulus) + modulus) % modulus;
    if &remainder * 2 > *modulus {
        remainder - modulus
    } else {
        remainder
    }
}

/// Whether Σ cₖ aᵏ bⁿ⁻ᵏ vanishes modulo 2⁶¹ − 1.
fn vanishes_modulo(numerators: &[Integer], numerator: &Integer, denominator: &Integer) -> bool {
    let modulus = Modulus::mersenne();
    let [at, scale] = [numerator, denominator].map(|own| modulus.embed_integer(own));
    let mut power = modulus.one();
    let mut value = 0;
    for own in numerators.iter().rev() {
        let term = modulus.times(modulus.embed_integer(own), power);
        value = modulus.plus(modulus.times(value, at), term);
        power = modulus.times(power, scale);
    }
    value == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planted_rational_roots_are_all_found() {
        let planted = ["-7/3", "0", "1/3", "1000003/999983", "22/7"]
            .map(|text| text.parse::<Rational>().unwrap_or_else(|()| 0.into()));
        let coefficients: Vec<Rational> = [-2, 0, 0, 1].map(Rational::from).to_vec();
        let mut product = UniPoly::from_coefficients(&coefficients);
        for root in &planted {
            product = &product * &UniPoly::from_coefficients(&[-root, Rational::from(1)]);
        }
        let mut found = roots_in_field(&product);
        found.sort();
        assert_eq!(found, planted);
    }

    #[test]
    fn irrational_roots_are_not_in_the_field() {
        for coefficients in [
            &[-2, 0, 1][..],
            &[1, 0, 1],
            &[-2, 0, 0, 1],
            &[1, 1, 1, 1, 1],
        ] {
            let coefficients: Vec<_> = coefficients.iter().copied().map(Rational::from).collect();
            assert_eq!(
                roots_in_field(&UniPoly::from_coefficients(&coefficients)),
                []
            );
        }
    }
}
