//! Files read back by other means: the written numbers are those of the net.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod exchange;
mod nets;

use std::collections::HashMap;

use exchange::{Exchange, bits};
use nets::{number, patch, read_json};
use serde_json::Value;
use sweepc::diag::Code;
use sweepc::export::{ALL, Context, ExportFault, Exported, Fidelity, RoundedNet, StepSchema};
use sweepc::net::{ControlNet, Knots, Model, Part};
use sweepc::number::{Field, Real, Unit};

fn export(format: &str, net: &ControlNet, context: &Context) -> Result<Exported, ExportFault> {
    let exporter = ALL.iter().find(|own| own.name == format).unwrap();
    let part = Part::of_net(context.name(), net.clone());
    (exporter.write)(&Model::new(vec![part]), context)
}

fn text(format: &str, net: &ControlNet) -> String {
    let exported = export(format, net, &Context::new("file", "R")).unwrap();
    String::from_utf8(exported.bytes).unwrap()
}

/// Nets that every format carries, and in how many faces they come as STEP; 0 for a surface
/// without edges.
fn carried() -> Vec<(&'static str, ControlNet, usize)> {
    vec![
        ("quarter cylinder", patch(&nets::quarter_cylinder()), 1),
        ("circle over cubic", patch(&nets::circle_over_cubic()), 1),
        ("polynomial", patch(&nets::polynomial()), 1),
        ("degree 25", patch(&nets::of_degree(25)), 1),
        ("cone", patch(&nets::cone()), 1),
        ("tube, equal ends", patch(&nets::tube("1 1 -1")), 2),
        ("tube, unequal ends", patch(&nets::tube("1 1")), 2),
        ("sphere", nets::sphere(), 8),
        ("hemisphere", nets::hemisphere(), 4),
        ("cylinder", nets::cylinder(), 4),
        ("torus", nets::torus(), 16),
        ("lune", nets::lune(), 2),
        ("teardrop", nets::teardrop(), 1),
        ("folded", nets::folded(), 0),
        ("moebius", nets::moebius(), 2),
        ("touching corners", nets::touching_corners(), 2),
        ("petal", nets::petal(), 2),
        ("nearly closed", nets::nearly_closed(), 4),
        ("bag", patch(&nets::bag()), 0),
        ("apex at a corner", patch(&nets::corner_apex()), 0),
        (
            "eighths",
            nets::on(&nets::circle_over_cubic(), ("1/8", "3/8"), ("-1/4", "1")),
            1,
        ),
    ]
}

#[test]
fn the_net_is_the_surface() {
    let domain = (("-1/3", "5/7"), ("1/2", "2"));
    for coordinates in [
        nets::quarter_cylinder(),
        nets::circle_over_cubic(),
        nets::polynomial(),
        nets::negative_weight(),
        nets::of_degree(26),
        nets::cone(),
        nets::tube("1 1"),
    ] {
        let net = nets::on(&coordinates, domain.0, domain.1);
        for (u, v) in [("-1/3", "1/2"), ("5/7", "2"), ("0", "1"), ("1/9", "7/5")] {
            let (u, v) = (number(u), number(v));
            let [w, rest @ ..] = coordinates.each_ref().map(|own| own.evaluate(&u, &v));
            let expected = rest.map(|own| own.times(&w.inverse().unwrap()));
            assert_eq!(net.de_casteljau(&u, &v), Some(expected));
        }
        assert_eq!(net.weight(0, 0), &Real::one());
        assert_eq!(net.de_casteljau(&number("1"), &number("1")), None);
    }
}

#[test]
fn several_spans_keep_to_their_circle() {
    let net = nets::cylinder();
    for at in ["0", "1/3", "1", "5/2", "4"] {
        let [x, y, _] = net.de_casteljau(&number(at), &number("1/2")).unwrap();
        assert_eq!(x.times(&x).plus(&y.times(&y)), Real::one(), "at {at}");
    }
}

#[test]
fn impossible_nets_are_refused() {
    let pole = nets::sum(&[("0 1", "1")]);
    let one = nets::sum(&[("1", "1")]);
    let (from, to) = (number("0"), number("1"));
    let domain = (&from, &to);
    assert_eq!(
        ControlNet::bezier([&pole, &one, &one, &one], domain, domain),
        None
    );
    assert_eq!(ControlNet::bezier([&one; 4], (&to, &from), domain), None);
    assert_eq!(Knots::new(1, &["0", "1", "1"].map(number)), None);
    assert_eq!(Knots::new(1, &["0", "0", "2", "1", "1"].map(number)), None);
}

