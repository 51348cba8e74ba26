use crate::number::{Field, Real};
use crate::poly::{UniPoly, from_bernstein};

use super::{Arguments, Coordinates, Interval, Kind, Shape, Slot};

/// `ph(start: P, preimage: [(a, b), …], scale: λ)`: the plane Pythagorean-hodograph curve with
/// x′ + iy′ = λ w², w the complex polynomial with these Bernstein coefficients a + ib on the
/// domain.   [farouki-nittler, eq. 2]
///
/// Of degree 2m + 1 for m + 1 coefficients; σ = |λ| |w|².
pub(super) const KIND: Kind = Kind {
    name: "ph",
    usage: "ph(start: P, preimage: [(a, b), …]) or with scale: λ",
    slots: &[
        Slot {
            label: Some("start"),
            shape: Shape::Point,
            optional: false,
        },
        Slot {
            label: Some("preimage"),
            shape: Shape::Pairs,
            optional: false,
        },
        Slot {
            label: Some("scale"),
            shape: Shape::Number,
            optional: true,
        },
    ],
    build,
};

fn build(arguments: &Arguments, domain: &Interval) -> Result<Coordinates, String> {
    let start = arguments.point(0);
    if start.len() != 2 {
        return Err("a `ph` curve lies in a plane: its start is a pair".to_owned());
    }
    let preimage = arguments.points(1);
    let part = |index: usize| -> UniPoly<Real> {
        let coefficients: Vec<Real> = preimage.iter().map(|pair| pair[index].clone()).collect();
        from_bernstein(&coefficients, domain.start(), domain.end())
    };
    let (real, imaginary) = (part(0), part(1));
    let one = Real::one();
    let scale = arguments.number(2).unwrap_or(&one);
    if (real.is_zero() && imaginary.is_zero()) || scale.is_zero() {
        return Err("the hodograph of this curve is zero".to_owned());
    }
    let two = Real::from(2);
    let x = &(&real * &real) - &(&imaginary * &imaginary);
    let y = (&real * &imaginary).scale(&two);
    let integrate = |slope: &UniPoly<Real>, from: &Real| {
        let rise = slope.scale(scale).antiderivative();
        let offset = from - &rise.evaluate(domain.start());
        &rise + &UniPoly::constant(&offset)
    };
    Ok(Coordinates {
        weight: UniPoly::one(),
        numerators: vec![integrate(&x, &start[0]), integrate(&y, &start[1])],
    })
}
