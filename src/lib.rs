//! sweepc
#![doc = include_str!("ARCHITECTURE.md")]

pub mod diag;
pub mod export;
pub mod net;
pub mod number;
pub mod curve;
pub mod poly;
pub mod sweep;
pub mod sema;
pub mod syntax;
