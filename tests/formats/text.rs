//! The four JSON formats, as their libraries take the numbers out of them.

use serde_json::Value;
use sweepc::net::ControlNet;
use sweepc::number::Field;

use crate::surface::{Surface, bits};
use crate::{file, nets, simple};

fn numbers(value: &Value) -> Vec<u64> {
    let items = value.as_array().unwrap();
    items
        .iter()
        .map(|own| bits(own.as_f64().unwrap()))
        .collect()
}

fn count(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap()).unwrap()
}

/// Points in rows, each an object with x, y, z, w.
fn named(value: &Value) -> Vec<Vec<u64>> {
    let rows = value.as_array().unwrap().iter();
    let points = rows.flat_map(|row| row.as_array().unwrap());
    let coordinate = |own: &Value, name: &str| bits(own[name].as_f64().unwrap());
    points
        .map(|own| {
            ["x", "y", "z", "w"]
                .map(|name| coordinate(own, name))
                .to_vec()
        })
        .collect()
}

fn parsed(format: &str, net: &ControlNet) -> Value {
    serde_json::from_str(&file(format, net)).unwrap()
}

/// Nets of any weights but 0, of any degree, of any number of spans.
fn carried() -> Vec<ControlNet> {
    let mut list = simple();
    list.extend([
        nets::patch(&nets::negative_weight()),
        nets::patch(&nets::of_degree(60)),
        nets::patch(&nets::tube("1 1")),
        nets::cylinder(),
        nets::torus(),
    ]);
    list
}

#[test]
fn geomdl_has_points_and_weights() {
    for net in carried() {
        let file = parsed("geomdl", &net);
        assert_eq!(
            (&file["shape"]["type"], count(&file["shape"]["count"])),
            (&"surface".into(), 1)
        );
        let own = &file["shape"]["data"][0];
        assert_eq!(
            (own["name"].as_str(), own["rational"].as_bool()),
            (Some("R"), Some(true))
        );
        assert_eq!(
            (count(&own["size_u"]), count(&own["size_v"])),
            (net.rows(), net.columns())
        );
        let controls = &own["control_points"];
        let points = controls["points"].as_array().unwrap().iter().map(numbers);
        let weights = numbers(&controls["weights"]);
        let read = Surface {
            degrees: [&own["degree_u"], &own["degree_v"]].map(count),
            knots: [&own["knotvector_u"], &own["knotvector_v"]].map(numbers),
            points: points
                .zip(weights)
                .map(|(mut point, weight)| {
                    point.push(weight);
                    point
                })
                .collect(),
        };
        assert_eq!(read, Surface::affine(&net));
    }
}

#[test]
fn three_has_points_with_weights() {
    for net in carried() {
        let own = parsed("three", &net);
        let read = Surface {
            degrees: [&own["degree1"], &own["degree2"]].map(count),
            knots: [&own["knots1"], &own["knots2"]].map(numbers),
            points: named(&own["controlPoints"]),
        };
        assert_eq!(read, Surface::affine(&net));
    }
}

#[test]
fn verb_has_products() {
    for net in carried() {
        let own = parsed("verb", &net);
        let rows = own["controlPoints"].as_array().unwrap().iter();
        let points = rows.flat_map(|row| row.as_array().unwrap());
        let read = Surface {
            degrees: [&own["degreeU"], &own["degreeV"]].map(count),
            knots: [&own["knotsU"], &own["knotsV"]].map(numbers),
            points: points.map(numbers).collect(),
        };
        assert_eq!(read, Surface::premultiplied(&net));
    }
}

#[test]
fn truck_has_products() {
    for net in carried() {
        let own = parsed("truck", &net);
        let knots = [&own["knot_vecs"][0], &own["knot_vecs"][1]].map(numbers);
        let sizes = [net.rows(), net.columns()];
        let read = Surface {
            degrees: [0, 1].map(|axis| knots[axis].len() - sizes[axis] - 1),
            knots,
            points: named(&own["control_points"]),
        };
        assert_eq!(read, Surface::premultiplied(&net));
    }
}

#[test]
fn a_point_at_infinity_is_a_product() {
    let net = nets::patch(&[
        nets::sum(&[("1 -2 2", "1")]),
        nets::sum(&[("0 2 -2", "1")]),
        nets::sum(&[("1", "0 1")]),
        nets::sum(&[("0 0 3", "1")]),
    ]);
    assert!(net.weights().iter().any(Field::is_zero));
    let rows = parsed("verb", &net);
    let middle = numbers(&rows["controlPoints"][1][0]);
    assert_eq!(middle, [1.0, 0.0, 0.0, 0.0].map(bits));
    // Points are not at infinity in the patch of higher degree that stands for the net.
    let elevated = parsed("three", &net);
    assert_eq!(
        (count(&elevated["degree1"]), count(&elevated["degree2"])),
        (3, 1)
    );
}