#[test]
fn a_point_at_infinity_holds_its_direction() {
    let net = patch(&[
        nets::sum(&[("1 -2 1", "1")]),
        nets::sum(&[("0 2 -2", "1")]),
        nets::sum(&[("1", "0 1")]),
        nets::sum(&[("0 0 3", "1")]),
    ]);
    assert!(net.weight(2, 1).is_zero() && !net.all_positive());
    assert_eq!(net.point(2, 1), &["0", "1", "3"].map(number));
    assert_eq!(net.point(1, 0), &["1", "0", "0"].map(number));
    assert_eq!(
        export("step", &net, &Context::new("f", "R"))
            .unwrap_err()
            .code,
        Code::E0304
    );
}

#[test]
fn json_read_again_is_the_exact_net() {
    for coordinates in [nets::negative_weight(), nets::of_degree(26)] {
        let net = patch(&coordinates);
        assert_eq!(read_json(&text("json", &net)), net);
    }
    for (name, net, _) in carried() {
        let exported = export("json", &net, &Context::new("file", "R")).unwrap();
        assert_eq!(exported.fidelity, Fidelity::Exact);
        assert_eq!(
            read_json(&String::from_utf8(exported.bytes).unwrap()),
            net,
            "{name}"
        );
    }
}

#[test]
fn json_layout_is_one_row_a_line() {
    let context = Context::new("file", "σ \"R\"");
    let exported = export("json", &patch(&nets::quarter_cylinder()), &context).unwrap();
    let expected = r#"{
  "format": "sweepc-net/1",
  "name": "σ \"R\"",
  "field": [],
  "degree": [2,1],
  "knots": {
    "u": ["0", "0", "0", "1", "1", "1"],
    "v": ["0", "0", "1", "1"]
  },
  "weights": [
    ["1", "1"],
    ["1", "1"],
    ["2", "2"]
  ],
  "points": [
    [["1", "0", "0"], ["1", "0", "1"]],
    [["1", "1", "0"], ["1", "1", "1"]],
    [["0", "1", "0"], ["0", "1", "1"]]
  ],
  "float": {
    "knots": {
      "u": [0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
      "v": [0.0, 0.0, 1.0, 1.0]
    },
    "weights": [
      [1.0, 1.0],
      [1.0, 1.0],
      [2.0, 2.0]
    ],
    "points": [
      [[1.0, 0.0, 0.0], [1.0, 0.0, 1.0]],
      [[1.0, 1.0, 0.0], [1.0, 1.0, 1.0]],
      [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0]]
    ]
  }
}
"#;
    assert_eq!(String::from_utf8(exported.bytes).unwrap(), expected);
}

#[test]
fn step_and_json_have_the_same_doubles() {
    for (name, net, faces) in carried() {
        let patches = Exchange::read(&text("step", &net)).patches();
        assert_eq!(patches.len(), faces.max(1), "{name}");
        for patch in &patches {
            assert!(patch.is_part_of(&net), "{name}");
        }
        let [patch] = patches.as_slice() else {
            continue;
        };
        let json: Value = serde_json::from_str(&text("json", &net)).unwrap();
        assert_eq!(patch.points, bits(&json["float"]["points"]), "{name}");
        assert_eq!(patch.weights, bits(&json["float"]["weights"]), "{name}");
        let rounded = RoundedNet::new(&net).unwrap();
        let own = rounded.points.iter().flatten().flatten();
        let own: Vec<_> = own.map(|own| own.value().to_bits()).collect();
        assert_eq!(own, patch.points, "{name}");
    }
}

#[test]
fn step_faces_have_the_edges_that_readers_expect() {
    // Edges, their uses, vertices. Edges that bound two faces are there once.
    let expected = HashMap::from([
        ("cone", (3, 3, 3)),
        ("circle over cubic", (3, 3, 3)),
        ("tube, equal ends", (6, 8, 4)),
        ("tube, unequal ends", (6, 8, 4)),
        ("cylinder", (12, 16, 8)),
        ("hemisphere", (8, 12, 5)),
        ("sphere", (12, 24, 6)),
        ("torus", (32, 64, 16)),
        ("lune", (5, 6, 4)),
        ("teardrop", (4, 4, 3)),
        ("folded", (0, 0, 0)),
        ("moebius", (6, 8, 4)),
        ("touching corners", (7, 8, 5)),
        // Folded onto itself: the same face twice, which is no neighbour of itself.
        ("petal", (6, 6, 6)),
        ("nearly closed", (13, 16, 10)),
        ("bag", (0, 0, 0)),
        ("apex at a corner", (0, 0, 0)),
    ]);
    for (name, net, faces) in carried() {
        let exported = export("step", &net, &Context::new("file", "R")).unwrap();
        let step = Exchange::read(std::str::from_utf8(&exported.bytes).unwrap());
        let count = |name: &str| step.all(name).len();
        let seen = (
            count("EDGE_CURVE"),
            count("ORIENTED_EDGE"),
            count("VERTEX_POINT"),
        );
        assert_eq!(seen, *expected.get(name).unwrap_or(&(4, 4, 4)), "{name}");
        assert_eq!(count("ADVANCED_FACE"), faces, "{name}");
        assert_eq!(count("GEOMETRIC_SET"), usize::from(faces == 0), "{name}");
        let codes: Vec<_> = exported.warnings.iter().map(|own| own.code).collect();
        assert_eq!(codes.contains(&Code::W1009), faces == 0, "{name}");
        assert_eq!(count("SHAPE_DEFINITION_REPRESENTATION"), 1);
        let shells = (count("OPEN_SHELL"), count("CLOSED_SHELL"));
        let expected = match name {
            "sphere" | "torus" => (0, 1),
            // No two sides, or the same face twice.
            "moebius" | "petal" => (2, 0),
            _ => (usize::from(faces > 0), 0),
        };
        assert_eq!(shells, expected, "{name}");
    }
}

