use crate::number::{Field, Integer, Ring};

use super::{binomials, subdivide};

/// A polynomial on the unit square by its tensor Bernstein coefficients, i by i along u and j within
/// i along v; its bidegree is one less than their numbers, which are not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BernsteinGrid<F> {
    rows: Vec<Vec<F>>,
}

impl<F: Field> BernsteinGrid<F> {
    /// Of coefficients in rows of one length.
    #[must_use]
    pub fn new(rows: Vec<Vec<F>>) -> Self {
        Self { rows }
    }

    /// All coefficients: the least and the greatest bound the polynomial, and their mean is its own.
    pub fn coefficients(&self) -> impl Iterator<Item = &F> {
        self.rows.iter().flatten()
    }

    /// ∂p/∂u, of bidegree (n − 1, m): n (bᵢ₊₁ⱼ − bᵢⱼ); 0 for n = 0.
    #[must_use]
    pub fn derivative_u(&self) -> Self {
        let degree = self.rows.len() - 1;
        if degree == 0 {
            return Self::new(vec![vec![F::zero(); self.rows[0].len()]]);
        }
        let factor = F::from_integer(&Integer::from(degree));
        let step = |pair: &[Vec<F>]| {
            let numbers = pair[1].iter().zip(&pair[0]);
            let steps = numbers.map(|(next, own)| next.minus(own).times(&factor));
            steps.collect()
        };
        Self::new(self.rows.windows(2).map(step).collect())
    }

    /// ∂p/∂v, of bidegree (n, m − 1); 0 for m = 0.
    #[must_use]
    pub fn derivative_v(&self) -> Self {
        self.transposed().derivative_u().transposed()
    }

    fn transposed(&self) -> Self {
        let column = |j: usize| self.rows.iter().map(|row| row[j].clone()).collect();
        Self::new((0..self.rows[0].len()).map(column).collect())
    }

    /// p + q of one bidegree
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.termwise(other, F::plus)
    }

    /// p − q of one bidegree
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.termwise(other, F::minus)
    }

    fn termwise(&self, other: &Self, operation: fn(&F, &F) -> F) -> Self {
        let rows = self.rows.iter().zip(&other.rows);
        let row = |(left, right): (&Vec<F>, &Vec<F>)| {
            let numbers = left.iter().zip(right);
            let results = numbers.map(|(left, right)| operation(left, right));
            results.collect()
        };
        Self::new(rows.map(row).collect())
    }

    /// p q: the scaled coefficients C(n, i) C(m, j) bᵢⱼ of a product are the convolution of those of
    /// its factors.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let integer = |own: Integer| F::from_integer(&own);
        let (left, right) = (self.scaled(integer).rows, other.scaled(integer).rows);
        let (m, n) = (left.len() + right.len(), left[0].len() + right[0].len());
        let mut sums = vec![vec![F::zero(); n - 1]; m - 1];
        for (i, row) in left.iter().enumerate() {
            for (j, own) in row.iter().enumerate().filter(|(_, own)| !own.is_zero()) {
                for (sums, others) in sums[i..].iter_mut().zip(&right) {
                    for (sum, other) in sums[j..].iter_mut().zip(others) {
                        *sum = sum.plus(&own.times(other));
                    }
                }
            }
        }
        Self::new(sums).scaled(|own| F::from_parts(F::Ring::one(), own))
    }

    /// The coefficients times what a function makes of C(n, i) C(m, j).
    fn scaled(&self, factor: impl Fn(Integer) -> F) -> Self {
        let (in_u, in_v) = (
            binomials(self.rows.len() - 1),
            binomials(self.rows[0].len() - 1),
        );
        let row = |(row, above): (&Vec<F>, &Integer)| {
            let numbers = row.iter().zip(&in_v);
            let scaled = numbers.map(|(own, across)| own.times(&factor(above * across)));
            scaled.collect()
        };
        Self::new(self.rows.iter().zip(&in_u).map(row).collect())
    }

    /// The polynomial on the four quarters of the square, each as a unit square.
    #[must_use]
    pub fn quarters(&self) -> Vec<Self> {
        let halves = self.halves_v();
        let quarters = halves.iter().flat_map(|own| own.transposed().halves_v());
        quarters.map(|own| own.transposed()).collect()
    }

    /// Both halves along v.
    fn halves_v(&self) -> [Self; 2] {
        let half = F::from_integer(&Integer::from(2)).inverse();
        let half = half.unwrap_or_else(F::one);
        let rows = self.rows.iter();
        let (left, right) = rows.map(|row| subdivide(row, &half)).unzip();
        [left, right].map(Self::new)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use crate::poly::{BiPoly, UniPoly, de_casteljau, from_bernstein};

    fn grid(rows: &[&[i64]]) -> BernsteinGrid<Rational> {
        let row = |own: &&[i64]| own.iter().map(|own| Rational::from(*own)).collect();
        BernsteinGrid::new(rows.iter().map(row).collect())
    }

    fn value(own: &BernsteinGrid<Rational>, u: &Rational, v: &Rational) -> Rational {
        let rows = own.rows.iter();
        let column: Vec<Rational> = rows.map(|row| de_casteljau(row, v)).collect();
        de_casteljau(&column, u)
    }

    /// The same polynomial by powers.
    fn powers(own: &BernsteinGrid<Rational>) -> BiPoly<Rational> {
        let (zero, one) = (Rational::zero(), Rational::one());
        let terms = own.rows.iter().enumerate().map(|(i, row)| {
            let mut unit = vec![Rational::zero(); own.rows.len()];
            unit[i] = Rational::one();
            let in_u: UniPoly<Rational> = from_bernstein(&unit, &zero, &one);
            BiPoly::product(&in_u, &from_bernstein(row, &zero, &one))
        });
        BiPoly::sum(terms)
    }

    #[test]
    fn grids_compute_as_polynomials_do() {
        let grids = [
            grid(&[&[3]]),
            grid(&[&[1, -2, 5]]),
            grid(&[&[4], &[0], &[-7], &[2]]),
            grid(&[&[1, 2, 0], &[-3, 5, 8]]),
        ];
        for one in &grids {
            let own = powers(one);
            assert!((&powers(&one.derivative_u()) - &own.derivative_u()).is_zero());
            assert!((&powers(&one.derivative_v()) - &own.derivative_v()).is_zero());
            assert!((&powers(&one.plus(one)) - &(&own + &own)).is_zero());
            assert!(powers(&one.minus(one)).is_zero());
            for other in &grids {
                let product = &own * &powers(other);
                assert!((&powers(&one.times(other)) - &product).is_zero());
            }
        }
    }

    #[test]
    fn quarters_are_the_polynomial_on_a_part() {
        let own = grid(&[&[1, 2, 0], &[-3, 5, 8]]);
        let number = |above: i64, below: i64| Rational::new(above.into(), below.into());
        let half = number(1, 2);
        let (u, v) = (number(1, 3), number(3, 4));
        // v first, u within
        let corners = [(0, 0), (1, 0), (0, 1), (1, 1)];
        for ((i, j), quarter) in corners.into_iter().zip(own.quarters()) {
            let at = |own: &Rational, start: i64| own.plus(&Rational::from(start)).times(&half);
            assert_eq!(value(&quarter, &u, &v), value(&own, &at(&u, i), &at(&v, j)));
        }
    }
}
