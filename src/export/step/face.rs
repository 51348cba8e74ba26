use crate::export::{Double, RoundedNet};
use crate::net::{ControlNet, Knots};

use super::entities::{Entities, Id, list, string};
use super::side::Side;

/// What a shape representation holds.
pub(super) struct Shape {
    /// The kind of the representation.
    pub(super) representation: &'static str,
    /// Its item.
    pub(super) item: Id,
}

/// The face of a patch, under construction.
pub(super) struct Face<'a> {
    net: &'a ControlNet,
    rounded: &'a RoundedNet,
    entities: &'a mut Entities,
    points: Vec<Vec<Id>>,
    vertices: Vec<([Double; 3], Id)>,
}

impl<'a> Face<'a> {
    /// Writes the control points; surface, edges and vertices refer to them.
    pub(super) fn new(
        net: &'a ControlNet,
        rounded: &'a RoundedNet,
        entities: &'a mut Entities,
    ) -> Self {
        let mut point = |place: &[Double; 3]| {
            let coordinates = list(place.iter().map(|own| own.step()));
            entities.add(&format!("CARTESIAN_POINT('',{coordinates})"))
        };
        let rows = rounded.points.iter();
        let points = rows.map(|row| row.iter().map(&mut point).collect());
        Self {
            points: points.collect(),
            net,
            rounded,
            entities,
            vertices: Vec::new(),
        }
    }

    /// Whether readers understand the boundary as it is meant.
    ///
    /// They make a patch periodic, and drop its last row, if opposite sides agree within their
    /// tolerance, whatever the weights; and two adjacent apices leave them without a corner.
    pub(super) fn has_clear_boundary(&self) -> bool {
        let sides = self.sides();
        let [south, east, north, west] = &sides;
        let clear = |one: &Side, other: &Side| one.meets(other) || !one.nearly_meets(other);
        let apex = sides.each_ref().map(Side::is_nearly_point);
        let adjacent = (apex[0] || apex[2]) && (apex[1] || apex[3]);
        clear(south, north) && clear(west, east) && !adjacent
    }

    /// Writes the face with its edges, in an open shell.
    pub(super) fn write_shell(mut self, name: &str) -> Shape {
        let name = string(name);
        let surface = self.surface();
        let edges = self.edge_loop();
        let bound = self.add(format!("FACE_OUTER_BOUND('',{edges},.T.)"));
        let face = self.add(format!("ADVANCED_FACE({name},({bound}),{surface},.T.)"));
        let shell = self.add(format!("OPEN_SHELL('',({face}))"));
        Shape {
            representation: "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
            item: self.add(format!("SHELL_BASED_SURFACE_MODEL({name},({shell}))")),
        }
    }

    /// Writes the surface alone; readers bound it by its domain.
    pub(super) fn write_bare(mut self, name: &str) -> Shape {
        let surface = self.surface();
        Shape {
            representation: "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION",
            item: self.add(format!("GEOMETRIC_SET({},({surface}))", string(name))),
        }
    }

    /// The four sides: v at its start, u at its end, v at its end, u at its start. The first two
    /// run with the boundary of the domain, the others against it.
    fn sides(&self) -> [Side; 4] {
        let (last_i, last_j) = (self.net.rows() - 1, self.net.columns() - 1);
        let side = |along_u, indices: Vec<(usize, usize)>| {
            let indices = || indices.iter().copied();
            Side {
                along_u,
                points: indices().map(|(i, j)| self.points[i][j]).collect(),
                places: indices().map(|(i, j)| self.rounded.points[i][j]).collect(),
                weights: indices().map(|(i, j)| self.rounded.weights[i][j]).collect(),
            }
        };
        let along_u = |j| side(true, (0..=last_i).map(|i| (i, j)).collect());
        let along_v = |i| side(false, (0..=last_j).map(|j| (i, j)).collect());
        [along_u(0), along_v(last_i), along_u(last_j), along_v(0)]
    }

    /// The boundary: an edge for each side that is not a point, one edge for two sides that meet.
    fn edge_loop(&mut self) -> Id {
        let sides = self.sides();
        let mut edges: [Option<Id>; 4] = [None; 4];
        for (index, side) in sides.iter().enumerate() {
            edges[index] = match index.checked_sub(2) {
                _ if side.is_point() => None,
                Some(opposite) if side.meets(&sides[opposite]) => edges[opposite],
                _ => Some(self.edge(side)),
            };
        }
        let mut oriented = Vec::new();
        for (edge, sense) in edges.iter().zip([".T.", ".T.", ".F.", ".F."]) {
            if let Some(edge) = edge {
                oriented.push(self.add(format!("ORIENTED_EDGE('',*,*,{edge},{sense})")));
            }
        }
        self.add(format!("EDGE_LOOP('',{})", list(oriented)))
    }

