use super::content::POINT;
use super::image::{Image, place_of_all};
use super::interpolation::Interpolation;
use super::{BiPoly, UniPoly, gcd};
use crate::number::{Field, Integer, Place, Ring, lcm};

impl<F: Field> BiPoly<F> {
    /// The multiple whose coefficients are coprime integers, the leading one (highest power of
    /// u, then of v) positive: the normal form up to factors of the field. 0 for 0.
    ///
    /// Over a field other than the rationals the leading coefficient is first made rational.
    #[must_use]
    pub fn primitive(&self) -> Self {
        let rows = self.rows();
        let Some(lead) = rows.last().map(UniPoly::leading_coefficient) else {
            return Self::zero();
        };
        if !lead.is_rational() {
            return match lead.inverse() {
                Some(inverse) => self.scale(&inverse).primitive(),
                None => Self::zero(),
            };
        }
        let mut content = <Integer as Ring>::zero();
        let mut denominator = <Integer as Ring>::one();
        for row in &rows {
            content = crate::number::gcd(&content, &row.content());
            denominator = lcm(&denominator, row.denominator());
        }
        let sign = if lead.sign().is_lt() { -1 } else { 1 };
        let numerator = F::Ring::from_integer(&(denominator * sign));
        self.scale(&F::from_parts(numerator, content))
    }

    /// The greatest divisor in u alone, the greatest in v alone, and the rest, free of both.
    #[must_use]
    pub fn split(&self) -> Option<(UniPoly<F>, UniPoly<F>, Self)> {
        let (in_u, in_v) = (self.content_u(), self.content_v());
        let mut rest = self.clone();
        if !in_u.is_constant() {
            rest = rest.exact_div_u(&in_u)?;
        }
        if !in_v.is_constant() {
            rest = rest.exact_div_v(&in_v)?;
        }
        Some((in_u, in_v, rest))
    }
}

/// The greatest common divisor in the normal form of [`BiPoly::primitive`]; gcd(0, 0) = 0.
///
/// Images modulo a prime, one at a point u and one at a point v, prove most pairs coprime.
/// Otherwise the divisors in u alone and in v alone are univariate; that of the rest is
/// interpolated from univariate ones, and division is the proof.
#[must_use]
pub fn gcd_bi<F: Field>(left: &BiPoly<F>, right: &BiPoly<F>) -> BiPoly<F> {
    if left.is_zero() {
        return right.primitive();
    }
    if right.is_zero() {
        return left.primitive();
    }
    let place = place_of_all([left, right]);
    if place.is_some_and(|place| images_coprime(left, right, &place)) {
        return BiPoly::one();
    }
    let (Some(first), Some(second)) = (left.split(), right.split()) else {
        return BiPoly::one();
    };
    let univariate = BiPoly::product(&gcd(&first.0, &second.0), &gcd(&first.1, &second.1));
    (&univariate * &gcd_of_primitive(&first.2, &second.2)).primitive()
}

/// The quotient if the divisor divides; none if it does not, or is 0.
///
/// Long division in u, where every quotient of leading coefficients has to be exact in `F[v]`.
#[must_use]
pub fn exact_div_bi<F: Field>(dividend: &BiPoly<F>, divisor: &BiPoly<F>) -> Option<BiPoly<F>> {
    if let [(in_u, in_v)] = divisor.terms() {
        return dividend.exact_div_u(in_u)?.exact_div_v(in_v);
    }
    let body = divisor.rows();
    let lead = body.last()?;
    let mut remainder = dividend.rows();
    if remainder.is_empty() {
        return Some(BiPoly::zero());
    }
    let low = body.len() - 1;
    let steps = remainder.len().checked_sub(body.len())?;
    let mut quotient = vec![UniPoly::zero(); steps + 1];
    for step in (0..=steps).rev() {
        let digit = remainder[step + low].exact_div(lead)?;
        if !digit.is_zero() {
            for (index, own) in body.iter().enumerate() {
                remainder[step + index] = &remainder[step + index] - &(&digit * own);
            }
        }
        quotient[step] = digit;
    }
    let exact = remainder[..low].iter().all(UniPoly::is_zero);
    exact.then(|| BiPoly::from_rows(&quotient))
}

/// The gcd of two polynomials without divisors in one variable alone.
fn gcd_of_primitive<F: Field>(left: &BiPoly<F>, right: &BiPoly<F>) -> BiPoly<F> {
    let (Some(first), Some(second)) = (left.bidegree(), right.bidegree()) else {
        return BiPoly::one();
    };
    // Without such divisors a polynomial in one variable is a constant.
    let place = place_of_all([left, right]);
    let bounded = place.is_some_and(|place| free_of_v(left, right, &place));
    if first.u.min(first.v).min(second.u).min(second.v) == 0 || bounded {
        return BiPoly::one();
    }
    if first.u.min(second.u) > first.v.min(second.v) {
        return interpolated_gcd(&left.transpose(), &right.transpose()).transpose();
    }
    interpolated_gcd(left, right)
}

