use std::cmp::Ordering;
use std::fmt;

use super::enclosure::refine;
use super::{
    Basis, Enclosure, Generator, Integer, Leading, Place, Ring, binomial_sums, convolution, gcd,
    halves, surd_list,
};

/// A numerator of a tower of real fields: an element of ℤ[√a₁, √a₂, …] with integral radicands.
///
/// A number is kept at its lowest level: a + b√aₖ with b ≠ 0 and both parts below level k. As
/// no radicand is a square below its level, equality of values is equality of representations.
/// Operands of one operation belong to one tower.
#[derive(Debug, PartialEq, Eq)]
pub enum SurdInteger {
    /// A rational integer.
    Rational(Integer),
    /// a + b√aₖ
    Irrational(Box<Binomial>),
}

/// a + b√aₖ with b ≠ 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Binomial {
    /// a
    pub constant: SurdInteger,
    /// b
    pub slope: SurdInteger,
    /// √aₖ
    pub generator: Generator,
}

impl Clone for SurdInteger {
    #[inline]
    fn clone(&self) -> Self {
        #[inline(never)]
        fn irrational(own: &Binomial) -> SurdInteger {
            SurdInteger::Irrational(Box::new(own.clone()))
        }
        match self {
            Self::Rational(own) => Self::Rational(own.clone()),
            Self::Irrational(own) => irrational(own),
        }
    }
}

impl SurdInteger {
    /// a + b√aₖ at its lowest level.
    #[must_use]
    pub fn binomial(constant: Self, slope: Self, generator: &Generator) -> Self {
        if slope.is_zero() {
            return constant;
        }
        Self::Irrational(Box::new(Binomial {
            constant,
            slope,
            generator: generator.clone(),
        }))
    }

    /// √aₖ
    #[must_use]
    pub fn generator(generator: &Generator) -> Self {
        Self::binomial(Self::zero(), Self::one(), generator)
    }

    /// The generator of the level on which it lies; none for a rational integer.
    #[must_use]
    pub fn level(&self) -> Option<&Generator> {
        match self {
            Self::Rational(_) => None,
            Self::Irrational(own) => Some(&own.generator),
        }
    }

    fn height(&self) -> usize {
        self.level().map_or(0, Generator::level)
    }

    /// a − b√aₖ
    fn conjugate(own: &Binomial) -> Self {
        Self::binomial(own.constant.clone(), own.slope.negated(), &own.generator)
    }

    /// a² − aₖ b², below the level of the number; not 0
    pub(super) fn norm(own: &Binomial) -> Self {
        let square = own.slope.times(&own.slope).times(own.generator.square());
        own.constant.times(&own.constant).minus(&square)
    }

    /// The numerator and the denominator of 1/a; none for 0.
    ///
    /// 1/(a + b√r) = (a − b√r)/(a² − r b²), level by level.
    pub(super) fn inverse(&self) -> Option<(Self, Integer)> {
        match self {
            Self::Rational(own) => {
                (!own.is_zero()).then(|| (Self::Rational(Integer::from(1)), own.clone()))
            }
            Self::Irrational(own) => {
                let (numerator, denominator) = Self::norm(own).inverse()?;
                let common = numerator.content_with(&denominator);
                let numerator = numerator.divided(&common);
                Some((Self::conjugate(own).times(&numerator), denominator / common))
            }
        }
    }

    /// An interval around it at the precision.
    #[must_use]
    pub fn enclose(&self, precision: u32) -> Enclosure {
        match self {
            Self::Rational(own) => Enclosure::of_integer(own, precision),
            Self::Irrational(own) => {
                let slope = own.slope.enclose(precision);
                let root = own.generator.enclose(precision);
                own.constant.enclose(precision).plus(&slope.times(&root))
            }
        }
    }

    /// Its coordinates on the products of generators: the generators of each product from the
    /// ground up, in the order 1, r₁, r₂, r₁r₂, r₃, …
    #[must_use]
    pub fn components(&self) -> Vec<(Vec<Generator>, &Integer)> {
        match self {
            Self::Rational(own) if own.is_zero() => Vec::new(),
            Self::Rational(own) => vec![(Vec::new(), own)],
            Self::Irrational(own) => {
                let mut components = own.constant.components();
                for (mut product, value) in own.slope.components() {
                    product.push(own.generator.clone());
                    components.push((product, value));
                }
                components
            }
        }
    }

    fn map(&self, change: &impl Fn(&Integer) -> Integer) -> Self {
        match self {
            Self::Rational(own) => Self::Rational(change(own)),
            Self::Irrational(own) => Self::binomial(
                own.constant.map(change),
                own.slope.map(change),
                &own.generator,
            ),
        }
    }