    /// The edge along a side, between the vertices at its ends.
    fn edge(&mut self, side: &Side) -> Id {
        let last = side.points.len() - 1;
        let start = self.vertex(side.places[0], side.points[0]);
        let end = self.vertex(side.places[last], side.points[last]);
        let curve = self.curve(side);
        self.add(format!("EDGE_CURVE('',{start},{end},{curve},.T.)"))
    }

    /// The vertex at a corner; corners with the same doubles share it.
    fn vertex(&mut self, place: [Double; 3], point: Id) -> Id {
        if let Some((_, vertex)) = self.vertices.iter().find(|(known, _)| *known == place) {
            return *vertex;
        }
        let vertex = self.add(format!("VERTEX_POINT('',{point})"));
        self.vertices.push((place, vertex));
        vertex
    }

    /// The rational curve of a side.
    fn curve(&mut self, side: &Side) -> Id {
        let (knots, doubles) = if side.along_u {
            (self.net.knots_u(), &self.rounded.knots_u)
        } else {
            (self.net.knots_v(), &self.rounded.knots_v)
        };
        let (degree, points) = (knots.degree(), list(&side.points));
        let closed = logical(side.is_closed());
        let spline = format!("{degree},{points},.UNSPECIFIED.,{closed},.U.");
        let (counts, values) = knot_lists(knots, doubles);
        let knots = format!("{counts},{values},.UNSPECIFIED.");
        if side.is_polynomial() {
            return self.add(format!("B_SPLINE_CURVE_WITH_KNOTS('',{spline},{knots})"));
        }
        let weights = list(side.weights.iter().map(|own| own.step()));
        self.entities.add_complex(&mut [
            "BOUNDED_CURVE()".to_owned(),
            format!("B_SPLINE_CURVE({spline})"),
            format!("B_SPLINE_CURVE_WITH_KNOTS({knots})"),
            "CURVE()".to_owned(),
            "GEOMETRIC_REPRESENTATION_ITEM()".to_owned(),
            format!("RATIONAL_B_SPLINE_CURVE({weights})"),
            "REPRESENTATION_ITEM('')".to_owned(),
        ])
    }

    /// The surface of the patch.
    fn surface(&mut self) -> Id {
        let [south, east, north, west] = self.sides();
        let closed_u = logical(west.meets(&east));
        let closed_v = logical(south.meets(&north));
        let degree = self.net.degree();
        let points = list(self.points.iter().map(list));
        let spline = format!(
            "{},{},{points},.UNSPECIFIED.,{closed_u},{closed_v},.U.",
            degree.u, degree.v
        );
        let u = knot_lists(self.net.knots_u(), &self.rounded.knots_u);
        let v = knot_lists(self.net.knots_v(), &self.rounded.knots_v);
        let knots = format!("{},{},{},{},.UNSPECIFIED.", u.0, v.0, u.1, v.1);
        let rows = &self.rounded.weights;
        if rows.iter().flatten().all(|own| *own == rows[0][0]) {
            return self.add(format!("B_SPLINE_SURFACE_WITH_KNOTS('',{spline},{knots})"));
        }
        let weights = list(
            rows.iter()
                .map(|row| list(row.iter().map(|own| own.step()))),
        );
        self.entities.add_complex(&mut [
            "BOUNDED_SURFACE()".to_owned(),
            format!("B_SPLINE_SURFACE({spline})"),
            format!("B_SPLINE_SURFACE_WITH_KNOTS({knots})"),
            "GEOMETRIC_REPRESENTATION_ITEM()".to_owned(),
            format!("RATIONAL_B_SPLINE_SURFACE({weights})"),
            "REPRESENTATION_ITEM('')".to_owned(),
            "SURFACE()".to_owned(),
        ])
    }

    fn add(&mut self, entity: String) -> Id {
        self.entities.add(&entity)
    }
}

/// The multiplicities, and the different knots.
fn knot_lists(knots: &Knots, doubles: &[Double]) -> (String, String) {
    let mut start = 0;
    let mut values = Vec::new();
    let mut counts = Vec::new();
    for (_, count) in knots.multiplicities() {
        values.push(doubles[start].step());
        counts.push(count);
        start += count;
    }
    (list(counts), list(values))
}

fn logical(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}
