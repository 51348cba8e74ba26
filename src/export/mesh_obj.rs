//! OBJ with triangles: points and normals in shortest decimals of doubles.

use crate::net::Model;

use super::obj::one_word;
use super::refusal::Readers;
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity, Mesh, Precision};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "mesh",
    extension: "mesh.obj",
    summary: "OBJ, triangles with normals in doubles",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};

/// - **errors** those of [`Readers::check_patches`] and [`Mesh::of`]
fn write(model: &Model, context: &Context<'_>) -> Result<Exported, ExportFault> {
    READERS.check_patches(model)?;
    let mesh = Mesh::of(model, context, Precision::Double)?;
    let mut text = format!(
        "# sweepc {}: triangles; unit {}\n",
        env!("CARGO_PKG_VERSION"),
        context.unit.symbol()
    );
    let mut list = |word: &str, items: &[[Double; 3]]| {
        for item in items {
            let [x, y, z] = item.map(Double::json);
            text.push_str(&format!("{word} {x} {y} {z}\n"));
        }
    };
    list("v", &mesh.vertices);
    list("vn", &mesh.normals);
    for (index, part) in model.parts().iter().enumerate() {
        text.push_str(&format!("o {}\n", one_word(&part.name)));
        for triangle in mesh.triangles.iter().filter(|own| own.part == index) {
            let [a, b, c] = triangle
                .corners
                .map(|own| format!("{}//{}", own.vertex + 1, own.normal + 1));
            text.push_str(&format!("f {a} {b} {c}\n"));
        }
    }
    Ok(Exported {
        bytes: text.into_bytes(),
        fidelity: Fidelity::Tessellated {
            chord_error: mesh.chord_error,
        },
        warnings: Vec::new(),
    })
}
