use std::cmp::Ordering;

use super::UniPoly;
use super::bernstein::{integral_scales, scaled_bernstein};
use super::rational_roots::roots_in_field;
use super::squarefree::square_free;
use crate::number::{Field, Integer, Ring};

/// A real root of a polynomial: a number given by a square-free polynomial and an interval that
/// holds none of its other roots.
///
/// Either lower = upper is the root, or the root lies strictly between them and the polynomial
/// has opposite signs there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RealRoot<F: Field> {
    polynomial: UniPoly<F>,
    lower: F,
    upper: F,
    multiplicity: u32,
}

impl<F: Field> RealRoot<F> {
    /// A number of the field, as the root of x − a.
    #[must_use]
    pub fn exact(value: F, multiplicity: u32) -> Self {
        let line = UniPoly::from_coefficients(&[value.negated(), F::one()]);
        Self {
            polynomial: line.primitive(),
            lower: value.clone(),
            upper: value,
            multiplicity,
        }
    }

    /// The same root by a divisor of its polynomial, which has it as its only root between the
    /// bounds.
    pub(super) fn of_divisor(&self, divisor: UniPoly<F>) -> Self {
        Self {
            polynomial: divisor,
            ..self.clone()
        }
    }

    /// The square-free polynomial.
    #[must_use]
    pub fn polynomial(&self) -> &UniPoly<F> {
        &self.polynomial
    }

    /// The lower end of the isolating interval.
    #[must_use]
    pub fn lower(&self) -> &F {
        &self.lower
    }

    /// The upper end of the isolating interval.
    #[must_use]
    pub fn upper(&self) -> &F {
        &self.upper
    }

    /// The multiplicity in the polynomial whose roots were asked for.
    #[must_use]
    pub fn multiplicity(&self) -> u32 {
        self.multiplicity
    }

    /// Whether the root is known as a number of the field.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.lower == self.upper
    }

    /// upper − lower
    #[must_use]
    pub fn width(&self) -> F {
        self.upper.minus(&self.lower)
    }

    /// Halves the interval until upper − lower ≤ width, or the root is hit; the width is
    /// positive.
    pub fn refine(&mut self, width: &F) {
        if self.is_exact() || self.width() <= *width {
            return;
        }
        let sign = self.polynomial.evaluate(&self.lower).sign();
        while !self.is_exact() && self.width() > *width {
            self.halve_from(sign);
        }
    }

    /// The place in words: `v = 1/3`, or for an irrational root an isolating interval that is
    /// narrow enough to be of use, `v in [181/256, 363/512]`.
    #[must_use]
    pub fn place(&self, variable: &str) -> String {
        let mut root = self.clone();
        let (numerator, denominator) = self.width().into_parts();
        root.refine(&F::from_parts(numerator, denominator * 1024));
        if root.is_exact() {
            format!("{variable} = {}", root.lower)
        } else {
            format!("{variable} in [{}, {}]", root.lower, root.upper)
        }
    }

    /// Halves the interval once.
    pub fn halve(&mut self) {
        if !self.is_exact() {
            let sign = self.polynomial.evaluate(&self.lower).sign();
            self.halve_from(sign);
        }
    }

    /// Halves the interval, at whose lower end the polynomial has the given sign.
    fn halve_from(&mut self, sign: Ordering) {
        let middle = middle(&self.lower, &self.upper);
        match self.polynomial.evaluate(&middle).sign() {
            Ordering::Equal => (self.lower, self.upper) = (middle.clone(), middle),
            here if here == sign => self.lower = middle,
            _ => self.upper = middle,
        }
    }
}

/// (a + b) / 2
pub(super) fn middle<F: Field>(lower: &F, upper: &F) -> F {
    let (numerator, denominator) = lower.plus(upper).into_parts();
    F::from_parts(numerator, denominator * 2)
}

/// All real roots in the closed interval [from, to], ascending, in disjoint closed intervals
/// inside it. None are listed for the polynomial 0.
///
/// - **holds** over ℚ a rational root is exact
/// - **cost** a square-free factorisation, then Bernstein coefficients halved until Descartes'
///   rule of signs leaves one change or none
#[must_use]
pub fn real_roots<F: Field>(polynomial: &UniPoly<F>, from: &F, to: &F) -> Vec<RealRoot<F>> {
    if polynomial.is_constant() || from > to {
        return Vec::new();
    }
    if from == to {
        return root_at(polynomial, from).into_iter().collect();
    }
    if !may_vanish(polynomial, from, to) {
        return Vec::new();
    }
    let mut roots = Vec::new();
    for (factor, multiplicity) in square_free(polynomial) {
        roots_of_factor(factor, multiplicity, (from, to), &mut roots);
    }
    separate(&mut roots);
    roots
}

