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

    /// Its equal parts, in order.
    #[must_use]
    pub fn divided(&self, count: usize) -> Vec<Self> {
        let count = i64::try_from(count).unwrap_or(i64::MAX);
        let end = |index| match index {
            0 => self.start.clone(),
            _ if index == count => self.end.clone(),
            _ => self.fraction(index, count),
        };
        let parts = (0..count).map(|index| (end(index), end(index + 1)));
        let parts = parts.map(|(start, end)| Self { start, end });
        parts.collect()
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "[{}, {}]", self.start, self.end)
    }
}
