use std::rc::Rc;

use crate::number::Real;

use super::junction::split_where_others_end;
use super::{ControlNet, CurveNet, Edge, EdgeId, Face, Part, Shell, Side, Use, VertexId};

/// The shells of the patches of some parts.
pub(super) fn sew(parts: &[Part]) -> Vec<Shell> {
    let mut sewing = Sewing::default();
    for (part, own) in parts.iter().enumerate() {
        for patch in own.patches().unwrap_or_default() {
            let Some(sides) = sides(&patch.net) else {
                continue;
            };
            let sides = sides.map(|(row, range)| sewing.side(row, range));
            sewing.all.faces.push(Face {
                part,
                net: patch.net.clone(),
                surface: Rc::clone(&patch.surface),
                sides,
            });
        }
    }
    split_where_others_end(&mut sewing);
    shells(sewing.all)
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
pub(super) struct Sewing {
    pub(super) all: Shell,
}

impl Sewing {
    fn side(&mut self, row: CurveNet, range: (Real, Real)) -> Side {
        let curve = row.reduced();
        if curve.degree() == 0 {
            return Side::Point(self.vertex(curve.start()));
        }
        let (edge, reversed) = self.edge(curve, row);
        Side::Edges(vec![Use {
            edge,
            reversed,
            range,
        }])
    }

    /// The edge along a curve, and whether it runs the other way: one that is known already, or a
    /// new one.
    pub(super) fn edge(&mut self, curve: CurveNet, row: CurveNet) -> (EdgeId, bool) {
        let start = self.vertex(curve.start());
        let end = self.vertex(curve.end());
        let edges = &mut self.all.edges;
        let known = edges.iter().enumerate().find_map(|(edge, own)| {
            if (own.start, own.end) == (start, end) && own.curve == curve {
                return Some((edge, false));
            }
            let turned = (own.end, own.start) == (start, end) && own.curve.reversed() == curve;
            turned.then_some((edge, true))
        });
        known.unwrap_or_else(|| {
            edges.push(Edge {
                curve,
                row,
                start,
                end,
            });
            (edges.len() - 1, false)
        })
    }

    fn vertex(&mut self, point: &[Real; 3]) -> VertexId {
        let vertices = &mut self.all.vertices;
        let known = vertices.iter().position(|own| own == point);
        known.unwrap_or_else(|| {
            vertices.push(point.clone());
            vertices.len() - 1
        })
    }
}

/// The shells, each with its own edges and vertices.
fn shells(all: Shell) -> Vec<Shell> {
    let Shell {
        faces,
        edges,
        vertices,
    } = all;
    // The first face of each face's shell, as far as it is known.
    let mut first: Vec<usize> = (0..faces.len()).collect();
    let mut last_with_edge = vec![None; edges.len()];
    for (index, face) in faces.iter().enumerate() {
        for own in face.uses() {
            let neighbour: usize = last_with_edge[own.edge].replace(index).unwrap_or(index);
            // A face that is there twice is no neighbour of itself.
            if neighbour != index && faces[neighbour].coincides(face) {
                continue;
            }
            let (one, other) = (first[neighbour], first[index]);
            let (low, high) = (one.min(other), one.max(other));
            let same = first.iter_mut().filter(|own| **own == high);
            same.for_each(|own| *own = low);
        }
    }
    let mut groups: Vec<(usize, Vec<Face>)> = Vec::new();
    for (face, first) in faces.into_iter().zip(first) {
        match groups.iter_mut().find(|(own, _)| *own == first) {
            Some((_, faces)) => faces.push(face),
            None => groups.push((first, vec![face])),
        }
    }
    let groups = groups.into_iter();
    groups
        .map(|(_, faces)| shell(faces, &edges, &vertices))
        .collect()
}

/// Faces with the edges and vertices that they use, numbered anew.
fn shell(mut faces: Vec<Face>, edges: &[Edge], vertices: &[[Real; 3]]) -> Shell {
    let mut shell = Shell::default();
    let mut known_edges: Vec<Option<EdgeId>> = vec![None; edges.len()];
    let mut known_vertices: Vec<Option<VertexId>> = vec![None; vertices.len()];
    let mut vertex = |old: VertexId, shell: &mut Shell| {
        *known_vertices[old].get_or_insert_with(|| {
            shell.vertices.push(vertices[old].clone());
            shell.vertices.len() - 1
        })
    };
    for side in faces.iter_mut().flat_map(|face| &mut face.sides) {
        match side {
            Side::Point(old) => *old = vertex(*old, &mut shell),
            Side::Edges(uses) => {
                for own in uses {
                    own.edge = *known_edges[own.edge].get_or_insert_with(|| {
                        let edge = &edges[own.edge];
                        let start = vertex(edge.start, &mut shell);
                        let end = vertex(edge.end, &mut shell);
                        shell.edges.push(Edge {
                            start,
                            end,
                            ..edge.clone()
                        });
                        shell.edges.len() - 1
                    });
                }
            }
        }
    }
    shell.faces = faces;
    shell
}
