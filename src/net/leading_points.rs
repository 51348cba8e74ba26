use std::rc::Rc;

use crate::number::{Integer, Leading, LeadingWord, MachineList, MachineNumbers, Ring};
use crate::poly::binomials;

use super::products::{Products, Term};

/// The points and weights of a net by their leading digits, from those of the factors of their
/// terms: no point is multiplied out.
#[derive(Debug)]
pub struct LeadingPoints<'a> {
    /// W, X, Y, Z
    sums: Vec<Sum<'a>>,
    /// 1/W₀₀
    first: Leading,
    /// C(n, i) and C(m, j)
    binomials: [Vec<Integer>; 2],
    /// 1/(C(n, i) W₀₀)
    rows: Vec<LeadingWord>,
    /// 1/C(m, j)
    columns: Vec<LeadingWord>,
}

impl<'a> LeadingPoints<'a> {
    /// From the leading digits of all factors; none where few are known of one.
    pub(super) fn of(products: &'a Products) -> Option<Self> {
        let mut sums = Vec::with_capacity(products.terms().len());
        for own in products.terms() {
            sums.push(Sum::machine(own).map_or_else(|| Sum::digits(own), Some)?);
        }
        let first = products.coordinate(0, (0, 0)).leading()?.inverse()?;
        let word = LeadingWord::of_leading(first);
        let degree = products.degree();
        let binomials = [degree.u, degree.v].map(binomials);
        let inverse = |own: &Integer| LeadingWord::of_integer(own).inverse();
        let [rows, columns] = binomials.each_ref().map(|own| own.iter().map(inverse));
        Some(Self {
            sums,
            first,
            rows: all(rows.map(|own| own?.times(word)))?,
            columns: all(columns)?,
            binomials,
        })
    }

    /// The weight of control point (i, j), and 1/W with which its coordinates are to be multiplied;
    /// none if the weight may be 0.
    #[must_use]
    pub fn weight_word(&self, i: usize, j: usize) -> Option<(LeadingWord, LeadingWord)> {
        let weight = self.sums[0].word(i, j)?;
        let scale = self.rows[i].times(self.columns[j])?;
        Some((weight.times(scale)?, weight.inverse()?))
    }

    /// A coordinate of control point (i, j) with 1/W.
    #[must_use]
    #[inline]
    pub fn coordinate_word(
        &self,
        axis: usize,
        (i, j): (usize, usize),
        inverse: LeadingWord,
    ) -> Option<LeadingWord> {
        self.sums[axis + 1].word(i, j)?.times(inverse)
    }

    /// The weight of control point (i, j), by more digits.
    #[must_use]
    pub fn weight(&self, i: usize, j: usize) -> Option<Leading> {
        let [rows, columns] = &self.binomials;
        let binomial = Leading::of_integer(&(&rows[i] * &columns[j]));
        let scale = binomial.inverse()?.times(self.first)?;
        self.sums[0].leading(i, j)?.times(scale)
    }

    /// A coordinate of control point (i, j), by more digits; none if the weight may be 0.
    #[must_use]
    pub fn coordinate(&self, axis: usize, (i, j): (usize, usize)) -> Option<Leading> {
        let inverse = self.sums[0].leading(i, j)?.inverse()?;
        self.sums[axis + 1].leading(i, j)?.times(inverse)
    }
}

/// The leading digits of a list of numbers.
type Digits = Vec<Leading>;

/// Σ fₖ[i] gₖ[j], by machine numbers where all sums are such, else by leading digits.
#[derive(Debug)]
enum Sum<'a> {
    Machine(Vec<[MachineNumbers<'a>; 2]>),
    Digits(Vec<(Digits, Rc<[Leading]>)>),
}

impl<'a> Sum<'a> {
    /// None where some sum may be longer than a machine number.
    fn machine(terms: &'a [Term]) -> Option<Self> {
        let mut lists = Vec::with_capacity(terms.len());
        for Term { in_u, in_v } in terms {
            let pair = [in_u.machine()?, in_v.machine()?];
            let bits: u32 = pair.iter().map(|own| own.numbers().bits()).sum();
            if bits + terms.len().ilog2() >= i128::BITS - 2 {
                return None;
            }
            lists.push(pair.map(MachineList::numbers));
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

    #[inline]
    fn word(&self, i: usize, j: usize) -> Option<LeadingWord> {
        match self {
            Self::Machine(terms) => Some(LeadingWord::of_machine(exact(terms, i, j))),
            Self::Digits(terms) => {
                let mut sum = LeadingWord::of_machine(0);
                for (in_u, in_v) in terms {
                    let [left, right] = [in_u[i], in_v[j]].map(LeadingWord::of_leading);
                    sum = sum.plus(left.times(right)?)?;
                }
                Some(sum)
            }
        }
    }

    fn leading(&self, i: usize, j: usize) -> Option<Leading> {
        match self {
            Self::Machine(terms) => Some(Leading::of_integer(&Integer::from(exact(terms, i, j)))),
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

/// Σ fₖ[i] gₖ[j]
#[inline]
fn exact(terms: &[[MachineNumbers<'_>; 2]], i: usize, j: usize) -> i128 {
    let products = terms.iter().map(|[in_u, in_v]| in_u.at(i) * in_v.at(j));
    products.sum()
}

/// All of a list, if all are known.
fn all<T>(known: impl ExactSizeIterator<Item = Option<T>>) -> Option<Vec<T>> {
    let mut list = Vec::with_capacity(known.len());
    for own in known {
        list.push(own?);
    }
    Some(list)
}
