#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use super::occluder::Occluder;
use super::vector::{Vector, between, minus};

/// What is shorter than this, in units of the picture, is no stretch of its own.
const SPECK: f64 = 1.2;
/// How far a simplified line may be from the line.
const SLACK: f64 = 0.04;

/// A line in the plane of the picture.
pub(super) type Polyline = Vec<[f64; 2]>;

/// A line of a picture, in stretches that are seen and stretches that are hidden.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Stroke {
    pub(super) visible: Vec<Polyline>,
    pub(super) hidden: Vec<Polyline>,
}

impl Stroke {
    /// Cuts a projected line where it passes behind something.
    pub(super) fn of(line: &[Vector], occluder: &Occluder) -> Self {
        Self::beside(line, &vec![Vector::default(); line.len()], occluder)
    }

    /// As [`Stroke::of`], for a line that is looked for beside itself, by a shift for each point.
    pub(super) fn beside(line: &[Vector], shifts: &[Vector], occluder: &Occluder) -> Self {
        let mut pieces: Vec<(bool, Polyline)> = Vec::new();
        let mut add = |is_hidden: bool, from: Vector, to: Vector| {
            let [from, to] = [from, to].map(|own| [own[0], own[1]]);
            match pieces.last_mut() {
                Some((last, points)) if *last == is_hidden && points.last() == Some(&from) => {
                    points.push(to);
                }
                _ => pieces.push((is_hidden, vec![from, to])),
            }
        };
        for (pair, shift) in line.windows(2).zip(shifts.windows(2)) {
            let [from, to] = [pair[0], pair[1]];
            let shifted = [0, 1].map(|end| minus(pair[end], shift[end].map(|own| -own)));
            let at = |ratio: f64| match ratio {
                0.0 => from,
                1.0 => to,
                _ => between(from, to, ratio),
            };
            let mut seen_from = 0.0;
            for (low, high) in occluder.hidden(shifted[0], shifted[1]) {
                if seen_from < low {
                    add(false, at(seen_from), at(low));
                }
                add(true, at(low), at(high));
                seen_from = high;
            }
            if seen_from < 1.0 {
                add(false, at(seen_from), to);
            }
        }
        Self::settle(pieces)
    }

    /// Gives specks to their neighbours and simplifies.
    fn settle(pieces: Vec<(bool, Polyline)>) -> Self {
        let mut settled: Vec<(bool, Polyline)> = Vec::new();
        for (is_hidden, points) in pieces {
            match settled.last_mut() {
                Some((last, before))
                    if before.last() == points.first()
                        && (*last == is_hidden || length(&points) < SPECK) =>
                {
                    before.extend_from_slice(&points[1..]);
                }
                Some((last, before))
                    if before.last() == points.first() && length(before) < SPECK =>
                {
                    *last = is_hidden;
                    before.extend_from_slice(&points[1..]);
                }
                _ => settled.push((is_hidden, points)),
            }
        }
        let mut stroke = Self::default();
        for (is_hidden, points) in settled {
            let points = simplified(&points);
            if length(&points) == 0.0 {
                continue;
            }
            if is_hidden {
                stroke.hidden.push(points);
            } else {
                stroke.visible.push(points);
            }
        }
        stroke
    }
}

fn length(points: &[[f64; 2]]) -> f64 {
    let chords = points.windows(2).map(|pair| {
        let [x, y] = [0, 1].map(|axis| pair[1][axis] - pair[0][axis]);
        (x * x + y * y).sqrt()
    });
    chords.sum()
}

/// A line through some of the points that is nowhere farther than [`SLACK`] from the others.
fn simplified(points: &[[f64; 2]]) -> Polyline {
    let Some((first, last)) = points.first().zip(points.last()) else {
        return Polyline::new();
    };
    let chord = [last[0] - first[0], last[1] - first[1]];
    let square = chord[0] * chord[0] + chord[1] * chord[1];
    let distance = |own: &[f64; 2]| {
        let offset = [own[0] - first[0], own[1] - first[1]];
        let along = offset[0] * chord[0] + offset[1] * chord[1];
        let ratio = if square > 0.0 {
            (along / square).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let [x, y] = [0, 1].map(|axis| offset[axis] - ratio * chord[axis]);
        x * x + y * y
    };
    let inner = 1..points.len().saturating_sub(1);
    let farthest = inner.max_by(|a, b| distance(&points[*a]).total_cmp(&distance(&points[*b])));
    match farthest {
        Some(index) if distance(&points[index]) > SLACK * SLACK => {
            let mut line = simplified(&points[..=index]);
            line.pop();
            line.extend(simplified(&points[index..]));
            line
        }
        _ => vec![*first, *last],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_cut_where_it_passes_behind() {
        let depth = 5.0;
        let corner = |x: f64, y: f64| [x, y, depth];
        let [a, b, c, d] = [
            corner(4.0, 0.0),
            corner(12.0, 0.0),
            corner(12.0, 8.0),
            corner(4.0, 8.0),
        ];
        let square = Occluder::new(vec![[a, b, c], [a, c, d]]);
        let line: Vec<Vector> = (0..=4_u8).map(|x| [4.0 * f64::from(x), 4.0, 0.0]).collect();
        let stroke = Stroke::of(&line, &square);
        assert_eq!(
            stroke.visible,
            [[[0.0, 4.0], [4.0, 4.0]], [[12.0, 4.0], [16.0, 4.0]]]
        );
        assert_eq!(stroke.hidden, [[[4.0, 4.0], [12.0, 4.0]]]);
    }

    #[test]
    fn specks_are_no_stretches() {
        let piece = |from: f64, to: f64| vec![[from, 0.0], [to, 0.0]];
        let stroke = Stroke::settle(vec![
            (false, piece(0.0, 10.0)),
            (true, piece(10.0, 11.0)),
            (false, piece(11.0, 20.0)),
            (true, piece(20.0, 30.0)),
        ]);
        assert_eq!(stroke.visible, [piece(0.0, 20.0)]);
        assert_eq!(stroke.hidden, [piece(20.0, 30.0)]);
    }
}
