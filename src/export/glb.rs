//! GLB, the binary form of glTF 2.0: a mesh for each surface, in numbers of 32 bits.

use serde_json::{Value, json};

use crate::net::Model;
use crate::number::Unit;

use super::refusal::Readers;
use super::tessellate::Shaded;
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity, Mesh, Precision};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "glb",
    extension: "glb",
    summary: "GLB, triangles with normals for viewers",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    infinite_power: None,
};

/// The numbers of glTF 2.0 that are used here.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// Points keep the numbers of the surface. Its unit, and its z that points upwards where glTF has
/// y, are the affair of the root node: (x, y, z) becomes (x, z, −y) in metres.
///
/// - **errors** those of [`Readers::check_patches`] and [`Mesh::of`]
fn write(model: &Model, context: &Context<'_>) -> Result<Exported, ExportFault> {
    READERS.check_patches(model)?;
    let mesh = Mesh::of(model, context, Precision::Single)?;
    let mut binary = Binary::default();
    let names = model.parts().iter().map(|own| own.name.as_str());
    let meshes: Vec<_> = names
        .enumerate()
        .map(|(part, name)| binary.mesh(&mesh, part, name))
        .collect();
    let nodes = meshes.iter().enumerate();
    let mut nodes: Vec<_> = nodes
        .map(|(index, own)| json!({"mesh": index, "name": own["name"]}))
        .collect();
    let children: Vec<_> = (0..nodes.len()).collect();
    let [scale, back] = metres(context.unit);
    nodes.push(json!({
        "children": children,
        "matrix": [scale, 0, 0, 0, 0, 0, back, 0, 0, scale, 0, 0, 0, 0, 0, 1],
        "name": context.name(),
    }));
    let generator = format!("sweepc {}", env!("CARGO_PKG_VERSION"));
    let file = json!({
        "asset": {"version": "2.0", "generator": generator},
        "scene": 0,
        "scenes": [{"nodes": [nodes.len() - 1]}],
        "nodes": nodes,
        "meshes": meshes,
        // Thin walls are seen from both sides.
        "materials": [{"doubleSided": true, "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}}],
        "accessors": binary.accessors,
        "bufferViews": binary.views,
        "buffers": [{"byteLength": binary.bytes.len()}],
    });
    Ok(Exported {
        bytes: container(&file, binary.bytes),
        fidelity: Fidelity::Tessellated {
            chord_error: mesh.chord_error,
        },
        warnings: Vec::new(),
    })
}

/// The number of metres in a unit, and its negative.
fn metres(unit: Unit) -> [Value; 2] {
    match unit {
        Unit::Millimetre => [json!(0.001), json!(-0.001)],
        Unit::Centimetre => [json!(0.01), json!(-0.01)],
        Unit::Metre => [json!(1), json!(-1)],
        Unit::Inch => [json!(0.0254), json!(-0.0254)],
    }
}

/// The header and both chunks, each filled up to a multiple of four bytes.
fn container(file: &Value, mut binary: Vec<u8>) -> Vec<u8> {
    let mut text = file.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = |own: usize| u32::try_from(own).unwrap_or(u32::MAX).to_le_bytes();
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend(length(12 + 8 + text.len() + 8 + binary.len()));
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", binary)] {
        bytes.extend(length(chunk.len()));
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

/// The buffer with its views and accessors.
#[derive(Default)]
struct Binary {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Binary {
    /// The triangles of one part.
    fn mesh(&mut self, mesh: &Mesh, part: usize, name: &str) -> Value {
        let own = mesh.triangles.iter().filter(|own| own.part == part);
        let shaded = Shaded::of(mesh, own);
        let points = shaded.corners.iter().map(|own| mesh.vertices[own.vertex]);
        let points: Vec<_> = points.collect();
        let normals = shaded.corners.iter().map(|own| mesh.normals[own.normal]);
        let position = self.vectors(&points);
        let (least, greatest) = box_of(&points);
        self.accessors[position]["min"] = json!(least);
        self.accessors[position]["max"] = json!(greatest);
        let normal = self.vectors(&normals.collect::<Vec<_>>());
        let indices = shaded.triangles.iter().flatten();
        let start = self.bytes.len();
        indices
            .clone()
            .for_each(|own| self.bytes.extend(own.to_le_bytes()));
        let indices = self.accessor(
            start,
            ELEMENT_ARRAY_BUFFER,
            json!({"componentType": UNSIGNED_INT, "count": indices.count(), "type": "SCALAR"}),
        );
        json!({"name": name, "primitives": [{
            "attributes": {"POSITION": position, "NORMAL": normal},
            "indices": indices, "material": 0, "mode": 4,
        }]})
    }

    fn vectors(&mut self, vectors: &[[Double; 3]]) -> usize {
        let start = self.bytes.len();
        for number in vectors.iter().flatten() {
            self.bytes.extend(number.bytes(Precision::Single));
        }
        self.accessor(
            start,
            ARRAY_BUFFER,
            json!({"componentType": FLOAT, "count": vectors.len(), "type": "VEC3"}),
        )
    }

    /// The place of an accessor to all bytes from a start on.
    fn accessor(&mut self, start: usize, target: u32, mut accessor: Value) -> usize {
        accessor["bufferView"] = json!(self.views.len());
        let length = self.bytes.len() - start;
        self.views.push(
            json!({"buffer": 0, "byteOffset": start, "byteLength": length, "target": target}),
        );
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

/// The least and the greatest of each coordinate.
fn box_of(points: &[[Double; 3]]) -> ([Value; 3], [Value; 3]) {
    let ends = |axis: usize| {
        let values = points.iter().map(|own| own[axis].value());
        let mut values: Vec<_> = values.collect();
        values.sort_by(|one, other| one.total_cmp(other));
        (json!(values.first()), json!(values.last()))
    };
    let [x, y, z] = [0, 1, 2].map(ends);
    ([x.0, y.0, z.0], [x.1, y.1, z.1])
}
