//! Surfaces that share boundary curves exactly are sewn to shells.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod nets;

use nets::{number, on};
use sweepc::net::{ControlNet, CurveNet, Model, Part, Shell, Side, Use};
use sweepc::number::{Field, Real};
use sweepc::poly::BiDegree;

fn model(nets: &[ControlNet]) -> Model {
    let parts = nets.iter().enumerate();
    let parts = parts.map(|(index, net)| Part::of_net(&format!("R{index}"), net.clone()));
    Model::new(parts.collect())
}

/// Faces, edges and vertices.
fn counts(shell: &Shell) -> (usize, usize, usize) {
    let Shell {
        faces,
        edges,
        vertices,
    } = shell;
    (faces.len(), edges.len(), vertices.len())
}

fn curve(controls: &[[&str; 4]]) -> CurveNet {
    let controls: Vec<_> = controls.iter().map(|own| own.map(number)).collect();
    CurveNet::from_homogeneous(&controls).unwrap()
}

/// Every edge as a side uses it runs along the side of the face's own net.
fn edges_lie_on_their_faces(shell: &Shell) {
    for face in &shell.faces {
        let (from_u, to_u) = face.net.knots_u().domain();
        let (from_v, to_v) = face.net.knots_v().domain();
        let [south, east, north, west] = &face.sides;
        let along_u = |side, v: &Real| runs_along(shell, side, |u| face.net.de_casteljau(u, v));
        let along_v = |side, u: &Real| runs_along(shell, side, |v| face.net.de_casteljau(u, v));
        along_u(south, from_v);
        along_v(east, to_u);
        along_u(north, to_v);
        along_v(west, from_u);
    }
}

fn runs_along(shell: &Shell, side: &Side, at: impl Fn(&Real) -> Option<[Real; 3]>) {
    let Side::Edges(uses) = side else {
        return;
    };
    for Use {
        edge,
        reversed,
        range: (from, to),
    } in uses
    {
        let edge = &shell.edges[*edge];
        for local in ["0", "1/3", "1/2", "1"].map(number) {
            let parameter = from.plus(&to.minus(from).times(&local));
            let back = Real::one().minus(&local);
            let own = if *reversed { back } else { local };
            assert_eq!(edge.curve.de_casteljau(&own), at(&parameter));
            assert_eq!(edge.row.de_casteljau(&own), at(&parameter));
        }
        assert_eq!(edge.curve.start(), &shell.vertices[edge.start]);
        assert_eq!(edge.curve.end(), &shell.vertices[edge.end]);
        assert_eq!(edge.curve.reduced(), edge.curve);
    }
}

#[test]
fn a_patch_alone_is_a_shell_of_its_own() {
    for (net, expected) in [
        (nets::patch(&nets::quarter_cylinder()), (1, 4, 4)),
        (nets::patch(&nets::cone()), (1, 3, 3)),
        (nets::folded(), (1, 3, 3)),
    ] {
        let model = model(&[net]);
        let [shell] = model.shells() else {
            panic!("one patch, one shell");
        };
        assert_eq!(counts(shell), expected);
        edges_lie_on_their_faces(shell);
        assert!(!model.is_connected_across_parts());
    }
}

#[test]
fn neighbours_share_their_edge_whatever_its_degree_and_direction() {
    let surface = nets::circle_over_cubic();
    let left = on(&surface, ("0", "1/2"), ("0", "1"));
    let right = on(&surface, ("1/2", "1"), ("0", "1"));
    // The same with u and v exchanged and with a factor in common: other degrees, weights, sides.
    let factor = nets::sum(&[("5 2", "1 1")]);
    let turned = surface.each_ref().map(|own| &own.transpose() * &factor);
    let turned = on(&turned, ("0", "1"), ("1/2", "1"));
    for other in [right, turned] {
        let model = model(&[left.clone(), other]);
        let [shell] = model.shells() else {
            panic!("neighbours are one shell");
        };
        assert_eq!(counts(shell), (2, 6, 5));
        edges_lie_on_their_faces(shell);
        assert!(model.is_connected_across_parts());
    }
    let distant = on(&surface, ("3/4", "1"), ("0", "1"));
    let apart = model(&[left, distant]);
    assert_eq!(apart.shells().len(), 2);
    assert!(!apart.is_connected_across_parts());
}

