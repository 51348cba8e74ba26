use super::UniPoly;
use crate::number::{Field, Integer, Ring, lcm};

impl<F: Field> UniPoly<F> {
    /// p(from + (to − from) x): the polynomial on an interval, as one on [0, 1].
    ///
    /// Without fractions: with from = a/d and to − from = w/d the numerators are those of
    /// Σ nₖ (a + w x)ᵏ dⁿ⁻ᵏ over dⁿ.
    #[must_use]
    pub fn restrict(&self, from: &F, to: &F) -> Self {
        if from.is_zero() && *to == F::one() {
            return self.clone();
        }
        let Some(degree) = self.degree() else {
            return Self::zero();
        };
        let [start, width] = [from.clone(), to.minus(from)].map(Field::into_parts);
        let common = lcm(&start.1, &width.1);
        let start = start.0.scaled(&(&common / &start.1));
        let width = width.0.scaled(&(&common / &width.1));
        let mut power = Integer::from(1);
        let mut expanded: Vec<F::Ring> = Vec::with_capacity(degree + 1);
        for own in self.numerators().iter().rev() {
            // expanded ← expanded · (a + w x) + own · power
            expanded.push(F::Ring::zero());
            for index in (0..expanded.len()).rev() {
                let mut value = expanded[index].times(&start);
                if index > 0 {
                    value.add_product(&expanded[index - 1], &width);
                }
                expanded[index] = value;
            }
            expanded[0] = expanded[0].plus(&own.scaled(&power));
            power *= &common;
        }
        Self::from_numerators(expanded, self.denominator() * (power / common))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    #[test]
    fn restriction_is_composition_with_the_line() {
        let number = |value: &str| value.parse::<Rational>().unwrap_or_else(|()| 0.into());
        let coefficients = ["1/3", "0", "-7/2", "5", "1/9"].map(number);
        let polynomial = UniPoly::from_coefficients(&coefficients);
        for (from, to) in [("0", "1"), ("-2/3", "7/5"), ("1", "1"), ("3", "-1/2")] {
            let (from, to) = (number(from), number(to));
            let line = UniPoly::from_coefficients(&[from.clone(), &to - &from]);
            assert_eq!(polynomial.restrict(&from, &to), polynomial.compose(&line));
        }
    }
}
