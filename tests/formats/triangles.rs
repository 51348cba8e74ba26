//! Readers of STL, PLY, GLB and OBJ with triangles, as far as they are written here.

use serde_json::Value;

use crate::surface::bits;

/// Three numbers by their bits as doubles.
pub(crate) type Vector = [u64; 3];

/// A triangle as a file tells it: its points, and the normals there.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Facet {
    pub(crate) points: [Vector; 3],
    pub(crate) normals: [Vector; 3],
}

fn number(bytes: &[u8]) -> u64 {
    bits(match bytes.len() {
        4 => f64::from(f32::from_le_bytes(bytes.try_into().unwrap())),
        _ => f64::from_le_bytes(bytes.try_into().unwrap()),
    })
}

fn count(bytes: &[u8]) -> usize {
    usize::try_from(u32::from_le_bytes(bytes.try_into().unwrap())).unwrap()
}

fn vector(numbers: &[u64]) -> Vector {
    numbers.try_into().unwrap()
}

/// Triangles of STL; one normal stands for all three.
pub(crate) fn read_stl(bytes: &[u8]) -> Vec<Facet> {
    assert!(!bytes.starts_with(b"solid") && bytes[..80].is_ascii());
    let (number_of, rest) = bytes[80..].split_at(4);
    assert_eq!(rest.len(), 50 * count(number_of));
    let facet = |own: &[u8]| {
        assert_eq!(own[48..], [0, 0]);
        let numbers: Vec<u64> = own[..48].chunks(4).map(number).collect();
        let [normal, points @ ..] = [0, 3, 6, 9].map(|at| vector(&numbers[at..at + 3]));
        Facet {
            points,
            normals: [normal; 3],
        }
    };
    rest.chunks(50).map(facet).collect()
}

/// The number of vertices of PLY, and the triangles by their places.
pub(crate) fn read_ply(bytes: &[u8]) -> (usize, Vec<[usize; 3]>, Vec<Facet>) {
    let end = b"end_header\n";
    let at = bytes.windows(end.len()).position(|own| own == end).unwrap() + end.len();
    let header = std::str::from_utf8(&bytes[..at]).unwrap();
    let lines: Vec<&str> = header.lines().collect();
    assert_eq!(lines[..2], ["ply", "format binary_little_endian 1.0"]);
    let property = |own: &&str| own.starts_with("property ");
    let names = ["x", "y", "z", "nx", "ny", "nz"].map(|own| format!("property double {own}"));
    let properties: Vec<&str> = lines.iter().copied().filter(property).collect();
    assert_eq!(properties[..6], names);
    assert_eq!(properties[6..], ["property list uchar int vertex_indices"]);
    let element = |word: &str| -> usize {
        let line = lines.iter().find_map(|own| own.strip_prefix(word));
        line.unwrap().parse().unwrap()
    };
    let (vertices, faces) = (element("element vertex "), element("element face "));
    let (table, rest) = bytes[at..].split_at(48 * vertices);
    assert_eq!(rest.len(), 13 * faces);
    let rows: Vec<Vec<u64>> = table
        .chunks(48)
        .map(|own| own.chunks(8).map(number).collect())
        .collect();
    let indices: Vec<[usize; 3]> = rest
        .chunks(13)
        .map(|own| {
            assert_eq!(own[0], 3);
            [1, 5, 9].map(|at| count(&own[at..at + 4]))
        })
        .collect();
    let facets = indices.iter().map(|own| Facet {
        points: own.map(|own| vector(&rows[own][..3])),
        normals: own.map(|own| vector(&rows[own][3..])),
    });
    (vertices, indices.clone(), facets.collect())
}

