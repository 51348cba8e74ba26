//! What holds for every format.

use std::collections::HashSet;

use sweepc::diag::Code;
use sweepc::export::{ALL, Context, Exporter, Fidelity};
use sweepc::net::{ControlNet, Model, Part};
use sweepc::number::Real;

use crate::{model, nets, simple};

/// Surfaces of every kind, also such as no format carries.
fn surfaces() -> Vec<ControlNet> {
    let mut list = simple();
    list.extend([
        nets::patch(&nets::negative_weight()),
        nets::patch(&nets::of_degree(26)),
        nets::patch(&nets::line()),
        nets::patch(&nets::tube("1 1")),
        nets::patch(&nets::bag()),
        nets::cylinder(),
        nets::sphere(),
        nets::folded(),
        nets::moebius(),
    ]);
    list
}

/// The formats whose numbers are the control points themselves.
const EXACT: &[&str] = &[
    "json", "step", "iges", "3dm", "geomdl", "three", "verb", "truck", "obj",
];

fn is_exact(own: &Exporter) -> bool {
    EXACT.contains(&own.name)
}

fn exact_formats() -> impl Iterator<Item = &'static Exporter> {
    let exact = ALL.iter().filter(|own| is_exact(own));
    assert_eq!(exact.clone().count(), EXACT.len());
    exact
}

#[test]
fn words_and_extensions_are_different_and_plain() {
    let plain = |own: &str| {
        own.chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || ".-".contains(c))
    };
    let names: HashSet<_> = ALL.iter().map(|own| own.name).collect();
    let extensions: HashSet<_> = ALL.iter().map(|own| own.extension).collect();
    assert_eq!((names.len(), extensions.len()), (ALL.len(), ALL.len()));
    for own in ALL {
        assert!(plain(own.name) && plain(own.extension), "{own:?}");
        assert!(
            !own.extension.starts_with('.') && !own.summary.is_empty(),
            "{own:?}"
        );
    }
}

#[test]
fn a_surface_is_written_or_refused_with_the_way_out() {
    for (index, net) in surfaces().iter().enumerate() {
        // Pictures and meshes take their time.
        for own in ALL.iter().filter(|own| index % 4 == 0 || is_exact(own)) {
            let context = Context {
                chord: Some(nets::number("1/4")),
                ..Context::new("file", "R")
            };
            match (own.write)(&model(net), &context) {
                Ok(written) => {
                    assert!(!written.bytes.is_empty());
                    let warnings = written.warnings.iter();
                    assert!(
                        warnings
                            .map(|own| own.code.as_str())
                            .all(|own| own.starts_with('W'))
                    );
                    let again = (own.write)(&model(net), &context).unwrap();
                    assert_eq!(written, again, "{}", own.name);
                }
                Err(fault) => {
                    let codes = [
                        Code::E0302,
                        Code::E0304,
                        Code::E0305,
                        Code::E0306,
                        Code::E0308,
                    ];
                    assert!(codes.contains(&fault.code), "{}: {fault:?}", own.name);
                    assert!(!fault.help.is_empty() && !fault.message.is_empty());
                }
            }
        }
    }
}

#[test]
fn degrees_above_25_are_the_affair_of_step_and_iges() {
    let net = nets::patch(&nets::of_degree(26));
    let refused = exact_formats().filter(|own| {
        let written = (own.write)(&model(&net), &Context::new("file", "R"));
        written.is_err_and(|fault| fault.code == Code::E0305)
    });
    let refused: Vec<_> = refused.map(|own| own.name).collect();
    assert_eq!(refused, ["step", "iges"]);
}

#[test]
fn formats_of_one_surface_refuse_two() {
    let net = nets::patch(&nets::quarter_cylinder());
    let parts = ["A", "B"].map(|name| Part::of_net(name, net.clone()));
    let model = Model::new(parts.to_vec());
    for own in ALL {
        let written = (own.write)(&model, &Context::whole("file"));
        match written {
            Ok(_) => assert!(own.several, "{}", own.name),
            Err(fault) => assert_eq!((own.several, fault.code), (false, Code::E0304)),
        }
    }
}

#[test]
fn text_has_no_negative_zero_and_no_name_for_infinity() {
    for net in surfaces() {
        for own in exact_formats().filter(|own| own.name != "3dm") {
            let Ok(written) = (own.write)(&model(&net), &Context::new("file", "R")) else {
                continue;
            };
            let text = String::from_utf8(written.bytes).unwrap();
            let words = text.split([' ', ',', '(', ')', '[', ']', '}', '\n', ';']);
            for word in words {
                let zero = word
                    .parse::<f64>()
                    .is_ok_and(|own| own == 0.0 && own.is_sign_negative());
                assert!(
                    !zero && !["NaN", "inf", "-inf"].contains(&word),
                    "{}: {word}",
                    own.name
                );
            }
        }
    }
}

#[test]
fn a_file_of_doubles_is_exact_and_others_have_a_bound() {
    let exact = nets::patch(&nets::quarter_cylinder());
    let thirds = nets::patch(&nets::polynomial());
    for own in exact_formats() {
        let fidelity = |net: &ControlNet| {
            let written = (own.write)(&model(net), &Context::new("file", "R"));
            written.unwrap().fidelity
        };
        assert_eq!(fidelity(&exact), Fidelity::Exact, "{}", own.name);
        let bound = match fidelity(&thirds) {
            Fidelity::Rounded { max_error } => max_error.unwrap(),
            other => {
                assert_eq!((own.name, other), ("json", Fidelity::Exact));
                continue;
            }
        };
        let small = Real::power_of_two(-54);
        assert!(
            bound > Real::from(0) && bound <= small,
            "{}: {bound}",
            own.name
        );
    }
}

#[test]
fn points_of_products_stay_within_their_bound() {
    let net = nets::on(&nets::circle_over_cubic(), ("1/7", "3/7"), ("-1/3", "1"));
    let rounded = sweepc::export::PremultipliedNet::new(&net).unwrap();
    let Fidelity::Rounded {
        max_error: Some(bound),
    } = rounded.fidelity(&net)
    else {
        panic!("sevenths are no doubles");
    };
    assert!(bound < Real::power_of_two(-50), "{bound}");
    // The surface of the doubles, made exact again.
    use sweepc::number::Field;
    let points = rounded
        .points
        .iter()
        .flatten()
        .map(|own| own.map(|own| own.exact()));
    let (mut weights, mut places) = (Vec::new(), Vec::new());
    for [x, y, z, w] in points {
        let scale = w.inverse().unwrap();
        places.push([x, y, z].map(|own| own.times(&scale)));
        weights.push(w);
    }
    let (knots_u, knots_v) = (net.knots_u().clone(), net.knots_v().clone());
    let doubles = ControlNet::new(knots_u, knots_v, weights, places).unwrap();
    for (u, v) in [("1/7", "-1/3"), ("1/4", "0"), ("3/8", "1/2"), ("3/7", "1")] {
        let (u, v) = (nets::number(u), nets::number(v));
        let exact = net.de_casteljau(&u, &v).unwrap();
        for (own, other) in exact.iter().zip(doubles.de_casteljau(&u, &v).unwrap()) {
            assert!(own.minus(&other).absolute() <= bound);
        }
    }
}
