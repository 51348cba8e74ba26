use std::cell::OnceCell;

use crate::number::{Field, Real};
use crate::poly::{Antiderivative, RealRoot, UniPoly, integrate, real_roots};

use super::{
    Axis, Fault, Hodograph, Homogeneous, Interval, Parameter, Plane, Property, PropertyFunction,
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
    hodograph: Hodograph,
    speed: OnceCell<Result<UniPoly<Real>, Fault>>,
    arc_length: OnceCell<Result<(UniPoly<Real>, UniPoly<Real>), Fault>>,
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
    ) -> Self {
        let hodograph = Hodograph::of(&position.reduce());
        Self {
            name,
            plane,
            parameter,
            domain,
            position,
            hodograph,
            speed: OnceCell::new(),
            arc_length: OnceCell::new(),
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
        &self.hodograph
    }

    /// The numerator N of σ = N/d, positive on the domain apart from cusps.
    ///
    /// # Errors
    ///
    /// The faults of [`Hodograph::speed`].
    pub fn speed(&self) -> Result<&UniPoly<Real>, Fault> {
        let speed = self
            .speed
            .get_or_init(|| self.hodograph.speed(&self.domain));
        speed.as_ref().map_err(Clone::clone)
    }

    /// Where σ vanishes on the domain; empty if the curve has no σ.
    #[must_use]
    pub fn cusps(&self) -> Vec<RealRoot<Real>> {
        self.speed()
            .map(|speed| Hodograph::cusps(speed, &self.domain))
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
    pub fn property(&self, property: Property) -> Result<PropertyFunction, Fault> {
        let degree = self.position.degree();
        let polynomial = self.position.is_polynomial();
        // deg N = deg (a, b, c) by counting, and deg d.
        let (speed_bound, weight_bound) = if polynomial {
            (degree.saturating_sub(1), 0)
        } else {
            ((2 * degree).saturating_sub(2), 2 * degree)
        };
        let Hodograph {
            numerators,
            denominator,
        } = &self.hodograph;
        let function = |numerator: UniPoly<Real>, denominator: UniPoly<Real>, bound| {
            Ok(PropertyFunction {
                numerator,
                denominator,
                bound,
            })
        };
        match property {
            Property::Position(axis) => function(
                self.position.coordinates[axis.index()].clone(),
                self.position.weight.clone(),
                (degree, if polynomial { 0 } else { degree }),
            ),
            Property::Hodograph(axis) => function(
                numerators[axis.index()].clone(),
                denominator.clone(),
                (speed_bound, weight_bound),
            ),
            Property::Speed => function(
                self.speed()?.clone(),
                denominator.clone(),
                (speed_bound, weight_bound),
            ),
            Property::ArcLength => {
                let (numerator, denominator) = self.arc_length()?;
                let bound = if polynomial {
                    (degree, 0)
                } else {
                    let bottom = denominator.degree().unwrap_or(0);
                    (bottom.max(numerator.degree().unwrap_or(0)), bottom)
                };
                function(numerator, denominator, bound)
            }
            Property::Tangent(axis) => function(
                numerators[axis.index()].clone(),
                self.speed()?.clone(),
                (speed_bound, speed_bound),
            ),
            Property::Normal(axis) => function(
                self.normal_numerator(axis)?,
                self.speed()?.clone(),
                (speed_bound, speed_bound),
            ),
            Property::Curvature => {
                let (top, bottom) = self.curvature()?;
                let turning = speed_bound.saturating_sub(2);
                function(top, bottom, (turning + weight_bound, 2 * speed_bound))
            }
            Property::RadiusOfCurvature => {
                let (top, bottom) = self.curvature()?;
                if top.is_zero() {
                    return Err(Fault::StraightLine);
                }
                let turning = speed_bound.saturating_sub(2);
                function(bottom, top, (2 * speed_bound, turning + weight_bound))
            }
        }
    }

    /// The plane axes' hodograph numerators (a, b).
    fn plane_hodograph(&self) -> Result<(Axis, Axis, &UniPoly<Real>, &UniPoly<Real>), Fault> {
        let (first, second) = self.plane.ok_or(Fault::NotPlane)?.axes();
        let numerators = &self.hodograph.numerators;
        Ok((
            first,
            second,
            &numerators[first.index()],
            &numerators[second.index()],
        ))
    }

    fn normal_numerator(&self, axis: Axis) -> Result<UniPoly<Real>, Fault> {
        let (first, second, a, b) = self.plane_hodograph()?;
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
        let (_, _, a, b) = self.plane_hodograph()?;
        let speed = self.speed()?;
        let turning = &(a * &b.derivative()) - &(&a.derivative() * b);
        // N divides: with a + ib = g h ω² both are multiples of |g| h |ω|².
        let turning = turning.exact_div(speed).unwrap_or_else(UniPoly::zero);
        Ok((&turning * &self.hodograph.denominator, speed * speed))
    }

    fn arc_length(&self) -> Result<(UniPoly<Real>, UniPoly<Real>), Fault> {
        let length = self.arc_length.get_or_init(|| {
            let speed = self.speed()?;
            let (numerator, denominator) = match integrate(speed, &self.hodograph.denominator) {
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
                return Err(Fault::InfiniteArcLength { root });
            }
            let offset = denominator
                .evaluate(start)
                .inverse()
                .unwrap_or_else(Real::zero);
            let offset = numerator.evaluate(start).times(&offset);
            Ok((&numerator - &denominator.scale(&offset), denominator))
        });
        length.clone()
    }
}
