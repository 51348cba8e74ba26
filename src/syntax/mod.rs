//! Text to tree.
//!
//! [`decode`] turns the bytes of a file into text, [`parse`] turns text into a
//! [`Document`](ast::Document), and a [`Formatter`] turns that into text again. None of them knows
//! what a name means, and [`parse`] never fails: what it cannot read it reports, and it goes on at
//! the next declaration.

pub mod ast;
mod characters;
mod decode;
mod format;
pub mod lexer;
mod parser;

pub use characters::canonical_name;
pub use decode::decode;
pub use format::{Formatter, Reading, Spelling};
pub use parser::parse;
