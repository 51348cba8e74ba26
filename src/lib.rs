//! sweepc
#![doc = include_str!("ARCHITECTURE.md")]

pub mod curve;
pub mod diag;
pub mod export;
pub mod net;
pub mod number;
pub mod poly;
pub mod sema;
pub mod sweep;
pub mod syntax;
