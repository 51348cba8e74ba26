use std::fmt;

use crate::number::{Field, Real};

/// A closed parameter interval [start, end] with start < end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interval {
    start: Real,
    end: Real,
}

impl Interval {
    /// [start, end]; none if it is empty or a point.
    #[must_use]
    pub fn new(start: Real, end: Real) -> Option<Self> {
        (start < end).then_some(Self { start, end })
    }

    /// [0, 1]
    #[must_use]
    pub fn unit() -> Self {
        Self {
            start: Real::zero(),
            end: Real::one(),
        }
    }

    /// The lower end.
    #[must_use]
    pub fn start(&self) -> &Real {
        &self.start
    }

    /// The upper end.
    #[must_use]
    pub fn end(&self) -> &Real {
        &self.end
    }

    /// start + (end − start) k / n
    #[must_use]
    pub fn fraction(&self, numerator: i64, denominator: i64) -> Real {
        let part = &Real::from(numerator) / &Real::from(denominator);
        &self.start + &(&(&self.end - &self.start) * &part)
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "[{}, {}]", self.start, self.end)
    }
}
