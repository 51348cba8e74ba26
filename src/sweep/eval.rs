//! The slow, obvious road: a formula evaluated at exact rational numbers.
//!
//! Nothing here multiplies polynomials out. Derivatives come from Taylor coefficients, σ is the
//! square root of a number, and the arc length integrates a polynomial through values of σ. It
//! serves to check the fast road in tests, and is no part of the compiler.

use crate::curve::{Axis, Curve, Parameter, Property};
use crate::number::{Field, Real, Tower};
use crate::poly::UniPoly;

use super::{CurveProperty, Form, Scalar, Vector};

/// The point of a surface at (u, v); none where the formula divides by zero there, takes the
/// root of a number that is not a square, or meets a cusp.
#[must_use]
pub fn evaluate_slowly(
    coordinates: &Vector,
    u: &Real,
    v: &Real,
    tower: &Tower,
) -> Option<[Real; 3]> {
    let at = |own: &Scalar| Some(jet(own, u, v, 0, tower)?.value().clone());
    let [x, y, z] = coordinates;
    Some([at(x)?, at(y)?, at(z)?])
}

/// The Taylor coefficients cᵢⱼ of (u − u₀)ⁱ (v − v₀)ʲ with i + j ≤ order, as `rows[i][j]`.
#[derive(Clone)]
struct Jet {
    order: usize,
    rows: Vec<Vec<Real>>,
}

impl Jet {
    fn zero(order: usize) -> Self {
        let rows = (0..=order)
            .map(|i| vec![Real::zero(); order - i + 1])
            .collect();
        Self { order, rows }
    }

    fn constant(order: usize, value: &Real) -> Self {
        let mut jet = Self::zero(order);
        jet.rows[0][0] = value.clone();
        jet
    }

    fn variable(order: usize, parameter: Parameter, at: &Real) -> Self {
        let mut jet = Self::constant(order, at);
        if order > 0 {
            match parameter {
                Parameter::U => jet.rows[1][0] = Real::one(),
                Parameter::V => jet.rows[0][1] = Real::one(),
            }
        }
        jet
    }

    fn value(&self) -> &Real {
        &self.rows[0][0]
    }

    fn nilpotent(&self) -> Self {
        let mut jet = self.clone();
        jet.rows[0][0] = Real::zero();
        jet
    }

    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (row, own) in sum.rows.iter_mut().zip(&other.rows) {
            for (left, right) in row.iter_mut().zip(own) {
                *left = &*left + right;
            }
        }
        sum
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero(self.order);
        for (i, row) in self.rows.iter().enumerate() {
            for (j, left) in row.iter().enumerate().filter(|(_, own)| !own.is_zero()) {
                for (k, other_row) in other.rows.iter().enumerate().take(self.order + 1 - i - j) {
                    for (l, right) in other_row
                        .iter()
                        .enumerate()
                        .take(self.order + 1 - i - j - k)
                    {
                        product.rows[i + k][j + l] = &product.rows[i + k][j + l] + &(left * right);
                    }
                }
            }
        }
        product
    }

    fn scale(&self, factor: &Real) -> Self {
        self.times(&Self::constant(self.order, factor))
    }

    /// Σ cₖ hᵏ, h the part without constant term.
    fn series(&self, coefficients: &[Real]) -> Self {
        let step = self.nilpotent();
        coefficients
            .iter()
            .rev()
            .fold(Self::zero(self.order), |value, own| {
                value.times(&step).plus(&Self::constant(self.order, own))
            })
    }

    /// 1/(a + h) = Σ (−h)ᵏ / aᵏ⁺¹
    fn inverse(&self) -> Option<Self> {
        let inverse = self.value().inverse()?;
        let ratio = inverse.negated();
        let coefficients = std::iter::successors(Some(inverse), |last| Some(last * &ratio));
        Some(self.series(&coefficients.take(self.order + 1).collect::<Vec<_>>()))
    }

    /// √(a + h) = √a Σ binomial(1/2, k) (h/a)ᵏ
    fn square_root(&self, tower: &Tower) -> Option<Self> {
        let root = tower.root_in_field(self.value())?;
        if self.order == 0 {
            return Some(Self::constant(0, &root));
        }
        let inverse = self.value().inverse()?;
        let mut coefficients = vec![root];
        for k in 0..self.order {
            let k = i64::try_from(k).ok()?;
            let ratio = &Real::from(1 - 2 * k) / &Real::from(2 * k + 2);
            let next = &(&coefficients[coefficients.len() - 1] * &ratio) * &inverse;
            coefficients.push(next);
        }
        Some(self.series(&coefficients))
    }

    /// The jet of the derivative, of one order less.
    fn derivative(&self, parameter: Parameter) -> Self {
        let mut jet = Self::zero(self.order.saturating_sub(1));
        for i in 0..=jet.order {
            for j in 0..=jet.order - i {
                let (source, factor) = match parameter {
                    Parameter::U => (&self.rows[i + 1][j], i + 1),
                    Parameter::V => (&self.rows[i][j + 1], j + 1),
                };
                let factor = Real::from(i64::try_from(factor).unwrap_or_default());
                jet.rows[i][j] = source * &factor;
            }
        }
        jet
    }

    fn truncate(&self, order: usize) -> Self {
        let mut jet = Self::zero(order);
        for (row, own) in jet.rows.iter_mut().zip(&self.rows) {
            let length = row.len();
            row.clone_from_slice(&own[..length]);
        }
        jet
    }

    /// The Taylor coefficients in u alone.
    fn column(&self) -> Vec<Real> {
        self.rows.iter().map(|row| row[0].clone()).collect()
    }
}

