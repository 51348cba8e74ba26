use std::collections::HashMap;

use crate::curve::{Fault, Parameter, PropertyFunction};
use crate::diag::{Code, Diagnostic, Limits};
use crate::number::{Field, Real, Tower};
use crate::poly::{BiPoly, Fraction};

use super::bound::predicted_degree;
use super::square_root::square_root;
use super::{CurveProperty, Domain, Form, NormalFault, Scalar, Vector, unit_normal};

/// Multiplies expressions out to unreduced fractions of polynomials in u and v.
///
/// Products never cancel, sums go over the least common multiple of their denominators, and the
/// properties of curves enter as the papers write them. A shared part is expanded once.
#[derive(Debug)]
pub struct Expander<'a> {
    domain: &'a Domain,
    tower: &'a Tower,
    limits: &'a Limits,
    /// The expression is kept beside its expansion, so that its identity stays its own.
    expanded: HashMap<usize, (Scalar, Fraction<Real>)>,
}

/// What an expression expands to.
pub type Expanded = Fraction<Real>;

type Found<T> = Result<T, Box<Diagnostic>>;

impl<'a> Expander<'a> {
    /// An expander for expressions that are used on a domain; it matters for the sign of roots.
    /// The tower grows where a square root of a number needs it.
    #[must_use]
    pub fn new(domain: &'a Domain, tower: &'a Tower, limits: &'a Limits) -> Self {
        Self {
            domain,
            tower,
            limits,
            expanded: HashMap::new(),
        }
    }

    /// The fraction that an expression is, as it is written.
    ///
    /// # Errors
    ///
    /// Division by zero (E0207), a square root that is not rational (E0210), a normal
    /// that is not (E0307), a property that a curve does not have (E02xx), and the limits: on
    /// degree and number of terms (E0505), which are checked before anything is multiplied, and
    /// on the degree of the field (E0509).
    pub fn expand(&mut self, expression: &Scalar) -> Found<Fraction<Real>> {
        self.check_size(expression)?;
        self.fraction(expression)
    }

    /// The fractions of three coordinates.
    ///
    /// # Errors
    ///
    /// As [`Expander::expand`].
    pub fn expand_vector(&mut self, vector: &Vector) -> Found<[Fraction<Real>; 3]> {
        let [x, y, z] = vector;
        Ok([self.expand(x)?, self.expand(y)?, self.expand(z)?])
    }

    /// The number that an expression is.
    ///
    /// # Errors
    ///
    /// As [`Expander::expand`]; the value is none if the expression depends on u or v.
    pub fn constant(&mut self, expression: &Scalar) -> Found<Option<Real>> {
        if let Some(number) = expression.as_number() {
            return Ok(Some(number.clone()));
        }
        Ok(self.expand(expression)?.as_constant())
    }

    fn check_size(&self, expression: &Scalar) -> Found<()> {
        let degree = predicted_degree(expression);
        let terms = (degree.u.saturating_add(1)).saturating_mul(degree.v.saturating_add(1));
        let high = degree.u.max(degree.v);
        let excess = if high > self.limits.degree {
            format!(
                "degree {high}, the limit is {} (`--max-degree`)",
                self.limits.degree
            )
        } else if terms > self.limits.terms {
            format!(
                "{terms} terms, the limit is {} (`--max-terms`)",
                self.limits.terms
            )
        } else {
            return Ok(());
        };
        let message = format!("this expands to {excess}");
        Err(Box::new(
            Diagnostic::new(Code::E0505, expression.span(), message)
                .label(format!("bidegree up to {degree}")),
        ))
    }

    fn fraction(&mut self, expression: &Scalar) -> Found<Fraction<Real>> {
        if let Form::Constant(value) = expression.form() {
            return Ok(Fraction::constant(value));
        }
        if let Some((_, fraction)) = self.expanded.get(&expression.identity()) {
            return Ok(fraction.clone());
        }
        let fraction = self.fraction_of_form(expression)?;
        self.expanded.insert(
            expression.identity(),
            (expression.clone(), fraction.clone()),
        );
        Ok(fraction)
    }

