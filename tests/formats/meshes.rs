//! Meshes: their files hold them bit for bit, they have no gaps, and they lie where they should.

use std::collections::HashMap;

use sweepc::diag::Code;
use sweepc::export::{Context, Double, Mesh, Precision, Triangle};
use sweepc::net::{ControlNet, Model, Part, Shell, Side};
use sweepc::number::{Field, Integer, Real, Unit};

use crate::triangles::{Facet, Vector, read_glb, read_obj, read_ply, read_stl};
use crate::{model, nets, write};

/// Surfaces with the Euler characteristic V − E + F of their meshes.
fn surfaces() -> Vec<(&'static str, ControlNet, i64)> {
    vec![
        (
            "quarter cylinder",
            nets::patch(&nets::quarter_cylinder()),
            1,
        ),
        (
            "circle over cubic",
            nets::patch(&nets::circle_over_cubic()),
            1,
        ),
        ("polynomial", nets::patch(&nets::polynomial()), 1),
        ("negative weight", nets::patch(&nets::negative_weight()), 1),
        ("cone", nets::patch(&nets::cone()), 1),
        ("tube", nets::patch(&nets::tube("1 1")), 0),
        ("hemisphere", nets::hemisphere(), 1),
        ("sphere", nets::sphere(), 2),
        ("cylinder", nets::cylinder(), 0),
        ("torus", nets::torus(), 0),
        ("lune", nets::lune(), 1),
        ("teardrop", nets::teardrop(), 0),
        ("moebius", nets::moebius(), 0),
        ("petal", nets::petal(), 0),
        ("bag", nets::patch(&nets::bag()), 2),
        ("apex at a corner", nets::patch(&nets::corner_apex()), 1),
    ]
}

fn context(chord: &str) -> Context<'static> {
    Context {
        chord: Some(nets::number(chord)),
        ..Context::new("file", "R")
    }
}

fn mesh(model: &Model, chord: &str, precision: Precision) -> Mesh {
    Mesh::of(model, &context(chord), precision).unwrap()
}

fn bits(vector: [Double; 3]) -> Vector {
    vector.map(|own| own.value().to_bits())
}

fn facet(mesh: &Mesh, triangle: &Triangle) -> Facet {
    Facet {
        points: mesh.points(triangle).map(bits),
        normals: triangle.corners.map(|own| bits(mesh.normals[own.normal])),
    }
}

/// Two surfaces that share an edge.
fn neighbours() -> Model {
    let net = nets::circle_over_cubic();
    let halves = [("0", "1/2"), ("1/2", "1")].map(|v| nets::on(&net, ("0", "1"), v));
    let names = ["one", "the other"];
    let parts = names
        .iter()
        .zip(halves)
        .map(|(name, net)| Part::of_net(name, net));
    Model::new(parts.collect())
}

#[test]
fn files_hold_the_mesh_bit_for_bit() {
    let mut models: Vec<Model> = surfaces().iter().map(|own| model(&own.1)).collect();
    models.push(neighbours());
    for model in &models {
        let context = context("1");
        let bytes = |format: &str| write(format, model, &context).unwrap().bytes;
        let fine = mesh(model, "1", Precision::Double);
        let coarse = mesh(model, "1", Precision::Single);
        let facets = |mesh: &Mesh, part: Option<usize>| -> Vec<Facet> {
            let own = mesh.triangles.iter();
            let own = own.filter(|own| part.is_none_or(|part| part == own.part));
            own.map(|own| facet(mesh, own)).collect()
        };
        assert_eq!(read_ply(&bytes("ply")).2, facets(&fine, None));
        let points = |facets: Vec<Facet>| facets.into_iter().map(|own| own.points);
        assert!(points(read_stl(&bytes("stl"))).eq(points(facets(&coarse, None))));
        let objects = read_obj(std::str::from_utf8(&bytes("mesh")).unwrap());
        let (_, meshes) = read_glb(&bytes("glb"));
        assert_eq!(objects.len(), model.parts().len());
        assert_eq!(meshes.len(), model.parts().len());
        for (index, part) in model.parts().iter().enumerate() {
            let name = part.name.replace(' ', "_");
            assert_eq!(objects[index], (name, facets(&fine, Some(index))));
            assert_eq!(
                meshes[index],
                (part.name.clone(), facets(&coarse, Some(index)))
            );
        }
    }
}