fn jet(expression: &Scalar, u: &Real, v: &Real, order: usize, tower: &Tower) -> Option<Jet> {
    let inner = |part: &Scalar| jet(part, u, v, order, tower);
    match expression.form() {
        Form::Constant(value) => Some(Jet::constant(order, value)),
        Form::Parameter(Parameter::U) => Some(Jet::variable(order, Parameter::U, u)),
        Form::Parameter(Parameter::V) => Some(Jet::variable(order, Parameter::V, v)),
        Form::Polynomial(parameter, own) => {
            let at = match parameter {
                Parameter::U => u,
                Parameter::V => v,
            };
            let at = Jet::variable(order, *parameter, at);
            let coefficients = own.coefficients().into_iter().rev();
            Some(coefficients.fold(Jet::zero(order), |value, own| {
                value.times(&at).plus(&Jet::constant(order, &own))
            }))
        }
        Form::Sum(terms) => terms
            .iter()
            .try_fold(Jet::zero(order), |sum, term| Some(sum.plus(&inner(term)?))),
        Form::Product(factors) => factors
            .iter()
            .try_fold(Jet::constant(order, &Real::one()), |product, own| {
                Some(product.times(&inner(own)?))
            }),
        Form::Power(base, exponent) => {
            let base = inner(base)?;
            let base = if *exponent < 0 { base.inverse()? } else { base };
            let one = Jet::constant(order, &Real::one());
            Some((0..exponent.unsigned_abs()).fold(one, |power, _| power.times(&base)))
        }
        Form::Property(of, argument) => {
            let argument = inner(argument)?;
            let taylor = taylor(of, argument.value(), order, tower)?;
            Some(argument.series(&taylor))
        }
        Form::Partial(parameter, body) => {
            Some(jet(body, u, v, order + 1, tower)?.derivative(*parameter))
        }
        Form::Substitution {
            body,
            u: to_u,
            v: to_v,
        } => {
            let (to_u, to_v) = (inner(to_u)?, inner(to_v)?);
            let outer = jet(body, to_u.value(), to_v.value(), order, tower)?;
            let rows: Vec<Jet> = outer.rows.iter().map(|row| to_v.series(row)).collect();
            let step = to_u.nilpotent();
            Some(
                rows.iter()
                    .rev()
                    .fold(Jet::zero(order), |value, row| value.times(&step).plus(row)),
            )
        }
        Form::SquareRoot(body) => inner(body)?.square_root(tower),
        Form::OnDomain(body, _) => inner(body),
        Form::Normal(surface, axis) => normal(surface, *axis, (u, v), order, tower),
    }
}

fn normal(
    surface: &Vector,
    axis: Axis,
    (u, v): (&Real, &Real),
    order: usize,
    tower: &Tower,
) -> Option<Jet> {
    let [x, y, z] = surface
        .each_ref()
        .map(|own| jet(own, u, v, order + 1, tower));
    let point = [x?, y?, z?];
    let along = |parameter| point.each_ref().map(|own| own.derivative(parameter));
    let (in_u, in_v) = (along(Parameter::U), along(Parameter::V));
    let minus = Real::from(-1);
    let cross = [(1, 2), (2, 0), (0, 1)].map(|(i, j): (usize, usize)| {
        in_u[i]
            .times(&in_v[j])
            .plus(&in_u[j].times(&in_v[i]).scale(&minus))
    });
    let squared = cross
        .iter()
        .fold(Jet::zero(order), |sum, own| sum.plus(&own.times(own)));
    Some(cross[axis.index()].times(&squared.square_root(tower)?.inverse()?))
}