#[test]
fn step_reals_have_a_point_and_no_lower_case() {
    let net = nets::on(&nets::polynomial(), ("0", "1/1000000"), ("-1", "0"));
    let step = text("step", &net);
    assert!(step.contains("E-"), "{step}");
    for item in step.split(['(', ')', ',']) {
        if item.starts_with(|first: char| first == '-' || first.is_ascii_digit()) {
            assert_ne!(item, "-0.");
            let real = item.contains('.') && !item.contains('e');
            assert!(
                real || item.parse::<u32>().is_ok() || item.contains(' '),
                "{item}"
            );
        }
    }
}

#[test]
fn names_and_units_arrive() {
    let net = patch(&nets::quarter_cylinder());
    let mut context = Context::new("file", "Rσ");
    for (unit, mark) in [
        (Unit::Millimetre, "SI_UNIT(.MILLI.,.METRE.)"),
        (Unit::Centimetre, "SI_UNIT(.CENTI.,.METRE.)"),
        (Unit::Metre, "SI_UNIT($,.METRE.)"),
        (Unit::Inch, "CONVERSION_BASED_UNIT('INCH',"),
    ] {
        context.unit = unit;
        let step = export("step", &net, &context).unwrap();
        let step = String::from_utf8(step.bytes).unwrap();
        Exchange::read(&step);
        assert!(step.contains(mark), "{step}");
        assert!(step.contains("FILE_NAME('file-R\\X2\\03C3\\X0\\.step','1970-01-01T00:00:00'"));
        assert!(step.contains("PRODUCT('R\\X2\\03C3\\X0\\',"));
    }
}

#[test]
fn the_protocol_is_in_the_header_and_in_the_product() {
    let net = patch(&nets::quarter_cylinder());
    for (step_schema, header, context) in [
        (
            StepSchema::Ap203,
            "CONFIG_CONTROL_DESIGN",
            "MECHANICAL_CONTEXT",
        ),
        (StepSchema::Ap214, "AUTOMOTIVE_DESIGN", "PRODUCT_CONTEXT"),
        (
            StepSchema::Ap242,
            "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF",
            "PRODUCT_CONTEXT",
        ),
    ] {
        let context_of_file = Context {
            step_schema,
            ..Context::new("file", "R")
        };
        let step = export("step", &net, &context_of_file).unwrap();
        let step = String::from_utf8(step.bytes).unwrap();
        assert!(step.contains(&format!("FILE_SCHEMA(('{header}")), "{step}");
        let read = Exchange::read(&step);
        let count = |name: &str| read.all(name).len();
        assert_eq!((count(context), count("ADVANCED_FACE")), (1, 1));
        // The schema of AP203 asks for these, and the others do not have them.
        let own = usize::from(step_schema == StepSchema::Ap203);
        for (name, times) in [
            ("CC_DESIGN_APPROVAL", 1),
            ("APPROVAL_DATE_TIME", 1),
            ("APPROVAL_PERSON_ORGANIZATION", 1),
            ("CC_DESIGN_SECURITY_CLASSIFICATION", 1),
            ("CC_DESIGN_DATE_AND_TIME_ASSIGNMENT", 2),
            ("CC_DESIGN_PERSON_AND_ORGANIZATION_ASSIGNMENT", 4),
            ("PRODUCT_CATEGORY_RELATIONSHIP", 1),
        ] {
            assert_eq!(count(name), own * times, "{name}");
        }
    }
}

