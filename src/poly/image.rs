use super::{BiPoly, UniPoly};
use crate::number::{Field, Modulus, Place, Ring};

/// A polynomial over a prime field, ascending, without trailing zeros: the image of a
/// polynomial's numerators at a [`Place`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Image {
    modulus: Modulus,
    coefficients: Vec<u64>,
}

/// A place at which all the polynomials have images; none if none is known.
pub(super) fn place_of<'a, F: Field>(
    polynomials: impl IntoIterator<Item = &'a UniPoly<F>>,
) -> Option<Place> {
    let highest = polynomials.into_iter().filter_map(UniPoly::highest);
    match highest.max_by_key(|own| own.height()) {
        Some(highest) => highest.place(),
        None => Some(Place::rational()),
    }
}

/// A place at which all the polynomials have images; none if none is known.
pub(super) fn place_of_all<'a, F: Field>(
    polynomials: impl IntoIterator<Item = &'a BiPoly<F>>,
) -> Option<Place> {
    let terms = polynomials.into_iter().flat_map(BiPoly::terms);
    place_of(terms.flat_map(|(in_u, in_v)| [in_u, in_v]))
}

impl Image {
    /// The image of the numerators at a place for them.
    pub(super) fn of<F: Field>(polynomial: &UniPoly<F>, place: &Place) -> Self {
        Self::new(polynomial.image(place), place.modulus())
    }

    /// Σ cᵢ xⁱ from ascending coefficients.
    pub(super) fn new(mut coefficients: Vec<u64>, modulus: &Modulus) -> Self {
        while coefficients.last() == Some(&0) {
            coefficients.pop();
        }
        Self {
            modulus: *modulus,
            coefficients,
        }
    }

    /// The image of p(a, v), a polynomial in v, up to a factor; none if a denominator vanishes in it.
    pub(super) fn at_u<F: Field>(polynomial: &BiPoly<F>, at: u64, place: &Place) -> Option<Self> {
        let terms = polynomial.terms().iter();
        let own = Self::at(terms.map(|(in_u, in_v)| (in_u, in_v)), at, place)?;
        Some(own.0)
    }

    /// The image of p(u, b), a polynomial in u, up to a factor.
    pub(super) fn at_v<F: Field>(polynomial: &BiPoly<F>, at: u64, place: &Place) -> Option<Self> {
        let terms = polynomial.terms().iter();
        let own = Self::at(terms.map(|(in_u, in_v)| (in_v, in_u)), at, place)?;
        Some(own.0)
    }

    /// The image of p(a, v) itself.
    pub(super) fn value_at_u<F: Field>(
        polynomial: &BiPoly<F>,
        at: u64,
        place: &Place,
    ) -> Option<Self> {
        let terms = polynomial.terms().iter();
        let (own, below) = Self::at(terms.map(|(in_u, in_v)| (in_u, in_v)), at, place)?;
        Some(own.over(below))
    }

    /// The image of p(u, b) itself.
    pub(super) fn value_at_v<F: Field>(
        polynomial: &BiPoly<F>,
        at: u64,
        place: &Place,
    ) -> Option<Self> {
        let terms = polynomial.terms().iter();
        let (own, below) = Self::at(terms.map(|(in_u, in_v)| (in_v, in_u)), at, place)?;
        Some(own.over(below))
    }

    fn over(mut self, divisor: u64) -> Self {
        let modulus = self.modulus;
        let inverse = modulus.inverse(divisor);
        for own in &mut self.coefficients {
            *own = modulus.times(*own, inverse);
        }
        self
    }

