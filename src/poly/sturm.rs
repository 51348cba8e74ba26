use super::UniPoly;
use super::gcd::gcd;
use crate::number::{Field, Integer};

/// The number of distinct real roots in the closed interval [from, to]; 0 for the polynomial 0,
/// whose roots cannot be counted.
///
/// By Sturm's theorem: a root at an end is divided out and counted; in between, the sequence
/// p, p′, −rem, … loses one change of sign per root. A road of its own beside
/// [`real_roots`](super::real_roots).
#[must_use]
pub fn count_roots<F: Field>(polynomial: &UniPoly<F>, from: &F, to: &F) -> usize {
    if polynomial.is_constant() || from > to {
        return 0;
    }
    let repeated = gcd(polynomial, &polynomial.derivative());
    let Some(mut radical) = polynomial.exact_div(&repeated) else {
        return 0;
    };
    let mut count = 0;
    for end in [from, to] {
        let line = UniPoly::from_coefficients(&[end.negated(), F::one()]);
        if let Some(quotient) = radical.exact_div(&line) {
            radical = quotient;
            count += 1;
        }
    }
    let sequence = sturm_sequence(&radical);
    count + changes(&sequence, from).saturating_sub(changes(&sequence, to))
}

/// p, p′, and the negated remainders up to positive factors.
fn sturm_sequence<F: Field>(radical: &UniPoly<F>) -> Vec<UniPoly<F>> {
    let mut sequence = vec![radical.clone(), radical.derivative()];
    while let [.., high, low] = sequence.as_slice()
        && let Some((_, remainder)) = high.div_rem(low)
    {
        let content = remainder.content();
        let positive = remainder.numerators().iter();
        let divided = positive.map(|own| {
            let negated = crate::number::Ring::negated(own);
            crate::number::Ring::divided(&negated, &content)
        });
        sequence.push(UniPoly::from_numerators(
            divided.collect(),
            Integer::from(1),
        ));
    }
    sequence
}

/// The number of changes of sign along the sequence, zeros left out.
fn changes<F: Field>(sequence: &[UniPoly<F>], at: &F) -> usize {
    let signs = sequence
        .iter()
        .map(|polynomial| polynomial.evaluate(at).sign());
    let signs: Vec<_> = signs.filter(|sign| sign.is_ne()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    #[test]
    fn closed_intervals_count_their_ends_once() {
        // x (x−1)² (x²−2)
        let coefficients = [0, -2, 4, -1, -2, 1].map(Rational::from);
        let polynomial = UniPoly::from_coefficients(&coefficients);
        let count = |from: i64, to: i64| count_roots(&polynomial, &from.into(), &to.into());
        assert_eq!(count(-2, 2), 4);
        assert_eq!(count(0, 1), 2);
        assert_eq!(count(1, 1), 1);
        assert_eq!(count(2, 3), 0);
        assert_eq!(count(1, 0), 0);
    }
}
