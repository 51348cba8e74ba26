use crate::number::Field;

use super::{BiDegree, BiPoly, Quotient, UniPoly, exact_div_bi, gcd, gcd_bi, lcm};

/// A denominator D(u) E(v) M(u, v): factors in u alone, in v alone, and the rest, which has no
/// factor in one variable. The first two are of coprime integers, as [`UniPoly::integral`] has them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Denominator<F: Field> {
    in_u: UniPoly<F>,
    in_v: UniPoly<F>,
    /// None for 1.
    mixed: Option<BiPoly<F>>,
}

impl<F: Field> Denominator<F> {
    /// 1
    #[must_use]
    pub fn one() -> Self {
        Self {
            in_u: UniPoly::one(),
            in_v: UniPoly::one(),
            mixed: None,
        }
    }

    /// D(u) E(v), of coprime integers.
    #[must_use]
    pub fn separable(in_u: &UniPoly<F>, in_v: &UniPoly<F>) -> Self {
        Self {
            in_u: in_u.integral(),
            in_v: in_v.integral(),
            mixed: None,
        }
    }

    /// Splits a polynomial into a constant and a denominator; none for 0.
    #[must_use]
    pub fn split(polynomial: &BiPoly<F>) -> Option<(F, Self)> {
        let (in_u, in_v, rest) = polynomial.split()?;
        let (scale, mixed) = match rest.as_constant() {
            Some(constant) => (constant, None),
            None => {
                let lead = rest.rows().last()?.leading_coefficient();
                let monic = rest.scale(&lead.inverse()?);
                (lead, Some(monic))
            }
        };
        Some((scale, Self { in_u, in_v, mixed }))
    }

    /// D(u)
    #[must_use]
    pub fn in_u(&self) -> &UniPoly<F> {
        &self.in_u
    }

    /// E(v)
    #[must_use]
    pub fn in_v(&self) -> &UniPoly<F> {
        &self.in_v
    }

    /// M(u, v); none for 1.
    #[must_use]
    pub fn mixed(&self) -> Option<&BiPoly<F>> {
        self.mixed.as_ref()
    }

    /// Whether M is 1.
    #[must_use]
    pub fn is_separable(&self) -> bool {
        self.mixed.is_none()
    }

    /// The denominator multiplied out.
    #[must_use]
    pub fn polynomial(&self) -> BiPoly<F> {
        let separable = BiPoly::product(&self.in_u, &self.in_v);
        match &self.mixed {
            None => separable,
            Some(mixed) => &separable * mixed,
        }
    }

    /// The product of two denominators.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        Self {
            in_u: &self.in_u * &other.in_u,
            in_v: &self.in_v * &other.in_v,
            mixed: match (&self.mixed, &other.mixed) {
                (None, own) | (own, None) => own.clone(),
                (Some(own), Some(other)) => Some(own * other),
            },
        }
    }

    /// The nth power.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        Self {
            in_u: self.in_u.power(exponent),
            in_v: self.in_v.power(exponent),
            mixed: powered(self.mixed.as_ref(), exponent),
        }
    }

    /// The least common multiple.
    #[must_use]
    pub fn lcm(&self, other: &Self) -> Self {
        let univariate = |left: &UniPoly<F>, right: &UniPoly<F>| {
            if right.is_one() || left == right {
                left.clone()
            } else if left.is_one() {
                right.clone()
            } else {
                lcm(left, right)
            }
        };
        let mixed = match (&self.mixed, &other.mixed) {
            (None, own) | (own, None) => own.clone(),
            (Some(own), Some(other)) if own == other => Some(own.clone()),
            (Some(own), Some(other)) => {
                let common = gcd_bi(own, other);
                let rest = exact_div_bi(other, &common);
                Some(monic(&(own * &rest.unwrap_or_else(BiPoly::one))))
            }
        };
        Self {
            in_u: univariate(&self.in_u, &other.in_u),
            in_v: univariate(&self.in_v, &other.in_v),
            mixed,
        }
    }

    /// A polynomial times what this denominator must be multiplied by to give one of its multiples.
    fn raise(&self, polynomial: &BiPoly<F>, multiple: &Self) -> BiPoly<F> {
        let divide = |whole: &UniPoly<F>, part: &UniPoly<F>| {
            if whole == part {
                Some(UniPoly::one())
            } else {
                whole.exact_div(part)
            }
        };
        let in_u = divide(&multiple.in_u, &self.in_u).unwrap_or_else(UniPoly::one);
        let in_v = divide(&multiple.in_v, &self.in_v).unwrap_or_else(UniPoly::one);
        let separable = polynomial.times_separable(&in_u, &in_v);
        let mixed = match (&multiple.mixed, &self.mixed) {
            (None, _) => None,
            (Some(whole), None) => Some(whole.clone()),
            (Some(whole), Some(part)) if whole == part => None,
            (Some(whole), Some(part)) => exact_div_bi(whole, part),
        };
        match mixed {
            Some(mixed) => &separable * &mixed,
            None => separable,
        }
    }
}

