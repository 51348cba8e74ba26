use std::borrow::Cow;
use std::cell::OnceCell;
use std::rc::Rc;

use crate::number::{Field, Integer, MachineList, Real, Ring, lcm};
use crate::poly::{BiDegree, BiPoly, Numerators, UniPoly, binomial, binomials};

use super::scaled_form::ScaledForm;

/// Where a degree is raised by so much or more, that is multiplied out when it is asked for.
const LONG: usize = 16;

/// The numerators of exact numbers.
pub(super) type Numerator = <Real as Field>::Ring;

/// A homogeneous control point as integers: c (W, X, Y, Z), with a positive factor c of its own.
#[derive(Clone, Debug)]
pub(super) struct Control {
    /// c (W, X, Y, Z)
    pub(super) coordinates: [Numerator; 4],
    /// c, up to a factor that all points of a net share.
    pub(super) factor: Integer,
}

/// The control points of one Bézier patch before they are multiplied out: each coordinate of
/// point (i, j) is Σ fₖ[i] gₖ[j] / (C(n, i) C(m, j)), up to a factor that all share.
///
/// A surface of bidegree (n, m) has n + m + 2 such numbers in a term, and (n + 1)(m + 1) points.
#[derive(Clone, Debug)]
pub(super) struct Products {
    degree: BiDegree,
    /// The terms of W, X, Y, Z.
    terms: [Vec<Term>; 4],
    /// The sums of W, X, Y, Z at all points, once asked for, if they are machine numbers.
    sums: [OnceCell<Option<MachineList>>; 4],
}

/// fₖ and gₖ; terms share what was converted once.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) in_u: Numerators<Numerator>,
    pub(super) in_v: Rc<ScaledForm>,
}

impl Products {
    /// Of four polynomials at a bidegree that is at least theirs, over the domain u × v.
    ///
    /// - **cost** one conversion to the Bernstein basis for every factor that is different
    pub(super) fn of(
        coordinates: [&BiPoly<Real>; 4],
        degree: BiDegree,
        u: (&Real, &Real),
        v: (&Real, &Real),
    ) -> Self {
        let fits = |(in_u, in_v): &(UniPoly<Real>, UniPoly<Real>)| {
            in_u.degree() <= Some(degree.u) && in_v.degree() <= Some(degree.v)
        };
        // Where terms cancel above the bidegree, the dense form has no such terms.
        let fitting = coordinates.map(|own| {
            if own.terms().iter().all(fits) {
                Cow::Borrowed(own)
            } else {
                Cow::Owned(BiPoly::from_rows(&own.rows()))
            }
        });
        let (mut along_u, mut along_v) = (Conversions::new(u), Conversions::new(v));
        let converted = fitting.each_ref().map(|own| {
            let terms = own.terms().iter();
            let terms = terms.map(|(in_u, in_v)| {
                let along_u = along_u.of(in_u, degree.u);
                (along_u, along_v.of(in_v, degree.v))
            });
            terms.collect::<Vec<_>>()
        });
        let below = |(in_u, in_v): &(Converted, Converted)| &in_u.denominator * &in_v.denominator;
        let denominators = converted.iter().flatten().map(below);
        let denominator = denominators.fold(Integer::one(), |all, own| lcm(&all, &own));
        let terms = converted.map(|own| {
            let scaled = own.into_iter().map(|term| {
                let scale = &denominator / below(&term);
                let scale = Numerator::from_integer(&scale);
                Term {
                    in_u: term
                        .0
                        .form
                        .coefficients()
                        .times_ratio(&scale, Integer::unit()),
                    in_v: term.1.form,
                }
            });
            scaled.collect()
        });
        Self {
            degree,
            terms,
            sums: Default::default(),
        }
    }

    /// The coordinates of an axis, W first, at all points, i by i and j within i, if they are machine
    /// numbers; each times the factor of its point.
    pub(super) fn sums(&self, axis: usize) -> Option<&MachineList> {
        let find = || {
            let terms = self.terms[axis].iter();
            let lists = terms.map(|own| {
                let (in_u, in_v) = (own.in_u.machine()?, own.in_v.machine()?);
                Some([in_u.numbers(), in_v.numbers()])
            });
            let size = (self.degree.u + 1, self.degree.v + 1);
            MachineList::outer_products(&lists.collect::<Option<Vec<_>>>()?, size)
        };
        self.sums[axis].get_or_init(find).as_ref()
    }

