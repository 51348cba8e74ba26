//! STL in its binary form: triangles alone, in numbers of 32 bits.

use crate::net::Model;

use super::refusal::Readers;
use super::tessellate::facet_normal;
use super::{Context, ExportFault, Exported, Exporter, Fidelity, Mesh, Precision};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "stl",
    extension: "stl",
    summary: "STL, triangles",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};
/// The bytes of the header.
const HEADER: usize = 80;

/// The normal of a triangle is that of its own points.
///
/// - **errors** those of [`Readers::check_patches`] and [`Mesh::of`]
fn write(model: &Model, context: &Context<'_>) -> Result<Exported, ExportFault> {
    READERS.check_patches(model)?;
    let mesh = Mesh::of(model, context, Precision::Single)?;
    // A file that begins with `solid` is taken for text.
    let title = format!(
        "sweepc {} {} unit {}",
        env!("CARGO_PKG_VERSION"),
        context.name(),
        context.unit.symbol()
    );
    let plain = |own: char| u8::try_from(own).ok().filter(u8::is_ascii);
    let title = title.chars().map(|own| plain(own).unwrap_or(b'?'));
    let mut bytes: Vec<u8> = title.take(HEADER).collect();
    bytes.resize(HEADER, b' ');
    let count = u32::try_from(mesh.triangles.len()).unwrap_or(u32::MAX);
    bytes.extend(count.to_le_bytes());
    for triangle in &mesh.triangles {
        let points = mesh.points(triangle);
        let normal = facet_normal(Precision::Single, points).unwrap_or_default();
        for number in [normal].iter().chain(&points).flatten() {
            bytes.extend(number.bytes(Precision::Single));
        }
        bytes.extend([0, 0]);
    }
    Ok(Exported {
        bytes,
        fidelity: Fidelity::Tessellated {
            chord_error: mesh.chord_error,
        },
        warnings: Vec::new(),
    })
}
