use crate::number::{Field, Real};
use crate::poly::{UniPoly, from_bernstein};

use super::{Arguments, BuildFault, Coordinates, Kind, Setting, Shape, Slot};

/// `bezier([P, …], weights: [w, …])`: the (rational) Bézier curve Σ wᵢ Pᵢ Bᵢ / Σ wᵢ Bᵢ on the
/// domain, of degree one less than the number of points.
pub(super) const KIND: Kind = Kind {
    name: "bezier",
    usage: "bezier([P, …]) or bezier([P, …], weights: [w, …])",
    slots: &[
        Slot::positional(Shape::Points),
        Slot::optional("weights", Shape::Numbers),
    ],
    build,
};

fn build(arguments: &Arguments, setting: &Setting<'_>) -> Result<Coordinates, BuildFault> {
    let domain = setting.domain;
    let points = arguments.points(0);
    if points.len() < 2 {
        let message = "a Bézier curve needs two control points or more";
        return Err(BuildFault::malformed(message));
    }
    let ones = vec![Real::one(); points.len()];
    let weights = arguments.numbers(1).unwrap_or(&ones);
    if weights.len() != points.len() {
        let (points, weights) = (points.len(), weights.len());
        let message = format!("{points} control points but {weights} weights");
        return Err(BuildFault::Malformed(message));
    }
    let on_domain =
        |coefficients: &[Real]| from_bernstein(coefficients, domain.start(), domain.end());
    let weight = on_domain(weights);
    if weight.is_zero() {
        return Err(BuildFault::malformed("all weights are zero"));
    }
    let coordinate = |axis: usize| -> UniPoly<Real> {
        let weighted: Vec<Real> = points
            .iter()
            .zip(weights)
            .map(|(point, weight)| weight * &point[axis])
            .collect();
        on_domain(&weighted)
    };
    let numerators = (0..points[0].len()).map(coordinate).collect();
    Ok(Coordinates::rational(weight, numerators))
}
