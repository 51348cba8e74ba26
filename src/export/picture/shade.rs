#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use super::grid::Grid;
use super::occluder::Occluder;
use super::stage::Stage;
use super::vector::{Vector, between, cross, dot, minus, unit};

/// The number of tones from dark to light.
pub(super) const TONES: u8 = 64;
/// Cells of one tone along a side, where that can be.
const CELLS: usize = 32;
/// The direction to the light, in the picture: from the left, from above, from the front.
const LIGHT: Vector = [-0.45, -0.65, 0.61];

/// A cell of a surface in one tone.
pub(super) struct Shade {
    /// Whether the front is seen: at first the side of the normal.
    pub(super) is_front: bool,
    is_hidden: bool,
    /// From 0, dark, to [`TONES`] − 1, light.
    pub(super) tone: u8,
    pub(super) corners: [[f64; 2]; 4],
    pub(super) depth: f64,
}

/// The cells of a surface.
pub(super) struct Shades {
    pub(super) cells: Vec<Shade>,
}

impl Shades {
    pub(super) fn of(grid: &Grid, stage: &Stage, occluder: &Occluder) -> Self {
        let light = unit(LIGHT);
        // a divisor of the steps between two lines
        let width = grid.steps.map(|own| match own / CELLS {
            0 | 1 => 1,
            2 | 3 => 2,
            _ => 4,
        });
        let cells = grid.cells(width).map(|cell| {
            let places = cell.map(|[i, j]| stage.place(grid.at(i, j).point));
            let [a, b, c, d] = places;
            let normal = unit(cross(minus(c, a), minus(d, b)));
            // Down is positive in a picture: its normals point the other way. Seen from its back
            // a cell is lit from its back.
            let is_front = normal[2] < 0.0;
            let lit = dot(normal, light);
            let lit = if is_front { -lit } else { lit };
            let brightness = f64::from(TONES - 1) * (0.5 + 0.5 * lit);
            let middle = between(between(a, c, 0.5), between(b, d, 0.5), 0.5);
            let is_hidden = places
                .iter()
                .chain([&middle])
                .all(|own| occluder.hides(*own));
            Shade {
                is_front,
                is_hidden,
                tone: brightness.round() as u8,
                corners: places.map(|[x, y, _]| [x, y]),
                depth: middle[2],
            }
        });
        Self {
            cells: cells.filter(|own| own.depth.is_finite()).collect(),
        }
    }

    /// The cells in sight that show the side of the normal, less those that show the other.
    pub(super) fn votes(&self) -> i64 {
        let seen = self.cells.iter().filter(|own| !own.is_hidden);
        seen.map(|own| if own.is_front { 1 } else { -1 }).sum()
    }

    /// Makes the side of the normal the front, or the other.
    pub(super) fn turn(&mut self, is_normal: bool) {
        for own in &mut self.cells {
            own.is_front = own.is_front == is_normal;
        }
    }

    /// The cells of all surfaces that are not hidden, the farthest first.
    pub(super) fn from_afar(all: &[Self]) -> Vec<&Shade> {
        let mut cells: Vec<&Shade> = all
            .iter()
            .flat_map(|own| &own.cells)
            .filter(|own| !own.is_hidden)
            .collect();
        cells.sort_by(|one, other| one.depth.total_cmp(&other.depth));
        cells
    }
}
