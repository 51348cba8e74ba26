use crate::number::{Complex, Real, RootFault, Tower};
use crate::poly::{UniPoly, bernstein, gcd, real_roots};

use std::cell::OnceCell;

use super::Interval;

/// The preimage of a plane Pythagorean hodograph: r′ = g ω², ω = a + ib, with a complex constant g
/// taken out so that a and b have coefficients in a small field.   [farouki-nittler, eq. 2]
///
/// - **shape** deg ω = m gives a curve of degree 2m + 1
#[derive(Debug, Clone)]
pub struct Preimage {
    factor: Complex,
    real: UniPoly<Real>,
    imaginary: UniPoly<Real>,
    /// a² − b², 2ab and a² + b², once they are asked for.
    squares: OnceCell<[UniPoly<Real>; 3]>,
}

impl PartialEq for Preimage {
    fn eq(&self, other: &Self) -> bool {
        self.factor == other.factor && self.parts() == other.parts()
    }
}

impl Eq for Preimage {}

impl Preimage {
    /// g (a + ib)²
    #[must_use]
    pub fn new(factor: Complex, real: UniPoly<Real>, imaginary: UniPoly<Real>) -> Self {
        Self {
            factor,
            real,
            imaginary,
            squares: OnceCell::new(),
        }
    }

    /// (Re ω², Im ω², |ω|²)
    fn squares(&self) -> &[UniPoly<Real>; 3] {
        let find = || UniPoly::complex_squares(&self.real, &self.imaginary);
        self.squares.get_or_init(find)
    }

    /// g
    #[must_use]
    pub fn factor(&self) -> &Complex {
        &self.factor
    }

    /// a and b
    #[must_use]
    pub fn parts(&self) -> [&UniPoly<Real>; 2] {
        [&self.real, &self.imaginary]
    }

    /// (x′, y′): real and imaginary part of g ω².
    #[must_use]
    pub fn hodograph(&self) -> [UniPoly<Real>; 2] {
        let [square, cross, _] = self.squares();
        let (g, h) = (&self.factor.real, &self.factor.imaginary);
        [
            &square.scale(g) - &cross.scale(h),
            &square.scale(h) + &cross.scale(g),
        ]
    }

    /// Whether the curve does not move.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.factor.is_zero() || (self.real.is_zero() && self.imaginary.is_zero())
    }

    /// |ω|²
    #[must_use]
    pub fn norm(&self) -> UniPoly<Real> {
        let [.., norm] = self.squares();
        norm.clone()
    }

    /// σ = |g| |ω|²; the field grows if it does not hold |g|.   [farouki-nittler, eq. 3]
    ///
    /// # Errors
    ///
    /// A field of too large a degree.
    pub fn speed(&self, tower: &Tower) -> Result<UniPoly<Real>, RootFault> {
        Ok(self.norm().scale(&self.factor.modulus(tower)?))
    }

    /// Im(ω̄ ω′) = a b′ − a′ b: half the rate at which the tangent turns is this over |ω|².
    ///
    /// κ = 2 Im(ω̄ω′) / (|g| |ω|⁴).   [farouki-nittler, eq. 5]
    #[must_use]
    pub fn turning(&self) -> UniPoly<Real> {
        let (a, b) = (&self.real, &self.imaginary);
        UniPoly::sum_of_products(&[(1, a, &b.derivative()), (-1, &a.derivative(), b)])
    }

    /// The same directions without the real factors of ω, whose squares do not turn the tangent.
    #[must_use]
    pub fn primitive(&self) -> Self {
        let common = gcd(&self.real, &self.imaginary);
        let divide = |own: &UniPoly<Real>| own.exact_div(&common).unwrap_or_else(|| own.clone());
        Self::new(
            self.factor.clone(),
            divide(&self.real),
            divide(&self.imaginary),
        )
    }

    /// The same directions on [0, 1], ω scaled by a power of two so that the largest Bernstein
    /// coefficient of its parts is about 1; and that power: ω = 2ᵏ ω̂.
    #[must_use]
    pub fn normalised(&self, domain: &Interval) -> (Self, i64) {
        let parts = self
            .parts()
            .map(|own| own.restrict(domain.start(), domain.end()));
        let exponent = parts.iter().filter_map(magnitude).max().unwrap_or(0);
        let [real, imaginary] = parts.map(|own| own.scale(&Real::power_of_two(-exponent)));
        (Self::new(self.factor.clone(), real, imaginary), exponent)
    }

    /// Whether ω vanishes on the domain: the curve has a cusp there.
    #[must_use]
    pub fn has_cusp(&self, domain: &Interval) -> bool {
        let common = gcd(&self.real, &self.imaginary);
        !common.is_constant() && !real_roots(&common, domain.start(), domain.end()).is_empty()
    }
}

/// The binary exponent of the largest Bernstein coefficient on [0, 1]; none for 0.
pub(super) fn magnitude(polynomial: &UniPoly<Real>) -> Option<i64> {
    let degree = polynomial.degree()?;
    let coefficients = bernstein(polynomial, degree, &Real::from(0), &Real::from(1));
    coefficients.iter().filter_map(Real::binade).max()
}