#[test]
fn a_viewer_gets_metres_and_y_upwards() {
    let net = nets::patch(&nets::quarter_cylinder());
    for (unit, metres) in [
        (Unit::Millimetre, 0.001),
        (Unit::Centimetre, 0.01),
        (Unit::Metre, 1.0),
        (Unit::Inch, 0.0254),
    ] {
        let context = Context {
            unit,
            ..context("1/10")
        };
        let (file, _) = read_glb(&write("glb", &model(&net), &context).unwrap().bytes);
        let root = usize::try_from(file["scenes"][0]["nodes"][0].as_u64().unwrap()).unwrap();
        let matrix: Vec<f64> =
            serde_json::from_value(file["nodes"][root]["matrix"].clone()).unwrap();
        // Columns are images of the axes: x stays, y goes to −z, z to y.
        let images = [
            [metres, 0.0, 0.0, 0.0],
            [0.0, 0.0, -metres, 0.0],
            [0.0, metres, 0.0, 0.0],
        ];
        assert_eq!(matrix[..12], images.concat());
        assert_eq!(matrix[12..], [0.0, 0.0, 0.0, 1.0]);
    }
}

/// How often triangles run through each edge in either direction.
fn edges(mesh: &Mesh) -> HashMap<[usize; 2], [usize; 2]> {
    let mut uses: HashMap<[usize; 2], [usize; 2]> = HashMap::new();
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.corners.map(|own| own.vertex);
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let own = uses.entry([from.min(to), from.max(to)]).or_default();
            own[usize::from(from > to)] += 1;
        }
    }
    uses
}

/// The number of edges of the mesh that lie on an edge of a shell which one face uses once.
fn boundary(model: &Model, mesh: &Mesh) -> usize {
    let shells = model.shells().iter().zip(&mesh.subdivisions);
    let count = shells.map(|(shell, steps)| {
        let mut uses = vec![0; shell.edges.len()];
        shell
            .faces
            .iter()
            .flat_map(|own| own.uses())
            .for_each(|own| uses[own.edge] += 1);
        let open = uses
            .iter()
            .zip(&steps.edges)
            .filter(|(uses, _)| **uses == 1);
        open.map(|(_, steps)| steps).sum::<usize>()
    });
    count.sum()
}

#[test]
fn meshes_are_watertight_where_surfaces_are() {
    let mut models: Vec<_> = surfaces()
        .into_iter()
        .map(|(name, net, euler)| (name, model(&net), euler))
        .collect();
    models.push(("neighbours", neighbours(), 1));
    for (name, model, euler) in &models {
        for chord in ["1/2", "1/9"] {
            let mesh = mesh(model, chord, Precision::Single);
            let uses = edges(&mesh);
            let open = uses
                .values()
                .filter(|own| own.iter().sum::<usize>() == 1)
                .count();
            // Two sides of the petal run along a line and back, and its steps may be folded up.
            if *name != "petal" {
                assert_eq!(open, boundary(model, &mesh), "{name} at {chord}");
            }
            assert!(
                uses.values().all(|own| own.iter().sum::<usize>() <= 2),
                "{name} at {chord}"
            );
            let oriented = model.shells().iter().all(|own| own.orientation().is_some());
            if oriented {
                assert!(uses.values().all(|own| *own <= [1, 1]), "{name} at {chord}");
            }
            let count = |own: usize| i64::try_from(own).unwrap();
            let mut used: Vec<_> = mesh
                .triangles
                .iter()
                .flat_map(|own| own.corners)
                .map(|own| own.vertex)
                .collect();
            used.sort_unstable();
            used.dedup();
            let characteristic =
                count(used.len()) - count(uses.len()) + count(mesh.triangles.len());
            assert_eq!(characteristic, *euler, "{name} at {chord}");
            for triangle in &mesh.triangles {
                let [a, b, c] = mesh.points(triangle);
                assert!(a != b && b != c && c != a, "{name} at {chord}");
            }
        }
    }
}

