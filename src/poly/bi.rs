use std::cell::OnceCell;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use crate::number::{Field, Integer, LeadingWord, Ring, lcm};

use super::{BiDegree, UniPoly, gcd_all};

/// A polynomial in u and v, held as a sum of products Σ fₖ(u) gₖ(v).
///
/// Swept surfaces are such sums with two or three terms, whatever their degree; a dense
/// polynomial is the case fₖ = uᵏ. Every fₖ is primitive, so proportional factors are equal and
/// their terms are merged; the sum never has more terms than the dense form. The same polynomial
/// has many such forms: equality compares the coefficients.
#[derive(Clone, Debug)]
pub struct BiPoly<F: Field> {
    terms: Vec<(UniPoly<F>, UniPoly<F>)>,
    /// Is found when it is asked for, and then kept.
    bidegree: OnceCell<Option<BiDegree>>,
}

impl<F: Field> BiPoly<F> {
    /// 0
    #[must_use]
    pub fn zero() -> Self {
        Self {
            terms: Vec::new(),
            bidegree: OnceCell::new(),
        }
    }

    /// 1
    #[must_use]
    pub fn one() -> Self {
        Self::constant(&F::one())
    }

    /// The constant polynomial c.
    #[must_use]
    pub fn constant(value: &F) -> Self {
        Self::in_v(&UniPoly::constant(value))
    }

    /// f(u)
    #[must_use]
    pub fn in_u(factor: &UniPoly<F>) -> Self {
        Self::product(factor, &UniPoly::one())
    }

    /// g(v)
    #[must_use]
    pub fn in_v(factor: &UniPoly<F>) -> Self {
        let mut polynomial = Self::zero();
        if !factor.is_zero() {
            polynomial.terms = vec![(UniPoly::one(), factor.clone())];
        }
        polynomial
    }

    /// f(u) g(v)
    #[must_use]
    pub fn product(in_u: &UniPoly<F>, in_v: &UniPoly<F>) -> Self {
        if in_u.is_zero() || in_v.is_zero() {
            return Self::zero();
        }
        let (factor, primitive) = in_u.split();
        Self {
            terms: vec![(primitive, in_v.scale(&factor))],
            bidegree: OnceCell::new(),
        }
    }

    /// Σ uⁱ rᵢ(v)
    #[must_use]
    pub fn from_rows(rows: &[UniPoly<F>]) -> Self {
        let mut polynomial = Self::zero();
        for (power, row) in rows.iter().enumerate().filter(|(_, row)| !row.is_zero()) {
            let monomial = UniPoly::one().shift(power);
            polynomial.terms.push((monomial, row.clone()));
        }
        polynomial
    }

    /// Σ cⱼ(u) vʲ
    #[must_use]
    pub fn from_columns(columns: &[UniPoly<F>]) -> Self {
        Self::from_rows(columns).transpose()
    }

    /// p(v, u)
    #[must_use]
    pub fn transpose(&self) -> Self {
        let mut polynomial = Self::zero();
        for (in_u, in_v) in &self.terms {
            polynomial.add_term(in_v, in_u);
        }
        polynomial
    }

    /// The terms fₖ(u), gₖ(v) of this form of the polynomial.
    #[must_use]
    pub fn terms(&self) -> &[(UniPoly<F>, UniPoly<F>)] {
        &self.terms
    }

    /// The coefficients of 1, u, u², … as polynomials in v; the last is not 0.
    #[must_use]
    pub fn rows(&self) -> Vec<UniPoly<F>> {
        dense(self.terms.iter().map(|(in_u, in_v)| (in_u, in_v)))
    }

    /// The coefficients of 1, v, v², … as polynomials in u; the last is not 0.
    #[must_use]
    pub fn columns(&self) -> Vec<UniPoly<F>> {
        dense(self.terms.iter().map(|(in_u, in_v)| (in_v, in_u)))
    }

