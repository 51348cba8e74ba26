use std::collections::HashMap;

use super::{Corner, Mesh, Triangle};

/// Some triangles of a mesh for formats in which a vertex has one normal: each pair of a vertex and
/// a normal that occurs is an entry of its own.
pub(in crate::export) struct Shaded {
    /// The entries, in order of their first use.
    pub(in crate::export) corners: Vec<Corner>,
    /// The triangles, by entries.
    pub(in crate::export) triangles: Vec<[u32; 3]>,
}

impl Shaded {
    pub(in crate::export) fn of<'a>(
        mesh: &Mesh,
        triangles: impl Iterator<Item = &'a Triangle>,
    ) -> Self {
        let mut known = HashMap::with_capacity(mesh.vertices.len());
        let mut corners = Vec::new();
        let triangles = triangles.map(|own| {
            own.corners.map(|corner| {
                *known.entry(corner).or_insert_with(|| {
                    corners.push(corner);
                    // Three for each triangle, and of those there are fewer.
                    u32::try_from(corners.len() - 1).unwrap_or(u32::MAX)
                })
            })
        });
        let triangles = triangles.collect();
        Self { corners, triangles }
    }
}
