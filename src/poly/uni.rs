use std::borrow::Cow;
use std::cell::OnceCell;
use std::cmp::Ordering;
use std::fmt;
use std::rc::Rc;

use crate::number::{Field, Integer, MachineList, MachineNumbers, Place, Ring, lcm};

use super::numerators::Numerators;

/// A polynomial in one variable, Σ (nᵢ / d) xⁱ.
///
/// Canonical: the last numerator is not 0, d > 0, and no integer above 1 divides d and all
/// numerators; so equality of values is equality of representations. The zero polynomial has no
/// numerators, and no degree. Copies share their memory.
#[derive(Clone)]
pub struct UniPoly<F: Field>(Form<F::Ring>);

#[derive(Clone)]
enum Form<R> {
    Zero,
    One,
    Other(Rc<Body<R>>),
}

/// A polynomial other than 0 and 1.
struct Body<R> {
    numerators: Numerators<R>,
    denominator: Integer,
    /// The primitive multiple, once it is found; none if it is the polynomial itself.
    primitive: OnceCell<Option<Form<R>>>,
}

impl<F: Field> UniPoly<F> {
    /// Σ (nᵢ / d) xⁱ from ascending numerators; d is not 0.
    #[must_use]
    pub fn from_numerators(mut numerators: Vec<F::Ring>, denominator: Integer) -> Self {
        while numerators.last().is_some_and(Ring::is_zero) {
            numerators.pop();
        }
        Self::lowest(numerators.into(), denominator)
    }

    /// Σ cᵢ xⁱ from ascending coefficients.
    #[must_use]
    pub fn from_coefficients(coefficients: &[F]) -> Self {
        // Of a prime power that divides d, some coefficient needs all: it stays in lowest terms.
        if let Some((numerators, denominator)) = MachineList::of_fractions(coefficients.iter()) {
            return Self::of_parts(numerators.trimmed().into(), denominator.into());
        }
        let parts: Vec<_> = coefficients.iter().map(Field::parts).collect();
        let denominator = parts
            .iter()
            .fold(Integer::one(), |common, (_, denominator)| {
                lcm(&common, denominator)
            });
        let mut numerators: Vec<_> = parts
            .iter()
            .map(|(numerator, own)| numerator.scaled(&(&denominator / *own)))
            .collect();
        while numerators.last().is_some_and(Ring::is_zero) {
            numerators.pop();
        }
        Self::of_parts(numerators.into(), denominator)
    }

    /// From numerators of which the last is not 0; d is not 0.
    pub(super) fn lowest(numerators: Numerators<F::Ring>, denominator: Integer) -> Self {
        let mut common = numerators.content_with(&denominator);
        if Ring::sign(&denominator).is_lt() {
            common = -common;
        }
        if common.is_one() {
            return Self::of_parts(numerators, denominator);
        }
        Self::of_parts(numerators.over(&common), denominator / common)
    }

    /// From parts in lowest terms.
    pub(super) fn of_parts(numerators: Numerators<F::Ring>, denominator: Integer) -> Self {
        let is_one =
            |own: &MachineList| own.numbers() == MachineNumbers::ONE && denominator.is_one();
        Self(match numerators.machine() {
            Some(own) if own.numbers().is_empty() => Form::Zero,
            Some(own) if is_one(own) => Form::One,
            _ => Form::Other(Rc::new(Body {
                numerators,
                denominator,
                primitive: OnceCell::new(),
            })),
        })
    }

    /// 0
    #[must_use]
    pub fn zero() -> Self {
        Self(Form::Zero)
    }

    /// 1
    #[must_use]
    pub fn one() -> Self {
        Self(Form::One)
    }

    /// x
    #[must_use]
    pub fn variable() -> Self {
        Self::one().shift(1)
    }

    /// The constant polynomial c.
    #[must_use]
    pub fn constant(value: &F) -> Self {
        let (numerator, denominator) = value.parts();
        if numerator.is_zero() {
            return Self::zero();
        }
        Self::of_parts(vec![numerator.clone()].into(), denominator.clone())
    }

    fn body(&self) -> Option<&Body<F::Ring>> {
        match &self.0 {
            Form::Other(own) => Some(own),
            Form::Zero | Form::One => None,
        }
    }