/// The Taylor coefficients of a property at a parameter, up to the order.
fn taylor(of: &CurveProperty, at: &Real, order: usize, tower: &Tower) -> Option<Vec<Real>> {
    let extra = usize::try_from(of.derivative).ok()?;
    let mut jet = property(&of.curve, of.property, at, order + extra, tower)?;
    for _ in 0..extra {
        jet = jet.derivative(Parameter::U);
    }
    Some(jet.column())
}

fn property(
    curve: &Curve,
    property: Property,
    at: &Real,
    order: usize,
    tower: &Tower,
) -> Option<Jet> {
    let position = position(curve, at, order + 2)?;
    let slope = position.each_ref().map(|own| own.derivative(Parameter::U));
    let bend = slope.each_ref().map(|own| own.derivative(Parameter::U));
    let squared = slope
        .iter()
        .fold(Jet::zero(order + 1), |sum, own| sum.plus(&own.times(own)));
    let speed = || squared.truncate(order).square_root(tower);
    let plane = || {
        let (first, second) = curve.plane()?.axes();
        Some((first, second, &slope[first.index()], &slope[second.index()]))
    };
    let curvature = || {
        let (first, second, a, b) = plane()?;
        let (a, b) = (a.truncate(order), b.truncate(order));
        let minus = Real::from(-1);
        let turning = a
            .times(&bend[second.index()])
            .plus(&b.times(&bend[first.index()]).scale(&minus));
        let speed = speed()?;
        Some(turning.times(&speed.times(&speed).times(&speed).inverse()?))
    };
    match property {
        Property::Position(axis) => Some(position[axis.index()].truncate(order)),
        Property::Hodograph(axis) => Some(slope[axis.index()].truncate(order)),
        Property::Speed => speed(),
        Property::ArcLength => {
            let mut length = Jet::constant(order, &arc_length(curve, at, tower)?);
            for (power, own) in speed()?.column().iter().enumerate().take(order) {
                let divisor = Real::from(i64::try_from(power + 1).ok()?);
                length.rows[power + 1][0] = own / &divisor;
            }
            Some(length)
        }
        Property::Tangent(axis) => Some(
            slope[axis.index()]
                .truncate(order)
                .times(&speed()?.inverse()?),
        ),
        Property::Normal(axis) => {
            let (first, second, a, b) = plane()?;
            let top = if axis == first {
                b.truncate(order)
            } else if axis == second {
                a.truncate(order).scale(&Real::from(-1))
            } else {
                Jet::zero(order)
            };
            Some(top.times(&speed()?.inverse()?))
        }
        Property::Curvature => curvature(),
        Property::RadiusOfCurvature => curvature()?.inverse(),
    }
}

fn position(curve: &Curve, at: &Real, order: usize) -> Option<[Jet; 3]> {
    let variable = Jet::variable(order, Parameter::U, at);
    let horner = |polynomial: &UniPoly<Real>| {
        polynomial
            .coefficients()
            .iter()
            .rev()
            .fold(Jet::zero(order), |value, own| {
                value.times(&variable).plus(&Jet::constant(order, own))
            })
    };
    let inverse = horner(&curve.position().weight).inverse()?;
    Some(
        curve
            .position()
            .coordinates
            .each_ref()
            .map(|own| horner(own).times(&inverse)),
    )
}

/// The arc length of a polynomial curve by integrating the polynomial through values of σ; that
/// of a rational curve is taken from the curve.
fn arc_length(curve: &Curve, at: &Real, tower: &Tower) -> Option<Real> {
    if !curve.position().is_polynomial() {
        return curve.property(Property::ArcLength).ok()?.evaluate(at);
    }
    let count = i64::try_from(curve.position().degree().max(1)).ok()?;
    let mut through = UniPoly::zero();
    let mut nodes = UniPoly::one();
    for index in 0..count {
        let node = curve.domain().fraction(index, count);
        let value = property(curve, Property::Speed, &node, 0, tower)?
            .value()
            .clone();
        let rest = &value - &through.evaluate(&node);
        through = &through + &nodes.scale(&(&rest / &nodes.evaluate(&node)));
        nodes = &nodes * &(&UniPoly::variable() - &UniPoly::constant(&node));
    }
    let length = through.antiderivative();
    Some(&length.evaluate(at) - &length.evaluate(curve.domain().start()))
}
