use super::{Enclosure, Field, Real, RootFault, Tower};

/// A complex number a + ib with real and imaginary part in the field.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complex {
    /// a
    pub real: Real,
    /// b
    pub imaginary: Real,
}

impl Complex {
    /// a + ib
    #[must_use]
    pub fn new(real: Real, imaginary: Real) -> Self {
        Self { real, imaginary }
    }

    /// A real number.
    #[must_use]
    pub fn of_real(real: Real) -> Self {
        Self::new(real, Real::zero())
    }

    /// 0
    #[must_use]
    pub fn zero() -> Self {
        Self::of_real(Real::zero())
    }

    /// 1
    #[must_use]
    pub fn one() -> Self {
        Self::of_real(Real::one())
    }

    /// Whether it is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.real.is_zero() && self.imaginary.is_zero()
    }

    /// z + w
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self::new(&self.real + &other.real, &self.imaginary + &other.imaginary)
    }

    /// z − w
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// −z
    #[must_use]
    pub fn negated(&self) -> Self {
        Self::new(-&self.real, -&self.imaginary)
    }

    /// a − ib
    #[must_use]
    pub fn conjugate(&self) -> Self {
        Self::new(self.real.clone(), -&self.imaginary)
    }

    /// z w
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let (a, b, c, d) = (&self.real, &self.imaginary, &other.real, &other.imaginary);
        Self::new(&(a * c) - &(b * d), &(a * d) + &(b * c))
    }

    /// z x for a real number x
    #[must_use]
    pub fn scale(&self, factor: &Real) -> Self {
        Self::new(&self.real * factor, &self.imaginary * factor)
    }

    /// |z|²
    #[must_use]
    pub fn norm(&self) -> Real {
        &(&self.real * &self.real) + &(&self.imaginary * &self.imaginary)
    }

    /// 1 / z; none for 0
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        Some(self.conjugate().scale(&self.norm().inverse()?))
    }

    /// |z|; the field grows if it does not hold it.
    ///
    /// # Errors
    ///
    /// A field of too large a degree.
    pub fn modulus(&self, tower: &Tower) -> Result<Real, RootFault> {
        if self.imaginary.is_zero() {
            return Ok(self.real.absolute());
        }
        tower.square_root(&self.norm())
    }

    /// Whether it is the principal one of its two square roots' values ±z: of positive real
    /// part, or imaginary with a positive imaginary part. 0 is.
    #[must_use]
    pub fn is_principal(&self) -> bool {
        match self.real.sign() {
            std::cmp::Ordering::Equal => self.imaginary.sign().is_ge(),
            sign => sign.is_gt(),
        }
    }

    /// The principal square root. The field grows by nothing but its real and imaginary part.
    ///
    /// √(p + iq) = α + i q/2α with α = √((|z| + p)/2).
    ///
    /// # Errors
    ///
    /// A field of too large a degree.
    pub fn square_root(&self, tower: &Tower) -> Result<Self, RootFault> {
        if self.imaginary.is_zero() {
            let root = tower.square_root(&self.real.absolute())?;
            return Ok(if self.real.sign().is_lt() {
                Self::new(Real::zero(), root)
            } else {
                Self::of_real(root)
            });
        }
        let two = Real::from(2);
        let square = &(&self.modulus(tower)? + &self.real) / &two;
        let real = tower.square_root(&square)?;
        let imaginary = &self.imaginary / &(&real * &two);
        Ok(Self::new(real, imaginary))
    }

    /// Intervals around real and imaginary part.
    #[must_use]
    pub fn enclose(&self, precision: u32) -> [Enclosure; 2] {
        [&self.real, &self.imaginary].map(|own| own.enclose(precision))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_roots_square_to_their_radicands() {
        for (real, imaginary, degree) in [(3, 4, 1), (0, 2, 1), (-9, 0, 1), (1, -1, 4), (-2, 1, 4)]
        {
            let tower = Tower::default();
            let radicand = Complex::new(real.into(), imaginary.into());
            let root = radicand.square_root(&tower);
            assert!(root.is_ok_and(|root| root.times(&root) == radicand && root.is_principal()));
            assert_eq!(tower.degree(), degree, "{radicand:?}");
        }
    }
}
