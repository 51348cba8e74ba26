use std::collections::BTreeMap;
use std::rc::Rc;

use crate::curve::{Fault, Parameter};
use crate::diag::{Code, Diagnostic, Limits};
use crate::number::{Field, Real, Tower};
use crate::poly::{BiDegree, Fraction, Quotient};

use super::bound::Counter;
use super::square_root::{root_of_number, square_root};
use super::{CurveProperty, Domain, Expanded, Form, NormalFault, Scalar, Vector, unit_normal};

/// Multiplies expressions out to unreduced fractions of polynomials in u and v.
///
/// Products never cancel, sums go over the least common multiple of their denominators, and the
/// properties of curves enter as the papers write them. A shared part is expanded once.
#[derive(Debug)]
pub struct Expander<'a> {
    domain: &'a Domain,
    tower: &'a Tower,
    limits: &'a Limits,
    counter: Counter,
    /// The expression is kept beside its expansion, so that its identity stays its own.
    expanded: BTreeMap<usize, (Scalar, Expanded)>,
}

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
            counter: Counter::default(),
            expanded: BTreeMap::new(),
        }
    }

    /// The function that an expression is, as it is written.
    ///
    /// # Errors
    ///
    /// Division by zero (E0207), a square root that is not rational (E0210), a normal
    /// that is not (E0307), a property that a curve does not have (E02xx), and the limits: on
    /// degree and number of terms (E0505), which are checked before anything is multiplied, and
    /// on the degree of the field (E0509).
    pub fn expand(&mut self, expression: &Scalar) -> Found<Expanded> {
        self.check_size(expression)?;
        self.expanded(expression)
    }

    /// The fractions of three coordinates.
    ///
    /// # Errors
    ///
    /// As [`Expander::expand`].
    pub fn expand_vector(&mut self, vector: &Vector) -> Found<[Fraction<Real>; 3]> {
        let [x, y, z] = vector.each_ref().map(|own| self.expand(own));
        Ok([x?.into_fraction(), y?.into_fraction(), z?.into_fraction()])
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

    fn check_size(&mut self, expression: &Scalar) -> Found<()> {
        let size = |degree: BiDegree| {
            let terms = (degree.u.saturating_add(1)).saturating_mul(degree.v.saturating_add(1));
            (degree.u.max(degree.v), terms)
        };
        let fits = |(high, terms)| high <= self.limits.degree && terms <= self.limits.terms;
        let bound = expression.degree_at_most();
        let bound = bound.map(|own| BiDegree::new(own, own));
        if bound.map(size).is_some_and(fits) {
            return Ok(());
        }
        let degree = self.counter.largest(expression);
        let (high, terms) = size(degree);
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

    fn expanded(&mut self, expression: &Scalar) -> Found<Expanded> {
        if let Form::Constant(value) = expression.form() {
            return Ok(Expanded::Number(value.clone()));
        }
        if !expression.is_shared() {
            return self.form(expression);
        }
        if let Some((_, known)) = self.expanded.get(&expression.identity()) {
            return Ok(known.clone());
        }
        let expanded = self.form(expression)?;
        let entry = (expression.clone(), expanded.clone());
        self.expanded.insert(expression.identity(), entry);
        Ok(expanded)
    }

    /// The terms of a sum or the factors of a product, with those of the sums or products among
    /// them that nothing else asks for.
    fn all(&mut self, parts: &[Scalar], nested: Nested) -> Found<Vec<Expanded>> {
        let mut all = Vec::with_capacity(parts.len());
        self.gather(parts, nested, &mut all)?;
        Ok(all)
    }

    fn gather(&mut self, parts: &[Scalar], nested: Nested, all: &mut Vec<Expanded>) -> Found<()> {
        for own in parts {
            match nested(own.form()) {
                Some(inner) if !own.is_shared() => self.gather(inner, nested, all)?,
                _ => all.push(self.expanded(own)?),
            }
        }
        Ok(())
    }

    fn fraction(&mut self, expression: &Scalar) -> Found<Fraction<Real>> {
        Ok(self.expanded(expression)?.into_fraction())
    }

    fn form(&mut self, expression: &Scalar) -> Found<Expanded> {
        let zero_division = || division_by_zero(expression);
        let in_both = Expanded::from;
        match expression.form() {
            Form::Constant(value) => Ok(Expanded::Number(value.clone())),
            Form::Parameter(parameter) => Ok(Expanded::variable(*parameter)),
            Form::Polynomial(parameter, own) => Ok(Expanded::InOne(
                *parameter,
                Quotient::polynomial(own.clone()),
            )),
            Form::Sum(terms) => Ok(Expanded::sum(&self.all(terms, terms_of)?)),
            Form::Product(factors) => Ok(Expanded::product(&self.all(factors, factors_of)?)),
            Form::Power(base, exponent) => {
                let base = self.expanded(base)?;
                base.power(*exponent).ok_or_else(zero_division)
            }
            Form::Property(property, argument) => self.property(expression, property, argument),
            Form::Partial(by, body) => Ok(self.expanded(body)?.partial(*by)),
            Form::OnDomain(body, domain) if **domain == *self.domain => self.expanded(body),
            Form::OnDomain(body, domain) => {
                Expander::new(domain, self.tower, self.limits).expanded(body)
            }
            Form::Substitution { body, .. } if body.is_rooted() => {
                Err(Box::new(undecided_sign(expression)))
            }
            Form::Substitution { body, u, v } => {
                let (u, v) = (self.fraction(u)?, self.fraction(v)?);
                let composed = self.fraction(body)?.compose(&u, &v);
                composed.map(in_both).ok_or_else(zero_division)
            }
            Form::SquareRoot(body) => {
                // It is expanded whole, and has twice the degree of its root.
                let (radicand, span) = (self.expand(body)?, expression.span());
                if let Expanded::Number(own) = &radicand {
                    return root_of_number(own, self.tower, span).map(Expanded::Number);
                }
                let radicand = radicand.into_fraction();
                square_root(&radicand, self.domain, self.tower, span).map(in_both)
            }
            Form::Normal(surface, axis) => {
                let expanded = self.expand_vector(surface)?;
                let normal = unit_normal(&expanded, self.domain, self.tower)
                    .map_err(|fault| normal_finding(&fault, expression))?;
                Ok(in_both(normal[axis.index()].clone()))
            }
        }
    }

    fn property(
        &mut self,
        expression: &Scalar,
        of: &CurveProperty,
        argument: &Scalar,
    ) -> Found<Expanded> {
        let mut function = of
            .curve
            .property(of.property)
            .map_err(|fault| curve_finding(&fault, of, expression))?;
        for _ in 0..of.derivative {
            function = Rc::new(function.derivative());
        }
        let quotient = Quotient::new(&function.numerator, &function.denominator)
            .ok_or_else(|| division_by_zero(expression))?;
        if let Form::Parameter(parameter) = argument.form() {
            return Ok(Expanded::InOne(*parameter, quotient));
        }
        let at = self.fraction(argument)?;
        let zero = Fraction::constant(&Real::zero());
        let outer = Expanded::InOne(Parameter::U, quotient).fraction();
        let composed = outer.compose(&at, &zero);
        composed
            .map(Expanded::from)
            .ok_or_else(|| division_by_zero(expression))
    }
}

/// The parts of a form of one kind.
type Nested = fn(&Form) -> Option<&[Scalar]>;

fn terms_of(form: &Form) -> Option<&[Scalar]> {
    match form {
        Form::Sum(terms) => Some(terms),
        _ => None,
    }
}

fn factors_of(form: &Form) -> Option<&[Scalar]> {
    match form {
        Form::Product(factors) => Some(factors),
        _ => None,
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
