#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use crate::export::Double;
use crate::number::{Rational, Real};

use super::View;
use super::vector::{Vector, dot};

/// A parallel projection: x to the right, y downwards, the third coordinate towards the viewer.
#[derive(Clone)]
pub(super) struct Camera {
    right: Vector,
    up: Vector,
    toward: Vector,
}

impl Camera {
    pub(super) fn new(view: &View) -> Self {
        let [sin, cos] = sine_and_cosine(view.azimuth());
        let [rise, run] = sine_and_cosine(view.elevation());
        Self {
            right: [-sin, cos, 0.0],
            up: [-rise * cos, -rise * sin, run],
            toward: [run * cos, run * sin, rise],
        }
    }

    /// The direction to the viewer.
    pub(super) fn toward(&self) -> Vector {
        self.toward
    }

    pub(super) fn project(&self, point: Vector) -> Vector {
        [
            dot(self.right, point),
            -dot(self.up, point),
            dot(self.toward, point),
        ]
    }
}

/// sin and cos of an angle in degrees, by their power series on an eighth of a turn: the same bits
/// on every machine, and exact for multiples of 90°.
fn sine_and_cosine(degrees: &Rational) -> [f64; 2] {
    let double = Double::nearest(&Real::from(degrees.clone())).map_or(0.0, Double::value);
    let quarters = (double / 90.0).round();
    let rest = (double - 90.0 * quarters) * (std::f64::consts::PI / 180.0);
    let (mut sin, mut cos, mut term) = (0.0, 0.0, 1.0);
    let mut order = 0.0;
    for step in 0..24 {
        let sum = if step % 2 == 0 { &mut cos } else { &mut sin };
        if step % 4 < 2 {
            *sum += term;
        } else {
            *sum -= term;
        }
        order += 1.0;
        term *= rest / order;
    }
    match quarters.rem_euclid(4.0) {
        1.0 => [cos, -sin],
        2.0 => [-sin, -cos],
        3.0 => [-cos, sin],
        _ => [sin, cos],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_views_look_along_the_axes() {
        let seen = |name: &str| {
            let camera = Camera::new(&name.parse().unwrap_or_default());
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| camera.project(axis))
        };
        let (right, up, near) = ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]);
        let away = |own: Vector| own.map(|coordinate| -coordinate);
        assert_eq!(seen("front"), [right, away(near), up]);
        assert_eq!(seen("right"), [near, right, up]);
        assert_eq!(seen("top"), [right, up, near]);
        assert_eq!(seen("90,0"), seen("back"));
        assert_eq!(seen("-180,0"), seen("left"));
        assert_eq!(seen("270,-90"), seen("bottom"));
    }

    #[test]
    fn angles_between_are_those_of_the_series() {
        for angle in [-179_i64, -61, 0, 17, 44, 45, 46, 89, 200, 359] {
            let [sin, cos] = sine_and_cosine(&Rational::from(angle));
            assert!((sin * sin + cos * cos - 1.0).abs() < 1e-15);
        }
        let [sin, cos] = sine_and_cosine(&Rational::from(60));
        assert!((cos - 0.5).abs() < 1e-15 && (sin * sin - 0.75).abs() < 1e-15);
    }
}
