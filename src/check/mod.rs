//! What there is to prove about a surface, each proof in a file of its own.
//!
//! [`Checked`] is the ticket that exporters demand: it is made only here, and only from a
//! surface whose facts have been decided.

mod affine;
mod checked;
mod cuts;
mod direction;
mod expectation;
mod offset;
mod pole;
mod positivity;
mod regular;
mod verdict;
mod weights;

pub use affine::AffineDegree;
pub use checked::Checked;
pub use expectation::{Judgement, judge};
pub use positivity::Positivity;
pub use verdict::Verdict;
pub use weights::WeightRange;
