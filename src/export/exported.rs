use crate::number::Real;

use super::ExportFault;

/// A file, ready to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exported {
    /// All of it.
    pub bytes: Vec<u8>,
    /// How it differs from the exact surface.
    pub fidelity: Fidelity,
    /// What is odd about it; every code is a warning's.
    pub warnings: Vec<ExportFault>,
}

/// How a file differs from the exact surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fidelity {
    /// In nothing.
    Exact,
    /// Every number is the double nearest to the exact one.
    Rounded {
        /// No coordinate of a surface point moves by more than this; a proved bound in the unit
        /// of length. None where nothing is proved: for weights that are not all positive, and
        /// for inner knots whose rounding changes the shape.
        max_error: Option<Real>,
    },
    /// Replaced by triangles.
    Tessellated {
        /// No point of the surface is farther from the triangles than this, and no point of the
        /// triangles farther from the surface; a proved bound in the unit of length.
        chord_error: Real,
    },
    /// Drawn for the eye.
    Drawn,
}

impl Fidelity {
    /// That of a file which holds both: the greater difference.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        match (self, other) {
            (Self::Exact, other) | (other, Self::Exact) => other,
            (Self::Rounded { max_error: one }, Self::Rounded { max_error: other }) => {
                Self::Rounded {
                    max_error: one.zip(other).map(|(one, other)| one.max(other)),
                }
            }
            (Self::Tessellated { chord_error: one }, Self::Tessellated { chord_error: other }) => {
                Self::Tessellated {
                    chord_error: one.max(other),
                }
            }
            (own @ Self::Tessellated { .. }, _) | (_, own) => own,
        }
    }
}
