//! JSON as the Python library geomdl exchanges it: `geomdl.exchange.import_json`.

use crate::net::{ControlNet, Model};

use super::layout::{Layout, array};
use super::refusal::{Readers, affine_nets, check_doubles};
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity, RoundedNet};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "geomdl",
    extension: "geomdl.json",
    summary: "JSON for geomdl, its exchange format",
    several: true,
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
    let mut surfaces = Vec::new();
    let (mut fidelity, mut warnings) = (Fidelity::Exact, Vec::new());
    for part in model.parts() {
        for net in affine_nets(part)? {
            READERS.check_degrees(net.degree())?;
            let rounded = RoundedNet::new(net)?;
            check_doubles(net, &rounded)?;
            surfaces.push(surface(&part.name, net, &rounded));
            fidelity = fidelity.worse(rounded.fidelity(net));
            warnings.extend(rounded.warnings);
        }
    }
    let file = Layout::Object(vec![(
        "shape",
        Layout::Object(vec![
            ("type", Layout::line("surface")),
            ("count", Layout::line(surfaces.len())),
            ("data", Layout::List(surfaces)),
        ]),
    )]);
    Ok(Exported {
        bytes: file.into_bytes(),
        fidelity,
        warnings,
    })
}

/// One surface. The control points come in one list, i by i and j within i.
fn surface(name: &str, net: &ControlNet, rounded: &RoundedNet) -> Layout {
    let list = |values: &[Double]| array(values.iter().map(|own| own.json()));
    let points = rounded.points.iter().flatten();
    let weights = rounded.weights.iter().flatten().map(|own| own.json());
    let degree = net.degree();
    Layout::Object(vec![
        ("type", Layout::line("spline")),
        ("name", Layout::line(name)),
        ("rational", Layout::line(true)),
        ("dimension", Layout::line(3)),
        ("degree_u", Layout::line(degree.u)),
        ("degree_v", Layout::line(degree.v)),
        ("knotvector_u", Layout::Line(list(&rounded.knots_u))),
        ("knotvector_v", Layout::Line(list(&rounded.knots_v))),
        ("size_u", Layout::line(net.rows())),
        ("size_v", Layout::line(net.columns())),
        (
            "control_points",
            Layout::Object(vec![
                (
                    "points",
                    Layout::Rows(points.map(|own| list(own)).collect()),
                ),
                ("weights", Layout::Line(array(weights))),
            ]),
        ),
    ])
}