/// A plane square whose last weight or point is changed.
fn square(weight: &str, point: [&str; 3]) -> ControlNet {
    let knots = Knots::bezier(1, &number("0"), &number("1")).unwrap();
    let weights = ["1", "1", "1", weight].map(number).to_vec();
    let points = [["0", "0", "0"], ["0", "1", "0"], ["1", "0", "0"], point];
    let points = points.map(|own| own.map(number)).to_vec();
    ControlNet::new(knots.clone(), knots, weights, points).unwrap()
}

#[test]
fn what_readers_drop_is_refused_or_named() {
    let step = |net: &ControlNet| -> Result<Vec<Code>, ExportFault> {
        let exported = export("step", net, &Context::new("file", "R"))?;
        let codes: Vec<_> = exported.warnings.iter().map(|own| own.code).collect();
        Ok(codes)
    };
    let refused = |net: &ControlNet| step(net).unwrap_err().code;
    let flat = ["1", "1", "0"];

    assert_eq!(step(&patch(&nets::negative_weight())), Ok(vec![]));
    assert_eq!(refused(&square("0", flat)), Code::E0304);
    assert_eq!(refused(&patch(&nets::of_degree(26))), Code::E0305);
    assert_eq!(refused(&patch(&nets::line())), Code::E0305);
    assert_eq!(refused(&square("1", ["1", "1e309", "0"])), Code::E0306);
    let message = step(&square("1", ["1", "-1e400", "0"]))
        .unwrap_err()
        .message;
    assert_eq!(
        message,
        "y of control point (1, 1) is about 1e400, beyond the last double"
    );
    assert_eq!(step(&square("1000", flat)), Ok(vec![]));
    assert_eq!(step(&square("1000.1", flat)), Ok(vec![Code::W1006]));
    assert_eq!(step(&square("1e-6", flat)), Ok(vec![Code::W1006]));
    assert_eq!(refused(&square("999999/1000000000000", flat)), Code::E0304);
    let allowed = Context {
        any_weight_ratio: true,
        ..Context::new("file", "R")
    };
    assert!(export("step", &square("1e-7", flat), &allowed).is_ok());
    assert_eq!(refused(&square("1e-400", flat)), Code::E0304);
    assert_eq!(
        export("step", &square("1e-400", flat), &allowed)
            .unwrap_err()
            .code,
        Code::E0306
    );
    assert_eq!(
        step(&square("1", ["1", "1", "1e-310"])),
        Ok(vec![Code::W1005])
    );
    assert_eq!(
        step(&square("1", ["1.00000000000000000001", "0", "0"])),
        Ok(vec![Code::W1008])
    );
}

#[test]
fn rounding_is_measured() {
    let fidelity = |net: &ControlNet| {
        export("step", net, &Context::new("f", "R"))
            .unwrap()
            .fidelity
    };
    assert_eq!(fidelity(&square("1/2", ["1", "1", "1/4"])), Fidelity::Exact);
    let net = square("1/3", ["1", "1", "1/10"]);
    let Fidelity::Rounded {
        max_error: Some(bound),
    } = fidelity(&net)
    else {
        panic!("a third is not a double");
    };
    assert!(
        bound > number("1e-18") && bound < number("1e-16"),
        "{bound}"
    );
    // The surface of the doubles stays within the bound.
    let rounded = RoundedNet::new(&net).unwrap();
    let weights = rounded.weights.iter().flatten().map(|own| own.exact());
    let points = rounded
        .points
        .iter()
        .flatten()
        .map(|own| own.map(|own| own.exact()));
    let (knots_u, knots_v) = (net.knots_u().clone(), net.knots_v().clone());
    let doubles = ControlNet::new(knots_u, knots_v, weights.collect(), points.collect()).unwrap();
    for (u, v) in [("1", "1"), ("1/2", "1/2"), ("9/10", "4/5")] {
        let (u, v) = (number(u), number(v));
        let exact = net.de_casteljau(&u, &v).unwrap();
        for (own, other) in exact.iter().zip(doubles.de_casteljau(&u, &v).unwrap()) {
            let apart = own.minus(&other);
            assert!(apart <= bound && apart.negated() <= bound);
        }
    }
}

#[test]
fn short_and_distant_domains_are_counted_from_zero() {
    let net = patch(&nets::circle_over_cubic());
    for (from, to) in [
        ("0", "1e-9"),
        ("0", "1e9"),
        ("1e9", "1000000001"),
        ("-1e20", "-99999999999999999999"),
    ] {
        let knots = Knots::bezier(2, &number(from), &number(to)).unwrap();
        let moved = net.with_knots(knots, net.knots_v().clone()).unwrap();
        assert_eq!(text("step", &moved), text("step", &net));
    }
}
