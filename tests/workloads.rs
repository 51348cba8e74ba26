//! The doubles of the workloads are those that three other programs agree on.
#![allow(missing_docs, reason = "tests state facts")]

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
        let outcome = Parsed::new(record).compile();
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
        assert!(outcome.times.iter().all(|own| own.as_secs() < 60));
        count += 1;
    }
    count
}

#[test]
fn paper_size() {
    let text = include_str!("../benches/workloads/W1.json");
    assert_eq!(agrees(text, usize::MAX), 5);
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
