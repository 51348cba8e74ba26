use crate::number::{Enclosure, Field, Integer, Rational, Real};
use crate::poly::UniPoly;

use super::preimage::magnitude;
use super::{Interval, Preimage};

/// The positive nodes of the Gauss–Legendre rule with ten nodes on [−1, 1], and the weights of a
/// node and of its mirror image, each to 30 digits.
const RULE: [(&str, &str); 5] = [
    (
        "0.148874338981631210884826001130",
        "0.295524224714752870173892994651",
    ),
    (
        "0.433395394129247190799265943166",
        "0.269266719309996355091226921569",
    ),
    (
        "0.679409568299024406234327365115",
        "0.219086362515982043995534934228",
    ),
    (
        "0.865063366688984510732096688423",
        "0.149451349150580593145776339658",
    ),
    (
        "0.973906528517171720077964012084",
        "0.066671344308688137593568809893",
    ),
];

/// The digits behind the point in [`RULE`].
const DIGITS: u32 = 30;

/// Pieces after which the precision is too small.
const PIECES: usize = 2_048;

/// Bounds for the bending energy ∫κ² ds of a plane Pythagorean-hodograph curve without cusps, good
/// to about `bits` binary digits; none if so many are not enough to find any.   [farouki-neff]
///
/// κ² ds = 4 Im(ω̄ω′)² / (|g| |ω|⁶) dv, with Im(ω̄ω′) and ω scaled to size 1 on [0, 1]. On each piece
/// the function is analytic in an ellipse with foci at the ends and half axes of sum ρ; if |f| ≤ M
/// there, the rule errs by at most 64/15 M ρ⁻²⁰/(1 − ρ⁻²), the classical bound for Gauss quadrature.
#[must_use]
pub fn bending_energy(preimage: &Preimage, domain: &Interval, bits: u32) -> Option<[Rational; 2]> {
    let (local, exponent) = preimage.normalised(domain);
    let turning = local.turning();
    let Some(size) = magnitude(&turning) else {
        return Some([Rational::zero(), Rational::zero()]);
    };
    let turning = turning.scale(&Real::power_of_two(-size));
    let integral = integral(&turning, &local.norm(), bits)?;
    // 4 · 2^(2 size − 2 exponent) / (|g| · length of the domain)
    let norm = preimage.factor().norm();
    let half = norm.binade()?.div_euclid(2);
    let factor = &norm * &Real::power_of_two(-2 * half);
    let length = domain.end() - domain.start();
    let stretch = length.binade()?;
    let length = &length * &Real::power_of_two(-stretch);
    let precision = integral.precision();
    let divisor = factor.enclose(precision).square_root();
    let divisor = divisor.times(&length.enclose(precision)).inverse()?;
    let power = Real::power_of_two(2 + 2 * (size - exponent) - half - stretch).as_rational()?;
    Some(integral.times(&divisor).ends().map(|end| &end * &power))
}

/// ∫ h²/q³ over [0, 1].
fn integral(turning: &UniPoly<Real>, norm: &UniPoly<Real>, bits: u32) -> Option<Enclosure> {
    let precision = bits + 24;
    let mut total = Enclosure::of_integer(&0.into(), precision);
    let mut pending = vec![(Real::from(0), Real::from(1))];
    for _ in 0..PIECES {
        let Some((from, to)) = pending.pop() else {
            return Some(total);
        };
        let middle = &(&from + &to) / &Real::from(2);
        let piece = Piece {
            turning: Local::of(turning, &middle, &to, precision),
            norm: Local::of(norm, &middle, &to, precision),
            precision,
        };
        match piece.integral(bits) {
            Some(value) => {
                let half = (&to - &middle).enclose(precision);
                total = total.plus(&value.times(&half));
            }
            None => pending.extend([(middle.clone(), to), (from, middle)]),
        }
    }
    None
}

/// A polynomial on [−1, 1]: intervals around its coefficients, ascending.
struct Local(Vec<Enclosure>);

impl Local {
    /// p(m + (b − m) ξ)
    fn of(polynomial: &UniPoly<Real>, middle: &Real, to: &Real, precision: u32) -> Self {
        let local = polynomial.restrict(middle, to).coefficients();
        Self(local.iter().map(|own| own.enclose(precision)).collect())
    }

    fn evaluate(&self, at: &Enclosure) -> Enclosure {
        let zero = Enclosure::of_integer(&0.into(), at.precision());
        let coefficients = self.0.iter().rev();
        coefficients.fold(zero, |value, own| value.times(at).plus(own))
    }

    /// Σ |cₖ| Rᵏ from the given power on.
    fn majorant(&self, from: usize, radius: &Enclosure) -> Enclosure {
        let zero = Enclosure::of_integer(&0.into(), radius.precision());
        let sized = self.0.iter().enumerate().rev().map(|(power, own)| {
            if power < from {
                zero.clone()
            } else {
                own.absolute()
            }
        });
        sized.fold(zero.clone(), |value, own| value.times(radius).plus(&own))
    }
}

