use crate::number::{Field, Real};
use crate::poly::{UniPoly, from_bernstein};

use super::{Arguments, Coordinates, Interval, Kind, Shape, Slot};

/// `bezier([P, …], weights: [w, …])`: the (rational) Bézier curve Σ wᵢ Pᵢ Bᵢ / Σ wᵢ Bᵢ on the
/// domain, of degree one less than the number of points.
pub(super) const KIND: Kind = Kind {
    name: "bezier",
    usage: "bezier([P, …]) or bezier([P, …], weights: [w, …])",
    slots: &[
        Slot {
            label: None,
            shape: Shape::Points,
            optional: false,
        },
        Slot {
            label: Some("weights"),
            shape: Shape::Numbers,
            optional: true,
        },
    ],
    build,
};

fn build(arguments: &Arguments, domain: &Interval) -> Result<Coordinates, String> {
    let points = arguments.points(0);
    if points.len() < 2 {
        return Err("a Bézier curve needs two control points or more".to_owned());
    }
    let ones = vec![Real::one(); points.len()];
    let weights = arguments.numbers(1).unwrap_or(&ones);
    if weights.len() != points.len() {
        return Err(format!(
            "{} control points but {} weights",
            points.len(),
            weights.len()
        ));
    }
    let on_domain =
        |coefficients: &[Real]| from_bernstein(coefficients, domain.start(), domain.end());
    let weight = on_domain(weights);
    if weight.is_zero() {
        return Err("all weights are zero".to_owned());
    }
    let coordinate = |axis: usize| -> UniPoly<Real> {
        let weighted: Vec<Real> = points
            .iter()
            .zip(weights)
            .map(|(point, weight)| weight * &point[axis])
            .collect();
        on_domain(&weighted)
    };
    Ok(Coordinates {
        weight,
        numerators: (0..points[0].len()).map(coordinate).collect(),
    })
}
