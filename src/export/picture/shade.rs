#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use super::grid::Grid;
use super::stage::Stage;
use super::vector::{Vector, cross, dot, minus, unit};

/// The number of tones from dark to light.
pub(super) const TONES: u8 = 64;
/// Cells of one tone along a side, from which on they are twice as wide.
const MANY: usize = 32;
/// The direction to the light, in the picture: from the left, from above, from the front.
const LIGHT: Vector = [-0.45, -0.65, 0.61];

/// A cell of a surface in one tone.
pub(super) struct Shade {
    /// Whether the side is seen that most of the surface shows.
    pub(super) is_front: bool,
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
    pub(super) fn of(grid: &Grid, stage: &Stage) -> Self {
        let light = unit(LIGHT);
        let width = grid.steps.map(|own| if own / 2 > MANY { 4 } else { 2 });
        let cells = grid.cells(width).map(|cell| {
            let places = cell.map(|[i, j]| stage.place(grid.at(i, j).point));
            let [a, b, c, d] = places;
            let normal = unit(cross(minus(c, a), minus(d, b)));
            // Seen from its back a cell is lit from its back.
            let [side, lit] = [normal[2], dot(normal, light)];
            let lit = if side < 0.0 { -lit } else { lit };
            let brightness = f64::from(TONES - 1) * (0.5 + 0.5 * lit);
            Shade {
                is_front: side < 0.0,
                tone: brightness.round() as u8,
                corners: places.map(|[x, y, _]| [x, y]),
                depth: (a[2] + b[2] + c[2] + d[2]) / 4.0,
            }
        });
        let mut cells: Vec<Shade> = cells.filter(|own| own.depth.is_finite()).collect();
        let fronts = cells.iter().filter(|own| own.is_front).count();
        if 2 * fronts < cells.len() {
            for own in &mut cells {
                own.is_front = !own.is_front;
            }
        }
        Self { cells }
    }

    /// The cells of all surfaces, the farthest first.
    pub(super) fn from_afar(all: &[Self]) -> Vec<&Shade> {
        let mut cells: Vec<&Shade> = all.iter().flat_map(|own| &own.cells).collect();
        cells.sort_by(|one, other| one.depth.total_cmp(&other.depth));
        cells
    }
}
