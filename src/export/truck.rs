//! JSON as the Rust crates of truck read it: a `NurbsSurface<Vector4>`.

use crate::net::Model;

use super::layout::{Layout, array};
use super::refusal::{Readers, check_premultiplied};
use super::{Context, Double, ExportFault, Exported, Exporter, PremultipliedNet, single};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "truck",
    extension: "truck.json",
    summary: "JSON for truck, a `NurbsSurface<Vector4>`",
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
    let point = |[x, y, z, w]: &[Double; 4]| {
        let [x, y, z, w] = [x, y, z, w].map(|own| own.json());
        format!("{{\"x\": {x}, \"y\": {y}, \"z\": {z}, \"w\": {w}}}")
    };
    let rows = rounded.points.iter();
    let rows = rows.map(|row| array(row.iter().map(point)));
    let file = Layout::Object(vec![
        (
            "knot_vecs",
            Layout::Rows(vec![list(&rounded.knots_u), list(&rounded.knots_v)]),
        ),
        ("control_points", Layout::Rows(rows.collect())),
    ]);
    Ok(Exported {
        bytes: file.into_bytes(),
        fidelity: rounded.fidelity(net),
        warnings: rounded.warnings,
    })
}
