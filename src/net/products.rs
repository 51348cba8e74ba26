use std::borrow::Cow;
use std::rc::Rc;

use crate::number::{Field, Integer, Leading, Real, Ring, lcm};
use crate::poly::{BiDegree, BiPoly, UniPoly, binomials, scaled_bernstein};

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
    /// The fₖ and gₖ of W, X, Y, Z.
    terms: [Vec<(Vec<Numerator>, Rc<[Numerator]>)>; 4],
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
        let (mut along_u, mut along_v) =
            (Conversions::new(degree.u, u), Conversions::new(degree.v, v));
        let converted = fitting.each_ref().map(|own| {
            let terms = own.terms().iter();
            let terms = terms.map(|(in_u, in_v)| (along_u.of(in_u), along_v.of(in_v)));
            terms.collect::<Vec<_>>()
        });
        let below = |(in_u, in_v): &(Converted, Converted)| &in_u.denominator * &in_v.denominator;
        let denominators = converted.iter().flatten().map(below);
        let denominator = denominators.fold(Integer::one(), |all, own| lcm(&all, &own));
        let terms = converted.map(|own| {
            let scaled = own.into_iter().map(|term| {
                let scale = &denominator / below(&term);
                let in_u = term.0.numerators.iter().map(|own| own.scaled(&scale));
                (in_u.collect(), term.1.numerators)
            });
            scaled.collect()
        });
        Self { degree, terms }
    }

    /// The coordinate of an axis, W first, at (i, j), times the factor of the point.
    pub(super) fn coordinate(&self, axis: usize, (i, j): (usize, usize)) -> Numerator {
        let mut sum = Numerator::zero();
        for (in_u, in_v) in &self.terms[axis] {
            sum.add_product(&in_u[i], &in_v[j]);
        }
        sum
    }

    /// Control point (i, j).
    pub(super) fn control(&self, (i, j): (usize, usize)) -> Control {
        let [in_u, in_v] = [(self.degree.u, i), (self.degree.v, j)].map(binomial);
        Control {
            coordinates: [0, 1, 2, 3].map(|axis| self.coordinate(axis, (i, j))),
            factor: in_u * in_v,
        }
    }

    /// All control points, i by i and j within i.
    pub(super) fn controls(&self) -> Vec<Control> {
        let (in_u, in_v) = (binomials(self.degree.u), binomials(self.degree.v));
        let control = |i: usize, j: usize| Control {
            coordinates: [0, 1, 2, 3].map(|axis| self.coordinate(axis, (i, j))),
            factor: &in_u[i] * &in_v[j],
        };
        let places = (0..in_u.len()).flat_map(|i| (0..in_v.len()).map(move |j| (i, j)));
        places.map(|(i, j)| control(i, j)).collect()
    }

    /// The leading digits of all factors.
    pub(super) fn leading(&self) -> LeadingPoints {
        let digits = |list: &[Numerator]| list.iter().map(Ring::leading).collect();
        let inverse = |own: &Integer| Leading::of_integer(own).inverse();
        let inverses = |degree| binomials(degree).iter().map(inverse).collect();
        let first = self.coordinate(0, (0, 0));
        LeadingPoints {
            terms: self.terms.each_ref().map(|own| {
                let terms = own.iter();
                let terms = terms.map(|(in_u, in_v)| (digits(in_u), digits(in_v)));
                terms.collect()
            }),
            scales: [inverses(self.degree.u), inverses(self.degree.v)],
            first: first.leading().and_then(Leading::inverse),
        }
    }
}

/// C(n, k)
fn binomial((degree, index): (usize, usize)) -> Integer {
    let steps = 0..index;
    steps.fold(Integer::one(), |all, step| {
        all * Integer::from(degree - step) / Integer::from(step + 1)
    })
}

/// The scaled Bernstein coefficients of a polynomial, over a denominator.
#[derive(Clone)]
struct Converted {
    numerators: Rc<[Numerator]>,
    denominator: Integer,
}

/// Polynomials in one parameter that are converted already.
struct Conversions<'a> {
    degree: usize,
    domain: (&'a Real, &'a Real),
    known: Vec<(UniPoly<Real>, Converted)>,
}

impl<'a> Conversions<'a> {
    fn new(degree: usize, domain: (&'a Real, &'a Real)) -> Self {
        Self {
            degree,
            domain,
            known: Vec::new(),
        }
    }

    fn of(&mut self, polynomial: &UniPoly<Real>) -> Converted {
        if let Some((_, known)) = self.known.iter().find(|(own, _)| own == polynomial) {
            return known.clone();
        }
        let local = polynomial.restrict(self.domain.0, self.domain.1);
        let converted = Converted {
            numerators: scaled_bernstein(local.numerators(), self.degree).into(),
            denominator: local.denominator().clone(),
        };
        self.known.push((polynomial.clone(), converted.clone()));
        converted
    }
}

/// The factors of leading digits; none where they are not known.
type Digits = Vec<Option<Leading>>;

/// The points and weights of a net by their leading digits, from those of the factors of their
/// terms: no point is multiplied out.
#[derive(Debug)]
pub struct LeadingPoints {
    terms: [Vec<(Digits, Digits)>; 4],
    /// 1/C(n, i) and 1/C(m, j)
    scales: [Digits; 2],
    /// 1/W₀₀
    first: Option<Leading>,
}

impl LeadingPoints {
    /// The weight and the coordinates of control point (i, j), as far as they are known; nothing
    /// of a point whose weight may be 0.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> [Option<Leading>; 4] {
        let Some(weight) = self.homogeneous(0, (i, j)) else {
            return [None; 4];
        };
        let Some(inverse) = weight.inverse() else {
            return [None; 4];
        };
        let coordinate = |axis| self.homogeneous(axis, (i, j))?.times(inverse);
        let scale = || {
            self.first?
                .times(self.scales[0][i]?)?
                .times(self.scales[1][j]?)
        };
        [
            scale().and_then(|own| weight.times(own)),
            coordinate(1),
            coordinate(2),
            coordinate(3),
        ]
    }

    fn homogeneous(&self, axis: usize, (i, j): (usize, usize)) -> Option<Leading> {
        let mut products = self.terms[axis]
            .iter()
            .map(|(in_u, in_v)| in_u[i]?.times(in_v[j]?));
        let zero = || Some(Leading::of_integer(&Integer::from(0)));
        let first = products.next().unwrap_or_else(zero)?;
        products.try_fold(first, |sum, own| sum.plus(own?))
    }
}
