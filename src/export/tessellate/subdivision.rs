use crate::net::{Face, Shell, Side};
use crate::number::{Field, Integer, Real};

use super::flatness::Flatness;

/// Into how many equal steps of the parameter the edges and faces of a shell are divided.
///
/// Along a side that is whole on a face, an edge has no fewer steps than the face, so its steps
/// are no longer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Subdivision {
    /// The steps of each edge along its curve.
    pub edges: Vec<usize>,
    /// The steps of each face along u and along v; the lines between them meet inside the face,
    /// its boundary has the points of the edges.
    pub faces: Vec<[usize; 2]>,
}

impl Subdivision {
    /// The coarsest one within a tolerance; none if a face needs more than so many steps.
    pub(super) fn of(
        shell: &Shell,
        flatness: &[Flatness],
        tolerance: &Integer,
        greatest: usize,
    ) -> Option<Self> {
        let faces = shell.faces.iter().zip(flatness);
        let faces = faces
            .map(|(face, flatness)| flatness.steps(tolerance, least_steps(shell, face), greatest));
        let faces: Vec<_> = faces.collect::<Option<_>>()?;
        let mut edges: Vec<usize> = shell
            .edges
            .iter()
            .map(|own| {
                let closed = own.start == own.end;
                if closed { CLOSED } else { OPEN }
            })
            .collect();
        for (face, steps) in shell.faces.iter().zip(&faces) {
            let along = [steps[0], steps[1], steps[0], steps[1]];
            for ((side, steps), domain) in face.sides.iter().zip(along).zip(domains(face)) {
                let Side::Edges(uses) = side else {
                    continue;
                };
                for own in uses {
                    let part = own.range.1.minus(&own.range.0);
                    let own = &mut edges[own.edge];
                    *own = (*own).max(steps_on(&part, &domain, steps));
                }
            }
        }
        Some(Self { edges, faces })
    }

    /// The number of triangles.
    pub(super) fn triangles(&self, shell: &Shell) -> usize {
        let faces = shell.faces.iter().zip(&self.faces);
        let count = faces.map(|(face, [m, n])| {
            let boundary: usize = face.uses().map(|own| self.edges[own.edge]).sum();
            let cells = (m - 2).saturating_mul(n - 2);
            let inner = cells.saturating_add(m - 2).saturating_add(n - 2);
            inner.saturating_mul(2).saturating_add(boundary)
        });
        count.fold(0, usize::saturating_add)
    }
}

/// The least number of steps: inner lines must exist.
const OPEN: usize = 2;
/// The same where both ends meet, so that no two steps have both ends in common.
const CLOSED: usize = 4;

/// The least number of steps of a face: more where its boundary touches itself.
fn least_steps(shell: &Shell, face: &Face) -> usize {
    let mut edges: Vec<_> = face.uses().map(|own| own.edge).collect();
    let count = edges.len();
    edges.sort_unstable();
    edges.dedup();
    let ends = |own: usize| shell.edges[own].start == shell.edges[own].end;
    let plain = edges.len() == count && count >= 4 && !edges.into_iter().any(ends);
    if plain { OPEN } else { CLOSED }
}

/// The domain's length along each side.
fn domains(face: &Face) -> [Real; 4] {
    let length = |(from, to): (&Real, &Real)| to.minus(from);
    let (u, v) = (
        length(face.net.knots_u().domain()),
        length(face.net.knots_v().domain()),
    );
    [u.clone(), v.clone(), u, v]
}

/// The least number of steps on a part of a side that are no longer than those of the side.
fn steps_on(part: &Real, side: &Real, steps: usize) -> usize {
    if part == side {
        return steps;
    }
    // The number is between 1 and that of the whole side.
    let enough = |count: usize| {
        let [count, steps] = [count, steps].map(|own| Real::from(Integer::from(own)));
        part.times(&steps) <= side.times(&count)
    };
    let (mut low, mut high) = (1, steps);
    while low < high {
        let middle = low + (high - low) / 2;
        if enough(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}
