//! Diagnostics: where in the source, which rule, what to do about it.
//!
//! This floor imports nothing of ours. It knows text and places, not mathematics.

mod clipped;
mod code;
mod diagnostic;
mod limits;
mod preview;
mod render;
mod source;
mod span;

pub use code::{Code, Severity};
pub use diagnostic::{Diagnostic, Diagnostics, Fix};
pub use limits::Limits;
pub use render::{Style, render_json, render_text};
pub use source::{SourceFile, SourceMap};
pub use span::{FileId, Span};
