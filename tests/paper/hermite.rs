//! The four Hermite interpolants of Examples 2 and 4, their properties, and the choice among them.

use serde_json::Value;
use sweepc::curve::{
    Branch, Choice, HermiteData, Interval, Preimage, bending_energy, rotation_index,
};
use sweepc::number::{Complex, Field, Rational, Real, Tower};
use sweepc::poly::{UniPoly, bernstein, real_roots};

use crate::nets::net;
use crate::reference::{Embedding, has_digits, interpolants, items, text};
use crate::support::compile;

fn complex(pair: &Value, field: &Embedding) -> Complex {
    let [real, imaginary] = field.numbers(pair).try_into().unwrap();
    Complex::new(real, imaginary)
}

/// Hermite data of an example, and the first end point.
pub(crate) fn hermite_data(data: &Value) -> (HermiteData, Complex) {
    let number = |text: &Value| text.as_str().unwrap().parse::<Real>().unwrap();
    let point = |name: &str| Complex::new(number(&data[name][0]), number(&data[name][1]));
    let start = point("start");
    let own = HermiteData {
        first: point("start_derivative"),
        last: point("end_derivative"),
        chord: point("end").minus(&start),
    };
    (own, start)
}

/// A reference branch beside ours, both in one field.
struct Interpolant {
    field: Embedding,
    preimage: Preimage,
    speed: UniPoly<Real>,
    modulus: Real,
    start: Complex,
}

impl Interpolant {
    fn new(all: &Value, data: &Value, reference: &Value) -> Self {
        let (hermite, start) = hermite_data(data);
        let tower = Tower::default();
        let branch = Branch::of_word(text(&reference["branch"])).unwrap();
        let preimage = hermite.preimage(branch, &Interval::unit(), &tower).unwrap();
        let speed = preimage.speed(&tower).unwrap();
        let modulus = preimage.factor().modulus(&tower).unwrap();
        let degree = tower.degree();
        let field = Embedding::new(all, text(&reference["field"]), &tower);
        assert_eq!((degree, tower.degree()), (field.degree(), field.degree()));
        Self {
            field,
            preimage,
            speed,
            modulus,
            start,
        }
    }

    /// The Bernstein coefficients of ω.
    fn coefficients(&self) -> [Complex; 3] {
        let [real, imaginary] = self.preimage.parts().map(|own| on_unit(own, 2));
        let mut pairs = real.into_iter().zip(imaginary);
        std::array::from_fn(|_| {
            let (real, imaginary) = pairs.next().unwrap();
            Complex::new(real, imaginary)
        })
    }

    /// The control points of the quintic.
    fn control_points(&self) -> Vec<[Real; 2]> {
        let [x, y] = self.preimage.hodograph();
        let integral = |own: &UniPoly<Real>, start: &Real| {
            on_unit(&(&own.antiderivative() + &UniPoly::constant(start)), 5)
        };
        let x = integral(&x, &self.start.real);
        let y = integral(&y, &self.start.imaginary);
        x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
    }

    fn polynomial(&self, list: &Value) -> UniPoly<Real> {
        UniPoly::from_coefficients(&self.field.numbers(list))
    }
}

pub(crate) fn on_unit(polynomial: &UniPoly<Real>, degree: usize) -> Vec<Real> {
    bernstein(polynomial, degree, &Real::zero(), &Real::one())
}

/// Applies a check to every branch of every example.
fn each_branch(check: impl Fn(&Interpolant, &Value)) {
    let all = interpolants();
    let mut count = 0;
    for example in items(&all["examples"]) {
        for reference in items(&example["branches"]) {
            check(
                &Interpolant::new(&all, &example["data"], reference),
                reference,
            );
            count += 1;
        }
    }
    assert_eq!(count, 8);
}

