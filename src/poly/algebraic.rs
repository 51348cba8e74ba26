use std::cmp::Ordering;

use super::bernstein::scaled_bernstein;
use super::root::{middle, sign_changes};
use super::{BiPoly, RealRoot, UniPoly, gcd};
use crate::number::{Field, Integer, Ring, lcm};

/// The field F(α) of a real root α: its elements are polynomials in α.
///
/// The polynomial m of α need not be irreducible. When a question about an element c finds a
/// common divisor of c and m, the one of its two cofactors that vanishes at α takes the place of
/// m: dynamic evaluation.
pub(super) struct Algebraic<F: Field> {
    root: RealRoot<F>,
}

/// A Sturm sequence over F(α): polynomials in v, each a list of elements of F[u] at u = α.
type Sequence<F> = Vec<Vec<UniPoly<F>>>;

impl<F: Field> Algebraic<F> {
    /// The field of a root that is not exact.
    pub(super) fn new(root: RealRoot<F>) -> Self {
        Self { root }
    }

    /// The root, in an interval as narrow as the questions asked so far needed.
    pub(super) fn root(&self) -> &RealRoot<F> {
        &self.root
    }

    /// A root of p(α, v) in from < v < to, as an interval of at most the given width in which
    /// there is no other, or as lower = upper; none if there is no root. The ends are no roots.
    pub(super) fn some_root(
        &mut self,
        polynomial: &BiPoly<F>,
        from: &F,
        to: &F,
        width: &F,
    ) -> Option<(F, F)> {
        let sequence = self.sturm_sequence(polynomial.columns());
        let (mut lower, mut upper) = (from.clone(), to.clone());
        let start = self.changes(&sequence, &lower);
        let mut count = start.saturating_sub(self.changes(&sequence, &upper));
        if count == 0 {
            return None;
        }
        while count > 1 || upper.minus(&lower) > *width {
            let middle = middle(&lower, &upper);
            let value = self.value(&sequence[0], &middle);
            if self.is_zero(&value) {
                return Some((middle.clone(), middle));
            }
            // No root so far lies below the lower end, so the count from the start is the same.
            let left = start.saturating_sub(self.changes(&sequence, &middle));
            if left == 0 {
                lower = middle;
            } else {
                (upper, count) = (middle, left);
            }
        }
        Some((lower, upper))
    }

    /// p(α, v), its derivative, and the negated remainders up to positive factors.
    fn sturm_sequence(&mut self, columns: Vec<UniPoly<F>>) -> Sequence<F> {
        let first = self.trim(columns);
        let second = first.iter().enumerate().skip(1);
        let second: Vec<_> = second
            .map(|(power, own)| own.scale(&F::from_integer(&Integer::from(power))))
            .collect();
        let mut sequence = vec![first, second];
        while let [.., high, low] = sequence.as_slice()
            && !low.is_empty()
        {
            let remainder = self.negated_remainder(high.clone(), low);
            sequence.push(remainder);
        }
        sequence.pop();
        sequence
    }

    /// −a mod b times a positive number: each step multiplies by lc(b), and the sign of that is
    /// undone at the end.
    fn negated_remainder(
        &mut self,
        mut high: Vec<UniPoly<F>>,
        low: &[UniPoly<F>],
    ) -> Vec<UniPoly<F>> {
        let Some((lead, body)) = low.split_last() else {
            return Vec::new();
        };
        let mut negate = true;
        let falling = self.sign(lead).is_lt();
        while high.len() >= low.len() {
            let Some(top) = high.pop() else {
                return high;
            };
            let offset = high.len() - body.len();
            for (index, own) in high.iter_mut().enumerate() {
                let mut value = &*own * lead;
                if index >= offset {
                    value = &value - &(&top * &body[index - offset]);
                }
                *own = value;
            }
            negate ^= falling;
            high = self.trim(high);
        }
        let high = positive_primitive(high);
        if negate {
            high.iter().map(|own| -own).collect()
        } else {
            high
        }
    }

    /// The coefficients reduced modulo m, without leading zeros.
    fn trim(&mut self, coefficients: Vec<UniPoly<F>>) -> Vec<UniPoly<F>> {
        let reduced = coefficients.iter().map(|own| self.reduce(own));
        let mut reduced: Vec<_> = reduced.collect();
        while let Some(last) = reduced.last() {
            if !self.is_zero(last) {
                break;
            }
            reduced.pop();
        }
        reduced
    }

    fn reduce(&self, value: &UniPoly<F>) -> UniPoly<F> {
        match value.div_rem(self.root.polynomial()) {
            Some((_, remainder)) => remainder,
            None => value.clone(),
        }
    }

    /// The number of changes of sign of the sequence at v.
    fn changes(&mut self, sequence: &Sequence<F>, at: &F) -> usize {
        let mut changes = 0;
        let mut last = Ordering::Equal;
        for own in sequence {
            let value = self.value(own, at);
            let sign = self.sign(&value);
            if sign.is_ne() {
                changes += usize::from(last == sign.reverse());
                last = sign;
            }
        }
        changes
    }

    /// Σ cⱼ vʲ as an element of F(α).
    fn value(&self, coefficients: &[UniPoly<F>], at: &F) -> UniPoly<F> {
        let value = coefficients
            .iter()
            .rev()
            .fold(UniPoly::zero(), |value, own| &value.scale(at) + own);
        self.reduce(&value)
    }

    /// Whether c(α) = 0; the polynomial of α is split on the way if it can be.
    fn is_zero(&mut self, value: &UniPoly<F>) -> bool {
        if value.is_zero() {
            return true;
        }
        if self.root.is_exact() {
            return value.evaluate(self.root.lower()).is_zero();
        }
        let common = gcd(value, self.root.polynomial());
        if common.is_constant() {
            return false;
        }
        let Some(rest) = self.root.polynomial().exact_div(&common) else {
            return false;
        };
        let [below, above] =
            [self.root.lower(), self.root.upper()].map(|end| common.evaluate(end).sign());
        let vanishes = below != above;
        self.root = self.root.of_divisor(if vanishes { common } else { rest });
        vanishes
    }

    /// The sign of c(α): that of c on an interval around α without roots of c.
    fn sign(&mut self, value: &UniPoly<F>) -> Ordering {
        if self.is_zero(value) {
            return Ordering::Equal;
        }
        loop {
            let (lower, upper) = (self.root.lower(), self.root.upper());
            if self.root.is_exact() {
                return value.evaluate(lower).sign();
            }
            let local = value.restrict(lower, upper);
            let degree = local.degree().unwrap_or(0);
            let coefficients = scaled_bernstein(local.numerators(), degree);
            if sign_changes(&coefficients) == 0 {
                // Not all are 0, so inside the interval no sum of them vanishes.
                let sign = coefficients.iter().map(Ring::sign);
                return sign
                    .into_iter()
                    .find(|sign| sign.is_ne())
                    .unwrap_or(Ordering::Equal);
            }
            self.root.halve();
        }
    }
}

/// The polynomials times a positive number that makes their numerators coprime integers over 1.
fn positive_primitive<F: Field>(coefficients: Vec<UniPoly<F>>) -> Vec<UniPoly<F>> {
    let mut content = <Integer as Ring>::zero();
    let mut denominator = Integer::from(1);
    for own in &coefficients {
        content = crate::number::gcd(&content, &own.content());
        denominator = lcm(&denominator, own.denominator());
    }
    if Ring::is_zero(&content) {
        return coefficients;
    }
    let factor = F::from_parts(F::Ring::from_integer(&denominator), content);
    coefficients.iter().map(|own| own.scale(&factor)).collect()
}
