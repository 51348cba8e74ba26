use crate::diag::Code;
use crate::export::{Double, ExportFault, RoundedNet};
use crate::net::CurveNet;
use crate::number::Real;

use super::file::{Entity, File, Parameter, Pointer, Status};

use Parameter::{Integer, Real as Number};

/// The doubles 0 and 1.
pub(super) struct Constants {
    zero: Double,
    one: Double,
}

impl Constants {
    /// - **errors** none in fact: both are doubles
    pub(super) fn new() -> Result<Self, ExportFault> {
        Ok(Self {
            zero: nearest(&Real::from(0))?,
            one: nearest(&Real::from(1))?,
        })
    }
}

/// Entity 128, a rational B-spline surface. Weights and points come with the index along u rising
/// first.
pub(super) fn surface(net: &RoundedNet, label: String, status: Status) -> Entity {
    let (rows, columns) = (net.points.len(), net.points.first().map_or(0, Vec::len));
    let degrees = [
        net.knots_u.len() - rows - 1,
        net.knots_v.len() - columns - 1,
    ];
    let closed_u = net.points.first() == net.points.last();
    let closed_v = net.points.iter().all(|row| row.first() == row.last());
    let weights: Vec<Double> = transposed(&net.weights, columns);
    let polynomial = weights.iter().all(|own| *own == weights[0]);
    let counts = [rows - 1, columns - 1, degrees[0], degrees[1]];
    let flags = [closed_u, closed_v, polynomial, false, false].map(usize::from);
    let points = transposed(&net.points, columns);
    let ends = [&net.knots_u, &net.knots_v].map(|own| [own[0], own[own.len() - 1]]);
    let reals = net.knots_u.iter().chain(&net.knots_v).chain(&weights);
    let reals = reals
        .chain(points.iter().flatten())
        .chain(ends.iter().flatten());
    let integers = counts.into_iter().chain(flags).map(Integer);
    Entity {
        kind: 128,
        form: 0,
        status,
        label,
        parameters: integers.chain(reals.copied().map(Number)).collect(),
    }
}

/// The items of rows, column by column.
fn transposed<T: Copy>(rows: &[Vec<T>], columns: usize) -> Vec<T> {
    let items = (0..columns).flat_map(|j| rows.iter().filter_map(move |row| row.get(j)));
    items.copied().collect()
}

/// Entity 126, a rational B-spline curve over [0, 1].
///
/// - **errors** a number beyond the last double (E0306)
pub(super) fn curve(net: &CurveNet, constants: &Constants) -> Result<Entity, ExportFault> {
    let degree = net.degree();
    let (mut weights, mut points) = (Vec::new(), Vec::new());
    for (weight, point) in net.weights().iter().zip(net.points()) {
        weights.push(nearest(weight)?);
        for own in point {
            points.push(nearest(own)?);
        }
    }
    let closed = points.first_chunk::<3>() == points.last_chunk::<3>();
    let polynomial = weights.iter().all(|own| *own == weights[0]);
    Ok(spline(
        degree,
        [false, closed, polynomial],
        &weights,
        &points,
        constants,
        Status::Part,
    ))
}

/// Entity 126, a segment in the plane of the parameters.
pub(super) fn segment(ends: [[Double; 2]; 2], constants: &Constants) -> Entity {
    let points: Vec<_> = ends
        .iter()
        .flat_map(|[u, v]| [*u, *v, constants.zero])
        .collect();
    let weights = [constants.one; 2];
    let flags = [true, false, true];
    spline(1, flags, &weights, &points, constants, Status::Parametric)
}

fn spline(
    degree: usize,
    [planar, closed, polynomial]: [bool; 3],
    weights: &[Double],
    points: &[Double],
    constants: &Constants,
    status: Status,
) -> Entity {
    let Constants { zero, one } = *constants;
    let flags = [planar, closed, polynomial, false].map(usize::from);
    let integers = [degree, degree].into_iter().chain(flags).map(Integer);
    let knots = [zero, one].map(|own| std::iter::repeat_n(own, degree + 1));
    let reals = knots.into_iter().flatten();
    let reals = reals.chain(weights.iter().chain(points).copied());
    let normal = if planar { one } else { zero };
    let reals = reals.chain([zero, one, zero, zero, normal]);
    Entity {
        kind: 126,
        form: 0,
        status,
        label: String::new(),
        parameters: integers.chain(reals.map(Number)).collect(),
    }
}

/// Entity 102, curves one after the other; one alone stands for itself.
pub(super) fn composite(curves: &[Pointer], status: Status, file: &mut File) -> Pointer {
    if let [only] = curves {
        return *only;
    }
    let pointers = curves.iter().copied().map(Parameter::Pointer);
    let count = [Integer(curves.len())];
    file.add(&Entity {
        kind: 102,
        form: 0,
        status,
        label: String::new(),
        parameters: count.into_iter().chain(pointers).collect(),
    })
}

fn nearest(exact: &Real) -> Result<Double, ExportFault> {
    Double::nearest(exact).ok_or_else(|| {
        let help = "use a larger unit of length, or a scale in which the numbers are smaller";
        let message = "a number of an edge is beyond the last double";
        ExportFault::new(Code::E0306, message, help)
    })
}
