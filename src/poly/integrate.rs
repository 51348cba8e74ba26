use super::UniPoly;
use super::gcd::gcd;
use super::squarefree::square_free;
use crate::number::{Field, Integer};

/// What the antiderivative of a rational function is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Antiderivative<F: Field> {
    /// A rational function in lowest terms, the denominator primitive.
    Rational {
        /// The numerator, without a constant of integration: the polynomial part vanishes at 0
        /// and the rest at infinity.
        numerator: UniPoly<F>,
        /// The denominator.
        denominator: UniPoly<F>,
    },
    /// Not a rational function.
    NotRational {
        /// The primitive square-free denominator of the part that integrates to logarithms and
        /// arctangents: its roots are the poles with a residue.
        logarithmic: UniPoly<F>,
    },
}

/// Decides whether ∫ p/q is rational, and finds it.
///
/// With q = q₁ q₂, q₁ = gcd(q, q′) and q₂ the radical, a rational antiderivative of the proper
/// part r/q is a/q₁ with deg a < deg q₁ and a′ q₂ − a e = r, where e = q₁′ q₂ / q₁. The leading
/// coefficient of the left-hand side for a = xᵏ is (k − deg q₁) lc(q₂), which is not 0: the
/// coefficients of a follow one by one from the top, and the equation holds or it does not.
/// (Horowitz's and Ostrogradsky's reduction)
///
/// A zero denominator counts as 1.
#[must_use]
pub fn integrate<F: Field>(numerator: &UniPoly<F>, denominator: &UniPoly<F>) -> Antiderivative<F> {
    if denominator.is_constant()
        && let Some(inverse) = denominator.leading_coefficient().inverse()
    {
        return polynomial_result(&numerator.scale(&inverse).antiderivative());
    }
    let common = gcd(numerator, denominator);
    let reduce = |polynomial: &UniPoly<F>| polynomial.exact_div(&common);
    let (Some(top), Some(bottom)) = (reduce(numerator), reduce(denominator)) else {
        return polynomial_result(&numerator.antiderivative());
    };
    let scale = bottom.leading_coefficient().inverse();
    let bottom = bottom.monic();
    let top = top.scale(&scale.unwrap_or_else(F::one));
    let Some((whole, rest)) = top.div_rem(&bottom) else {
        return polynomial_result(&numerator.antiderivative());
    };
    if bottom.is_constant() {
        return polynomial_result(&whole.antiderivative());
    }
    let repeated = gcd(&bottom, &bottom.derivative()).monic();
    let radical = bottom.exact_div(&repeated).unwrap_or_else(UniPoly::one);
    match rational_part(&rest, &repeated, &radical) {
        Some(part) => {
            let sum = &(&whole.antiderivative() * &repeated) + &part;
            lowest_terms(&sum, &repeated)
        }
        None => Antiderivative::NotRational {
            logarithmic: logarithmic(&rest, &bottom),
        },
    }
}

fn polynomial_result<F: Field>(antiderivative: &UniPoly<F>) -> Antiderivative<F> {
    Antiderivative::Rational {
        numerator: antiderivative.clone(),
        denominator: UniPoly::one(),
    }
}

fn lowest_terms<F: Field>(numerator: &UniPoly<F>, denominator: &UniPoly<F>) -> Antiderivative<F> {
    let common = gcd(numerator, denominator);
    let reduce = |own: &UniPoly<F>| own.exact_div(&common).unwrap_or_else(|| own.clone());
    let (numerator, bottom) = (reduce(numerator), reduce(denominator));
    let denominator = bottom.primitive();
    let scale = bottom.leading_coefficient().inverse();
    let scale = scale.map(|inverse| inverse.times(&denominator.leading_coefficient()));
    Antiderivative::Rational {
        numerator: numerator.scale(&scale.unwrap_or_else(F::one)),
        denominator,
    }
}

/// The a of degree below that of q₁ with a′ q₂ − a e = r, for monic q₁ and q₂.
fn rational_part<F: Field>(
    rest: &UniPoly<F>,
    repeated: &UniPoly<F>,
    radical: &UniPoly<F>,
) -> Option<UniPoly<F>> {
    let degree = repeated.degree()?;
    let order = radical.degree()?;
    let twist = (&repeated.derivative() * radical).exact_div(repeated)?;
    let mut residual = rest.clone();
    let mut coefficients = vec![F::zero(); degree];
    for power in (0..degree).rev() {
        let top = residual.coefficient(power + order - 1);
        if top.is_zero() {
            continue;
        }
        let gap = F::from_integer(&Integer::from(degree - power));
        let value = top.times(&gap.inverse()?.negated());
        let monomial = UniPoly::one().shift(power);
        let column = &(&monomial.derivative() * radical) - &(&monomial * &twist);
        residual = &residual - &column.scale(&value);
        coefficients[power] = value;
    }
    residual
        .is_zero()
        .then(|| UniPoly::from_coefficients(&coefficients))
}

