use sweepc::export::Double;
use sweepc::net::ControlNet;
use sweepc::number::{Field, Real};

/// A rational surface as a file tells it: the index along v rises first.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface {
    pub(crate) degrees: [usize; 2],
    pub(crate) knots: [Vec<u64>; 2],
    pub(crate) points: Vec<Vec<u64>>,
}

impl Surface {
    /// What a format must hold that stores x, y, z and the weight.
    pub(crate) fn affine(net: &ControlNet) -> Self {
        Self::of(net, |weight, [x, y, z]| {
            [x.clone(), y.clone(), z.clone(), weight.clone()]
        })
    }

    /// What a format must hold that stores wx, wy, wz and w: doubles of the exact products.
    pub(crate) fn premultiplied(net: &ControlNet) -> Self {
        Self::of(net, |weight, point| {
            let [x, y, z] = point.each_ref().map(|own| own.times(weight));
            [x, y, z, weight.clone()]
        })
    }

    fn of(net: &ControlNet, store: impl Fn(&Real, &[Real; 3]) -> [Real; 4]) -> Self {
        let double = |exact: &Real| bits(Double::nearest(exact).unwrap().value());
        let points = net.weights().iter().zip(net.points());
        let points = points.map(|(weight, point)| store(weight, point));
        let knots = [net.knots_u(), net.knots_v()];
        Self {
            degrees: [net.degree().u, net.degree().v],
            knots: knots.map(|own| own.values().iter().map(double).collect()),
            points: points.map(|own| own.iter().map(double).collect()).collect(),
        }
    }

    /// The surface of a list of points in which the index along u rises first.
    pub(crate) fn transposed(self) -> Self {
        let rows = self.knots[0].len() - self.degrees[0] - 1;
        let columns = self.points.len() / rows;
        let places = (0..rows).flat_map(|i| (0..columns).map(move |j| j * rows + i));
        Self {
            points: places.map(|own| self.points[own].clone()).collect(),
            ..self
        }
    }
}

/// The bits of a double that is a number, and no negative zero.
pub(crate) fn bits(value: f64) -> u64 {
    assert!(value.is_finite() && (value != 0.0 || value.is_sign_positive()));
    value.to_bits()
}
