#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use super::approx_surface::{ApproxSurface, Sample};
use super::vector::{Vector, dot, minus};

/// Steps of the grid from one isoparametric line to the next.
const STEPS: usize = 8;
/// Isoparametric lines from one end of a domain to the other, both ends counted as one.
const LINES: std::ops::RangeInclusive<usize> = 4..=16;

/// Samples of a surface at equal steps of both parameters.
pub(super) struct Grid {
    /// Steps along u and along v; multiples of [`Grid::stride`].
    pub(super) steps: [usize; 2],
    /// u by u, and v by v within.
    samples: Vec<Sample>,
    domain: [[f64; 2]; 2],
}

impl Grid {
    /// A grid whose isoparametric lines are about as far apart as asked for.
    pub(super) fn new(surface: &ApproxSurface, spacing: f64) -> Self {
        let lines = lengths(surface).map(|length| {
            let count = (length / spacing).round() as usize;
            count.clamp(*LINES.start(), *LINES.end())
        });
        let steps = lines.map(|own| own * STEPS);
        let mut grid = Self {
            steps,
            samples: Vec::new(),
            domain: surface.domain(),
        };
        for i in 0..=steps[0] {
            for j in 0..=steps[1] {
                let [u, v] = grid.parameters([i as f64, j as f64]);
                grid.samples.push(surface.sample(u, v));
            }
        }
        grid
    }

    /// The distance of isoparametric lines at which the longer side of a surface has the most.
    pub(super) fn spacing(surface: &ApproxSurface) -> f64 {
        let [u, v] = lengths(surface);
        u.max(v) / *LINES.end() as f64
    }

    /// Steps from one isoparametric line to the next.
    pub(super) fn stride(&self) -> usize {
        STEPS
    }

    /// The parameters at a place that is counted in steps.
    pub(super) fn parameters(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let [from, to] = self.domain[axis];
            let ratio = place[axis] / self.steps[axis] as f64;
            // exact at both ends
            (1.0 - ratio) * from + ratio * to
        })
    }

    /// The sample at step i along u and j along v.
    pub(super) fn at(&self, i: usize, j: usize) -> &Sample {
        &self.samples[i * (self.steps[1] + 1) + j]
    }

    /// All samples.
    pub(super) fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// The line at step i along u, from the start of v to its end.
    pub(super) fn line_u(&self, i: usize) -> Vec<Vector> {
        (0..=self.steps[1]).map(|j| self.at(i, j).point).collect()
    }

    /// The line at step j along v, from the start of u to its end.
    pub(super) fn line_v(&self, j: usize) -> Vec<Vector> {
        (0..=self.steps[0]).map(|i| self.at(i, j).point).collect()
    }

    /// The corners of all cells, as steps: (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1), where
    /// cells are so many steps wide along u and along v.
    pub(super) fn cells(&self, width: [usize; 2]) -> impl Iterator<Item = [[usize; 2]; 4]> {
        let [m, n] = self.steps;
        let [du, dv] = width;
        let rows = (0..m).step_by(du);
        rows.flat_map(move |i| (0..n).step_by(dv).map(move |j| (i, j)))
            .map(move |(i, j)| [[i, j], [i + du, j], [i + du, j + dv], [i, j + dv]])
    }
}

/// The length of the middle line along u, and along v, by chords.
fn lengths(surface: &ApproxSurface) -> [f64; 2] {
    const CHORDS: u8 = 32;
    let domain = surface.domain();
    let at = |axis: usize, ratio: f64| {
        let [from, to] = domain[axis];
        from + ratio * (to - from)
    };
    [0, 1].map(|axis| {
        let points: Vec<Vector> = (0..=CHORDS)
            .map(|step| {
                let own = at(axis, f64::from(step) / f64::from(CHORDS));
                let other = at(1 - axis, 0.5);
                let [u, v] = if axis == 0 {
                    [own, other]
                } else {
                    [other, own]
                };
                surface.sample(u, v).point
            })
            .collect();
        let chords = points.windows(2).map(|pair| minus(pair[1], pair[0]));
        chords.map(|own| dot(own, own).sqrt()).sum()
    })
}
