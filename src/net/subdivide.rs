use crate::number::Real;

use super::{ControlNet, Knots};

impl ControlNet {
    /// The Bézier patch on a rectangle of the domain that lies within one pair of spans; none if
    /// it does not, or if W is 0 at its first corner.
    ///
    /// The control points are values of the polar form, bᵢ = f(a, …, a, b, …, b) with i arguments
    /// b, in each direction.
    ///
    /// - **holds** [`ControlNet::de_casteljau`] of the part equals that of the whole
    #[must_use]
    pub fn restricted(&self, u: (&Real, &Real), v: (&Real, &Real)) -> Option<Self> {
        let rows: Option<Vec<Vec<_>>> = (0..self.rows())
            .map(|i| {
                let row: Vec<_> = (0..self.columns())
                    .map(|j| self.homogeneous(i, j))
                    .collect();
                part(self.knots_v(), &row, v)
            })
            .collect();
        let rows = rows?;
        let columns: Option<Vec<Vec<_>>> = (0..=self.degree().v)
            .map(|j| {
                let column: Vec<_> = rows.iter().map(|row| row[j].clone()).collect();
                part(self.knots_u(), &column, u)
            })
            .collect();
        let columns = columns?;
        let degree = self.degree();
        let controls: Vec<_> = (0..=degree.u)
            .flat_map(|i| columns.iter().map(move |column| column[i].clone()))
            .collect();
        let knots_u = Knots::bezier(degree.u, u.0, u.1)?;
        let knots_v = Knots::bezier(degree.v, v.0, v.1)?;
        Self::from_homogeneous(knots_u, knots_v, &controls)
    }
}

/// The Bernstein coefficients of a B-spline on an interval within one of its spans.
fn part(knots: &Knots, points: &[[Real; 4]], (from, to): (&Real, &Real)) -> Option<Vec<[Real; 4]>> {
    let (degree, values) = (knots.degree(), knots.values());
    let span = values.partition_point(|knot| knot <= from);
    if from < values.first()? || from >= to || to > values.get(span)? {
        return None;
    }
    let first = span.checked_sub(1 + degree)?;
    let coefficient = |index: usize| {
        let arguments = (0..degree).map(|own| if own < degree - index { from } else { to });
        knots.polar_form(points, first, &arguments.collect::<Vec<_>>())
    };
    (0..=degree).map(coefficient).collect()
}
