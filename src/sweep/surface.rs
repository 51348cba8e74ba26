use std::cell::OnceCell;
use std::cmp::Ordering;
use std::rc::Rc;

use crate::curve::Interval;
use crate::diag::{Diagnostic, Limits, Span};
use crate::number::{Field, Integer, Place, Real, Ring, Tower, gcd, lcm};
use crate::poly::{
    BiDegree, BiPoly, Coprimality, Denominator, Fraction, UniPoly, common_factor_u,
    common_factor_v, exact_div_bi, gcd_bi,
};

use super::{DegreeBound, Expander, Form, NormalVector, Scalar, Vector, degree_bound};

/// The rectangle of parameters on which a surface is used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Domain {
    /// The range of u.
    pub u: Interval,
    /// The range of v.
    pub v: Interval,
}

impl Domain {
    /// [0, 1] × [0, 1]
    #[must_use]
    pub fn unit() -> Self {
        Self {
            u: Interval::unit(),
            v: Interval::unit(),
        }
    }

    /// The rectangle between bounds of u and of v; none if it is empty.
    #[must_use]
    pub fn new(u: (Real, Real), v: (Real, Real)) -> Option<Self> {
        Some(Self {
            u: Interval::new(u.0, u.1)?,
            v: Interval::new(v.0, v.1)?,
        })
    }

    /// Its parts, so many along u and so many along v, all equal, in order of u, then v.
    #[must_use]
    pub fn divided(&self, (along_u, along_v): (usize, usize)) -> Vec<Self> {
        let (rows, columns) = (self.u.divided(along_u), self.v.divided(along_v));
        let part = |u: &Interval, v: &Interval| Self {
            u: u.clone(),
            v: v.clone(),
        };
        let rows = rows.iter();
        rows.flat_map(|u| columns.iter().map(move |v| part(u, v)))
            .collect()
    }
}

/// A surface as it is written: three coordinate expressions on a domain.
#[derive(Debug, Clone)]
pub struct SweptSurface {
    /// Its name.
    pub name: String,
    /// Where its name is declared.
    pub span: Span,
    /// Its domain.
    pub domain: Domain,
    /// x, y, z
    pub coordinates: Vector,
    /// The field of its numbers.
    pub tower: Tower,
}

impl SweptSurface {
    /// The coordinates for use elsewhere: what takes its sign from the domain keeps that of this
    /// surface.
    #[must_use]
    pub fn function(&self) -> Vector {
        let domain = Rc::new(self.domain.clone());
        self.coordinates.each_ref().map(|own| {
            if own.is_rooted() {
                let form = Form::OnDomain(own.clone(), Rc::clone(&domain));
                Scalar::new(own.span(), form)
            } else {
                own.clone()
            }
        })
    }
}

/// The homogeneous coordinates W, X, Y, Z of a surface; the points are (X, Y, Z)/W.
///
/// Equal are those whose normal forms are.
#[derive(Debug, Clone)]
pub struct HomogeneousSurface {
    proportional: [BiPoly<Real>; 4],
    /// By which they are divided in the normal form, up to a positive rational factor.
    unit: Real,
    /// To be found means to multiply out, which nothing but a report needs.
    normal_form: OnceCell<[BiPoly<Real>; 4]>,
    /// The vector R_u × R_v in factors, once it is asked for.
    normal_vector: OnceCell<Option<NormalVector>>,
}

impl PartialEq for HomogeneousSurface {
    fn eq(&self, other: &Self) -> bool {
        self.coordinates() == other.coordinates()
    }
}

impl Eq for HomogeneousSurface {}

impl HomogeneousSurface {
    /// The surface of given W, X, Y, Z.
    #[must_use]
    pub fn new(proportional: [BiPoly<Real>; 4]) -> Self {
        Self {
            proportional,
            unit: Real::one(),
            normal_form: OnceCell::new(),
            normal_vector: OnceCell::new(),
        }
    }

    /// The surface of given W, X, Y, Z on a domain.
    fn scaled(coordinates: [BiPoly<Real>; 4], domain: &Domain) -> Self {
        match rational_sign(&coordinates[0], domain) {
            Ordering::Less => return Self::new(coordinates.map(|own| -&own)),
            Ordering::Greater => return Self::new(coordinates),
            Ordering::Equal => {}
        }
        let start = start(&coordinates[0], domain);
        if !start.is_rational() && is_rational_up_to_a_factor(&coordinates[0]) {
            // A rational weight makes all that follows cheaper.
            let inverse = start.inverse().unwrap_or_else(Real::one);
            return Self::new(coordinates.map(|own| own.scale(&inverse)));
        }
        Self {
            unit: if start.is_rational() {
                Real::one()
            } else {
                start.absolute()
            },
            proportional: if start.sign().is_lt() {
                coordinates.map(|own| -&own)
            } else {
                coordinates
            },
            normal_form: OnceCell::new(),
            normal_vector: OnceCell::new(),
        }
    }

