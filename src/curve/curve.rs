use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use crate::number::{Field, Real, Tower};
use crate::poly::{Antiderivative, RealRoot, UniPoly, integrate, real_roots};

use super::kinds::Coordinates;
use super::{
    Axis, Fault, Hodograph, Homogeneous, Interpolant, Interval, Parameter, Plane, Preimage,
    Property, PropertyFunction,
};

/// A rational curve of one span on its domain, with the properties that it has exactly.
///
/// A curve is a Pythagorean-hodograph curve if its squared speed is a square in the field,
/// however it was written; σ, t, n, κ exist then and only then.
#[derive(Debug)]
pub struct Curve {
    name: String,
    plane: Option<Plane>,
    parameter: Parameter,
    domain: Interval,
    position: Homogeneous,
    hodograph: OnceCell<Hodograph>,
    /// The field, which grows by a square root where the speed needs one.
    tower: Tower,
    preimage: Option<Preimage>,
    interpolant: Option<Interpolant>,
    speed: OnceCell<Result<UniPoly<Real>, Fault>>,
    arc_length: OnceCell<Result<ArcLength, Fault>>,
    /// What has been asked for already.
    properties: RefCell<Vec<(Property, Known)>>,
}

/// A property that was found, or why there is none.
type Known = Result<Rc<PropertyFunction>, Fault>;

/// s as a fraction.
#[derive(Debug, Clone)]
struct ArcLength {
    numerator: UniPoly<Real>,
    denominator: UniPoly<Real>,
}

impl Curve {
    /// A curve from its homogeneous coordinates, which are kept as they are written.
    #[must_use]
    pub fn new(
        name: String,
        plane: Option<Plane>,
        parameter: Parameter,
        domain: Interval,
        position: Homogeneous,
        tower: Tower,
    ) -> Self {
        Self {
            name,
            plane,
            parameter,
            domain,
            position,
            hodograph: OnceCell::new(),
            tower,
            preimage: None,
            interpolant: None,
            speed: OnceCell::new(),
            arc_length: OnceCell::new(),
            properties: RefCell::default(),
        }
    }

    /// The same curve with what is known from how it was built: its hodograph, the preimage of
    /// that, and which Hermite interpolant it is.
    #[must_use]
    pub fn built(self, coordinates: Coordinates) -> Self {
        let hodograph = match (coordinates.slopes, self.plane) {
            (Some(slopes), Some(plane)) => Hodograph {
                numerators: plane.in_space(slopes, UniPoly::zero()),
                denominator: UniPoly::one(),
            }
            .into(),
            _ => self.hodograph,
        };
        Self {
            hodograph,
            preimage: coordinates.preimage,
            interpolant: coordinates.interpolant,
            ..self
        }
    }

    /// The name it was declared under.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its plane; none for a curve in space.
    #[must_use]
    pub fn plane(&self) -> Option<Plane> {
        self.plane
    }

    /// Its parameter, u or v.
    #[must_use]
    pub fn parameter(&self) -> Parameter {
        self.parameter
    }

    /// Its domain.
    #[must_use]
    pub fn domain(&self) -> &Interval {
        &self.domain
    }

    /// Its homogeneous coordinates, as written.
    #[must_use]
    pub fn position(&self) -> &Homogeneous {
        &self.position
    }

    /// Its hodograph in lowest terms.
    #[must_use]
    pub fn hodograph(&self) -> &Hodograph {
        self.hodograph.get_or_init(|| {
            if self.position.is_polynomial() {
                Hodograph::of(&self.position)
            } else {
                Hodograph::of(&self.position.reduce())
            }
        })
    }

    /// The numerator N of σ = N/d, positive on the domain apart from cusps.
    ///
    /// # Errors
    ///
    /// The faults of [`Hodograph::speed`].
    pub fn speed(&self) -> Result<&UniPoly<Real>, Fault> {
        let speed = self.speed.get_or_init(|| match &self.preimage {
            Some(preimage) => preimage.speed(&self.tower).map_err(|_| Fault::FieldDegree {
                radicand: preimage.factor().norm(),
            }),
            None => self.hodograph().speed(&self.domain, &self.tower),
        });
        speed.as_ref().map_err(Clone::clone)
    }

