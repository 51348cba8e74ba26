use super::image::{Image, place_of_all};
use super::square::primitive_root;
use super::{BiPoly, SquareTest, UniPoly, square_test};
use crate::number::{Field, Integer, Place, Ring, lcm};

/// Whether a polynomial in u and v is a square up to a constant factor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BiSquareTest<F: Field> {
    /// p = factor · root², the root in the normal form of [`BiPoly::primitive`]; 0 is 0 · 1².
    Square {
        /// The constant factor, of either sign.
        factor: F,
        /// The root.
        root: BiPoly<F>,
    },
    /// p is no such square.
    NotSquare {
        /// What shows it.
        reason: String,
    },
}

/// The points at which images are taken: accidents, so that few polynomials are singular there.
const POINTS: [u64; 2] = [3_141_592_653, 2_718_281_828];

/// Decides whether p(u, v) = factor · root².
///
/// An image modulo a prime in one variable refutes almost every other polynomial: if p is a
/// square up to a constant, then so is its image, unless that is 0. For a square the root is
/// that of the univariate p(xᴺ, x), N > degᵥ p, from which p can be read off.
///
/// - **cost** refutation: one image; proof: a square root and a square in degree degᵤ · N
#[must_use]
pub fn square_test_bi<F: Field>(polynomial: &BiPoly<F>) -> BiSquareTest<F> {
    if let [(in_u, in_v)] = polynomial.terms() {
        return product_test(in_u, in_v);
    }
    if let Some(reason) = refuted_by_image(polynomial) {
        return BiSquareTest::NotSquare { reason };
    }
    let Some(degree) = polynomial.bidegree() else {
        return BiSquareTest::Square {
            factor: F::zero(),
            root: BiPoly::one(),
        };
    };
    let packed = pack(polynomial, degree.v + 1);
    if packed.is_constant() {
        return BiSquareTest::Square {
            factor: packed.leading_coefficient(),
            root: BiPoly::one(),
        };
    }
    let root = primitive_root(&packed)
        .and_then(|(factor, root)| Some((factor, unpack(&root, degree.v + 1)?)));
    match root {
        Some((factor, root)) => BiSquareTest::Square { factor, root },
        None => BiSquareTest::NotSquare {
            reason:
                "it has no square root with coefficients in the field, whatever its constant factor"
                    .to_owned(),
        },
    }
}

/// f(u) g(v) is a square up to a constant if f and g are.
fn product_test<F: Field>(in_u: &UniPoly<F>, in_v: &UniPoly<F>) -> BiSquareTest<F> {
    let refused = |odd_part: &UniPoly<F>, variable: &str| BiSquareTest::NotSquare {
        reason: format!(
            "`{}` divides it to an odd power",
            odd_part.display(variable)
        ),
    };
    match (square_test(in_u), square_test(in_v)) {
        (SquareTest::NotSquare { odd_part }, _) => refused(&odd_part, "u"),
        (_, SquareTest::NotSquare { odd_part }) => refused(&odd_part, "v"),
        (
            SquareTest::Square { factor, root },
            SquareTest::Square {
                factor: second,
                root: in_v,
            },
        ) => BiSquareTest::Square {
            factor: factor.times(&second),
            root: BiPoly::product(&root, &in_v),
        },
    }
}

/// Looks for an image in one variable that is not a constant times a square.
///
/// If p = c r², scale r to be primitive over a valuation ring above the point and the prime; by
/// Gauss's lemma r² is primitive too, so where the image of p is not 0, c is a unit and the
/// image is the image of c times a square. Being a square up to a constant is the same over an
/// extension of the prime field.
fn refuted_by_image<F: Field>(polynomial: &BiPoly<F>) -> Option<String> {
    let place = place_of_all([polynomial])?;
    let prime = place.modulus().name();
    for point in POINTS {
        for (variable, image) in [
            ("u", Image::at_u(polynomial, point, &place)),
            ("v", Image::at_v(polynomial, point, &place)),
        ] {
            if !image?.is_square() {
                return Some(shown(&prime, variable, point));
            }
        }
    }
    None
}

