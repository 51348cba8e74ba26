use crate::net::{Shell, Side};
use crate::number::{Field, Real};

use super::Subdivision;
use super::lattice::{Lattice, ratio};

/// A side of a face, counter-clockwise around the unit square, and the inner points beside it.
pub(super) struct Outline {
    /// Places on the side and the points there; one point if the side is collapsed.
    pub(super) outer: Vec<(Real, usize)>,
    /// Places beside the side and the inner points there.
    pub(super) inner: Vec<(Real, [usize; 2])>,
    side: usize,
}

impl Outline {
    /// The four sides of a face, from the start of u and v.
    pub(super) fn sides(
        shell: &Shell,
        face: usize,
        steps: &Subdivision,
        lattice: &Lattice,
    ) -> [Self; 4] {
        let [m, n] = steps.faces[face];
        [0, 1, 2, 3].map(|side| {
            let mut outer = chain(shell, face, side, steps, lattice);
            if side >= 2 {
                outer.reverse();
                for (place, _) in &mut outer {
                    *place = Real::one().minus(place);
                }
            }
            let count = if side.is_multiple_of(2) { m } else { n };
            let inner = (1..count).map(|step| {
                let at = match side {
                    0 => [step, 1],
                    1 => [m - 1, step],
                    2 => [m - step, n - 1],
                    _ => [1, n - step],
                };
                (ratio(step, count), at)
            });
            Self {
                outer,
                inner: inner.collect(),
                side,
            }
        })
    }

    /// The parameters of a place on the side.
    pub(super) fn parameters(&self, place: &Real) -> [Real; 2] {
        let back = || Real::one().minus(place);
        match self.side {
            0 => [place.clone(), Real::zero()],
            1 => [Real::one(), place.clone()],
            2 => [back(), Real::one()],
            _ => [Real::zero(), back()],
        }
    }
}

/// The points of a side by its rising parameter.
fn chain(
    shell: &Shell,
    face: usize,
    side: usize,
    steps: &Subdivision,
    lattice: &Lattice,
) -> Vec<(Real, usize)> {
    let face = &shell.faces[face];
    let uses = match &face.sides[side] {
        Side::Point(vertex) => return vec![(Real::zero(), lattice.vertex(*vertex))],
        Side::Edges(uses) => uses,
    };
    let knots = if side.is_multiple_of(2) {
        face.net.knots_u()
    } else {
        face.net.knots_v()
    };
    let (start, end) = knots.domain();
    let length = end.minus(start);
    let mut chain = Vec::new();
    for (index, own) in uses.iter().enumerate() {
        let count = steps.edges[own.edge];
        let [from, to] = [&own.range.0, &own.range.1].map(|own| &own.minus(start) / &length);
        let part = to.minus(&from);
        for step in usize::from(index > 0)..=count {
            let place = from.plus(&part.times(&ratio(step, count)));
            let step = if own.reversed { count - step } else { step };
            chain.push((place, lattice.on_edge(shell, own.edge, step)));
        }
    }
    chain
}