/// The first root of odd multiplicity in the open interval (from, to): there the polynomial
/// changes its sign.
#[must_use]
pub fn sign_change<F: Field>(polynomial: &UniPoly<F>, from: &F, to: &F) -> Option<RealRoot<F>> {
    if from >= to {
        return None;
    }
    let local = polynomial.restrict(from, to);
    let coefficients = scaled_bernstein(local.numerators(), local.degree().unwrap_or(0));
    if sign_changes(&coefficients) == 0 {
        return None;
    }
    real_roots(polynomial, from, to).into_iter().find(|root| {
        let at_end = root.is_exact() && (root.lower == *from || root.lower == *to);
        root.multiplicity % 2 == 1 && !at_end
    })
}

/// Whether the Bernstein coefficients on the interval leave room for a root.
fn may_vanish<F: Field>(polynomial: &UniPoly<F>, from: &F, to: &F) -> bool {
    let local = polynomial.restrict(from, to);
    let Some(degree) = local.degree() else {
        return true;
    };
    let coefficients = scaled_bernstein(local.numerators(), degree);
    let at_end = |own: Option<&F::Ring>| own.is_none_or(Ring::is_zero);
    at_end(coefficients.first()) || at_end(coefficients.last()) || sign_changes(&coefficients) > 0
}

/// The given point with its multiplicity, if it is a root.
fn root_at<F: Field>(polynomial: &UniPoly<F>, at: &F) -> Option<RealRoot<F>> {
    let line = UniPoly::from_coefficients(&[at.negated(), F::one()]);
    let mut rest = polynomial.clone();
    let mut multiplicity = 0;
    while let Some(quotient) = rest.exact_div(&line) {
        multiplicity += 1;
        rest = quotient;
    }
    (multiplicity > 0).then(|| RealRoot::exact(at.clone(), multiplicity))
}

/// The roots of a square-free factor: first those seen to lie in the field, then the rest by
/// isolation; a root that is hit on the way is divided out.
fn roots_of_factor<F: Field>(
    mut factor: UniPoly<F>,
    multiplicity: u32,
    (from, to): (&F, &F),
    roots: &mut Vec<RealRoot<F>>,
) {
    let mut known = roots_in_field(&factor);
    known.extend([from.clone(), to.clone()]);
    let mut pending = known;
    loop {
        for value in pending.drain(..) {
            let line = UniPoly::from_coefficients(&[value.negated(), F::one()]);
            if let Some(quotient) = factor.exact_div(&line) {
                factor = quotient;
                if (from..=to).contains(&&value) {
                    roots.push(RealRoot::exact(value, multiplicity));
                }
            }
        }
        let factor = factor.primitive();
        match isolate(&factor, from, to) {
            Ok(intervals) => {
                roots.extend(intervals.into_iter().map(|(lower, upper)| RealRoot {
                    polynomial: factor.clone(),
                    lower,
                    upper,
                    multiplicity,
                }));
                return;
            }
            Err(hit) => pending.push(hit),
        }
    }
}

/// Open intervals with one root each, for a square-free polynomial without roots at the ends;
/// or the root that a bisection point hit.
///
/// On (k/2ʲ, (k+1)/2ʲ) of the local parameter the Bernstein coefficients have as many changes of
/// sign as there are roots, or an even number more; for a square-free polynomial the surplus
/// vanishes once the pieces are small. (Vincent's theorem)
fn isolate<F: Field>(polynomial: &UniPoly<F>, from: &F, to: &F) -> Result<Vec<(F, F)>, F> {
    let width = to.minus(from);
    let place = |index: &Integer, depth: u32| {
        let local = F::from_parts(F::Ring::from_integer(index), Integer::from(1) << depth);
        from.plus(&width.times(&local))
    };
    let mut intervals = Vec::new();
    let mut pieces = vec![(
        integral_bernstein(polynomial, from, to),
        Integer::from(0),
        0,
    )];
    while let Some((coefficients, index, depth)) = pieces.pop() {
        match sign_changes(&coefficients) {
            0 => {}
            1 => intervals.push((place(&index, depth), place(&(&index + 1), depth))),
            _ => {
                let (left, right) = F::Ring::halves(coefficients);
                let index = index * 2;
                let middle = &index + 1;
                if right.first().is_some_and(Ring::is_zero) {
                    return Err(place(&middle, depth + 1));
                }
                pieces.push((right, middle, depth + 1));
                pieces.push((left, index, depth + 1));
            }
        }
    }
    Ok(intervals)
}

