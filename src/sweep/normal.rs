use crate::diag::Code;
use crate::number::{Field, Real, Tower};
use crate::poly::{BiPoly, BiSquareTest, Fraction, square_test_bi};

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
                    "the unit normal of this surface needs √({radicand}): the field grows beyond the limit on its degree"
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

/// The polynomial vector M with R_u × R_v = M / W³:
/// M = W P_u × P_v − W_u P × P_v + W_v P × P_u, where P = (X, Y, Z).
#[must_use]
pub fn normal_direction(surface: &HomogeneousSurface) -> [BiPoly<Real>; 3] {
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
/// R_u × R_v at its first regular point.
///
/// With M as in [`normal_direction`], N = M / q where q² = M·M.
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
    let direction = normal_direction(&surface);
    let squared = direction
        .iter()
        .fold(BiPoly::zero(), |sum, own| &sum + &(own * own));
    if squared.is_zero() {
        return Err(NormalFault::NotSurface);
    }
    let (factor, root) = match square_test_bi(&squared) {
        BiSquareTest::Square { factor, root } => (factor, root),
        BiSquareTest::NotSquare { reason } => return Err(NormalFault::NotRational { reason }),
    };
    let scale = tower
        .square_root(&factor)
        .map_err(|_| NormalFault::FieldDegree { radicand: factor })?;
    let over = &root.scale(&scale) * surface.weight();
    let root = if starts_negative(&over, domain) {
        -&root
    } else {
        root
    };
    let root = root.scale(&scale);
    let component = |own: &BiPoly<Real>| Fraction::quotient(own, &root).map(|own| own.reduce());
    match direction.each_ref().map(component) {
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
