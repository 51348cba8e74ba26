use std::collections::VecDeque;

use super::BiPoly;
use super::tensor::Tensor;
use crate::number::Field;

/// Whether subdivision into at most so many pieces shows that some polynomials have no common zero
/// in the closed box: on every piece the Bernstein coefficients of one of them have one sign.
#[must_use]
pub fn never_vanish_together<F: Field>(
    polynomials: &[&BiPoly<F>],
    u: (&F, &F),
    v: (&F, &F),
    pieces: usize,
) -> bool {
    let tensors = polynomials.iter().filter(|own| !own.is_zero());
    let whole: Vec<_> = tensors.map(|own| Tensor::of(own, u, v)).collect();
    let mut open = VecDeque::from([(whole, 0_u32)]);
    let mut looked = 0;
    while let Some((tensors, depth)) = open.pop_front() {
        looked += 1;
        let clear = tensors.iter().any(|own| {
            let signs = own.signs();
            !(signs.zero || signs.are_mixed())
        });
        if clear {
            continue;
        }
        if looked + open.len() >= pieces {
            return false;
        }
        let halves = tensors.into_iter().map(|own| {
            if depth.is_multiple_of(2) {
                own.halves_u()
            } else {
                own.halves_v()
            }
        });
        let (left, right): (Vec<_>, Vec<_>) = halves.unzip();
        open.extend([(left, depth + 1), (right, depth + 1)]);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use crate::poly::UniPoly;

    #[test]
    fn crossing_lines_meet_and_parallel_lines_do_not() {
        let line = |constant: i64, u: i64, v: i64| {
            let row = |own: &[i64]| {
                let own: Vec<_> = own.iter().map(|own| Rational::from(*own)).collect();
                UniPoly::from_coefficients(&own)
            };
            BiPoly::from_rows(&[row(&[constant, v]), row(&[u])])
        };
        let (zero, one) = (Rational::from(0), Rational::from(1));
        let apart = |first: &BiPoly<Rational>, second: &BiPoly<Rational>| {
            never_vanish_together(&[first, second], (&zero, &one), (&zero, &one), 256)
        };
        // u = v against 3u + 3v = 2, 3u = 3v + 1 and 5u = 5v + 1
        let diagonal = line(0, 1, -1);
        assert!(!apart(&diagonal, &line(-2, 3, 3)));
        assert!(apart(&diagonal, &line(-1, 3, -3)));
        assert!(apart(&diagonal, &line(-1, 5, -5)));
        assert!(!apart(&diagonal, &diagonal));
    }
}