    /// The numerators, if they are held as machine numbers.
    #[inline]
    pub(super) fn machine(&self) -> Option<MachineNumbers<'_>> {
        match &self.0 {
            Form::Zero => Some(MachineNumbers::NONE),
            Form::One => Some(MachineNumbers::ONE),
            Form::Other(own) => own.numerators.machine().map(MachineList::numbers),
        }
    }

    /// The numerators of a polynomial other than 0 and 1.
    pub(super) fn numerators_held(&self) -> Option<&Numerators<F::Ring>> {
        self.body().map(|own| &own.numerators)
    }

    /// The numerators as they are held.
    pub(super) fn held(&self) -> Numerators<F::Ring> {
        match &self.0 {
            Form::Zero => Vec::new().into(),
            Form::One => vec![F::Ring::one()].into(),
            Form::Other(own) => own.numerators.clone(),
        }
    }

    #[inline]
    fn length(&self) -> usize {
        match &self.0 {
            Form::Zero => 0,
            Form::One => 1,
            Form::Other(own) => own.numerators.len(),
        }
    }

    /// The degree; none for 0.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.length().checked_sub(1)
    }

    /// Whether it is 0.
    #[must_use]
    #[inline]
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Form::Zero)
    }

    /// Whether it is 1.
    #[must_use]
    #[inline]
    pub fn is_one(&self) -> bool {
        matches!(self.0, Form::One)
    }

    /// Whether it is a constant, 0 included.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.length() <= 1
    }

    /// Whether all coefficients are rational numbers.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.body().is_none_or(|own| own.numerators.is_rational())
    }

    /// Whether it is the product of a number and a polynomial with rational coefficients.
    #[must_use]
    pub fn is_rational_up_to_a_factor(&self) -> bool {
        if self.is_rational() {
            return true;
        }
        let unit = |own: &F::Ring| own.divided(&own.content());
        let numerators = self.numerators().iter().filter(|own| !own.is_zero());
        let mut units = numerators.map(unit);
        let Some(first) = units.next() else {
            return true;
        };
        let opposite = first.negated();
        units.all(|own| own == first || own == opposite)
    }

    /// The numerators nᵢ, ascending.
    #[must_use]
    pub fn numerators(&self) -> &[F::Ring] {
        match &self.0 {
            Form::Zero => &[],
            Form::One => std::slice::from_ref(F::Ring::unit()),
            Form::Other(own) => &own.numerators,
        }
    }

    /// The numerator of the highest power; none for 0.
    #[must_use]
    pub fn leading_numerator(&self) -> Option<Cow<'_, F::Ring>> {
        match &self.0 {
            Form::Zero => None,
            Form::One => Some(Cow::Borrowed(F::Ring::unit())),
            Form::Other(own) => own.numerators.last(),
        }
    }

    /// f, g and d of a product f(x) g(x) / d that is not multiplied out yet.
    #[must_use]
    pub fn factors(&self) -> Option<(Self, Self, Integer)> {
        let body = self.body()?;
        let product = body.numerators.factors()?;
        let whole = |own: &Numerators<F::Ring>| Self::of_parts(own.clone(), Integer::one());
        let below = &product.divisor * &body.denominator;
        Some((whole(&product.left), whole(&product.right), below))
    }

    /// The images of the numerators at a place for them.
    pub(super) fn image(&self, place: &Place) -> Vec<u64> {
        match &self.0 {
            Form::Zero => Vec::new(),
            Form::One => vec![place.modulus().one()],
            Form::Other(own) => own.numerators.image(place),
        }
    }

    /// The numerator that lies in the largest field; none if all are rational.
    pub(super) fn highest(&self) -> Option<&F::Ring> {
        let irrational = !self.is_rational();
        irrational.then(|| self.numerators().iter().max_by_key(|own| own.height()))?
    }

    /// The common denominator d.
    #[must_use]
    pub fn denominator(&self) -> &Integer {
        match self.body() {
            Some(own) => &own.denominator,
            None => Integer::unit(),
        }
    }

    /// The coefficient of xⁱ.
    #[must_use]
    pub fn coefficient(&self, power: usize) -> F {
        let Some(body) = self.body() else {
            return match power {
                0 if self.is_one() => F::one(),
                _ => F::zero(),
            };
        };
        let numerators = &body.numerators;
        let numerator = match power {
            0 => numerators.first(),
            _ if power + 1 == numerators.len() => numerators.last(),
            _ => (power < numerators.len()).then(|| numerators.at(power)),
        };
        match numerator {
            Some(numerator) => F::from_parts(numerator.into_owned(), body.denominator.clone()),
            None => F::zero(),
        }
    }

    /// All coefficients, ascending.
    #[must_use]
    pub fn coefficients(&self) -> Vec<F> {
        let numerators = self.numerators().iter();
        numerators
            .map(|own| F::from_parts(own.clone(), self.denominator().clone()))
            .collect()
    }

    /// The coefficient of the highest power; 0 for 0.
    #[must_use]
    pub fn leading_coefficient(&self) -> F {
        self.degree()
            .map_or_else(F::zero, |degree| self.coefficient(degree))
    }

    /// xⁿ p(x)
    #[must_use]
    pub fn shift(&self, power: usize) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        let mut numerators = Vec::with_capacity(power + self.length());
        numerators.resize(power, F::Ring::zero());
        numerators.extend_from_slice(self.numerators());
        Self::of_parts(numerators.into(), self.denominator().clone())
    }

    /// p′(x)
    #[must_use]
    pub fn derivative(&self) -> Self {
        if let Some(slope) = self.machine().and_then(MachineList::derivative) {
            return Self::lowest(slope.into(), self.denominator().clone());
        }
        let numerators = self.numerators().iter().enumerate().skip(1);
        let numerators = numerators.map(|(power, own)| own.scaled(&Integer::from(power)));
        Self::from_numerators(numerators.collect(), self.denominator().clone())
    }

    /// The polynomial P with P′ = p and P(0) = 0.
    #[must_use]
    pub fn antiderivative(&self) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        if let Some((rise, common)) = self.machine().and_then(MachineList::antiderivative) {
            return Self::lowest(rise.into(), self.denominator() * Integer::from(common));
        }
        let powers = 1..=self.length();
        let common = powers.fold(Integer::one(), |all, own| lcm(&all, &Integer::from(own)));
        let terms = self.numerators().iter().enumerate();
        let terms = terms.map(|(power, own)| own.scaled(&(&common / Integer::from(power + 1))));
        let numerators = std::iter::once(F::Ring::zero()).chain(terms);
        Self::from_numerators(numerators.collect(), self.denominator() * &common)
    }

    /// The polynomial P with P′ = p and P(a) = c.
    #[must_use]
    pub fn antiderivative_from(&self, at: &F, value: &F) -> Self {
        if at.is_zero()
            && let Some(rise) = self.antiderivative_with(value)
        {
            return rise;
        }
        let rise = self.antiderivative();
        let constant = value.minus(&rise.evaluate(at));
        &rise + &Self::constant(&constant)
    }

    /// The polynomial P with P′ = p and P(0) = c, in machine numbers.
    fn antiderivative_with(&self, constant: &F) -> Option<Self> {
        let (rise, common) = MachineList::antiderivative(self.machine()?)?;
        let (above, below) = constant.machine_parts()?;
        let (own, below) = (self.denominator() * Integer::from(common), below.into());
        let denominator = lcm(&own, &below);
        let first = (&denominator / &below * Integer::from(above)).machine()?;
        let sum = rise.with_first(first, (&denominator / &own).machine()?)?;
        Some(Self::lowest(sum.trimmed().into(), denominator))
    }

    /// p(x) at a number, by Horner's rule on numerator and denominator.
    #[must_use]
    pub fn evaluate(&self, at: &F) -> F {
        if at.is_zero() {
            return self.coefficient(0);
        }
        if at.is_one()
            && let Some(sum) = self.machine().and_then(MachineList::total)
        {
            let sum = F::Ring::from_integer(&Integer::from(sum));
            return F::from_parts(sum, self.denominator().clone());
        }
        let (numerator, denominator) = at.parts();
        let mut value = F::Ring::zero();
        let mut power = Integer::one();
        for (step, own) in self.numerators().iter().rev().enumerate() {
            if step > 0 {
                power *= denominator;
            }
            value = value.times(numerator).plus(&own.scaled(&power));
        }
        F::from_parts(value, self.denominator() * power)
    }

    /// The sign of p(x) at a number.
    #[must_use]
    pub fn sign_at(&self, at: &F) -> Ordering {
        if at.is_zero() && !self.is_zero() {
            let first = self.body().and_then(|own| own.numerators.first());
            return first.map_or(Ordering::Greater, |own| own.sign());
        }
        self.evaluate(at).sign()
    }

    /// p(q(x))
    #[must_use]
    pub fn compose(&self, inner: &Self) -> Self {
        self.coefficients()
            .iter()
            .rev()
            .fold(Self::zero(), |value, own| {
                &(&value * inner) + &Self::constant(own)
            })
    }

    /// p / lc(p); 0 for 0
    #[must_use]
    pub fn monic(&self) -> Self {
        match self.leading_coefficient().inverse() {
            Some(inverse) => self.scale(&inverse),
            None => Self::zero(),
        }
    }

    /// The multiple whose numerators are coprime integers over 1, of positive leading
    /// coefficient: the normal form up to factors of the field. 0 for 0.
    ///
    /// Over a field other than the rationals the leading coefficient is first made rational.
    #[must_use]
    pub fn primitive(&self) -> Self {
        let Some(body) = self.body() else {
            return self.clone();
        };
        let found = body.primitive.get_or_init(|| self.find_primitive());
        Self(found.as_ref().unwrap_or(&self.0).clone())
    }

    /// The multiple whose numerators are coprime integers over 1, of positive leading coefficient,
    /// by a rational factor; 0 for 0.
    ///
    /// The primitive multiple where the leading coefficient is rational. Where it is not, the
    /// numerators stay as short as they are, and a multiple of the polynomial may have others.
    #[must_use]
    pub fn integral(&self) -> Self {
        match self.leading_numerator() {
            Some(lead) if lead.height() > 0 => {
                let content = self.content();
                let divisor = if lead.sign().is_lt() {
                    -content
                } else {
                    content
                };
                Self::of_parts(self.held().over(&divisor), Integer::one())
            }
            _ => self.primitive(),
        }
    }

    /// The number c and the primitive q with p = c q; 0 and 0 for 0.
    #[must_use]
    pub fn split(&self) -> (F, Self) {
        self.factored(self.primitive())
    }

    /// The number c and the q of [`UniPoly::integral`] with p = c q; 0 and 0 for 0.
    #[must_use]
    pub fn split_integral(&self) -> (F, Self) {
        self.factored(self.integral())
    }

    fn factored(&self, multiple: Self) -> (F, Self) {
        if multiple == *self && !self.is_zero() {
            return (F::one(), multiple);
        }
        let factor = self.multiple_of(&multiple);
        (factor.unwrap_or_else(F::zero), multiple)
    }

    /// c with p = c q; none for 0.
    fn multiple_of(&self, other: &Self) -> Option<F> {
        let (own, lead) = (self.leading_numerator()?, other.leading_numerator()?);
        // Mostly the content, with a sign.
        if let Some(factor) = own.quotient(&lead) {
            return Some(F::from_parts(factor, self.denominator().clone()));
        }
        let inverse = other.leading_coefficient().inverse()?;
        Some(self.leading_coefficient().times(&inverse))
    }

    /// None for the polynomial itself.
    fn find_primitive(&self) -> Option<Form<F::Ring>> {
        let lead = self.leading_numerator()?;
        if lead.height() > 0 {
            let own = self.monic().primitive();
            return (own != *self).then_some(own.0);
        }
        let content = self.content();
        let divisor = if lead.sign().is_lt() {
            -content
        } else {
            content
        };
        if divisor.is_one() && self.denominator().is_one() {
            return None;
        }
        let numerators = self.held().over(&divisor);
        Some(Self::of_parts(numerators, Integer::one()).0)
    }

    /// The greatest integer that divides every numerator; 0 for 0.
    #[must_use]
    pub fn content(&self) -> Integer {
        self.content_with(&Integer::zero())
    }

    /// The greatest integer that divides every numerator, and a given one.
    pub(super) fn content_with(&self, with: &Integer) -> Integer {
        match &self.0 {
            Form::Zero => with.abs(),
            Form::One => Integer::one(),
            Form::Other(own) => own.numerators.content_with(with),
        }
    }
}

