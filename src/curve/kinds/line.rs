use crate::number::Real;
use crate::poly::{UniPoly, from_bernstein};

use super::{Arguments, BuildFault, Coordinates, Kind, Setting, Shape, Slot};

/// `line(P, Q)`: the segment from P to Q, linear on the domain.
pub(super) const KIND: Kind = Kind {
    name: "line",
    usage: "line(P, Q)",
    slots: &[
        Slot::positional(Shape::Point),
        Slot::positional(Shape::Point),
    ],
    build,
};

fn build(arguments: &Arguments, setting: &Setting<'_>) -> Result<Coordinates, BuildFault> {
    let (start, end) = (arguments.point(0), arguments.point(1));
    if start == end {
        let message = "the two points of a line coincide";
        return Err(BuildFault::malformed(message));
    }
    let domain = setting.domain;
    let along = |(from, to): (&Real, &Real)| {
        from_bernstein(&[from.clone(), to.clone()], domain.start(), domain.end())
    };
    let numerators = start.iter().zip(end).map(along).collect();
    Ok(Coordinates::rational(UniPoly::one(), numerators))
}
