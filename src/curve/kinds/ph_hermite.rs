use crate::curve::{Branch, Choice, HermiteData, Interpolant};
use crate::number::{Complex, Real};

use super::{Arguments, BuildFault, Coordinates, Kind, Setting, Shape, Slot};

/// `ph_hermite(P0, D0, P1, D1, branch: best)`: the plane Pythagorean-hodograph quintic with these
/// end points and end derivatives on the domain.   [farouki-neff]
///
/// There are four; `branch` names one of them, or is `best`, which is the default: the one of
/// least absolute rotation index.
pub(super) const KIND: Kind = Kind {
    name: "ph_hermite",
    usage: "ph_hermite(P0, D0, P1, D1), or with branch: best, \"++\", \"+-\", \"-+\" or \"--\"",
    slots: &[
        Slot::positional(Shape::Point),
        Slot::positional(Shape::Point),
        Slot::positional(Shape::Point),
        Slot::positional(Shape::Point),
        Slot::optional("branch", Shape::Word),
    ],
    build,
};

fn build(arguments: &Arguments, setting: &Setting<'_>) -> Result<Coordinates, BuildFault> {
    let point = |slot: usize| match arguments.point(slot) {
        [x, y] => Ok(Complex::new(x.clone(), y.clone())),
        _ => Err(BuildFault::malformed(
            "a `ph_hermite` curve lies in a plane: its data are pairs",
        )),
    };
    let (start, end) = (point(0)?, point(2)?);
    let width = setting.domain.end() - setting.domain.start();
    let data = HermiteData {
        first: point(1)?,
        last: point(3)?,
        chord: end.minus(&start).scale(&(&Real::from(1) / &width)),
    };
    let (branch, choice) = match arguments.word(4) {
        None | Some("best") => data
            .best(setting.domain, setting.tower)
            .map_err(BuildFault::Malformed)?,
        Some(word) => match Branch::of_word(word) {
            Some(branch) => (branch, Choice::Given),
            None => {
                let message = format!("there is no branch `{word}`");
                return Err(BuildFault::Malformed(message));
            }
        },
    };
    let preimage = data.preimage(branch, setting.domain, setting.tower)?;
    if preimage.is_zero() {
        let message = "the hodograph of this curve is zero: its data are those of a point";
        return Err(BuildFault::malformed(message));
    }
    let start = [start.real, start.imaginary];
    Ok(Coordinates {
        interpolant: Some(Interpolant { branch, choice }),
        ..Coordinates::pythagorean(preimage, &start, setting.domain)
    })
}