    /// Whether it is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        match self.terms.len() {
            0 => true,
            // Different primitive factors are linearly independent.
            1 | 2 => false,
            _ => self.rows().is_empty(),
        }
    }

    /// The exact bidegree; none for 0.
    #[must_use]
    pub fn bidegree(&self) -> Option<BiDegree> {
        *self.bidegree.get_or_init(|| self.find_bidegree())
    }

    fn find_bidegree(&self) -> Option<BiDegree> {
        if self.is_zero() {
            return None;
        }
        let along = |(in_u, in_v): &(UniPoly<F>, UniPoly<F>)| {
            Some(BiDegree::new(in_u.degree()?, in_v.degree()?))
        };
        let bound = self.terms.iter().filter_map(along).reduce(BiDegree::max)?;
        let corner = self.terms.iter().filter(|own| along(own) == Some(bound));
        if has_corner(corner.map(|(in_u, in_v)| (in_u, in_v))) {
            return Some(bound);
        }
        let in_u = top_degree(self.terms.iter().map(|(in_u, in_v)| (in_u, in_v)));
        let in_v = top_degree(self.terms.iter().map(|(in_u, in_v)| (in_v, in_u)));
        if let (Some(u), Some(v)) = (in_u, in_v) {
            return Some(BiDegree::new(u, v));
        }
        let rows = self.rows();
        let in_v = rows.iter().filter_map(UniPoly::degree).max()?;
        Some(BiDegree::new(rows.len() - 1, in_v))
    }

    /// The constant that it is; none if it depends on u or v.
    #[must_use]
    pub fn as_constant(&self) -> Option<F> {
        match self.bidegree() {
            None => Some(F::zero()),
            Some(BiDegree { u: 0, v: 0 }) => Some(self.evaluate(&F::zero(), &F::zero())),
            Some(_) => None,
        }
    }

    /// p(u, v) at a point.
    #[must_use]
    pub fn evaluate(&self, u: &F, v: &F) -> F {
        self.terms.iter().fold(F::zero(), |sum, (in_u, in_v)| {
            sum.plus(&in_u.evaluate(u).times(&in_v.evaluate(v)))
        })
    }

    /// p(a, v) as a polynomial in v.
    #[must_use]
    pub fn at_u(&self, at: &F) -> UniPoly<F> {
        self.terms
            .iter()
            .fold(UniPoly::zero(), |sum, (in_u, in_v)| {
                &sum + &in_v.scale(&in_u.evaluate(at))
            })
    }

    /// p(u, b) as a polynomial in u.
    #[must_use]
    pub fn at_v(&self, at: &F) -> UniPoly<F> {
        self.terms
            .iter()
            .fold(UniPoly::zero(), |sum, (in_u, in_v)| {
                &sum + &in_u.scale(&in_v.evaluate(at))
            })
    }

    /// ∂p/∂u
    #[must_use]
    pub fn derivative_u(&self) -> Self {
        self.map(|in_u, in_v| (in_u.derivative(), in_v.clone()))
    }

    /// ∂p/∂v
    #[must_use]
    pub fn derivative_v(&self) -> Self {
        let mut polynomial = Self::zero();
        for (in_u, in_v) in &self.terms {
            let slope = in_v.derivative();
            if !slope.is_zero() {
                polynomial.add_primitive_term(in_u.clone(), slope);
            }
        }
        polynomial
    }

    /// c p
    #[must_use]
    pub fn scale(&self, factor: &F) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        let terms = self.terms.iter();
        Self {
            terms: terms
                .map(|(in_u, in_v)| (in_u.clone(), in_v.scale(factor)))
                .collect(),
            bidegree: self.bidegree.clone(),
        }
    }

    /// pⁿ
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        if let [(in_u, in_v)] = self.terms.as_slice() {
            return Self::product(&in_u.power(exponent), &in_v.power(exponent));
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

    /// d(u) e(v) p
    #[must_use]
    pub fn times_separable(&self, in_u: &UniPoly<F>, in_v: &UniPoly<F>) -> Self {
        let ones = [in_u, in_v].map(UniPoly::is_one);
        if ones == [true, true] {
            return self.clone();
        }
        if in_u.is_zero() || in_v.is_zero() {
            return Self::zero();
        }
        let times = |own: &UniPoly<F>, factor: &UniPoly<F>, is_one: bool| {
            if is_one { own.clone() } else { own * factor }
        };
        let mut product = Self::zero();
        product.terms.reserve_exact(self.terms.len());
        for (own_u, own_v) in &self.terms {
            let v = times(own_v, in_v, ones[1]);
            if ones[0] {
                product.add_primitive_term(own_u.clone(), v);
            } else {
                product.add_term(&times(own_u, in_u, false), &v);
            }
        }
        product
    }

    /// p + q + …
    #[must_use]
    pub fn sum(terms: impl IntoIterator<Item = Self>) -> Self {
        let mut terms = terms.into_iter();
        let mut sum = terms.next().unwrap_or_else(Self::zero);
        for (in_u, in_v) in terms.flat_map(|own| own.terms) {
            sum.add_primitive_term(in_u, in_v);
        }
        sum.limit_terms()
    }

    /// The greatest common divisor of the coefficients as polynomials in u, primitive: the
    /// largest factor in u alone. 0 for 0.
    #[must_use]
    pub fn content_u(&self) -> UniPoly<F> {
        match self.terms.as_slice() {
            [(in_u, _)] => in_u.clone(),
            _ => gcd_all(&self.parts_u()),
        }
    }

    /// The largest factor in v alone, primitive. 0 for 0.
    #[must_use]
    pub fn content_v(&self) -> UniPoly<F> {
        match self.terms.as_slice() {
            [(_, in_v)] => in_v.primitive(),
            _ => gcd_all(&self.parts_v()),
        }
    }

    /// p / d(u) if d divides.
    #[must_use]
    pub fn exact_div_u(&self, divisor: &UniPoly<F>) -> Option<Self> {
        if divisor.is_constant() {
            return Some(self.scale(&divisor.leading_coefficient().inverse()?));
        }
        let termwise: Option<Vec<_>> = self
            .terms
            .iter()
            .map(|(in_u, _)| in_u.exact_div(divisor))
            .collect();
        if let Some(quotients) = termwise {
            let mut polynomial = Self::zero();
            for (in_u, (_, in_v)) in quotients.iter().zip(&self.terms) {
                polynomial.add_term(in_u, in_v);
            }
            return Some(polynomial);
        }
        let columns: Option<Vec<_>> = self
            .columns()
            .iter()
            .map(|column| column.exact_div(divisor))
            .collect();
        Some(Self::from_columns(&columns?))
    }

    /// p / d(v) if d divides.
    #[must_use]
    pub fn exact_div_v(&self, divisor: &UniPoly<F>) -> Option<Self> {
        if divisor.is_constant() {
            return Some(self.scale(&divisor.leading_coefficient().inverse()?));
        }
        let termwise = self.terms.iter().map(|(_, in_v)| in_v.exact_div(divisor));
        if let Some(quotients) = termwise.collect::<Option<Vec<_>>>() {
            let mut polynomial = Self::zero();
            for ((in_u, _), in_v) in self.terms.iter().zip(quotients) {
                polynomial.add_primitive_term(in_u.clone(), in_v);
            }
            return Some(polynomial);
        }
        let rows = self.rows();
        let rows: Option<Vec<_>> = rows.iter().map(|row| row.exact_div(divisor)).collect();
        // Proportional rows become one term.
        Some(Self::from_rows(&rows?).transpose().transpose())
    }

    /// Adds f(u) g(v), merging it with a term that shares a factor.
    fn add_term(&mut self, in_u: &UniPoly<F>, in_v: &UniPoly<F>) {
        if in_u.is_zero() || in_v.is_zero() {
            return;
        }
        let (factor, primitive) = in_u.split();
        self.add_primitive_term(primitive, in_v.scale(&factor));
    }

    /// Adds f(u) g(v) with a primitive f and g ≠ 0.
    fn add_primitive_term(&mut self, primitive: UniPoly<F>, in_v: UniPoly<F>) {
        self.bidegree = OnceCell::new();
        if let Some(index) = self.terms.iter().position(|(own, _)| *own == primitive) {
            self.terms[index].1 = &self.terms[index].1 + &in_v;
            if self.terms[index].1.is_zero() {
                self.terms.swap_remove(index);
            }
            return;
        }
        if let Some(index) = self.terms.iter().position(|(_, own)| *own == in_v) {
            let (own, in_v) = self.terms.swap_remove(index);
            return self.add_term(&(&own + &primitive), &in_v);
        }
        self.terms.push((primitive, in_v));
    }

    /// Adds the product of two terms. Primitive polynomials over the integers have primitive
    /// products.   (Gauss's lemma)
    fn add_product_term(
        &mut self,
        left: &(UniPoly<F>, UniPoly<F>),
        right: &(UniPoly<F>, UniPoly<F>),
    ) {
        let (in_u, in_v) = (&left.0 * &right.0, &left.1 * &right.1);
        if left.0.is_rational() && right.0.is_rational() {
            self.add_primitive_term(in_u, in_v);
        } else {
            self.add_term(&in_u, &in_v);
        }
    }

    /// Falls back to the dense form once that has fewer terms.
    fn limit_terms(self) -> Self {
        if self.terms.len() <= 3 {
            return self;
        }
        let in_u = self.terms.iter().filter_map(|(own, _)| own.degree()).max();
        let in_v = self.terms.iter().filter_map(|(_, own)| own.degree()).max();
        let (in_u, in_v) = (in_u.unwrap_or(0), in_v.unwrap_or(0));
        if self.terms.len() <= in_u.min(in_v) + 1 {
            return self;
        }
        if in_u <= in_v {
            Self::from_rows(&self.rows())
        } else {
            Self::from_columns(&self.columns())
        }
    }

    fn map(&self, change: impl Fn(&UniPoly<F>, &UniPoly<F>) -> (UniPoly<F>, UniPoly<F>)) -> Self {
        let mut polynomial = Self::zero();
        for (in_u, in_v) in &self.terms {
            let (in_u, in_v) = change(in_u, in_v);
            polynomial.add_term(&in_u, &in_v);
        }
        polynomial
    }
}

