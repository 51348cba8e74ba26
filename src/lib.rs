//! The exact sweep compiler.
//!
//! A swept surface is written in the notation of the papers; `sweepc` expands it over an exact
//! field to homogeneous polynomials W, X, Y, Z in u and v, proves its degrees, common factors and
//! poles, and compiles it to a rational Bézier patch whose every double is the one nearest to the
//! exact value.
//!
#![doc = include_str!("ARCHITECTURE.md")]

pub mod check;
pub mod cli;
pub mod curve;
pub mod diag;
pub mod export;
pub mod net;
pub mod number;
pub mod pipeline;
pub mod poly;
pub mod report;
pub mod sema;
pub mod sweep;
pub mod syntax;
