use std::cmp::Ordering;

use super::bernstein::{integral_scales, scaled_bernstein};
use super::{BiPoly, UniPoly};
use crate::number::{Field, Integer, Ring, lcm};

/// The tensor Bernstein coefficients of a polynomial on a box, times a positive integer that
/// makes them lie in the ring; u index outer.
pub(super) struct Tensor<R> {
    rows: Vec<Vec<R>>,
}

/// Which signs occur among the coefficients.
pub(super) struct Signs {
    /// Some are below 0.
    pub(super) negative: bool,
    /// Some are 0.
    pub(super) zero: bool,
    /// Some are above 0.
    pub(super) positive: bool,
}

impl Signs {
    /// Whether coefficients on both sides of 0 occur.
    pub(super) fn are_mixed(&self) -> bool {
        self.negative && self.positive
    }
}

impl<R: Ring> Tensor<R> {
    /// The coefficients on the box u.0 ≤ u ≤ u.1, v.0 ≤ v ≤ v.1.
    pub(super) fn of<F: Field<Ring = R>>(polynomial: &BiPoly<F>, u: (&F, &F), v: (&F, &F)) -> Self {
        let local: Vec<(UniPoly<F>, UniPoly<F>)> = polynomial
            .terms()
            .iter()
            .map(|(in_u, in_v)| (in_u.restrict(u.0, u.1), in_v.restrict(v.0, v.1)))
            .collect();
        let top = |degree: Option<usize>| degree.unwrap_or(0);
        let (mut high_u, mut high_v, mut common) = (0, 0, Integer::from(1));
        for (in_u, in_v) in &local {
            high_u = high_u.max(top(in_u.degree()));
            high_v = high_v.max(top(in_v.degree()));
            common = lcm(&common, &(in_u.denominator() * in_v.denominator()));
        }
        let (scale_u, scale_v) = (integral_scales(high_u), integral_scales(high_v));
        let mut rows = vec![vec![R::zero(); high_v + 1]; high_u + 1];
        for (in_u, in_v) in &local {
            let scale = &common / (in_u.denominator() * in_v.denominator());
            let first = scaled_bernstein(in_u.numerators(), high_u);
            let second: Vec<R> = scaled_bernstein(in_v.numerators(), high_v)
                .iter()
                .zip(&scale_v)
                .map(|(own, binomial)| own.scaled(&(binomial * &scale)))
                .collect();
            for ((row, weight), binomial) in rows.iter_mut().zip(&first).zip(&scale_u) {
                let weight = weight.scaled(binomial);
                for (own, factor) in row.iter_mut().zip(&second) {
                    own.add_product(&weight, factor);
                }
            }
        }
        Self { rows }
    }

    /// Which signs occur.
    pub(super) fn signs(&self) -> Signs {
        let mut signs = Signs {
            negative: false,
            zero: false,
            positive: false,
        };
        for own in self.rows.iter().flatten() {
            match own.sign() {
                Ordering::Less => signs.negative = true,
                Ordering::Equal => signs.zero = true,
                Ordering::Greater => signs.positive = true,
            }
            if signs.are_mixed() {
                break;
            }
        }
        signs
    }

    /// The signs at the corners (u.0, v.0), (u.0, v.1), (u.1, v.0), (u.1, v.1).
    pub(super) fn corners(&self) -> [Ordering; 4] {
        let ends = |row: Option<&Vec<R>>| {
            let sign = |own: Option<&R>| own.map_or(Ordering::Equal, Ring::sign);
            row.map_or([Ordering::Equal; 2], |row| {
                [sign(row.first()), sign(row.last())]
            })
        };
        let ([first, second], [third, fourth]) = (ends(self.rows.first()), ends(self.rows.last()));
        [first, second, third, fourth]
    }

    /// Both halves in v.
    pub(super) fn halves_v(self) -> (Self, Self) {
        let (left, right) = self.rows.into_iter().map(R::halves).unzip();
        (Self { rows: left }, Self { rows: right })
    }

    /// Both halves in u.
    pub(super) fn halves_u(self) -> (Self, Self) {
        let (left, right) = self.transpose().halves_v();
        (left.transpose(), right.transpose())
    }

    fn transpose(self) -> Self {
        let width = self.rows.first().map_or(0, Vec::len);
        let empty = || Vec::with_capacity(self.rows.len());
        let mut columns: Vec<Vec<R>> = (0..width).map(|_| empty()).collect();
        for row in self.rows {
            for (column, own) in columns.iter_mut().zip(row) {
                column.push(own);
            }
        }
        Self { rows: columns }
    }
}
