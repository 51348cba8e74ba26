//! The files of every example as the kernel truck reads them: STEP and its own JSON.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_arithmetic,
    missing_docs,
    reason = "a file that cannot be read has failed; truck stores products of doubles"
)]

mod example_files;
mod support;

use std::collections::BTreeSet;
use std::fs;

use support::{Compiled, compile};
use sweepc::export::{ALL, Exporter};
use sweepc::net::{ControlNet, Part};
use sweepc::number::{Field, Real};
use sweepc::pipeline::Options;
use truck_stepio::r#in::Table;
use truck_stepio::r#in::alias::{
    BSplineSurface, KnotVec, NurbsSurface, ParametricSurface, Point3, Surface, Vector4,
};

/// Coordinates of points may differ by so many units in the last place of their range, since truck
/// computes in doubles; and by so many where a degree is 13 or more.
const ULPS: (i64, i64) = (4, 8);

/// Where points are compared, as shares of a patch.
const SHARES: [&str; 4] = ["0", "5/16", "1/2", "1"];

/// A surface as truck holds it: knots, and points (wx, wy, wz, w).
struct Read {
    knots: [Vec<f64>; 2],
    points: Vec<Vec<[f64; 4]>>,
    at: Box<dyn Fn(f64, f64) -> [f64; 3]>,
}

fn knots(own: &KnotVec) -> Vec<f64> {
    own.iter().copied().collect()
}

impl Read {
    fn of(surface: &Surface) -> Self {
        match surface {
            Surface::BSplineSurface(own) => Self::polynomial(own),
            Surface::NurbsSurface(own) => Self::rational(own),
            other => panic!("{other:?}"),
        }
    }

    fn polynomial(own: &BSplineSurface<Point3>) -> Self {
        let rows = own.control_points().iter();
        let rows = rows.map(|row| row.iter().map(|own| [own.x, own.y, own.z, 1.0]).collect());
        let surface = own.clone();
        Self {
            knots: [knots(own.uknot_vec()), knots(own.vknot_vec())],
            points: rows.collect(),
            at: Box::new(move |u, v| surface.subs(u, v).into()),
        }
    }

    fn rational(own: &NurbsSurface<Vector4>) -> Self {
        let rows = own.control_points().iter();
        let rows = rows.map(|row| row.iter().map(|own| (*own).into()).collect());
        let surface = own.clone();
        Self {
            knots: [knots(own.uknot_vec()), knots(own.vknot_vec())],
            points: rows.collect(),
            at: Box::new(move |u, v| surface.subs(u, v).into()),
        }
    }

    /// The ends of the domain along u, or along v.
    fn ends(&self, axis: usize) -> [Real; 2] {
        let knots = &self.knots[axis];
        [knots[0], knots[knots.len() - 1]].map(exact)
    }

    /// The part of a net that it should be; none if its domain is no part of the net's.
    fn part_of(&self, net: &ControlNet) -> Option<ControlNet> {
        let (u, v) = (self.ends(0), self.ends(1));
        let part = net.restricted((&u[0], &u[1]), (&v[0], &v[1]))?;
        let degree = |axis: usize, points: usize| self.knots[axis].len() - points - 1;
        let (rows, columns) = (self.points.len(), self.points[0].len());
        let degree = sweepc::poly::BiDegree::new(degree(0, rows), degree(1, columns));
        part.elevated(degree)
    }

    /// Whether its numbers are those of a part of a net.
    fn is_part_of(&self, net: &ControlNet) -> bool {
        let points = self.points.iter().flatten();
        let bits: Vec<_> = points.map(|own| own.map(f64::to_bits)).collect();
        self.part_of(net)
            .is_some_and(|part| products(&part) == bits)
    }

    /// The same surface with its parameters exchanged.
    fn exchanged(self) -> Self {
        let [u, v] = self.knots;
        let columns = self.points[0].len();
        let column = |j: usize| self.points.iter().map(|row| row[j]).collect();
        Self {
            knots: [v, u],
            points: (0..columns).map(column).collect(),
            at: Box::new(move |u, v| (self.at)(v, u)),
        }
    }
}