/// The name and the triangles of each object of OBJ.
pub(crate) fn read_obj(text: &str) -> Vec<(String, Vec<Facet>)> {
    let (mut points, mut normals) = (Vec::new(), Vec::new());
    let mut found: Vec<(String, Vec<Facet>)> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let (word, rest) = line.split_once(' ').unwrap();
        let words: Vec<&str> = rest.split(' ').collect();
        let numbers =
            || -> Vec<u64> { words.iter().map(|own| bits(own.parse().unwrap())).collect() };
        match word {
            "v" => points.push(vector(&numbers())),
            "vn" => normals.push(vector(&numbers())),
            "o" => found.push((rest.to_owned(), Vec::new())),
            "f" => {
                let corners: Vec<(usize, usize)> = words
                    .iter()
                    .map(|own| {
                        let (point, normal) = own.split_once("//").unwrap();
                        (point.parse().unwrap(), normal.parse().unwrap())
                    })
                    .collect();
                let corners: [(usize, usize); 3] = corners.try_into().unwrap();
                found.last_mut().unwrap().1.push(Facet {
                    points: corners.map(|(own, _)| points[own - 1]),
                    normals: corners.map(|(_, own)| normals[own - 1]),
                });
            }
            other => panic!("{other}"),
        }
    }
    found
}

/// The JSON of a GLB file, and the name and the triangles of each mesh.
pub(crate) fn read_glb(bytes: &[u8]) -> (Value, Vec<(String, Vec<Facet>)>) {
    assert_eq!(&bytes[..8], b"glTF\x02\0\0\0");
    assert_eq!(count(&bytes[8..12]), bytes.len());
    let length = count(&bytes[12..16]);
    assert_eq!(&bytes[16..20], b"JSON");
    let (text, rest) = bytes[20..].split_at(length);
    let (size, kind) = (count(&rest[..4]), &rest[4..8]);
    assert_eq!(
        (kind, size, size % 4, length % 4),
        (&b"BIN\0"[..], rest.len() - 8, 0, 0)
    );
    let (file, binary): (Value, _) = (serde_json::from_slice(text).unwrap(), &rest[8..]);
    let index = |own: &Value| usize::try_from(own.as_u64().unwrap()).unwrap();
    assert_eq!(index(&file["buffers"][0]["byteLength"]), binary.len());
    let view = |accessor: &Value| -> &[u8] {
        let view = &file["bufferViews"][index(&accessor["bufferView"])];
        let start = index(&view["byteOffset"]);
        assert_eq!(start % 4, 0);
        &binary[start..start + index(&view["byteLength"])]
    };
    let vectors = |accessor: &Value| -> Vec<Vector> {
        let accessor = &file["accessors"][index(accessor)];
        assert_eq!(
            (&accessor["type"], &accessor["componentType"]),
            (&"VEC3".into(), &5126.into())
        );
        let numbers: Vec<u64> = view(accessor).chunks(4).map(number).collect();
        let vectors: Vec<Vector> = numbers.chunks(3).map(vector).collect();
        assert_eq!(vectors.len(), index(&accessor["count"]));
        for axis in 0..3 {
            let values = || vectors.iter().map(|own| f64::from_bits(own[axis]));
            if let Some(least) = accessor["min"][axis].as_f64() {
                assert_eq!(values().reduce(f64::min), Some(least));
                assert_eq!(values().reduce(f64::max), accessor["max"][axis].as_f64());
            }
        }
        vectors
    };
    let meshes = file["meshes"].as_array().unwrap().iter().map(|mesh| {
        let own = &mesh["primitives"][0];
        assert_eq!(own["mode"], 4);
        assert!(file["accessors"][index(&own["attributes"]["POSITION"])]["min"].is_array());
        let points = vectors(&own["attributes"]["POSITION"]);
        let normals = vectors(&own["attributes"]["NORMAL"]);
        let accessor = &file["accessors"][index(&own["indices"])];
        assert_eq!(accessor["componentType"], 5125);
        let indices: Vec<usize> = view(accessor).chunks(4).map(count).collect();
        assert_eq!(indices.len(), index(&accessor["count"]));
        let facets = indices.chunks(3).map(|own| {
            let own: [usize; 3] = own.try_into().unwrap();
            Facet {
                points: own.map(|own| points[own]),
                normals: own.map(|own| normals[own]),
            }
        });
        (mesh["name"].as_str().unwrap().to_owned(), facets.collect())
    });
    let meshes = meshes.collect();
    (file, meshes)
}
