use super::UniPoly;
use crate::number::{Field, Integer};

/// A polynomial in u with values in F[v], met at one integer after another: Newton's form
/// Σ cₖ (u − x₀) … (u − xₖ₋₁).
pub(super) struct Interpolation<F: Field> {
    points: Vec<i64>,
    differences: Vec<UniPoly<F>>,
}

impl<F: Field> Interpolation<F> {
    /// No point yet.
    pub(super) fn new() -> Self {
        Self {
            points: Vec::new(),
            differences: Vec::new(),
        }
    }

    /// 0, 1, −1, 2, −2, …
    pub(super) fn integers() -> impl Iterator<Item = i64> {
        (0..i64::MAX).map(|index| {
            if index % 2 == 0 {
                -index / 2
            } else {
                index / 2 + 1
            }
        })
    }

    /// The number of points.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// Takes in the value at one more point; true if the polynomial had it there already.
    pub(super) fn push(&mut self, point: i64, value: &UniPoly<F>) -> bool {
        let mut difference = value.clone();
        for (known, own) in self.points.iter().zip(&self.differences) {
            let gap = F::from_integer(&Integer::from(point - known)).inverse();
            difference = (&difference - own).scale(&gap.unwrap_or_else(F::one));
        }
        let known = difference.is_zero() && !self.points.is_empty();
        self.points.push(point);
        self.differences.push(difference);
        known
    }

    /// The coefficients of 1, u, u², …; the last is not 0.
    pub(super) fn rows(&self) -> Vec<UniPoly<F>> {
        let mut rows: Vec<UniPoly<F>> = Vec::new();
        for (point, own) in self.points.iter().zip(&self.differences).rev() {
            // rows ← rows · (u − x) + c
            let factor = F::from_integer(&Integer::from(-point));
            rows.push(UniPoly::zero());
            for index in (0..rows.len()).rev() {
                let mut value = rows[index].scale(&factor);
                if index > 0 {
                    value = &value + &rows[index - 1];
                }
                rows[index] = value;
            }
            rows[0] = &rows[0] + own;
            while rows.last().is_some_and(UniPoly::is_zero) {
                rows.pop();
            }
        }
        rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    #[test]
    fn values_lead_back_to_the_polynomial() {
        let polynomial = UniPoly::from_coefficients(&[3, -1, 5, 2].map(Rational::from));
        let mut interpolation = Interpolation::new();
        for point in Interpolation::<Rational>::integers().take(5) {
            let value = polynomial.evaluate(&point.into());
            let known = interpolation.push(point, &UniPoly::constant(&value));
            assert_eq!(known, interpolation.len() == 5);
        }
        let found: Vec<_> = interpolation
            .rows()
            .iter()
            .map(|row| row.coefficient(0))
            .collect();
        assert_eq!(found, polynomial.coefficients());
    }

    #[test]
    fn every_integer_comes_once() {
        let first: Vec<_> = Interpolation::<Rational>::integers().take(5).collect();
        assert_eq!(first, [0, 1, -1, 2, -2]);
    }
}