/// Whether images at one point show that every common divisor is a constant.
fn images_coprime<F: Field>(left: &BiPoly<F>, right: &BiPoly<F>, place: &Place) -> bool {
    let image = |own: &BiPoly<F>| {
        let image = Image::at_v(own, POINT, place)?;
        let degree = own.terms().iter().filter_map(|(in_u, _)| in_u.degree());
        Some((degree.max(), image))
    };
    free_of_v(left, right, place) && are_coprime(image(left), image(right))
}

/// Whether images at one point show that no common divisor depends on v.
fn free_of_v<F: Field>(left: &BiPoly<F>, right: &BiPoly<F>, place: &Place) -> bool {
    let image = |own: &BiPoly<F>| {
        let image = Image::at_u(own, POINT, place)?;
        let degree = own.terms().iter().filter_map(|(_, in_v)| in_v.degree());
        Some((degree.max(), image))
    };
    are_coprime(image(left), image(right))
}

/// Whether two images are coprime and one of them reaches the bound for its degree. Then no
/// common divisor depends on the variable that is left: scaled to be primitive over the local
/// ring of the point and the prime, it would keep its degree too.
fn are_coprime(
    left: Option<(Option<usize>, Image)>,
    right: Option<(Option<usize>, Image)>,
) -> bool {
    let (Some((left_bound, left)), Some((right_bound, right))) = (left, right) else {
        return false;
    };
    let kept = left.degree() == left_bound || right.degree() == right_bound;
    kept && left.gcd(right).degree() == Some(0)
}

/// The gcd from gcd(p(x, v), q(x, v)) at integers x.
///
/// Where the leading coefficients in v are kept, the degree there is not below that of the gcd,
/// and for all but finitely many x it is equal; then the monic gcd times γ(x), γ = gcd of the
/// leading coefficients, is a value of the gcd times a polynomial in u.
fn interpolated_gcd<F: Field>(left: &BiPoly<F>, right: &BiPoly<F>) -> BiPoly<F> {
    let [first, second] = [left, right].map(|own| own.columns().pop());
    let (Some(first), Some(second)) = (first, second) else {
        return BiPoly::one();
    };
    let lead = gcd(&first, &second);
    let mut interpolation = Interpolation::new();
    let mut degree = usize::MAX;
    for point in Interpolation::<F>::integers() {
        let at = F::from_integer(&Integer::from(point));
        if first.evaluate(&at).is_zero() || second.evaluate(&at).is_zero() {
            continue;
        }
        let common = gcd(&left.at_u(&at), &right.at_u(&at));
        let Some(own) = common.degree().filter(|own| *own > 0) else {
            break;
        };
        if own > degree {
            continue;
        }
        if own < degree {
            degree = own;
            interpolation = Interpolation::new();
        }
        let value = common.monic().scale(&lead.evaluate(&at));
        if interpolation.push(point, &value) {
            let candidate = BiPoly::from_rows(&interpolation.rows());
            let candidate = candidate.exact_div_u(&candidate.content_u());
            if let Some(candidate) = candidate
                && exact_div_bi(left, &candidate).is_some()
                && exact_div_bi(right, &candidate).is_some()
            {
                return candidate.primitive();
            }
        }
    }
    BiPoly::one()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;

    fn rows(rows: &[&[i64]]) -> BiPoly<Rational> {
        let row = |row: &&[i64]| {
            let row: Vec<_> = row.iter().copied().map(Rational::from).collect();
            UniPoly::from_coefficients(&row)
        };
        BiPoly::from_rows(&rows.iter().map(row).collect::<Vec<_>>())
    }

    #[test]
    fn planted_divisors_of_every_kind_are_found() {
        // (u−2)(v²+1)(uv−1)(u+v) against (u−2)²(v²+1)(u+v)(u²v+3)
        let line = rows(&[&[-2], &[1]]);
        let circle = rows(&[&[1, 0, 1]]);
        let (saddle, sum) = (rows(&[&[-1], &[0, 1]]), rows(&[&[0, 1], &[1]]));
        let common = &(&line * &circle) * &sum;
        let left = (&common * &saddle).scale(&Rational::from(-6));
        let right = &(&common * &line) * &rows(&[&[3], &[], &[0, 1]]);
        assert_eq!(gcd_bi(&left, &right), common);
        assert_eq!(
            exact_div_bi(&left, &common),
            Some(saddle.scale(&Rational::from(-6)))
        );
        assert_eq!(exact_div_bi(&common, &saddle), None);
        assert_eq!(gcd_bi(&saddle, &sum), BiPoly::one());
        assert_eq!(gcd_bi(&BiPoly::zero(), &left), left.primitive());
        assert_eq!(
            gcd_bi(&BiPoly::<Rational>::zero(), &BiPoly::zero()),
            BiPoly::zero()
        );
        assert_eq!(exact_div_bi(&left, &BiPoly::zero()), None);
    }
}
