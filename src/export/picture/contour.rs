#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use std::collections::BTreeMap;

use super::approx_surface::{ApproxSurface, Sample};
use super::grid::Grid;
use super::vector::{Vector, dot};

/// Steps of the bisection for a contour point between two steps of the grid.
const BISECTIONS: usize = 12;

/// A step of a grid.
type Node = [usize; 2];

/// The lines of a surface along which it is seen edge-on: the zeros of n · d for the direction d to
/// the viewer, traced through the triangles of a grid.
pub(super) struct Contours<'a> {
    surface: &'a ApproxSurface,
    grid: &'a Grid,
    toward: Vector,
    points: Vec<Sample>,
    index: BTreeMap<[Node; 2], usize>,
    links: Vec<Vec<usize>>,
}

impl<'a> Contours<'a> {
    /// The contours, each as a chain of samples.
    pub(super) fn of(
        surface: &'a ApproxSurface,
        grid: &'a Grid,
        toward: Vector,
    ) -> Vec<Vec<Sample>> {
        let mut own = Self {
            surface,
            grid,
            toward,
            points: Vec::new(),
            index: BTreeMap::new(),
            links: Vec::new(),
        };
        for [a, b, c, d] in grid.cells([1, 1]) {
            own.cross([a, b, c]);
            own.cross([a, c, d]);
        }
        own.chains()
    }

    /// n · d; none where the surface has no normal.
    fn facing(&self, sample: &Sample) -> Option<f64> {
        let own = dot(sample.normal, self.toward);
        (own.is_finite() && sample.normal != Vector::default()).then_some(own)
    }

    /// The piece of a contour inside a triangle: from one side that it crosses to the other.
    fn cross(&mut self, triangle: [Node; 3]) {
        let [a, b, c] = triangle;
        let mut ends = [[a, b], [b, c], [c, a]]
            .map(|side| self.crossing(side))
            .into_iter()
            .flatten();
        if let (Some(one), Some(other)) = (ends.next(), ends.next()) {
            self.links[one].push(other);
            self.links[other].push(one);
        }
    }

    /// The index of the contour point on a side of a triangle, if there is one.
    fn crossing(&mut self, side: [Node; 2]) -> Option<usize> {
        let [from, to] = if side[0] < side[1] {
            side
        } else {
            [side[1], side[0]]
        };
        let sign = |own: Node| Some(self.facing(self.grid.at(own[0], own[1]))? >= 0.0);
        let (start, end) = (sign(from)?, sign(to)?);
        if start == end {
            return None;
        }
        if let Some(known) = self.index.get(&[from, to]) {
            return Some(*known);
        }
        let place = |ratio: f64| {
            let along = |axis: usize| {
                let (low, high) = (from[axis] as f64, to[axis] as f64);
                low + ratio * (high - low)
            };
            let [u, v] = self.grid.parameters([along(0), along(1)]);
            self.surface.sample(u, v)
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = (low + high) / 2.0;
            if self.facing(&place(middle)).map(|own| own >= 0.0) == Some(start) {
                low = middle;
            } else {
                high = middle;
            }
        }
        let point = place((low + high) / 2.0);
        self.points.push(point);
        self.links.push(Vec::new());
        self.index.insert([from, to], self.points.len() - 1);
        Some(self.points.len() - 1)
    }

    /// The pieces joined: first those with ends, then the closed ones.
    fn chains(&self) -> Vec<Vec<Sample>> {
        let mut used = vec![false; self.points.len()];
        let mut chains = Vec::new();
        let ends = (0..self.points.len()).filter(|own| self.links[*own].len() == 1);
        for start in ends.chain(0..self.points.len()) {
            if used[start] {
                continue;
            }
            let mut chain = Vec::new();
            let mut next = Some(start);
            while let Some(own) = next {
                used[own] = true;
                chain.push(self.points[own]);
                next = self.links[own].iter().copied().find(|other| !used[*other]);
            }
            if chain.len() > 2 && self.links[start].len() == 2 {
                chain.push(self.points[start]);
            }
            if chain.len() > 1 {
                chains.push(chain);
            }
        }
        chains
    }
}