    /// d Σ fₖ(a) gₖ and d, the product of all denominators.
    fn at<'a, F: Field>(
        terms: impl Iterator<Item = (&'a UniPoly<F>, &'a UniPoly<F>)>,
        at: u64,
        place: &Place,
    ) -> Option<(Self, u64)> {
        let modulus = place.modulus();
        let at = modulus.embed(at);
        // Over the product of the denominators so far.
        let (mut sum, mut below) = (Vec::new(), modulus.one());
        for (fixed, free) in terms {
            let weight = modulus.times(Self::of(fixed, place).evaluate(at), below);
            for own in [fixed, free].map(UniPoly::denominator) {
                if Ring::is_one(own) {
                    continue;
                }
                let own = modulus.embed_integer(own);
                if own == 0 {
                    return None;
                }
                below = modulus.times(below, own);
                for known in &mut sum {
                    *known = modulus.times(*known, own);
                }
            }
            let free = free.image(place);
            sum.resize(sum.len().max(free.len()), 0);
            for (own, image) in sum.iter_mut().zip(free) {
                *own = modulus.plus(*own, modulus.times(image, weight));
            }
        }
        Some((Self::new(sum, modulus), below))
    }

    fn evaluate(&self, at: u64) -> u64 {
        let modulus = &self.modulus;
        let coefficients = self.coefficients.iter().rev();
        coefficients.fold(0, |value, own| modulus.plus(modulus.times(value, at), *own))
    }

    /// Σ pᵢ²
    pub(super) fn sum_of_squares(parts: &[Self], modulus: &Modulus) -> Self {
        let longest = parts.iter().map(|own| own.coefficients.len()).max();
        let mut sum = vec![0; (2 * longest.unwrap_or(0)).saturating_sub(1)];
        for part in parts {
            for (i, left) in part.coefficients.iter().enumerate() {
                for (own, right) in sum[i..].iter_mut().zip(&part.coefficients) {
                    *own = modulus.plus(*own, modulus.times(*left, *right));
                }
            }
        }
        Self::new(sum, modulus)
    }

    /// Whether it is a constant times a square; 0 is.
    ///
    /// The root of the monic multiple follows from the upper half of the coefficients.
    pub(super) fn is_square(&self) -> bool {
        let (modulus, length) = (&self.modulus, self.coefficients.len());
        let Some(lead) = self.coefficients.last() else {
            return true;
        };
        if length.is_multiple_of(2) {
            return false;
        }
        let inverse = modulus.inverse(*lead);
        let half = modulus.inverse(modulus.embed(2));
        let descending = self.coefficients.iter().rev();
        let monic: Vec<u64> = descending.map(|own| modulus.times(*own, inverse)).collect();
        let mut root = vec![modulus.one()];
        for (order, own) in monic.iter().enumerate().skip(1) {
            let first = (order + 1).saturating_sub(length.div_ceil(2)).max(1);
            let sum = (first..root.len().min(order + 1 - first))
                .map(|index| modulus.times(root[index], root[order - index]))
                .fold(0, |sum, product| modulus.plus(sum, product));
            if order <= length / 2 {
                root.push(modulus.times(modulus.minus(*own, sum), half));
            } else if sum != *own {
                return false;
            }
        }
        true
    }

    /// The coefficients, ascending.
    pub(super) fn into_coefficients(self) -> Vec<u64> {
        self.coefficients
    }

    /// The degree; none for 0.
    pub(super) fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// The greatest common divisor up to a constant factor, see [`image_gcd`].
    pub(super) fn gcd(self, other: Self) -> Self {
        let modulus = self.modulus;
        let coefficients = image_gcd(self.coefficients, other.coefficients, &modulus);
        Self {
            modulus,
            coefficients,
        }
    }
}

/// The greatest common divisor of two polynomials over a prime field up to a constant factor, by
/// cross-multiplied remainders lc(b) a − lc(a) xᵏ b: no inverses.
pub(super) fn image_gcd(mut high: Vec<u64>, mut low: Vec<u64>, modulus: &Modulus) -> Vec<u64> {
    loop {
        if high.len() < low.len() {
            std::mem::swap(&mut high, &mut low);
        }
        let Some(&divisor) = low.last() else {
            return high;
        };
        if low.len() == 1 {
            return vec![modulus.one()];
        }
        let Some(lead) = high.pop() else {
            return low;
        };
        let offset = high.len() + 1 - low.len();
        for own in &mut high[..offset] {
            *own = modulus.times(*own, divisor);
        }
        for (own, subtrahend) in high[offset..].iter_mut().zip(&low) {
            *own = modulus.minus(
                modulus.times(*own, divisor),
                modulus.times(*subtrahend, lead),
            );
        }
        while high.last() == Some(&0) {
            high.pop();
        }
    }
}

