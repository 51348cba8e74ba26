//! De Casteljau's triangle at 1/2, on lists of Bernstein coefficients.

use super::{Integer, Ring};

/// The Bernstein coefficients on both halves, all times 2ⁿ: sums in place of means.
pub(super) fn one_by_one<R: Ring>(mut row: Vec<R>) -> (Vec<R>, Vec<R>) {
    let degree = row.len().saturating_sub(1);
    let mut left = Vec::with_capacity(row.len());
    for step in 0..row.len() {
        let scale = Integer::from(1) << (degree - step);
        left.push(row[0].scaled(&scale));
        // row[..len − step] is the next line of the triangle; the side stays behind it.
        let last = degree - step;
        for index in 0..last {
            row[index] = row[index].plus(&row[index + 1]);
        }
        row[last] = row[last].scaled(&scale);
    }
    (left, row)
}

/// The same for machine numbers whose sums are machine numbers: at most 2ⁿ times the greatest. None
/// for others.
pub(super) fn in_machine_numbers<R: Ring>(
    row: &[R],
    whole: impl Fn(Integer) -> R,
) -> Option<(Vec<R>, Vec<R>)> {
    let degree = row.len().checked_sub(1)?;
    let mut numbers = Vec::with_capacity(row.len());
    let mut size = 0;
    for own in row {
        let own = own.as_integer()?.machine()?;
        size |= own.unsigned_abs();
        numbers.push(own);
    }
    if usize::try_from(size.leading_zeros()).ok()? < degree + 2 {
        return None;
    }
    let whole = |own: i128| whole(Integer::from(own));
    let mut left = Vec::with_capacity(row.len());
    for last in (0..=degree).rev() {
        left.push(whole(numbers[0] << last));
        for index in 0..last {
            numbers[index] += numbers[index + 1];
        }
        numbers[last] <<= last;
    }
    Some((left, numbers.into_iter().map(whole).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn machine_numbers_halve_as_numbers_do() {
        for power in [0, 1, 40, 100, 116, 117, 118, 125, 126] {
            for length in 1..11_usize {
                for seed in 0..9_usize {
                    let top: Integer = Integer::from(1) << power;
                    let edge = |index: usize| match (index * index + seed * index + seed) % 5 {
                        0 => Integer::from(0),
                        1 => top.clone(),
                        2 => -&top,
                        3 => &top - 1,
                        _ => Integer::from(-1),
                    };
                    let row: Vec<Integer> = (0..length).map(edge).collect();
                    let halves = in_machine_numbers(&row, |own| own);
                    assert!(
                        halves.is_none_or(|own| own == one_by_one(row.clone())),
                        "{row:?}"
                    );
                }
            }
        }
        let row = [7, -3, 12].map(Integer::from);
        assert!(in_machine_numbers(&row, |own| own).is_some());
        assert!(in_machine_numbers::<Integer>(&[], |own| own).is_none());
        assert_eq!(one_by_one::<Integer>(Vec::new()), (Vec::new(), Vec::new()));
    }
}
