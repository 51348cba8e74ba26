use crate::diag::Code;
use crate::number::Real;
use crate::poly::{RealRoot, UniPoly};

use super::Parameter;

/// Why a curve does not have a property.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fault {
    /// ‖r′‖² is not a square: these factors occur an odd number of times.
    NotPythagorean {
        /// The product of the odd factors, square-free.
        odd_part: UniPoly<Real>,
    },
    /// σ = √c · (rational function), and √c would extend the field beyond the limit on its degree.
    FieldDegree {
        /// c
        radicand: Real,
    },
    /// σ = |h| … with a real factor h that changes sign on the domain.
    SpeedChangesSign {
        /// The place of the change.
        root: Box<RealRoot<Real>>,
    },
    /// ∫σ has a logarithm or an arctangent in it.
    ArcLengthNotRational {
        /// The poles of the part that does not integrate to a rational function.
        logarithmic: UniPoly<Real>,
    },
    /// ∫σ diverges: σ has a pole on the domain.
    InfiniteArcLength {
        /// The pole.
        root: Box<RealRoot<Real>>,
    },
    /// r′ = 0 identically.
    NoMotion,
    /// The curve is not given in a coordinate plane.
    NotPlane,
    /// κ = 0 identically, so 1/κ does not exist.
    StraightLine,
}

impl Fault {
    /// The code of the rule that is broken.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::NotPythagorean { .. } => Code::E0201,
            Self::FieldDegree { .. } => Code::E0509,
            Self::SpeedChangesSign { .. } => Code::E0202,
            Self::ArcLengthNotRational { .. } | Self::InfiniteArcLength { .. } => Code::E0203,
            Self::NoMotion => Code::E0204,
            Self::NotPlane => Code::E0206,
            Self::StraightLine => Code::E0207,
        }
    }

    /// What is wrong, in terms of the curve of that name.
    #[must_use]
    pub fn message(&self, curve: &str) -> String {
        match self {
            Self::NotPythagorean { .. } => {
                format!(
                    "`{curve}` is not a Pythagorean-hodograph curve: ‖{curve}′‖² is not a square"
                )
            }
            Self::FieldDegree { radicand } => format!(
                "the parametric speed of `{curve}` needs √({}): the field grows beyond the limit on its degree",
                radicand.brief()
            ),
            Self::SpeedChangesSign { .. } => format!(
                "the parametric speed of `{curve}` is not rational: a real factor of its hodograph changes sign on the domain"
            ),
            Self::ArcLengthNotRational { .. } => {
                format!("the arc length of `{curve}` is not a rational function")
            }
            Self::InfiniteArcLength { .. } => {
                format!("the arc length of `{curve}` is infinite on its domain")
            }
            Self::NoMotion => format!("`{curve}` is constant: its hodograph is zero"),
            Self::NotPlane => format!("`{curve}` is not given in a coordinate plane"),
            Self::StraightLine => {
                format!("`{curve}` is a straight line: its curvature is zero")
            }
        }
    }

    /// What to do about it.
    #[must_use]
    pub fn help(&self) -> Option<&'static str> {
        match self {
            Self::NotPythagorean { .. } => Some(
                "give the curve by a preimage, `ph(start: P, preimage: [(a, b), …])`, or use only x, y, z",
            ),
            Self::FieldDegree { .. } => Some("raise the limit with `--max-field-degree`"),
            Self::SpeedChangesSign { .. } => Some("end the domain at the change of sign"),
            Self::ArcLengthNotRational { .. } => {
                Some("polynomial Pythagorean-hodograph curves have a rational arc length")
            }
            Self::NotPlane => Some(
                "a curve given by pairs in a plane has n and κ; one in space has x, y, z, σ, s and t",
            ),
            Self::NoMotion => {
                Some("a fixed vector is a constant, `let a = (1, 2, 3)`, not a curve")
            }
            Self::StraightLine => {
                Some("its radius of curvature does not exist; use a curve that turns")
            }
            Self::InfiniteArcLength { .. } => Some("end the domain before the pole"),
        }
    }

    /// The evidence, in the curve's own parameter.
    #[must_use]
    pub fn evidence(&self, curve: &str, parameter: Parameter) -> Option<String> {
        let variable = parameter.to_string();
        match self {
            Self::NotPythagorean { odd_part } => Some(format!(
                "‖{curve}′‖² has this factor an odd number of times: {}",
                odd_part.display(&variable)
            )),
            Self::SpeedChangesSign { root } => Some(format!(
                "the factor {} changes sign at {}",
                root.polynomial().display(&variable),
                root.place(&variable)
            )),
            Self::ArcLengthNotRational { logarithmic } => Some(format!(
                "the integral of σ has logarithms or arctangents from the poles {} = 0",
                logarithmic.display(&variable)
            )),
            Self::InfiniteArcLength { root } => {
                Some(format!("σ has a pole at {}", root.place(&variable)))
            }
            Self::FieldDegree { .. } | Self::NoMotion | Self::NotPlane | Self::StraightLine => None,
        }
    }
}
