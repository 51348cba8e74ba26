use crate::diag::Limits;
use crate::number::{Real, Unit};
use crate::report::Report;

use super::{Guide, StepSchema, View};

/// What a file says beside the model.
#[derive(Clone, Debug)]
pub struct Context<'a> {
    /// The name of the surface in the source; none for all surfaces of the source in one file.
    pub surface: Option<&'a str>,
    /// The name of the source file without its extension.
    pub stem: &'a str,
    /// What the number 1 means as a length.
    pub unit: Unit,
    /// Whether weights may differ by any factor, not only by
    /// [10⁶](Context::GREATEST_WEIGHT_RATIO).
    pub any_weight_ratio: bool,
    /// Where pictures are seen from.
    pub view: View,
    /// The curves that pictures show beside the surface.
    pub guides: Vec<Guide>,
    /// The degree report of the surfaces, for pages that show it.
    pub report: Option<Report>,
    /// The application protocol of STEP files.
    pub step_schema: StepSchema,
    /// Whether surfaces in IGES are trimmed by their boundary curves.
    pub iges_trimmed: bool,
    /// The greatest distance between a surface and its triangles; none for a thousandth of the
    /// model's size.
    pub chord: Option<Real>,
    /// What files may ask for.
    pub limits: Limits,
}

impl<'a> Context<'a> {
    /// The quotient of the greatest weight by the least above which kernels lose accuracy.
    pub const GREATEST_WEIGHT_RATIO: i64 = 1_000_000;

    /// A surface of a file, in millimetres.
    #[must_use]
    pub fn new(stem: &'a str, surface: &'a str) -> Self {
        Self {
            surface: Some(surface),
            ..Self::whole(stem)
        }
    }

    /// All surfaces of a file, in millimetres.
    #[must_use]
    pub fn whole(stem: &'a str) -> Self {
        Self {
            surface: None,
            stem,
            unit: Unit::default(),
            any_weight_ratio: false,
            view: View::default(),
            guides: Vec::new(),
            report: None,
            step_schema: StepSchema::default(),
            iges_trimmed: false,
            chord: None,
            limits: Limits::default(),
        }
    }

    /// The name of what is written: the surface, or the source file.
    #[must_use]
    pub fn name(&self) -> &'a str {
        self.surface.unwrap_or(self.stem)
    }

    /// The name of the written file without its extension: `STEM-SURFACE`, or `STEM` for all
    /// surfaces.
    #[must_use]
    pub fn file_stem(&self) -> String {
        match self.surface {
            Some(surface) => format!("{}-{surface}", self.stem),
            None => self.stem.to_owned(),
        }
    }
}
