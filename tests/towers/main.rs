//! Laws of the square-root towers and of the polynomials over them, by roads that share no code
//! with the crate: fixed-point balls, schoolbook sums, ranks of exponent vectors.
//!
//! The cases are the same in every run. `SWEEPC_CASES=20` runs twenty times as many.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_arithmetic,
    missing_docs,
    reason = "a failing law may end the test"
)]

mod ball;
mod cases;
mod display;
mod enclosures;
mod fields;
mod images;
mod numbers;
mod polynomials;
mod roots;
mod rounding;
