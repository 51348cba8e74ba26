//! Exact numbers. The only floor that knows which bignum library is used.
//!
//! A [`Field`] is held as numerators in a [`Ring`] over rational-integer denominators, so that
//! polynomials can keep one common denominator and compute without fractions. Everything above
//! `poly` is concrete over [`Real`]; nothing above this floor may assume what `Real` is.

mod field;
mod integer;
mod modulus;
mod rational;
mod residue;
mod unit;

pub use field::{Field, Ring};
pub use integer::{Integer, gcd, lcm};
pub use modulus::Modulus;
pub use rational::Rational;
pub use residue::Residue;
pub use unit::Unit;

/// The exact real numbers that curves and surfaces are made of.
pub type Real = Rational;
