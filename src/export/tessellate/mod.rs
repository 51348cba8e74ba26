//! Surfaces as triangles: exact points rounded once, within a proved distance of the surface.

mod facet;
mod flatness;
mod lattice;
mod mesh;
mod nearest;
mod normal_field;
mod outline;
mod resolution;
mod samples;
mod shaded;
mod strip;
mod subdivision;
mod tensor;
mod weld;

pub use mesh::{Corner, Mesh, Triangle};
pub use samples::Samples;
pub use subdivision::Subdivision;

pub(super) use facet::facet_normal;
pub(super) use shaded::Shaded;
