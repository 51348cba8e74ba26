#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

/// A point or a vector of a picture.
pub(super) type Vector = [f64; 3];

/// a − b
pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a · b
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b
pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a / ‖a‖; the zero vector stays as it is.
pub(super) fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    if length > 0.0 {
        a.map(|own| own / length)
    } else {
        a
    }
}

/// (1 − t) a + t b
pub(super) fn between(a: Vector, b: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|axis| a[axis] + t * (b[axis] - a[axis]))
}
