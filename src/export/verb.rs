//! JSON as the JavaScript library verb reads it: the members of its `NurbsSurfaceData`.

use crate::net::Model;

use super::layout::{Layout, array};
use super::refusal::{Readers, check_premultiplied};
use super::{Context, Double, ExportFault, Exported, Exporter, PremultipliedNet, single};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "verb",
    extension: "verb.json",
    summary: "JSON for verb, a `NurbsSurfaceData`",
    several: false,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};

/// - **errors** a degree of 0 (E0305); a number beyond the last double, or numbers that
///   merge (E0306)
fn write(model: &Model, _: &Context) -> Result<Exported, ExportFault> {
    let net = &single(model)?.net;
    READERS.check_degrees(net.degree())?;
    let rounded = PremultipliedNet::new(net)?;
    check_premultiplied(net, &rounded)?;
    let list = |values: &[Double]| array(values.iter().map(|own| own.json()));
    let rows = rounded.points.iter();
    let rows = rows.map(|row| array(row.iter().map(|own| list(own))));
    let file = Layout::Object(vec![
        ("degreeU", Layout::line(net.degree().u)),
        ("degreeV", Layout::line(net.degree().v)),
        ("knotsU", Layout::Line(list(&rounded.knots_u))),
        ("knotsV", Layout::Line(list(&rounded.knots_v))),
        ("controlPoints", Layout::Rows(rows.collect())),
    ]);
    Ok(Exported {
        bytes: file.into_bytes(),
        fidelity: rounded.fidelity(net),
        warnings: rounded.warnings,
    })
}
