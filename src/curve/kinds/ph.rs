use crate::curve::Preimage;
use crate::number::{Complex, Field, Real};
use crate::poly::{UniPoly, from_bernstein};

use super::{Arguments, BuildFault, Coordinates, Kind, Setting, Shape, Slot};

/// `ph(start: P, preimage: [(a, b), …], scale: λ)`: the plane Pythagorean-hodograph curve with
/// x′ + iy′ = λ w², w the complex polynomial with these Bernstein coefficients a + ib on the
/// domain.   [farouki-nittler, eq. 2]
///
/// Of degree 2m + 1 for m + 1 coefficients; σ = |λ| |w|².
pub(super) const KIND: Kind = Kind {
    name: "ph",
    usage: "ph(start: P, preimage: [(a, b), …]) or with scale: λ",
    slots: &[
        Slot::labelled("start", Shape::Point),
        Slot::labelled("preimage", Shape::Pairs),
        Slot::optional("scale", Shape::Number),
    ],
    build,
};

fn build(arguments: &Arguments, setting: &Setting<'_>) -> Result<Coordinates, BuildFault> {
    let [x, y] = arguments.point(0) else {
        let message = "a `ph` curve lies in a plane: its start is a pair";
        return Err(BuildFault::malformed(message));
    };
    let coefficients = arguments.points(1);
    let part = |index: usize| -> UniPoly<Real> {
        let coefficients = coefficients.iter().map(|pair| &pair[index]);
        from_bernstein(coefficients, setting.domain.start(), setting.domain.end())
    };
    let scale = arguments.number(2).cloned().unwrap_or_else(Real::one);
    let preimage = Preimage::new(Complex::of_real(scale), part(0), part(1));
    if preimage.is_zero() {
        let message = "the hodograph of this curve is zero";
        return Err(BuildFault::malformed(message));
    }
    let start = [x.clone(), y.clone()];
    Ok(Coordinates::pythagorean(preimage, &start, setting.domain))
}
