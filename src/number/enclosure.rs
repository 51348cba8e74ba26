use std::cmp::Ordering;

use super::{Integer, Rational, Ring};

/// A closed interval [l, u] · 2⁻ᵖ that holds a real number.
///
/// Every operation rounds outwards, so a sign or a digit that both ends agree on is proved; one
/// that they do not agree on asks for a greater precision p. Both operands of an operation have
/// the same precision.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Enclosure {
    lower: Integer,
    upper: Integer,
    precision: u32,
}

impl Enclosure {
    /// [l, u] · 2⁻ᵖ with l ≤ u.
    #[must_use]
    pub fn new(lower: Integer, upper: Integer, precision: u32) -> Self {
        Self {
            lower,
            upper,
            precision,
        }
    }

    /// An integer.
    #[must_use]
    pub fn of_integer(value: &Integer, precision: u32) -> Self {
        let scaled = value << precision;
        Self::new(scaled.clone(), scaled, precision)
    }

    /// A rational number.
    #[must_use]
    pub fn of_rational(value: &Rational, precision: u32) -> Self {
        let (quotient, remainder) =
            (value.numerator() << precision).div_mod_floor(value.denominator());
        let upper = if Ring::is_zero(&remainder) {
            quotient.clone()
        } else {
            &quotient + 1
        };
        Self::new(quotient, upper, precision)
    }

    /// p
    #[must_use]
    pub fn precision(&self) -> u32 {
        self.precision
    }

    /// l
    pub(super) fn lower(&self) -> &Integer {
        &self.lower
    }

    /// The ends, as rational numbers.
    #[must_use]
    pub fn ends(&self) -> [Rational; 2] {
        [&self.lower, &self.upper].map(|end| Rational::dyadic(end, self.precision))
    }

