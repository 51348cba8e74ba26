//! What follows from the printed data: the examples of `seeds/farouki-nittler/examples.json`, each
//! compiled from its own source.

use serde_json::{Value, json};
use sweepc::curve::Interval;
use sweepc::number::{Field, Real, Tower};
use sweepc::poly::UniPoly;

use crate::hermite::{hermite_data, on_unit};
use crate::reference::{Embedding, NAMES, items, ratio, text};
use crate::support::compile;
use crate::surfaces::{Place, terms};

const EXAMPLES: &str = include_str!("../../seeds/farouki-nittler/examples.json");

fn examples() -> Value {
    serde_json::from_str(EXAMPLES).unwrap()
}

/// The terms of homogeneous coordinates, whose bidegrees are stated beside them.
fn expected(homogeneous: &Value, field: &Embedding) -> (Vec<Place>, Vec<Real>) {
    let mut found = (Vec::new(), Vec::new());
    for (index, name) in NAMES.iter().enumerate() {
        let own = &homogeneous[name];
        let mut degree = [0, 0];
        for term in items(&own["terms"]) {
            let power = |at: usize| usize::try_from(term[at].as_u64().unwrap()).unwrap();
            let (i, j) = (power(0), power(1));
            degree = [degree[0].max(i), degree[1].max(j)];
            found.0.push((index, i, j));
            found.1.push(field.sum(text(&term[2])));
        }
        assert_eq!(json!(degree), own["bidegree"]);
    }
    found
}

#[test]
fn surfaces_are_the_derived_ones() {
    let mut count = 0;
    for example in items(&examples()["examples"]) {
        let lines: Vec<&str> = items(&example["source"]).iter().map(text).collect();
        let compiled = compile(&lines.join("\n"));
        let derived = &example["derived"];
        let homogeneous: Vec<&Value> = match derived["surfaces"].as_array() {
            Some(surfaces) => surfaces.iter().map(|own| &own["homogeneous"]).collect(),
            None => vec![&example["printed"]["homogeneous"]],
        };
        assert!(!compiled.compilation.diagnostics.has_errors());
        assert_eq!(homogeneous.len(), compiled.compilation.surfaces.len());
        for (index, homogeneous) in homogeneous.into_iter().enumerate() {
            let surface = compiled.compilation.surfaces[index].as_ref().unwrap();
            let tower = surface.definition().tower.scratch();
            let field = Embedding::of_generators(&derived["field"], &tower);
            let theirs = expected(homogeneous, &field);
            let ours = terms(surface.surface().coordinates());
            assert_eq!(ours.0, theirs.0, "{} {index}", example["example"]);
            let factor = ratio(&ours.1, &theirs.1);
            assert!(factor.is_ok(), "{} {index}: {factor:?}", example["example"]);
            count += 1;
        }
    }
    assert_eq!(count, 7);
}

/// Control points, polynomials and arc length of the curves of Examples 2 and 4.
#[test]
fn curves_are_the_derived_ones() {
    let mut count = 0;
    for example in items(&examples()["examples"]) {
        let derived = &example["derived"]["sweep"];
        if !derived.is_object() {
            continue;
        }
        let (hermite, start) = hermite_data(&example["printed"]["sweep"]["hermite"]);
        let (tower, unit) = (Tower::default(), Interval::unit());
        let (branch, _) = hermite.best(&unit, &tower).unwrap();
        let preimage = hermite.preimage(branch, &unit, &tower).unwrap();
        let speed = preimage.speed(&tower).unwrap();
        let field = Embedding::of_generators(&derived["field"], &tower);
        let polynomial = |name: &str| {
            let list = items(&derived[name]).iter();
            let list: Vec<Real> = list.map(|own| field.sum(text(own))).collect();
            UniPoly::from_coefficients(&list)
        };
        let hodograph = preimage.hodograph();
        for (axis, from) in [&start.real, &start.imaginary].into_iter().enumerate() {
            let own = &hodograph[axis].antiderivative() + &UniPoly::constant(from);
            assert_eq!(own, polynomial(["x", "y"][axis]));
            let points = items(&derived["bezier"]).iter();
            let points: Vec<Real> = points.map(|own| field.sum(text(&own[axis]))).collect();
            assert_eq!(on_unit(&own, 5), points);
        }
        assert_eq!(speed, polynomial("parametric_speed"));
        assert_eq!(speed.antiderivative(), polynomial("arc_length"));
        let total = speed.antiderivative().evaluate(&Real::one());
        assert_eq!(total, field.sum(text(&derived["length"])));
        let modulus = preimage.factor().modulus(&tower).unwrap();
        let turning = preimage.turning().scale(&(&modulus * &Real::from(2)));
        assert_eq!(turning, polynomial("curvature_numerator"));
        count += 1;
    }
    assert_eq!(count, 2);
}
