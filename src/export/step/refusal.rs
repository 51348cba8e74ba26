//! What readers of STEP silently drop or damage, refused beforehand.

use crate::diag::Code;
use crate::net::{ControlNet, Knots, Model, Part};
use crate::number::{Field, Real};
use crate::poly::BiDegree;

use super::{Context, ExportFault, RoundedNet};
use crate::export::Double;

/// The greatest degree that the common kernels read.
const GREATEST_DEGREE: usize = 25;
/// The quotient of the greatest weight by the least that is worth a warning.
const LARGE_WEIGHT_RATIO: i64 = 1_000;

/// Refuses degrees that readers drop and weights that they cannot take; a warning where they may
/// lose accuracy.
pub(super) fn check(model: &Model, context: &Context) -> Result<Option<ExportFault>, ExportFault> {
    let mut warning = None;
    for part in model.parts() {
        check_degrees(part.net.degree())?;
        let patches = part.patches().map_err(|reason| no_patches(part, reason))?;
        for patch in patches {
            check_degrees(patch.net.degree())?;
            let ratio = check_weights(&patch.net, context)?;
            warning = warning.or(ratio);
        }
    }
    Ok(warning)
}

fn check_degrees(degree: BiDegree) -> Result<(), ExportFault> {
    for (along, own) in [("u", degree.u), ("v", degree.v)] {
        let help = match own {
            0 => "a surface must move in both directions; the `json` file carries this net",
            1..=GREATEST_DEGREE => continue,
            _ => {
                "readers of STEP drop it without a word; use a profile or curve of lower degree, or the `json` file, which carries any degree"
            }
        };
        let message = format!("degree {own} along {along}: STEP carries 1 to {GREATEST_DEGREE}");
        return Err(ExportFault::new(Code::E0305, message, help));
    }
    Ok(())
}

/// The refusal of a surface without patches of positive weights.
fn no_patches(part: &Part, reason: &str) -> ExportFault {
    let least = part.net.min_weight().brief();
    let message = format!(
        "a control point has weight {least}; STEP carries positive weights only, and {reason}"
    );
    let help = "restrict the surface to a smaller domain, or write the `json` file, which carries any weights";
    ExportFault::new(Code::E0304, message, help)
}

fn check_weights(net: &ControlNet, context: &Context) -> Result<Option<ExportFault>, ExportFault> {
    let (least, greatest) = (net.min_weight(), net.max_weight());
    let (low, high) = (least.brief(), greatest.brief());
    let fault = |code, message: String, help| ExportFault::new(code, message, help);
    let above = |ratio: i64| *greatest > least.times(&Real::from(ratio));
    if above(Context::GREATEST_WEIGHT_RATIO) && !context.any_weight_ratio {
        let message = format!("the weights run from {low} to {high}, a factor above 10^6");
        let help = "readers of STEP lose accuracy with such weights: restrict the surface to a smaller domain, or give `--allow-weight-ratio`";
        return Err(fault(Code::E0304, message, help));
    }
    Ok(above(LARGE_WEIGHT_RATIO).then(|| {
        let message = format!("the weights run from {low} to {high}, a factor above 10^3");
        let help = "readers of STEP may lose accuracy: restrict the surface to a smaller domain";
        fault(Code::W1006, message, help)
    }))
}

/// Refuses weights that round to 0 and different knots that round to the same double.
pub(super) fn check_doubles(net: &ControlNet, rounded: &RoundedNet) -> Result<(), ExportFault> {
    let merged = |knots: &Knots, doubles: &[Double]| {
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
    let zero = rounded.weights.iter().flatten().any(|own| own.is_zero());
    let zero = zero.then(|| "a positive weight becomes 0 as a double".to_owned());
    let fault = zero
        .or_else(|| merged(net.knots_u(), &rounded.knots_u))
        .or_else(|| merged(net.knots_v(), &rounded.knots_v));
    let help = "choose a domain whose ends differ more; the `json` file carries the exact numbers";
    fault.map_or(Ok(()), |message| {
        Err(ExportFault::new(Code::E0306, message, help))
    })
}
