use super::{BiPoly, UniPoly};
use crate::number::{Field, Residue, Ring};

/// A polynomial over the prime field of [`Residue`], ascending, without trailing zeros: the
/// image of a polynomial's numerators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Image(Vec<Residue>);

impl Image {
    /// The image of the numerators; none if the field has no image.
    pub(super) fn of<F: Field>(polynomial: &UniPoly<F>) -> Option<Self> {
        let residues = polynomial.numerators().iter().map(Ring::residue);
        Some(Self::new(residues.collect::<Option<_>>()?))
    }

    /// Σ cᵢ xⁱ from ascending coefficients.
    pub(super) fn new(mut coefficients: Vec<Residue>) -> Self {
        while coefficients.last() == Some(&Residue::ZERO) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    /// The image of p(a, v), a polynomial in v; none if the field has no
    /// image or a denominator vanishes in it.
    pub(super) fn at_u<F: Field>(polynomial: &BiPoly<F>, at: Residue) -> Option<Self> {
        let terms = polynomial.terms().iter();
        Self::at(terms.map(|(in_u, in_v)| (in_u, in_v)), at)
    }

    /// The image of p(u, b), a polynomial in u.
    pub(super) fn at_v<F: Field>(polynomial: &BiPoly<F>, at: Residue) -> Option<Self> {
        let terms = polynomial.terms().iter();
        Self::at(terms.map(|(in_u, in_v)| (in_v, in_u)), at)
    }

    /// Σ fₖ(a) gₖ
    fn at<'a, F: Field>(
        terms: impl Iterator<Item = (&'a UniPoly<F>, &'a UniPoly<F>)>,
        at: Residue,
    ) -> Option<Self> {
        let mut sum: Vec<Residue> = Vec::new();
        for (fixed, free) in terms {
            let value = Self::of(fixed)?.evaluate(at);
            let denominators = [fixed, free].map(UniPoly::denominator);
            let denominator = denominators
                .into_iter()
                .filter(|own| !Ring::is_one(*own))
                .fold(Residue::ONE, |all, own| all * Residue::of_integer(own));
            if denominator == Residue::ZERO {
                return None;
            }
            let weight = if denominator == Residue::ONE {
                value
            } else {
                value * denominator.inverse()
            };
            let length = sum.len().max(free.numerators().len());
            sum.resize(length, Residue::ZERO);
            for (own, numerator) in sum.iter_mut().zip(free.numerators()) {
                *own = *own + numerator.residue()? * weight;
            }
        }
        Some(Self::new(sum))
    }

    fn evaluate(&self, at: Residue) -> Residue {
        let coefficients = self.0.iter().rev();
        coefficients.fold(Residue::ZERO, |value, own| value * at + *own)
    }

    /// Whether it is a constant times a square; 0 is.
    ///
    /// The root of the monic multiple follows from the upper half of the coefficients.
    pub(super) fn is_square(&self) -> bool {
        let Some(lead) = self.0.last() else {
            return true;
        };
        if self.0.len().is_multiple_of(2) {
            return false;
        }
        let (inverse, half) = (lead.inverse(), Residue::new(2).inverse());
        let monic: Vec<Residue> = self.0.iter().rev().map(|own| *own * inverse).collect();
        let mut root = vec![Residue::ONE];
        for (order, own) in monic.iter().enumerate().skip(1) {
            let first = (order + 1).saturating_sub(self.0.len().div_ceil(2)).max(1);
            let sum = (first..root.len().min(order + 1 - first))
                .map(|index| root[index] * root[order - index])
                .fold(Residue::ZERO, |sum, product| sum + product);
            if order <= self.0.len() / 2 {
                root.push((*own - sum) * half);
            } else if sum != *own {
                return false;
            }
        }
        true
    }

    /// The degree; none for 0.
    pub(super) fn degree(&self) -> Option<usize> {
        self.0.len().checked_sub(1)
    }

    /// The greatest common divisor up to a constant factor, by cross-multiplied remainders
    /// lc(b) a − lc(a) xᵏ b: no inverses.
    pub(super) fn gcd(self, other: Self) -> Self {
        let (mut high, mut low) = (self.0, other.0);
        loop {
            if high.len() < low.len() {
                std::mem::swap(&mut high, &mut low);
            }
            let Some(&divisor) = low.last() else {
                return Self(high);
            };
            if low.len() == 1 {
                return Self(vec![Residue::ONE]);
            }
            let Some(lead) = high.pop() else {
                return Self(low);
            };
            let offset = high.len() + 1 - low.len();
            for own in &mut high[..offset] {
                *own = *own * divisor;
            }
            for (own, subtrahend) in high[offset..].iter_mut().zip(&low) {
                *own = *own * divisor - *subtrahend * lead;
            }
            while high.last() == Some(&Residue::ZERO) {
                high.pop();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(coefficients: &[u64]) -> Image {
        Image::new(coefficients.iter().copied().map(Residue::new).collect())
    }

    #[test]
    fn squares_up_to_a_constant_are_told_from_others() {
        // 3 (x²+2x+5)², and with each of its coefficients changed
        let square = [75, 60, 42, 12, 3];
        assert!(image(&square).is_square());
        for place in 0..square.len() {
            let mut other = square;
            other[place] += 1;
            assert!(!image(&other).is_square(), "{other:?}");
        }
        assert!(image(&[]).is_square() && image(&[7]).is_square());
        assert!(!image(&[0, 1]).is_square() && image(&[0, 0, 1]).is_square());
    }

    #[test]
    fn images_at_points_are_images_of_values() {
        let number = |value: i64| crate::number::Rational::new(value.into(), 6.into());
        let rows = [[3, 1, 4], [1, 5, 9], [2, 6, 5]].map(|row| {
            let row: Vec<_> = row.iter().copied().map(number).collect();
            UniPoly::from_coefficients(&row)
        });
        let polynomial = BiPoly::from_rows(&rows);
        // up to the denominator that the image of a univariate polynomial leaves out
        let proportional = |left: &Image, right: &Image| {
            let pairs = left.0.iter().zip(&right.0);
            let [first, second] = [left, right].map(|own| own.0[0]);
            left.0.len() == right.0.len()
                && pairs.into_iter().all(|(l, r)| *l * second == *r * first)
        };
        let at = crate::number::Rational::from(7);
        let in_v = Image::at_u(&polynomial, Residue::new(7)).zip(Image::of(&polynomial.at_u(&at)));
        let in_u = Image::at_v(&polynomial, Residue::new(7)).zip(Image::of(&polynomial.at_v(&at)));
        assert!(in_v.is_some_and(|(own, value)| proportional(&own, &value)));
        assert!(in_u.is_some_and(|(own, value)| proportional(&own, &value)));
    }
}
