use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

use crate::report::{Generator, Length, Summary};

/// A row of the table: a surface of a variant, or a variant that has none.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Row {
    /// From 1.
    pub(super) variant: usize,
    pub(super) file: String,
    #[serde(serialize_with = "in_order")]
    pub(super) parameters: Vec<(String, String)>,
    /// The exit status that a run of its own would end with.
    pub(super) status: u8,
    /// The codes of the variant's findings.
    pub(super) codes: Vec<&'static str>,
    #[serde(flatten)]
    pub(super) summary: Option<Summary>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) field: Option<Vec<Generator>>,
    #[serde(serialize_with = "by_curve", skip_serializing_if = "Vec::is_empty")]
    pub(super) lengths: Vec<Length>,
    /// The files of the surface, then those of the variant.
    pub(super) files: Vec<String>,
}

fn in_order<S: Serializer>(own: &[(String, String)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(own.iter().map(|(name, value)| (name, value)))
}

fn by_curve<S: Serializer>(own: &[Length], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(own.iter().map(|length| (&length.curve, length)))
}

impl Row {
    /// The names of the columns: a member of a member of the JSON object has a point in its name.
    pub(super) fn columns(parameters: &[String], curves: &[String]) -> Vec<String> {
        let fixed = |own: &[&str]| own.iter().map(|own| (*own).to_owned()).collect::<Vec<_>>();
        let mut columns = fixed(&["variant", "file"]);
        columns.extend(parameters.iter().map(|own| format!("parameters.{own}")));
        columns.extend(fixed(&[
            "status",
            "codes",
            "surface",
            "bidegree.u",
            "bidegree.v",
            "common_factor.u",
            "common_factor.v",
            "positive_weights",
            "poles",
            "regular",
            "rational_offset",
        ]));
        for curve in curves {
            columns.push(format!("lengths.{curve}.exact"));
            columns.push(format!("lengths.{curve}.decimal"));
        }
        columns.extend(fixed(&["field", "files"]));
        columns
    }

    /// The cells of the columns.
    pub(super) fn cells(&self, parameters: &[String], curves: &[String]) -> Vec<String> {
        let mut cells = vec![self.variant.to_string(), self.file.clone()];
        let values: BTreeMap<&str, &str> = self
            .parameters
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let value = |own: &String| values.get(own.as_str()).copied().unwrap_or_default();
        cells.extend(parameters.iter().map(|own| value(own).to_owned()));
        cells.push(self.status.to_string());
        cells.push(self.codes.join(" "));
        match &self.summary {
            Some(own) => {
                let [u, v] = own.bidegree;
                let factor = own.common_factor.map(|own| own.map(|own| own.to_string()));
                let [factor_u, factor_v] = factor.unwrap_or_default();
                cells.extend([own.surface.clone(), u.to_string(), v.to_string()]);
                cells.extend([factor_u, factor_v, own.positive_weights.to_string()]);
                cells.extend([own.poles.to_string(), own.regular.to_string()]);
                cells.push(own.rational_offset.to_string());
            }
            None => cells.extend(std::iter::repeat_n(String::new(), 9)),
        }
        for curve in curves {
            let length = self.lengths.iter().find(|own| own.curve == *curve);
            let length = length.map(|own| [own.exact.clone(), own.decimal.clone()]);
            cells.extend(length.unwrap_or_default());
        }
        let field = self.field.iter().flatten();
        let field = field.map(|own| format!("{} = √({})", own.name, own.square));
        cells.push(field.collect::<Vec<_>>().join(", "));
        cells.push(self.files.join(" "));
        cells
    }
}
