//! Swept surfaces: their formulas, and what the formulas expand to.

mod bound;
mod claim;
mod eval;
mod expand;
mod expanded;
mod expression;
mod normal;
mod square_root;
mod surface;

pub use bound::{DegreeBound, degree_bound};
pub use claim::{Claim, Expectation, Quality, Quantity, Relation};
pub use eval::evaluate_slowly;
pub use expand::Expander;
pub use expanded::Expanded;
pub use expression::{CurveProperty, Form, Scalar, Vector};
pub use normal::{NormalFault, NormalVector, unit_normal};
pub use surface::{Domain, Expansion, HomogeneousSurface, Step, SweptSurface};
