//! STEP (ISO 10303-21) by AP203, AP214 or AP242: B-spline faces in shells with shared edges.

mod configuration;
mod entities;
mod geometry;
mod product;
mod schema;
mod shell;

use crate::diag::Code;
use crate::net::{Model, Part};

use super::boundary::with_clear_boundaries;
use super::refusal::{GREATEST_DEGREE, INFINITE_POWER, Readers};
use super::written::Written;
use super::{Context, ExportFault, Exported, Exporter, Fidelity};
use entities::Entities;
use shell::{write_bare, write_shells};

pub use schema::StepSchema;

pub(super) const EXPORTER: Exporter = Exporter {
    name: "step",
    extension: "step",
    summary: "STEP, B-spline faces in shells",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: Some(GREATEST_DEGREE),
    infinite_power: Some(INFINITE_POWER),
};

/// - **errors** a degree above 25 or of 0 (E0305); no patches with positive weights, or weights
///   that differ by a factor above 10⁶ (E0304); a number beyond the last double, or knots that
///   merge (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let ratio = READERS.check(model, context)?;
    let clear = with_clear_boundaries(model)?;
    let mut entities = Entities::default();
    let mut written = Written::for_readers(&READERS);
    let shape = if let Some(model) = &clear {
        let mut nets = Vec::new();
        for shell in model.shells() {
            let faces = shell.faces.iter();
            nets.push(written.round(faces.map(|own| &own.net))?);
        }
        write_shells(model, &nets, context.name(), &mut entities)?
    } else {
        let patches = model.parts().iter().flat_map(Part::patches).flatten();
        let nets = written.round(patches.map(|own| &own.net))?;
        write_bare(&nets, context.name(), &mut entities)
    };
    product::write(&shape, context, &mut entities);
    let text = format!(
        "ISO-10303-21;\n{}DATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        product::header(context),
        entities.text()
    );
    let bare = clear.is_none().then(unbounded);
    Ok(Exported {
        bytes: text.into_bytes(),
        fidelity: written.fidelity.unwrap_or(Fidelity::Exact),
        warnings: written
            .warnings
            .into_iter()
            .chain(ratio)
            .chain(bare)
            .collect(),
    })
}

fn unbounded() -> ExportFault {
    ExportFault::new(
        Code::W1009,
        "sides or corners coincide or nearly do: the surface is written without edges",
        "some readers ignore such a surface; cut the domain into parts that do not close up, and export each",
    )
}
