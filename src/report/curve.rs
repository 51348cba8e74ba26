use serde::Serialize;

use crate::curve::{Choice, Curve, Interpolant, Preimage, bending_energy, rotation_index};
use crate::number::{Basis, Field, Integer, Rational, Real};

/// The report of a Pythagorean-hodograph curve.
#[derive(Debug, Clone, Serialize)]
pub struct CurveReport {
    /// Its name.
    pub name: String,
    /// The total arc length, if ∫σ is rational.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) arc_length: Option<LengthReport>,
    /// Which Hermite interpolant it is, if it was built as one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) ph_hermite: Option<HermiteReport>,
}

/// A length as it is and in 30 digits.
#[derive(Debug, Clone, Serialize)]
pub(super) struct LengthReport {
    pub(super) exact: String,
    pub(super) decimal: String,
    /// With every radical written out, where that is short.
    #[serde(skip)]
    pub(super) readable: String,
    /// The generators that the readable form names, with what they are.
    #[serde(skip)]
    pub(super) generators: Option<String>,
}

/// A branch of the four PH quintics with the same Hermite data.
#[derive(Debug, Clone, Serialize)]
pub(super) struct HermiteReport {
    pub(super) branch: &'static str,
    pub(super) choice: &'static str,
    pub(super) rotation_index: String,
    /// None if it is infinite: at a cusp.
    pub(super) bending_energy: Option<String>,
}

/// Significant digits of an arc length.
const LENGTH_DIGITS: i64 = 30;
/// Significant digits of rotation index and bending energy.
const DIGITS: i64 = 10;

/// The arc length of a curve, if it is rational; it may need a generator of its own.
pub(super) fn arc_length(curve: &Curve) -> Option<Real> {
    curve.length().ok()
}

impl CurveReport {
    pub(super) fn of(curve: &Curve, basis: &Basis) -> Self {
        let length = arc_length(curve).map(|length| LengthReport {
            exact: basis.spell(&length),
            decimal: length.decide(|own| significant(own, LENGTH_DIGITS)),
            readable: basis.readable(&length),
            generators: basis.legend(&length),
        });
        let hermite = curve.preimage().zip(curve.interpolant());
        Self {
            name: curve.name().to_owned(),
            arc_length: length,
            ph_hermite: hermite.map(|(preimage, own)| HermiteReport::of(preimage, own, curve)),
        }
    }
}

impl HermiteReport {
    fn of(preimage: &Preimage, interpolant: &Interpolant, curve: &Curve) -> Self {
        let domain = curve.domain();
        let energy = |bits: u32| bending_energy(preimage, domain, bits);
        // A straight line that stops has no curvature all the same.
        let bends = !preimage.turning().is_zero();
        let is_infinite = bends && preimage.has_cusp(domain);
        Self {
            branch: interpolant.branch.word(),
            choice: match interpolant.choice {
                Choice::Given => "given",
                Choice::LeastRotation => "least absolute rotation index",
                Choice::FirstOfEqual => "first of those with the least absolute rotation index",
            },
            rotation_index: digits(&|bits| Some(rotation_index(preimage, domain, bits).ends())),
            bending_energy: (!is_infinite).then(|| digits(&energy)),
        }
    }
}

/// The first digits of a number that is bounded ever more narrowly.
fn digits(bounds: &impl Fn(u32) -> Option<[Rational; 2]>) -> String {
    let known = [38, 76, 152, 304].into_iter().filter_map(bounds);
    let mut texts = known.filter_map(|[lower, upper]| {
        let text = significant(&lower, DIGITS);
        (text == significant(&upper, DIGITS)).then_some(text)
    });
    texts.next().unwrap_or_else(|| "not known".to_owned())
}

/// A number that is not negative to so many significant digits, without zeros at its end:
/// `0.25`, `1.5e-60`.
fn significant(value: &Rational, count: i64) -> String {
    if value.is_zero() {
        return "0".to_owned();
    }
    let ten = |exponent: i64| {
        Rational::from(10)
            .power(exponent)
            .unwrap_or_else(Rational::one)
    };
    // 10^e ≤ value < 10^(e + 1), from the length of the quotient by a few corrections
    let length = |own: &Integer| i64::try_from(own.bits()).unwrap_or(i64::MAX);
    let bits = length(value.numerator()) - length(value.denominator());
    let mut exponent = bits * 30_103 / 100_000 - 1;
    while ten(exponent + 1) <= *value {
        exponent += 1;
    }
    let digits = |exponent: i64| {
        let places = u32::try_from(count - 1).unwrap_or_default();
        (value / &ten(exponent)).decimal(places)
    };
    let mut text = digits(exponent);
    if text.starts_with("10") {
        exponent += 1;
        text = digits(exponent);
    }
    if (-5..count).contains(&exponent) {
        let places = u32::try_from(count - 1 - exponent).unwrap_or_default();
        return trimmed(&value.decimal(places));
    }
    format!("{}e{exponent}", trimmed(&text))
}

fn trimmed(text: &str) -> String {
    if !text.contains('.') {
        return text.to_owned();
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_count_from_the_first_that_is_not_zero() {
        let read = |text: &str| {
            text.parse::<Rational>()
                .unwrap_or_else(|()| Rational::from(0))
        };
        for (value, text) in [
            ("1/4", "0.25"),
            ("1/3", "0.3333333333"),
            ("2000/3", "666.6666667"),
            ("1e12", "1e12"),
            ("123456e-30", "1.23456e-25"),
            ("0.00012345678999", "0.00012345679"),
            ("0.99999999999", "1"),
            ("0", "0"),
        ] {
            assert_eq!(significant(&read(value), DIGITS), text, "{value}");
        }
    }
}
