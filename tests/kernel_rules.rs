//! What readers of STEP damage or drop without a word, rule by rule: refused with the way out, or
//! written so that it arrives.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod example_files;
mod exchange;
mod nets;

use exchange::{Exchange, attributes};
use nets::patch;
use ruststep::ast::Parameter;
use sweepc::diag::Code;
use sweepc::export::{ALL, Context, ExportFault};
use sweepc::net::{ControlNet, Model, Part};
use sweepc::number::Unit;

fn step_in(nets: &[ControlNet], unit: Unit) -> Result<String, ExportFault> {
    let exporter = ALL.iter().find(|own| own.name == "step").unwrap();
    let parts = nets.iter().map(|own| Part::of_net("R", own.clone()));
    let context = Context {
        unit,
        ..Context::new("file", "R")
    };
    let written = (exporter.write)(&Model::new(parts.collect()), &context)?;
    Ok(String::from_utf8(written.bytes).unwrap())
}

fn step(net: &ControlNet) -> Result<String, ExportFault> {
    step_in(std::slice::from_ref(net), Unit::Millimetre)
}

/// One surface of each kind: plain, rational, with an apex, closed, not orientable, cut, bare.
fn files() -> Vec<String> {
    let nets = [
        patch(&nets::polynomial()),
        patch(&nets::quarter_cylinder()),
        patch(&nets::cone()),
        patch(&nets::tube("1 1")),
        patch(&nets::negative_weight()),
        patch(&nets::bag()),
        nets::sphere(),
        nets::moebius(),
    ];
    nets.iter().map(|own| step(own).unwrap()).collect()
}

#[test]
fn degrees_up_to_25_and_the_way_out_above() {
    assert!(step(&patch(&nets::of_degree(25))).is_ok());
    let refused = step(&patch(&nets::of_degree(26))).unwrap_err();
    assert_eq!(refused.code, Code::E0305);
    assert!(refused.help.contains("`json`"), "{}", refused.help);
}

#[test]
fn numbers_below_those_that_are_infinite_to_readers() {
    let patch = |size: &str| {
        patch(&[
            nets::sum(&[("1", "1")]),
            nets::sum(&[(&format!("0 {size}"), "1")]),
            nets::sum(&[("1", "0 1")]),
            nets::sum(&[("0 1", "0 1")]),
        ])
    };
    // 10^100 itself is above the nearest double
    for (name, below, infinite) in [
        ("step", "99999999999999e86", "1e100"),
        ("step", "-99999999999999e86", "-1e100"),
        ("iges", "99999999999999e86", "1e100"),
        ("3dm", "99999999999999e293", "1e307"),
    ] {
        let exporter = ALL.iter().find(|own| own.name == name).unwrap();
        let write = |size: &str| {
            let model = Model::new(vec![Part::of_net("R", patch(size))]);
            (exporter.write)(&model, &Context::new("file", "R"))
        };
        assert!(write(below).is_ok(), "{name} {below}");
        let refused = write(infinite).unwrap_err();
        assert_eq!(refused.code, Code::E0306, "{name} {infinite}");
        assert!(refused.help.contains("`json`"), "{}", refused.help);
    }
}

#[test]
fn every_weight_in_a_file_is_positive() {
    for text in files() {
        let positive = |bits: &u64| f64::from_bits(*bits) > 0.0;
        let patches = Exchange::read(&text).patches();
        assert!(!patches.is_empty());
        assert!(patches.iter().flat_map(|own| &own.weights).all(positive));
        let file = Exchange::read(&text);
        for own in file.all("RATIONAL_B_SPLINE_CURVE") {
            assert!(file.bits(&own.parameter).iter().all(positive));
        }
    }
    // Negative everywhere is a matter of the sign: the net is the same.
    let surface = nets::quarter_cylinder();
    let minus = nets::sum(&[("-1", "1")]);
    let negative = surface.each_ref().map(|own| own * &minus);
    assert_eq!(step(&patch(&negative)), step(&patch(&surface)));
}

#[test]
fn surfaces_are_b_splines_in_faces_in_shells_of_a_product() {
    for text in files() {
        let file = Exchange::read(&text);
        let count = |name: &str| file.all(name).len();
        assert_eq!(count("BEZIER_SURFACE") + count("BEZIER_CURVE"), 0);
        assert_eq!(count("SHAPE_REPRESENTATION"), 0);
        for one in [
            "PRODUCT",
            "PRODUCT_DEFINITION_FORMATION",
            "PRODUCT_DEFINITION",
            "PRODUCT_DEFINITION_SHAPE",
            "SHAPE_DEFINITION_REPRESENTATION",
        ] {
            assert_eq!(count(one), 1, "{one}");
        }
        let shells = count("OPEN_SHELL") + count("CLOSED_SHELL");
        assert!((shells > 0) != (count("GEOMETRIC_SET") > 0));
    }
}

