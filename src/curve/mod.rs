//! Curves and their exact differential and integral properties.

mod bending_energy;
mod curve;
mod fault;
mod hermite;
mod hodograph;
mod homogeneous;
mod interval;
pub mod kinds;
mod plane;
mod preimage;
mod property;
mod rotation_index;

pub use bending_energy::bending_energy;
pub use curve::Curve;
pub use fault::Fault;
pub use hermite::{Branch, Choice, HermiteData, Interpolant};
pub use hodograph::Hodograph;
pub use homogeneous::Homogeneous;
pub use interval::Interval;
pub use plane::{Axis, Parameter, Plane};
pub use preimage::Preimage;
pub use property::{Property, PropertyFunction};
pub use rotation_index::rotation_index;
