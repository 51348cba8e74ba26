use crate::number::Real;
use crate::poly::UniPoly;

use super::Axis;

/// A property of a curve, as a scalar function of its parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Property {
    /// A coordinate of the position r.
    Position(Axis),
    /// A coordinate of the hodograph r′.
    Hodograph(Axis),
    /// The parametric speed σ = ‖r′‖.
    Speed,
    /// The arc length s from the start of the domain.
    ArcLength,
    /// A coordinate of the unit tangent t = r′/σ.
    Tangent(Axis),
    /// A coordinate of the unit normal n = (b′ e₁ − a′ e₂)/σ of a plane curve.
    Normal(Axis),
    /// The signed curvature κ of a plane curve, positive turning left.
    Curvature,
    /// The signed radius of curvature ρ = 1/κ.
    RadiusOfCurvature,
}

/// A property as an unreduced fraction, with the degrees that counting gives.
///
/// The fraction is the one that papers write, t = (x′, y′)/σ over σ and so on: what a formula
/// loses by cancellation is then visible.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PropertyFunction {
    /// The numerator.
    pub numerator: UniPoly<Real>,
    /// The denominator, not 0.
    pub denominator: UniPoly<Real>,
    /// The degrees of numerator and denominator by counting; never below the true ones.
    pub bound: (usize, usize),
}

impl PropertyFunction {
    /// The derivative (n′d − nd′)/d²; a constant denominator stays.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let slope = self.numerator.derivative();
        let (above, below) = self.bound;
        if self.denominator.is_constant() {
            return Self {
                numerator: slope,
                denominator: self.denominator.clone(),
                bound: (above.saturating_sub(1), below),
            };
        }
        let (top, bottom) = (&self.numerator, &self.denominator);
        let terms = [(1, &slope, bottom), (-1, top, &bottom.derivative())];
        Self {
            numerator: UniPoly::sum_of_products(&terms),
            denominator: bottom * bottom,
            bound: ((above + below).saturating_sub(1), 2 * below),
        }
    }

    /// The value at a parameter; none at a pole.
    #[must_use]
    pub fn evaluate(&self, at: &Real) -> Option<Real> {
        use crate::number::Field;
        let inverse = self.denominator.evaluate(at).inverse()?;
        Some(self.numerator.evaluate(at).times(&inverse))
    }
}