    /// a ± b, by the operation on rational integers.
    fn combine(&self, other: &Self, join: &impl Fn(&Integer, &Integer) -> Integer) -> Self {
        match (self, other) {
            (Self::Rational(left), Self::Rational(right)) => Self::Rational(join(left, right)),
            (Self::Irrational(left), _) if self.height() > other.height() => {
                let constant = left.constant.combine(other, join);
                Self::binomial(constant, left.slope.clone(), &left.generator)
            }
            (Self::Irrational(left), Self::Irrational(right))
                if self.height() == other.height() =>
            {
                let constant = left.constant.combine(&right.constant, join);
                let slope = left.slope.combine(&right.slope, join);
                Self::binomial(constant, slope, &left.generator)
            }
            (_, Self::Irrational(right)) => {
                let constant = self.combine(&right.constant, join);
                let slope = Self::zero().combine(&right.slope, join);
                Self::binomial(constant, slope, &right.generator)
            }
            (Self::Irrational(_), Self::Rational(_)) => self.clone(),
        }
    }

    /// a += b, in the memory of a.
    fn accumulate(&mut self, other: Self) {
        if self.height() < other.height() {
            let own = std::mem::replace(self, other);
            return self.accumulate(own);
        }
        match (&mut *self, other) {
            (Self::Rational(own), Self::Rational(other)) => *own += other,
            (Self::Irrational(own), Self::Irrational(other))
                if own.generator.level() == other.generator.level() =>
            {
                let Binomial {
                    constant, slope, ..
                } = *other;
                own.constant.accumulate(constant);
                own.slope.accumulate(slope);
                if own.slope.is_zero() {
                    *self = std::mem::replace(&mut own.constant, Self::zero());
                }
            }
            (Self::Irrational(own), other) => own.constant.accumulate(other),
            (Self::Rational(_), Self::Irrational(_)) => {}
        }
    }
}

impl Ring for SurdInteger {
    #[inline]
    fn zero() -> Self {
        Self::Rational(Ring::zero())
    }

    #[inline]
    fn one() -> Self {
        Self::Rational(Ring::one())
    }

