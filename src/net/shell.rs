use crate::number::Real;

use super::{Edge, Face};

/// Faces that share edges.
///
/// Boundary curves that agree exactly, as rational curves up to direction, common factor, degree
/// and scale of the weights, are one edge.
#[derive(Clone, Debug, Default)]
pub struct Shell {
    /// The faces, in order of part, u, v.
    pub faces: Vec<Face>,
    /// The edges, in order of their first use.
    pub edges: Vec<Edge>,
    /// The different ends of edges and collapsed sides, in order of their first use.
    pub vertices: Vec<[Real; 3]>,
}