    /// The preimage of its hodograph, if the curve was built from it.
    #[must_use]
    pub fn preimage(&self) -> Option<&Preimage> {
        self.preimage.as_ref()
    }

    /// The Hermite interpolant that it is, if it was built as one.
    #[must_use]
    pub fn interpolant(&self) -> Option<&Interpolant> {
        self.interpolant.as_ref()
    }

    /// Whether its parametric speed has been asked for, and exists.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        self.speed.get().is_some_and(Result::is_ok)
    }

    /// Where σ vanishes on the domain; empty if the curve has no σ.
    #[must_use]
    pub fn cusps(&self) -> Vec<RealRoot<Real>> {
        let regular = |own: &Preimage| !own.has_cusp(&self.domain);
        if self.preimage.as_ref().is_some_and(regular) {
            return Vec::new();
        }
        self.speed()
            .map(|speed| self.hodograph().cusps(speed, &self.domain))
            .unwrap_or_default()
    }

    /// The total arc length ∫σ over the domain.
    ///
    /// # Errors
    ///
    /// As for the property [`Property::ArcLength`].
    pub fn length(&self) -> Result<Real, Fault> {
        let length = self.property(Property::ArcLength)?;
        Ok(length
            .evaluate(self.domain.end())
            .unwrap_or_else(Real::zero))
    }

    /// A property as an unreduced fraction in the curve's parameter.
    ///
    /// With r′ = (a, b, c)/d, σ = N/d and the polynomial H = (ab′ − a′b)/N (for a polynomial curve
    /// H = (x′y″ − x″y′)/σ): t = (a, b, c)/N, n = (b, −a)/N, κ = Hd/N², ρ = N²/(Hd).
    /// Degrees by counting, for a polynomial curve of degree m: σ m − 1, s m, H m − 3.
    ///
    /// # Errors
    ///
    /// The [`Fault`] that says why the curve does not have the property.
    pub fn property(&self, property: Property) -> Result<Rc<PropertyFunction>, Fault> {
        let known = self.properties.borrow();
        if let Some((_, known)) = known.iter().find(|(own, _)| *own == property) {
            return known.clone();
        }
        drop(known);
        let found = self.find(property).map(Rc::new);
        self.properties.borrow_mut().push((property, found.clone()));
        found
    }

    fn find(&self, property: Property) -> Result<PropertyFunction, Fault> {
        let counted = || self.counted_degrees();
        let (numerator, denominator, bound) = match property {
            Property::Position(axis) => {
                let Homogeneous {
                    weight,
                    coordinates,
                } = &self.position;
                let degree = self.position.degree();
                let below = if self.position.is_polynomial() {
                    0
                } else {
                    degree
                };
                (
                    coordinates[axis.index()].clone(),
                    weight.clone(),
                    (degree, below),
                )
            }
            Property::Hodograph(axis) => {
                let Hodograph {
                    numerators,
                    denominator,
                } = self.hodograph();
                let top = numerators[axis.index()].clone();
                (top, denominator.clone(), counted())
            }
            Property::Speed => {
                let top = self.speed()?.clone();
                (top, self.hodograph().denominator.clone(), counted())
            }
            Property::ArcLength => return self.arc_length_function(),
            Property::Tangent(axis) => {
                let top = self.hodograph().numerators[axis.index()].clone();
                (top, self.speed()?.clone(), (counted().0, counted().0))
            }
            Property::Normal(axis) => {
                let top = self.normal_numerator(axis)?;
                (top, self.speed()?.clone(), (counted().0, counted().0))
            }
            Property::Curvature => {
                let ((top, bottom), (speed, weight)) = (self.curvature()?, counted());
                (top, bottom, (speed.saturating_sub(2) + weight, 2 * speed))
            }
            Property::RadiusOfCurvature => {
                let ((top, bottom), (speed, weight)) = (self.curvature()?, counted());
                if top.is_zero() {
                    return Err(Fault::StraightLine);
                }
                (bottom, top, (2 * speed, speed.saturating_sub(2) + weight))
            }
        };
        Ok(PropertyFunction {
            numerator,
            denominator,
            bound,
        })
    }

    /// The degrees of (a, b, c) and of d by counting: m − 1 and 0 for a polynomial curve of degree
    /// m, else 2m − 2 (the leading terms of x′w − xw′ always cancel) and 2m.
    fn counted_degrees(&self) -> (usize, usize) {
        let degree = self.position.degree();
        if self.position.is_polynomial() {
            (degree.saturating_sub(1), 0)
        } else {
            ((2 * degree).saturating_sub(2), 2 * degree)
        }
    }

    fn arc_length_function(&self) -> Result<PropertyFunction, Fault> {
        let ArcLength {
            numerator,
            denominator,
        } = self.arc_length()?;
        let bound = if self.position.is_polynomial() {
            (self.position.degree(), 0)
        } else {
            let bottom = denominator.degree().unwrap_or(0);
            (bottom.max(numerator.degree().unwrap_or(0)), bottom)
        };
        Ok(PropertyFunction {
            numerator,
            denominator,
            bound,
        })
    }

    /// The hodograph numerators (a, b) along the axes of the curve's plane.
    fn plane_hodograph(&self) -> Result<[(Axis, &UniPoly<Real>); 2], Fault> {
        let (first, second) = self.plane.ok_or(Fault::NotPlane)?.axes();
        let numerators = &self.hodograph().numerators;
        Ok([first, second].map(|axis| (axis, &numerators[axis.index()])))
    }

    fn normal_numerator(&self, axis: Axis) -> Result<UniPoly<Real>, Fault> {
        let [(first, a), (second, b)] = self.plane_hodograph()?;
        Ok(if axis == first {
            b.clone()
        } else if axis == second {
            -a
        } else {
            UniPoly::zero()
        })
    }

    /// (H d, N²)
    fn curvature(&self) -> Result<(UniPoly<Real>, UniPoly<Real>), Fault> {
        let [(_, a), (_, b)] = self.plane_hodograph()?;
        let speed = self.speed()?;
        let terms = [(1, a, &b.derivative()), (-1, &a.derivative(), b)];
        let turning = UniPoly::sum_of_products(&terms);
        // N divides: with a + ib = g h ω² both are multiples of |g| h |ω|².
        let turning = turning.exact_div(speed).unwrap_or_else(UniPoly::zero);
        Ok((&turning * &self.hodograph().denominator, speed * speed))
    }

    fn arc_length(&self) -> Result<ArcLength, Fault> {
        let length = self.arc_length.get_or_init(|| {
            let speed = self.speed()?;
            let (numerator, denominator) = match integrate(speed, &self.hodograph().denominator) {
                Antiderivative::Rational {
                    numerator,
                    denominator,
                } => (numerator, denominator),
                Antiderivative::NotRational { logarithmic } => {
                    return Err(Fault::ArcLengthNotRational { logarithmic });
                }
            };
            let (start, end) = (self.domain.start(), self.domain.end());
            if let Some(root) = real_roots(&denominator, start, end).into_iter().next() {
                return Err(Fault::InfiniteArcLength {
                    root: Box::new(root),
                });
            }
            let offset = numerator.evaluate(start);
            if offset.is_zero() {
                return Ok(ArcLength {
                    numerator,
                    denominator,
                });
            }
            let inverse = denominator.evaluate(start).inverse();
            let offset = offset.times(&inverse.unwrap_or_else(Real::zero));
            Ok(ArcLength {
                numerator: &numerator - &denominator.scale(&offset),
                denominator,
            })
        });
        length.clone()
    }
}
