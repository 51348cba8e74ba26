//! What readers silently drop or damage, refused beforehand.

use crate::diag::Code;
use crate::net::{ControlNet, Knots, Model, Part};
use crate::number::{Field, Real};
use crate::poly::BiDegree;

use super::{Context, Double, ExportFault, PremultipliedNet, RoundedNet};

/// The greatest degree that readers of STEP and IGES know.
pub(super) const GREATEST_DEGREE: usize = 25;
/// The power of ten that is infinite in Open CASCADE: half of its `Precision::Infinite()`.
pub(super) const INFINITE_POWER: i64 = 100;
/// The quotient of the greatest weight by the least that is worth a warning.
const LARGE_WEIGHT_RATIO: i64 = 1_000;

/// What the readers of a format take: patches with positive weights, up to a degree.
pub(super) struct Readers {
    /// The greatest degree; none if any will do.
    pub(super) greatest_degree: Option<usize>,
    /// The power of ten from which on a number is as good as infinite for them; none if they take
    /// every double.
    pub(super) infinite_power: Option<i64>,
}

impl Readers {
    /// Refuses degrees that they drop and weights that they cannot take; a warning where they may
    /// lose accuracy.
    ///
    /// - **errors** a degree of 0 or above the greatest (E0305); no patches with positive weights,
    ///   or weights that differ by a factor above 10⁶ (E0304)
    pub(super) fn check(
        &self,
        model: &Model,
        context: &Context,
    ) -> Result<Option<ExportFault>, ExportFault> {
        let mut warning = None;
        for part in model.parts() {
            self.check_degrees(part.net.degree())?;
            let patches = part.patches();
            let patches = patches.map_err(|reason| no_patches(part, reason))?;
            for patch in patches {
                self.check_degrees(patch.net.degree())?;
                let ratio = check_weights(&patch.net, context)?;
                warning = warning.or(ratio);
            }
        }
        Ok(warning)
    }

    /// Refuses what has no triangles.
    ///
    /// - **errors** a degree of 0 (E0305); no patches with positive weights (E0304)
    pub(super) fn check_patches(&self, model: &Model) -> Result<(), ExportFault> {
        for part in model.parts() {
            self.check_degrees(part.net.degree())?;
            let patches = part.patches();
            patches.map_err(|reason| no_patches(part, reason))?;
        }
        Ok(())
    }

    /// Refuses degrees that they drop.
    ///
    /// - **errors** a degree of 0 or above the greatest (E0305)
    pub(super) fn check_degrees(&self, degree: BiDegree) -> Result<(), ExportFault> {
        let greatest = self.greatest_degree;
        let above = |own: usize| greatest.is_some_and(|greatest| own > greatest);
        for (along, own) in [("u", degree.u), ("v", degree.v)] {
            let help = match own {
                0 => "a surface must move in both directions; the `json` file carries this net",
                own if !above(own) => continue,
                _ => {
                    "they drop it without a word: use a profile or curve of lower degree, or the `json` file, which carries any degree"
                }
            };
            let taken = match greatest {
                Some(greatest) => format!("1 to {greatest}"),
                None => "1 and more".to_owned(),
            };
            let message = format!("degree {own} along {along}: readers take {taken}");
            return Err(ExportFault::new(Code::E0305, message, help));
        }
        Ok(())
    }

    /// Refuses numbers that are as good as infinite for them.
    ///
    /// - **errors** one of at least the power of ten where that begins (E0306)
    pub(super) fn check_sizes<'a>(
        &self,
        mut doubles: impl Iterator<Item = &'a Double>,
    ) -> Result<(), ExportFault> {
        let power = self.infinite_power;
        let limit = power.and_then(|power| Double::nearest(&Real::from(10).power(power)?));
        let Some(double) = limit.and_then(|limit| doubles.find(|own| own.reaches(limit))) else {
            return Ok(());
        };
        let message = format!(
            "a number of the net is {}: readers take numbers from 1e{} on for infinite",
            double.json(),
            power.unwrap_or_default()
        );
        let help = "use a larger unit of length, or a scale in which the numbers are smaller; the `json` file carries any double";
        Err(ExportFault::new(Code::E0306, message, help))
    }
}

/// The refusal of a surface without patches of positive weights.
fn no_patches(part: &Part, reason: &str) -> ExportFault {
    let least = part.net.min_weight().brief();
    let message = format!(
        "a control point has weight {least}; readers take positive weights only, and {reason}"
    );
    let help = "restrict the surface to a smaller domain, or write the `json` file, which carries any weights";
    ExportFault::new(Code::E0304, message, help)
}

