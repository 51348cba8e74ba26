#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use super::vector::{Vector, minus};

/// The side of a cell of the grid that finds triangles, in units of the picture.
const CELL: f64 = 6.0;
/// What is nearer than a line by less than this does not hide it: lines lie on the surface.
const DEPTH: f64 = 0.6;
/// Cells along a side of the picture at most.
const CELLS: usize = 512;

/// Projected triangles, and which stretches of lines they hide.
pub(super) struct Occluder {
    triangles: Vec<[Vector; 3]>,
    corner: [f64; 2],
    columns: usize,
    rows: usize,
    cells: Vec<Vec<usize>>,
}

impl Occluder {
    /// Triangles in the coordinates of a [`Camera`](super::camera::Camera), in any order.
    pub(super) fn new(triangles: Vec<[Vector; 3]>) -> Self {
        let all = || triangles.iter().flatten();
        let least = |axis: usize| all().map(|own| own[axis]).fold(f64::INFINITY, f64::min);
        let greatest = |axis: usize| all().map(|own| own[axis]).fold(f64::NEG_INFINITY, f64::max);
        let corner = [least(0), least(1)];
        let count = |axis: usize| cell(greatest(axis) - corner[axis]) + 1;
        let (columns, rows) = (count(0).min(CELLS), count(1).min(CELLS));
        let mut occluder = Self {
            triangles: Vec::new(),
            corner,
            columns,
            rows,
            cells: vec![Vec::new(); columns * rows],
        };
        for (index, triangle) in triangles.iter().enumerate() {
            for place in occluder.places(triangle) {
                occluder.cells[place].push(index);
            }
        }
        occluder.triangles = triangles;
        occluder
    }

    /// The cells that the bounds of some points meet.
    fn places(&self, points: &[Vector]) -> Vec<usize> {
        let range = |axis: usize, count: usize| {
            let along = points.iter().map(|own| own[axis] - self.corner[axis]);
            let least = along.clone().fold(f64::INFINITY, f64::min);
            let greatest = along.fold(f64::NEG_INFINITY, f64::max);
            cell(least).min(count - 1)..=cell(greatest).min(count - 1)
        };
        let columns = range(0, self.columns);
        let rows = range(1, self.rows);
        rows.flat_map(|row| columns.clone().map(move |column| (row, column)))
            .map(|(row, column)| row * self.columns + column)
            .collect()
    }

    /// Whether a point lies behind a triangle.
    pub(super) fn hides(&self, point: Vector) -> bool {
        let here = |own: &[Vector; 3]| behind(own, point, point).is_some();
        let places = self.places(&[point]).into_iter();
        places
            .flat_map(|place| &self.cells[place])
            .any(|index| here(&self.triangles[*index]))
    }

    /// The stretches of a short segment that lie behind a triangle: ascending in the parameter
    /// from 0 to 1, apart from each other.
    pub(super) fn hidden(&self, from: Vector, to: Vector) -> Vec<(f64, f64)> {
        let places = self.places(&[from, to]);
        let mut near: Vec<usize> = places
            .into_iter()
            .flat_map(|place| self.cells[place].iter().copied())
            .collect();
        near.sort_unstable();
        near.dedup();
        let mut stretches: Vec<(f64, f64)> = near
            .into_iter()
            .filter_map(|index| behind(&self.triangles[index], from, to))
            .collect();
        stretches.sort_by(|left, right| left.0.total_cmp(&right.0));
        let mut merged: Vec<(f64, f64)> = Vec::new();
        for own in stretches {
            match merged.last_mut() {
                Some(last) if own.0 <= last.1 => last.1 = last.1.max(own.1),
                _ => merged.push(own),
            }
        }
        merged
    }
}

/// The cell of a distance from the corner; that of what lies before it is the first.
fn cell(distance: f64) -> usize {
    (distance / CELL) as usize
}

/// Where a segment lies behind a triangle.
///
/// Inside the projected triangle three linear functions of the parameter are not negative; behind
/// it the depth of its plane exceeds that of the segment.
fn behind(triangle: &[Vector; 3], from: Vector, to: Vector) -> Option<(f64, f64)> {
    let [a, b, c] = *triangle;
    let area = turn(a, b, c);
    if area == 0.0 || !area.is_finite() {
        return None;
    }
    let parts = |point| {
        let (first, second) = (turn(point, b, c) / area, turn(a, point, c) / area);
        [first, second, 1.0 - first - second]
    };
    let (start, end) = (parts(from), parts(to));
    let depth = |own: [f64; 3]| own[0] * a[2] + own[1] * b[2] + own[2] * c[2];
    let gap = (depth(start) - from[2] - DEPTH, depth(end) - to[2] - DEPTH);
    let inside = [0, 1, 2].map(|index| (start[index], end[index]));
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for (first, last) in inside.into_iter().chain([gap]) {
        if first < 0.0 && last < 0.0 {
            return None;
        }
        if first < 0.0 {
            low = low.max(first / (first - last));
        } else if last < 0.0 {
            high = high.min(first / (first - last));
        }
    }
    (low < high).then_some((low, high))
}

/// Twice the signed area of a projected triangle.
fn turn(a: Vector, b: Vector, c: Vector) -> f64 {
    let (left, right) = (minus(b, a), minus(c, a));
    left[0] * right[1] - left[1] * right[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The square 0 ≤ x, y ≤ 8 at a depth of 4 + x/2.
    fn square() -> Occluder {
        let corner = |x: f64, y: f64| [x, y, 4.0 + x / 2.0];
        let [a, b] = [corner(0.0, 0.0), corner(8.0, 0.0)];
        let [c, d] = [corner(8.0, 8.0), corner(0.0, 8.0)];
        Occluder::new(vec![[a, b, c], [a, c, d]])
    }

    #[test]
    fn a_line_is_hidden_where_it_passes_behind() {
        let along = |depth: f64| square().hidden([-8.0, 1.0, depth], [24.0, 1.0, depth]);
        assert_eq!(along(0.0), [(0.25, 0.5)], "behind all of it");
        assert_eq!(along(9.0), [], "before all of it");
        assert_eq!(
            along(6.0 - DEPTH),
            [(0.375, 0.5)],
            "where the square is nearer than 6: from x = 4 on"
        );
        let beside = square().hidden([-8.0, 9.0, 0.0], [24.0, 9.0, 0.0]);
        assert_eq!(beside, []);
        assert!(square().hides([1.0, 1.0, 0.0]) && !square().hides([1.0, 1.0, 9.0]));
        assert!(!square().hides([9.0, 9.0, 0.0]));
    }

    #[test]
    fn a_line_on_the_surface_is_seen() {
        let seen = square().hidden([0.0, 0.0, 4.0], [8.0, 8.0, 8.0]);
        assert_eq!(seen, []);
        let edge = square().hidden([8.0, 0.0, 8.0], [8.0, 8.0, 8.0]);
        assert_eq!(edge, []);
    }

    #[test]
    fn a_triangle_seen_on_edge_hides_nothing() {
        let wall = Occluder::new(vec![[[0.0, 0.0, 9.0], [8.0, 8.0, 9.0], [4.0, 4.0, 12.0]]]);
        assert_eq!(wall.hidden([0.0, 4.0, 0.0], [8.0, 4.0, 0.0]), []);
    }
}