/// A face of a shell, and parameters there.
type Place = (usize, [Real; 2]);

/// The parameters of all vertices of a shell, each with its face, in the order of a mesh.
fn places(shell: &Shell, mesh: &Mesh, index: usize) -> Vec<Place> {
    let steps = &mesh.subdivisions[index];
    let ratio = |own: usize, all: usize| Real::ratio(Integer::from(own), Integer::from(all));
    let mut vertices = vec![None; shell.vertices.len()];
    let mut edges: Vec<Vec<Option<Place>>> =
        steps.edges.iter().map(|own| vec![None; own - 1]).collect();
    let mut inner = Vec::new();
    for (index, face) in shell.faces.iter().enumerate() {
        let (from_u, to_u) = face.net.knots_u().domain();
        let (from_v, to_v) = face.net.knots_v().domain();
        for (side, own) in face.sides.iter().enumerate() {
            let place = |along: &Real| match side {
                0 => [along.clone(), from_v.clone()],
                1 => [to_u.clone(), along.clone()],
                2 => [along.clone(), to_v.clone()],
                _ => [from_u.clone(), along.clone()],
            };
            match own {
                Side::Point(vertex) => {
                    let start = if side.is_multiple_of(2) {
                        from_u
                    } else {
                        from_v
                    };
                    vertices[*vertex] = Some((index, place(start)));
                }
                Side::Edges(uses) => {
                    for own in uses {
                        let count = steps.edges[own.edge];
                        let edge = &shell.edges[own.edge];
                        for step in 0..=count {
                            let part = own.range.1.minus(&own.range.0);
                            let along = own.range.0.plus(&part.times(&ratio(step, count)));
                            let step = if own.reversed { count - step } else { step };
                            let slot = match step {
                                0 => &mut vertices[edge.start],
                                own if own == count => &mut vertices[edge.end],
                                step => &mut edges[own.edge][step - 1],
                            };
                            *slot = Some((index, place(&along)));
                        }
                    }
                }
            }
        }
        let [m, n] = steps.faces[index];
        for i in 1..m {
            for j in 1..n {
                let u = from_u.plus(&to_u.minus(from_u).times(&ratio(i, m)));
                let v = from_v.plus(&to_v.minus(from_v).times(&ratio(j, n)));
                inner.push((index, [u, v]));
            }
        }
    }
    let outer = vertices.into_iter().chain(edges.into_iter().flatten());
    outer.map(Option::unwrap).chain(inner).collect()
}

/// The exact value of a double: its shortest decimal is read back as it.
fn value(own: f64) -> Real {
    let decimal = format!("{own:?}").parse::<Real>().unwrap();
    Double::nearest(&decimal).unwrap().exact()
}

/// Whether a number of 32 bits is the one nearest to an exact number: no neighbour is nearer.
fn is_nearest_single(own: Double, exact: &Real) -> bool {
    let single = own.value() as f32;
    assert_eq!(f64::from(single).to_bits(), own.value().to_bits());
    let apart = |own: f32| value(f64::from(own)).minus(exact).absolute();
    let [below, above] = [single.next_down(), single.next_up()];
    apart(single) <= apart(below) && apart(single) <= apart(above)
}

#[test]
fn vertices_are_exact_points_rounded_once() {
    for (name, net, _) in surfaces() {
        let model = model(&net);
        let fine = mesh(&model, "1/8", Precision::Double);
        let coarse = mesh(&model, "1/8", Precision::Single);
        let shells = model.shells().iter().enumerate();
        let places = shells.flat_map(|(index, shell)| {
            let places = places(shell, &fine, index).into_iter();
            places.map(|(face, place)| (&shell.faces[face], place))
        });
        let exact: Vec<[Real; 3]> = places
            .map(|(face, [u, v])| face.net.de_casteljau(&u, &v).unwrap())
            .collect();
        assert_eq!(exact.len(), fine.vertices.len(), "{name}");
        for (exact, own) in exact.iter().zip(&fine.vertices) {
            let nearest = exact.each_ref().map(|own| Double::nearest(own).unwrap());
            assert_eq!(*own, nearest, "{name}");
        }
        assert_eq!(coarse.vertices.len(), exact.len(), "{name}");
        for (exact, own) in exact.iter().zip(&coarse.vertices) {
            for (exact, own) in exact.iter().zip(own) {
                assert!(
                    is_nearest_single(*own, exact),
                    "{name}: {own:?} for {exact}"
                );
            }
        }
    }
}

