//! OBJ: rational free-form surfaces, one for each patch.

use crate::net::{Model, Part};

use super::refusal::Readers;
use super::written::Written;
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity, RoundedNet};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "obj",
    extension: "obj",
    summary: "OBJ, rational free-form surfaces",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};

/// - **errors** a degree of 0 (E0305); no patches with positive weights, or weights that differ by
///   a factor above 10⁶ (E0304); a number beyond the last double, or numbers that merge (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let ratio = READERS.check(model, context)?;
    let mut written = Written::for_readers(&READERS);
    let mut text = format!(
        "# sweepc {}: x, y, z and the weight; unit {}\n",
        env!("CARGO_PKG_VERSION"),
        context.unit.symbol()
    );
    let mut points = 0;
    for part in model.parts() {
        let patches = part.patches().unwrap_or_default();
        for net in written.round(patches.iter().map(|own| &own.net))? {
            text.push_str(&surface(part, &net, points));
            points += net.points.len() * net.points.first().map_or(0, Vec::len);
        }
    }
    Ok(Exported {
        bytes: text.into_bytes(),
        fidelity: written.fidelity.unwrap_or(Fidelity::Exact),
        warnings: written.warnings.into_iter().chain(ratio).collect(),
    })
}

/// A surface after some points of others. The index along u rises first.
fn surface(part: &Part, net: &RoundedNet, earlier: usize) -> String {
    let (rows, columns) = (net.points.len(), net.points.first().map_or(0, Vec::len));
    let words = |items: &[Double]| {
        let items: Vec<_> = items.iter().map(|own| own.json()).collect();
        items.join(" ")
    };
    let mut text = format!("o {}\n", one_word(&part.name));
    for j in 0..columns {
        for (points, weights) in net.points.iter().zip(&net.weights) {
            let [x, y, z] = points[j];
            text.push_str(&format!("v {}\n", words(&[x, y, z, weights[j]])));
        }
    }
    let (degree_u, degree_v) = (
        net.knots_u.len() - rows - 1,
        net.knots_v.len() - columns - 1,
    );
    let ends = [&net.knots_u, &net.knots_v].map(|own| words(&[own[0], own[own.len() - 1]]));
    let indices = (earlier + 1..=earlier + rows * columns).map(|own| own.to_string());
    let indices: Vec<_> = indices.collect();
    text.push_str(&format!(
        "cstype rat bspline\ndeg {degree_u} {degree_v}\nsurf {} {}\nparm u {}\nparm v {}\nend\n",
        ends.join(" "),
        indices.join(" "),
        words(&net.knots_u),
        words(&net.knots_v),
    ));
    text
}

/// A name without white space.
pub(super) fn one_word(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}
