use std::sync::Arc;

use super::Modulus;

/// A ring homomorphism from the numerators of a field to a prime field: a prime q, and a square
/// root modulo q of the image of every radicand.
///
/// Images prove what is hard to see over the integers: if the images of two polynomials keep
/// their degrees and are coprime, the polynomials are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    modulus: Modulus,
    /// None for no roots.
    roots: Option<Arc<[u64]>>,
}

impl Place {
    /// The place of the rational integers: the prime 2⁶¹ − 1.
    #[must_use]
    pub fn rational() -> Self {
        Self::new(Modulus::mersenne(), Vec::new())
    }

    pub(super) fn new(modulus: Modulus, roots: Vec<u64>) -> Self {
        Self {
            modulus,
            roots: (!roots.is_empty()).then(|| roots.into()),
        }
    }

    /// Arithmetic modulo q.
    #[must_use]
    pub fn modulus(&self) -> &Modulus {
        &self.modulus
    }

    /// The image of the square root of a level of the tower, counted from 0.
    pub(super) fn root(&self, level: usize) -> u64 {
        let roots = self.roots.as_deref().unwrap_or_default();
        roots.get(level).copied().unwrap_or_default()
    }
}