    /// W, X, Y, Z, multiplied by a number so that W at the start corner of the domain is positive
    /// and rational (if W vanishes there: W's first coefficient), and the rational components of
    /// all coefficients are coprime integers.
    #[must_use]
    pub fn coordinates(&self) -> &[BiPoly<Real>; 4] {
        self.normal_form.get_or_init(|| {
            let inverse = self.unit.inverse().unwrap_or_else(Real::one);
            let unit = self.proportional.each_ref().map(|own| own.scale(&inverse));
            coprime_integers(&unit)
        })
    }

    /// W, X, Y, Z up to a positive factor, without multiplying them out.
    #[must_use]
    pub fn proportional(&self) -> &[BiPoly<Real>; 4] {
        &self.proportional
    }

    /// W up to a positive factor, which is that of [`Self::point`].
    #[must_use]
    pub fn weight(&self) -> &BiPoly<Real> {
        &self.proportional[0]
    }

    /// (X, Y, Z) up to a positive factor
    #[must_use]
    pub fn point(&self) -> [BiPoly<Real>; 3] {
        let [_, x, y, z] = &self.proportional;
        [x.clone(), y.clone(), z.clone()]
    }

    /// R_u × R_v in factors; none if it is zero identically. It is found once.
    #[must_use]
    pub fn normal_vector(&self) -> Option<&NormalVector> {
        let find = || NormalVector::of(self);
        self.normal_vector.get_or_init(find).as_ref()
    }

    /// The bidegrees of W, X, Y, Z; none for a zero coordinate.
    #[must_use]
    pub fn bidegrees(&self) -> [Option<BiDegree>; 4] {
        self.proportional.each_ref().map(BiPoly::bidegree)
    }

    /// The bidegree of the patch: the componentwise maximum.
    #[must_use]
    pub fn bidegree(&self) -> BiDegree {
        self.bidegrees()
            .into_iter()
            .flatten()
            .fold(BiDegree::default(), BiDegree::max)
    }

    /// The point at parameters where W is not 0.
    #[must_use]
    pub fn evaluate(&self, u: &Real, v: &Real) -> Option<[Real; 3]> {
        let inverse = self.weight().evaluate(u, v).inverse()?;
        Some(self.point().map(|own| own.evaluate(u, v).times(&inverse)))
    }

    /// Brings three fractions over their common denominator and removes the common factor.
    #[must_use]
    pub(super) fn of(fractions: &[Fraction<Real>; 3], domain: &Domain) -> Reduction {
        Self::of_in_steps(fractions, domain, &mut |_| {})
    }

    /// As [`Self::of`], and tells of every step that is done.
    fn of_in_steps(
        fractions: &[Fraction<Real>; 3],
        domain: &Domain,
        done: &mut dyn FnMut(Step),
    ) -> Reduction {
        let common = fractions.iter().fold(Denominator::one(), |common, own| {
            common.lcm(own.denominator())
        });
        let [x, y, z] = fractions.each_ref().map(|own| own.numerator_over(&common));
        let constructed = [common.polynomial(), x, y, z];
        let bidegrees = constructed.each_ref().map(BiPoly::bidegree);
        done(Step::Expanded);
        let factor = CommonFactor::of(&common, &constructed);
        done(Step::FactorFound);
        let (reduced, coprimality) = if factor.is_one() {
            (constructed, factor.proof)
        } else {
            let reduced = constructed.each_ref().map(|own| factor.divide(own));
            done(Step::Divided);
            let coprimality = factor.certify(&common, &reduced);
            done(Step::Certified);
            (reduced, coprimality)
        };
        let reduction = Reduction {
            constructed: bidegrees,
            common_factor: factor.polynomial(domain),
            coprimality,
            surface: Self::scaled(reduced, domain),
        };
        done(Step::Scaled);
        reduction
    }
}

/// A surface before and after its common factor is removed.
pub(super) struct Reduction {
    pub(super) constructed: [Option<BiDegree>; 4],
    pub(super) common_factor: BiPoly<Real>,
    pub(super) coprimality: Option<Coprimality>,
    pub(super) surface: HomogeneousSurface,
}

