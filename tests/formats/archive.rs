//! 3DM, read chunk by chunk; every checksum is computed again, bit by bit.

use sweepc::export::Context;
use sweepc::net::{Model, Part};
use sweepc::number::Unit;

use crate::surface::{Surface, bits};
use crate::{bytes, nets, simple, write};

const TABLE_END: u32 = 0xFFFF_FFFF;

/// The types of chunks that hold chunks.
const NESTED: &[u32] = &[
    0x1000_0013,
    0x1000_0014,
    0x1000_0015,
    0x2000_8070,
    0x0002_7FFA,
];

#[derive(Debug)]
enum Chunk {
    Short(u32, u32),
    Bytes(u32, Vec<u8>),
    Chunks(u32, Vec<Chunk>),
}

impl Chunk {
    fn kind(&self) -> u32 {
        match self {
            Self::Short(kind, _) | Self::Bytes(kind, _) | Self::Chunks(kind, _) => *kind,
        }
    }

    fn chunks(&self) -> &[Chunk] {
        match self {
            Self::Chunks(_, chunks) => chunks,
            other => panic!("{other:?}"),
        }
    }

    fn bytes(&self) -> &[u8] {
        match self {
            Self::Bytes(_, bytes) => bytes,
            other => panic!("{other:?}"),
        }
    }

    fn child(&self, kind: u32) -> &Chunk {
        self.chunks().iter().find(|own| own.kind() == kind).unwrap()
    }
}

fn integer(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

fn size(bytes: &[u8], at: usize) -> usize {
    usize::try_from(integer(bytes, at)).unwrap()
}

fn double(bytes: &[u8], at: usize) -> f64 {
    f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap())
}

/// CRC-32 by its definition: the remainder of a polynomial, one bit at a time.
fn checksum(bytes: &[u8]) -> u32 {
    let register = bytes.iter().fold(u32::MAX, |register, byte| {
        (0..8).fold(register ^ u32::from(*byte), |own, _| {
            let carry = if own & 1 == 1 { 0xEDB8_8320 } else { 0 };
            (own >> 1) ^ carry
        })
    });
    !register
}

fn chunks(mut rest: &[u8]) -> Vec<Chunk> {
    let mut found = Vec::new();
    while !rest.is_empty() {
        let (kind, value) = (integer(rest, 0), integer(rest, 4));
        rest = &rest[8..];
        if kind & 0x8000_0000 != 0 {
            found.push(Chunk::Short(kind, value));
            continue;
        }
        let (content, after) = rest.split_at(usize::try_from(value).unwrap());
        rest = after;
        let checked = kind & 0x8000 != 0;
        let end = content.len() - if checked { 4 } else { 0 };
        let nested = NESTED.contains(&kind);
        if checked {
            // Chunks within do not count.
            let own = if nested { &[] } else { &content[..end] };
            assert_eq!(checksum(own), integer(content, end));
        }
        found.push(if nested {
            Chunk::Chunks(kind, chunks(&content[..end]))
        } else {
            Chunk::Bytes(kind, content[..end].to_vec())
        });
    }
    found
}

/// The number of the unit, and each surface with its name.
fn read(file: &[u8]) -> (u32, Vec<(String, Surface)>) {
    assert_eq!(&file[..32], b"3D Geometry File Format        2");
    let tables = chunks(&file[32..]);
    let kinds: Vec<_> = tables.iter().map(Chunk::kind).collect();
    assert_eq!(kinds, [1, 0x1000_0014, 0x1000_0015, 0x1000_0013, 0x7FFF]);
    for table in &tables[1..4] {
        assert_eq!(table.chunks().last().unwrap().kind(), TABLE_END);
    }
    assert_eq!(size(tables[4].bytes(), 0), file.len());
    let units = tables[2].child(0x2000_8031).bytes();
    assert_eq!((integer(units, 0), units.len()), (100, 32));
    let objects = tables[3].chunks().split_last().unwrap().1;
    (integer(units, 4), objects.iter().map(object).collect())
}

