use crate::number::Real;

use super::EdgeId;

/// The place of a point in its [shell](super::Shell).
pub type VertexId = usize;

/// One side of a face.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Side {
    /// A side that is collapsed to a point.
    Point(VertexId),
    /// The edges along the side in order of the rising parameter; several where a neighbour ends
    /// midway.
    Edges(Vec<Use>),
}

/// An edge as a part of a side.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Use {
    /// The edge.
    pub edge: EdgeId,
    /// Whether the edge's curve runs against the rising parameter.
    pub reversed: bool,
    /// The range of the side's parameter, in that of the face's net.
    pub range: (Real, Real),
}