#[test]
fn no_patch_closes_up() {
    let closed = Parameter::Enumeration("T".to_owned());
    for net in [
        patch(&nets::tube("1 1")),
        patch(&nets::tube("1 1 -1")),
        nets::torus(),
        nets::nearly_closed(),
    ] {
        let file = Exchange::read(&step(&net).unwrap());
        let surfaces = file.all("B_SPLINE_SURFACE");
        assert!(surfaces.len() >= 2);
        for own in surfaces {
            assert!(!attributes(own).contains(&closed), "{own:?}");
        }
    }
}

#[test]
fn neighbours_have_their_edge_in_common() {
    let half = |from, to| nets::on(&nets::quarter_cylinder(), (from, to), ("0", "1"));
    let nets = [half("0", "1/2"), half("1/2", "1")];
    let file = Exchange::read(&step_in(&nets, Unit::Millimetre).unwrap());
    let count = |name: &str| file.all(name).len();
    assert_eq!(count("OPEN_SHELL"), 1);
    assert_eq!((count("EDGE_CURVE"), count("ORIENTED_EDGE")), (7, 8));
    assert_eq!(count("VERTEX_POINT"), 6);
}

#[test]
fn collapsed_sides_have_no_edge() {
    let file = Exchange::read(&step(&patch(&nets::cone())).unwrap());
    assert_eq!(file.all("EDGE_CURVE").len(), 3);
    for edge in file.all("B_SPLINE_CURVE_WITH_KNOTS") {
        let [_, _, points, ..] = attributes(edge) else {
            panic!("{edge:?}");
        };
        if let Parameter::List(points) = points {
            assert!(points.iter().any(|own| own != &points[0]));
        }
    }
}

#[test]
fn texts_are_plain() {
    for text in files() {
        assert!(text.starts_with("ISO-10303-21;"), "no mark before it");
        assert!(text.is_ascii());
        // Only the parts of complex entities have nothing between their brackets.
        assert!(!text.contains(",()") && !text.contains("(()"));
        let reals = text.split(['(', ')', ',']);
        for own in reals.filter(|own| own.starts_with(|c: char| c == '-' || c.is_ascii_digit())) {
            assert!(!own.contains('e') && own != "-0.", "{own}");
        }
    }
}

#[test]
fn the_unit_is_the_declared_one() {
    let net = [patch(&nets::quarter_cylinder())];
    for (unit, mark) in [
        (Unit::Metre, "SI_UNIT($,.METRE.)"),
        (Unit::Inch, "LENGTH_MEASURE(25.4)"),
    ] {
        assert!(step_in(&net, unit).unwrap().contains(mark));
    }
}

#[test]
fn normals_do_not_depend_on_the_form_of_the_weights() {
    // The weight has a negative Bernstein coefficient at its own degree, and is positive.
    let text = "surface R = (u, v + 1/(1 - 3u + 3u^2), 0)\nexpect normal(R) == (0, 0, 1)\n";
    let folder = tempfile::TempDir::new().unwrap();
    let arguments = ["compile", "-", "--emit", "mesh"];
    let output = example_files::run(folder.path(), &arguments, text);
    assert!(output.status.success(), "{output:?}");
    let mesh = std::fs::read_to_string(folder.path().join("stdin-R.mesh.obj")).unwrap();
    let normals: Vec<&str> = mesh.lines().filter(|own| own.starts_with("vn ")).collect();
    assert_eq!(normals, ["vn 0.0 0.0 1.0"]);
}

#[test]
fn the_size_of_a_surface_is_not_that_of_its_control_points() {
    // The twelfth Chebyshev polynomial on [0, 1] has values within 1, and coefficients of thousands.
    let text = "let a(u) = 2u - 1\nlet f(u) = 32 a(u)^6 - 48 a(u)^4 + 18 a(u)^2 - 1\n\
                surface R = (u, v, 2 f(u)^2 - 1)\n";
    let triangles = |chord: &[&str]| {
        let folder = tempfile::TempDir::new().unwrap();
        let arguments = [&["compile", "-", "--emit", "mesh"], chord].concat();
        let output = example_files::run(folder.path(), &arguments, text);
        assert!(output.status.success(), "{output:?}");
        let mesh = std::fs::read_to_string(folder.path().join("stdin-R.mesh.obj")).unwrap();
        mesh.lines().filter(|own| own.starts_with("f ")).count()
    };
    // A thousandth of 2, and half as much again.
    assert!(triangles(&[]) >= triangles(&["--chord", "3/1000"]));
}

#[test]
fn a_fold_is_told() {
    // The curve has the radius of curvature 3/2 at v = 0; the profile goes out to `reach`.
    let findings = |reach: &str| {
        let text = format!(
            "profile p(u) in xz = ({reach} u, 0)\n\
             sweep c(v) in xy on [0, 1] = (3v - v^3, 3v^2)\n\
             surface R = oriented_translation(p, c)\n"
        );
        let output = example_files::run(&example_files::folder(), &["check", "-"], &text);
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(findings("-2").contains("W1011"));
    for reach in ["2", "-1"] {
        assert_eq!(findings(reach), "", "{reach}");
    }
}
