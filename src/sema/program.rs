use std::rc::Rc;

use crate::curve::{Curve, Parameter};
use crate::number::{Real, Tower, Unit};
use crate::sweep::{Expectation, SweptSurface};

/// What a file asks for: surfaces, and claims about them.
#[derive(Debug, Clone, Default)]
pub struct Program {
    /// The length unit.
    pub unit: Unit,
    /// The field of all numbers.
    pub tower: Tower,
    /// The sound curves of the root file, in the order of the text.
    pub curves: Vec<Rc<Curve>>,
    /// The surfaces of the root file, in the order of the text. Those with errors are missing.
    pub surfaces: Vec<SweptSurface>,
    /// The expectations of the root file.
    pub expectations: Vec<Expectation>,
    /// Zeros that numerators and denominators of curves share, and cusps, which have been told of
    /// the curves: bounds in the curve's parameter.
    pub shared_zeros: Vec<(Parameter, (Real, Real))>,
    /// Whether the root file declares a surface at all, sound or not.
    pub declares_surfaces: bool,
}
