use crate::curve::Parameter;
use crate::poly::BiDegree;

use super::{Form, Scalar};

/// How many parts of an expression are looked at.
const EFFORT: usize = 1_000;

/// A bidegree that is not exceeded when an expression is expanded: counted as by
/// [`degree_bound`](super::degree_bound), but as if all denominators were coprime, so that no
/// symbols need to be compared. None for long expressions and rare forms.
#[must_use]
pub(super) fn rough_degree(expression: &Scalar) -> Option<BiDegree> {
    let mut effort = EFFORT;
    let Rough { above, below } = Rough::of(expression, &mut effort)?;
    Some(above.max(below))
}

/// The bidegrees of a numerator and of a denominator.
#[derive(Clone, Copy, Default)]
struct Rough {
    above: BiDegree,
    below: BiDegree,
}

impl Rough {
    fn of(expression: &Scalar, effort: &mut usize) -> Option<Self> {
        *effort = effort.checked_sub(1)?;
        let mut all = Self::default();
        match expression.form() {
            Form::Constant(_) => {}
            Form::Parameter(own) => all.above = along(*own, 1),
            Form::Polynomial(parameter, own) => {
                all.above = along(*parameter, own.degree().unwrap_or_default());
            }
            Form::Product(factors) => {
                for own in factors {
                    let own = Self::of(own, effort)?;
                    all = Self {
                        above: plus(all.above, own.above),
                        below: plus(all.below, own.below),
                    };
                }
            }
            // n/d + a/b = (n b + a d) / d b
            Form::Sum(terms) => {
                for own in terms {
                    let own = Self::of(own, effort)?;
                    let raised = plus(all.above, own.below);
                    all = Self {
                        above: raised.max(plus(own.above, all.below)),
                        below: plus(all.below, own.below),
                    };
                }
            }
            Form::Power(base, exponent) => {
                let base = Self::of(base, effort)?;
                let size = usize::try_from(exponent.unsigned_abs()).ok()?;
                all = Self {
                    above: times(base.above, size),
                    below: times(base.below, size),
                };
                if *exponent < 0 {
                    std::mem::swap(&mut all.above, &mut all.below);
                }
            }
            Form::Property(of, argument) if of.derivative == 0 => {
                let Form::Parameter(parameter) = argument.form() else {
                    return None;
                };
                let (above, below) = of.curve.property(of.property).ok()?.bound;
                all = Self {
                    above: along(*parameter, above),
                    below: along(*parameter, below),
                };
            }
            _ => return None,
        }
        Some(all)
    }
}

fn along(parameter: Parameter, degree: usize) -> BiDegree {
    match parameter {
        Parameter::U => BiDegree::new(degree, 0),
        Parameter::V => BiDegree::new(0, degree),
    }
}

fn plus(left: BiDegree, right: BiDegree) -> BiDegree {
    let u = left.u.saturating_add(right.u);
    BiDegree::new(u, left.v.saturating_add(right.v))
}

fn times(degree: BiDegree, factor: usize) -> BiDegree {
    let u = degree.u.saturating_mul(factor);
    BiDegree::new(u, degree.v.saturating_mul(factor))
}
