//! Curves and their exact differential and integral properties.

mod curve;
mod fault;
mod hodograph;
mod homogeneous;
mod interval;
pub mod kinds;
mod plane;
mod property;

pub use curve::Curve;
pub use fault::Fault;
pub use hodograph::Hodograph;
pub use homogeneous::Homogeneous;
pub use interval::Interval;
pub use plane::{Axis, Parameter, Plane};
pub use property::{Property, PropertyFunction};
