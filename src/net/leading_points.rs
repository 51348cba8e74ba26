use std::rc::Rc;

use crate::number::{Integer, Leading, Ring};
use crate::poly::binomials;

use super::products::{Numerator, Products, Term};

/// The points and weights of a net by their leading digits, from those of the factors of their
/// terms: no point is multiplied out.
#[derive(Debug)]
pub struct LeadingPoints {
    /// W, X, Y, Z
    sums: Vec<Sum>,
    /// 1/(C(n, i) W₀₀)
    rows: Digits,
    /// 1/C(m, j)
    columns: Digits,
}

impl LeadingPoints {
    /// From the leading digits of all factors; none where few are known of one.
    pub(super) fn of(products: &Products) -> Option<Self> {
        let inverse = |own: &Integer| Leading::of_integer(own).inverse();
        let inverses = |degree| all(binomials(degree).iter().map(inverse));
        let mut sums = Vec::with_capacity(products.terms().len());
        for own in products.terms() {
            sums.push(Sum::machine(own).map_or_else(|| Sum::digits(own), Some)?);
        }
        let first = products.coordinate(0, (0, 0)).leading()?.inverse()?;
        let rows = inverses(products.degree().u)?.into_iter();
        Some(Self {
            sums,
            rows: all(rows.map(|own| own.times(first)))?,
            columns: inverses(products.degree().v)?,
        })
    }

    /// The weight of control point (i, j), and 1/W with which its coordinates are to be multiplied;
    /// none if the weight may be 0.
    #[must_use]
    pub fn weight(&self, i: usize, j: usize) -> Option<(Leading, Leading)> {
        let weight = self.sums[0].leading(i, j)?;
        let scale = self.rows[i].times(self.columns[j])?;
        Some((weight.times(scale)?, weight.inverse()?))
    }

    /// A coordinate of control point (i, j) with 1/W.
    #[must_use]
    pub fn coordinate(
        &self,
        axis: usize,
        (i, j): (usize, usize),
        inverse: Leading,
    ) -> Option<Leading> {
        self.sums[axis + 1].leading(i, j)?.times(inverse)
    }
}

/// The leading digits of a list of numbers.
type Digits = Vec<Leading>;

/// Σ fₖ[i] gₖ[j], by machine numbers where all sums are such, else by leading digits.
#[derive(Debug)]
enum Sum {
    Machine(Vec<[Vec<i128>; 2]>),
    Digits(Vec<(Digits, Rc<[Leading]>)>),
}

impl Sum {
    /// None where some sum may be longer than a machine number.
    fn machine(terms: &[Term]) -> Option<Self> {
        let machine = |own: &Numerator| own.as_integer()?.machine();
        let size = |list: &[i128]| list.iter().fold(0, |all, own| all | own.unsigned_abs());
        let bits = |list: &[i128]| u128::BITS - size(list).leading_zeros();
        let mut lists = Vec::with_capacity(terms.len());
        for Term { in_u, in_v } in terms {
            if in_v.is_product() {
                return None;
            }
            let pair = [
                all(in_u.iter().map(machine))?,
                all(in_v.coefficients().iter().map(machine))?,
            ];
            if bits(&pair[0]) + bits(&pair[1]) + terms.len().ilog2() >= i128::BITS - 2 {
                return None;
            }
            lists.push(pair);
        }
        Some(Self::Machine(lists))
    }

    /// None where few digits are known of some number.
    fn digits(terms: &[Term]) -> Option<Self> {
        let mut lists = Vec::with_capacity(terms.len());
        for Term { in_u, in_v } in terms {
            let in_u = all(in_u.iter().map(Ring::leading))?;
            lists.push((in_u, in_v.leading()?));
        }
        Some(Self::Digits(lists))
    }

    fn leading(&self, i: usize, j: usize) -> Option<Leading> {
        match self {
            Self::Machine(terms) => {
                let products = terms.iter().map(|[in_u, in_v]| in_u[i] * in_v[j]);
                Some(Leading::of_integer(&Integer::from(products.sum::<i128>())))
            }
            Self::Digits(terms) => {
                let mut sum = Leading::zero();
                for (in_u, in_v) in terms {
                    sum = sum.plus(in_u[i].times(in_v[j])?)?;
                }
                Some(sum)
            }
        }
    }
}

/// All of a list, if all are known.
fn all<T>(known: impl ExactSizeIterator<Item = Option<T>>) -> Option<Vec<T>> {
    let mut list = Vec::with_capacity(known.len());
    for own in known {
        list.push(own?);
    }
    Some(list)
}
