use crate::number::{Field, Integer, Real};
use crate::poly::BiDegree;

use super::{ControlNet, Knots};

impl ControlNet {
    /// The same patch in a bidegree that is not lower; none for a net of several spans or a lower
    /// bidegree.
    ///
    /// bᵢ ← (i bᵢ₋₁ + (n + 1 − i) bᵢ)/(n + 1) for i = 0, …, n + 1, in homogeneous coordinates.
    ///
    /// - **holds** [`ControlNet::de_casteljau`] does not change
    #[must_use]
    pub fn elevated(&self, degree: BiDegree) -> Option<Self> {
        let mut rows: Vec<Vec<_>> = (0..self.rows())
            .map(|i| {
                let row = (0..self.columns()).map(|j| self.homogeneous(i, j));
                elevated(row.collect(), degree.v)
            })
            .collect();
        rows = transposed(&rows);
        rows = rows
            .into_iter()
            .map(|own| elevated(own, degree.u))
            .collect();
        let knots = |own: &Knots, degree| {
            let (from, to) = own.domain();
            let raised = own.is_bezier() && degree >= own.degree();
            raised.then(|| Knots::bezier(degree, from, to))?
        };
        let knots_u = knots(self.knots_u(), degree.u)?;
        let knots_v = knots(self.knots_v(), degree.v)?;
        let controls: Vec<_> = transposed(&rows).into_iter().flatten().collect();
        Self::from_homogeneous(knots_u, knots_v, &controls)
    }
}

/// A row of Bernstein coefficients at a degree that is not lower.
fn elevated(mut row: Vec<[Real; 4]>, degree: usize) -> Vec<[Real; 4]> {
    while row.len() <= degree {
        let count = row.len();
        let part = |index| Real::ratio(Integer::from(index), Integer::from(count));
        row = (0..=count)
            .map(|index| {
                let (before, after) = (part(index), part(count - index));
                std::array::from_fn(|axis| {
                    let term = |own: Option<&[Real; 4]>, factor: &Real| {
                        own.map_or_else(Real::zero, |own| own[axis].times(factor))
                    };
                    let earlier = index.checked_sub(1).and_then(|own| row.get(own));
                    term(earlier, &before).plus(&term(row.get(index), &after))
                })
            })
            .collect();
    }
    row
}

fn transposed(rows: &[Vec<[Real; 4]>]) -> Vec<Vec<[Real; 4]>> {
    let columns = rows.first().map_or(0, Vec::len);
    let column = |j: usize| rows.iter().map(|row| row[j].clone()).collect();
    (0..columns).map(column).collect()
}
