//! IGES, read by its records and columns.

use std::collections::BTreeMap;

use sweepc::export::Context;
use sweepc::net::{Model, Part};
use sweepc::number::Unit;

use crate::surface::{Surface, bits};
use crate::{file, model, nets, simple, write};

/// An entity: its form, its status and its parameters.
struct Entity {
    kind: usize,
    form: usize,
    status: String,
    parameters: Vec<String>,
}

/// The global parameters, and the entities by pointer.
struct File {
    global: Vec<String>,
    entities: BTreeMap<usize, Entity>,
}

/// A number in columns.
fn field(line: &str, index: usize) -> usize {
    line[8 * index..8 * (index + 1)].trim().parse().unwrap()
}

/// The parameters of records: a text is as long as it says.
fn parameters(text: &str) -> Vec<String> {
    let (mut found, mut rest) = (Vec::new(), text);
    loop {
        let end = rest.find([',', ';']).unwrap();
        let counted = rest[..end].split_once('H');
        let length =
            counted.and_then(|(count, _)| Some((count.len(), count.parse::<usize>().ok()?)));
        let (word, end) = match length {
            Some((digits, length)) => {
                let end = digits + 1 + length;
                (&rest[digits + 1..end], end)
            }
            None => (&rest[..end], end),
        };
        found.push(word.to_owned());
        let delimiter = &rest[end..=end];
        rest = &rest[end + 1..];
        if delimiter == ";" {
            assert!(rest.trim().is_empty(), "{rest}");
            return found;
        }
        assert_eq!(delimiter, ",");
    }
}

fn read(text: &str) -> File {
    let mut sections: BTreeMap<char, Vec<&str>> = BTreeMap::new();
    for line in text.lines() {
        assert!(line.is_ascii() && line.len() == 80, "{line}");
        let section = sections.entry(line.chars().nth(72).unwrap()).or_default();
        section.push(&line[..72]);
        assert_eq!(line[73..].trim().parse(), Ok(section.len()), "{line}");
    }
    let order: Vec<char> = text
        .lines()
        .map(|line| line.chars().nth(72).unwrap())
        .collect();
    let places = order.iter().map(|own| "SGDPT".find(*own).unwrap());
    assert!(places.is_sorted());
    let end = sections[&'T'][0];
    for (index, letter) in "SGDP".chars().enumerate() {
        let count = format!("{letter}{:>7}", sections[&letter].len());
        assert_eq!(&end[8 * index..8 * (index + 1)], count);
    }
    let directory = &sections[&'D'];
    let entities = directory.chunks(2).enumerate().map(|(index, lines)| {
        let pointer = 2 * index + 1;
        assert_eq!(field(lines[0], 0), field(lines[1], 0));
        let (start, count) = (field(lines[0], 1), field(lines[1], 3));
        let records = &sections[&'P'][start - 1..start - 1 + count];
        for record in records {
            assert_eq!(record[64..72].trim().parse(), Ok(pointer));
        }
        let text: String = records.iter().map(|own| &own[..64]).collect();
        // Records end with blanks where the next number does not fit in.
        let mut words = parameters(&text);
        words
            .iter_mut()
            .for_each(|own| *own = own.trim().to_owned());
        let kind = field(lines[0], 0);
        assert_eq!(words.remove(0).parse(), Ok(kind));
        let entity = Entity {
            kind,
            form: field(lines[1], 4),
            status: lines[0][64..72].to_owned(),
            parameters: words,
        };
        (pointer, entity)
    });
    File {
        entities: entities.collect(),
        global: parameters(&sections[&'G'].concat()),
    }
}

impl Entity {
    fn count(&self, index: usize) -> usize {
        self.parameters[index].parse().unwrap()
    }

    /// Reals from a place on: with a point, the exponent after D.
    fn reals(&self, from: usize, count: usize) -> Vec<u64> {
        let words = self.parameters[from..from + count].iter();
        words.map(|own| real(own)).collect()
    }

    /// The knots, weights and points of entity 128.
    fn surface(&self) -> Surface {
        let [rows, columns] = [0, 1].map(|own| self.count(own) + 1);
        let degrees = [self.count(2), self.count(3)];
        let lengths = [rows + degrees[0] + 1, columns + degrees[1] + 1];
        let (first, second) = (9, 9 + lengths[0]);
        let weights = self.reals(second + lengths[1], rows * columns);
        let points = second + lengths[1] + rows * columns;
        let point = |index: usize| {
            let mut point = self.reals(points + 3 * index, 3);
            point.push(weights[index]);
            point
        };
        let knots = [
            self.reals(first, lengths[0]),
            self.reals(second, lengths[1]),
        ];
        let ends = knots.iter().flat_map(|own| [own[0], own[own.len() - 1]]);
        assert_eq!(
            self.reals(points + 3 * rows * columns, 4),
            ends.collect::<Vec<_>>()
        );
        let polynomial = weights.iter().all(|own| *own == weights[0]);
        assert_eq!(self.parameters[6], usize::from(polynomial).to_string());
        let surface = Surface {
            degrees,
            points: (0..rows * columns).map(point).collect(),
            knots,
        };
        surface.transposed()
    }
}

