use crate::number::Real;

use super::{ControlNet, CurveNet, Edge, EdgeId, Face, Part, Shell, Side, Use, VertexId};

/// The shells of the patches of some parts.
pub(super) fn sew(parts: &[Part]) -> Vec<Shell> {
    let mut sewing = Sewing::default();
    for (part, own) in parts.iter().enumerate() {
        for patch in own.patches().unwrap_or_default() {
            let Some(sides) = sides(&patch.net) else {
                continue;
            };
            let sides = sides.map(|side| sewing.side(side));
            sewing.all.faces.push(Face {
                part,
                net: patch.net.clone(),
                surface: patch.surface.clone(),
                sides,
            });
        }
    }
    sewing.shells()
}

/// The boundary of a net of one span: south, east, north, west, each by its rising parameter, with
/// the parameter's range. None if W is 0 at a corner.
fn sides(net: &ControlNet) -> Option<[(CurveNet, (Real, Real)); 4]> {
    let (last_i, last_j) = (net.rows() - 1, net.columns() - 1);
    let along_u = |j| net.curve((0..=last_i).map(|i| (i, j)));
    let along_v = |i| net.curve((0..=last_j).map(|j| (i, j)));
    let range = |(from, to): (&Real, &Real)| (from.clone(), to.clone());
    let (u, v) = (range(net.knots_u().domain()), range(net.knots_v().domain()));
    Some([
        (along_u(0)?, u.clone()),
        (along_v(last_i)?, v.clone()),
        (along_u(last_j)?, u),
        (along_v(0)?, v),
    ])
}

/// Faces, edges and vertices of all shells together.
#[derive(Default)]
struct Sewing {
    all: Shell,
}

impl Sewing {
    /// A side by its curve: an edge that is known already, or a new one.
    fn side(&mut self, (row, range): (CurveNet, (Real, Real))) -> Side {
        let curve = row.reduced();
        let start = self.vertex(curve.start());
        if curve.degree() == 0 {
            return Side::Point(start);
        }
        let end = self.vertex(curve.end());
        let known = self.all.edges.iter().enumerate().find_map(|(edge, own)| {
            if (own.start, own.end) == (start, end) && own.curve == curve {
                return Some((edge, false));
            }
            let turned = (own.end, own.start) == (start, end) && own.curve.reversed() == curve;
            turned.then_some((edge, true))
        });
        let (edge, reversed) = known.unwrap_or((self.all.edges.len(), false));
        if edge == self.all.edges.len() {
            self.all.edges.push(Edge {
                curve,
                row,
                start,
                end,
            });
        }
        Side::Edges(vec![Use {
            edge,
            reversed,
            range,
        }])
    }

    fn vertex(&mut self, point: &[Real; 3]) -> VertexId {
        let vertices = &mut self.all.vertices;
        let known = vertices.iter().position(|own| own == point);
        known.unwrap_or_else(|| {
            vertices.push(point.clone());
            vertices.len() - 1
        })
    }

    /// The shells, each with its own edges and vertices.
    fn shells(self) -> Vec<Shell> {
        let (edges, vertices) = (&self.all.edges, &self.all.vertices);
        // The first face of each face's shell, as far as it is known.
        let mut first: Vec<usize> = (0..self.all.faces.len()).collect();
        let mut first_with_edge = vec![None; edges.len()];
        for (index, face) in self.all.faces.iter().enumerate() {
            for own in uses(face) {
                let (one, other) = (
                    first[*first_with_edge[own.edge].get_or_insert(index)],
                    first[index],
                );
                let (low, high) = (one.min(other), one.max(other));
                let same = first.iter_mut().filter(|own| **own == high);
                same.for_each(|own| *own = low);
            }
        }
        let mut groups: Vec<(usize, Vec<Face>)> = Vec::new();
        for (face, first) in self.all.faces.into_iter().zip(first) {
            match groups.iter_mut().find(|(own, _)| *own == first) {
                Some((_, faces)) => faces.push(face),
                None => groups.push((first, vec![face])),
            }
        }
        let groups = groups.into_iter();
        groups
            .map(|(_, faces)| shell(faces, edges, vertices))
            .collect()
    }
}

/// The edges that a face uses.
fn uses(face: &Face) -> impl Iterator<Item = &Use> {
    face.sides.iter().flat_map(|side| match side {
        Side::Point(_) => &[],
        Side::Edges(uses) => uses.as_slice(),
    })
}

/// Faces with the edges and vertices that they use, numbered anew.
fn shell(mut faces: Vec<Face>, edges: &[Edge], vertices: &[[Real; 3]]) -> Shell {
    let mut shell = Shell::default();
    let mut known_edges: Vec<EdgeId> = Vec::new();
    let mut known_vertices: Vec<VertexId> = Vec::new();
    let mut vertex = |old: VertexId, shell: &mut Shell| {
        let known = known_vertices.iter().position(|own| *own == old);
        known.unwrap_or_else(|| {
            known_vertices.push(old);
            shell.vertices.push(vertices[old].clone());
            known_vertices.len() - 1
        })
    };
    for side in faces.iter_mut().flat_map(|face| &mut face.sides) {
        match side {
            Side::Point(old) => *old = vertex(*old, &mut shell),
            Side::Edges(uses) => {
                for own in uses {
                    let known = known_edges.iter().position(|old| *old == own.edge);
                    own.edge = known.unwrap_or_else(|| {
                        let edge = &edges[own.edge];
                        let start = vertex(edge.start, &mut shell);
                        let end = vertex(edge.end, &mut shell);
                        known_edges.push(own.edge);
                        shell.edges.push(Edge {
                            start,
                            end,
                            ..edge.clone()
                        });
                        known_edges.len() - 1
                    });
                }
            }
        }
    }
    shell.faces = faces;
    shell
}
