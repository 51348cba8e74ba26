//! OBJ, as its free-form statements are defined.

use sweepc::export::Context;
use sweepc::net::{Model, Part};

use crate::surface::{Surface, bits};
use crate::{file, nets, simple, write};

/// The name and the surface of each object.
fn read(text: &str) -> Vec<(String, Surface)> {
    let (mut vertices, mut found, mut name) = (Vec::new(), Vec::new(), String::new());
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    while let Some(line) = lines.next() {
        let words: Vec<&str> = line.split(' ').collect();
        let numbers = |words: &[&str]| -> Vec<u64> {
            words.iter().map(|own| bits(own.parse().unwrap())).collect()
        };
        let counts = |words: &[&str]| -> Vec<usize> {
            words.iter().map(|own| own.parse().unwrap()).collect()
        };
        match words[0] {
            "o" => name = words[1..].join(" "),
            "v" => vertices.push(numbers(&words[1..])),
            "cstype" => {
                assert_eq!(words, ["cstype", "rat", "bspline"]);
                let mut next = |word: &str| -> Vec<&str> {
                    let words: Vec<&str> = lines.next().unwrap().split(' ').collect();
                    assert_eq!(words[0], word);
                    words
                };
                let degrees = counts(&next("deg")[1..]);
                let surface = next("surf");
                let ends = numbers(&surface[1..5]);
                let points = counts(&surface[5..]);
                let knots = ["u", "v"].map(|along| {
                    let words = next("parm");
                    assert_eq!(words[1], along);
                    numbers(&words[2..])
                });
                next("end");
                let outer = knots.iter().flat_map(|own| [own[0], own[own.len() - 1]]);
                assert_eq!(ends, outer.collect::<Vec<_>>());
                let points = points.iter().map(|own| vertices[own - 1].clone());
                let surface = Surface {
                    degrees: [degrees[0], degrees[1]],
                    knots,
                    points: points.collect(),
                };
                found.push((name.clone(), surface.transposed()));
            }
            other => panic!("{other}"),
        }
    }
    found
}

#[test]
fn objects_have_points_and_weights() {
    let mut list = simple();
    list.push(nets::patch(&nets::of_degree(60)));
    for net in list {
        let read = read(&file("obj", &net));
        assert_eq!(read, [("R".to_owned(), Surface::affine(&net))]);
    }
}

#[test]
fn objects_count_their_points_on() {
    let nets = simple();
    let parts = nets.iter().map(|net| Part::of_net("a b", net.clone()));
    let model = Model::new(parts.collect());
    let written = write("obj", &model, &Context::whole("file")).unwrap();
    let expected = nets
        .iter()
        .map(|net| ("a_b".to_owned(), Surface::affine(net)));
    let read = read(std::str::from_utf8(&written.bytes).unwrap());
    assert_eq!(read, expected.collect::<Vec<_>>());
}
