//! Exact numbers. The only floor that knows which bignum library is used.
//!
//! A [`Field`] is held as numerators in a [`Ring`] over rational-integer denominators, so that
//! polynomials can keep one common denominator and compute without fractions. Everything above
//! `poly` is concrete over [`Real`]; nothing above this floor may assume what `Real` is.

mod basis;
mod binomial_sums;
mod complex;
mod conjugates;
mod convolution;
mod divisor;
mod enclosure;
mod field;
mod generator;
mod halves;
mod integer;
mod leading;
mod leading_word;
mod machine_list;
mod machine_numbers;
mod machine_sums;
mod modulus;
mod operators;
mod place;
mod rational;
mod surd;
mod surd_integer;
mod surd_list;
mod tower;
mod unit;
mod words;

pub use basis::Basis;
use basis::radicals;
pub use complex::Complex;
pub use conjugates::Conjugates;
pub use divisor::{gcd, lcm, machine_gcd};
pub use enclosure::Enclosure;
pub use field::{Field, Ring};
pub use generator::Generator;
pub use integer::Integer;
pub use leading::Leading;
pub use leading_word::LeadingWord;
pub use machine_list::MachineList;
pub use machine_numbers::MachineNumbers;
pub use modulus::Modulus;
pub use operators::machine_quotient;
pub use place::Place;
pub use rational::Rational;
pub use surd::Surd;
pub use surd_integer::{Binomial, SurdInteger};
pub use tower::{RootFault, Tower};
pub use unit::Unit;

/// The exact real numbers that curves and surfaces are made of.
pub type Real = Surd;
