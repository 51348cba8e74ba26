use super::UniPoly;
use crate::number::{Field, Residue, Ring};

/// A polynomial over the prime field of [`Residue`], ascending, without trailing zeros: the
/// image of a polynomial's numerators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Image(Vec<Residue>);

impl Image {
    /// The image of the numerators; none if the field has no image.
    pub(super) fn of<F: Field>(polynomial: &UniPoly<F>) -> Option<Self> {
        let residues = polynomial.numerators().iter().map(Ring::residue);
        Some(Self::new(residues.collect::<Option<_>>()?))
    }

    /// Σ cᵢ xⁱ from ascending coefficients.
    pub(super) fn new(mut coefficients: Vec<Residue>) -> Self {
        while coefficients.last() == Some(&Residue::ZERO) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    /// The degree; none for 0.
    pub(super) fn degree(&self) -> Option<usize> {
        self.0.len().checked_sub(1)
    }

    /// The greatest common divisor up to a constant factor, by cross-multiplied remainders
    /// lc(b) a − lc(a) xᵏ b: no inverses.
    pub(super) fn gcd(self, other: Self) -> Self {
        let (mut high, mut low) = (self.0, other.0);
        loop {
            if high.len() < low.len() {
                std::mem::swap(&mut high, &mut low);
            }
            let Some(&divisor) = low.last() else {
                return Self(high);
            };
            if low.len() == 1 {
                return Self(vec![Residue::ONE]);
            }
            let Some(lead) = high.pop() else {
                return Self(low);
            };
            let offset = high.len() + 1 - low.len();
            for own in &mut high[..offset] {
                *own = *own * divisor;
            }
            for (own, subtrahend) in high[offset..].iter_mut().zip(&low) {
                *own = *own * divisor - *subtrahend * lead;
            }
            while high.last() == Some(&Residue::ZERO) {
                high.pop();
            }
        }
    }
}
