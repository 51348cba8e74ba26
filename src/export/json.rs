//! The exact net as JSON, `sweepc-net/1`: exact numbers as strings, their doubles beside them.

use serde_json::json;

use crate::net::{ControlNet, Knots, Model};
use crate::number::{Basis, Real};

use super::layout::{Layout, along, array, rows};
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity, RoundedNet, single};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "json",
    extension: "json",
    summary: "the exact net, with its doubles",
    several: false,
    shows_report: false,
    write,
};

/// - **errors** a number beyond the last double (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let net = &single(model)?.net;
    let rounded = RoundedNet::new(net)?;
    Ok(Exported {
        bytes: net_text(context.name(), net, &rounded).into_bytes(),
        fidelity: Fidelity::Exact,
        warnings: rounded.warnings,
    })
}

/// The net of this name as `sweepc-net/1`, with its doubles.
pub(super) fn net_text(name: &str, net: &ControlNet, rounded: &RoundedNet) -> String {
    let basis = basis(net);
    let definitions = basis.definitions().into_iter();
    let field = definitions.map(|(name, square)| json!({"name": name, "square": square}));
    let quoted = |exact: &Real| format!("\"{}\"", basis.spell(exact));
    let knots = |knots: &Knots| Layout::Line(array(knots.values().iter().map(quoted)));
    let weights = net.weights().iter().map(quoted);
    let points = net.points().iter().map(|own| array(own.iter().map(quoted)));
    let columns = net.columns();
    let file = Layout::Object(vec![
        ("format", Layout::line("sweepc-net/1")),
        ("name", Layout::line(name)),
        ("field", Layout::line(field.collect::<Vec<_>>())),
        ("degree", Layout::line([net.degree().u, net.degree().v])),
        ("knots", along(knots(net.knots_u()), knots(net.knots_v()))),
        ("weights", rows(weights.collect(), columns)),
        ("points", rows(points.collect(), columns)),
        ("float", doubles(rounded)),
    ]);
    file.into_text()
}

/// The member `float`: the doubles of knots, weights and points.
fn doubles(net: &RoundedNet) -> Layout {
    let list = |values: &[Double]| array(values.iter().map(|own| own.json()));
    let knots = |values| Layout::Line(list(values));
    let weights = net.weights.iter().map(|row| list(row));
    let points = net
        .points
        .iter()
        .map(|row| array(row.iter().map(|own| list(own))));
    Layout::Object(vec![
        ("knots", along(knots(&net.knots_u), knots(&net.knots_v))),
        ("weights", Layout::Rows(weights.collect())),
        ("points", Layout::Rows(points.collect())),
    ])
}

/// The generators of the numbers of a net.
fn basis(net: &ControlNet) -> Basis {
    let knots = net.knots_u().values().iter().chain(net.knots_v().values());
    let points = net.points().iter().flatten();
    let numbers = knots.chain(net.weights()).chain(points);
    Basis::of(numbers.map(Real::numerator))
}
