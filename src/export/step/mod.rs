//! STEP AP214 (ISO 10303-21, 10303-214): one B-spline face in an open shell.

mod entities;
mod face;
mod product;
mod refusal;
mod side;

use crate::diag::Code;
use crate::net::{ControlNet, Knots, Model};
use crate::number::{Field, Real};

use super::{Context, ExportFault, Exported, Exporter, RoundedNet, single};
use entities::Entities;
use face::Face;

pub(super) const EXPORTER: Exporter = Exporter {
    name: "step",
    extension: "step",
    summary: "STEP AP214, one B-spline face",
    several: false,
    write,
};

/// - **errors** a degree above 25 or of 0 (E0305); a weight that is not positive, or weights that
///   differ by a factor above 10⁶ (E0304); a number beyond the last double, or knots that merge
///   (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let net = &single(model)?.net;
    refusal::check_degrees(net)?;
    let ratio = refusal::check_weights(net, context)?;
    let net = &readable(net);
    let rounded = RoundedNet::new(net)?;
    refusal::check_doubles(net, &rounded)?;
    let mut entities = Entities::default();
    let face = Face::new(net, &rounded, &mut entities);
    let bounded = face.has_clear_boundary();
    let shape = if bounded {
        face.write_shell(context.name())
    } else {
        face.write_bare(context.name())
    };
    product::write(&shape, context, &mut entities);
    let text = format!(
        "ISO-10303-21;\n{}DATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        product::header(context),
        entities.text()
    );
    let fidelity = rounded.fidelity(net);
    let bare = (!bounded).then(unbounded);
    let warnings = rounded.warnings.into_iter().chain(ratio).chain(bare);
    Ok(Exported {
        bytes: text.into_bytes(),
        fidelity,
        warnings: warnings.collect(),
    })
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