    fn unit() -> &'static Self {
        static ONE: SurdInteger = SurdInteger::Rational(Integer::of_machine(1));
        &ONE
    }

    fn from_integer(value: &Integer) -> Self {
        Self::Rational(value.clone())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        matches!(self, Self::Rational(own) if Ring::is_zero(own))
    }

    #[inline]
    fn is_one(&self) -> bool {
        matches!(self, Self::Rational(own) if Ring::is_one(own))
    }

    #[inline]
    fn plus(&self, other: &Self) -> Self {
        if let (Self::Rational(left), Self::Rational(right)) = (self, other) {
            return Self::Rational(left + right);
        }
        self.combine(other, &|left, right| left + right)
    }

    #[inline]
    fn minus(&self, other: &Self) -> Self {
        if let (Self::Rational(left), Self::Rational(right)) = (self, other) {
            return Self::Rational(left - right);
        }
        self.combine(other, &|left, right| left - right)
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        if let (Self::Rational(own), Self::Rational(other)) = (&mut *self, other) {
            own.add(other);
        } else {
            self.accumulate(other.clone());
        }
    }

    fn times(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::Rational(left), Self::Rational(right)) => Self::Rational(left * right),
            (Self::Rational(factor), own) | (own, Self::Rational(factor)) => own.scaled(factor),
            (Self::Irrational(left), Self::Irrational(right)) => {
                match self.height().cmp(&other.height()) {
                    Ordering::Greater => Self::binomial(
                        left.constant.times(other),
                        left.slope.times(other),
                        &left.generator,
                    ),
                    Ordering::Less => other.times(self),
                    Ordering::Equal => {
                        // (a + b√r)(c + d√r) = ac + bd r + (ad + bc)√r
                        let mut constant = left.constant.times(&right.constant);
                        let square = left.slope.times(&right.slope);
                        constant.add_product(&square, left.generator.square());
                        let mut slope = left.constant.times(&right.slope);
                        slope.add_product(&left.slope, &right.constant);
                        Self::binomial(constant, slope, &left.generator)
                    }
                }
            }
        }
    }

    #[inline]
    fn add_product(&mut self, left: &Self, right: &Self) {
        if let (Self::Rational(own), Self::Rational(left), Self::Rational(right)) =
            (&mut *self, left, right)
        {
            own.add_product(left, right);
        } else {
            self.accumulate(left.times(right));
        }
    }

    fn convolution(left: &[Self], right: &[Self]) -> Vec<Self> {
        let product = convolution::of_integers(left, right, Self::Rational);
        let product = product.or_else(|| surd_list::by_parts(left, right));
        product.unwrap_or_else(|| convolution::one_by_one(left, right))
    }

    fn binomial_sums(powers: &[Self], degree: usize) -> Vec<Self> {
        binomial_sums::of_integers(powers, degree, Self::Rational)
            .unwrap_or_else(|| surd_list::sums_by_parts(powers, degree))
    }

    fn halves(coefficients: Vec<Self>) -> (Vec<Self>, Vec<Self>) {
        halves::in_machine_numbers(&coefficients, Self::Rational)
            .unwrap_or_else(|| halves::one_by_one(coefficients))
    }

    fn negated(&self) -> Self {
        self.map(&|own| -own)
    }

    #[inline]
    fn scaled(&self, factor: &Integer) -> Self {
        match self {
            Self::Rational(own) => Self::Rational(own * factor),
            Self::Irrational(_) if Ring::is_zero(factor) => Self::zero(),
            Self::Irrational(_) => self.map(&|own| own * factor),
        }
    }

    fn divided(&self, divisor: &Integer) -> Self {
        self.map(&|own| own / divisor)
    }

    fn quotient(&self, divisor: &Self) -> Option<Self> {
        match (self, divisor) {
            (Self::Rational(own), Self::Rational(divisor)) => {
                own.quotient(divisor).map(Self::Rational)
            }
            (Self::Irrational(own), _) if self.height() > divisor.height() => Some(Self::binomial(
                own.constant.quotient(divisor)?,
                own.slope.quotient(divisor)?,
                &own.generator,
            )),
            // x / (a + b√r) = x (a − b√r) / (a² − r b²), part by part
            (_, Self::Irrational(divisor)) => self
                .times(&Self::conjugate(divisor))
                .quotient(&Self::norm(divisor)),
            (Self::Irrational(_), Self::Rational(_)) => None,
        }
    }

    fn content_with(&self, other: &Integer) -> Integer {
        if Ring::is_one(other) {
            return other.clone();
        }
        match self {
            Self::Rational(own) => gcd(other, own),
            Self::Irrational(own) => {
                let slope = own.slope.content_with(other);
                own.constant.content_with(&slope)
            }
        }
    }

    #[inline]
    fn sign(&self) -> Ordering {
        match self {
            Self::Rational(own) => Ring::sign(own),
            Self::Irrational(own) => match (own.constant.sign(), own.slope.sign()) {
                (Ordering::Equal, sign) => sign,
                (left, right) if left == right => left,
                // Not 0, so some enclosure excludes 0.
                _ => self.leading().map_or_else(
                    || refine(|precision| self.enclose(precision).sign()),
                    |own| own.sign(),
                ),
            },
        }
    }

    fn height(&self) -> usize {
        Self::height(self)
    }

    fn place(&self) -> Option<Place> {
        match self.level() {
            None => Some(Place::rational()),
            Some(generator) => generator.place(),
        }
    }

    fn image(&self, place: &Place) -> u64 {
        let modulus = place.modulus();
        match self {
            Self::Rational(own) => modulus.embed_integer(own),
            Self::Irrational(own) => {
                let root = place.root(own.generator.level() - 1);
                let slope = modulus.times(own.slope.image(place), root);
                modulus.plus(own.constant.image(place), slope)
            }
        }
    }

    fn basis<'a>(elements: impl IntoIterator<Item = &'a Self>) -> Basis {
        Basis::of(elements)
    }

    fn from_components(basis: &Basis, components: &[Integer]) -> Self {
        let mut parts: Vec<Self> = components.iter().cloned().map(Self::Rational).collect();
        for generator in basis.generators() {
            let pairs = parts.chunks(2);
            parts = pairs
                .map(|pair| match pair {
                    [constant, slope] => Self::binomial(constant.clone(), slope.clone(), generator),
                    _ => pair.first().cloned().unwrap_or_else(Self::zero),
                })
                .collect();
        }
        parts.into_iter().next().unwrap_or_else(Self::zero)
    }

    fn bits(&self) -> u64 {
        match self {
            Self::Rational(own) => Ring::bits(own),
            Self::Irrational(own) => own.constant.bits().max(own.slope.bits()),
        }
    }

    fn as_integer(&self) -> Option<&Integer> {
        match self {
            Self::Rational(own) => Some(own),
            Self::Irrational(_) => None,
        }
    }

    fn leading(&self) -> Option<Leading> {
        match self {
            Self::Rational(own) => own.leading(),
            Self::Irrational(own) => {
                let product = own.slope.leading()?.times(own.generator.leading()?)?;
                own.constant.leading()?.plus(product)
            }
        }
    }
}

/// `3 - 2*√2`, every radical written out.
impl fmt::Display for SurdInteger {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&super::radicals(self, &Integer::from(1)))
    }
}
