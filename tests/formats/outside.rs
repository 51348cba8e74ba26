//! Closed shells show their outer side, however their surfaces are written.

use sweepc::export::{Context, Mesh, Precision};
use sweepc::net::{ControlNet, Knots, Model, Part};
use sweepc::number::{Field, Real};

use crate::meshes::{cross, dot, exact, minus};
use crate::{nets, write};

/// The net with other points.
fn changed(net: &ControlNet, change: impl Fn(&[Real; 3]) -> [Real; 3]) -> ControlNet {
    let points = net.points().iter().map(change).collect();
    let (knots_u, knots_v) = (net.knots_u().clone(), net.knots_v().clone());
    ControlNet::new(knots_u, knots_v, net.weights().to_vec(), points).unwrap()
}

/// The net seen in a mirror: R_u × R_v changes its side.
fn mirrored(net: &ControlNet) -> ControlNet {
    changed(net, |[x, y, z]| [x.negated(), y.clone(), z.clone()])
}

/// The net far from the origin.
fn moved(net: &ControlNet) -> ControlNet {
    let by = ["1000", "-2000", "1/3"].map(nets::number);
    changed(net, |own| [0, 1, 2].map(|axis| own[axis].plus(&by[axis])))
}

/// Six times the volume that triangles enclose.
fn volume(mesh: &Mesh) -> Real {
    let start = exact(mesh.vertices[0]);
    let cone = |own| {
        let [a, b, c] = mesh.points(own).map(|own| minus(&exact(own), &start));
        dot(&a, &cross(&b, &c))
    };
    let cones = mesh.triangles.iter().map(cone);
    cones.fold(Real::zero(), |sum, own| sum.plus(&own))
}

/// A cube of six bilinear patches; those of the given numbers have the other side in front.
fn cube(turned: &[usize]) -> Vec<ControlNet> {
    let sides: [[[i64; 3]; 3]; 6] = [
        [[0, 0, 0], [0, 1, 0], [1, 0, 0]],
        [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
        [[0, 0, 0], [1, 0, 0], [0, 0, 1]],
        [[0, 1, 0], [0, 0, 1], [1, 0, 0]],
        [[0, 0, 0], [0, 0, 1], [0, 1, 0]],
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ];
    let side = |(index, [start, u, v]): (usize, &[[i64; 3]; 3])| {
        let (u, v) = if turned.contains(&index) {
            (v, u)
        } else {
            (u, v)
        };
        let at = |[i, j]: [i64; 2]| [0, 1, 2].map(|k| Real::from(start[k] + i * u[k] + j * v[k]));
        let points = [[0, 0], [0, 1], [1, 0], [1, 1]].map(at).to_vec();
        let knots = || Knots::bezier(1, &Real::zero(), &Real::one()).unwrap();
        ControlNet::new(knots(), knots(), vec![Real::one(); 4], points).unwrap()
    };
    sides.iter().enumerate().map(side).collect()
}

#[test]
fn closed_shells_show_their_outer_side() {
    let all = [0, 1, 2, 3, 4, 5];
    let mut shells = vec![cube(&[]), cube(&all), cube(&[0]), cube(&[0, 3, 5])];
    for net in [nets::sphere(), nets::torus()] {
        shells.extend([
            vec![net.clone()],
            vec![mirrored(&net)],
            vec![moved(&mirrored(&net))],
        ]);
    }
    for nets in shells {
        let parts = nets.iter().enumerate();
        let parts = parts.map(|(index, net)| Part::of_net(&format!("R{index}"), net.clone()));
        let model = Model::new(parts.collect());
        let context = Context {
            chord: Some(nets::number("1/4")),
            ..Context::whole("file")
        };
        let mesh = Mesh::of(&model, &context, Precision::Double).unwrap();
        assert!(volume(&mesh).sign().is_gt());
        for triangle in &mesh.triangles {
            let [a, b, c] = mesh.points(triangle).map(exact);
            let facet = cross(&minus(&b, &a), &minus(&c, &a));
            for corner in triangle.corners {
                assert!(
                    dot(&facet, &exact(mesh.normals[corner.normal]))
                        .sign()
                        .is_gt()
                );
            }
        }
        let step = write("step", &model, &context).unwrap();
        assert!(
            String::from_utf8(step.bytes)
                .unwrap()
                .contains("CLOSED_SHELL")
        );
    }
}
