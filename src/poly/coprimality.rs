use crate::number::Modulus;

/// How it was proved that a list of polynomials has no common divisor of positive degree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coprimality {
    /// Their images modulo a prime have none, and one of them kept its degree.
    Modular(Modulus),
    /// The greatest common divisor was computed, and is 1.
    Euclid,
}
