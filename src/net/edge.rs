use super::{CurveNet, VertexId};

/// The place of an edge in its [shell](super::Shell).
pub type EdgeId = usize;

/// A boundary curve of one face, or the shared one of several.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The curve in [lowest degree](CurveNet::reduced), in the direction of its first use,
    /// whatever the signs of its weights.
    pub curve: CurveNet,
    /// The same curve with the degree and weights that it has in the first face that uses it; its
    /// weights are positive if that face's are.
    pub row: CurveNet,
    /// Where the curve starts.
    pub start: VertexId,
    /// Where it ends.
    pub end: VertexId,
}
