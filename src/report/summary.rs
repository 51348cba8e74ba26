use serde::Serialize;

use super::Report;
use super::report::{Decision, Generator};

/// What a table of many surfaces says of one; each fact is that of the report.
#[derive(Debug, Clone, Serialize)]
pub struct Summary {
    /// The name of the surface.
    pub surface: String,
    /// The bidegree of the patch.
    pub bidegree: [usize; 2],
    /// The bidegree of the common factor that was removed.
    pub common_factor: Option<[usize; 2]>,
    /// Whether all weights of the one patch are positive.
    pub positive_weights: bool,
    /// How many poles there are.
    pub poles: usize,
    /// Whether the surface is regular.
    pub regular: Decision,
    /// Whether its offsets are rational.
    pub rational_offset: Decision,
}

/// The total arc length of a curve, as it is and in 30 digits.
#[derive(Debug, Clone, Serialize)]
pub struct Length {
    /// The name of the curve.
    #[serde(skip)]
    pub curve: String,
    /// The number, spelled with the generators of the field.
    pub exact: String,
    /// Its first digits.
    pub decimal: String,
}

impl Report {
    /// A summary of each surface.
    #[must_use]
    pub fn summaries(&self) -> Vec<Summary> {
        let surfaces = self.surfaces.iter();
        let summaries = surfaces.map(|own| Summary {
            surface: own.name.clone(),
            bidegree: own.patch.bidegree,
            common_factor: own.common_factor.bidegree,
            positive_weights: own.weights.positive,
            poles: own.poles.len(),
            regular: own.regular,
            rational_offset: own.rational_offset,
        });
        summaries.collect()
    }

    /// The lengths of the curves that have a rational one.
    #[must_use]
    pub fn lengths(&self) -> Vec<Length> {
        let lengths = self.curves.iter().filter_map(|own| {
            let length = own.arc_length.as_ref()?;
            Some(Length {
                curve: own.name.clone(),
                exact: length.exact.clone(),
                decimal: length.decimal.clone(),
            })
        });
        lengths.collect()
    }

    /// The generators of the field that numbers are spelled with.
    #[must_use]
    pub fn field(&self) -> &[Generator] {
        &self.field
    }
}