/// The warning for weights by which readers may lose accuracy.
///
/// - **errors** weights that differ by a factor above 10⁶ (E0304)
fn check_weights(net: &ControlNet, context: &Context) -> Result<Option<ExportFault>, ExportFault> {
    let (least, greatest) = (net.min_weight(), net.max_weight());
    let (low, high) = (least.brief(), greatest.brief());
    let above = |ratio: i64| *greatest > least.times(&Real::from(ratio));
    if above(Context::GREATEST_WEIGHT_RATIO) && !context.any_weight_ratio {
        let message = format!("the weights run from {low} to {high}, a factor above 10^6");
        let help = "readers lose accuracy with such weights: restrict the surface to a smaller domain, or give `--allow-weight-ratio`";
        return Err(ExportFault::new(Code::E0304, message, help));
    }
    Ok(above(LARGE_WEIGHT_RATIO).then(|| {
        let message = format!("the weights run from {low} to {high}, a factor above 10^3");
        let help = "readers may lose accuracy: restrict the surface to a smaller domain";
        ExportFault::new(Code::W1006, message, help)
    }))
}

/// The nets of a surface for formats that store points as (x, y, z): the whole one, or its patches
/// with positive weights where a point of the whole one is at infinity.
///
/// - **errors** a weight of 0 and no such patches (E0304)
pub(super) fn affine_nets(part: &Part) -> Result<Vec<&ControlNet>, ExportFault> {
    if part.net.weights().iter().all(|own| !own.is_zero()) {
        return Ok(vec![&part.net]);
    }
    let patches = part.patches().map_err(|_| at_infinity())?;
    Ok(patches.iter().map(|own| &own.net).collect())
}

/// The one of them, for formats that hold one.
///
/// - **errors** a weight of 0, and no or several patches (E0304)
pub(super) fn affine_net(part: &Part) -> Result<&ControlNet, ExportFault> {
    match affine_nets(part)?.as_slice() {
        [net] => Ok(net),
        _ => Err(at_infinity()),
    }
}

fn at_infinity() -> ExportFault {
    let message = "a control point has weight 0: readers take no points at infinity";
    let help =
        "write the `json`, `verb` or `truck` file, or restrict the surface to a smaller domain";
    ExportFault::new(Code::E0304, message, help)
}

/// Refuses weights that round to 0 and different knots that round to the same double.
///
/// - **errors** both (E0306)
pub(super) fn check_doubles(net: &ControlNet, rounded: &RoundedNet) -> Result<(), ExportFault> {
    let weights = net.weights().iter().zip(rounded.weights.iter().flatten());
    check_weight_doubles(weights)?;
    check_knots(net, [&rounded.knots_u, &rounded.knots_v])
}

/// Refuses what [`check_doubles`] refuses, where points are multiplied by their weights.
///
/// - **errors** a weight that rounds to 0, knots that merge (E0306)
pub(super) fn check_premultiplied(
    net: &ControlNet,
    rounded: &PremultipliedNet,
) -> Result<(), ExportFault> {
    let doubles = rounded.points.iter().flatten().map(|[_, _, _, own]| own);
    check_weight_doubles(net.weights().iter().zip(doubles))?;
    check_knots(net, [&rounded.knots_u, &rounded.knots_v])
}

fn check_weight_doubles<'a>(
    mut weights: impl Iterator<Item = (&'a Real, &'a Double)>,
) -> Result<(), ExportFault> {
    let vanishes = |(exact, double): (&Real, &Double)| double.is_zero() && !exact.is_zero();
    if !weights.any(vanishes) {
        return Ok(());
    }
    let message = "a weight that is not 0 becomes 0 as a double";
    Err(ExportFault::new(Code::E0306, message, NARROW))
}

/// Refuses different knots that round to the same double.
fn check_knots(net: &ControlNet, doubles: [&[Double]; 2]) -> Result<(), ExportFault> {
    let merged = |(knots, doubles): (&Knots, &[Double])| {
        let pairs = knots.values().windows(2).zip(doubles.windows(2));
        let mut pairs =
            pairs.filter(|(exact, double)| exact[0] != exact[1] && double[0] == double[1]);
        pairs.next().map(|(exact, _)| {
            format!(
                "the knots {} and {} are the same double",
                exact[0], exact[1]
            )
        })
    };
    let knots = [net.knots_u(), net.knots_v()].into_iter().zip(doubles);
    match knots.filter_map(merged).next() {
        Some(message) => Err(ExportFault::new(Code::E0306, message, NARROW)),
        None => Ok(()),
    }
}

/// The way out where numbers merge.
const NARROW: &str =
    "choose a domain whose ends differ more; the `json` file carries the exact numbers";