/// The power of a factor that may be absent.
fn powered<F: Field>(factor: Option<&BiPoly<F>>, exponent: u32) -> Option<BiPoly<F>> {
    factor
        .filter(|_| exponent > 0)
        .map(|own| own.power(exponent))
}

/// The multiple whose leading coefficient, in u and then in v, is 1.
fn monic<F: Field>(polynomial: &BiPoly<F>) -> BiPoly<F> {
    let rows = polynomial.rows();
    let lead = rows.last().map(UniPoly::leading_coefficient);
    match lead.and_then(|lead| lead.inverse()) {
        Some(inverse) => polynomial.scale(&inverse),
        None => BiPoly::zero(),
    }
}

/// A rational function N(u, v) / D of u and v, unreduced until [`Fraction::reduce`] is asked for.
///
/// Products never cancel; sums go over the least common multiple of the denominators; 0 keeps
/// its denominator. So the degrees are those of the formula, not of the function.
#[derive(Clone, Debug)]
pub struct Fraction<F: Field> {
    numerator: BiPoly<F>,
    denominator: Denominator<F>,
}

impl<F: Field> Fraction<F> {
    /// a(u)
    #[must_use]
    pub fn in_u(quotient: &Quotient<F>) -> Self {
        Self::new(
            BiPoly::in_u(quotient.numerator()),
            Denominator {
                in_u: quotient.denominator().clone(),
                ..Denominator::one()
            },
        )
    }

    /// b(v)
    #[must_use]
    pub fn in_v(quotient: &Quotient<F>) -> Self {
        Self::new(
            BiPoly::in_v(quotient.numerator()),
            Denominator {
                in_v: quotient.denominator().clone(),
                ..Denominator::one()
            },
        )
    }

    /// a(u) b(v)
    #[must_use]
    pub fn product(in_u: &Quotient<F>, in_v: &Quotient<F>) -> Self {
        Self::new(
            BiPoly::product(in_u.numerator(), in_v.numerator()),
            Denominator {
                in_u: in_u.denominator().clone(),
                in_v: in_v.denominator().clone(),
                mixed: None,
            },
        )
    }

    /// N / D
    #[must_use]
    pub fn new(numerator: BiPoly<F>, denominator: Denominator<F>) -> Self {
        Self {
            numerator,
            denominator,
        }
    }

    /// N(u, v) / D(u, v), nothing cancelled; none if D is 0.
    #[must_use]
    pub fn quotient(numerator: &BiPoly<F>, denominator: &BiPoly<F>) -> Option<Self> {
        let (scale, denominator) = Denominator::split(denominator)?;
        let numerator = numerator.scale(&scale.inverse()?);
        Some(Self::new(numerator, denominator))
    }

    /// N / 1
    #[must_use]
    pub fn polynomial(numerator: BiPoly<F>) -> Self {
        Self::new(numerator, Denominator::one())
    }

    /// c
    #[must_use]
    pub fn constant(value: &F) -> Self {
        Self::polynomial(BiPoly::constant(value))
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &BiPoly<F> {
        &self.numerator
    }

    /// The denominator.
    #[must_use]
    pub fn denominator(&self) -> &Denominator<F> {
        &self.denominator
    }

    /// Whether the function is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// a + b over the least common multiple of the denominators.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let denominator = self.denominator.lcm(&other.denominator);
        let numerator = &self.numerator_over(&denominator) + &other.numerator_over(&denominator);
        Self::new(numerator, denominator)
    }

    /// a + b + … over the least common multiple of the denominators; 0 for none.
    #[must_use]
    pub fn sum(terms: &[&Self]) -> Self {
        let denominator = terms.iter().fold(Denominator::one(), |common, own| {
            common.lcm(&own.denominator)
        });
        let numerators = terms.iter().map(|own| own.numerator_over(&denominator));
        Self::new(BiPoly::sum(numerators), denominator)
    }