/// The integrand Im(ω̄ω′)² / |ω|⁶ on a piece of the domain, as a function on [−1, 1].
struct Piece {
    turning: Local,
    norm: Local,
    precision: u32,
}

impl Piece {
    /// The integral over [−1, 1]; none if the rule is not known to be good enough here.
    fn integral(&self, bits: u32) -> Option<Enclosure> {
        let error = self.error()?;
        let mut sum = Enclosure::of_integer(&0.into(), self.precision);
        for (node, weight) in RULE {
            let (node, weight) = (self.known(node)?, self.known(weight)?);
            let pair = self.value(&node)?.plus(&self.value(&node.negated())?);
            sum = sum.plus(&pair.times(&weight));
        }
        let [_, error] = error.ends();
        let [least, _] = sum.ends();
        let unit = Rational::new(1.into(), Integer::from(1) << bits);
        let floor = Rational::new(1.into(), Integer::from(1) << (bits + 10));
        if error > floor && error > &least * &unit {
            return None;
        }
        let margin = Enclosure::of_rational(&error, self.precision);
        Some(sum.plus(&margin.negated().hull(&margin)))
    }

    /// A number of [`RULE`].
    fn known(&self, digits: &str) -> Option<Enclosure> {
        let value: Rational = digits.parse().ok()?;
        let step = Rational::from(10).power(-i64::from(DIGITS))?;
        let [low, high] = [&value - &step, &value + &step];
        let low = Enclosure::of_rational(&low, self.precision);
        Some(low.hull(&Enclosure::of_rational(&high, self.precision)))
    }

    fn value(&self, at: &Enclosure) -> Option<Enclosure> {
        let turning = self.turning.evaluate(at);
        let inverse = self.norm.evaluate(at).inverse()?;
        let ratio = turning.times(&inverse);
        Some(ratio.times(&ratio).times(&inverse))
    }

    /// A bound for the error of the rule, from the largest of some ellipses in which |ω|² is known
    /// not to vanish; none if there is none.
    fn error(&self) -> Option<Enclosure> {
        [64, 32, 16, 8, 4].into_iter().find_map(|sum| {
            // |z| ≤ R = (ρ + 1/ρ)/2 in the ellipse
            let sum = Rational::from(sum);
            let inverse = sum.inverse()?;
            let half = Rational::new(1.into(), 2.into());
            let radius = Enclosure::of_rational(&(&(&sum + &inverse) * &half), self.precision);
            let rest = self.norm.majorant(1, &radius);
            let least = self.norm.0.first()?.minus(&rest);
            let inverse_least = least.sign()?.is_gt().then(|| least.inverse())??;
            let ratio = self.turning.majorant(0, &radius).times(&inverse_least);
            let most = ratio.times(&ratio).times(&inverse_least);
            let square = inverse.power(2)?;
            let decay = &(&inverse.power(20)? * &Rational::new(64.into(), 15.into()))
                / &(&Rational::from(1) - &square);
            Some(most.times(&Enclosure::of_rational(&decay, self.precision)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Complex;

    fn polynomial(coefficients: &[i64]) -> UniPoly<Real> {
        let coefficients: Vec<_> = coefficients.iter().copied().map(Real::from).collect();
        UniPoly::from_coefficients(&coefficients)
    }

    #[test]
    fn the_rule_integrates_polynomials_of_degree_19() {
        // Σ wᵢ xᵢ²ᵏ = 1/(2k + 1), to the digits of the rule
        for power in 0..10 {
            let exact = Rational::new(1.into(), (2 * power + 1).into());
            let sum = RULE.iter().fold(Rational::from(0), |sum, (node, weight)| {
                let read = |digits: &str| digits.parse::<Rational>().unwrap_or(Rational::from(0));
                let term = read(node).power(2 * power).map(|own| &own * &read(weight));
                &sum + &term.unwrap_or(Rational::from(0))
            });
            let gap = &sum - &exact;
            let gap = if gap.sign().is_lt() { -&gap } else { gap };
            let bound = Rational::from(10).power(-28);
            assert!(bound.is_some_and(|bound| gap < bound), "{power}");
        }
    }

    #[test]
    fn the_energy_of_a_cubic_is_known() {
        // ω = 1 + it: 4 ∫ (1 + t²)⁻³ dt = [t/(1 + t²)² + 3t/2(1 + t²) + (3/2) arctan t]·…
        // = 1 + 3π/8 on [0, 1]
        let preimage = Preimage::new(Complex::one(), polynomial(&[1]), polynomial(&[0, 1]));
        let found = bending_energy(&preimage, &Interval::unit(), 60);
        let digits = found.map(|found| found.map(|end| end.decimal(15)));
        let expected = "2.178097245096172".to_owned();
        assert_eq!(digits, Some([expected.clone(), expected]));
        let cusp = Preimage::new(
            Complex::one(),
            polynomial(&[-1, 2]),
            polynomial(&[0, -1, 2]),
        );
        assert_eq!(bending_energy(&cusp, &Interval::unit(), 60), None);
    }
}
