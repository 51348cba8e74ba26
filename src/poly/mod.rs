//! Exact polynomials and rational functions over any [`Field`](crate::number::Field), without
//! fractions inside: integer numerators over one common denominator.

mod bi;
mod bidegree;
mod uni;

pub use bi::BiPoly;
pub use bidegree::BiDegree;
pub use uni::UniPoly;
