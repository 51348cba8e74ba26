use std::rc::Rc;

use crate::curve::Interval;
use crate::diag::{Diagnostic, Limits, Span};
use crate::number::{Field, Integer, Place, Real, Ring, Tower, gcd, lcm};
use crate::poly::{
    BiDegree, BiPoly, Coprimality, Denominator, Fraction, UniPoly, certify_coprime, exact_div_bi,
    gcd as gcd_uni, gcd_bi,
};

use super::{DegreeBound, Expander, Form, Scalar, Vector, degree_bound};

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
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HomogeneousSurface {
    coordinates: [BiPoly<Real>; 4],
}

impl HomogeneousSurface {
    /// The surface of given W, X, Y, Z.
    #[must_use]
    pub fn new(coordinates: [BiPoly<Real>; 4]) -> Self {
        Self { coordinates }
    }

    /// W, X, Y, Z
    #[must_use]
    pub fn coordinates(&self) -> &[BiPoly<Real>; 4] {
        &self.coordinates
    }

    /// W
    #[must_use]
    pub fn weight(&self) -> &BiPoly<Real> {
        &self.coordinates[0]
    }

    /// (X, Y, Z)
    #[must_use]
    pub fn point(&self) -> [BiPoly<Real>; 3] {
        let [_, x, y, z] = &self.coordinates;
        [x.clone(), y.clone(), z.clone()]
    }

    /// The bidegrees of W, X, Y, Z; none for a zero coordinate.
    #[must_use]
    pub fn bidegrees(&self) -> [Option<BiDegree>; 4] {
        self.coordinates.each_ref().map(BiPoly::bidegree)
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
        let common = fractions.iter().fold(Denominator::one(), |common, own| {
            common.lcm(own.denominator())
        });
        let point = fractions.each_ref().map(|own| own.numerator_over(&common));
        let factor = CommonFactor::of(&common, &point);
        let [x, y, z] = point;
        let constructed = [common.polynomial(), x, y, z];
        let reduced = constructed.each_ref().map(|own| factor.divide(own));
        Reduction {
            coprimality: factor.certify(&reduced),
            common_factor: normalise_one(&factor.polynomial(), domain),
            constructed,
            surface: Self {
                coordinates: normalise(&reduced, domain),
            },
        }
    }
}

/// A surface before and after its common factor is removed.
pub(super) struct Reduction {
    pub(super) constructed: [BiPoly<Real>; 4],
    pub(super) common_factor: BiPoly<Real>,
    pub(super) coprimality: Option<Coprimality>,
    pub(super) surface: HomogeneousSurface,
}

/// What the formula of a surface expands to, with the story of its degrees.
#[derive(Debug, Clone)]
pub struct Expansion {
    /// The bidegrees of W, X, Y, Z by counting.
    pub bound: DegreeBound,
    /// The exact bidegrees of the formula over its common denominator.
    pub constructed: [Option<BiDegree>; 4],
    /// The greatest common divisor of the four as constructed, normalised like W.
    pub common_factor: BiPoly<Real>,
    /// How it was proved that what is left has no common factor.
    pub coprimality: Option<Coprimality>,
    /// The reduced coordinates in normal form.
    pub surface: HomogeneousSurface,
}

impl Expansion {
    /// Expands a surface.
    ///
    /// # Errors
    ///
    /// The findings of [`Expander::expand`].
    pub fn of(surface: &SweptSurface, limits: &Limits) -> Result<Self, Box<Diagnostic>> {
        let mut expander = Expander::new(&surface.domain, &surface.tower, limits);
        let fractions = expander.expand_vector(&surface.coordinates)?;
        let reduction = HomogeneousSurface::of(&fractions, &surface.domain);
        Ok(Self {
            bound: degree_bound(&surface.coordinates),
            constructed: reduction.constructed.each_ref().map(BiPoly::bidegree),
            common_factor: reduction.common_factor,
            coprimality: reduction.coprimality,
            surface: reduction.surface,
        })
    }
}

/// The greatest common divisor a(u) b(v) m(u, v) of W, X, Y, Z.
///
/// Every irreducible factor of W lies in D(u), in E(v) or in M(u, v); a factor in one variable
/// divides a polynomial if and only if it divides its content.
struct CommonFactor {
    in_u: UniPoly<Real>,
    in_v: UniPoly<Real>,
    mixed: BiPoly<Real>,
}

