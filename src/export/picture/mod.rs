//! Pictures of surfaces: a drawing with hidden lines removed, and a page with a viewer.
//!
//! A picture is for the eye. Its lines are drawn in doubles, from control points that are each
//! rounded once; what it says in numbers is exact.

mod approx_surface;
mod camera;
mod contour;
mod figure;
mod grid;
mod html;
mod occluder;
mod orientation;
mod shade;
mod spline;
mod stage;
mod stroke;
mod svg;
mod vector;
mod view;

pub(super) use html::EXPORTER as HTML;
pub(super) use svg::EXPORTER as SVG;
pub use view::View;