/// The degree in x of Σ f(x) g(y), unless leading terms cancel.
///
/// The coefficient of the highest power of x among the f is Σ lc(f) g over those that have it.
fn top_degree<'a, F: Field>(
    terms: impl Iterator<Item = (&'a UniPoly<F>, &'a UniPoly<F>)> + Clone,
) -> Option<usize> {
    let high = terms.clone().filter_map(|(own, _)| own.degree()).max()?;
    let leading = terms.filter(|(own, _)| own.degree() == Some(high));
    if leading.clone().nth(1).is_none() {
        return Some(high);
    }
    let leading: Vec<_> = leading.collect();
    // Its own highest coefficient is mostly enough.
    let across = leading.iter().filter_map(|(_, other)| other.degree()).max();
    let highest = leading
        .iter()
        .copied()
        .filter(|(_, other)| other.degree() == across);
    if has_corner(highest.clone()) {
        return Some(high);
    }
    let lead = |(own, other): (&UniPoly<F>, &UniPoly<F>)| {
        own.leading_coefficient()
            .times(&other.leading_coefficient())
    };
    let corner = highest.map(lead).reduce(|sum, own| sum.plus(&own))?;
    if !corner.is_zero() {
        return Some(high);
    }
    let scaled = leading
        .iter()
        .map(|(own, other)| other.scale(&own.leading_coefficient()));
    let scaled: Vec<_> = scaled.collect();
    let sum = UniPoly::sum(scaled.iter());
    (!sum.is_zero()).then_some(high)
}