/// ω is that of the reference up to a complex constant, g ω² is the same.
#[test]
fn preimages_are_the_reference() {
    each_branch(|own, reference| {
        let ours = own.coefficients();
        let theirs: Vec<Complex> = items(&reference["preimage"])
            .iter()
            .map(|pair| complex(pair, &own.field))
            .collect();
        assert_eq!(theirs.len(), 3);
        assert!(!ours[0].is_zero() && !theirs[0].is_zero());
        for (our, their) in ours.iter().zip(&theirs) {
            assert_eq!(our.times(&theirs[0]), their.times(&ours[0]));
        }
        let square = |factor: &Complex, own: &Complex| factor.times(&own.times(own));
        let factor = complex(&reference["factor"], &own.field);
        assert_eq!(
            square(own.preimage.factor(), &ours[0]),
            square(&factor, &theirs[0])
        );
    });
}

#[test]
fn control_points_are_the_reference() {
    each_branch(|own, reference| {
        let points = own.control_points();
        assert_eq!(points.len(), items(&reference["control_points"]).len());
        for (index, point) in points.iter().enumerate() {
            let expected = own.field.numbers(&reference["control_points"][index]);
            assert_eq!(point.as_slice(), expected, "{index}");
            for (axis, number) in point.iter().enumerate() {
                let decimal = text(&reference["decimals"][index][axis]);
                assert!(has_digits(number, decimal), "{number} for {decimal}");
            }
        }
    });
}

/// The same curves by way of the language: the control points of a wall over each.
#[test]
fn walls_over_the_interpolants_have_their_control_points() {
    let all = interpolants();
    let pair = |own: &Value| format!("({}, {})", text(&own[0]), text(&own[1]));
    for example in items(&all["examples"]) {
        let names = ["start", "start_derivative", "end", "end_derivative"];
        let data = names.map(|own| pair(&example["data"][own])).join(", ");
        for reference in items(&example["branches"]) {
            let branch = text(&reference["branch"]);
            let curve = format!("ph_hermite({data}, branch: \"{branch}\")");
            let compiled = compile(&format!(
                "sweep c(v) in xy = {curve}\nsurface R = c(v) + u k"
            ));
            let surface = compiled.surface();
            let tower = surface.definition().tower.scratch();
            let field = Embedding::new(&all, text(&reference["field"]), &tower);
            let net = net(surface);
            assert_eq!((net.rows(), net.columns()), (2, 6), "{curve}");
            for (index, point) in items(&reference["control_points"]).iter().enumerate() {
                let expected = field.numbers(point);
                assert_eq!(net.point(0, index)[..2], expected, "{curve} {index}");
            }
        }
    }
}

/// σ, s and H = κσ², and the total arc length.
#[test]
fn polynomials_are_the_reference() {
    each_branch(|own, reference| {
        assert_eq!(own.speed, own.polynomial(&reference["speed"]));
        let length = own.speed.antiderivative();
        assert_eq!(length, own.polynomial(&reference["arc_length"]));
        let turning = own.preimage.turning();
        let turning = turning.scale(&(&own.modulus * &Real::from(2)));
        assert_eq!(turning, own.polynomial(&reference["curvature_numerator"]));
        let total = length.evaluate(&Real::one());
        assert_eq!(total, own.field.number(text(&reference["length"])));
        assert!(has_digits(&total, text(&reference["length_decimal"])));
    });
}

/// 4(1 + √2)/3 and 5/3, for the branches of the paper.
#[test]
fn arc_lengths_of_the_paper() {
    let mut found = Vec::new();
    for example in items(&interpolants()["examples"]) {
        let (hermite, _) = hermite_data(&example["data"]);
        let (tower, unit) = (Tower::default(), Interval::unit());
        let (branch, _) = hermite.best(&unit, &tower).unwrap();
        let preimage = hermite.preimage(branch, &unit, &tower).unwrap();
        let speed = preimage.speed(&tower).unwrap();
        found.push((speed.antiderivative().evaluate(&Real::one()), tower));
    }
    let [(second, tower), (fourth, _)] = <[_; 2]>::try_from(found).unwrap();
    let root = tower.square_root(&Real::from(2)).unwrap();
    let four_thirds = Real::ratio(4.into(), 3.into());
    assert_eq!(second, &four_thirds * &(&Real::one() + &root));
    assert_eq!(fourth, Real::ratio(5.into(), 3.into()));
}

