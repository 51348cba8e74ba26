use crate::number::{Field, Real};

/// The weights and affine points of homogeneous control points (W, X, Y, Z), scaled so that the
/// first weight is 1; where a weight is 0, the direction (X, Y, Z)/W₀. None without points, or if
/// the first weight is 0.
pub(super) fn affine(controls: &[[Real; 4]]) -> Option<(Vec<Real>, Vec<[Real; 3]>)> {
    let scale = controls.first()?[0].inverse()?;
    let weights = controls.iter().map(|[weight, ..]| weight.times(&scale));
    let points = controls.iter().map(|[weight, point @ ..]| {
        let divisor = weight.inverse().unwrap_or_else(|| scale.clone());
        point.each_ref().map(|own| own.times(&divisor))
    });
    Some((weights.collect(), points.collect()))
}