/// A step of an expansion that is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// The formula is expanded over a common denominator.
    Expanded,
    /// The common factor of W, X, Y, Z is found; that it is 1 is proved.
    FactorFound,
    /// A common factor other than 1 is divided out.
    Divided,
    /// Of the quotients it is proved that nothing is left in common.
    Certified,
    /// W is positive and rational at the start corner.
    Scaled,
}

/// What the formula of a surface expands to, with the story of its degrees.
#[derive(Debug, Clone)]
pub struct Expansion {
    /// The formula.
    coordinates: Vector,
    /// The exact bidegrees of the formula over its common denominator.
    pub constructed: [Option<BiDegree>; 4],
    /// The greatest common divisor of the four as constructed, normalised like W.
    pub common_factor: BiPoly<Real>,
    /// How it was proved that what is left has no common factor.
    pub coprimality: Option<Coprimality>,
    /// The reduced coordinates.
    pub surface: HomogeneousSurface,
}

impl Expansion {
    /// Expands a surface.
    ///
    /// # Errors
    ///
    /// The findings of [`Expander::expand`].
    pub fn of(surface: &SweptSurface, limits: &Limits) -> Result<Self, Box<Diagnostic>> {
        Self::of_in_steps(surface, limits, &mut |_| {})
    }

    /// As [`Self::of`], and tells of every step that is done.
    ///
    /// # Errors
    ///
    /// Those of [`Self::of`].
    pub fn of_in_steps(
        surface: &SweptSurface,
        limits: &Limits,
        done: &mut dyn FnMut(Step),
    ) -> Result<Self, Box<Diagnostic>> {
        let mut expander = Expander::new(&surface.domain, &surface.tower, limits);
        let fractions = expander.expand_vector(&surface.coordinates)?;
        let reduction = HomogeneousSurface::of_in_steps(&fractions, &surface.domain, done);
        Ok(Self {
            coordinates: surface.coordinates.clone(),
            constructed: reduction.constructed,
            common_factor: reduction.common_factor,
            coprimality: reduction.coprimality,
            surface: reduction.surface,
        })
    }

    /// The bidegrees of W, X, Y, Z by counting.
    #[must_use]
    pub fn bound(&self) -> DegreeBound {
        degree_bound(&self.coordinates)
    }
}

/// The greatest common divisor a(u) b(v) m(u, v) of W, X, Y, Z.
///
/// Every irreducible factor of W lies in D(u), in E(v) or in M(u, v); a factor in one variable
/// divides a polynomial if and only if it divides its content.
struct CommonFactor {
    in_u: UniPoly<Real>,
    in_v: UniPoly<Real>,
    /// None for 1.
    mixed: Option<BiPoly<Real>>,
    /// How it was proved to be 1, if it is.
    proof: Option<Coprimality>,
}

impl CommonFactor {
    fn of(weight: &Denominator<Real>, coordinates: &[BiPoly<Real>; 4]) -> Self {
        let point = coordinates[1..].iter().filter(|own| !own.is_zero());
        let point: Vec<&BiPoly<Real>> = point.collect();
        // A constant needs no proof.
        let along = |own: &UniPoly<Real>, divisor: Shared| {
            if own.is_constant() {
                (UniPoly::one(), Some(None))
            } else {
                let (divisor, proof) = divisor(own, &point);
                (divisor, proof.map(Some))
            }
        };
        let (in_u, first) = along(weight.in_u(), common_factor_u);
        let (in_v, second) = along(weight.in_v(), common_factor_v);
        let mixed = weight.mixed().map(|own| {
            point.iter().fold(own.clone(), |common, own| {
                if common.as_constant().is_some() {
                    common
                } else {
                    gcd_bi(&common, own)
                }
            })
        });
        let mixed = mixed.filter(|own| own.as_constant().is_none());
        let proof = match (first, second) {
            (Some(first), Some(second)) if mixed.is_none() => {
                Some(joined([first, second], weight.is_separable()))
            }
            _ => None,
        };
        Self {
            in_u,
            in_v,
            mixed,
            proof,
        }
    }

    fn is_one(&self) -> bool {
        self.in_u.is_constant() && self.in_v.is_constant() && self.mixed.is_none()
    }

    /// Multiplied out, in the normal form that W has alone.
    fn polynomial(&self, domain: &Domain) -> BiPoly<Real> {
        if self.is_one() {
            return BiPoly::one();
        }
        let separable = BiPoly::product(&self.in_u, &self.in_v);
        let whole = match &self.mixed {
            None => separable,
            Some(mixed) => &separable * mixed,
        };
        let zero = BiPoly::zero;
        let alone = [whole, zero(), zero(), zero()];
        HomogeneousSurface::scaled(alone, domain).coordinates()[0].clone()
    }

