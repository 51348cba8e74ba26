use std::rc::Rc;

use crate::sweep::HomogeneousSurface;

use super::ControlNet;

/// A piece of a surface whose weights are all positive.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Its net, over a rectangle of the surface's domain.
    pub net: ControlNet,
    /// W, X, Y, Z.
    pub surface: Rc<HomogeneousSurface>,
}
