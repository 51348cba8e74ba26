use std::fmt;

/// The degrees of a bivariate polynomial, u before v. Shown as `(2, 9)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct BiDegree {
    /// Degree in u.
    pub u: usize,
    /// Degree in v.
    pub v: usize,
}

impl BiDegree {
    /// (u, v)
    #[must_use]
    pub fn new(u: usize, v: usize) -> Self {
        Self { u, v }
    }

    /// The componentwise maximum.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self::new(self.u.max(other.u), self.v.max(other.v))
    }

    /// The componentwise sum: the bidegree of a product.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self::new(self.u + other.u, self.v + other.v)
    }

    /// Whether both components are at most the other's.
    #[must_use]
    pub fn fits(self, other: Self) -> bool {
        self.u <= other.u && self.v <= other.v
    }
}

impl fmt::Display for BiDegree {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&format!("({}, {})", self.u, self.v))
    }
}
