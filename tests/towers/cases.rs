//! How many cases a law is tried on.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

/// Tries a law on so many cases, times the environment variable `SWEEPC_CASES`.
pub(crate) fn for_all<S: Strategy>(
    cases: u32,
    strategy: S,
    law: impl Fn(S::Value) -> Result<(), TestCaseError>,
) {
    let factor = std::env::var("SWEEPC_CASES").ok();
    let factor = factor.and_then(|own| own.parse().ok()).unwrap_or(1);
    let config = Config {
        cases: cases.saturating_mul(factor),
        failure_persistence: None,
        max_shrink_iters: 512,
        ..Config::default()
    };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    if let Err(failure) = TestRunner::new_with_rng(config, rng).run(&strategy, law) {
        panic!("{failure}");
    }
}
