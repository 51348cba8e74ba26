//! File formats. The one floor where exact numbers become doubles.
//!
//! A format is one file and one line in [`ALL`]. An exporter writes a net whole or refuses it
//! with the reason and the way out; what is lost on the way is told by [`Fidelity`].

mod approx;
mod context;
mod exported;
mod fault;
mod json;
mod rounded_net;
mod step;

use crate::net::ControlNet;

pub use approx::Double;
pub use context::Context;
pub use exported::{Exported, Fidelity};
pub use fault::ExportFault;
pub use rounded_net::RoundedNet;

/// A file format.
#[derive(Clone, Copy, Debug)]
pub struct Exporter {
    /// The word that selects it on the command line.
    pub name: &'static str,
    /// The extension of its files, without the point.
    pub extension: &'static str,
    /// What it is, in a few words.
    pub summary: &'static str,
    /// Writes one surface, or says why the format cannot carry it.
    pub write: fn(&ControlNet, &Context) -> Result<Exported, ExportFault>,
}

/// Every format.
pub const ALL: &[Exporter] = &[json::EXPORTER, step::EXPORTER];
