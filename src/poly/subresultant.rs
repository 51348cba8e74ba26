use crate::number::Ring;

/// The end of the subresultant remainder sequence of two polynomials over an integral domain.
pub(super) struct Subresultant<R> {
    /// The last remainder that is not 0: their gcd up to a factor of the fraction field.
    pub(super) polynomial: Vec<R>,
    /// Their resultant; 0 if the gcd is not constant.
    pub(super) resultant: R,
}

impl<R: Ring> Subresultant<R> {
    /// Runs the sequence; the numerators ascend without trailing zeros, neither list is empty.
    ///
    /// With g = lc and h the leading coefficient of the regular subresultant of the same level,
    /// the pseudo-remainder of two neighbours is divisible by g hᵟ in any integral domain, where
    /// δ is the difference of their degrees. (Collins' and Brown's reduction)
    pub(super) fn of(first: &[R], second: &[R]) -> Self {
        let (mut high, mut low) = (first.to_vec(), second.to_vec());
        let mut negative = false;
        if high.len() < low.len() {
            negative = high.len() % 2 == 0 && low.len() % 2 == 0;
            std::mem::swap(&mut high, &mut low);
        }
        let (mut lead, mut regular) = (R::one(), R::one());
        while low.len() > 1 {
            let gap = high.len() - low.len();
            negative ^= high.len() % 2 == 0 && low.len() % 2 == 0;
            let remainder = pseudo_remainder(high, &low);
            if remainder.is_empty() {
                return Self {
                    polynomial: low,
                    resultant: R::zero(),
                };
            }
            let divisor = lead.times(&power(&regular, gap));
            let reduced: Option<Vec<R>> =
                remainder.iter().map(|own| own.quotient(&divisor)).collect();
            high = low;
            low = reduced.unwrap_or(remainder);
            lead = high[high.len() - 1].clone();
            regular = next_regular(&lead, &regular, gap);
        }
        // The last step: h^(1−n) lc(b)ⁿ for a of degree n and a constant b.
        let resultant = next_regular(&low[0], &regular, high.len() - 1);
        Self {
            polynomial: vec![R::one()],
            resultant: if negative {
                resultant.negated()
            } else {
                resultant
            },
        }
    }
}

/// gᵟ h^(1−δ), which lies in the ring.
fn next_regular<R: Ring>(lead: &R, regular: &R, gap: usize) -> R {
    match gap {
        0 => regular.clone(),
        1 => lead.clone(),
        _ => power(lead, gap)
            .quotient(&power(regular, gap - 1))
            .unwrap_or_else(R::one),
    }
}

/// lc(b)^(δ+1) a mod b, with δ = deg a − deg b.
fn pseudo_remainder<R: Ring>(mut high: Vec<R>, low: &[R]) -> Vec<R> {
    let (body, lead) = (&low[..low.len() - 1], &low[low.len() - 1]);
    for offset in (0..=high.len() - low.len()).rev() {
        let top = high[offset + body.len()].negated();
        high.truncate(offset + body.len());
        for (index, own) in high.iter_mut().enumerate() {
            *own = own.times(lead);
            if index >= offset {
                own.add_product(&top, &body[index - offset]);
            }
        }
    }
    while high.last().is_some_and(Ring::is_zero) {
        high.pop();
    }
    high
}

fn power<R: Ring>(base: &R, exponent: usize) -> R {
    (0..exponent).fold(R::one(), |power, _| power.times(base))
}