#[test]
fn shells_are_independent_of_what_lies_between() {
    let surface = nets::quarter_cylinder();
    let piece = |from, to| on(&surface, (from, to), ("0", "1"));
    let model = model(&[
        piece("0", "1/4"),
        nets::folded(),
        piece("1/2", "1"),
        piece("1/4", "1/2"),
    ]);
    let parts: Vec<Vec<usize>> = model
        .shells()
        .iter()
        .map(|shell| shell.faces.iter().map(|face| face.part).collect())
        .collect();
    assert_eq!(parts, [vec![0, 2, 3], vec![1]]);
    assert_eq!(counts(&model.shells()[0]), (3, 10, 8));
    model.shells().iter().for_each(edges_lie_on_their_faces);
}

#[test]
fn a_curve_has_one_reduced_net() {
    // (1 + t)(1 + t², 1 − t², 2t, 0), its half on [0, 1/2] and the plain arc
    let arc = curve(&[
        ["1", "1", "0", "0"],
        ["1", "1", "1", "0"],
        ["2", "0", "2", "0"],
    ]);
    assert_eq!(arc.reduced(), arc);
    for degree in 3..6 {
        let raised = arc.elevated(degree);
        assert_eq!(raised.degree(), degree);
        assert_eq!(raised.reduced(), arc);
        assert_eq!(raised.reversed().reduced(), arc.reversed());
    }
    let (zero, half) = (number("0"), number("1/2"));
    let left = arc.between(&zero, &half).unwrap();
    for at in ["0", "1/3", "1"].map(number) {
        assert_eq!(left.de_casteljau(&at), arc.de_casteljau(&at.times(&half)));
        let back = Real::one().minus(&at);
        assert_eq!(arc.reversed().de_casteljau(&at), arc.de_casteljau(&back));
    }
    let point = curve(&[["1", "3", "0", "1"], ["2", "6", "0", "2"]]);
    assert!(point.is_point() && !arc.is_point());
}

#[test]
fn an_edge_is_split_where_a_neighbour_ends() {
    let surface = nets::circle_over_cubic();
    let piece = |u, v| on(&surface, u, v);
    let long = piece(("0", "1/2"), ("0", "1"));
    let [lower, upper] = [("0", "1/3"), ("1/3", "1")].map(|v| piece(("1/2", "3/4"), v));
    // One side against two, whichever comes first.
    for nets in [
        [long.clone(), lower.clone(), upper.clone()],
        [lower.clone(), upper.clone(), long.clone()],
    ] {
        let model = model(&nets);
        assert_eq!(model.shells().len(), 1);
        assert_eq!(counts(&model.shells()[0]), (3, 10, 8));
        edges_lie_on_their_faces(&model.shells()[0]);
    }
    // Sides that overlap by a third: neither is a part of the other.
    let early = piece(("0", "1/2"), ("0", "2/3"));
    let model = model(&[early, upper.clone()]);
    assert_eq!(counts(&model.shells()[0]), (2, 9, 8));
    edges_lie_on_their_faces(&model.shells()[0]);
    let ranges = |face: usize, side: usize| match &model.shells()[0].faces[face].sides[side] {
        Side::Edges(uses) => uses.iter().map(|own| own.range.clone()).collect::<Vec<_>>(),
        Side::Point(_) => Vec::new(),
    };
    let range = |from, to| (number(from), number(to));
    assert_eq!(ranges(0, 1), [range("0", "1/3"), range("1/3", "2/3")]);
    assert_eq!(ranges(1, 3), [range("1/3", "2/3"), range("2/3", "1")]);
}

/// Faces on both sides of an edge run through it in opposite directions.
fn is_oriented(shell: &Shell, flipped: &[bool]) -> bool {
    let mut senses = vec![Vec::new(); shell.edges.len()];
    for (face, flipped) in shell.faces.iter().zip(flipped) {
        for (place, side) in face.sides.iter().enumerate() {
            let Side::Edges(uses) = side else {
                continue;
            };
            for own in uses {
                let along = (place < 2) != own.reversed;
                senses[own.edge].push(along != *flipped);
            }
        }
    }
    senses.iter().all(|own| match own.as_slice() {
        [_] => true,
        [one, other] => one != other,
        _ => false,
    })
}