fn object(own: &Chunk) -> (String, Surface) {
    assert!(matches!(own.chunks()[0], Chunk::Short(0x8200_0071, 8)));
    let class = own.child(0x0002_7FFA);
    let uuid = class.child(0x0002_FFFB).bytes();
    assert_eq!(uuid[..8], [0xDE, 0xD4, 0xD7, 0x4E, 0x47, 0xE9, 0xD3, 0x11]);
    assert_eq!(uuid[8..], [0xBF, 0xE5, 0x00, 0x10, 0x83, 0x01, 0x22, 0xF0]);
    let attributes = own.child(0x0200_8072).bytes();
    let name = 1 + 16 + 12 + 4 + 16 + 4 + 4;
    let length = size(attributes, name);
    let units = attributes[name + 4..]
        .chunks(2)
        .take(length.saturating_sub(1));
    let units: Vec<_> = units
        .map(|own| u16::from_le_bytes([own[0], own[1]]))
        .collect();
    let text = String::from_utf16(&units).unwrap();
    (text, surface(class.child(0x0002_FFFC).bytes()))
}

/// Bytes that are read one after the other.
struct Cursor<'a>(&'a [u8]);

impl<'a> Cursor<'a> {
    fn take(&mut self, count: usize) -> &'a [u8] {
        let (taken, rest) = self.0.split_at(count);
        self.0 = rest;
        taken
    }

    fn size(&mut self) -> usize {
        size(self.take(4), 0)
    }

    fn doubles(&mut self, count: usize) -> Vec<u64> {
        let items = self.take(8 * count).chunks(8);
        items.map(|own| bits(double(own, 0))).collect()
    }

    /// Knots; the first and the last are left out in the file.
    fn knots(&mut self) -> Vec<u64> {
        let count = self.size();
        let inner = self.doubles(count);
        [&inner[..1], &inner, &inner[count - 1..]].concat()
    }
}

fn surface(data: &[u8]) -> Surface {
    let mut cursor = Cursor(data);
    assert_eq!(cursor.take(1), [0x10]);
    let [dimension, rational, order_u, order_v, rows, columns, ..] =
        [(); 8].map(|()| cursor.size());
    assert_eq!(dimension, 3);
    cursor.take(6 * 8);
    let knots = [cursor.knots(), cursor.knots()];
    let count = cursor.size();
    assert_eq!(count, rows * columns);
    let point = |_| {
        let mut point = cursor.doubles(dimension + rational);
        point.resize(4, 1_f64.to_bits());
        point
    };
    let points = (0..count).map(point).collect();
    assert!(cursor.0.is_empty());
    Surface {
        degrees: [order_u - 1, order_v - 1],
        knots,
        points,
    }
}

#[test]
fn surfaces_have_products_and_names() {
    let mut list = simple();
    list.push(nets::patch(&nets::of_degree(60)));
    for net in list {
        let (unit, surfaces) = read(&bytes("3dm", &net));
        assert_eq!(unit, 2);
        assert_eq!(surfaces, [("R".to_owned(), Surface::premultiplied(&net))]);
    }
}

#[test]
fn several_surfaces_are_several_objects() {
    let nets = simple();
    let parts = nets.iter().map(|net| Part::of_net("Rσ 1", net.clone()));
    let model = Model::new(parts.collect());
    for (unit, number) in [
        (Unit::Millimetre, 2),
        (Unit::Centimetre, 3),
        (Unit::Metre, 4),
        (Unit::Inch, 8),
    ] {
        let context = Context {
            unit,
            ..Context::whole("file")
        };
        let written = write("3dm", &model, &context).unwrap();
        let premultiplied = nets.iter().map(Surface::premultiplied);
        let expected = premultiplied.map(|own| ("Rσ 1".to_owned(), own));
        assert_eq!(read(&written.bytes), (number, expected.collect()));
    }
}

#[test]
fn a_patch_of_the_paper_is_small() {
    let net = nets::on(&nets::circle_over_cubic(), ("0", "1"), ("0", "1"));
    let surface = 1 + 8 * 4 + 6 * 8 + 2 * 4 + 8 * (4 + 6) + 4 + 8 * 4 * 12;
    let file = bytes("3dm", &net);
    assert!(file.len() < surface + 450, "{}", file.len());
}
