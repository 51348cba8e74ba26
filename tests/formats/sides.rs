//! Normals where R_u × R_v is 0 inside a surface, between sides that face opposite ways.

use sweepc::export::{Context, Mesh, Precision};
use sweepc::net::ControlNet;
use sweepc::number::Field;

use crate::meshes::{cross, dot, exact, minus};
use crate::{model, nets};

/// Surfaces whose R_u × R_v has the factor 1 − 2u, and what stays there of it.
fn surfaces() -> [(&'static str, ControlNet); 3] {
    let cone = |u: &'static str| {
        [
            nets::sum(&[("1", "1 0 1")]),
            nets::sum(&[(u, "1 0 -1")]),
            nets::sum(&[(u, "0 2")]),
            nets::sum(&[(u, "1 0 1")]),
        ]
    };
    let cusp = [
        nets::sum(&[("1", "1")]),
        nets::sum(&[("1 -4 4", "1")]),
        nets::sum(&[("1", "0 1")]),
        nets::sum(&[("-1 6 -12 8", "1")]),
    ];
    [
        ("an apex inside", nets::patch(&cone("-1 2"))),
        ("an apex inside, from above", nets::patch(&cone("1 -2"))),
        ("a cuspidal edge", nets::patch(&cusp)),
    ]
}

/// Each triangle has the limits of the normals on its own side.
#[test]
fn triangles_on_both_sides_face_where_their_normals_point() {
    for (name, net) in surfaces() {
        let context = Context {
            chord: Some(nets::number("1/20")),
            ..Context::new("file", "R")
        };
        for precision in [Precision::Single, Precision::Double] {
            let mesh = Mesh::of(&model(&net), &context, precision).unwrap();
            let mut met = [0, 0];
            for triangle in &mesh.triangles {
                let [a, b, c] = mesh.points(triangle).map(exact);
                let facet = cross(&minus(&b, &a), &minus(&c, &a));
                for corner in triangle.corners {
                    let [x, y, z] = exact(mesh.vertices[corner.vertex]);
                    let normal = exact(mesh.normals[corner.normal]);
                    assert!(dot(&facet, &normal).sign().is_gt(), "{name}");
                    let is_between = match name {
                        "a cuspidal edge" => x.is_zero() && z.is_zero(),
                        _ => [x, y, z].iter().all(Field::is_zero),
                    };
                    if is_between {
                        met[usize::from(normal[2].sign().is_lt())] += 1;
                    }
                }
            }
            // both sides come to the place, as many triangles each, and see it from opposite sides
            assert!(met[0] > 2 && met[0] == met[1], "{name}: {met:?}");
        }
    }
}