    fn divide(&self, polynomial: &BiPoly<Real>) -> BiPoly<Real> {
        let mut quotient = polynomial.clone();
        quotient = quotient.exact_div_u(&self.in_u).unwrap_or(quotient);
        quotient = quotient.exact_div_v(&self.in_v).unwrap_or(quotient);
        match &self.mixed {
            None => quotient,
            Some(mixed) => exact_div_bi(&quotient, mixed).unwrap_or(quotient),
        }
    }

    /// Proves once more, from the quotients, that nothing is left in common.
    fn certify(
        &self,
        weight: &Denominator<Real>,
        reduced: &[BiPoly<Real>; 4],
    ) -> Option<Coprimality> {
        let in_u = weight.in_u().exact_div(&self.in_u)?;
        let in_v = weight.in_v().exact_div(&self.in_v)?;
        let weight = match (weight.mixed(), &self.mixed) {
            (None, _) => Denominator::separable(&in_u, &in_v),
            _ => Denominator::split(&reduced[0])?.1,
        };
        Self::of(&weight, reduced).proof
    }
}

/// A way to find the common divisors in one parameter.
type Shared = fn(&UniPoly<Real>, &[&BiPoly<Real>]) -> (UniPoly<Real>, Option<Coprimality>);

/// The weaker of two proofs; that for a constant is none.
fn joined(proofs: [Option<Coprimality>; 2], separable: bool) -> Coprimality {
    if proofs.contains(&Some(Coprimality::Euclid)) || !separable {
        return Coprimality::Euclid;
    }
    let rational = Coprimality::Modular(*Place::rational().modulus());
    proofs.into_iter().flatten().next().unwrap_or(rational)
}

/// The sign of W at the start corner of the domain, if it is seen without W itself that this is
/// rational and not 0; else none.
fn rational_sign(weight: &BiPoly<Real>, domain: &Domain) -> Ordering {
    let (u, v) = (domain.u.start(), domain.v.start());
    let [(in_u, in_v)] = weight.terms() else {
        return Ordering::Equal;
    };
    let is_rational =
        in_u.is_rational() && in_v.is_rational() && u.is_rational() && v.is_rational();
    match in_u.sign_at(u) {
        Ordering::Greater if is_rational => in_v.sign_at(v),
        Ordering::Less if is_rational => in_v.sign_at(v).reverse(),
        _ => Ordering::Equal,
    }
}

/// W at the start corner of the domain (if that is 0: its first coefficient).
fn start(weight: &BiPoly<Real>, domain: &Domain) -> Real {
    let corner = weight.evaluate(domain.u.start(), domain.v.start());
    if corner.is_zero() {
        first_coefficient(weight)
    } else {
        corner
    }
}

/// Whether a polynomial is the product of a number and a polynomial with rational coefficients.
fn is_rational_up_to_a_factor(polynomial: &BiPoly<Real>) -> bool {
    match polynomial.terms() {
        [(in_u, in_v)] => in_u.is_rational_up_to_a_factor() && in_v.is_rational_up_to_a_factor(),
        _ => {
            let rows = polynomial.rows();
            let numerators: Vec<_> = rows
                .iter()
                .flat_map(|own| own.numerators())
                .cloned()
                .collect();
            UniPoly::<Real>::from_numerators(numerators, <Integer as Ring>::one())
                .is_rational_up_to_a_factor()
        }
    }
}

/// The positive rational multiple in which the rational components of all coefficients are coprime
/// integers.
fn coprime_integers(coordinates: &[BiPoly<Real>; 4]) -> [BiPoly<Real>; 4] {
    let (mut divisor, mut multiple) = (<Integer as Ring>::zero(), <Integer as Ring>::one());
    for row in coordinates.iter().flat_map(BiPoly::rows) {
        divisor = gcd(&divisor, &row.content());
        multiple = lcm(&multiple, row.denominator());
    }
    if divisor.is_zero() {
        return coordinates.clone();
    }
    let factor = Real::from_parts(Ring::from_integer(&multiple), divisor);
    coordinates.each_ref().map(|own| own.scale(&factor))
}

/// The coefficient of the lowest power of u, and of v among those.
fn first_coefficient(polynomial: &BiPoly<Real>) -> Real {
    let rows = polynomial.rows();
    let row = rows.iter().find(|row| !row.is_zero());
    let coefficients = row.map(UniPoly::coefficients).unwrap_or_default();
    let first = coefficients.into_iter().find(|own| !own.is_zero());
    first.unwrap_or_else(Real::zero)
}