    /// The sign, if it is the same everywhere in the interval.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        let [lower, upper] = [&self.lower, &self.upper].map(Ring::sign);
        (lower == upper).then_some(lower)
    }

    /// a + b
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        debug_assert_eq!(self.precision, other.precision);
        let (lower, upper) = (&self.lower + &other.lower, &self.upper + &other.upper);
        Self::new(lower, upper, self.precision)
    }

    /// −a
    #[must_use]
    pub fn negated(&self) -> Self {
        Self::new(-&self.upper, -&self.lower, self.precision)
    }

    /// a − b
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// a b
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        debug_assert_eq!(self.precision, other.precision);
        let (left, right) = (self.sign(), other.sign());
        if left == Some(Ordering::Greater) && right == Some(Ordering::Greater) {
            let (lower, upper) = (&self.lower * &other.lower, &self.upper * &other.upper);
            return self.rescaled(&lower, &upper);
        }
        let products = [
            &self.lower * &other.lower,
            &self.lower * &other.upper,
            &self.upper * &other.lower,
            &self.upper * &other.upper,
        ];
        let [mut lower, mut upper] = [products[0].clone(), products[0].clone()];
        for product in products {
            if product < lower {
                lower.clone_from(&product);
            }
            if product > upper {
                upper = product;
            }
        }
        self.rescaled(&lower, &upper)
    }

    /// The product of two scaled intervals, scaled once.
    fn rescaled(&self, lower: &Integer, upper: &Integer) -> Self {
        Self::new(
            lower >> self.precision,
            ceiling_shift(upper, self.precision),
            self.precision,
        )
    }

    /// 1 / a; none if 0 lies in the interval
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        if self.sign()?.is_eq() {
            return None;
        }
        let unit = Integer::from(1) << (2 * self.precision);
        let lower = unit.div_floor(&self.upper);
        let upper = -(-unit).div_floor(&self.lower);
        Some(Self::new(lower, upper, self.precision))
    }

    /// a / n for a positive integer n
    #[must_use]
    pub fn divided(&self, divisor: &Integer) -> Self {
        let upper = -(-&self.upper).div_floor(divisor);
        Self::new(self.lower.div_floor(divisor), upper, self.precision)
    }

    /// √a, of what is negative in the interval that of 0.
    #[must_use]
    pub fn square_root(&self) -> Self {
        let root = |end: &Integer| {
            let square = end.max(&Integer::from(0)) << self.precision;
            let root = square.sqrt();
            let exact = &root * &root == square;
            (root, exact)
        };
        let ((lower, _), (upper, exact)) = (root(&self.lower), root(&self.upper));
        let upper = if exact { upper } else { upper + 1 };
        Self::new(lower, upper, self.precision)
    }

    /// |a|
    #[must_use]
    pub fn absolute(&self) -> Self {
        if Ring::sign(&self.lower).is_lt() && Ring::sign(&self.upper).is_gt() {
            let upper = (-&self.lower).max(self.upper.clone());
            return Self::new(Integer::from(0), upper, self.precision);
        }
        if Ring::sign(&self.upper).is_gt() {
            self.clone()
        } else {
            self.negated()
        }
    }

    /// The smallest interval that holds both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        let lower = (&self.lower).min(&other.lower).clone();
        let upper = (&self.upper).max(&other.upper).clone();
        Self::new(lower, upper, self.precision)
    }

    /// π
    ///
    /// π/4 = 4 arctan 1/5 − arctan 1/239.   (Machin)
    #[must_use]
    pub fn pi(precision: u32) -> Self {
        let inner = precision + 16;
        let part = |of: i64| arctangent_of_inverse(&Integer::from(of), inner);
        let four = Self::of_integer(&4.into(), inner);
        let quarter = four.times(&part(5)).minus(&part(239));
        quarter.times(&four).coarser(precision)
    }

    /// arctan a, which grows with a: from the lower end's to the upper end's.
    #[must_use]
    pub fn arctangent(&self) -> Self {
        let [lower, upper] = [&self.lower, &self.upper].map(|end| {
            let size = Self::new(end.abs(), end.abs(), self.precision).arctangent_of_positive();
            if Ring::sign(end).is_lt() {
                size.negated()
            } else {
                size
            }
        });
        Self::new(lower.lower, upper.upper, self.precision)
    }

    /// arctan a for a number a ≥ 0: π/2 − arctan 1/a if it is greater than 1.
    fn arctangent_of_positive(&self) -> Self {
        let inner = self.precision + 8;
        let own = self.finer(inner);
        if own.lower > Integer::from(1) << inner
            && let Some(inverse) = own.inverse()
        {
            let right = Self::pi(inner).divided(&Integer::from(2));
            return right
                .minus(&inverse.arctangent_of_small())
                .coarser(self.precision);
        }
        own.arctangent_of_small().coarser(self.precision)
    }

    /// arctan a for a narrow interval in [0, 1].
    ///
    /// arctan a = 2 arctan(a / (1 + √(1 + a²))) until the argument is small, then the series
    /// Σ (−1)ᵏ a^(2k+1)/(2k+1), which alternates.
    fn arctangent_of_small(&self) -> Self {
        const HALVINGS: u32 = 4;
        let inner = self.precision + 24;
        let one = Self::of_integer(&1.into(), inner);
        let mut argument = self.finer(inner);
        for _ in 0..HALVINGS {
            let root = one.plus(&argument.times(&argument)).square_root();
            let inverse = one.plus(&root).inverse();
            argument = inverse.map_or_else(|| argument.clone(), |inverse| argument.times(&inverse));
        }
        let square = argument.times(&argument);
        let (mut power, mut sum) = (argument.clone(), argument);
        for order in 1_u32.. {
            power = power.times(&square).negated();
            let term = power.divided(&Integer::from(2 * order + 1));
            sum = sum.plus(&term);
            // An alternating series errs by less than its next term.
            let size = term.absolute().upper;
            if size <= Integer::from(1) {
                let error = Self::new(-&size - 1, size + 1, inner);
                sum = sum.plus(&error);
                break;
            }
        }
        Self::new(sum.lower << HALVINGS, sum.upper << HALVINGS, inner).coarser(self.precision)
    }

    /// The digits behind the point that both ends round to, at most so many; none if they differ
    /// before the point.
    #[must_use]
    pub fn decimal(&self, digits: u32) -> Option<String> {
        let [lower, upper] = self.ends().map(|end| end.decimal(digits));
        (lower == upper).then_some(lower)
    }

    /// The same interval at a greater precision.
    fn finer(&self, precision: u32) -> Self {
        let shift = precision - self.precision;
        Self::new(&self.lower << shift, &self.upper << shift, precision)
    }

    /// u − l, in steps of 2⁻ᵖ
    #[must_use]
    pub fn width(&self) -> Integer {
        &self.upper - &self.lower
    }

    /// An interval around it at a smaller precision.
    pub(super) fn coarser(&self, precision: u32) -> Self {
        let shift = self.precision - precision;
        let upper = ceiling_shift(&self.upper, shift);
        Self::new(&self.lower >> shift, upper, precision)
    }
}

