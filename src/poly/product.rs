use std::ops::{Mul, Neg};

use super::UniPoly;
use super::numerators::Numerators;
use crate::number::{Field, MachineList, Ring, machine_gcd, machine_quotient};

/// Products of two polynomials with so many coefficients are multiplied out only when asked for.
const LONG: usize = 16;

impl<F: Field> UniPoly<F> {
    /// c p(x)
    #[must_use]
    pub fn scale(&self, factor: &F) -> Self {
        if self.is_zero() || factor.is_zero() {
            return Self::zero();
        }
        if factor.is_one() {
            return self.clone();
        }
        if let Some(scaled) = self.scaled_by_machine(factor) {
            return scaled;
        }
        let (numerator, denominator) = factor.parts();
        if numerator.height() > 0 {
            let scaled = self.numerators().iter().map(|own| own.times(numerator));
            return Self::from_numerators(scaled.collect(), self.denominator() * denominator);
        }
        // Only crosswise is there something to cancel.
        let first = self.content_with(denominator);
        let second = numerator.content_with(self.denominator());
        let below = (self.denominator() / &second) * (denominator / &first);
        let numerator = numerator.divided(&second);
        let numerators = match self.numerators_held() {
            Some(own) => own.times_ratio(&numerator, &first),
            None => vec![numerator].into(),
        };
        Self::of_parts(numerators, below)
    }

    /// c p(x) for a rational c, if all numbers are machine numbers.
    fn scaled_by_machine(&self, factor: &F) -> Option<Self> {
        let (above, below) = factor.machine_parts()?;
        let own = self.numerators_held()?.machine()?;
        let denominator = self.denominator().machine()?;
        let first = own.content_with(below.unsigned_abs()).cast_signed();
        let second = machine_gcd(above, denominator);
        let numbers = own.times_ratio(machine_quotient(above, second), first)?;
        let below =
            machine_quotient(denominator, second).checked_mul(machine_quotient(below, first))?;
        Some(Self::of_parts(numbers.into(), below.into()))
    }

    /// Whether a product is better left alone until its coefficients are asked for.
    fn is_long_product(&self, other: &Self) -> bool {
        let length = |own: &Self| own.degree().unwrap_or(0) + 1;
        length(self).min(length(other)) >= LONG && self.is_rational() && other.is_rational()
    }

    /// The product of polynomials that are not 0, multiplied out.
    fn convolution(&self, other: &Self) -> Numerators<F::Ring> {
        if let (Some(left), Some(right)) = (self.machine(), other.machine())
            && let Some(product) = MachineList::convolution(left, right)
        {
            return product.into();
        }
        F::Ring::convolution(self.numerators(), other.numerators()).into()
    }

    /// p(x)ⁿ
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        if exponent == 1 {
            return self.clone();
        }
        if let (Some(own), Ok(power)) = (self.machine(), usize::try_from(exponent))
            && own.iter().eq([0, 1])
            && self.denominator().is_one()
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
}

impl<F: Field> Mul for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn mul(self, other: Self) -> UniPoly<F> {
        match (self.degree(), other.degree()) {
            _ if other.is_one() => return self.clone(),
            _ if self.is_one() => return other.clone(),
            (None, _) | (_, None) => return UniPoly::zero(),
            (_, Some(0)) => return self.scale(&other.coefficient(0)),
            (Some(0), _) => return other.scale(&self.coefficient(0)),
            _ => {}
        }
        if !self.is_rational() || !other.is_rational() {
            let denominator = self.denominator() * other.denominator();
            return UniPoly::lowest(self.convolution(other), denominator);
        }
        // Over the integers the content of a product is the product of the contents, so only
        // crosswise is there something to cancel.   (Gauss's lemma)
        let first = self.content_with(other.denominator());
        let second = other.content_with(self.denominator());
        let divisor = &first * &second;
        let product = if self.is_long_product(other) {
            Numerators::product(self.held(), other.held(), divisor)
        } else {
            self.convolution(other).over(&divisor)
        };
        UniPoly::of_parts(
            product,
            (self.denominator() / second) * (other.denominator() / first),
        )
    }
}

impl<F: Field> Neg for &UniPoly<F> {
    type Output = UniPoly<F>;
    fn neg(self) -> UniPoly<F> {
        self.scale(&F::one().negated())
    }
}