/// Whether a double is the one nearest to a/√s, by squares of the middles between it and its
/// neighbours.
fn is_nearest_root(own: f64, above: &Real, square: &Real) -> bool {
    let middle = |other: f64| value(own).plus(&value(other)).times(&nets::number("1/2"));
    let signed = |own: &Real| {
        let square = own.times(own);
        if own.sign().is_lt() {
            square.negated()
        } else {
            square
        }
    };
    // x ≤ a/√s exactly if sgn(x) x² s ≤ sgn(a) a².
    let image = signed(above);
    let low = signed(&middle(own.next_down())).times(square);
    let high = signed(&middle(own.next_up())).times(square);
    low <= image && image <= high
}

#[test]
fn normals_are_exact_directions_rounded_once() {
    for coordinates in [
        nets::quarter_cylinder(),
        nets::circle_over_cubic(),
        nets::polynomial(),
        nets::cone(),
    ] {
        let model = model(&nets::patch(&coordinates));
        let mesh = mesh(&model, "1/8", Precision::Double);
        let [weight, point @ ..] = &coordinates;
        let places = places(&model.shells()[0], &mesh, 0);
        let mut seen = 0;
        for corner in mesh.triangles.iter().flat_map(|own| own.corners) {
            let [u, v] = &places[corner.vertex].1;
            // The tangents times W², for any weights: W P′ − W′ P.
            let tangent = |along_u: bool| {
                let slope = |own: &sweepc::poly::BiPoly<Real>| {
                    let own = if along_u {
                        own.derivative_u()
                    } else {
                        own.derivative_v()
                    };
                    own.evaluate(u, v)
                };
                point.each_ref().map(|own| {
                    let left = weight.evaluate(u, v).times(&slope(own));
                    left.minus(&slope(weight).times(&own.evaluate(u, v)))
                })
            };
            let (left, right) = (tangent(true), tangent(false));
            let cross = [(1, 2), (2, 0), (0, 1)]
                .map(|(i, j)| left[i].times(&right[j]).minus(&left[j].times(&right[i])));
            let square = cross
                .iter()
                .fold(Real::zero(), |sum, own| sum.plus(&own.times(own)));
            // At the apex of the cone each triangle has the normal in its middle.
            if square.is_zero() {
                continue;
            }
            seen += 1;
            for (own, exact) in mesh.normals[corner.normal].iter().zip(&cross) {
                assert!(
                    is_nearest_root(own.value(), exact, &square),
                    "{own:?} for {exact}²/{square}"
                );
            }
        }
        assert!(seen > 20);
    }
}

pub(super) fn exact(point: [Double; 3]) -> [Real; 3] {
    point.map(Double::exact)
}

pub(super) fn minus(left: &[Real; 3], right: &[Real; 3]) -> [Real; 3] {
    [0, 1, 2].map(|axis| left[axis].minus(&right[axis]))
}

pub(super) fn dot(left: &[Real; 3], right: &[Real; 3]) -> Real {
    let terms = left.iter().zip(right).map(|(own, other)| own.times(other));
    terms.fold(Real::zero(), |sum, own| sum.plus(&own))
}

pub(super) fn cross(left: &[Real; 3], right: &[Real; 3]) -> [Real; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| left[i].times(&right[j]).minus(&left[j].times(&right[i])))
}

#[test]
fn triangles_face_where_their_normals_point() {
    for (name, net, _) in surfaces() {
        // Where these two have no tangent plane, a triangle of any size turns as it likes.
        if ["bag", "moebius", "petal", "apex at a corner"].contains(&name) {
            continue;
        }
        let model = model(&net);
        let mesh = mesh(&model, "1/20", Precision::Double);
        for triangle in &mesh.triangles {
            let [a, b, c] = mesh.points(triangle).map(exact);
            let facet = cross(&minus(&b, &a), &minus(&c, &a));
            for corner in triangle.corners {
                let normal = exact(mesh.normals[corner.normal]);
                assert!(dot(&facet, &normal).sign().is_gt(), "{name}");
            }
        }
    }
}

