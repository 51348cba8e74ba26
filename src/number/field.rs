use std::cmp::Ordering;
use std::fmt::{Debug, Display};

use super::{Basis, Integer, Leading, Place};

/// The numerators of a [`Field`]: an integral domain in which every element of the field stands
/// over a rational integer.
///
/// For the rationals this is ℤ; for ℚ(√a)(√b)… it is ℤ[√a, √b, …] with integral radicands.
pub trait Ring: Clone + PartialEq + Eq + Debug + Send + Sync + 'static {
    /// 0
    fn zero() -> Self;
    /// 1
    fn one() -> Self;
    /// 1, which always stands at the same place.
    fn unit() -> &'static Self;
    /// The image of a rational integer.
    fn from_integer(value: &Integer) -> Self;
    /// Whether it is 0.
    fn is_zero(&self) -> bool;
    /// Whether it is 1.
    fn is_one(&self) -> bool;
    /// a + b
    #[must_use]
    fn plus(&self, other: &Self) -> Self;
    /// a − b
    #[must_use]
    fn minus(&self, other: &Self) -> Self;
    /// a b
    #[must_use]
    fn times(&self, other: &Self) -> Self;
    /// a += b
    fn add(&mut self, other: &Self);
    /// a += b c
    fn add_product(&mut self, left: &Self, right: &Self);
    /// The coefficients of the product of two polynomials that are not 0.
    fn convolution(left: &[Self], right: &[Self]) -> Vec<Self>;
    /// The coefficients of Σ aₖ xᵏ (1+x)ⁿ⁻ᵏ for n + 1 numbers aₖ or fewer.
    fn binomial_sums(powers: &[Self], degree: usize) -> Vec<Self>;
    /// The Bernstein coefficients on both halves of an interval, all times 2ⁿ, from those on the
    /// interval.
    fn halves(coefficients: Vec<Self>) -> (Vec<Self>, Vec<Self>);
    /// −a
    #[must_use]
    fn negated(&self) -> Self;
    /// a n for a rational integer n
    #[must_use]
    fn scaled(&self, factor: &Integer) -> Self;
    /// a / n for a rational integer n that divides the content of a
    #[must_use]
    fn divided(&self, divisor: &Integer) -> Self;
    /// a / b if that lies in the ring; b is not 0
    fn quotient(&self, divisor: &Self) -> Option<Self>;
    /// The greatest rational integer that divides a; it is not negative, and 0 for 0.
    fn content(&self) -> Integer {
        self.content_with(&<Integer as Ring>::zero())
    }
    /// The greatest rational integer that divides a and n; it is not negative, and 0 if both are 0.
    fn content_with(&self, other: &Integer) -> Integer;
    /// The sign of the real number.
    fn sign(&self) -> Ordering;
    /// The number of generators of the field that the element is known to lie in: 0 for a
    /// rational integer.
    fn height(&self) -> usize;
    /// A homomorphism to a prime field, good for all elements of no greater height; none if
    /// none is known.
    fn place(&self) -> Option<Place>;
    /// The image at a place, which is that of an element of no smaller height.
    fn image(&self, place: &Place) -> u64;
    /// The generators that occur in some elements, and in the radicands of those.
    fn basis<'a>(elements: impl IntoIterator<Item = &'a Self>) -> Basis;
    /// The element with these components on the products of the generators of a basis, product
    /// number j of those whose bit is set in j.
    fn from_components(basis: &Basis, components: &[Integer]) -> Self;
    /// The size of the largest rational integer in it.
    fn bits(&self) -> u64;
    /// The element as a rational integer; none if it is not one.
    fn as_integer(&self) -> Option<&Integer>;
    /// Its leading digits; none where the terms of a sum cancel so far that few are sure.
    fn leading(&self) -> Option<Leading>;
}

/// A real field with exact arithmetic and decidable sign.
///
/// Values are canonical: equal numbers compare equal.
pub trait Field: Clone + PartialEq + Eq + Ord + Debug + Display + Send + Sync + 'static {
    /// The numerators.
    type Ring: Ring;

    /// numerator / denominator; the denominator is not 0
    fn from_parts(numerator: Self::Ring, denominator: Integer) -> Self;
    /// The image of a rational integer.
    fn from_integer(value: &Integer) -> Self {
        Self::from_parts(Self::Ring::from_integer(value), <Integer as Ring>::one())
    }
    /// The numerator and the positive denominator, in lowest terms.
    fn parts(&self) -> (&Self::Ring, &Integer);
    /// The same of a number that is not needed any more.
    fn into_parts(self) -> (Self::Ring, Integer);
    /// The same as machine numbers, if both are.
    fn machine_parts(&self) -> Option<(i128, i128)>;
    /// 0
    fn zero() -> Self;
    /// 1
    fn one() -> Self;
    /// Whether it is 0.
    fn is_zero(&self) -> bool;
    /// Whether it is 1.
    fn is_one(&self) -> bool;
    /// Whether it is a rational number.
    fn is_rational(&self) -> bool {
        self.parts().0.height() == 0
    }
    /// a + b
    #[must_use]
    fn plus(&self, other: &Self) -> Self;
    /// a − b
    #[must_use]
    fn minus(&self, other: &Self) -> Self;
    /// a b
    #[must_use]
    fn times(&self, other: &Self) -> Self;
    /// −a
    #[must_use]
    fn negated(&self) -> Self;
    /// 1 / a; none for 0
    fn inverse(&self) -> Option<Self>;
    /// The sign of the real number.
    fn sign(&self) -> Ordering;
    /// The root that is not negative, if it lies in the field that the number itself generates
    /// together with the levels below it.
    fn square_root(&self) -> Option<Self>;
}