/// Whether signs or leading digits prove that Σ lc(f) lc(g) is not 0.
fn has_corner<'a, F: Field>(
    mut terms: impl Iterator<Item = (&'a UniPoly<F>, &'a UniPoly<F>)> + Clone,
) -> bool {
    let all = terms.clone();
    let sign = |(own, other): (&UniPoly<F>, &UniPoly<F>)| {
        let [own, other] = [own, other].map(|own| own.leading_numerator().map(|own| own.sign()));
        own == other
    };
    match (terms.next(), terms.next()) {
        (None, _) => return false,
        (Some(_), None) => return true,
        (Some(first), Some(second)) => {
            let first = sign(first);
            if first == sign(second) && terms.all(|own| first == sign(own)) {
                return true;
            }
        }
    }
    let quotient = |own: &UniPoly<F>| {
        let above = LeadingWord::of_element(&*own.leading_numerator()?)?;
        if own.denominator().is_one() {
            return Some(above);
        }
        above.times(LeadingWord::of_integer(own.denominator()).inverse()?)
    };
    let mut products = all.map(|(own, other)| quotient(own)?.times(quotient(other)?));
    let sum = products.try_fold(LeadingWord::ZERO, |sum, own| sum.plus(own?));
    sum.is_some_and(|own| own != LeadingWord::ZERO)
}