/// The square of the distance of a point from a segment.
fn square_from_segment(point: &[Real; 3], from: &[Real; 3], to: &[Real; 3]) -> Real {
    let (along, own) = (minus(to, from), minus(point, from));
    let ratio = &dot(&own, &along) / &dot(&along, &along);
    let ratio = ratio.max(Real::zero()).min(Real::one());
    let foot = [0, 1, 2].map(|axis| from[axis].plus(&along[axis].times(&ratio)));
    let apart = minus(point, &foot);
    dot(&apart, &apart)
}

/// The square of the distance of a point from a triangle.
fn square_from_triangle(point: &[Real; 3], corners: &[[Real; 3]; 3]) -> Real {
    let [a, b, c] = corners;
    let normal = cross(&minus(b, a), &minus(c, a));
    let inside = [(a, b), (b, c), (c, a)].iter().all(|(from, to)| {
        let inward = cross(&normal, &minus(to, from));
        !dot(&inward, &minus(point, from)).sign().is_lt()
    });
    let size = dot(&normal, &normal);
    if inside && !size.is_zero() {
        let height = dot(&normal, &minus(point, a));
        return &height.times(&height) / &size;
    }
    let sides = [(a, b), (b, c), (c, a)];
    let sides = sides.map(|(from, to)| square_from_segment(point, from, to));
    sides.into_iter().min().unwrap()
}

#[test]
fn surfaces_are_within_the_stated_bound() {
    for (name, net, _) in surfaces() {
        let model = model(&net);
        for (chord, precision) in [("1/5", Precision::Double), ("1/9", Precision::Single)] {
            let mesh = mesh(&model, chord, precision);
            let bound = &mesh.chord_error;
            assert!(
                bound.sign().is_gt() && *bound <= nets::number(chord),
                "{name}: {bound}"
            );
            let square = bound.times(bound);
            for face in model.shells().iter().flat_map(|own| &own.faces) {
                let place = |(from, to): (&Real, &Real), at: &str| {
                    from.plus(&to.minus(from).times(&nets::number(at)))
                };
                for (u, v) in [
                    ("1/7", "1/11"),
                    ("1/2", "2/3"),
                    ("0", "3/13"),
                    ("19/20", "1"),
                    ("61/64", "17/31"),
                ] {
                    let u = place(face.net.knots_u().domain(), u);
                    let v = place(face.net.knots_v().domain(), v);
                    let point = face.net.de_casteljau(&u, &v).unwrap();
                    let nearest = nearest(&mesh, &point);
                    let distance = square_from_triangle(&point, &mesh.points(nearest).map(exact));
                    assert!(distance <= square, "{name} at {chord}, ({u}, {v})");
                }
            }
        }
    }
}

#[allow(
    clippy::float_arithmetic,
    reason = "doubles choose what is looked at exactly"
)]
/// The triangle nearest to a point: of a few that are near by samples in doubles, exactly.
fn nearest<'a>(mesh: &'a Mesh, point: &[Real; 3]) -> &'a Triangle {
    const STEPS: u8 = 4;
    let seen = point
        .each_ref()
        .map(|own| Double::nearest(own).unwrap().value());
    let order = |own: &Triangle| -> f64 {
        let [a, b, c] = mesh.points(own).map(|own| own.map(Double::value));
        let part = |own: u8| f64::from(own) / f64::from(STEPS);
        let places = (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| (part(i), part(j))));
        let squares = places.map(|(s, t)| -> f64 {
            let apart = |axis: usize| {
                a[axis] + s * (b[axis] - a[axis]) + t * (c[axis] - a[axis]) - seen[axis]
            };
            [0, 1, 2].map(|axis| apart(axis).powi(2)).iter().sum()
        });
        squares.fold(f64::INFINITY, f64::min)
    };
    let mut near: Vec<(f64, &Triangle)> =
        mesh.triangles.iter().map(|own| (order(own), own)).collect();
    near.sort_by(|one, other| one.0.total_cmp(&other.0));
    let exactly = |own: &&Triangle| square_from_triangle(point, &mesh.points(own).map(exact));
    let few = near.into_iter().take(6).map(|own| own.1);
    few.min_by_key(exactly).unwrap()
}

