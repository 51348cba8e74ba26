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
use sweepc::export::{Double, RoundedNet};
use sweepc::net::ControlNet;
use sweepc::number::Real;

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

    /// The faces' surfaces, in order of their numbers; weights of polynomial ones are 1.
    pub fn patches(&self) -> Vec<Patch> {
        let mut ids: Vec<_> = self.records.keys().collect();
        ids.sort();
        let patches = ids
            .into_iter()
            .filter_map(|id| self.patch(&self.records[id]));
        patches.collect()
    }

    fn patch(&self, records: &[Record]) -> Option<Patch> {
        let of = |name: &str| records.iter().find(|own| own.name == name);
        let knotted = attributes(of("B_SPLINE_SURFACE_WITH_KNOTS")?);
        // Degrees and points stand before the knots, in an entity of their own or in the same.
        let (spline, knots) = match of("B_SPLINE_SURFACE") {
            Some(spline) => (attributes(spline), knotted),
            None => (&knotted[1..], &knotted[8..]),
        };
        let points = self.bits(&spline[2]);
        let weights = match of("RATIONAL_B_SPLINE_SURFACE") {
            Some(rational) => self.bits(&rational.parameter),
            None => vec![1_f64.to_bits(); points.len() / 3],
        };
        let ends = |own: &Parameter| {
            let bits = self.bits(own);
            [bits[0], bits[bits.len() - 1]].map(f64::from_bits)
        };
        Some(Patch {
            u: ends(&knots[2]),
            v: ends(&knots[3]),
            points,
            weights,
        })
    }

    /// The bits of the points and of the weights of the one surface in the file.
    pub fn surface(&self) -> (Vec<u64>, Vec<u64>) {
        let mut patches = self.patches();
        assert_eq!(patches.len(), 1);
        let patch = patches.remove(0);
        (patch.points, patch.weights)
    }
}

/// A Bézier patch of a file: its domain, and the bits of its points and weights.
pub struct Patch {
    pub u: [f64; 2],
    pub v: [f64; 2],
    pub points: Vec<u64>,
    pub weights: Vec<u64>,
}

impl Patch {
    /// Whether its numbers are the doubles of a net's restriction to its domain, as the polar form
    /// gives it.
    pub fn is_part_of(&self, net: &ControlNet) -> bool {
        let exact = |own: [f64; 2]| own.map(|own| format!("{own:?}").parse::<Real>().unwrap());
        let (u, v) = (exact(self.u), exact(self.v));
        let Some(part) = net.restricted((&u[0], &u[1]), (&v[0], &v[1])) else {
            return false;
        };
        let rounded = RoundedNet::new(&part).unwrap();
        let points = rounded.points.iter().flatten().flatten();
        let weights = rounded.weights.iter().flatten();
        let bits = |own: &Double| own.value().to_bits();
        points.map(bits).eq(self.points.iter().copied())
            && weights.map(bits).eq(self.weights.iter().copied())
    }
}

pub fn attributes(record: &Record) -> &[Parameter] {
    match &record.parameter {
        Parameter::List(items) => items,
        other => panic!("{other:?}"),
    }
}
