use std::borrow::Cow;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use crate::number::{Field, Integer, Place, Ring, lcm};

use super::numerators::Numerators;

/// Products of two polynomials with so many coefficients are multiplied out only when asked for.
const LONG: usize = 16;

/// A polynomial in one variable, Σ (nᵢ / d) xⁱ.
///
/// Canonical: the last numerator is not 0, d > 0, and no integer above 1 divides d and all
/// numerators; so equality of values is equality of representations. The zero polynomial has no
/// numerators, and no degree.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UniPoly<F: Field> {
    numerators: Numerators<F::Ring>,
    denominator: Integer,
}

impl<F: Field> UniPoly<F> {
    /// Σ (nᵢ / d) xⁱ from ascending numerators; d is not 0.
    #[must_use]
    pub fn from_numerators(mut numerators: Vec<F::Ring>, mut denominator: Integer) -> Self {
        while numerators.last().is_some_and(Ring::is_zero) {
            numerators.pop();
        }
        let mut common = denominator.clone();
        for own in numerators.iter().rev() {
            if common.is_one() {
                break;
            }
            common = own.content_with(&common);
        }
        if Ring::sign(&denominator).is_lt() {
            common = -common;
        }
        if !common.is_one() {
            denominator /= &common;
            for numerator in &mut numerators {
                *numerator = numerator.divided(&common);
            }
        }
        Self {
            numerators: numerators.into(),
            denominator,
        }
    }

    /// Σ cᵢ xⁱ from ascending coefficients.
    #[must_use]
    pub fn from_coefficients(coefficients: &[F]) -> Self {
        let parts: Vec<_> = coefficients.iter().map(Field::parts).collect();
        let denominator = parts
            .iter()
            .fold(Integer::one(), |common, (_, denominator)| {
                lcm(&common, denominator)
            });
        // Of a prime power that divides d, some coefficient needs all: it stays in lowest terms.
        let mut numerators: Vec<_> = parts
            .iter()
            .map(|(numerator, own)| numerator.scaled(&(&denominator / own)))
            .collect();
        while numerators.last().is_some_and(Ring::is_zero) {
            numerators.pop();
        }
        Self {
            numerators: numerators.into(),
            denominator,
        }
    }

    /// 0
    #[must_use]
    pub fn zero() -> Self {
        Self {
            numerators: Numerators::Zero,
            denominator: Integer::one(),
        }
    }

    /// 1
    #[must_use]
    pub fn one() -> Self {
        Self {
            numerators: Numerators::Constant(F::Ring::one()),
            denominator: Integer::one(),
        }
    }

    /// x
    #[must_use]
    pub fn variable() -> Self {
        Self::from_numerators(vec![F::Ring::zero(), F::Ring::one()], Integer::one())
    }

    /// The constant polynomial c.
    #[must_use]
    pub fn constant(value: &F) -> Self {
        let (numerator, denominator) = value.parts();
        let numerators = if numerator.is_zero() {
            Numerators::Zero
        } else {
            Numerators::Constant(numerator)
        };
        Self {
            numerators,
            denominator,
        }
    }

    /// p + q + …
    #[must_use]
    pub fn sum(terms: &[&Self]) -> Self {
        if let [only] = terms {
            return (*only).clone();
        }
        let common = terms
            .iter()
            .fold(Integer::one(), |all, own| lcm(&all, &own.denominator));
        let length = terms.iter().map(|own| own.numerators.len()).max();
        let mut sums = vec![F::Ring::zero(); length.unwrap_or(0)];
        for term in terms {
            let factor = &common / &term.denominator;
            let scaled = F::Ring::from_integer(&factor);
            for (sum, own) in sums.iter_mut().zip(&*term.numerators) {
                if !own.is_zero() {
                    sum.add_product(own, &scaled);
                }
            }
        }
        Self::from_numerators(sums, common)
    }