#[test]
fn a_finer_tolerance_has_more_triangles() {
    let model = model(&nets::patch(&nets::circle_over_cubic()));
    let counts = ["1/2", "1/20", "1/200", "1/2000"]
        .map(|own| mesh(&model, own, Precision::Double).triangles.len());
    assert!(counts.is_sorted_by(|one, other| one < other), "{counts:?}");
    let plane = nets::patch(&nets::quarter_cylinder());
    let mesh = mesh(&crate::model(&plane), "1/1000", Precision::Double);
    assert_eq!(mesh.subdivisions[0].faces[0][1], 2);
}

#[test]
fn the_tolerance_is_a_thousandth_of_the_size() {
    // The box of the control points has the sides 1, 1, 1.
    let model = model(&nets::patch(&nets::quarter_cylinder()));
    let own = Mesh::of(&model, &Context::new("file", "R"), Precision::Double).unwrap();
    let same = mesh(&model, "1/1000", Precision::Double);
    assert_eq!(
        (own.triangles, own.chord_error),
        (same.triangles, same.chord_error)
    );
}

#[test]
fn what_a_format_does_not_resolve_is_refused() {
    let parabola = [
        nets::sum(&[("1", "1")]),
        nets::sum(&[("0 1", "1")]),
        nets::sum(&[("1", "0 1")]),
        nets::sum(&[("0 0 1", "1")]),
    ];
    let far = nets::on(&parabola, ("1000000", "1000001"), ("0", "1"));
    let refused = |format: &str, net: &ControlNet, chord: &str| {
        write(format, &model(net), &context(chord)).map(|_| ())
    };
    let code = |format: &str, net: &ControlNet, chord: &str| {
        refused(format, net, chord).map_err(|own| own.code)
    };
    // 10⁶ has steps of 1/16 in 32 bits, and u² = 10¹² steps of 2¹⁶.
    assert_eq!(code("stl", &far, "1/100"), Err(Code::E0308));
    assert_eq!(code("glb", &far, "1/100"), Err(Code::E0308));
    assert_eq!(code("ply", &far, "1/100"), Ok(()));
    assert_eq!(code("mesh", &far, "1e-20"), Err(Code::E0308));
    let help = |format: &str| refused(format, &far, "1e-20").unwrap_err().help;
    assert!(help("stl").contains("`ply`") && !help("ply").contains("`ply`"));
    // The tolerance is there, but neighbours become equal: 2²⁴ + v, in steps of 2.
    let near = nets::patch(&[
        nets::sum(&[("1", "1")]),
        nets::sum(&[("16777216 1", "1")]),
        nets::sum(&[("16777216", "1"), ("1", "0 1")]),
        nets::sum(&[("16777216", "1")]),
    ]);
    assert_eq!(code("stl", &near, "1000"), Err(Code::E0308));
    let huge = nets::patch(&[
        nets::sum(&[("1", "1")]),
        nets::sum(&[("0 1e39", "1")]),
        nets::sum(&[("1", "0 1")]),
        nets::sum(&[("0 0 1", "1")]),
    ]);
    assert_eq!(code("stl", &huge, "1e37"), Err(Code::E0306));
    assert_eq!(code("ply", &huge, "1e37"), Ok(()));
}

#[test]
fn triangles_have_a_limit() {
    let net = nets::patch(&nets::circle_over_cubic());
    let mesh = mesh(&model(&net), "1/100", Precision::Double);
    let count = mesh.triangles.len();
    for (limit, fits) in [(count, true), (count - 1, false)] {
        let mut context = context("1/100");
        context.limits.triangles = limit;
        let written = Mesh::of(&model(&net), &context, Precision::Double);
        let expected = if fits { Ok(()) } else { Err(Code::E0511) };
        assert_eq!(written.map(|_| ()).map_err(|own| own.code), expected);
    }
}
