//! Names and types: the bridge from the tree of a file to curves and surface expressions.
//!
//! [`lower`] resolves names, decides which `NAME (…)` are applications, checks types, builds the
//! curves and unfolds functions and constructions. It reports every finding it can and keeps what
//! is sound.

mod apply;
mod bare;
mod call;
mod circle;
mod constructor;
mod curve;
mod decimal_comma;
mod definition;
mod definitions;
mod expectation;
mod expression;
mod joined;
mod library;
mod lowerer;
mod names;
mod numeral;
mod polynomial;
mod product;
mod program;
mod property;
mod scope;
mod spelling;
mod surface;
mod undeclared;
mod unknown;
mod value;

pub use call::BUILT_IN;
pub use expectation::QUERIES;
pub use library::Library;
pub use lowerer::{RESERVED, Sources, lower};
pub use names::Names;
pub use program::Program;
pub use spelling::nearest;
