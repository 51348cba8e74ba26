//! The curves of a record, from their numbers in memory: the part of `lower` that is no text.

use std::hint::black_box;
use std::time::{Duration, Instant};

use sweepc::curve::kinds::{self, Arguments, Setting, Value};
use sweepc::curve::{Axis, Curve, Homogeneous, Interval, Parameter, Plane, Property};
use sweepc::number::{Real, Tower};
use sweepc::poly::{Quotient, UniPoly};

/// The numbers that a sweep curve is made from.
pub(crate) enum Sweep {
    /// The start, and Bernstein coefficients of the preimage.
    Preimage(Arguments),
    /// Power coefficients of x and y.
    Coordinates([Vec<Real>; 2]),
}

/// The numbers that both curves are made from, and what the formula asks of the sweep curve.
pub(crate) struct Curves {
    /// The field of the numbers.
    pub(crate) tower: Tower,
    pub(crate) sweep: Sweep,
    /// Power coefficients of X, Z, D.
    pub(crate) profile: [Vec<Real>; 3],
    pub(crate) properties: Vec<fn(Axis) -> Property>,
}

impl Sweep {
    pub(crate) fn of_preimage(start: [Real; 2], pairs: Vec<Vec<Real>>) -> Self {
        let values = [Value::Point(start.into()), Value::Points(pairs)];
        let values = values.into_iter().map(Some).chain([None]);
        Self::Preimage(Arguments(values.collect()))
    }
}

impl Curves {
    /// The time for both curves, through the functions that `compile` calls; and the curves.
    #[inline(never)]
    pub(crate) fn measure(&self) -> (Duration, [Curve; 2]) {
        let start = Instant::now();
        let curves = black_box([self.profile(), self.sweep()]);
        (start.elapsed(), curves)
    }

    fn sweep(&self) -> Curve {
        let (tower, domain, plane) = (&self.tower, Interval::unit(), Some(Plane::Xy));
        let curve = |position: Homogeneous| {
            let (domain, tower) = (domain.clone(), tower.clone());
            Curve::new(String::new(), plane, Parameter::V, domain, position, tower)
        };
        let curve = match &self.sweep {
            Sweep::Preimage(arguments) => {
                let setting = Setting {
                    domain: &domain,
                    tower,
                };
                let kind = kinds::ALL.iter().find(|own| own.name == "ph");
                let coordinates = kind.map(|own| (own.build)(arguments, &setting));
                let Some(Ok(coordinates)) = coordinates else {
                    unreachable!("{arguments:?}");
                };
                let Some(position) = coordinates.in_space(plane) else {
                    unreachable!("{coordinates:?}");
                };
                curve(position).built(coordinates)
            }
            Sweep::Coordinates(own) => {
                let [x, y] = own.each_ref().map(|own| UniPoly::from_coefficients(own));
                curve(Homogeneous::polynomial([x, y, UniPoly::zero()]))
            }
        };
        for property in &self.properties {
            for axis in Axis::ALL {
                let found = curve.property(property(axis));
                assert!(found.is_ok(), "{found:?}");
            }
        }
        black_box(curve.cusps());
        curve
    }

    fn profile(&self) -> Curve {
        let [x, z, d] = self
            .profile
            .each_ref()
            .map(|own| UniPoly::from_coefficients(own));
        let quotient = |own| Quotient::new(own, &d).unwrap_or_else(|| unreachable!("1/0"));
        let zero = Quotient::polynomial(UniPoly::zero());
        let position = Homogeneous::from_quotients(&[quotient(&x), zero, quotient(&z)]);
        let (domain, tower) = (Interval::unit(), self.tower.clone());
        let plane = Some(Plane::Xz);
        Curve::new(String::new(), plane, Parameter::U, domain, position, tower)
    }
}
