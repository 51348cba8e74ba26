//! A drawing shows what is in sight, and nothing else.

use std::collections::BTreeSet;
use std::fs;

use roxmltree::{Document, Node};

use crate::{compiled, example_files, model, nets, odd_nets, written};

/// The paths of a group of a drawing: the ends of each in hundredths, the smaller first.
fn ends(drawing: &Document<'_>, group: &str) -> Vec<[[i64; 2]; 2]> {
    let groups = drawing.descendants();
    let groups = groups.filter(|own| own.attribute("id") == Some(group));
    let paths = groups.flat_map(|own| own.children().filter(Node::is_element));
    paths
        .map(|own| {
            let points = points(own.attribute("d").unwrap());
            let mut ends = [points[0], points[points.len() - 1]];
            ends.sort_unstable();
            ends
        })
        .collect()
}

/// The points of `M x y L x y …`, in hundredths.
fn points(path: &str) -> Vec<[i64; 2]> {
    let numbers = path.split(['M', 'L', ' ']).filter(|own| !own.is_empty());
    let numbers: Vec<i64> = numbers
        .map(|own| (own.parse::<f64>().unwrap() * 100.0).round() as i64)
        .collect();
    let pairs = numbers.chunks_exact(2);
    pairs.map(|own| [own[0], own[1]]).collect()
}

/// A square x in [x, x + width], z in [z, z + width] at a distance y.
fn square(x: i64, y: i64, z: i64, width: i64) -> sweepc::net::ControlNet {
    let along = |from: i64| format!("{from} {width}");
    let zero = y.to_string();
    nets::patch(&[
        nets::sum(&[("1", "1")]),
        nets::sum(&[(&along(x), "1")]),
        nets::sum(&[(&zero, "1")]),
        nets::sum(&[("1", &along(z))]),
    ])
}

#[test]
fn a_square_hides_the_side_of_another_behind_it() {
    let near = square(3, 0, 1, 2);
    let far = square(0, 1, 0, 4);
    let text = written("svg", &model(&[("far", far), ("near", near)]), "front");
    let drawing = Document::parse(&text).unwrap();
    // The height of 4 fills 440; x = 5/2 is in the middle of 720.
    let place = |(x, z): (i64, i64)| [36_000 + 11_000 * x - 27_500, 3_600 + 11_000 * (4 - z)];
    let line = |a: (i64, i64), b: (i64, i64)| {
        let mut ends = [place(a), place(b)];
        ends.sort_unstable();
        ends
    };
    let visible = BTreeSet::from([
        line((0, 0), (4, 0)),
        line((0, 0), (0, 4)),
        line((0, 4), (4, 4)),
        line((4, 0), (4, 1)),
        line((4, 3), (4, 4)),
        line((3, 1), (5, 1)),
        line((3, 1), (3, 3)),
        line((5, 1), (5, 3)),
        line((3, 3), (5, 3)),
    ]);
    let found = |group: &str| ends(&drawing, group).into_iter().collect::<BTreeSet<_>>();
    assert_eq!(found("edges"), visible);
    assert_eq!(
        found("hidden-edges"),
        BTreeSet::from([line((4, 1), (4, 3))])
    );
}

#[test]
fn a_half_cylinder_hides_its_back_and_shows_its_contour() {
    // x = (1 − u²)/(1 + u²), y = 2u/(1 + u²), z = v for u in [−1, 1], v in [0, 1]
    let net = nets::on(
        &[
            nets::sum(&[("1 0 1", "1")]),
            nets::sum(&[("1 0 -1", "1")]),
            nets::sum(&[("0 2", "1")]),
            nets::sum(&[("1 0 1", "0 1")]),
        ],
        ("-1", "1"),
        ("0", "1"),
    );
    let text = written("svg", &model(&[("half", net)]), "front");
    let drawing = Document::parse(&text).unwrap();
    // 440 for the height of 1; x = 1/2 in the middle of 720.
    let [left, right, top, bottom] = [14_000, 58_000, 3_600, 47_600];
    let contour = [[right, top], [right, bottom]];
    let near = |one: &[[i64; 2]; 2], other: &[[i64; 2]; 2]| {
        let pairs = one.iter().flatten().zip(other.iter().flatten());
        pairs.into_iter().all(|(a, b)| (a - b).abs() <= 2)
    };
    assert!(
        ends(&drawing, "edges")
            .iter()
            .any(|own| near(own, &contour))
    );
    let lines = ends(&drawing, "isoparametric");
    let (upright, level): (Vec<[[i64; 2]; 2]>, Vec<_>) = lines
        .into_iter()
        .partition(|[one, other]| one[0] == other[0]);
    // Of sixteen steps along u seven lines are in front, seven behind, one is the contour.
    assert!((7..=8).contains(&upright.len()), "{upright:?}");
    assert!(
        upright
            .iter()
            .all(|[one, other]| (one[1], other[1]) == (top, bottom))
    );
    // Lines along u are seen once, from the side in front to the contour.
    assert_eq!(level.len(), 4);
    for [one, other] in level {
        assert!(near(&[one, other], &[[left, one[1]], [right, one[1]]]));
    }
}

#[test]
fn a_surface_before_another_one_is_drawn_in_every_view() {
    let cube = [
        ("front", square(0, 0, 0, 2)),
        ("behind", square(0, 2, 0, 2)),
    ];
    let text = |view: &str| written("svg", &model(&cube), view);
    let count = |view: &str, group: &str| ends(&Document::parse(&text(view)).unwrap(), group).len();
    // Of two equal squares only one is seen from before and from behind.
    for view in ["front", "back"] {
        assert_eq!(count(view, "edges"), 4, "{view}");
    }
    assert!(count("30,30", "edges") >= 8);
    assert_eq!(text("-60,30"), text("iso"));
    assert_eq!(text("300,30"), text("iso"));
    assert_ne!(text("301,30"), text("iso"));
}