    /// The degree; none for 0.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.numerators.len().checked_sub(1)
    }

    /// Whether it is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerators.is_empty()
    }

    /// Whether it is 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        matches!(&self.numerators, Numerators::Constant(own) if own.is_one())
            && self.denominator.is_one()
    }

    /// Whether it is a constant, 0 included.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.numerators.len() <= 1
    }

    /// Whether all coefficients are rational numbers.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.numerators.is_rational()
    }

    /// Whether it is the product of a number and a polynomial with rational coefficients.
    #[must_use]
    pub fn is_rational_up_to_a_factor(&self) -> bool {
        let unit = |own: &F::Ring| own.divided(&own.content());
        let mut units = self
            .numerators
            .iter()
            .filter(|own| !own.is_zero())
            .map(unit);
        let Some(first) = units.next() else {
            return true;
        };
        let opposite = first.negated();
        units.all(|own| own == first || own == opposite)
    }

    /// The numerators nᵢ, ascending.
    #[must_use]
    pub fn numerators(&self) -> &[F::Ring] {
        &self.numerators
    }

    /// The numerator of the highest power; none for 0.
    #[must_use]
    pub fn leading_numerator(&self) -> Option<Cow<'_, F::Ring>> {
        self.numerators.last()
    }

    /// f, g and d of a product f(x) g(x) / d that is not multiplied out yet.
    #[must_use]
    pub fn factors(&self) -> Option<(Self, Self, Integer)> {
        let product = self.numerators.factors()?;
        let whole = |numerators: &Numerators<F::Ring>| Self {
            numerators: numerators.clone(),
            denominator: Integer::one(),
        };
        let below = &product.divisor * &self.denominator;
        Some((whole(&product.left), whole(&product.right), below))
    }

    /// The images of the numerators at a place for them.
    pub(super) fn image(&self, place: &Place) -> Vec<u64> {
        self.numerators.image(place)
    }

    /// The numerator that lies in the largest field; none if all are rational.
    pub(super) fn highest(&self) -> Option<&F::Ring> {
        let irrational = !self.is_rational();
        irrational.then(|| self.numerators.iter().max_by_key(|own| own.height()))?
    }

    /// The common denominator d.
    #[must_use]
    pub fn denominator(&self) -> &Integer {
        &self.denominator
    }

    /// The coefficient of xⁱ.
    #[must_use]
    pub fn coefficient(&self, power: usize) -> F {
        let numerator = match power {
            0 => self.numerators.first(),
            _ if power + 1 == self.numerators.len() => self.numerators.last(),
            _ => self.numerators.get(power).map(Cow::Borrowed),
        };
        match numerator {
            Some(numerator) => F::from_parts(numerator.into_owned(), self.denominator.clone()),
            None => F::zero(),
        }
    }

    /// All coefficients, ascending.
    #[must_use]
    pub fn coefficients(&self) -> Vec<F> {
        let numerators = self.numerators.iter();
        numerators
            .map(|own| F::from_parts(own.clone(), self.denominator.clone()))
            .collect()
    }

    /// The coefficient of the highest power; 0 for 0.
    #[must_use]
    pub fn leading_coefficient(&self) -> F {
        self.degree()
            .map_or_else(F::zero, |degree| self.coefficient(degree))
    }

    /// c p(x)
    #[must_use]
    pub fn scale(&self, factor: &F) -> Self {
        if factor.is_one() {
            return self.clone();
        }
        if factor.is_zero() {
            return Self::zero();
        }
        let factor = Self::constant(factor);
        if self.numerators.factors().is_some() {
            return self.joined(&factor);
        }
        let numerator = &factor.numerators[0];
        let scaled = self.numerators.iter().map(|own| own.times(numerator));
        self.multiplied(&factor, scaled.collect())
    }

    /// The product with a polynomial that is not 0, from the products of the numerators.
    fn multiplied(&self, other: &Self, product: Vec<F::Ring>) -> Self {
        if !self.is_rational() || !other.is_rational() {
            return Self::from_numerators(product, &self.denominator * &other.denominator);
        }
        self.over(other, |common| {
            if common.is_one() {
                product.into()
            } else {
                product.iter().map(|own| own.divided(&common)).collect()
            }
        })
    }

    /// The product of polynomials over the rationals, multiplied out when it is asked for.
    fn joined(&self, other: &Self) -> Self {
        self.over(other, |common| {
            Numerators::product(self.numerators.clone(), other.numerators.clone(), common)
        })
    }

    /// The product of polynomials over the rationals in lowest terms, from its numerators divided
    /// by an integer.
    ///
    /// Over the integers the content of a product is the product of the contents, so only crosswise
    /// is there something to cancel.   (Gauss's lemma)
    fn over(&self, other: &Self, divided: impl FnOnce(Integer) -> Numerators<F::Ring>) -> Self {
        let first = self.numerators.content_with(&other.denominator);
        let second = other.numerators.content_with(&self.denominator);
        Self {
            numerators: divided(&first * &second),
            denominator: (&self.denominator / second) * (&other.denominator / first),
        }
    }

    /// xⁿ p(x)
    #[must_use]
    pub fn shift(&self, power: usize) -> Self {
        if self.is_zero() {
            return Self::zero();
        }
        let mut numerators = Vec::with_capacity(power + self.numerators.len());
        numerators.resize(power, F::Ring::zero());
        numerators.extend_from_slice(&self.numerators);
        Self {
            numerators: numerators.into(),
            denominator: self.denominator.clone(),
        }
    }

    /// p(x)ⁿ
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        if exponent == 1 {
            return self.clone();
        }
        if let ([zero, one], Ok(power)) = (&*self.numerators, usize::try_from(exponent))
            && zero.is_zero()
            && one.is_one()
            && self.denominator.is_one()
        {
            return Self::one().shift(power);
        }
        let mut result = Self::one();
        for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
            result = &result * &result;
            if exponent >> bit & 1 == 1 {
                result = &result * self;
            }
        }
        result
    }

    /// p′(x)
    #[must_use]
    pub fn derivative(&self) -> Self {
        let numerators = self.numerators.iter().enumerate().skip(1);
        let numerators = numerators.map(|(power, own)| own.scaled(&Integer::from(power)));
        Self::from_numerators(numerators.collect(), self.denominator.clone())
    }

    /// The polynomial P with P′ = p and P(0) = 0.
    #[must_use]
    pub fn antiderivative(&self) -> Self {
        let powers = 1..=self.numerators.len();
        let common = powers.fold(Integer::one(), |all, own| lcm(&all, &Integer::from(own)));
        let terms = self.numerators.iter().enumerate();
        let terms = terms.map(|(power, own)| own.scaled(&(&common / Integer::from(power + 1))));
        let numerators = std::iter::once(F::Ring::zero()).chain(terms);
        Self::from_numerators(numerators.collect(), &self.denominator * &common)
    }

    /// p(x) at a number, by Horner's rule on numerator and denominator.
    #[must_use]
    pub fn evaluate(&self, at: &F) -> F {
        if at.is_zero() {
            return self.coefficient(0);
        }
        let (numerator, denominator) = at.parts();
        let mut value = F::Ring::zero();
        let mut power = Integer::one();
        for (step, own) in self.numerators.iter().rev().enumerate() {
            if step > 0 {
                power *= &denominator;
            }
            value = value.times(&numerator).plus(&own.scaled(&power));
        }
        F::from_parts(value, &self.denominator * power)
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
        Self {
            numerators: self.numerators.primitive(|| self.find_primitive()),
            denominator: Integer::one(),
        }
    }

    /// The numerators of the primitive multiple; none if they are those of the polynomial.
    fn find_primitive(&self) -> Option<Numerators<F::Ring>> {
        let lead = self.numerators.last()?;
        if !self.numerators.is_rational() && lead.height() > 0 {
            let own = self.monic().primitive().numerators;
            return (own != self.numerators).then_some(own);
        }
        let content = self.content();
        let negative = lead.sign().is_lt();
        if self.numerators.factors().is_some() {
            let sign = F::Ring::from_integer(&Integer::from(if negative { -1 } else { 1 }));
            let changed = negative || !content.is_one();
            return changed.then(|| {
                Numerators::product(self.numerators.clone(), Numerators::Constant(sign), content)
            });
        }
        let numerators = self.numerators.iter();
        match (content.is_one(), negative) {
            (true, false) => None,
            (true, true) => Some(numerators.map(Ring::negated).collect()),
            (false, _) => {
                let divisor = if negative { -content } else { content };
                Some(numerators.map(|own| own.divided(&divisor)).collect())
            }
        }
    }

    /// The greatest integer that divides every numerator; 0 for 0.
    #[must_use]
    pub fn content(&self) -> Integer {
        self.numerators.content_with(&Integer::zero())
    }

    /// Whether a product is better left alone until its coefficients are asked for.
    fn is_long_product(&self, other: &Self) -> bool {
        let length = self.numerators.len().min(other.numerators.len());
        length >= LONG && self.is_rational() && other.is_rational()
    }

    fn combine(&self, other: &Self, add: impl Fn(&F::Ring, &F::Ring) -> F::Ring) -> Self {
        let common = lcm(&self.denominator, &other.denominator);
        let (left, right) = (&common / &self.denominator, &common / &other.denominator);
        let zero = F::Ring::zero();
        let length = self.numerators.len().max(other.numerators.len());
        let at = |list: &[F::Ring], index: usize, factor: &Integer| {
            let value = list.get(index).unwrap_or(&zero);
            if factor.is_one() {
                value.clone()
            } else {
                value.scaled(factor)
            }
        };
        let numerators = (0..length)
            .map(|index| {
                add(
                    &at(&self.numerators, index, &left),
                    &at(&other.numerators, index, &right),
                )
            })
            .collect();
        Self::from_numerators(numerators, common)
    }
}

