#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use crate::export::{ExportFault, RoundedNet};
use crate::net::ControlNet;

use super::spline::{Lattice, Spline};
use super::vector::{Vector, cross, unit};

/// A surface in doubles, for drawing: the homogeneous control points of the surface and of its
/// derivatives, each formed exactly and rounded once.
pub(super) struct ApproxSurface {
    value: Spline,
    along_u: Spline,
    along_v: Spline,
}

/// A point of a surface with its tangents R_u, R_v and its unit normal; a zero normal where it
/// has none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sample {
    pub(super) place: [f64; 2],
    pub(super) point: Vector,
    pub(super) tangents: [Vector; 2],
    pub(super) normal: Vector,
}

impl ApproxSurface {
    /// - **errors** a number beyond the last double (E0306)
    pub(super) fn new(net: &ControlNet) -> Result<Self, ExportFault> {
        RoundedNet::new(net)?;
        let value = Lattice::of(net);
        Ok(Self {
            along_u: value.derivative_u().rounded(),
            along_v: value.transposed().derivative_u().transposed().rounded(),
            value: value.rounded(),
        })
    }

    /// The ends of the domain along u and along v.
    pub(super) fn domain(&self) -> [[f64; 2]; 2] {
        self.value.domain()
    }

    /// The point and the normal R_u × R_v / ‖R_u × R_v‖ at parameters of the domain.
    ///
    /// R_u = (P_u − W_u R) / W for R = P / W.
    pub(super) fn sample(&self, u: f64, v: f64) -> Sample {
        let [weight, x, y, z] = self.value.at(u, v);
        let point = [x / weight, y / weight, z / weight];
        let tangents = [&self.along_u, &self.along_v].map(|own| {
            let [rate, x, y, z] = own.at(u, v);
            let along = [x, y, z];
            [0, 1, 2].map(|axis| (along[axis] - rate * point[axis]) / weight)
        });
        Sample {
            place: [u, v],
            point,
            tangents,
            normal: unit(cross(tangents[0], tangents[1])),
        }
    }

    /// The point at a step of the parameters from a place, or where the step leaves the domain.
    pub(super) fn beside(&self, place: [f64; 2], step: [f64; 2]) -> Vector {
        let [[from_u, to_u], [from_v, to_v]] = self.domain();
        let u = (place[0] + step[0]).clamp(from_u, to_u);
        let v = (place[1] + step[1]).clamp(from_v, to_v);
        self.sample(u, v).point
    }
}
