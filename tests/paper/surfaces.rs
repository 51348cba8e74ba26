//! Homogeneous coordinates, common factors and degrees of every planar case.

use serde_json::{Value, json};
use sweepc::check::Checked;
use sweepc::number::{Basis, Field, Real};
use sweepc::poly::{BiDegree, BiPoly, UniPoly};

use crate::reference::{Embedding, Examples, NAMES, items, ratio, surfaces, text};

fn pair(own: Option<BiDegree>) -> Value {
    own.map_or(Value::Null, |own| json!([own.u, own.v]))
}

/// Bidegrees under the names of the coordinates.
fn named(own: [Option<BiDegree>; 4]) -> Value {
    NAMES.into_iter().zip(own.map(pair)).collect()
}

/// The terms that are not zero: coordinate, power of u, power of v.
pub(crate) type Place = (usize, usize, usize);

pub(crate) fn terms(coordinates: &[BiPoly<Real>; 4]) -> (Vec<Place>, Vec<Real>) {
    let mut found = (Vec::new(), Vec::new());
    for (index, own) in coordinates.iter().enumerate() {
        for (i, row) in own.rows().iter().enumerate() {
            for (j, number) in row.coefficients().into_iter().enumerate() {
                if !number.is_zero() {
                    found.0.push((index, i, j));
                    found.1.push(number);
                }
            }
        }
    }
    found
}

fn expected(case: &Value, field: &Embedding) -> (Vec<Place>, Vec<Real>) {
    let mut found = (Vec::new(), Vec::new());
    for (index, name) in NAMES.iter().enumerate() {
        for term in text(&case[name]).split("; ") {
            let (powers, number) = term.split_once(": ").unwrap();
            let (i, j) = powers.split_once(' ').unwrap();
            found
                .0
                .push((index, i.parse().unwrap(), j.parse().unwrap()));
            found.1.push(field.number(number));
        }
    }
    found
}

/// The factor between our coordinates and those of a case; what differs otherwise.
fn compare(surface: &Checked, case: &Value, field: &Embedding) -> Result<Real, String> {
    let ours = terms(surface.surface().coordinates());
    let theirs = expected(case, field);
    if ours.0 != theirs.0 {
        return Err(format!("terms {:?} for {:?}", ours.0, theirs.0));
    }
    ratio(&ours.1, &theirs.1)
}

/// The degree over ℚ of the field that the coefficients of a surface need.
fn degree(surface: &Checked) -> usize {
    let coordinates = surface.surface().coordinates().iter();
    let rows: Vec<UniPoly<Real>> = coordinates.flat_map(BiPoly::rows).collect();
    Basis::of(rows.iter().flat_map(UniPoly::numerators)).degree()
}

#[test]
fn coordinates_are_the_reference() {
    let (data, mut examples) = (surfaces(), Examples::default());
    assert_eq!(items(&data["cases"]).len(), 22);
    for case in items(&data["cases"]) {
        let id = text(&case["id"]);
        let (_, surface) = examples.case(case);
        let tower = surface.definition().tower.scratch();
        let before = tower.degree();
        let field = Embedding::new(&data, text(&case["field"]), &tower);
        assert_eq!(tower.degree(), before, "{id}: another field");
        assert_eq!(degree(surface), field.degree(), "{id}: a larger field");
        let factor = compare(surface, case, &field).unwrap_or_else(|own| panic!("{id}: {own}"));
        // Ours are positive at the first corner; the reference keeps the sign of its formula.
        let positive = text(&case["weights"]) == "positive";
        assert_eq!(factor.sign().is_gt(), positive, "{id}");
        assert!(surface.weights().unwrap().is_positive(), "{id}");
        assert!(surface.poles().is_empty(), "{id}");
    }
}

#[test]
fn degrees_are_the_reference() {
    let (data, mut examples) = (surfaces(), Examples::default());
    for case in items(&data["cases"]) {
        let id = text(&case["id"]);
        let (_, surface) = examples.case(case);
        let expansion = surface.expansion();
        assert_eq!(named(expansion.constructed), case["constructed"], "{id}");
        assert_eq!(
            named(surface.surface().bidegrees()),
            case["reduced"],
            "{id}"
        );
        assert_eq!(expansion.common_factor, BiPoly::one(), "{id}");
        assert!(expansion.coprimality.is_some(), "{id}");
        let patch = surface.surface().bidegree();
        assert_eq!(pair(Some(patch)), case["patch"], "{id}");
        let affine = surface.affine().map(|own| {
            let above = pair(own.numerator);
            json!([above, pair(Some(own.denominator))])
        });
        let affine: Value = ["x", "y", "z"].into_iter().zip(affine).collect();
        assert_eq!(affine, case["lowest_terms"], "{id}");
    }
}

/// Whatever coefficient of the reference is changed, the comparison fails.
#[test]
fn a_wrong_coefficient_is_noticed() {
    let (data, mut examples) = (surfaces(), Examples::default());
    let case = items(&data["cases"]).iter().find(|own| own["id"] == "E4");
    let case = case.unwrap();
    let (_, surface) = examples.case(case);
    let tower = surface.definition().tower.scratch();
    let field = Embedding::new(&data, text(&case["field"]), &tower);
    let mut tried = 0;
    for name in NAMES {
        let original = text(&case[name]);
        for (index, term) in original.split("; ").enumerate() {
            let (place, number) = term.split_once(": ").unwrap();
            let (first, rest) = number.split_once(' ').unwrap_or((number, ""));
            let wrong = &first.parse::<Real>().unwrap() + &Real::ratio(1.into(), 1_000_003.into());
            let mut terms: Vec<String> = original.split("; ").map(str::to_owned).collect();
            terms[index] = format!("{place}: {wrong} {rest}");
            let mut perturbed = case.clone();
            perturbed[name] = Value::from(terms.join("; "));
            assert!(
                compare(surface, &perturbed, &field).is_err(),
                "{name} {term}"
            );
            tried += 1;
        }
    }
    assert_eq!(tried, 10 + 18 + 14 + 5);
    assert!(compare(surface, case, &field).is_ok());
    // The conjugate embedding, which the positive root excludes, is noticed as well.
    let mut conjugate = case.clone();
    let original = text(&case["W"]);
    conjugate["W"] = Value::from(original.replace("-14 2", "-14 -2"));
    assert_ne!(conjugate["W"], case["W"]);
    assert!(compare(surface, &conjugate, &field).is_err());
}