/// A double as the number that it is.
fn exact(value: f64) -> Real {
    let bits = value.abs().to_bits();
    let (biased, fraction) = ((bits >> 52), bits & ((1 << 52) - 1));
    let leading = if biased > 0 { 1 << 52 } else { 0 };
    let mantissa = Real::from(i64::try_from(fraction | leading).unwrap());
    let step = i64::try_from(biased.max(1)).unwrap() - 1_075;
    let size = mantissa.times(&Real::power_of_two(step));
    if value < 0.0 { size.negated() } else { size }
}

/// The double nearest to a number.
fn nearest(exact: &Real) -> f64 {
    sweepc::export::Double::nearest(exact).unwrap().value()
}

/// The products that truck makes of the doubles in a STEP file.
fn products(net: &ControlNet) -> Vec<[u64; 4]> {
    let points = net.weights().iter().zip(net.points());
    let product = |(weight, point): (&Real, &[Real; 3])| {
        let weight = nearest(weight);
        let [x, y, z] = point.each_ref().map(|own| nearest(own) * weight);
        [x, y, z, weight].map(f64::to_bits)
    };
    points.map(product).collect()
}

/// The doubles of the exact products.
fn premultiplied(net: &ControlNet) -> Vec<[u64; 4]> {
    let points = net.weights().iter().zip(net.points());
    let product = |(weight, point): (&Real, &[Real; 3])| {
        let [x, y, z] = point.each_ref().map(|own| nearest(&own.times(weight)));
        [x, y, z, nearest(weight)].map(f64::to_bits)
    };
    points.map(product).collect()
}

/// The points of a surface that was read lie where the exact ones do.
fn points_agree(read: &Read, net: &ControlNet, name: &str) {
    let range = range(net);
    let high = net.degree().u.max(net.degree().v) >= 13;
    let ulps = Real::from(if high { ULPS.1 } else { ULPS.0 });
    let allowed = Real::power_of_two(range.binade().unwrap() - 52).times(&ulps);
    let ([from_u, to_u], [from_v, to_v]) = (read.ends(0), read.ends(1));
    let between = |from: &Real, to: &Real, share: &str| {
        let share: Real = share.parse().unwrap();
        from.plus(&to.minus(from).times(&share))
    };
    for (one, other) in SHARES
        .iter()
        .flat_map(|one| SHARES.map(|other| (*one, other)))
    {
        let (u, v) = (between(&from_u, &to_u, one), between(&from_v, &to_v, other));
        let expected = net.de_casteljau(&u, &v).unwrap();
        let found = (read.at)(nearest(&u), nearest(&v));
        for (own, expected) in found.into_iter().zip(&expected) {
            let apart = exact(own).minus(expected).absolute();
            assert!(
                apart <= allowed,
                "{name} at {one}, {other}: {}",
                apart.brief()
            );
        }
    }
}

/// The largest difference of two coordinates of control points along an axis, or a coordinate
/// itself where the surface is far from the origin.
fn range(net: &ControlNet) -> Real {
    let axis = |axis: usize| {
        let values = || net.points().iter().map(move |own| &own[axis]);
        let (least, greatest) = (values().min().unwrap(), values().max().unwrap());
        let sizes = [least.absolute(), greatest.absolute(), greatest.minus(least)];
        sizes.into_iter().max().unwrap()
    };
    [0, 1, 2].map(axis).into_iter().max().unwrap()
}

/// A file in one format.
fn written(compiled: &Compiled, index: usize, format: &str) -> String {
    let exporter: Vec<&Exporter> = ALL.iter().filter(|own| own.name == format).collect();
    let surface = compiled.compilation.sound_surfaces().nth(index).unwrap();
    let options = Options::default();
    let mut files = compiled
        .compilation
        .export(surface, &exporter, "file", &options);
    let (_, exported) = files.next().unwrap();
    String::from_utf8(exported.unwrap().bytes).unwrap()
}

/// The exact nets of the surfaces of a compiled file.
fn nets(compiled: &Compiled) -> Vec<ControlNet> {
    let parts = compiled.compilation.sound_surfaces().map(Part::of);
    parts.map(|own| own.unwrap().net).collect()
}