#[test]
fn faces_are_turned_so_that_they_agree_along_edges() {
    let surface = nets::circle_over_cubic();
    let left = on(&surface, ("0", "1/2"), ("0", "1"));
    let right = on(&surface, ("1/2", "3/4"), ("0", "1"));
    let turned = surface.each_ref().map(|own| own.transpose());
    let turned = on(&turned, ("0", "1"), ("1/2", "3/4"));
    for (other, expected) in [(right, [false, false]), (turned, [false, true])] {
        let model = model(&[left.clone(), other]);
        let shell = &model.shells()[0];
        assert_eq!(shell.orientation().as_deref(), Some(expected.as_slice()));
        assert!(is_oriented(shell, &expected));
        assert!(!is_oriented(shell, &[expected[0], !expected[1]]));
        assert!(!shell.is_closed());
    }
    for (net, closed) in [
        (nets::sphere(), true),
        (nets::torus(), true),
        (nets::cylinder(), false),
        (nets::hemisphere(), false),
    ] {
        let model = model(&[net]);
        let shell = &model.shells()[0];
        let flipped = shell.orientation().unwrap();
        assert!(is_oriented(shell, &flipped));
        assert_eq!(shell.is_closed(), closed);
    }
    let moebius = Part::of_net("R", nets::moebius()).divided(2, 1);
    let model = Model::new(vec![moebius]);
    assert_eq!(model.shells()[0].orientation(), None);
    assert!(!model.shells()[0].is_closed());
}

#[test]
fn a_surface_that_is_there_twice_is_no_neighbour_of_itself() {
    let surface = nets::circle_over_cubic();
    let net = on(&surface, ("0", "1"), ("0", "1"));
    let turned = surface.each_ref().map(|own| own.transpose());
    let turned = on(&turned, ("0", "1"), ("0", "1"));
    let other = on(&surface, ("0", "1"), ("1", "2"));
    assert!(!model(&[net.clone(), net.clone()]).is_connected_across_parts());
    assert!(!model(&[net.clone(), turned]).is_connected_across_parts());
    assert!(model(&[net, other]).is_connected_across_parts());
}

#[test]
fn parts_and_elevations_of_a_net_are_the_surface() {
    for (net, u, v) in [
        (
            nets::patch(&nets::circle_over_cubic()),
            ("1/3", "1"),
            ("0", "1/7"),
        ),
        (
            nets::patch(&nets::negative_weight()),
            ("0", "2/3"),
            ("1/5", "1"),
        ),
        (nets::torus(), ("1", "2"), ("5/2", "3")),
        (nets::sphere(), ("7/2", "15/4"), ("0", "1")),
    ] {
        let (u, v) = ((number(u.0), number(u.1)), (number(v.0), number(v.1)));
        let part = net.restricted((&u.0, &u.1), (&v.0, &v.1)).unwrap();
        let degree = part.degree();
        let raised = part
            .elevated(BiDegree::new(degree.u + 2, degree.v + 1))
            .unwrap();
        assert_eq!(raised.degree(), BiDegree::new(degree.u + 2, degree.v + 1));
        for local in ["0", "1/4", "1/2", "1"].map(number) {
            let at_u = u.0.plus(&u.1.minus(&u.0).times(&local));
            let at_v = v.1.minus(&v.1.minus(&v.0).times(&local));
            let expected = net.de_casteljau(&at_u, &at_v);
            assert!(expected.is_some());
            assert_eq!(part.de_casteljau(&at_u, &at_v), expected);
            assert_eq!(raised.de_casteljau(&at_u, &at_v), expected);
        }
        assert_eq!(part.elevated(BiDegree::new(0, degree.v)), None);
    }
    // The polar form agrees with the conversion from the polynomials.
    let (from, middle, to) = (number("0"), number("2/7"), number("1"));
    let surface = nets::circle_over_cubic();
    let whole = nets::patch(&surface);
    assert_eq!(
        whole.restricted((&middle, &to), (&from, &middle)).unwrap(),
        on(&surface, ("2/7", "1"), ("0", "2/7"))
    );
    // Not across a knot, not outside.
    let torus = nets::torus();
    let (half, beyond) = (number("1/2"), number("9/2"));
    assert_eq!(
        torus.restricted((&half, &number("3/2")), (&from, &to)),
        None
    );
    assert_eq!(
        torus.restricted((&from, &to), (&number("4"), &beyond)),
        None
    );
    assert_eq!(torus.restricted((&to, &to), (&from, &to)), None);
    assert_eq!(torus.elevated(BiDegree::new(3, 3)), None);
}
