//! Written files as other parsers read them.

#![allow(
    dead_code,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    unreachable_pub,
    reason = "shared by several test files"
)]

use std::collections::HashMap;

use ruststep::ast::{EntityInstance, Name, Parameter, Record};
use serde_json::Value;

/// The bits of all numbers in nested lists, in order.
pub fn bits(value: &Value) -> Vec<u64> {
    match value {
        Value::Array(items) => items.iter().flat_map(bits).collect(),
        other => vec![other.as_f64().unwrap().to_bits()],
    }
}

/// The entities of an exchange file as another parser reads them: records by name and number.
pub struct Exchange {
    records: HashMap<u64, Vec<Record>>,
}

impl Exchange {
    pub fn read(text: &str) -> Self {
        let exchange = ruststep::parser::parse(text).unwrap();
        assert_eq!(exchange.header.len(), 3);
        let entities = exchange.data[0].entities.iter().map(|own| match own {
            EntityInstance::Simple { id, record } => (*id, vec![record.clone()]),
            EntityInstance::Complex { id, subsuper } => {
                let names: Vec<_> = subsuper.0.iter().map(|own| &own.name).collect();
                assert!(names.is_sorted(), "{names:?}");
                (*id, subsuper.0.clone())
            }
        });
        Self {
            records: entities.collect(),
        }
    }

    pub fn all(&self, name: &str) -> Vec<&Record> {
        let records = self.records.values().flatten();
        records.filter(|own| own.name == name).collect()
    }

    /// The bits of all reals in a parameter; references to points are followed.
    pub fn bits(&self, parameter: &Parameter) -> Vec<u64> {
        match parameter {
            Parameter::Real(value) => vec![value.to_bits()],
            Parameter::List(items) => items.iter().flat_map(|own| self.bits(own)).collect(),
            Parameter::Ref(Name::Entity(id)) => self.bits(&self.records[id][0].parameter),
            _ => Vec::new(),
        }
    }

    /// The bits of the points and of the weights of the one surface in the file; the weights of a
    /// polynomial one are 1.
    pub fn surface(&self) -> (Vec<u64>, Vec<u64>) {
        if let Some(spline) = self.all("B_SPLINE_SURFACE").first() {
            let weights = self.all("RATIONAL_B_SPLINE_SURFACE")[0];
            let points = self.bits(&attributes(spline)[2]);
            return (points, self.bits(&weights.parameter));
        }
        let spline = self.all("B_SPLINE_SURFACE_WITH_KNOTS")[0];
        let points = self.bits(&attributes(spline)[3]);
        let count = points.len() / 3;
        (points, vec![1_f64.to_bits(); count])
    }
}

pub fn attributes(record: &Record) -> &[Parameter] {
    match &record.parameter {
        Parameter::List(items) => items,
        other => panic!("{other:?}"),
    }
}