    /// c a
    #[must_use]
    pub fn scale(&self, factor: &F) -> Self {
        Self::new(self.numerator.scale(factor), self.denominator.clone())
    }

    /// −a
    #[must_use]
    pub fn negated(&self) -> Self {
        Self::new(-&self.numerator, self.denominator.clone())
    }

    /// a − b
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// a b
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        Self::new(
            &self.numerator * &other.numerator,
            self.denominator.times(&other.denominator),
        )
    }

    /// a(u, v) b(u) c(v)
    #[must_use]
    pub fn times_separable(&self, in_u: &Quotient<F>, in_v: &Quotient<F>) -> Self {
        let (above, below) = (&self.numerator, &self.denominator);
        Self::new(
            above.times_separable(in_u.numerator(), in_v.numerator()),
            Denominator {
                in_u: &below.in_u * in_u.denominator(),
                in_v: &below.in_v * in_v.denominator(),
                mixed: below.mixed.clone(),
            },
        )
    }

    /// 1 / a; none for 0
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        Self::quotient(&self.denominator.polynomial(), &self.numerator)
    }

    /// aⁿ for n of either sign; none for 0 to a negative power
    #[must_use]
    pub fn power(&self, exponent: i64) -> Option<Self> {
        let base = if exponent < 0 {
            self.inverse()?
        } else {
            self.clone()
        };
        let exponent = u32::try_from(exponent.unsigned_abs()).ok()?;
        Some(Self::new(
            base.numerator.power(exponent),
            base.denominator.power(exponent),
        ))
    }

    /// The numerator when the function is written over a multiple of its denominator.
    #[must_use]
    pub fn numerator_over(&self, multiple: &Denominator<F>) -> BiPoly<F> {
        if self.denominator == *multiple {
            return self.numerator.clone();
        }
        self.denominator.raise(&self.numerator, multiple)
    }

    /// ∂a/∂u = (N′ D − N D′) / D²; a denominator free of u stays as it is.
    #[must_use]
    pub fn derivative_u(&self) -> Self {
        let own = BiPoly::in_u(&self.denominator.in_u);
        let own = match &self.denominator.mixed {
            None => own,
            Some(mixed) => &own * mixed,
        };
        let numerator = self.numerator.derivative_u();
        if own.derivative_u().is_zero() {
            return Self::new(numerator, self.denominator.clone());
        }
        let numerator = &(&numerator * &own) - &(&self.numerator * &own.derivative_u());
        let squared = Denominator {
            in_u: self.denominator.in_u.power(2),
            in_v: self.denominator.in_v.clone(),
            mixed: powered(self.denominator.mixed.as_ref(), 2),
        };
        Self::new(numerator, squared)
    }

    /// ∂a/∂v
    #[must_use]
    pub fn derivative_v(&self) -> Self {
        self.transpose().derivative_u().transpose()
    }

    /// a(v, u)
    #[must_use]
    pub fn transpose(&self) -> Self {
        let Denominator { in_u, in_v, mixed } = self.denominator.clone();
        let (in_u, in_v) = (in_v, in_u);
        let numerator = self.numerator.transpose();
        let mixed = mixed.map(|own| own.transpose());
        let rows = mixed.as_ref().map(BiPoly::rows).unwrap_or_default();
        let lead = rows.last().map(UniPoly::leading_coefficient);
        match lead.and_then(|lead| lead.inverse()) {
            Some(inverse) => Self::new(
                numerator.scale(&inverse),
                Denominator {
                    in_u,
                    in_v,
                    mixed: mixed.map(|own| own.scale(&inverse)),
                },
            ),
            None => Self::new(numerator, Denominator { in_u, in_v, mixed }),
        }
    }

    /// The value at a point; none at a zero of the denominator as it stands.
    #[must_use]
    pub fn evaluate(&self, u: &F, v: &F) -> Option<F> {
        let denominator = self.denominator.in_u.evaluate(u);
        let denominator = denominator.times(&self.denominator.in_v.evaluate(v));
        let denominator = match &self.denominator.mixed {
            None => denominator,
            Some(mixed) => denominator.times(&mixed.evaluate(u, v)),
        };
        Some(self.numerator.evaluate(u, v).times(&denominator.inverse()?))
    }

    /// The same function in lowest terms.
    #[must_use]
    pub fn reduce(&self) -> Self {
        if self.numerator.is_zero() {
            return Self::polynomial(BiPoly::zero());
        }
        let mut numerator = self.numerator.clone();
        let mut denominator = self.denominator.clone();
        let in_u = shared(&denominator.in_u, || numerator.content_u());
        numerator = numerator.exact_div_u(&in_u).unwrap_or(numerator);
        denominator.in_u = denominator
            .in_u
            .exact_div(&in_u)
            .unwrap_or(denominator.in_u);
        let in_v = shared(&denominator.in_v, || numerator.content_v());
        numerator = numerator.exact_div_v(&in_v).unwrap_or(numerator);
        denominator.in_v = denominator
            .in_v
            .exact_div(&in_v)
            .unwrap_or(denominator.in_v);
        if let Some(mixed) = &denominator.mixed {
            let common = gcd_bi(&numerator, mixed);
            let divided = exact_div_bi(mixed, &common);
            if let (Some(top), Some(bottom)) = (exact_div_bi(&numerator, &common), divided) {
                let normal = monic(&bottom);
                let lead = bottom.rows().last().map(UniPoly::leading_coefficient);
                let scale = lead.and_then(|lead| lead.inverse()).unwrap_or_else(F::one);
                numerator = top.scale(&scale);
                denominator.mixed = normal.as_constant().is_none().then_some(normal);
            }
        }
        Self::new(numerator, denominator)
    }

    /// The number that the function is; none if it depends on u or v.
    #[must_use]
    pub fn as_constant(&self) -> Option<F> {
        let reduced = self.reduce();
        let denominator = reduced.denominator.polynomial().as_constant()?;
        Some(
            reduced
                .numerator
                .as_constant()?
                .times(&denominator.inverse()?),
        )
    }

    /// a(φ, ψ) for rational functions φ, ψ; none if the denominator becomes 0.
    ///
    /// Numerator and denominator are each written as forms in the parts of φ and ψ, and only the
    /// surplus powers of a denominator stay on the other side.
    #[must_use]
    pub fn compose(&self, u: &Self, v: &Self) -> Option<Self> {
        let bottom = self.denominator.polynomial();
        let own = self.numerator.bidegree().unwrap_or_default();
        let other = bottom.bidegree()?;
        let high = own.max(other);
        let (bu, bv) = (u.denominator.polynomial(), v.denominator.polynomial());
        let raise = |polynomial: &BiPoly<F>, own: BiDegree| {
            let in_u = bu.power(u32::try_from(high.u - own.u).unwrap_or_default());
            let in_v = bv.power(u32::try_from(high.v - own.v).unwrap_or_default());
            &(polynomial * &in_u) * &in_v
        };
        let numerator = raise(&substitute(&self.numerator, u, v, own), own);
        Self::quotient(&numerator, &raise(&substitute(&bottom, u, v, other), other))
    }
}

