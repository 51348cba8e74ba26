use crate::net::{ControlNet, CurveNet};
use crate::number::{Field, Integer, Real, Ring, lcm};
use crate::poly::{BiDegree, BiPoly, bernstein};

/// The numerators of exact numbers.
pub(super) type Numerator = <Real as Field>::Ring;

/// N functions on the unit square by their Bernstein coefficients, i by i and j within i, over one
/// positive denominator that is left out: it is of no account for quotients and directions.
pub(super) struct Tensor<const N: usize> {
    degree: BiDegree,
    coefficients: Vec<[Numerator; N]>,
}

impl Tensor<4> {
    /// W, X, Y, Z of a net of one span; its domain becomes the unit square.
    pub(super) fn of_net(net: &ControlNet) -> Self {
        let row = |i| (0..net.columns()).map(move |j| net.homogeneous(i, j));
        let controls: Vec<_> = (0..net.rows()).flat_map(row).collect();
        Self::new(net.degree(), &controls)
    }

    /// W, X, Y, Z of a curve, along the first parameter.
    pub(super) fn of_curve(curve: &CurveNet) -> Self {
        Self::new(BiDegree::new(curve.degree(), 0), &curve.homogeneous())
    }
}

impl<const N: usize> Tensor<N> {
    /// Polynomials on a rectangle u × v, which becomes the unit square.
    pub(super) fn of_polynomials(
        polynomials: [&BiPoly<Real>; N],
        u: (&Real, &Real),
        v: (&Real, &Real),
    ) -> Self {
        let bidegrees = polynomials.iter().filter_map(|own| own.bidegree());
        let degree = bidegrees
            .reduce(BiDegree::max)
            .unwrap_or(BiDegree::new(0, 0));
        let count = (degree.u + 1) * (degree.v + 1);
        let mut coefficients = vec![std::array::from_fn(|_| Real::zero()); count];
        for (axis, polynomial) in polynomials.into_iter().enumerate() {
            // Terms may cancel above the bidegree; a polynomial in rows has no such terms.
            for (power, row) in polynomial.rows().iter().enumerate() {
                let in_u = crate::poly::UniPoly::one().shift(power);
                let in_u = bernstein(&in_u, degree.u, u.0, u.1);
                let in_v = bernstein(row, degree.v, v.0, v.1);
                for (index, own) in coefficients.iter_mut().enumerate() {
                    let (i, j) = (index / (degree.v + 1), index % (degree.v + 1));
                    own[axis] = own[axis].plus(&in_u[i].times(&in_v[j]));
                }
            }
        }
        Self::new(degree, &coefficients)
    }

    fn new(degree: BiDegree, coefficients: &[[Real; N]]) -> Self {
        let all = || coefficients.iter().flatten();
        let denominator = all().fold(Integer::one(), |all, own| lcm(&all, own.denominator()));
        let scaled = |own: &Real| own.numerator().scaled(&(&denominator / own.denominator()));
        let coefficients = coefficients.iter().map(|own| own.each_ref().map(scaled));
        Self {
            degree,
            coefficients: coefficients.collect(),
        }
    }

    /// The coefficients of one function.
    pub(super) fn coefficients(&self, axis: usize) -> impl Iterator<Item = &Numerator> {
        self.coefficients.iter().map(move |own| &own[axis])
    }

    /// The functions of the first parameter where the second is given.
    pub(super) fn at_v(&self, v: &Real) -> Row<N> {
        let basis = basis(self.degree.v, v);
        let rows = self.coefficients.chunks_exact(basis.len());
        Row(rows.map(|row| combined(row, &basis)).collect())
    }

    /// Values at places along both parameters, v by v and u within, up to positive factors.
    pub(super) fn grid(
        &self,
        u: &[Real],
        v: &[Real],
        mut each: impl FnMut(usize, usize, [Numerator; N]),
    ) {
        let bases: Vec<_> = u.iter().map(|own| basis(self.degree.u, own)).collect();
        for (j, v) in v.iter().enumerate() {
            let row = self.at_v(v);
            for (i, basis) in bases.iter().enumerate() {
                each(i, j, combined(&row.0, basis));
            }
        }
    }
}

/// N functions of one parameter of [0, 1] by their Bernstein coefficients.
pub(super) struct Row<const N: usize>(Vec<[Numerator; N]>);

impl<const N: usize> Row<N> {
    /// The values at a parameter, up to a common positive factor.
    pub(super) fn at(&self, place: &Real) -> [Numerator; N] {
        combined(&self.0, &basis(self.0.len() - 1, place))
    }
}

/// C(n, i) kⁱ (d − k)ⁿ⁻ⁱ for a parameter k/d: the Bernstein polynomials times dⁿ.
fn basis(degree: usize, place: &Real) -> Vec<Numerator> {
    let (own, whole) = place.parts();
    let rest = Numerator::from_integer(whole).minus(own);
    let mut powers = vec![Numerator::one()];
    for index in 0..degree {
        powers.push(powers[index].times(&rest));
    }
    let (mut power, mut binomial) = (Numerator::one(), Integer::one());
    let mut basis = Vec::with_capacity(degree + 1);
    for index in 0..=degree {
        basis.push(power.times(&powers[degree - index]).scaled(&binomial));
        power = power.times(own);
        binomial = binomial * Integer::from(degree - index) / Integer::from(index + 1);
    }
    basis
}

fn combined<const N: usize>(rows: &[[Numerator; N]], basis: &[Numerator]) -> [Numerator; N] {
    std::array::from_fn(|axis| {
        let mut sum = Numerator::zero();
        for (row, factor) in rows.iter().zip(basis) {
            sum.add_product(&row[axis], factor);
        }
        sum
    })
}
