use crate::diag::Code;
use crate::number::{Field, Real, Tower};
use crate::poly::{BiPoly, BiSquareTest, Fraction, UniPoly, exact_div_bi, gcd_all, square_test_bi};

use super::{Domain, HomogeneousSurface};

/// Why a surface has no rational unit normal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NormalFault {
    /// R_u × R_v = 0 identically.
    NotSurface,
    /// ‖R_u × R_v‖² is not a square.
    NotRational {
        /// The factor that stands in the way.
        reason: String,
    },
    /// ‖R_u × R_v‖ = √c · (rational function), and √c would extend the field beyond the limit on
    /// its degree.
    FieldDegree {
        /// c
        radicand: Real,
    },
}

impl NormalFault {
    /// What is wrong, in words.
    #[must_use]
    pub fn message(&self) -> String {
        match self {
            Self::NotSurface => "R_u × R_v is zero: this is a curve or a point".to_owned(),
            Self::NotRational { reason } => {
                format!("the unit normal of this surface is not rational: {reason}")
            }
            Self::FieldDegree { radicand } => {
                format!(
                    "the unit normal of this surface needs √({}): the field grows beyond the limit on its degree",
                    radicand.brief()
                )
            }
        }
    }

    /// The code of the rule that is broken.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::NotSurface | Self::NotRational { .. } => Code::E0307,
            Self::FieldDegree { .. } => Code::E0509,
        }
    }

    /// What to do about it, or what follows.
    #[must_use]
    pub fn help(&self) -> &'static str {
        match self {
            Self::NotSurface | Self::NotRational { .. } => {
                "the offset of this surface is not a rational surface in these parameters"
            }
            Self::FieldDegree { .. } => "raise the limit with `--max-field-degree`",
        }
    }
}

/// The normal of a surface in factors: R_u × R_v = a(u) b(v) F(u, v) D / W³.
///
/// F has no factor in one variable, and the components of the polynomial vector D have no common
/// factor in one variable. For an oriented translation F is the numerator of 1 + κx, and D what
/// turns with the profile and the curve.
#[derive(Debug, Clone)]
pub struct NormalVector {
    /// a(u)
    pub in_u: UniPoly<Real>,
    /// b(v)
    pub in_v: UniPoly<Real>,
    /// F(u, v)
    pub mixed: BiPoly<Real>,
    /// D
    pub direction: [BiPoly<Real>; 3],
}

impl NormalVector {
    /// The normal of a surface; none if R_u × R_v is zero identically.
    ///
    /// With P = (X, Y, Z) and W = d(u) e(v), A = d P_u − d′ P and B = e P_v − e′ P have
    /// R_u × R_v = A × B / W³, and what A or B has in common is taken out before it is multiplied
    /// in. For other W it is (W P_u × P_v − W_u P × P_v + W_v P × P_u) / W³.
    pub(super) fn of(surface: &HomogeneousSurface) -> Option<Self> {
        let point = surface.point();
        let [(in_u, in_v)] = surface.weight().terms() else {
            return Self::taken_out(normal_numerators(surface));
        };
        let first = Self::taken_out(point.each_ref().map(|own| {
            let weight = BiPoly::in_u(in_u);
            &(&weight * &own.derivative_u()) - &(&weight.derivative_u() * own)
        }))?;
        let second = Self::taken_out(point.each_ref().map(|own| {
            let weight = BiPoly::in_v(in_v);
            &(&weight * &own.derivative_v()) - &(&weight.derivative_v() * own)
        }))?;
        let product = Self::taken_out(cross(&first.direction, &second.direction))?;
        let factors = [&first, &second];
        Some(factors.into_iter().fold(product, |product, own| Self {
            in_u: &product.in_u * &own.in_u,
            in_v: &product.in_v * &own.in_v,
            mixed: &product.mixed * &own.mixed,
            direction: product.direction,
        }))
    }

    /// A vector with its common factors taken out; none for 0.
    ///
    /// A common F is seen where every component is a product f(u) g(v) F.
    fn taken_out(vector: [BiPoly<Real>; 3]) -> Option<Self> {
        let parts = vector.iter().filter(|own| !own.is_zero());
        let parts: Vec<_> = parts.map(BiPoly::split).collect::<Option<_>>()?;
        let (_, _, rest) = parts.first()?;
        let in_u = gcd_all(parts.iter().map(|own| &own.0));
        let in_v = gcd_all(parts.iter().map(|own| &own.1));
        let shared = rest.as_constant().is_none()
            && parts.iter().all(|(_, _, own)| are_proportional(own, rest));
        let mixed = if shared { rest.clone() } else { BiPoly::one() };
        let direction = vector.map(|own| {
            let own = own.exact_div_u(&in_u).unwrap_or(own);
            let own = own.exact_div_v(&in_v).unwrap_or(own);
            if shared {
                exact_div_bi(&own, &mixed).unwrap_or(own)
            } else {
                own
            }
        });
        Some(Self {
            in_u,
            in_v,
            mixed,
            direction,
        })
    }

