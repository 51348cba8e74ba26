//! File formats. The one floor where exact numbers become doubles.
//!
//! A format is one file and one line in [`ALL`]. An exporter writes a model whole or refuses it
//! with the reason and the way out; what is lost on the way is told by [`Fidelity`].

mod approx;
mod boundary;
mod context;
mod exported;
mod fault;
mod geomdl;
mod glb;
mod guide;
mod iges;
mod json;
mod layout;
mod mesh_obj;
mod obj;
mod opennurbs;
mod outward;
mod picture;
mod ply;
mod premultiplied_net;
mod refusal;
mod rounded;
mod rounded_net;
mod rounding;
mod step;
mod stl;
mod tessellate;
mod three;
mod truck;
mod verb;
mod written;

use crate::diag::Code;
use crate::net::{Model, Part};

pub use approx::{Double, Precision};
pub use context::Context;
pub use exported::{Exported, Fidelity};
pub use fault::ExportFault;
pub use guide::Guide;
pub use picture::View;
pub use premultiplied_net::PremultipliedNet;
pub use rounded_net::RoundedNet;
pub use step::StepSchema;
pub use tessellate::{Corner, Mesh, Samples, Subdivision, Triangle};

/// A file format.
#[derive(Clone, Copy, Debug)]
pub struct Exporter {
    /// The word that selects it on the command line.
    pub name: &'static str,
    /// The extension of its files, without the point.
    pub extension: &'static str,
    /// What it is, in a few words.
    pub summary: &'static str,
    /// Whether a file can hold several surfaces.
    pub several: bool,
    /// Whether its files show the degree report.
    pub shows_report: bool,
    /// Writes the surfaces of a model, or says why the format cannot carry them.
    pub write: fn(&Model, &Context) -> Result<Exported, ExportFault>,
}

/// The surface of a model that holds one, for formats of single surfaces.
///
/// - **errors** no surface, or several (E0304)
fn single(model: &Model) -> Result<&Part, ExportFault> {
    match model.parts() {
        [part] => Ok(part),
        parts => {
            let message = format!("{} surfaces; a file of this format holds one", parts.len());
            let help = "choose one with `--surface`";
            Err(ExportFault::new(Code::E0304, message, help))
        }
    }
}

/// Every format.
pub const ALL: &[Exporter] = &[
    json::EXPORTER,
    step::EXPORTER,
    iges::EXPORTER,
    opennurbs::EXPORTER,
    geomdl::EXPORTER,
    three::EXPORTER,
    verb::EXPORTER,
    truck::EXPORTER,
    picture::SVG,
    picture::HTML,
    obj::EXPORTER,
    mesh_obj::EXPORTER,
    ply::EXPORTER,
    stl::EXPORTER,
    glb::EXPORTER,
];
