/// How it was proved that a list of polynomials has no common divisor of positive degree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Coprimality {
    /// Their images modulo 2⁶¹ − 1 have none, and one of them kept its degree.
    Modular,
    /// The greatest common divisor was computed, and is 1.
    Euclid,
}
