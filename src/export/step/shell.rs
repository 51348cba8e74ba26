use std::collections::HashMap;

use crate::export::outward::turned;
use crate::export::{Double, ExportFault, RoundedNet};
use crate::net::{Edge, Face, Model, Shell, Side};

use super::entities::{Entities, Id, list, string};
use super::geometry::{Geometry, rounded};

/// What a shape representation holds.
pub(super) struct Shape {
    /// The kind of the representation.
    pub(super) representation: &'static str,
    /// Its item.
    pub(super) item: Id,
}

/// Writes the shells of a model: one face for each patch, one edge for each boundary, whatever the
/// number of faces that it bounds.
///
/// - **errors** a number beyond the last double (E0306)
pub(super) fn write_shells(
    model: &Model,
    nets: &[Vec<RoundedNet>],
    name: &str,
    entities: &mut Entities,
) -> Result<Shape, ExportFault> {
    let mut shells = Vec::new();
    for (shell, nets) in model.shells().iter().zip(nets) {
        let mut writer = Writer {
            model,
            shell,
            geometry: Geometry::new(entities),
            vertices: HashMap::new(),
            edges: HashMap::new(),
        };
        shells.extend(writer.shells(nets)?);
    }
    let (name, shells) = (string(name), list(shells));
    Ok(Shape {
        representation: "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
        item: entities.add(&format!("SHELL_BASED_SURFACE_MODEL({name},{shells})")),
    })
}

/// Writes the surfaces alone; readers bound them by their domains.
pub(super) fn write_bare(nets: &[RoundedNet], name: &str, entities: &mut Entities) -> Shape {
    let mut geometry = Geometry::new(entities);
    let surfaces: Vec<Id> = nets.iter().map(|net| geometry.surface(net)).collect();
    Shape {
        representation: "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION",
        item: entities.add(&format!(
            "GEOMETRIC_SET({},{})",
            string(name),
            list(surfaces)
        )),
    }
}

/// A shell under construction.
struct Writer<'a> {
    model: &'a Model,
    shell: &'a Shell,
    geometry: Geometry<'a>,
    vertices: HashMap<usize, Id>,
    edges: HashMap<usize, Id>,
}

impl Writer<'_> {
    /// One shell; where its faces cannot be turned so that they agree along all edges, one for each
    /// face, since a shell has two sides and an edge of it at most two faces.
    fn shells(&mut self, nets: &[RoundedNet]) -> Result<Vec<Id>, ExportFault> {
        let orientation = turned(self.shell);
        let unflipped = vec![false; self.shell.faces.len()];
        let flipped = orientation.as_ref().unwrap_or(&unflipped);
        let mut faces = Vec::new();
        for ((face, net), flipped) in self.shell.faces.iter().zip(nets).zip(flipped) {
            faces.push(self.face(face, net, *flipped)?);
        }
        if orientation.is_none() {
            let mut alone = |face: Id| self.add(format!("OPEN_SHELL('',({face}))"));
            return Ok(faces.into_iter().map(&mut alone).collect());
        }
        let kind = if self.shell.is_closed() {
            "CLOSED_SHELL"
        } else {
            "OPEN_SHELL"
        };
        Ok(vec![self.add(format!("{kind}('',{})", list(faces)))])
    }

    /// A face; one that is flipped has the other side of its surface outside.
    fn face(&mut self, face: &Face, net: &RoundedNet, flipped: bool) -> Result<Id, ExportFault> {
        let surface = self.geometry.surface(net);
        let edges = self.edge_loop(face, flipped)?;
        let bound = self.add(format!("FACE_OUTER_BOUND('',{edges},.T.)"));
        let name = string(&self.model.parts()[face.part].name);
        let sense = if flipped { ".F." } else { ".T." };
        Ok(self.add(format!("ADVANCED_FACE({name},({bound}),{surface},{sense})")))
    }

    /// The boundary: the edges of each side that is not a point.
    fn edge_loop(&mut self, face: &Face, flipped: bool) -> Result<Id, ExportFault> {
        let mut oriented = Vec::new();
        for (index, side) in face.sides.iter().enumerate() {
            let Side::Edges(uses) = side else {
                continue;
            };
            let along = index < 2;
            let uses: Vec<_> = if along {
                uses.iter().collect()
            } else {
                uses.iter().rev().collect()
            };
            for own in uses {
                let edge = self.edge(own.edge)?;
                let forward = (own.reversed != along) != flipped;
                let sense = if forward { ".T." } else { ".F." };
                oriented.push(self.add(format!("ORIENTED_EDGE('',*,*,{edge},{sense})")));
            }
        }
        if flipped {
            oriented.reverse();
        }
        Ok(self.add(format!("EDGE_LOOP('',{})", list(oriented))))
    }

    /// The edge between its vertices.
    fn edge(&mut self, edge: usize) -> Result<Id, ExportFault> {
        if let Some(known) = self.edges.get(&edge) {
            return Ok(*known);
        }
        let Edge {
            row, start, end, ..
        } = &self.shell.edges[edge];
        let (first, last) = (self.vertex(*start)?, self.vertex(*end)?);
        let curve = self.geometry.curve(row, start == end)?;
        let id = self.add(format!("EDGE_CURVE('',{first},{last},{curve},.T.)"));
        self.edges.insert(edge, id);
        Ok(id)
    }

    fn vertex(&mut self, vertex: usize) -> Result<Id, ExportFault> {
        if let Some(known) = self.vertices.get(&vertex) {
            return Ok(*known);
        }
        let place: [Double; 3] = rounded(&self.shell.vertices[vertex])?;
        let point = self.geometry.point(&place);
        let id = self.add(format!("VERTEX_POINT('',{point})"));
        self.vertices.insert(vertex, id);
        Ok(id)
    }

    fn add(&mut self, entity: String) -> Id {
        self.geometry.entities.add(&entity)
    }
}
