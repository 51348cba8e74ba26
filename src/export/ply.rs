//! PLY in its binary form: vertices with normals, in doubles.

use crate::net::Model;

use super::refusal::Readers;
use super::tessellate::Shaded;
use super::{Context, ExportFault, Exported, Exporter, Fidelity, Mesh, Precision};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "ply",
    extension: "ply",
    summary: "PLY, triangles with normals in doubles",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};

/// A vertex on an edge has one entry for each of its normals.
///
/// - **errors** those of [`Readers::check_patches`] and [`Mesh::of`]
fn write(model: &Model, context: &Context<'_>) -> Result<Exported, ExportFault> {
    READERS.check_patches(model)?;
    let mesh = Mesh::of(model, context, Precision::Double)?;
    let shaded = Shaded::of(&mesh, mesh.triangles.iter());
    let one_line: Vec<_> = context.name().split_whitespace().collect();
    let mut header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment sweepc {}: {}; unit {}\nelement vertex {}\n",
        env!("CARGO_PKG_VERSION"),
        one_line.join(" "),
        context.unit.symbol(),
        shaded.corners.len(),
    );
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        header.push_str(&format!("property double {name}\n"));
    }
    header.push_str(&format!(
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        shaded.triangles.len()
    ));
    let mut bytes = header.into_bytes();
    for corner in &shaded.corners {
        let (point, normal) = (mesh.vertices[corner.vertex], mesh.normals[corner.normal]);
        for number in point.into_iter().chain(normal) {
            bytes.extend(number.bytes(Precision::Double));
        }
    }
    for triangle in &shaded.triangles {
        bytes.push(3);
        for corner in triangle {
            bytes.extend(corner.to_le_bytes());
        }
    }
    Ok(Exported {
        bytes,
        fidelity: Fidelity::Tessellated {
            chord_error: mesh.chord_error,
        },
        warnings: Vec::new(),
    })
}
