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
