//! STEP (ISO 10303-21) by AP203, AP214 or AP242: B-spline faces in shells with shared edges.

mod entities;
mod geometry;
mod product;
mod refusal;
mod shell;

use crate::diag::Code;
use crate::net::{ControlNet, Knots, Model, Part};
use crate::number::{Field, Real};

use super::boundary::with_clear_boundaries;
use super::{Context, ExportFault, Exported, Exporter, Fidelity, RoundedNet};
use entities::Entities;
use shell::{write_bare, write_shells};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "step",
    extension: "step",
    summary: "STEP, B-spline faces in shells",
    several: true,
    write,
};

/// - **errors** a degree above 25 or of 0 (E0305); no patches with positive weights, or weights
///   that differ by a factor above 10⁶ (E0304); a number beyond the last double, or knots that
///   merge (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let ratio = refusal::check(model, context)?;
    let clear = with_clear_boundaries(model)?;
    let mut entities = Entities::default();
    let mut written = Written::default();
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

/// What is known of the nets that are written.
#[derive(Default)]
struct Written {
    fidelity: Option<Fidelity>,
    warnings: Vec<ExportFault>,
}

impl Written {
    /// The doubles of some nets; of each kind of warning the first is kept.
    fn round<'a>(
        &mut self,
        nets: impl Iterator<Item = &'a ControlNet>,
    ) -> Result<Vec<RoundedNet>, ExportFault> {
        let mut list = Vec::new();
        for net in nets {
            let net = readable(net);
            let rounded = RoundedNet::new(&net)?;
            refusal::check_doubles(&net, &rounded)?;
            let fidelity = rounded.fidelity(&net);
            self.fidelity = Some(match self.fidelity.take() {
                Some(known) => known.worse(fidelity),
                None => fidelity,
            });
            for warning in &rounded.warnings {
                if self.warnings.iter().all(|own| own.code != warning.code) {
                    self.warnings.push(warning.clone());
                }
            }
            list.push(rounded);
        }
        Ok(list)
    }
}

/// The net over a domain that readers can tell from a point: a direction whose parameters lie too
/// close together, or too far out, runs from 0 to 1 instead. The surface is the same.
fn readable(net: &ControlNet) -> ControlNet {
    let limit = Real::from(1_000_000);
    let knots = |knots: &Knots| {
        let (from, to) = knots.domain();
        let length = to.minus(from);
        let far = |end: &Real| {
            let end = if end.sign().is_lt() {
                end.negated()
            } else {
                end.clone()
            };
            end > length.times(&limit)
        };
        let short = length.times(&limit) < Real::one();
        if short || length > limit || far(from) || far(to) {
            knots.normalised()
        } else {
            knots.clone()
        }
    };
    let moved = net.with_knots(knots(net.knots_u()), knots(net.knots_v()));
    moved.unwrap_or_else(|| net.clone())
}

fn unbounded() -> ExportFault {
    ExportFault::new(
        Code::W1009,
        "sides or corners coincide or nearly do: the surface is written without edges",
        "some readers ignore such a surface; cut the domain into parts that do not close up, and export each",
    )
}