#[test]
fn drawings_are_well_formed_and_the_same_in_every_run() {
    for example in ["paper/example_2.sweep", "design/duct_bend.sweep"] {
        let first = compiled(example, &["--emit", "svg"]);
        assert_eq!(
            first,
            compiled(example, &["--emit", "svg", "--threads", "1"])
        );
        for (name, text) in first {
            let drawing = Document::parse(&text).unwrap();
            assert!(!ends(&drawing, "isoparametric").is_empty(), "{name}");
            assert!(!ends(&drawing, "control-net").is_empty(), "{name}");
            let of = |class: &str| {
                drawing
                    .descendants()
                    .any(|own| own.attribute("class") == Some(class))
            };
            assert!(of("profile") && of("sweep-curve"), "{name}");
        }
    }
    for (name, net) in odd_nets() {
        let text = written("svg", &model(&[(name, net)]), "iso");
        let drawing = Document::parse(&text).unwrap();
        let title = drawing
            .descendants()
            .find(|own| own.has_tag_name("title"))
            .unwrap();
        assert!(
            title
                .text()
                .unwrap()
                .starts_with(&format!("{name}, bidegree ("))
        );
        assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    }
}

#[test]
fn surfaces_that_share_edges_are_drawn_together() {
    let names = |example: &str| {
        compiled(example, &["--emit", "svg"])
            .into_keys()
            .collect::<Vec<_>>()
    };
    let together = [
        "duct_bend-Lower.svg",
        "duct_bend-Upper.svg",
        "duct_bend.svg",
    ];
    assert_eq!(names("design/duct_bend.sweep"), together);
    assert_eq!(names("paper/quarter_torus.sweep"), ["quarter_torus-R.svg"]);
}

#[test]
fn a_long_caption_has_several_lines() {
    let squares: Vec<_> = (0..9).map(|own| square(own, 0, 0, 1)).collect();
    let names = [
        "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth",
    ];
    let parts: Vec<_> = names.into_iter().zip(squares).collect();
    let text = written("svg", &model(&parts), "iso");
    let drawing = Document::parse(&text).unwrap();
    let captions = drawing
        .descendants()
        .filter(|own| own.attribute("font-size") == Some("14"));
    let lines: Vec<String> = captions
        .map(|own| {
            own.descendants()
                .filter_map(|own| own.text().filter(|_| own.is_text()))
                .collect()
        })
        .collect();
    assert!(
        lines.len() > 1 && lines.iter().all(|own| own.chars().count() <= 82),
        "{lines:?}"
    );
    let all = lines.join("; ");
    let told = names.map(|own| format!("{own}, bidegree (1, 1)"));
    assert_eq!(all, told.join("; "));
}

/// No colour by `currentColor`, no order of painting, no part of a line set on its own: readers of
/// SVG outside of browsers paint these black, over the letters, and one over the other.
#[test]
fn a_drawing_says_its_colours_and_texts_plainly() {
    let files = compiled("paper/example_2.sweep", &["--emit", "svg"]);
    let drawing = Document::parse(&files["example_2-R.svg"]).unwrap();
    for own in drawing.descendants().filter(Node::is_element) {
        for attribute in own.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            let plain = !["color", "paint-order", "style"].contains(&name);
            assert!(plain && value != "currentColor", "{name}=\"{value}\"");
        }
        let names = ["svg", "title", "rect", "g", "path", "circle", "text"];
        assert!(names.contains(&own.tag_name().name()), "{own:?}");
    }
    let group = drawing.descendants();
    let mut group = group.filter(|own| own.attribute("id") == Some("surfaces"));
    let faces = group.next().unwrap().children().filter(Node::is_element);
    let colors: Vec<_> = faces
        .map(|own| ["fill", "stroke"].map(|name| own.attribute(name).unwrap_or("none")))
        .collect();
    assert!(!colors.is_empty());
    for [fill, stroke] in colors {
        assert!(fill.starts_with('#') && fill == stroke, "{fill} {stroke}");
    }
    let texts = drawing.descendants().filter(|own| own.has_tag_name("text"));
    let texts: Vec<_> = texts
        .map(|own| (own.text().unwrap(), own.attribute("fill")))
        .collect();
    let (red, blue, grey) = (Some("#b9483a"), Some("#1f6fb2"), Some("#6b7885"));
    assert_eq!(
        texts,
        [
            ("c(v)", None),
            ("c(v)", red),
            ("p(u)", None),
            ("p(u)", blue),
            ("x", grey),
            ("y", grey),
            ("z", grey),
            ("R, bidegree (2, 9)", Some("#1d2b3a")),
        ]
    );
}

/// `cargo run --release -- compile examples/paper/example_2.sweep --emit svg -o examples/pictures`
#[test]
fn the_picture_of_the_readme_is_up_to_date() {
    let files = compiled("paper/example_2.sweep", &["--emit", "svg"]);
    for (name, text) in files {
        let kept = fs::read_to_string(example_files::folder().join("pictures").join(&name));
        assert!(
            kept.unwrap() == text,
            "{name} is not what the compiler draws"
        );
    }
}

#[test]
fn a_view_is_a_name_or_two_angles() {
    let folder = example_files::folder();
    for view in ["sideways", "1", "0,91", "0,-91", "a,b", "1,2,3"] {
        let file = "paper/quarter_torus.sweep";
        let output = example_files::run(
            &folder,
            &["compile", file, "--emit", "svg", "--view", view],
            "",
        );
        assert_eq!(output.status.code(), Some(2), "{view}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains("elevation from -90 to 90"), "{said}");
    }
}
