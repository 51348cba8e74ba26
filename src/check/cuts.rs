use crate::number::{Field, Integer, Rational, Real};
use crate::poly::{UniPoly, bernstein};

/// Cuts are sought among the fractions with the denominator 2ᵏ of an interval.
const FINEST: u32 = 20;
/// The greatest number of parts of one direction.
const MOST_PARTS: usize = 64;

/// One direction of a domain, brought to positive Bernstein coefficients.
pub(super) struct Cuts {
    /// The degree of the parts.
    pub(super) degree: usize,
    /// The inner cuts, ascending.
    pub(super) inner: Vec<Real>,
}

impl Cuts {
    /// The fewest cuts after which a polynomial that is positive on [from, to] has positive
    /// Bernstein coefficients on every part; none if degree elevation within `raised` does without.
    ///
    /// Coefficients that are positive on an interval are so on every part of it, being means of
    /// them. So the farthest reach from the start, and again from there, gives the least number of
    /// parts; equal parts are taken where as few do, else cuts with small denominators.
    ///
    /// - **errors** none: more than 64 parts
    pub(super) fn of(
        polynomial: &UniPoly<Real>,
        degrees: impl IntoIterator<Item = usize>,
        from: &Real,
        to: &Real,
    ) -> Option<Self> {
        let mut least = None;
        for degree in degrees {
            least.get_or_insert(degree);
            if is_positive(&bernstein(polynomial, degree, from, to)) {
                return Some(Self {
                    degree,
                    inner: Vec::new(),
                });
            }
        }
        let line = Line {
            polynomial: polynomial.restrict(from, to),
            degree: least?,
        };
        let width = to.minus(from);
        let place = |own: &Rational| from.plus(&width.times(&Real::from(own.clone())));
        Some(Self {
            degree: line.degree,
            inner: line.cuts()?.iter().map(place).collect(),
        })
    }
}

/// Whether all numbers are positive.
pub(super) fn is_positive(values: &[Real]) -> bool {
    values.iter().all(|own| own.sign().is_gt())
}

/// A polynomial on [0, 1] and the degree in which its coefficients are asked for.
struct Line {
    polynomial: UniPoly<Real>,
    degree: usize,
}

impl Line {
    fn is_positive(&self, from: &Rational, to: &Rational) -> bool {
        let (from, to) = (Real::from(from.clone()), Real::from(to.clone()));
        is_positive(&bernstein(&self.polynomial, self.degree, &from, &to))
    }

    /// The inner cuts of the fewest parts.
    fn cuts(&self) -> Option<Vec<Rational>> {
        let one = Rational::one();
        // From the end: before the earliest cut of each part the rest does not suffice.
        let mut earliest = vec![one.clone()];
        while let Some(last) = earliest.last().filter(|own| !own.is_zero()) {
            if earliest.len() > MOST_PARTS {
                return None;
            }
            earliest.push(self.reach(last, &Rational::zero())?);
        }
        earliest.reverse();
        let parts = earliest.len() - 1;
        let equal: Vec<_> = (0..=parts).map(|own| fraction(own, parts)).collect();
        if equal
            .windows(2)
            .all(|own| self.is_positive(&own[0], &own[1]))
        {
            return Some(equal.get(1..parts)?.to_vec());
        }
        let mut cuts = vec![Rational::zero()];
        for low in earliest.get(1..parts)? {
            let high = self.reach(cuts.last()?, &one)?;
            cuts.push(simplest(low, &high));
        }
        cuts.remove(0);
        Some(cuts)
    }

    /// The place farthest towards `end` up to which the coefficients are positive from `start` on;
    /// none if there is no such place.
    fn reach(&self, start: &Rational, end: &Rational) -> Option<Rational> {
        let reaches = |at: &Rational| {
            if at < start {
                self.is_positive(at, start)
            } else {
                self.is_positive(start, at)
            }
        };
        if reaches(end) {
            return Some(end.clone());
        }
        let (mut near, mut far) = (start.clone(), end.clone());
        for _ in 0..FINEST {
            let middle = near.plus(&far).times(&fraction(1, 2));
            if reaches(&middle) {
                near = middle;
            } else {
                far = middle;
            }
        }
        (near != *start).then_some(near)
    }
}

/// The fraction with the least power of two below it in a closed interval, the one nearest to its
/// middle.
fn simplest(low: &Rational, high: &Rational) -> Rational {
    let middle = low.plus(high).times(&fraction(1, 2));
    for exponent in 1..=2 * FINEST {
        let scale = Rational::from(Integer::from(1) << exponent);
        // The multiple of 1/scale nearest to the middle.
        let twice = middle
            .times(&scale)
            .times(&fraction(2, 1))
            .plus(&Rational::one());
        let nearest = twice.numerator() / (twice.denominator() * Integer::from(2));
        let nearest = Rational::dyadic(&nearest, exponent);
        if *low <= nearest && nearest <= *high {
            return nearest;
        }
    }
    middle
}

fn fraction(numerator: usize, denominator: usize) -> Rational {
    Rational::new(Integer::from(numerator), Integer::from(denominator))
}