    /// a(u) b(v) F(u, v)
    #[must_use]
    pub fn factor(&self) -> BiPoly<Real> {
        &BiPoly::product(&self.in_u, &self.in_v) * &self.mixed
    }

    /// D·D
    #[must_use]
    pub fn squared_direction(&self) -> BiPoly<Real> {
        let squares = self.direction.iter().map(|own| own * own);
        squares.fold(BiPoly::zero(), |sum, own| &sum + &own)
    }
}

/// Whether two polynomials that are not 0 differ by a constant factor.
fn are_proportional(left: &BiPoly<Real>, right: &BiPoly<Real>) -> bool {
    let lead = |own: &BiPoly<Real>| own.rows().last().map(UniPoly::leading_coefficient);
    match (lead(left), lead(right)) {
        (Some(first), Some(second)) => {
            left.bidegree() == right.bidegree() && left.scale(&second) == right.scale(&first)
        }
        _ => false,
    }
}

/// W P_u × P_v − W_u P × P_v + W_v P × P_u, where P = (X, Y, Z).
fn normal_numerators(surface: &HomogeneousSurface) -> [BiPoly<Real>; 3] {
    let weight = surface.weight();
    let point = surface.point();
    let in_u = point.each_ref().map(BiPoly::derivative_u);
    let in_v = point.each_ref().map(BiPoly::derivative_v);
    let (weight_u, weight_v) = (weight.derivative_u(), weight.derivative_v());
    let terms = [
        scale(weight, &cross(&in_u, &in_v)),
        scale(&-&weight_u, &cross(&point, &in_v)),
        scale(&weight_v, &cross(&point, &in_u)),
    ];
    [0, 1, 2].map(|axis| &(&terms[0][axis] + &terms[1][axis]) + &terms[2][axis])
}

/// The unit normal of a surface where it is rational, continuous on the domain and along
/// R_u × R_v at its first regular point: D / q with q² = D·D.
///
/// # Errors
///
/// The [`NormalFault`] that says why there is none.
pub fn unit_normal(
    surface: &[Fraction<Real>; 3],
    domain: &Domain,
    tower: &Tower,
) -> Result<[Fraction<Real>; 3], NormalFault> {
    let surface = HomogeneousSurface::of(surface, domain).surface;
    let normal = surface.normal_vector().ok_or(NormalFault::NotSurface)?;
    let (factor, root) = match square_test_bi(&normal.squared_direction()) {
        BiSquareTest::Square { factor, root } => (factor, root),
        BiSquareTest::NotSquare { reason } => return Err(NormalFault::NotRational { reason }),
    };
    let scale = tower
        .square_root(&factor)
        .map_err(|_| NormalFault::FieldDegree { radicand: factor })?;
    let root = root.scale(&scale);
    let over = &(&root * &normal.factor()) * surface.weight();
    let root = if starts_negative(&over, domain) {
        -&root
    } else {
        root
    };
    let component = |own: &BiPoly<Real>| Fraction::quotient(own, &root).map(|own| own.reduce());
    match normal.direction.each_ref().map(component) {
        [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
        _ => Err(NormalFault::NotSurface),
    }
}

/// The sign at the first of many points on a line through the domain where it is not 0.
fn starts_negative(polynomial: &BiPoly<Real>, domain: &Domain) -> bool {
    (1..1_000)
        .map(|step| {
            polynomial.evaluate(
                &domain.u.fraction(step, 1_009),
                &domain.v.fraction(step, 1_013),
            )
        })
        .map(|value| value.sign())
        .find(|sign| sign.is_ne())
        .is_some_and(std::cmp::Ordering::is_lt)
}

fn cross(left: &[BiPoly<Real>; 3], right: &[BiPoly<Real>; 3]) -> [BiPoly<Real>; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&left[i] * &right[j]) - &(&left[j] * &right[i]))
}

fn scale(factor: &BiPoly<Real>, vector: &[BiPoly<Real>; 3]) -> [BiPoly<Real>; 3] {
    vector.each_ref().map(|own| factor * own)
}
