use crate::number::Real;
use crate::poly::{UniPoly, from_bernstein};

use super::{Arguments, Coordinates, Interval, Kind, Shape, Slot};

const POINT: Slot = Slot {
    label: None,
    shape: Shape::Point,
    optional: false,
};

/// `line(P, Q)`: the segment from P to Q, linear on the domain.
pub(super) const KIND: Kind = Kind {
    name: "line",
    usage: "line(P, Q)",
    slots: &[POINT, POINT],
    build,
};

fn build(arguments: &Arguments, domain: &Interval) -> Result<Coordinates, String> {
    let (start, end) = (arguments.point(0), arguments.point(1));
    if start == end {
        return Err("the two points of a line coincide".to_owned());
    }
    let along = |(from, to): (&Real, &Real)| {
        from_bernstein(&[from.clone(), to.clone()], domain.start(), domain.end())
    };
    Ok(Coordinates {
        weight: UniPoly::one(),
        numerators: start.iter().zip(end).map(along).collect(),
    })
}
