use std::cmp::Ordering;

/// Triangles between a chain of outer points and a chain of inner ones to its left, by the places
/// of their positions, which rise: (outer, outer, inner) or (outer, inner, inner).
///
/// The next point is that of the chain whose next one comes first. So a triangle reaches no
/// further than one step of one of the chains, or to the first inner point, or from the last.
pub(super) fn strip<P: Ord, T: Copy>(
    outer: &[(P, T)],
    inner: &[(P, T)],
    each: &mut impl FnMut([T; 3]),
) {
    let (mut i, mut j) = (0, 0);
    loop {
        let next = (outer.get(i + 1), inner.get(j + 1));
        let order = match next {
            (Some(one), Some(other)) => one.0.cmp(&other.0),
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (None, None) => return,
        };
        if order.is_le() {
            each([outer[i].1, outer[i + 1].1, inner[j].1]);
            i += 1;
        } else {
            each([outer[i].1, inner[j + 1].1, inner[j].1]);
            j += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strip_is_covered_once_and_no_triangle_is_wide() {
        // On the outer chain steps of 1/count, on the inner one places 1/4, 1/2, 3/4.
        for count in 4..30_i64 {
            let outer: Vec<_> = (0..=count).map(|own| (own * 4, (own * 4, 0))).collect();
            let inner: Vec<_> = (1..4).map(|own| (own * count, (own * count, 1))).collect();
            let mut area = 0;
            strip(&outer, &inner, &mut |[a, b, c]: [(i64, i64); 3]| {
                let cross = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
                assert!(cross > 0, "{a:?} {b:?} {c:?}");
                area += cross;
                let places = [a.0, b.0, c.0];
                let width = places.iter().max().zip(places.iter().min());
                assert!(width.is_some_and(|(high, low)| high - low <= count));
            });
            // Twice the trapezoid between chains of the lengths 4 count and 2 count.
            assert_eq!(area, 6 * count);
        }
    }
}
