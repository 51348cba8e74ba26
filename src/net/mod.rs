//! Control nets: the exact surface in the form that other programs read.
//!
//! A [`Model`] is what goes into one file: its [`Part`]s are surfaces, its [`Shell`]s the same
//! surfaces in patches that share edges.

mod affine;
mod control_net;
mod curve_net;
mod edge;
mod elevate;
mod face;
mod junction;
mod knots;
mod leading_points;
mod model;
mod orientation;
mod part;
mod patch;
mod products;
mod scaled_form;
mod sew;
mod shell;
mod side;
mod subdivide;

pub use control_net::ControlNet;
pub use curve_net::CurveNet;
pub use edge::{Edge, EdgeId};
pub use face::Face;
pub use knots::Knots;
pub use leading_points::LeadingPoints;
pub use model::Model;
pub use part::Part;
pub use patch::Patch;
pub use shell::Shell;
pub use side::{Side, Use, VertexId};

use sew::sew;
