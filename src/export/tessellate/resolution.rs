use crate::diag::Code;
use crate::export::approx::magnitude;
use crate::export::{ExportFault, Precision};
use crate::net::{Face, Model};
use crate::number::{Field, Integer, Real};

/// The default tolerance is this part of the model's size.
const PART_OF_SIZE: i64 = 1_000;

/// Steps along each parameter between the points that tell the size of a face.
const SAMPLES: i64 = 8;

/// Tolerances of a mesh: what is asked for, and what the rounding of its points takes of it.
pub(super) struct Resolution {
    tolerance: Real,
    rounding: Real,
    /// Bounds are counted in units of 2 to the power of minus this.
    pub(super) bits: u32,
}

impl Resolution {
    /// The tolerance that is asked for, or one in proportion to the size of the model.
    ///
    /// - **errors** one that the numbers of the format do not resolve (E0308)
    pub(super) fn of(
        model: &Model,
        chord: Option<&Real>,
        precision: Precision,
    ) -> Result<Self, ExportFault> {
        let (size, reach) = extent(model);
        let default = || &size / &Real::from(PART_OF_SIZE);
        let tolerance = chord.cloned().unwrap_or_else(default);
        // Below 2^binade half a step of the format is at most 2^(binade − 2 − fraction), and a
        // point moves by less than twice that.
        let binade = reach.binade().unwrap_or_default() + 1;
        let rounding = Real::power_of_two(binade - 1 - precision.fraction_bits());
        if tolerance < rounding.times(&Real::from(2)) {
            let least = magnitude(&rounding.times(&Real::from(20)));
            let message = format!(
                "the triangles would be finer than the numbers of the format, which end at {}",
                magnitude(&rounding)
            );
            let mut help = format!(
                "give a greater `--chord`, such as {least}; move the surface nearer to the origin"
            );
            if precision == Precision::Single {
                help += ", or write `ply` or `mesh`, whose numbers are doubles";
            }
            return Err(ExportFault::new(Code::E0308, message, help));
        }
        let bits = 40 - tolerance.binade().unwrap_or_default();
        Ok(Self {
            tolerance,
            rounding,
            bits: u32::try_from(bits).unwrap_or_default(),
        })
    }

    /// What is left of the tolerance for the triangles between exact points, rounded down.
    pub(super) fn for_chords(&self) -> Integer {
        let left = self.tolerance.minus(&self.rounding);
        let [lower, _] = left.enclose(self.bits).ends();
        (lower.numerator() << self.bits).div_floor(lower.denominator())
    }

    /// The bound for a mesh between rounded points from that for one between exact points.
    pub(super) fn with_rounding(&self, bound: Integer) -> Real {
        let bound = Real::ratio(bound, Integer::from(1) << self.bits);
        bound.plus(&self.rounding)
    }
}

/// The longest side of the box of points on the surfaces, and the greatest coordinate of a control
/// point. Control points may be much further apart than the points of their surface.
fn extent(model: &Model) -> (Real, Real) {
    let faces = || model.shells().iter().flat_map(|own| &own.faces);
    let points: Vec<[Real; 3]> = faces().flat_map(samples).collect();
    let size = [0, 1, 2].into_iter().filter_map(|axis| {
        let values = || points.iter().map(|own| &own[axis]);
        Some(values().max()?.minus(values().min()?))
    });
    let controls = faces().flat_map(|own| own.net.points()).flatten();
    let reach = controls.map(Real::absolute).max();
    (
        size.max().unwrap_or_else(Real::zero),
        reach.unwrap_or_else(Real::zero),
    )
}

/// Points of a face, evenly spaced in its parameters, its corners among them.
fn samples(face: &Face) -> Vec<[Real; 3]> {
    let along_u = steps(face.net.knots_u().domain());
    let along_v = steps(face.net.knots_v().domain());
    let places = along_u
        .iter()
        .flat_map(|u| along_v.iter().map(move |v| (u, v)));
    places
        .filter_map(|(u, v)| face.surface.evaluate(u, v))
        .collect()
}

fn steps((from, to): (&Real, &Real)) -> Vec<Real> {
    let width = to.minus(from);
    let part = |index: i64| width.times(&Real::ratio(index.into(), SAMPLES.into()));
    (0..=SAMPLES).map(|own| from.plus(&part(own))).collect()
}
