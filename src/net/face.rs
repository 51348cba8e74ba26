use std::rc::Rc;

use crate::sweep::HomogeneousSurface;

use super::{ControlNet, Side};

/// A patch with its boundary.
#[derive(Clone, Debug)]
pub struct Face {
    /// The part that it is a patch of.
    pub part: usize,
    /// Its net.
    pub net: ControlNet,
    /// W, X, Y, Z.
    pub surface: Rc<HomogeneousSurface>,
    /// South (v at its start), east (u at its end), north (v at its end), west (u at its start).
    /// South and east run with the boundary of the domain, north and west against it.
    pub sides: [Side; 4],
}