/// ⌈n / 2ᵏ⌉
fn ceiling_shift(value: &Integer, shift: u32) -> Integer {
    -(-value >> shift)
}

/// arctan 1/n for an integer n > 1.
fn arctangent_of_inverse(inverse: &Integer, precision: u32) -> Enclosure {
    let unit = Integer::from(1) << precision;
    let square = inverse * inverse;
    let mut power = unit / inverse;
    let mut sum = power.clone();
    let mut terms = 1_u32;
    for order in 1_u32.. {
        power /= &square;
        if Ring::is_zero(&power) {
            break;
        }
        let term = &power / Integer::from(2 * order + 1);
        if order % 2 == 1 {
            sum -= term;
        } else {
            sum += term;
        }
        terms += 1;
    }
    // Each term is cut off by less than two steps, and so is the rest of the series.
    let error = Integer::from(2 * terms + 2);
    Enclosure::new(&sum - &error, sum + error, precision)
}

/// Runs a computation at growing precisions until it succeeds.
///
/// It must succeed at some precision: the caller asks only what has an answer.
pub(super) fn refine<T>(mut attempt: impl FnMut(u32) -> Option<T>) -> T {
    let mut precision = 48;
    loop {
        if let Some(answer) = attempt(precision) {
            return answer;
        }
        precision *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn holds(enclosure: &Enclosure, digits: &str) -> bool {
        let [lower, upper] = enclosure.ends();
        let value: Result<Rational, ()> = digits.parse();
        value.is_ok_and(|value| lower <= value && value <= upper)
    }

    #[test]
    fn classical_constants_are_enclosed_narrowly() {
        let pi = "3.14159265358979323846264338327950288419716939937510582097494459230781640629";
        let found = Enclosure::pi(200);
        assert!(holds(&found, pi), "{found:?}");
        assert!(&found.upper - &found.lower < Integer::from(8));
        let one = Enclosure::of_integer(&1.into(), 200);
        let quarter = one
            .arctangent()
            .times(&Enclosure::of_integer(&4.into(), 200));
        assert!(holds(&quarter, pi), "{quarter:?}");
        let root = Enclosure::of_integer(&2.into(), 200).square_root();
        let two = "1.41421356237309504880168872420969807856967187537694807317667973799073247846";
        assert!(holds(&root, two));
        assert_eq!(root.decimal(20).as_deref(), Some("1.41421356237309504880"));
    }

    #[test]
    fn wide_intervals_and_large_numbers_have_arctangents() {
        // arctan 0 = 0, and arctan 2⁹⁰⁰ is less than π/2 by no more than 2⁻⁹⁰⁰
        let large: Integer = Integer::from(1) << 964_u32;
        let wide = Enclosure::new(Integer::from(0), large.clone(), 64).arctangent();
        let right = Enclosure::pi(64).divided(&2.into());
        assert!(wide.lower <= Integer::from(0) && wide.lower >= Integer::from(-2));
        let gap = wide.upper - &right.lower;
        assert!(gap >= Integer::from(0) && gap < Integer::from(8));
        let odd = Enclosure::new(-&large, large, 64).arctangent();
        assert_eq!(odd.negated(), odd);
    }

    #[test]
    fn angles_add_up() {
        // arctan 2 + arctan 1/2 = π/2, and arctan is odd
        let two = Enclosure::of_integer(&2.into(), 128);
        let half = two.inverse().map(|half| half.arctangent());
        let sum = half.map(|half| half.plus(&two.arctangent()));
        let right = Enclosure::pi(128).divided(&2.into());
        let gap = sum.map(|sum| sum.minus(&right).absolute());
        assert!(gap.is_some_and(|gap| gap.lower == 0 && gap.upper < 16));
        let minus = two.negated().arctangent().plus(&two.arctangent());
        assert_eq!(minus.sign(), None);
    }
}
