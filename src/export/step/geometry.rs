use std::collections::HashMap;

use crate::diag::Code;
use crate::export::{Double, ExportFault, RoundedNet};
use crate::net::CurveNet;
use crate::number::Real;

use super::entities::{Entities, Id, list};

/// Points, curves and surfaces as entities; equal points are one.
pub(super) struct Geometry<'a> {
    pub(super) entities: &'a mut Entities,
    points: HashMap<[Double; 3], Id>,
}

impl<'a> Geometry<'a> {
    pub(super) fn new(entities: &'a mut Entities) -> Self {
        Self {
            entities,
            points: HashMap::new(),
        }
    }

    /// The point with these coordinates.
    pub(super) fn point(&mut self, place: &[Double; 3]) -> Id {
        *self.points.entry(*place).or_insert_with(|| {
            let coordinates = list(place.iter().map(|own| own.step()));
            self.entities
                .add(&format!("CARTESIAN_POINT('',{coordinates})"))
        })
    }

    /// A rational curve over [0, 1].
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub(super) fn curve(&mut self, net: &CurveNet, closed: bool) -> Result<Id, ExportFault> {
        let mut points = Vec::new();
        for own in net.points() {
            points.push(self.point(&rounded(own)?));
        }
        let degree = net.degree();
        let closed = logical(closed);
        let spline = format!("{degree},{},.UNSPECIFIED.,{closed},.U.", list(points));
        let knots = format!("({0},{0}),(0.,1.),.UNSPECIFIED.", degree + 1);
        let weights: Result<Vec<Double>, ExportFault> = net.weights().iter().map(nearest).collect();
        let weights = weights?;
        if weights.iter().all(|own| *own == weights[0]) {
            let entity = format!("B_SPLINE_CURVE_WITH_KNOTS('',{spline},{knots})");
            return Ok(self.entities.add(&entity));
        }
        let weights = list(weights.iter().map(|own| own.step()));
        Ok(self.entities.add_complex(&mut [
            "BOUNDED_CURVE()".to_owned(),
            format!("B_SPLINE_CURVE({spline})"),
            format!("B_SPLINE_CURVE_WITH_KNOTS({knots})"),
            "CURVE()".to_owned(),
            "GEOMETRIC_REPRESENTATION_ITEM()".to_owned(),
            format!("RATIONAL_B_SPLINE_CURVE({weights})"),
            "REPRESENTATION_ITEM('')".to_owned(),
        ]))
    }

    /// The surface of a patch.
    pub(super) fn surface(&mut self, net: &RoundedNet) -> Id {
        let rows = &net.points;
        let points = list(rows.iter().map(|row| {
            let points = row.iter().map(|own| self.point(own));
            list(points.collect::<Vec<_>>())
        }));
        let (first, last) = (rows.first(), rows.last());
        let closed_u = logical(first == last);
        let closed_v = logical(rows.iter().all(|row| row.first() == row.last()));
        let u = knot_lists(&net.knots_u);
        let v = knot_lists(&net.knots_v);
        let degree = |knots: &[Double], points: usize| knots.len() - points - 1;
        let columns = rows.first().map_or(0, Vec::len);
        let degree_u = degree(&net.knots_u, rows.len());
        let degree_v = degree(&net.knots_v, columns);
        let spline =
            format!("{degree_u},{degree_v},{points},.UNSPECIFIED.,{closed_u},{closed_v},.U.");
        let knots = format!("{},{},{},{},.UNSPECIFIED.", u.0, v.0, u.1, v.1);
        let rows = &net.weights;
        if rows.iter().flatten().all(|own| *own == rows[0][0]) {
            let entity = format!("B_SPLINE_SURFACE_WITH_KNOTS('',{spline},{knots})");
            return self.entities.add(&entity);
        }
        let weights = rows
            .iter()
            .map(|row| list(row.iter().map(|own| own.step())));
        let weights = list(weights);
        self.entities.add_complex(&mut [
            "BOUNDED_SURFACE()".to_owned(),
            format!("B_SPLINE_SURFACE({spline})"),
            format!("B_SPLINE_SURFACE_WITH_KNOTS({knots})"),
            "GEOMETRIC_REPRESENTATION_ITEM()".to_owned(),
            format!("RATIONAL_B_SPLINE_SURFACE({weights})"),
            "REPRESENTATION_ITEM('')".to_owned(),
            "SURFACE()".to_owned(),
        ])
    }
}

/// The nearest doubles of a point.
///
/// - **errors** a number beyond the last double (E0306)
pub(super) fn rounded([x, y, z]: &[Real; 3]) -> Result<[Double; 3], ExportFault> {
    Ok([nearest(x)?, nearest(y)?, nearest(z)?])
}

fn nearest(exact: &Real) -> Result<Double, ExportFault> {
    Double::nearest(exact).ok_or_else(|| {
        let help = "use a larger unit of length, or a scale in which the numbers are smaller";
        ExportFault::new(
            Code::E0306,
            "a number of an edge is beyond the last double",
            help,
        )
    })
}

/// The multiplicities, and the different knots.
fn knot_lists(knots: &[Double]) -> (String, String) {
    let runs = knots.chunk_by(|one, other| one == other);
    let counts = list(runs.clone().map(<[Double]>::len));
    (counts, list(runs.map(|run| run[0].step())))
}

fn logical(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}
