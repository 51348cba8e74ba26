use crate::number::{Field, Real};
use crate::poly::{BiDegree, BiPoly, bernstein};
use crate::sweep::Domain;

/// The weights of the Bézier net of a surface on its domain, scaled so that the first is 1.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WeightRange {
    /// The least weight.
    pub min: Real,
    /// The greatest weight.
    pub max: Real,
}

impl WeightRange {
    /// Whether all weights are positive.
    #[must_use]
    pub fn is_positive(&self) -> bool {
        self.min.sign().is_gt()
    }
}

/// The range of the Bernstein coefficients of W at the bidegree of the patch; none if the first
/// of them is 0.
pub(super) fn weight_range(
    weight: &BiPoly<Real>,
    degree: BiDegree,
    domain: &Domain,
) -> Option<WeightRange> {
    let mut weights = vec![Real::zero(); (degree.u + 1) * (degree.v + 1)];
    for (in_u, in_v) in weight.terms() {
        let rows = bernstein(in_u, degree.u, domain.u.start(), domain.u.end());
        let columns = bernstein(in_v, degree.v, domain.v.start(), domain.v.end());
        let products = rows
            .iter()
            .flat_map(|row| columns.iter().map(move |column| row * column));
        for (sum, own) in weights.iter_mut().zip(products) {
            *sum = &*sum + &own;
        }
    }
    let scale = weights.first()?.inverse()?;
    let scaled: Vec<Real> = weights.iter().map(|own| own * &scale).collect();
    Some(WeightRange {
        min: scaled.iter().min()?.clone(),
        max: scaled.iter().max()?.clone(),
    })
}