/// Every example with its name.
fn examples() -> Vec<(String, Compiled)> {
    let files = example_files::sweeps(&example_files::folder());
    let compiled = |path: &std::path::PathBuf| {
        let text = fs::read_to_string(path).unwrap();
        (example_files::name(path), compile(&text))
    };
    files.iter().map(compiled).collect()
}

#[test]
fn truck_reads_the_faces_and_edges_of_step_files() {
    for (name, compiled) in examples() {
        for (index, net) in nets(&compiled).iter().enumerate() {
            let name = format!("{name}, surface {index}");
            let table = Table::from_step(&written(&compiled, index, "step")).unwrap();
            assert_eq!(table.shell.len(), 1, "{name}");
            let shell = table.shell.values().next().unwrap();
            let shell = table.to_compressed_shell(shell).unwrap();
            let mut area = Real::zero();
            for face in &shell.faces {
                let read = Read::of(&face.surface);
                let part = read.part_of(net).unwrap();
                let bits = read
                    .points
                    .iter()
                    .flatten()
                    .map(|own| own.map(f64::to_bits));
                assert_eq!(bits.collect::<Vec<_>>(), products(&part), "{name}");
                points_agree(&read, &part, &name);
                let [u, v] = [read.ends(0), read.ends(1)].map(|[from, to]| to.minus(&from));
                area = area.plus(&u.times(&v));
                // Each edge of the boundary is one of the shell's, and used once by this face.
                let edges: Vec<_> = face
                    .boundaries
                    .iter()
                    .flatten()
                    .map(|own| own.index)
                    .collect();
                let different: BTreeSet<_> = edges.iter().collect();
                assert_eq!(different.len(), edges.len(), "{name}");
                assert!(edges.iter().all(|own| *own < shell.edges.len()), "{name}");
            }
            let (u, v) = (net.knots_u().domain(), net.knots_v().domain());
            assert_eq!(area, u.1.minus(u.0).times(&v.1.minus(v.0)), "{name}");
            // Two faces side by side share an edge and its ends.
            let uses = shell
                .faces
                .iter()
                .flat_map(|own| own.boundaries.iter().flatten());
            let shared = uses.count() - shell.edges.len();
            assert!(shared >= shell.faces.len() - 1, "{name}");
        }
    }
}

#[test]
fn truck_reads_surfaces_that_are_joined_in_step_files() {
    let mut joined = 0;
    for (name, compiled) in examples() {
        let exporter: Vec<&Exporter> = ALL.iter().filter(|own| own.name == "step").collect();
        let options = Options::default();
        let mut files = compiled
            .compilation
            .export_together(&exporter, "file", &options);
        let Some((_, exported)) = files.next() else {
            continue;
        };
        let table = Table::from_step(std::str::from_utf8(&exported.unwrap().bytes).unwrap());
        let table = table.unwrap();
        let shells = table.shell.values();
        let shells = shells.map(|own| table.to_compressed_shell(own).unwrap());
        let mut faces = 0;
        for shell in shells {
            for face in &shell.faces {
                let nets = nets(&compiled);
                let read = Read::of(&face.surface);
                let owned = nets.iter().any(|net| read.is_part_of(net));
                // A face whose other side is outside has its parameters exchanged.
                let read = read.exchanged();
                let owner = owned || nets.iter().any(|net| read.is_part_of(net));
                assert!(owner, "{name}");
            }
            faces += shell.faces.len();
        }
        assert!(faces >= nets(&compiled).len(), "{name}");
        joined += 1;
    }
    assert!(joined > 0);
}

#[test]
fn truck_reads_its_own_json() {
    for (name, compiled) in examples() {
        for (index, net) in nets(&compiled).iter().enumerate() {
            let text = written(&compiled, index, "truck");
            let surface: NurbsSurface<Vector4> = serde_json::from_str(&text).unwrap();
            let read = Read::rational(&surface);
            let bits = read
                .points
                .iter()
                .flatten()
                .map(|own| own.map(f64::to_bits));
            assert_eq!(bits.collect::<Vec<_>>(), premultiplied(net), "{name}");
            points_agree(&read, net, &format!("{name}, surface {index}"));
        }
    }
}
