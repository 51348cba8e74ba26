//! The doubles of the workloads are those that three other programs agree on.
#![allow(missing_docs, reason = "tests state facts")]

#[path = "../benches/workloads/curves.rs"]
mod curves;
#[path = "../benches/workloads/record.rs"]
mod record;

use record::{Parsed, Set};

/// How many of the records up to a degree of the preimage have the doubles and the degrees that are
/// expected of them.
fn agrees(text: &str, greatest: usize) -> usize {
    let set: Result<Set, _> = serde_json::from_str(text);
    let set = set.unwrap_or_else(|own| unreachable!("{own}"));
    let mut count = 0;
    for record in set.cases.iter().filter(|own| own.m <= greatest) {
        let parsed = Parsed::new(record);
        let outcome = parsed.compile();
        let Some(expected) = &record.expected else {
            unreachable!("{} has no expectation", record.id);
        };
        assert_eq!(outcome.hash, expected.hash, "{}", record.id);
        assert_eq!(outcome.bidegree, expected.bidegree, "{}", record.id);
        // There a zero coefficient is counted as a factor at infinity.
        if !record.id.contains("prof-lowdeg") {
            assert_eq!(
                outcome.common_factor, expected.common_factor,
                "{}",
                record.id
            );
        }
        let curves = parsed.curves(&outcome);
        let mut times = outcome.times.iter().chain([&curves]);
        assert!(times.all(|own| own.as_secs() < 60));
        count += 1;
    }
    count
}

#[test]
fn paper_size() {
    let text = include_str!("../benches/workloads/W1.json");
    assert_eq!(agrees(text, usize::MAX), 5);
}

/// The sum that other programs found, to its last digit.
#[test]
fn a_million_points_with_normals() {
    let set: Result<Set, _> = serde_json::from_str(include_str!("../benches/workloads/W1.json"));
    let set = set.unwrap_or_else(|own| unreachable!("{own}"));
    let net = Parsed::new(&set.cases[0]).compile().net;
    let samples = sweepc::export::Samples::new(&net, [1_000, 1_000]);
    let points = samples.map(|own| own.points()).unwrap_or_default();
    assert_eq!(points.len(), 1_000_000);
    let sum: f64 = points.iter().flatten().sum();
    assert_eq!(format!("{sum:.5}"), "1461166.44418");
}

/// Points and normals in doubles are near the exact ones, at the ends and within.
#[test]
fn samples_are_near_exact_points() {
    let set: Result<Set, _> = serde_json::from_str(include_str!("../benches/workloads/W1.json"));
    let set = set.unwrap_or_else(|own| unreachable!("{own}"));
    for record in &set.cases {
        let net = Parsed::new(record).compile().net;
        // more than one group of parameters along v, the last not full
        let (rows, columns) = (5, 41);
        let samples = sweepc::export::Samples::new(&net, [rows, columns]);
        let points = samples.map(|own| own.points()).unwrap_or_default();
        assert_eq!(points.len(), rows * columns);
        let part = |index: usize, count: usize| {
            let text = format!("{index}/{}", count - 1);
            text.parse().unwrap_or_else(|()| unreachable!("{text}"))
        };
        for (index, sampled) in points.iter().enumerate() {
            let (u, v) = (part(index / columns, rows), part(index % columns, columns));
            let exact = net.de_casteljau(&u, &v);
            let exact = exact.unwrap_or_else(|| unreachable!("{} has no poles", record.id));
            for (own, exact) in sampled.iter().zip(&exact) {
                let exact = sweepc::export::Double::nearest(exact).map(|own| own.value());
                assert!(
                    exact.is_some_and(|exact| (own - exact).abs() < 1e-12),
                    "{}",
                    record.id
                );
            }
            let length: f64 = sampled[3..].iter().map(|own| own * own).sum();
            // Other kinds have points without a normal.
            let is_regular = ["W1-oriented", "W1-offset"].contains(&record.id.as_str());
            assert!(!is_regular || (length - 1.0).abs() < 1e-12, "{}", record.id);
        }
    }
}

#[test]
fn growing_degrees() {
    let text = include_str!("../benches/workloads/W2s.json");
    assert_eq!(agrees(text, 64), 24);
}

#[test]
fn growing_degrees_of_dyadic_numbers() {
    let text = include_str!("../benches/workloads/W2ds.json");
    assert_eq!(agrees(text, 64), 12);
}

#[test]
fn planted_factors() {
    let text = include_str!("../benches/workloads/W3.json");
    assert_eq!(agrees(text, 32), 20);
}

#[test]
fn a_parameter_study() {
    let text = include_str!("../benches/workloads/W5.json");
    assert_eq!(agrees(text, usize::MAX), 1_000);
}

#[test]
fn square_root_fields() {
    let text = include_str!("../benches/workloads/W6.json");
    assert_eq!(agrees(text, 16), 32);
}

#[test]
fn degenerate_inputs() {
    let text = include_str!("../benches/workloads/W7.json");
    assert_eq!(agrees(text, usize::MAX), 65);
}