impl<F: Field> PartialEq for UniPoly<F> {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Form::Zero, Form::Zero) | (Form::One, Form::One) => true,
            (Form::Other(own), Form::Other(other)) => {
                Rc::ptr_eq(own, other)
                    || (own.denominator == other.denominator && own.numerators == other.numerators)
            }
            _ => false,
        }
    }
}

impl<F: Field> Eq for UniPoly<F> {}

impl<F: Field> fmt::Debug for UniPoly<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("UniPoly")
            .field("numerators", &self.numerators())
            .field("denominator", self.denominator())
            .finish()
    }
}

/// `2/3 x^2 - x + 1`, with the variable `x`; see [`UniPoly::display`] for another.
impl<F: Field> fmt::Display for UniPoly<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.display("x"))
    }
}

impl<F: Field> UniPoly<F> {
    /// The polynomial in a named variable, highest power first, as one reads it in a paper.
    #[must_use]
    pub fn display(&self, variable: &str) -> String {
        let mut text = String::new();
        for power in (0..self.length()).rev() {
            let coefficient = self.coefficient(power);
            if coefficient.is_zero() {
                continue;
            }
            let negative = coefficient.sign().is_lt();
            text.push_str(match (text.is_empty(), negative) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            });
            let magnitude = if negative {
                coefficient.negated()
            } else {
                coefficient
            };
            let monomial = match power {
                0 => String::new(),
                1 => variable.to_owned(),
                _ => format!("{variable}^{power}"),
            };
            let number = magnitude.to_string();
            let number = if number.contains(' ') {
                format!("({number})")
            } else {
                number
            };
            match (monomial.is_empty(), magnitude == F::one()) {
                (true, _) => text.push_str(&number),
                (false, true) => text.push_str(&monomial),
                (false, false) => text.push_str(&format!("{number} {monomial}")),
            }
        }
        if text.is_empty() {
            "0".to_owned()
        } else {
            text
        }
    }
}
