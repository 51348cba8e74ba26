use std::rc::Rc;

use crate::number::{Integer, Leading, LeadingWord, MachineNumbers, Ring};
use crate::poly::binomials;

use super::products::{Products, Term};

/// The points and weights of a net by their leading digits, from those of the factors of their
/// terms: no point is multiplied out, unless machine numbers will do for all.
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
        let degree = products.degree();
        let mut sums = Vec::with_capacity(products.terms().len());
        for (axis, own) in products.terms().iter().enumerate() {
            sums.push(match products.sums(axis) {
                Some(own) => Sum::Machine(own.numbers(), degree.v + 1),
                None => Sum::digits(own)?,
            });
        }
        let first = products.coordinate(0, (0, 0)).leading()?.inverse()?;
        let word = LeadingWord::of_leading(first);
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
    #[inline]
    pub fn weight_word(&self, (i, j): (usize, usize)) -> Option<(LeadingWord, LeadingWord)> {
        let weight = self.sums[0].word((i, j))?;
        let scaled = weight.times(self.rows[i])?.times(self.columns[j])?;
        Some((scaled, weight.inverse()?))
    }

    /// A coordinate of control point (i, j) with 1/W.
    #[must_use]
    #[inline]
    pub fn coordinate_word(
        &self,
        axis: usize,
        place: (usize, usize),
        inverse: LeadingWord,
    ) -> Option<LeadingWord> {
        self.sums[axis + 1].word(place)?.times(inverse)
    }

    /// The weight of control point (i, j), by more digits.
    #[must_use]
    pub fn weight(&self, (i, j): (usize, usize)) -> Option<Leading> {
        let [rows, columns] = &self.binomials;
        let binomial = Leading::of_integer(&(&rows[i] * &columns[j]));
        let scale = binomial.inverse()?.times(self.first)?;
        self.sums[0].leading((i, j))?.times(scale)
    }

    /// A coordinate of control point (i, j), by more digits; none if the weight may be 0.
    #[must_use]
    pub fn coordinate(&self, axis: usize, place: (usize, usize)) -> Option<Leading> {
        let inverse = self.sums[0].leading(place)?.inverse()?;
        self.sums[axis + 1].leading(place)?.times(inverse)
    }
}

/// The leading digits of a list of numbers.
type Digits = Vec<Leading>;

/// Σ fₖ[i] gₖ[j], by machine numbers where all sums are such, else by leading digits.
#[derive(Debug)]
enum Sum<'a> {
    /// All sums, in rows of so many.
    Machine(MachineNumbers<'a>, usize),
    Digits(Vec<(Digits, Rc<[Leading]>)>),
}

impl Sum<'_> {
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
    fn word(&self, (i, j): (usize, usize)) -> Option<LeadingWord> {
        match self {
            Self::Machine(sums, columns) => Some(LeadingWord::of_machine(sums.at(i * columns + j))),
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

    fn leading(&self, (i, j): (usize, usize)) -> Option<Leading> {
        match self {
            Self::Machine(sums, columns) => {
                let own = Integer::from(sums.at(i * columns + j));
                Some(Leading::of_integer(&own))
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
