//! The doubles of the workloads are those that three other programs agree on.
#![allow(missing_docs, reason = "tests state facts")]

#[path = "../benches/workloads/record.rs"]
mod record;

use record::{Parsed, Set};

/// The records of a set; those with a great degree belong to the benchmark.
fn agrees(text: &str, wanted: impl Fn(&str) -> bool) -> usize {
    let set: Result<Set, _> = serde_json::from_str(text);
    let set = set.unwrap_or_else(|own| unreachable!("{own}"));
    let mut count = 0;
    for record in set.cases.iter().filter(|own| wanted(&own.id)) {
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
    assert_eq!(
        agrees(include_str!("../benches/workloads/W1.json"), |_| true),
        5
    );
}

#[test]
fn growing_degrees() {
    let small = |id: &str| ["-m2-", "-m4-", "-m8-"].iter().any(|m| id.contains(m));
    assert_eq!(
        agrees(include_str!("../benches/workloads/W2s.json"), small),
        12
    );
}

#[test]
fn planted_factors() {
    let small = |id: &str| ["-m2-", "-m4-", "-m8-"].iter().any(|m| id.contains(m));
    assert!(agrees(include_str!("../benches/workloads/W3.json"), small) >= 4);
}

#[test]
fn a_parameter_study() {
    let count = agrees(include_str!("../benches/workloads/W5.json"), |_| true);
    assert_eq!(count, 1_000);
}

#[test]
fn square_root_fields() {
    let small = |id: &str| ["-m2-", "-m4-"].iter().any(|m| id.contains(m));
    assert_eq!(
        agrees(include_str!("../benches/workloads/W6.json"), small),
        16
    );
}

#[test]
fn degenerate_inputs() {
    assert_eq!(
        agrees(include_str!("../benches/workloads/W7.json"), |_| true),
        65
    );
}