    fn fraction_of_form(&mut self, expression: &Scalar) -> Found<Fraction<Real>> {
        let zero_division = || division_by_zero(expression);
        match expression.form() {
            Form::Constant(value) => Ok(Fraction::constant(value)),
            Form::Parameter(parameter) => Ok(variable(*parameter)),
            Form::Sum(terms) => self.sum(terms),
            Form::Product(factors) => self.product(factors),
            Form::Power(base, exponent) => self
                .fraction(base)?
                .power(*exponent)
                .ok_or_else(zero_division),
            Form::Property(property, argument) => self.property(expression, property, argument),
            Form::Partial(Parameter::U, body) => Ok(self.fraction(body)?.derivative_u()),
            Form::Partial(Parameter::V, body) => Ok(self.fraction(body)?.derivative_v()),
            Form::OnDomain(body, domain) if **domain == *self.domain => self.fraction(body),
            Form::OnDomain(body, domain) => {
                Expander::new(domain, self.tower, self.limits).fraction(body)
            }
            Form::Substitution { body, .. } if body.is_rooted() => {
                Err(Box::new(undecided_sign(expression)))
            }
            Form::Substitution { body, u, v } => {
                let (u, v) = (self.fraction(u)?, self.fraction(v)?);
                self.fraction(body)?
                    .compose(&u, &v)
                    .ok_or_else(zero_division)
            }
            Form::SquareRoot(body) => {
                let radicand = self.fraction(body)?;
                square_root(&radicand, self.domain, self.tower, expression.span())
            }
            Form::Normal(surface, axis) => {
                let expanded = self.expand_vector(surface)?;
                let normal = unit_normal(&expanded, self.domain, self.tower)
                    .map_err(|fault| normal_finding(&fault, expression))?;
                Ok(normal[axis.index()].clone())
            }
        }
    }

    fn sum(&mut self, terms: &[Scalar]) -> Found<Fraction<Real>> {
        let mut sum = Fraction::constant(&Real::zero());
        for term in terms {
            sum = sum.plus(&self.fraction(term)?);
        }
        Ok(sum)
    }

    fn product(&mut self, factors: &[Scalar]) -> Found<Fraction<Real>> {
        let mut product = Fraction::constant(&Real::one());
        for factor in factors {
            product = product.times(&self.fraction(factor)?);
        }
        Ok(product)
    }

    fn property(
        &mut self,
        expression: &Scalar,
        of: &CurveProperty,
        argument: &Scalar,
    ) -> Found<Fraction<Real>> {
        let mut function = of
            .curve
            .property(of.property)
            .map_err(|fault| curve_finding(&fault, of, expression))?;
        for _ in 0..of.derivative {
            function = function.derivative();
        }
        if let Form::Parameter(parameter) = argument.form() {
            return in_parameter(&function, *parameter).ok_or_else(|| division_by_zero(expression));
        }
        let at = self.fraction(argument)?;
        let outer = in_parameter(&function, Parameter::U);
        let zero = Fraction::constant(&Real::zero());
        outer
            .and_then(|outer| outer.compose(&at, &zero))
            .ok_or_else(|| division_by_zero(expression))
    }
}

/// The finding for a derivative of a root whose argument is replaced afterwards: the sign that
/// the root has on the replaced argument's range is not the one it has where it stands.
fn undecided_sign(expression: &Scalar) -> Diagnostic {
    let message = "the sign of a square root or a normal is not decided here";
    Diagnostic::new(Code::E0210, expression.span(), message)
        .note(
            "it is differentiated, or belongs to another surface, before its argument is replaced",
        )
        .help("differentiate the expression in which the argument is replaced: `dv(f(v + 2))`")
}

fn variable(parameter: Parameter) -> Fraction<Real> {
    let linear = crate::poly::UniPoly::variable();
    Fraction::polynomial(match parameter {
        Parameter::U => BiPoly::in_u(&linear),
        Parameter::V => BiPoly::in_v(&linear),
    })
}

/// A function of one parameter as a fraction in u and v.
fn in_parameter(function: &PropertyFunction, parameter: Parameter) -> Option<Fraction<Real>> {
    let place = |polynomial| match parameter {
        Parameter::U => BiPoly::in_u(polynomial),
        Parameter::V => BiPoly::in_v(polynomial),
    };
    Fraction::quotient(&place(&function.numerator), &place(&function.denominator))
}

fn division_by_zero(expression: &Scalar) -> Box<Diagnostic> {
    let zero = match expression.form() {
        Form::Power(base, _) => base.span(),
        _ => expression.span(),
    };
    let finding = Diagnostic::new(Code::E0207, zero, "division by zero")
        .label("this is zero for all parameters, or where it is evaluated");
    Box::new(if zero == expression.span() {
        finding
    } else {
        finding.related(expression.span(), "in this quotient")
    })
}

fn normal_finding(fault: &NormalFault, expression: &Scalar) -> Box<Diagnostic> {
    Box::new(Diagnostic::new(fault.code(), expression.span(), fault.message()).help(fault.help()))
}

fn curve_finding(fault: &Fault, of: &CurveProperty, expression: &Scalar) -> Box<Diagnostic> {
    let message = fault.message(of.curve.name());
    let mut finding = Diagnostic::new(fault.code(), expression.span(), message);
    finding
        .notes
        .extend(fault.evidence(of.curve.name(), of.curve.parameter()));
    Box::new(finding)
}