/// The common factor of a univariate denominator and a content that is costly to find.
fn shared<F: Field>(denominator: &UniPoly<F>, content: impl FnOnce() -> UniPoly<F>) -> UniPoly<F> {
    if denominator.is_constant() {
        UniPoly::one()
    } else {
        gcd(denominator, &content())
    }
}

/// b₁ⁿ b₂ᵐ p(a₁/b₁, a₂/b₂) where (n, m) is the bidegree of p.
fn substitute<F: Field>(
    polynomial: &BiPoly<F>,
    u: &Fraction<F>,
    v: &Fraction<F>,
    degree: BiDegree,
) -> BiPoly<F> {
    let mut sum = BiPoly::zero();
    for (in_u, in_v) in polynomial.terms() {
        sum = &sum + &(&form(in_u, u, degree.u) * &form(in_v, v, degree.v));
    }
    sum
}

/// bⁿ f(a/b), the form of degree n of a polynomial f in the two parts of a fraction.
fn form<F: Field>(polynomial: &UniPoly<F>, at: &Fraction<F>, degree: usize) -> BiPoly<F> {
    let bottom = at.denominator.polynomial();
    let mut value = BiPoly::zero();
    let mut power = BiPoly::one();
    for index in (0..=degree).rev() {
        let coefficient = polynomial.coefficient(index);
        value = &(&value * &at.numerator) + &power.scale(&coefficient);
        power = &power * &bottom;
    }
    value
}
