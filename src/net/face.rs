use std::rc::Rc;

use crate::number::Field;
use crate::sweep::HomogeneousSurface;

use super::{ControlNet, Side, Use};

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

impl Face {
    /// The edges that it uses, side by side.
    pub fn uses(&self) -> impl Iterator<Item = &Use> {
        self.sides.iter().flat_map(|side| match side {
            Side::Point(_) => &[],
            Side::Edges(uses) => uses.as_slice(),
        })
    }

    /// Whether another face has the same net, read from any of its corners in any direction.
    #[must_use]
    pub fn coincides(&self, other: &Self) -> bool {
        let (own, other) = (&self.net, &other.net);
        let (last_i, last_j) = (other.rows() - 1, other.columns() - 1);
        let turned = |i: usize, j: usize, flip_i: bool, flip_j: bool| {
            let i = if flip_i { last_i - i } else { i };
            (i, if flip_j { last_j - j } else { j })
        };
        let agrees = |place: &dyn Fn(usize, usize) -> (usize, usize)| {
            let first = place(0, 0);
            let scale = other.weight(first.0, first.1);
            (0..own.rows()).all(|i| {
                (0..own.columns()).all(|j| {
                    let (k, l) = place(i, j);
                    own.point(i, j) == other.point(k, l)
                        && own.weight(i, j).times(scale) == *other.weight(k, l)
                })
            })
        };
        let flips = [(false, false), (false, true), (true, false), (true, true)];
        let (same, crossed) = (
            (own.rows(), own.columns()) == (other.rows(), other.columns()),
            (own.rows(), own.columns()) == (other.columns(), other.rows()),
        );
        flips.into_iter().any(|(flip_i, flip_j)| {
            (same && agrees(&|i, j| turned(i, j, flip_i, flip_j)))
                || (crossed && agrees(&|i, j| turned(j, i, flip_i, flip_j)))
        })
    }
}
