//! The examples of the paper, against exact values from elsewhere.
//!
//! `seeds/farouki-nittler/reference.json` and `seeds/farouki-neff/interpolants.json` hold what an
//! independent program found, over generators of its own. Both numbers are brought into one field,
//! by exact square roots of those generators' squares, and compared there.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod hermite;
mod nets;
mod printed;
mod reference;
mod regularity;
#[path = "../support/mod.rs"]
mod support;
mod surfaces;
mod table;
