//! Files of the exact formats read back by small readers of their own: the numbers are those of
//! the net, and what the formats promise in common holds for all.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a file that cannot be read has failed"
)]

mod archive;
mod iges;
mod laws;
mod meshes;
#[path = "../nets/mod.rs"]
mod nets;
mod objects;
mod outside;
mod sides;
mod surface;
mod text;
mod triangles;

use sweepc::export::{ALL, Context, ExportFault, Exported};
use sweepc::net::{ControlNet, Model, Part};

/// The model of one surface.
fn model(net: &ControlNet) -> Model {
    Model::new(vec![Part::of_net("R", net.clone())])
}

/// What a format makes of a model.
fn write(format: &str, model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let exporter = ALL.iter().find(|own| own.name == format).unwrap();
    (exporter.write)(model, context)
}

/// The file of one surface.
fn bytes(format: &str, net: &ControlNet) -> Vec<u8> {
    let exported = write(format, &model(net), &Context::new("file", "R"));
    exported.unwrap().bytes
}

/// The text file of one surface.
fn file(format: &str, net: &ControlNet) -> String {
    String::from_utf8(bytes(format, net)).unwrap()
}

/// Nets that every format carries as one patch.
fn simple() -> Vec<ControlNet> {
    vec![
        nets::patch(&nets::quarter_cylinder()),
        nets::patch(&nets::circle_over_cubic()),
        nets::patch(&nets::polynomial()),
        nets::patch(&nets::of_degree(25)),
        nets::patch(&nets::cone()),
        nets::teardrop(),
        nets::on(&nets::circle_over_cubic(), ("1/7", "3/7"), ("-1/3", "1")),
        nets::on(&nets::polynomial(), ("0", "1/1000000"), ("-1", "0")),
    ]
}
