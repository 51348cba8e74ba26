use serde::Serialize;

use crate::curve::{Choice, Curve, Interpolant, Preimage, bending_energy, rotation_index};
use crate::number::{Basis, Enclosure, Real};

/// The report of a Pythagorean-hodograph curve whose speed the surfaces use.
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
const LENGTH_DIGITS: usize = 30;
/// Significant digits of rotation index and bending energy.
const DIGITS: usize = 10;

/// The arc length of a curve, if it is rational; it may need a generator of its own.
pub(super) fn arc_length(curve: &Curve) -> Option<Real> {
    curve.length().ok()
}

impl CurveReport {
    pub(super) fn of(curve: &Curve, basis: &Basis) -> Self {
        let length = arc_length(curve).map(|length| LengthReport {
            exact: basis.spell(&length),
            decimal: significant(LENGTH_DIGITS, |digits| Some(length.decimal(digits))),
            readable: basis.readable(&length),
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
        Self {
            branch: interpolant.branch.word(),
            choice: match interpolant.choice {
                Choice::Given => "given",
                Choice::LeastRotation => "least absolute rotation index",
                Choice::FirstOfEqual => "first of those with the least absolute rotation index",
            },
            rotation_index: digits(&|bits| Some(rotation_index(preimage, domain, bits))),
            bending_energy: (!preimage.has_cusp(domain)).then(|| digits(&energy)),
        }
    }
}

/// The first digits of a number that is enclosed at growing precisions.
fn digits(enclose: &impl Fn(u32) -> Option<Enclosure>) -> String {
    let known = [38, 76, 152].into_iter().map(enclose);
    let mut texts = known.flatten().filter_map(|own| {
        let text = significant(DIGITS, |digits| own.decimal(digits));
        (!text.is_empty()).then_some(text)
    });
    texts.next().unwrap_or_else(|| "not known".to_owned())
}

/// A decimal with so many significant digits, without zeros at its end; empty if it has none.
fn significant(count: usize, decimal: impl Fn(u32) -> Option<String>) -> String {
    let places = |digits: usize| u32::try_from(digits).unwrap_or_default();
    let Some(whole) = decimal(0).or_else(|| decimal(1)) else {
        return String::new();
    };
    let whole = whole
        .trim_start_matches('-')
        .split('.')
        .next()
        .map_or(1, str::len);
    let Some(text) = decimal(places(count.saturating_sub(whole))) else {
        return String::new();
    };
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