/// Whether both bounds of a number round to these digits. A number with few digits is exact: it must
/// have zeros behind them.
fn encloses(bounds: &[Rational; 2], decimal: &str) -> bool {
    let digits = decimal.split_once('.').unwrap().1.len();
    let zeros = if digits < 10 { 20 - digits } else { 0 };
    let digits = u32::try_from(digits + zeros).unwrap();
    let expected = format!("{decimal}{}", "0".repeat(zeros));
    bounds.iter().all(|own| own.decimal(digits) == expected)
}

#[test]
fn rotation_indices_and_energies_are_the_reference() {
    let unit = Interval::unit();
    each_branch(|own, reference| {
        let index = rotation_index(&own.preimage, &unit, 160).ends();
        let decimal = text(&reference["rotation_index"]);
        assert!(encloses(&index, decimal), "{index:?} for {decimal}");
        let energy = bending_energy(&own.preimage, &unit, 90).unwrap();
        let decimal = text(&reference["bending_energy"]);
        assert!(encloses(&energy, decimal), "{energy:?} for {decimal}");
    });
    let quarter = [1, 1].map(|one| Rational::new(one.into(), 4.into()));
    assert!(encloses(&quarter, "0.25") && !encloses(&quarter, "0.24"));
}

/// Inflections to the last digit, and the sense of rotation where there are none.
#[test]
fn inflections_are_the_reference() {
    let fine = Real::ratio(1.into(), 10.into()).power(30).unwrap();
    each_branch(|own, reference| {
        let turning = own.preimage.turning();
        let roots = real_roots(&turning, &Real::zero(), &Real::one());
        let expected = items(&reference["inflections"]);
        assert_eq!(roots.len(), expected.len());
        for (mut root, decimal) in roots.into_iter().zip(expected) {
            root.refine(&fine);
            assert!(has_digits(root.lower(), text(decimal)));
            assert!(has_digits(root.upper(), text(decimal)));
        }
        if expected.is_empty() {
            let turns: Real = text(&reference["turns"]).parse().unwrap();
            let index: Real = text(&reference["rotation_index"]).parse().unwrap();
            assert_eq!(turns.absolute(), index);
            assert_eq!(turning.evaluate(&Real::zero()).sign(), turns.sign());
        }
    });
}

/// Least absolute rotation index, winding number 0 and least bending energy choose the same curve,
/// which is not the shortest.
#[test]
fn the_best_branch_is_the_good_one() {
    for example in items(&interpolants()["examples"]) {
        let branches = items(&example["branches"]);
        let best = branches.iter().find(|own| own["best"] == true).unwrap();
        let (hermite, _) = hermite_data(&example["data"]);
        let found = hermite.best(&Interval::unit(), &Tower::default());
        let branch = Branch::of_word(text(&best["branch"])).unwrap();
        assert_eq!(found, Ok((branch, Choice::LeastRotation)));
        let number = |own: &Value, name: &str| text(&own[name]).parse::<Real>().unwrap();
        let mut shorter = 0;
        for other in branches.iter().filter(|own| own["best"] == false) {
            assert_ne!(other["winding"], 0);
            for name in ["rotation_index", "bending_energy"] {
                assert!(number(best, name) < number(other, name));
            }
            shorter +=
                usize::from(number(other, "length_decimal") < number(best, "length_decimal"));
        }
        assert_eq!((&best["winding"], shorter), (&Value::from(0), 2));
    }
}

/// A wrong coefficient in any of the tables is noticed.
#[test]
fn a_wrong_table_is_noticed() {
    let all = interpolants();
    let example = &all["examples"][0];
    let reference = &example["branches"][0];
    let own = Interpolant::new(&all, &example["data"], reference);
    for name in ["speed", "arc_length", "curvature_numerator"] {
        let mut list = reference[name].clone();
        let last = items(&list).len() - 1;
        list[last] = Value::from(format!("{}1", text(&list[last])));
        assert_ne!(own.polynomial(&list), own.polynomial(&reference[name]));
    }
    // The other embedding of √(40√2 − 35) is the branch `+-`: the field has both.
    let other = &example["branches"][1];
    assert_ne!(own.speed, own.polynomial(&other["speed"]));
    let total = own.speed.antiderivative().evaluate(&Real::one());
    assert!(!has_digits(&total, "3.21895141649746006506891829896"));
}
