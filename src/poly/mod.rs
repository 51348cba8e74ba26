//! Exact polynomials and rational functions over any [`Field`](crate::number::Field), without
//! fractions inside: integer numerators over one common denominator.

mod uni;

pub use uni::UniPoly;
