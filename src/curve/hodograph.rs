use crate::number::{Field, Real, Tower};
use crate::poly::{RealRoot, SquareTest, UniPoly, gcd_all, real_roots, sign_change, square_test};

use super::{Fault, Homogeneous, Interval};

/// The hodograph r′ = (a, b, c)/d in lowest terms, d primitive.
///
/// For homogeneous coordinates (w; x) in lowest terms x′ = (x′w − xw′)/w²; a repeated factor of w
/// cancels once more.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hodograph {
    /// a, b, c
    pub numerators: [UniPoly<Real>; 3],
    /// d
    pub denominator: UniPoly<Real>,
}

impl Hodograph {
    /// The derivative of a curve in lowest terms.
    #[must_use]
    pub fn of(curve: &Homogeneous) -> Self {
        let weight = &curve.weight;
        let slope = weight.derivative();
        let numerators = curve.coordinates.each_ref().map(|own| {
            if weight.is_constant() {
                own.derivative()
            } else {
                UniPoly::sum_of_products(&[(1, &own.derivative(), weight), (-1, own, &slope)])
            }
        });
        let denominator = if weight.is_constant() {
            weight.clone()
        } else {
            weight * weight
        };
        let common = gcd_all(std::iter::once(&denominator).chain(&numerators));
        let divide = |own: &UniPoly<Real>| own.exact_div(&common).unwrap_or_else(|| own.clone());
        Self {
            denominator: divide(&denominator),
            numerators: numerators.each_ref().map(divide),
        }
    }

    /// Whether the curve does not move.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerators.iter().all(UniPoly::is_zero)
    }

    /// The polynomial N with N² = a² + b² + c², positive on the domain apart from isolated
    /// zeros: the numerator of the parametric speed σ = N/|d|.
    ///
    /// For a plane curve N = |g| h |ω|² where a + ib = g h ω².   [farouki-nittler, eq. 3]
    ///
    /// # Errors
    ///
    /// [`Fault::NoMotion`], [`Fault::NotPythagorean`], [`Fault::FieldDegree`] where the square root
    /// of the leading coefficient would extend the field too far, and [`Fault::SpeedChangesSign`]
    /// where no choice of sign is right on the whole domain.
    pub fn speed(&self, domain: &Interval, tower: &Tower) -> Result<UniPoly<Real>, Fault> {
        if self.is_zero() {
            return Err(Fault::NoMotion);
        }
        let squares = self.numerators.each_ref().map(|own| (1, own, own));
        let squared = UniPoly::sum_of_products(&squares);
        let (factor, root) = match square_test(&squared) {
            SquareTest::Square { factor, root } => (factor, root),
            SquareTest::NotSquare { odd_part } => return Err(Fault::NotPythagorean { odd_part }),
        };
        let scale = tower.square_root(&factor);
        let Ok(scale) = scale else {
            return Err(Fault::FieldDegree { radicand: factor });
        };
        let signed = root.scale(&scale);
        let over = &signed * &self.denominator;
        let changes = |own: &_| sign_change(own, domain.start(), domain.end());
        if changes(&(&self.common() * &self.denominator)).is_some()
            && let Some(root) = changes(&over)
        {
            return Err(Fault::SpeedChangesSign {
                root: Box::new(root),
            });
        }
        Ok(if is_negative(&over, domain) {
            -&signed
        } else {
            signed
        })
    }

    /// The cusps: zeros of its speed numerator on the closed domain.
    #[must_use]
    pub fn cusps(&self, speed: &UniPoly<Real>, domain: &Interval) -> Vec<RealRoot<Real>> {
        let common = self.common();
        let zeros = |own| real_roots(own, domain.start(), domain.end());
        if common.is_constant() || zeros(&common).is_empty() {
            return Vec::new();
        }
        zeros(speed)
    }

    /// The greatest common divisor of a, b, c, of a lower degree than N by far.
    ///
    /// N² = a² + b² + c² is 0 only where all three are, so N = ±gcd(a, b, c) M without real zeros
    /// of M.
    fn common(&self) -> UniPoly<Real> {
        gcd_all(&self.numerators)
    }
}

/// The sign of a non-zero polynomial that does not change sign on the domain: one of
/// deg + 1 inner points is not a zero.
fn is_negative(polynomial: &UniPoly<Real>, domain: &Interval) -> bool {
    let pieces = i64::try_from(polynomial.numerators().len() + 1).unwrap_or(i64::MAX);
    (1..pieces)
        .map(|piece| polynomial.evaluate(&domain.fraction(piece, pieces)).sign())
        .find(|sign| sign.is_ne())
        .is_some_and(std::cmp::Ordering::is_lt)
}