/// The rank of a list of images, as vectors of coefficients over one prime field.
pub(super) fn rank(mut images: Vec<Image>) -> usize {
    let mut rank = 0;
    while let Some(pivot) = images.pop() {
        let Some(lead) = pivot.coefficients.last().copied() else {
            continue;
        };
        rank += 1;
        let degree = pivot.coefficients.len() - 1;
        for image in &mut images {
            let Some(own) = image.coefficients.get(degree).copied() else {
                continue;
            };
            // image ← lead image − own pivot, which is 0 at that degree
            for (index, value) in image.coefficients.iter_mut().enumerate() {
                let part = pivot.coefficients.get(index).copied().unwrap_or(0);
                let modulus = &pivot.modulus;
                *value = modulus.minus(modulus.times(*value, lead), modulus.times(part, own));
            }
            while image.coefficients.last() == Some(&0) {
                image.coefficients.pop();
            }
        }
    }
    rank
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(coefficients: &[u64]) -> Image {
        let modulus = Modulus::mersenne();
        let coefficients = coefficients.iter().map(|own| modulus.embed(*own));
        Image::new(coefficients.collect(), &modulus)
    }

    #[test]
    fn squares_up_to_a_constant_are_told_from_others() {
        // 3 (x²+2x+5)², and with each of its coefficients changed
        let square = [75, 60, 42, 12, 3];
        assert!(image(&square).is_square());
        for place in 0..square.len() {
            let mut other = square;
            other[place] += 1;
            assert!(!image(&other).is_square(), "{other:?}");
        }
        assert!(image(&[]).is_square() && image(&[7]).is_square());
        assert!(!image(&[0, 1]).is_square() && image(&[0, 0, 1]).is_square());
    }

    #[test]
    fn images_at_points_are_images_of_values() {
        let number = |value: i64| crate::number::Rational::new(value.into(), 6.into());
        let rows = [[3, 1, 4], [1, 5, 9], [2, 6, 5]].map(|row| {
            let row: Vec<_> = row.iter().copied().map(number).collect();
            UniPoly::from_coefficients(&row)
        });
        let polynomial = BiPoly::from_rows(&rows);
        // up to the denominator that the image of a univariate polynomial leaves out
        let modulus = Modulus::mersenne();
        let exact = |image: Option<Image>, own: &UniPoly<_>| {
            let denominator = modulus.embed_integer(own.denominator());
            image == Some(Image::of(own, &Place::rational()).over(denominator))
        };
        let proportional = |left: &Image, right: &Image| {
            let (left, right) = (&left.coefficients, &right.coefficients);
            let same =
                |(l, r): (&u64, &u64)| modulus.times(*l, right[0]) == modulus.times(*r, left[0]);
            left.len() == right.len() && left.iter().zip(right).all(same)
        };
        let place = Place::rational();
        let at = crate::number::Rational::from(7);
        let in_v = Image::at_u(&polynomial, 7, &place);
        let in_u = Image::at_v(&polynomial, 7, &place);
        let (at_u, at_v) = (polynomial.at_u(&at), polynomial.at_v(&at));
        assert!(exact(Image::value_at_u(&polynomial, 7, &place), &at_u));
        assert!(exact(Image::value_at_v(&polynomial, 7, &place), &at_v));
        assert!(in_v.is_some_and(|own| proportional(&own, &Image::of(&at_u, &place))));
        assert!(in_u.is_some_and(|own| proportional(&own, &Image::of(&at_v, &place))));
    }
}