    /// The coordinate of an axis, W first, at (i, j), times the factor of the point.
    pub(super) fn coordinate(&self, axis: usize, (i, j): (usize, usize)) -> Numerator {
        if let Some(Some(own)) = self.sums[axis].get() {
            let own = own.numbers().at(i * (self.degree.v + 1) + j);
            return Numerator::from_integer(&Integer::from(own));
        }
        let terms = &self.terms[axis];
        let machine = terms.iter().try_fold(0_i128, |sum, term| {
            let [left, right] = [term.in_u.machine()?, term.in_v.machine()?];
            sum.checked_add(left.numbers().at(i).checked_mul(right.numbers().at(j))?)
        });
        if let Some(own) = machine {
            return Numerator::from_integer(&Integer::from(own));
        }
        let mut sum = Numerator::zero();
        for term in terms {
            sum.add_product(&term.in_u.at(i), &term.in_v.at(j));
        }
        sum
    }

    /// The factor of control point (i, j).
    pub(super) fn factor(&self, (i, j): (usize, usize)) -> Integer {
        binomial(self.degree.u, i) * binomial(self.degree.v, j)
    }

    /// All control points, i by i and j within i.
    pub(super) fn controls(&self) -> Vec<Control> {
        for term in self.terms.iter().flatten() {
            term.in_v.coefficients();
        }
        let (in_u, in_v) = (binomials(self.degree.u), binomials(self.degree.v));
        let control = |i: usize, j: usize| Control {
            coordinates: [0, 1, 2, 3].map(|axis| self.coordinate(axis, (i, j))),
            factor: &in_u[i] * &in_v[j],
        };
        let places = (0..in_u.len()).flat_map(|i| (0..in_v.len()).map(move |j| (i, j)));
        places.map(|(i, j)| control(i, j)).collect()
    }

    /// The bidegree.
    pub(super) fn degree(&self) -> BiDegree {
        self.degree
    }

    /// The terms of W, X, Y, Z.
    pub(super) fn terms(&self) -> &[Vec<Term>; 4] {
        &self.terms
    }
}

/// The scaled Bernstein coefficients of a polynomial, over a denominator.
#[derive(Clone)]
struct Converted {
    form: Rc<ScaledForm>,
    denominator: Integer,
}

impl Converted {
    fn times(&self, other: &Self) -> Self {
        let factors = (Rc::clone(&self.form), Rc::clone(&other.form));
        Self {
            form: Rc::new(ScaledForm::product(factors.0, factors.1)),
            denominator: &self.denominator * &other.denominator,
        }
    }
}

/// Polynomials in one parameter that are converted already, each at a degree.
struct Conversions<'a> {
    domain: (&'a Real, &'a Real),
    known: Vec<(UniPoly<Real>, usize, Converted)>,
}

impl<'a> Conversions<'a> {
    fn new(domain: (&'a Real, &'a Real)) -> Self {
        Self {
            domain,
            known: Vec::new(),
        }
    }

    /// At a degree that is at least that of the polynomial.
    fn of(&mut self, polynomial: &UniPoly<Real>, degree: usize) -> Converted {
        let same = |known: &&(UniPoly<Real>, usize, Converted)| {
            known.1 == degree && known.0 == *polynomial
        };
        if let Some((_, _, known)) = self.known.iter().find(same) {
            return known.clone();
        }
        let own = polynomial.degree().unwrap_or_default();
        let converted = match polynomial.factors() {
            // p(t) = p(t) ((1 − t) + t)ᵏ
            _ if own.min(degree - own) >= LONG => {
                let one = self.of(&UniPoly::one(), degree - own);
                self.of(polynomial, own).times(&one)
            }
            Some((left, right, divisor)) => {
                let along = right.degree().unwrap_or_default();
                let mut left = self.of(&left, degree - along);
                left.denominator *= &divisor;
                left.times(&self.of(&right, along))
            }
            None => {
                let local = polynomial.restrict(self.domain.0, self.domain.1);
                Converted {
                    form: Rc::new(ScaledForm::list(local.scaled_bernstein(degree))),
                    denominator: local.denominator().clone(),
                }
            }
        };
        self.known
            .push((polynomial.clone(), degree, converted.clone()));
        converted
    }
}