/// Looks for an image in one variable that shows that Σ pᵢ² is not a constant times a square,
/// without multiplying it out; in words.
#[must_use]
pub fn sum_of_squares_refuted<F: Field>(parts: &[BiPoly<F>]) -> Option<String> {
    let place = place_of_all(parts)?;
    let prime = place.modulus().name();
    for point in POINTS {
        let images = |of: fn(&BiPoly<F>, u64, &Place) -> Option<Image>| {
            let images = parts.iter().map(|own| of(own, point, &place));
            let images: Option<Vec<Image>> = images.collect();
            Some(Image::sum_of_squares(&images?, place.modulus()))
        };
        for (variable, image) in [
            ("u", images(Image::value_at_u)),
            ("v", images(Image::value_at_v)),
        ] {
            if !image?.is_square() {
                return Some(shown(&prime, variable, point));
            }
        }
    }
    None
}

/// Where an image shows that a polynomial is not a square.
fn shown(prime: &str, variable: &str, point: u64) -> String {
    format!("an image modulo {prime} shows it, at {variable} = {point}")
}

/// p(xᴺ, x)
fn pack<F: Field>(polynomial: &BiPoly<F>, base: usize) -> UniPoly<F> {
    let rows = polynomial.rows();
    let one = Integer::from(1);
    let common = rows
        .iter()
        .fold(one, |common, row| lcm(&common, row.denominator()));
    let mut numerators = vec![F::Ring::zero(); rows.len() * base];
    for (index, row) in rows.iter().enumerate() {
        let scale = &common / row.denominator();
        for (place, own) in numerators[index * base..].iter_mut().zip(row.numerators()) {
            *place = own.scaled(&scale);
        }
    }
    UniPoly::from_numerators(numerators, common)
}

/// The r with r(xᴺ, x) = R and 2 degᵥ r < N, if there is one. Then r² is as determined by its
/// packed form R² as r is.
fn unpack<F: Field>(packed: &UniPoly<F>, base: usize) -> Option<BiPoly<F>> {
    let rows: Vec<_> = packed
        .numerators()
        .chunks(base)
        .map(|row| UniPoly::from_numerators(row.to_vec(), packed.denominator().clone()))
        .collect();
    let fits = |row: &UniPoly<F>| row.degree().is_none_or(|degree| 2 * degree < base);
    rows.iter().all(fits).then(|| BiPoly::from_rows(&rows))
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
    fn planted_roots_are_found() {
        for root in [
            rows(&[&[1, -2, 3], &[], &[0, 5]]),
            rows(&[&[0, 1], &[1]]),
            rows(&[&[7]]),
            rows(&[&[-2, 0, 1]]),
            rows(&[&[1, 1], &[2, 2]]),
        ] {
            let factor = Rational::new((-5).into(), 3.into());
            let square = (&root * &root).scale(&factor);
            let BiSquareTest::Square { factor, root } = square_test_bi(&square) else {
                unreachable!("a square by construction");
            };
            assert_eq!((&root * &root).scale(&factor), square);
            assert_eq!(root.primitive(), root);
        }
        let zero = BiSquareTest::Square {
            factor: Rational::from(0),
            root: BiPoly::one(),
        };
        assert_eq!(square_test_bi(&BiPoly::zero()), zero);
    }

    #[test]
    fn others_are_refused() {
        let root = rows(&[&[1, -2, 3], &[], &[0, 5]]);
        let square = &root * &root;
        for other in [
            &square + &rows(&[&[1]]),
            &square * &rows(&[&[0, 1]]),
            &square * &rows(&[&[1], &[1]]),
            rows(&[&[0, 1], &[1]]),
        ] {
            let refused = matches!(square_test_bi(&other), BiSquareTest::NotSquare { .. });
            assert!(refused, "{other:?}");
        }
    }
    #[test]
    fn a_packed_square_need_not_be_one() {
        // 1 + 2v + u is (1 + x)² at u = x², v = x
        let polynomial = rows(&[&[1, 2], &[1]]);
        let packed = pack(&polynomial, 2);
        let root = primitive_root(&packed).map(|(_, root)| root);
        assert_eq!(root, Some(rows(&[&[1, 1]]).at_u(&Rational::from(0))));
        assert_eq!(root.and_then(|root| unpack(&root, 2)), None);
    }
}