/// The product of the poles with a residue, factor by factor of the square-free factorisation.
///
/// Near the roots of a factor v of multiplicity i, q = u vⁱ, the function is s/vⁱ with s = r/u
/// modulo vⁱ. Integration by parts s/vʲ⁺¹ = (b/vʲ)′ + (−j c − b′)/vʲ with b v′ + c v = −s/j
/// lowers the order to 1, where gcd(s, v) holds the poles without a residue.
/// (Hermite's reduction)
fn logarithmic<F: Field>(rest: &UniPoly<F>, bottom: &UniPoly<F>) -> UniPoly<F> {
    let factors = square_free(bottom);
    let poles = factors.iter().filter_map(|(factor, multiplicity)| {
        if *multiplicity == 1 {
            return Some(factor.clone());
        }
        let residues = residues(rest, bottom, factor, *multiplicity)?;
        factor.exact_div(&gcd(factor, &residues))
    });
    poles
        .fold(UniPoly::one(), |product, pole| &product * &pole)
        .primitive()
}

/// The s of degree below that of v such that r/q − s/v has no residue at the roots of v.
fn residues<F: Field>(
    rest: &UniPoly<F>,
    bottom: &UniPoly<F>,
    factor: &UniPoly<F>,
    multiplicity: u32,
) -> Option<UniPoly<F>> {
    let power = factor.power(multiplicity);
    let cofactor = bottom.exact_div(&power)?;
    let derivative = factor.derivative();
    let slope_inverse = inverse_modulo(&derivative, factor)?;
    let mut local = (rest * &inverse_modulo(&cofactor, &power)?)
        .div_rem(&power)?
        .1;
    for order in (1..multiplicity).rev() {
        let order = F::from_integer(&Integer::from(order));
        let target = local.scale(&order.inverse()?.negated());
        let first = (&target * &slope_inverse).div_rem(factor)?.1;
        let second = (&target - &(&first * &derivative)).exact_div(factor)?;
        local = -&(&second.scale(&order) + &first.derivative());
    }
    Some(local.div_rem(factor)?.1)
}

/// The b with a b = 1 modulo m, of degree below that of m; none if a and m have a common factor.
fn inverse_modulo<F: Field>(value: &UniPoly<F>, modulus: &UniPoly<F>) -> Option<UniPoly<F>> {
    let (mut high, mut low) = (modulus.clone(), value.div_rem(modulus)?.1);
    let (mut before, mut cofactor) = (UniPoly::zero(), UniPoly::one());
    while !low.is_constant() {
        let (quotient, remainder) = high.div_rem(&low)?;
        let next = &before - &(&quotient * &cofactor);
        (before, cofactor) = (cofactor, next);
        (high, low) = (low, remainder);
    }
    let inverse = low.leading_coefficient().inverse()?;
    Some(cofactor.scale(&inverse))
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
    fn poles_without_residue_integrate_rationally() {
        // (x/(x²+1))′ = (1−x²)/(x²+1)²
        let circle = polynomial(&[1, 0, 1]);
        let answer = integrate(&polynomial(&[1, 0, -1]), &circle.power(2));
        let expected = Antiderivative::Rational {
            numerator: polynomial(&[0, 1]),
            denominator: circle.clone(),
        };
        assert_eq!(answer, expected);
        let answer = integrate(&polynomial(&[3]), &polynomial(&[6]));
        let expected = Antiderivative::Rational {
            numerator: polynomial(&[0, 1]).scale(&Rational::new(1.into(), 2.into())),
            denominator: polynomial(&[1]),
        };
        assert_eq!(answer, expected);
    }

    #[test]
    fn the_poles_with_residue_are_named() {
        // 1/(x²+1) + 1/x² + (1−y²)/(1+y²)² at y = x−1: only the first has residues.
        let (circle, line) = (polynomial(&[1, 0, 1]), polynomial(&[0, 1]));
        let shifted = polynomial(&[2, -2, 1]);
        let flat = &(&circle * &line.power(2)) * &polynomial(&[0, 2, -1]);
        let numerator =
            &(&(&line.power(2) * &shifted.power(2)) + &(&circle * &shifted.power(2))) + &flat;
        let denominator = &(&circle * &line.power(2)) * &shifted.power(2);
        assert_eq!(
            integrate(&numerator, &denominator),
            Antiderivative::NotRational {
                logarithmic: circle
            }
        );
        assert_eq!(
            integrate(&polynomial(&[1]), &polynomial(&[0, 3])),
            Antiderivative::NotRational {
                logarithmic: polynomial(&[0, 1])
            }
        );
    }
}