impl CommonFactor {
    fn of(weight: &Denominator<Real>, point: &[BiPoly<Real>; 3]) -> Self {
        let shared = |start: &UniPoly<Real>, content: fn(&BiPoly<Real>) -> UniPoly<Real>| {
            point
                .iter()
                .filter(|own| !own.is_zero())
                .fold(start.clone(), |common, own| {
                    if common.is_constant() {
                        common
                    } else {
                        gcd_uni(&common, &content(own))
                    }
                })
        };
        let in_u = shared(weight.in_u(), BiPoly::content_u);
        let in_v = shared(weight.in_v(), BiPoly::content_v);
        let mixed = point.iter().filter(|own| !own.is_zero()).fold(
            weight.mixed().clone(),
            |common, own| {
                if common.as_constant().is_some() {
                    common
                } else {
                    gcd_bi(&common, own)
                }
            },
        );
        Self {
            in_u,
            in_v,
            mixed: if mixed.as_constant().is_some() {
                BiPoly::one()
            } else {
                mixed
            },
        }
    }

    fn polynomial(&self) -> BiPoly<Real> {
        &BiPoly::product(&self.in_u, &self.in_v) * &self.mixed
    }

    fn divide(&self, polynomial: &BiPoly<Real>) -> BiPoly<Real> {
        let mut quotient = polynomial.clone();
        quotient = quotient.exact_div_u(&self.in_u).unwrap_or(quotient);
        quotient = quotient.exact_div_v(&self.in_v).unwrap_or(quotient);
        if self.mixed.as_constant().is_none() {
            quotient = exact_div_bi(&quotient, &self.mixed).unwrap_or(quotient);
        }
        quotient
    }

    /// Proves once more, from the quotients, that nothing is left in common.
    fn certify(&self, reduced: &[BiPoly<Real>; 4]) -> Option<Coprimality> {
        let [weight, rest @ ..] = reduced;
        let (_, weight) = Denominator::split(weight)?;
        let rest: Vec<&BiPoly<Real>> = rest.iter().filter(|own| !own.is_zero()).collect();
        // A constant needs no certificate.
        let along = |own: &UniPoly<Real>, slices: Vec<UniPoly<Real>>| {
            if own.is_constant() {
                return Some(None);
            }
            let list: Vec<_> = std::iter::once(own).chain(&slices).collect();
            certify_coprime(&list).map(Some)
        };
        let in_u = along(
            weight.in_u(),
            rest.iter().flat_map(|own| own.columns()).collect(),
        )?;
        let in_v = along(
            weight.in_v(),
            rest.iter().flat_map(|own| own.rows()).collect(),
        )?;
        let mixed = rest.iter().fold(weight.mixed().clone(), |common, own| {
            if common.as_constant().is_some() {
                common
            } else {
                gcd_bi(&common, own)
            }
        });
        mixed.as_constant()?;
        let certificates = [in_u, in_v];
        let divided = certificates.contains(&Some(Coprimality::Euclid));
        let rational = Coprimality::Modular(*Place::rational().modulus());
        Some(if divided || !weight.is_separable() {
            Coprimality::Euclid
        } else {
            certificates
                .into_iter()
                .flatten()
                .next()
                .unwrap_or(rational)
        })
    }
}

/// The multiple in which W at the start corner of the domain is a positive rational number (if W
/// vanishes there: W's first term) and the rational components of all coefficients are coprime
/// integers.
fn normalise(coordinates: &[BiPoly<Real>; 4], domain: &Domain) -> [BiPoly<Real>; 4] {
    let weight = &coordinates[0];
    let corner = weight.evaluate(domain.u.start(), domain.v.start());
    let unit = if corner.is_zero() {
        first_coefficient(weight)
    } else {
        corner
    };
    let Some(inverse) = unit.inverse() else {
        return coordinates.clone();
    };
    let scaled = coordinates.each_ref().map(|own| own.scale(&inverse));
    let (mut divisor, mut multiple) = (<Integer as Ring>::zero(), <Integer as Ring>::one());
    for row in scaled.iter().flat_map(BiPoly::rows) {
        divisor = gcd(&divisor, &row.content());
        multiple = lcm(&multiple, row.denominator());
    }
    let factor = Real::from_parts(Ring::from_integer(&multiple), divisor);
    scaled.map(|own| own.scale(&factor))
}

fn normalise_one(polynomial: &BiPoly<Real>, domain: &Domain) -> BiPoly<Real> {
    let [normal, ..] = normalise(
        &[
            polynomial.clone(),
            BiPoly::zero(),
            BiPoly::zero(),
            BiPoly::zero(),
        ],
        domain,
    );
    normal
}

/// The coefficient of the lowest power of u, and of v among those.
fn first_coefficient(polynomial: &BiPoly<Real>) -> Real {
    let rows = polynomial.rows();
    let row = rows.iter().find(|row| !row.is_zero());
    let coefficients = row.map(UniPoly::coefficients).unwrap_or_default();
    let first = coefficients.into_iter().find(|own| !own.is_zero());
    first.unwrap_or_else(Real::zero)
}
