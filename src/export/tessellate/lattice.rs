use std::rc::Rc;

use crate::export::{Double, Precision};
use crate::net::Shell;
use crate::number::{Integer, Real};

use super::Subdivision;
use super::nearest::nearest_point;
use super::tensor::Tensor;

/// The vertices of a subdivided shell, numbered from a first one: those of the shell, the inner
/// points of its edges from their start, the inner points of its faces u by u and v by v within.
pub(super) struct Lattice {
    vertices: usize,
    edges: Vec<usize>,
    faces: Vec<usize>,
    steps: Rc<Subdivision>,
}

/// k/n
pub(super) fn ratio(step: usize, steps: usize) -> Real {
    Real::ratio(Integer::from(step), Integer::from(steps))
}

/// The parameters strictly between 0 and 1 at equal steps.
pub(super) fn inside(steps: usize) -> Vec<Real> {
    (1..steps).map(|own| ratio(own, steps)).collect()
}

impl Lattice {
    /// The lattice of a shell behind other points, whose own points are added to those; none if
    /// one is beyond the last number of the format.
    pub(super) fn of(
        shell: &Shell,
        steps: &Rc<Subdivision>,
        precision: Precision,
        points: &mut Vec<[Double; 3]>,
    ) -> Option<Self> {
        let vertices = points.len();
        for point in &shell.vertices {
            let [x, y, z] = point
                .each_ref()
                .map(|own| Double::nearest_in(precision, own));
            points.push([x?, y?, z?]);
        }
        let mut edges = Vec::new();
        for (edge, steps) in shell.edges.iter().zip(&steps.edges) {
            edges.push(points.len());
            let curve = Tensor::of_curve(&edge.row);
            let row = curve.at_v(&Real::from(0));
            for place in inside(*steps) {
                points.push(nearest_point(precision, &row.at(&place))?);
            }
        }
        let mut faces = Vec::new();
        for (face, [m, n]) in shell.faces.iter().zip(&steps.faces) {
            let first = points.len();
            faces.push(first);
            let (u, v) = (inside(*m), inside(*n));
            let zero = Double::default();
            points.resize(first + u.len() * v.len(), [zero; 3]);
            let mut sound = true;
            Tensor::of_net(&face.net).grid(&u, &v, |i, j, value| {
                let point = nearest_point(precision, &value);
                sound &= point.is_some();
                points[first + i * v.len() + j] = point.unwrap_or([zero; 3]);
            });
            if !sound {
                return None;
            }
        }
        Some(Self {
            vertices,
            edges,
            faces,
            steps: Rc::clone(steps),
        })
    }

    /// A vertex of the shell.
    pub(super) fn vertex(&self, vertex: usize) -> usize {
        self.vertices + vertex
    }

    /// The point of an edge so many steps from its start.
    pub(super) fn on_edge(&self, shell: &Shell, edge: usize, step: usize) -> usize {
        match step {
            0 => self.vertex(shell.edges[edge].start),
            own if own == self.steps.edges[edge] => self.vertex(shell.edges[edge].end),
            own => self.edges[edge] + own - 1,
        }
    }

    /// The point inside a face at step i along u and j along v.
    pub(super) fn in_face(&self, face: usize, [i, j]: [usize; 2]) -> usize {
        let [_, n] = self.steps.faces[face];
        self.faces[face] + (i - 1) * (n - 1) + j - 1
    }
}
