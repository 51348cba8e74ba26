//! JSON for three.js: the arguments of its `NURBSSurface`.

use crate::net::Model;

use super::layout::{Layout, array};
use super::refusal::{Readers, affine_net, check_doubles};
use super::{Context, Double, ExportFault, Exported, Exporter, RoundedNet, single};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "three",
    extension: "three.json",
    summary: "JSON for three.js, the arguments of `NURBSSurface`",
    several: false,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};

/// - **errors** a degree of 0 (E0305); a number beyond the last double, or numbers that
///   merge (E0306); a weight that is 0 and no patches
///   (E0304)
fn write(model: &Model, _: &Context) -> Result<Exported, ExportFault> {
    let net = affine_net(single(model)?)?;
    READERS.check_degrees(net.degree())?;
    let rounded = RoundedNet::new(net)?;
    check_doubles(net, &rounded)?;
    let list = |values: &[Double]| array(values.iter().map(|own| own.json()));
    let point = |([x, y, z], w): (&[Double; 3], &Double)| {
        let [x, y, z, w] = [x, y, z, w].map(|own| own.json());
        format!("{{\"x\": {x}, \"y\": {y}, \"z\": {z}, \"w\": {w}}}")
    };
    let rows = rounded.points.iter().zip(&rounded.weights);
    let rows = rows.map(|(points, weights)| array(points.iter().zip(weights).map(point)));
    let file = Layout::Object(vec![
        ("degree1", Layout::line(net.degree().u)),
        ("degree2", Layout::line(net.degree().v)),
        ("knots1", Layout::Line(list(&rounded.knots_u))),
        ("knots2", Layout::Line(list(&rounded.knots_v))),
        ("controlPoints", Layout::Rows(rows.collect())),
    ]);
    Ok(Exported {
        bytes: file.into_bytes(),
        fidelity: rounded.fidelity(net),
        warnings: rounded.warnings,
    })
}
