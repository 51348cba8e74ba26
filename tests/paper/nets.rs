//! Control nets of every planar case: exact, in 17 digits, and as the doubles of a written file.

use serde_json::Value;
use sweepc::check::Checked;
use sweepc::export::{self, Double};
use sweepc::net::ControlNet;
use sweepc::number::{Field, Real};
use sweepc::pipeline::Options;

use crate::reference::{Embedding, Examples, has_digits, items, ratio, surfaces, text};
use crate::support::Compiled;

pub(crate) fn net(surface: &Checked) -> ControlNet {
    let [zero, one] = [Real::zero(), Real::one()];
    let coordinates = surface.surface().coordinates().each_ref();
    ControlNet::bezier(coordinates, (&zero, &one), (&zero, &one)).unwrap()
}

/// The homogeneous control points of a case, i by i and j within i.
fn points(case: &Value, field: &Embedding) -> Vec<[Real; 4]> {
    let points = items(&case["net"]).iter().flat_map(items);
    let numbers = points.map(|own| {
        let parts: Vec<Real> = text(own).split("; ").map(|own| field.number(own)).collect();
        parts.try_into().unwrap()
    });
    numbers.collect()
}

fn indices(net: &ControlNet) -> impl Iterator<Item = (usize, usize)> {
    let columns = net.columns();
    (0..net.rows()).flat_map(move |i| (0..columns).map(move |j| (i, j)))
}

/// The factor between our control points and those of a case.
fn compare(net: &ControlNet, theirs: &[[Real; 4]]) -> Result<Real, String> {
    let ours: Vec<Real> = indices(net)
        .flat_map(|(i, j)| net.homogeneous(i, j))
        .collect();
    ratio(&ours, &theirs.concat())
}

/// Whether every weight and coordinate has the digits of the reference, where the first weight is
/// `scale`.
fn compare_digits(net: &ControlNet, scale: &Real, case: &Value) -> Result<(), String> {
    for (i, j) in indices(net) {
        let decimals = text(&case["decimals"][i][j]);
        let weight = net.weight(i, j) * scale;
        let numbers = [&weight].into_iter().chain(net.point(i, j));
        let mut decimals = decimals.split(' ');
        for number in numbers {
            let decimal = decimals.next().ok_or("too few decimals")?;
            if !has_digits(number, decimal) {
                return Err(format!("({i}, {j}): {number} for {decimal}"));
            }
        }
        if decimals.next().is_some() {
            return Err(format!("({i}, {j}): too many decimals"));
        }
    }
    Ok(())
}

#[test]
fn nets_are_the_reference() {
    let (data, mut examples) = (surfaces(), Examples::default());
    for case in items(&data["cases"]) {
        let id = text(&case["id"]);
        let (_, surface) = examples.case(case);
        let tower = surface.definition().tower.scratch();
        let field = Embedding::new(&data, text(&case["field"]), &tower);
        let (ours, theirs) = (net(surface), points(case, &field));
        assert_eq!(ours.rows(), items(&case["net"]).len(), "{id}");
        assert_eq!(ours.rows(), items(&case["decimals"]).len(), "{id}");
        compare(&ours, &theirs).unwrap_or_else(|own| panic!("{id}: {own}"));
        compare_digits(&ours, &theirs[0][0], case).unwrap_or_else(|own| panic!("{id}: {own}"));
    }
}

/// The doubles of a surface in a written file.
fn written(compiled: &Compiled, surface: &Checked) -> Value {
    let formats: Vec<_> = export::ALL
        .iter()
        .filter(|own| own.name == "json")
        .collect();
    let options = Options::default();
    let mut written = compiled
        .compilation
        .export(surface, &formats, "case", &options);
    let (_, exported) = written.next().unwrap();
    let file: Value = serde_json::from_slice(&exported.unwrap().bytes).unwrap();
    file["float"].clone()
}

fn same(double: &Value, exact: &Real) -> bool {
    let nearest = Double::nearest(exact).unwrap().value();
    double.as_f64().unwrap().to_bits() == nearest.to_bits()
}

#[test]
fn written_doubles_are_the_nearest_to_the_reference() {
    let (data, mut examples) = (surfaces(), Examples::default());
    for case in items(&data["cases"]) {
        let id = text(&case["id"]);
        let (compiled, surface) = examples.case(case);
        let tower = surface.definition().tower.scratch();
        let field = Embedding::new(&data, text(&case["field"]), &tower);
        let (file, theirs) = (written(compiled, surface), points(case, &field));
        let columns = items(&case["net"][0]).len();
        for (index, [weight, point @ ..]) in theirs.iter().enumerate() {
            let (i, j) = (index / columns, index % columns);
            let relative = weight / &theirs[0][0];
            assert!(same(&file["weights"][i][j], &relative), "{id} ({i}, {j})");
            for (axis, own) in point.iter().enumerate() {
                let double = &file["points"][i][j][axis];
                assert!(same(double, &(own / weight)), "{id} ({i}, {j})");
            }
        }
    }
}

/// A control point that is moved by a little, exactly or in its last digit.
#[test]
fn a_wrong_control_point_is_noticed() {
    let (data, mut examples) = (surfaces(), Examples::default());
    let case = items(&data["cases"]).iter().find(|own| own["id"] == "E2");
    let case = case.unwrap();
    let (_, surface) = examples.case(case);
    let tower = surface.definition().tower.scratch();
    let field = Embedding::new(&data, text(&case["field"]), &tower);
    let (ours, mut theirs) = (net(surface), points(case, &field));
    assert!(compare(&ours, &theirs).is_ok());
    let scale = theirs[0][0].clone();
    theirs[17][2] = &theirs[17][2] + &Real::ratio(1.into(), 1_000_003.into());
    assert!(compare(&ours, &theirs).is_err());
    assert!(compare_digits(&ours, &scale, case).is_ok());
    let mut perturbed = case.clone();
    let last = text(&case["decimals"][2][8]);
    perturbed["decimals"][2][8] =
        Value::from(last.replace("1.4876271939203857", "1.4876271939203858"));
    assert_ne!(perturbed, *case);
    assert!(compare_digits(&ours, &scale, &perturbed).is_err());
}
