#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use super::View;
use super::camera::Camera;
use super::vector::{Vector, between, minus};

/// The width of a picture.
pub(super) const WIDTH: f64 = 720.0;
/// The greatest height of what is drawn, without margins and caption.
const GREATEST_HEIGHT: f64 = 440.0;
/// The margin on the left, the right and above.
const MARGIN: f64 = 36.0;
/// The room below, for axes and caption.
const FOOT: f64 = 88.0;

/// A camera that places what it sees in the middle of a picture.
#[derive(Clone)]
pub(super) struct Stage {
    camera: Camera,
    scale: f64,
    middle: Vector,
    /// The height of the picture.
    pub(super) height: f64,
}

impl Stage {
    /// The stage on which all these points are to be seen.
    pub(super) fn new(view: &View, points: &[Vector]) -> Self {
        let camera = Camera::new(view);
        let mut least = [f64::INFINITY; 3];
        let mut greatest = [f64::NEG_INFINITY; 3];
        for point in points {
            let seen = camera.project(*point);
            if seen.iter().all(|own| own.is_finite()) {
                least = [0, 1, 2].map(|axis| least[axis].min(seen[axis]));
                greatest = [0, 1, 2].map(|axis| greatest[axis].max(seen[axis]));
            }
        }
        let extent = [0, 1, 2].map(|axis| greatest[axis] - least[axis]);
        let room = WIDTH - 2.0 * MARGIN;
        let scale = (room / extent[0]).min(GREATEST_HEIGHT / extent[1]);
        let scale = if scale.is_finite() { scale } else { 1.0 };
        let middle = between(least, greatest, 0.5);
        let middle = middle.map(|own| if own.is_finite() { own } else { 0.0 });
        let drawn = (extent[1] * scale).clamp(0.0, GREATEST_HEIGHT);
        let height = (drawn + MARGIN + FOOT).ceil();
        Self {
            camera,
            scale,
            middle,
            height,
        }
    }

    /// Where a point is seen, with its depth in the same scale.
    pub(super) fn place(&self, point: Vector) -> Vector {
        let [x, y, depth] = minus(self.direction(point), self.middle).map(|own| self.scale * own);
        let middle = self.middle();
        [x + middle[0], y + middle[1], depth]
    }

    /// Where a direction points, in the picture and out of it; not scaled.
    pub(super) fn direction(&self, direction: Vector) -> Vector {
        self.camera.project(direction)
    }

    /// The direction to the viewer.
    pub(super) fn toward(&self) -> Vector {
        self.camera.toward()
    }

    /// The middle of what is drawn.
    pub(super) fn middle(&self) -> [f64; 2] {
        [WIDTH / 2.0, MARGIN + (self.height - MARGIN - FOOT) / 2.0]
    }

    /// Units of the picture for a unit of length.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }
}