fn real(word: &str) -> u64 {
    assert!(
        word.contains('.') && !word.contains(['E', 'e', 'd']),
        "{word}"
    );
    bits(word.replace('D', "E").parse().unwrap())
}

fn of_kind(file: &File, kind: usize) -> Vec<&Entity> {
    let entities = file.entities.values();
    entities.filter(|own| own.kind == kind).collect()
}

#[test]
fn surfaces_have_points_and_weights() {
    for net in simple() {
        let file = read(&file("iges", &net));
        let surfaces = of_kind(&file, 128);
        assert_eq!(surfaces.len(), 1);
        assert_eq!(
            (surfaces[0].form, surfaces[0].status.as_str()),
            (0, "00000000")
        );
        assert_eq!(surfaces[0].surface(), Surface::affine(&net));
    }
}

#[test]
fn closed_surfaces_are_cut() {
    for (net, faces) in [
        (nets::patch(&nets::tube("1 1")), 2),
        (nets::cylinder(), 4),
        (nets::patch(&nets::negative_weight()), 2),
    ] {
        let file = read(&file("iges", &net));
        let surfaces = of_kind(&file, 128);
        assert_eq!(surfaces.len(), faces);
        for own in surfaces {
            // Neither direction is closed.
            assert_eq!(own.parameters[4..6], ["0", "0"]);
        }
    }
}

#[test]
fn boundaries_are_the_sides_of_the_patch() {
    let context = Context {
        iges_trimmed: true,
        ..Context::new("file", "R")
    };
    let net = nets::patch(&nets::circle_over_cubic());
    let written = write("iges", &model(&net), &context).unwrap();
    let file = read(std::str::from_utf8(&written.bytes).unwrap());
    let entity = |pointer: usize| &file.entities[&pointer];
    let [trimmed] = of_kind(&file, 144)[..] else {
        panic!("one face");
    };
    assert_eq!(trimmed.parameters[1..3], ["1", "0"]);
    let boundary = entity(trimmed.count(3));
    assert_eq!((boundary.kind, boundary.count(1)), (142, trimmed.count(0)));
    let surface = entity(boundary.count(1)).surface();
    assert_eq!(surface, Surface::affine(&net));
    let parts = |pointer: usize| -> Vec<&Entity> {
        let all = entity(pointer);
        assert_eq!((all.kind, all.count(0)), (102, all.parameters.len() - 1));
        (1..=all.count(0))
            .map(|own| entity(all.count(own)))
            .collect()
    };
    let curves = parts(boundary.count(3));
    // Of four sides one is a point.
    assert_eq!(curves.len(), 3);
    let ends: Vec<_> = curves.iter().map(|own| ends(own)).collect();
    for (index, [_, end]) in ends.iter().enumerate() {
        assert_eq!(*end, ends[(index + 1) % ends.len()][0]);
    }
    let segments = parts(boundary.count(2));
    assert_eq!(segments.len(), 4);
    assert!(
        segments
            .iter()
            .all(|own| own.kind == 126 && &own.status[4..6] == "05")
    );
}

/// The first and the last point of entity 126.
fn ends(curve: &Entity) -> [Vec<u64>; 2] {
    let (last, degree) = (curve.count(0), curve.count(1));
    let points = 6 + (last + degree + 2) + (last + 1);
    [curve.reals(points, 3), curve.reals(points + 3 * last, 3)]
}

#[test]
fn names_and_units_arrive() {
    let net = nets::patch(&nets::quarter_cylinder());
    let parts = ["Rσ", "a name; with, marks"].map(|name| Part::of_net(name, net.clone()));
    let model = Model::new(parts.to_vec());
    for (unit, flag, symbol) in [
        (Unit::Inch, "1", "INCH"),
        (Unit::Millimetre, "2", "MM"),
        (Unit::Metre, "6", "M"),
        (Unit::Centimetre, "10", "CM"),
    ] {
        let context = Context {
            unit,
            ..Context::whole("file")
        };
        let written = write("iges", &model, &context).unwrap();
        let file = read(std::str::from_utf8(&written.bytes).unwrap());
        assert_eq!(file.global[..4], [",", ";", "file", "file.igs"]);
        assert_eq!(file.global[13..15], [flag, symbol]);
        let names = of_kind(&file, 406);
        let names: Vec<_> = names
            .iter()
            .map(|own| (own.form, own.parameters[1].as_str()))
            .collect();
        assert_eq!(names, [(15, "R\\u{3C3}"), (15, "a name; with, marks")]);
        // Each surface points at its name.
        for (surface, property) in of_kind(&file, 128).iter().zip(["1", "5"]) {
            assert!(
                surface
                    .parameters
                    .ends_with(&["0", "1", property].map(str::to_owned))
            );
        }
    }
}
