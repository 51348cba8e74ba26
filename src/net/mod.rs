//! Control nets: the exact surface in the form that other programs read.

mod control_net;
mod knots;

pub use control_net::ControlNet;
pub use knots::Knots;