/// The Bernstein coefficients on the interval, times a positive integer that makes them lie in
/// the ring.
fn integral_bernstein<F: Field>(polynomial: &UniPoly<F>, from: &F, to: &F) -> Vec<F::Ring> {
    let local = polynomial.restrict(from, to);
    let degree = local.degree().unwrap_or(0);
    scaled_bernstein(local.numerators(), degree)
        .iter()
        .zip(&integral_scales(degree))
        .map(|(own, scale)| own.scaled(scale))
        .collect()
}

/// The number of changes of sign, zeros left out.
pub(super) fn sign_changes<R: Ring>(values: &[R]) -> usize {
    let mut changes = 0;
    let mut last = Ordering::Equal;
    for value in values {
        let sign = value.sign();
        if sign.is_ne() {
            changes += usize::from(last == sign.reverse());
            last = sign;
        }
    }
    changes
}

/// Sorts roots of pairwise coprime polynomials, and halves intervals until no two meet.
fn separate<F: Field>(roots: &mut [RealRoot<F>]) {
    loop {
        roots.sort_by(|left, right| left.lower.cmp(&right.lower));
        let mut clean = true;
        for index in 1..roots.len() {
            if roots[index - 1].upper >= roots[index].lower {
                roots[index - 1].halve();
                roots[index].halve();
                clean = false;
            }
        }
        if clean {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    fn polynomial(coefficients: &[i64]) -> UniPoly<Rational> {
        let coefficients: Vec<_> = coefficients.iter().copied().map(Rational::from).collect();
        UniPoly::from_coefficients(&coefficients)
    }

    #[test]
    fn halving_is_de_casteljau_at_one_half() {
        let row: Vec<Integer> = [4, -1, 3, 7].map(Integer::from).to_vec();
        let coefficients: Vec<_> = row.iter().cloned().map(Rational::from).collect();
        let half = Rational::new(1.into(), 2.into());
        let (left, right) = super::super::subdivide(&coefficients, &half);
        let scale = Rational::from(8);
        let scaled = |side: Vec<Rational>| {
            side.iter()
                .map(|own| (own * &scale).into_parts().0)
                .collect()
        };
        assert_eq!(Ring::halves(row), (scaled(left), scaled(right)));
    }

    #[test]
    fn rational_roots_are_exact_and_others_isolated() {
        // (3x−1)² x (x²−2) (x−5)
        let product = &polynomial(&[-1, 3]).power(2) * &polynomial(&[0, 1]);
        let product = &(&product * &polynomial(&[-2, 0, 1])) * &polynomial(&[-5, 1]);
        let roots = real_roots(&product, &0.into(), &5.into());
        let exact: Vec<_> = roots.iter().map(RealRoot::is_exact).collect();
        assert_eq!(exact, [true, true, false, true]);
        let multiplicities: Vec<_> = roots.iter().map(RealRoot::multiplicity).collect();
        assert_eq!(multiplicities, [1, 2, 1, 1]);
        assert_eq!(roots[1].lower().to_string(), "1/3");
        let mut root = roots[2].clone();
        root.refine(&Rational::new(1.into(), 1_000_000.into()));
        let two = Rational::from(2);
        assert!(root.lower() * root.lower() < two && two < root.upper() * root.upper());
        assert!(root.width() <= Rational::new(1.into(), 1_000_000.into()));
    }

    #[test]
    fn sign_changes_are_inside_and_of_odd_order() {
        let first = |product: &UniPoly<Rational>| {
            sign_change(product, &0.into(), &1.into()).map(|root| root.lower().to_string())
        };
        let (start, third) = (polynomial(&[0, 1]), polynomial(&[-1, 3]));
        assert_eq!(first(&start), None);
        assert_eq!(first(&third.power(2)), None);
        assert_eq!(first(&(&start * &third.power(3))).as_deref(), Some("1/3"));
        assert_eq!(first(&polynomial(&[])), None);
    }
}