/// The coefficients of 1, x, x², … of Σ f(x) g(y), as polynomials in y; the last is not 0.
fn dense<'a, F: Field>(
    terms: impl Iterator<Item = (&'a UniPoly<F>, &'a UniPoly<F>)> + Clone,
) -> Vec<UniPoly<F>> {
    let denominator =
        |(outer, inner): (&UniPoly<F>, &UniPoly<F>)| outer.denominator() * inner.denominator();
    let denominators = terms.clone().map(denominator);
    let common = denominators.fold(Integer::one(), |common, own| lcm(&common, &own));
    let length = |own: &UniPoly<F>| own.numerators().len();
    let height = terms.clone().map(|(outer, _)| length(outer)).max();
    let width = terms.clone().map(|(_, inner)| length(inner)).max();
    let mut rows = vec![vec![F::Ring::zero(); width.unwrap_or(0)]; height.unwrap_or(0)];
    for (outer, inner) in terms {
        let factor = &common / denominator((outer, inner));
        let inner = inner.numerators().iter();
        let inner: Vec<_> = inner.map(|own| own.scaled(&factor)).collect();
        for (row, left) in rows.iter_mut().zip(outer.numerators()) {
            if !left.is_zero() {
                for (sum, right) in row.iter_mut().zip(&inner) {
                    sum.add_product(left, right);
                }
            }
        }
    }
    let rows = rows.into_iter();
    let mut rows: Vec<_> = rows
        .map(|row| UniPoly::from_numerators(row, common.clone()))
        .collect();
    while rows.last().is_some_and(UniPoly::is_zero) {
        rows.pop();
    }
    rows
}

/// By descending powers of u: `(v^2 + 1) u^2 + v`.
impl<F: Field> fmt::Display for BiPoly<F> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = self.rows();
        let mut parts = Vec::new();
        for (power, row) in rows
            .iter()
            .enumerate()
            .rev()
            .filter(|(_, row)| !row.is_zero())
        {
            let monomial = UniPoly::<F>::one().shift(power).display("u");
            parts.push(match row.display("v").as_str() {
                text if power == 0 => text.to_owned(),
                "1" => monomial,
                "-1" => format!("-{monomial}"),
                text if row.is_constant() && !text.contains(' ') => format!("{text} {monomial}"),
                text => format!("({text}) {monomial}"),
            });
        }
        let text = parts.join(" + ").replace("+ -", "- ");
        formatter.write_str(if parts.is_empty() { "0" } else { &text })
    }
}

impl<F: Field> PartialEq for BiPoly<F> {
    fn eq(&self, other: &Self) -> bool {
        self.rows() == other.rows()
    }
}

impl<F: Field> Eq for BiPoly<F> {}

impl<F: Field> Add for &BiPoly<F> {
    type Output = BiPoly<F>;
    fn add(self, other: Self) -> BiPoly<F> {
        let mut sum = self.clone();
        for (in_u, in_v) in &other.terms {
            sum.add_primitive_term(in_u.clone(), in_v.clone());
        }
        sum.limit_terms()
    }
}

impl<F: Field> Sub for &BiPoly<F> {
    type Output = BiPoly<F>;
    fn sub(self, other: Self) -> BiPoly<F> {
        self + &-other
    }
}

impl<F: Field> Neg for &BiPoly<F> {
    type Output = BiPoly<F>;
    fn neg(self) -> BiPoly<F> {
        let terms = self.terms.iter();
        BiPoly {
            terms: terms.map(|(in_u, in_v)| (in_u.clone(), -in_v)).collect(),
            bidegree: self.bidegree.clone(),
        }
    }
}

impl<F: Field> Mul for &BiPoly<F> {
    type Output = BiPoly<F>;
    fn mul(self, other: Self) -> BiPoly<F> {
        let mut product = BiPoly::zero();
        for left in &self.terms {
            for right in &other.terms {
                product.add_product_term(left, right);
            }
        }
        product.limit_terms()
    }
}