impl<F: Field> Add for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn add(self, other: Self) -> UniPoly<F> {
        match (self.is_zero(), other.is_zero()) {
            (true, _) => return other.clone(),
            (_, true) => return self.clone(),
            _ => {}
        }
        self.combine(other, Ring::plus)
    }
}

impl<F: Field> Sub for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn sub(self, other: Self) -> UniPoly<F> {
        if other.is_zero() {
            return self.clone();
        }
        self.combine(other, Ring::minus)
    }
}

impl<F: Field> Neg for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn neg(self) -> UniPoly<F> {
        if self.numerators.factors().is_some() {
            return self.scale(&F::one().negated());
        }
        UniPoly {
            numerators: self.numerators.iter().map(Ring::negated).collect(),
            denominator: self.denominator.clone(),
        }
    }
}

impl<F: Field> Mul for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn mul(self, other: Self) -> UniPoly<F> {
        if self.is_zero() || other.is_zero() {
            return UniPoly::zero();
        }
        match (self.is_one(), other.is_one()) {
            (true, _) => return other.clone(),
            (_, true) => return self.clone(),
            _ => {}
        }
        if self.is_long_product(other) {
            return self.joined(other);
        }
        let product = F::Ring::convolution(&self.numerators, &other.numerators);
        self.multiplied(other, product)
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
        for power in (0..self.numerators.len()).rev() {
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
