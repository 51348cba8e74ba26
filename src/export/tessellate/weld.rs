use std::collections::HashSet;

use crate::diag::Code;
use crate::export::ExportFault;

use super::Mesh;

/// Makes one vertex of neighbours whose rounded points are equal, and takes away the triangles that
/// are edges or points then.
///
/// - **errors** a mesh that loses more by it: a triangle whose edge no other has, or an edge that
///   two triangles run through in the same direction where none did before (E0308)
pub(super) fn weld(mesh: &mut Mesh) -> Result<(), ExportFault> {
    let mut first: Vec<usize> = (0..mesh.vertices.len()).collect();
    let mut welded = false;
    for triangle in &mesh.triangles {
        for [start, end] in sides(triangle.corners.map(|own| own.vertex)) {
            let (start, end) = (root(&mut first, start), root(&mut first, end));
            if start != end && mesh.vertices[start] == mesh.vertices[end] {
                first[start.max(end)] = start.min(end);
                welded = true;
            }
        }
    }
    if !welded {
        return Ok(());
    }
    let was_sound = has_each_edge_once(mesh);
    for corner in mesh.triangles.iter_mut().flat_map(|own| &mut own.corners) {
        corner.vertex = root(&mut first, corner.vertex);
    }
    let mut lost = Vec::new();
    mesh.triangles.retain(|triangle| {
        let [a, b, c] = triangle.corners.map(|own| own.vertex);
        let sound = a != b && b != c && c != a;
        if !sound {
            lost.extend(
                sides([a, b, c])
                    .into_iter()
                    .filter(|[start, end]| start != end),
            );
        }
        sound
    });
    let kept: HashSet<[usize; 2]> = edges(mesh).collect();
    let has = |[start, end]: &[usize; 2]| {
        kept.contains(&[*start, *end]) || kept.contains(&[*end, *start])
    };
    if mesh.triangles.is_empty() || !lost.iter().all(has) || was_sound && !has_each_edge_once(mesh)
    {
        let message = "points of the triangles become equal in the numbers of the format";
        let help = "give a greater `--chord`; move the surface nearer to the origin, or write `ply` or `mesh`, whose numbers are doubles";
        return Err(ExportFault::new(Code::E0308, message, help));
    }
    Ok(())
}

fn root(first: &mut [usize], mut own: usize) -> usize {
    while first[own] != own {
        first[own] = first[first[own]];
        own = first[own];
    }
    own
}

fn sides([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The directed edges.
fn edges(mesh: &Mesh) -> impl Iterator<Item = [usize; 2]> {
    let triangles = mesh.triangles.iter();
    triangles.flat_map(|own| sides(own.corners.map(|corner| corner.vertex)))
}

/// Whether no two triangles run through an edge in the same direction.
fn has_each_edge_once(mesh: &Mesh) -> bool {
    let mut known = HashSet::new();
    edges(mesh).all(|own| known.insert(own))
}
