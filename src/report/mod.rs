//! The degree report: what the paper should have said.

mod curve;
mod html;
mod json;
mod markdown;
mod report;
mod summary;
mod text;

pub use curve::CurveReport;
pub use html::render_html;
pub use json::render_json;
pub use markdown::render_markdown;
pub use report::{Decision, Generator, Report, SurfaceReport};
pub use summary::{Length, Summary};
pub use text::render_text;
