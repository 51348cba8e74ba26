//! Boundaries as readers understand them: which patches have to be cut before they are faces.

use crate::net::{Face, Model, Part};
use crate::number::{Field, Real};

use super::{Double, ExportFault, RoundedNet};

/// Points closer than 1/NEARNESS coincide for readers, in the unit of length.
const NEARNESS: i64 = 10_000_000;

/// Equal parts along u and along v, in the order in which they are tried.
const DIVISIONS: [(usize, usize); 10] = [
    (1, 1),
    (2, 1),
    (1, 2),
    (2, 2),
    (3, 1),
    (1, 3),
    (3, 2),
    (2, 3),
    (3, 3),
    (4, 4),
];

/// The same surfaces, each in as few patches as have clear boundaries; none where no division of
/// some surface helps.
///
/// Surfaces without positive weights stay as they are.
///
/// - **errors** a number beyond the last double (E0306)
pub(super) fn with_clear_boundaries(model: &Model) -> Result<Option<Model>, ExportFault> {
    let mut parts = Vec::new();
    for part in model.parts() {
        if has_folded_corner(part)? {
            return Ok(None);
        }
        let mut clear = None;
        for (along_u, along_v) in DIVISIONS {
            let divided = part.divided(along_u, along_v);
            if is_clear(&divided)? {
                clear = Some(divided);
                break;
            }
        }
        match clear {
            Some(part) => parts.push(part),
            None => return Ok(None),
        }
    }
    let model = Model::new(parts);
    let mut faces = model.shells().iter().flat_map(|shell| &shell.faces);
    let clear = !faces.any(has_edge_twice);
    Ok(clear.then_some(model))
}

/// Whether two sides of a face run together: on a patch that is not closed there, readers find one
/// place in the domain for both, and give the face another inside.
fn has_edge_twice(face: &Face) -> bool {
    let mut edges: Vec<_> = face.uses().map(|own| own.edge).collect();
    edges.sort_unstable();
    edges.windows(2).any(|own| own[0] == own[1])
}

/// Whether two adjacent sides of a patch are the same curve or the same point. So they are in the
/// corner of any division.
fn has_folded_corner(part: &Part) -> Result<bool, ExportFault> {
    for patch in part.patches().unwrap_or_default() {
        let net = RoundedNet::new(&patch.net)?;
        let sides = sides(&net);
        let mut pairs = (0..4).map(|index| (&sides[index], &sides[(index + 1) % 4]));
        if pairs.any(|(one, other)| nearly_meet(one, other)) {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Whether readers understand the boundaries of all patches as they are meant.
fn is_clear(part: &Part) -> Result<bool, ExportFault> {
    for patch in part.patches().unwrap_or_default() {
        if !has_clear_boundary(&RoundedNet::new(&patch.net)?) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether readers understand the boundary of a patch as it is meant.
///
/// They make a patch periodic, and drop its last row, if opposite sides agree within their
/// tolerance, whatever the weights; two adjacent apices leave them without a corner; other sides
/// that agree, and opposite corners that touch, leave them without an inside.
fn has_clear_boundary(net: &RoundedNet) -> bool {
    let sides = sides(net);
    let apex = sides.each_ref().map(|own| is_nearly_point(own));
    let mut pairs = (0..4).flat_map(|one| (0..one).map(move |other| (one, other)));
    let distinct = pairs.all(|(one, other)| {
        if apex[one] && apex[other] {
            return one - other == 2;
        }
        !nearly_meet(&sides[one], &sides[other])
    });
    let [south, _, north, _] = &sides;
    let touch = |one: Option<&&Point>, other: Option<&&Point>| match (one, other) {
        (Some(one), Some(other)) => near(one, other),
        _ => true,
    };
    distinct && !touch(south.first(), north.last()) && !touch(south.last(), north.first())
}

type Point = [Double; 3];

/// The control points along the four sides: v at its start, u at its end, v at its end, u at its
/// start; each by the rising parameter.
fn sides(net: &RoundedNet) -> [Vec<&Point>; 4] {
    let rows = &net.points;
    let row = |index: usize| rows[index].iter().collect();
    let column = |first: bool| {
        let ends = rows
            .iter()
            .filter_map(|row| if first { row.first() } else { row.last() });
        ends.collect()
    };
    [column(true), row(rows.len() - 1), column(false), row(0)]
}

/// Whether readers may take a side for a point.
fn is_nearly_point(side: &[&Point]) -> bool {
    side.iter().all(|own| near(own, side[0]))
}

/// Whether readers may take both sides for the same curve, in this or the other direction, or for
/// the same point.
fn nearly_meet(one: &[&Point], other: &[&Point]) -> bool {
    let points = is_nearly_point(one) && is_nearly_point(other);
    let near = |(own, other): (&&Point, &&Point)| near(own, other);
    if points {
        return near((&one[0], &other[0]));
    }
    one.len() == other.len()
        && (one.iter().zip(other).all(near) || one.iter().rev().zip(other).all(near))
}

/// Whether readers may take both points for the same: no coordinate differs by more
/// than 1/NEARNESS.
fn near(one: &Point, other: &Point) -> bool {
    one.iter().zip(other).all(|(own, other)| {
        let apart = own.rational().minus(&other.rational());
        let apart = if apart.sign().is_lt() {
            apart.negated()
        } else {
            apart
        };
        Real::from(apart).times(&Real::from(NEARNESS)) <= Real::one()
    })
}
