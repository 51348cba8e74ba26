use super::UniPoly;
use crate::number::{Field, Ring};

impl<F: Field> UniPoly<F> {
    /// Quotient and remainder; none if the divisor is 0.
    #[must_use]
    pub fn div_rem(&self, divisor: &Self) -> Option<(Self, Self)> {
        let inverse = divisor.leading_coefficient().inverse()?;
        let low = divisor.degree()?;
        let Some(steps) = self.degree().and_then(|high| high.checked_sub(low)) else {
            return Some((Self::zero(), self.clone()));
        };
        let monic = divisor.scale(&inverse);
        // With the monic divisor m / e every step multiplies the remainder by e only.
        let (body, lead) = (monic.numerators(), monic.denominator());
        let mut remainder = self.numerators().to_vec();
        let mut denominator = self.denominator().clone();
        let mut quotient = vec![F::zero(); steps + 1];
        for step in (0..=steps).rev() {
            let top = remainder[step + low].clone();
            quotient[step] = F::from_parts(top.clone(), denominator.clone());
            if top.is_zero() {
                continue;
            }
            denominator *= lead;
            for (index, own) in remainder.iter_mut().enumerate() {
                *own = own.scaled(lead);
                if (step..=step + low).contains(&index) {
                    *own = own.minus(&top.times(&body[index - step]));
                }
            }
        }
        remainder.truncate(low);
        let quotient = Self::from_coefficients(&quotient).scale(&inverse);
        Some((quotient, Self::from_numerators(remainder, denominator)))
    }

    /// The quotient if the divisor divides; none if it does not, or is 0.
    #[must_use]
    pub fn exact_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_one() {
            return Some(self.clone());
        }
        if divisor.is_constant() {
            return Some(self.scale(&divisor.leading_coefficient().inverse()?));
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        match self.ring_quotient(divisor) {
            Some(quotient) => Some(quotient),
            // Gauss's lemma: over the integers there is no other road.
            None if self.is_rational() && divisor.is_rational() => None,
            None => {
                let (quotient, remainder) = self.div_rem(divisor)?;
                remainder.is_zero().then_some(quotient)
            }
        }
    }

    /// Long division of the numerators by the divisor's primitive numerators inside the ring.
    fn ring_quotient(&self, divisor: &Self) -> Option<Self> {
        let low = divisor.degree()?;
        let steps = self.degree()?.checked_sub(low)?;
        let content = divisor.content();
        let body: Vec<_> = divisor
            .numerators()
            .iter()
            .map(|own| own.divided(&content))
            .collect();
        let mut remainder = self.numerators().to_vec();
        let mut quotient = vec![F::Ring::zero(); steps + 1];
        for step in (0..=steps).rev() {
            let digit = remainder[step + low].quotient(&body[low])?;
            if !digit.is_zero() {
                let negated = digit.negated();
                for (index, own) in body.iter().enumerate() {
                    remainder[step + index].add_product(&negated, own);
                }
            }
            quotient[step] = digit;
        }
        if !remainder[..low].iter().all(Ring::is_zero) {
            return None;
        }
        let scale = quotient
            .into_iter()
            .map(|own| own.scaled(divisor.denominator()));
        Some(Self::from_numerators(
            scale.collect(),
            self.denominator() * content,
        ))
    }
}
