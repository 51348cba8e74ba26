//! What the times of a set say together.

use std::collections::BTreeMap;
use std::time::Duration;

/// The smallest m from which the growth is measured.
const GROWING_FROM: usize = 4;

/// Geometric means of the times, and how they grow with m.
#[derive(Default)]
pub(crate) struct Summary {
    count: u32,
    /// Sums of the logarithms of the times.
    logarithms: [f64; 3],
    /// (m, ln time) of the cases of one kind and one k.
    growth: BTreeMap<String, Vec<(usize, f64)>>,
}

/// The growth of one kind and one k: time ~ m^exponent.
pub(crate) struct Growth {
    pub(crate) group: String,
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) exponent: f64,
}

impl Summary {
    /// Takes the total time of a case, that from its numbers on, and that from its surface on.
    pub(crate) fn add(&mut self, id: &str, m: usize, times: [Duration; 3]) {
        let logarithms = times.map(|own| own.as_secs_f64().ln());
        self.count += 1;
        for (sum, own) in self.logarithms.iter_mut().zip(logarithms) {
            *sum += own;
        }
        if m >= GROWING_FROM {
            let group = id.replace(&format!("-m{m}-"), "-");
            let points = self.growth.entry(group).or_default();
            points.push((m, logarithms[0]));
        }
    }

    pub(crate) fn cases(&self) -> u32 {
        self.count
    }

    /// The geometric means in microseconds, in the order in which they came.
    pub(crate) fn means(&self) -> [f64; 3] {
        let count = f64::from(self.count.max(1));
        self.logarithms.map(|own| (own / count).exp() * 1e6)
    }

    /// The slopes of ln time over ln m by least squares, for groups with at least three m.
    pub(crate) fn growths(&self) -> Vec<Growth> {
        let groups = self.growth.iter();
        groups
            .filter(|(_, points)| points.len() >= 3)
            .filter_map(|(group, points)| {
                Some(Growth {
                    group: group.clone(),
                    from: points.iter().map(|own| own.0).min()?,
                    to: points.iter().map(|own| own.0).max()?,
                    exponent: slope(points)?,
                })
            })
            .collect()
    }
}

/// Σ (x − x̄)(y − ȳ) / Σ (x − x̄)² with x = ln m; none if all m are equal.
fn slope(points: &[(usize, f64)]) -> Option<f64> {
    let points: Option<Vec<(f64, f64)>> = points
        .iter()
        .map(|(m, y)| Some((f64::from(u32::try_from(*m).ok()?).ln(), *y)))
        .collect();
    let points = points?;
    let count = f64::from(u32::try_from(points.len()).ok()?);
    let mean_x = points.iter().map(|own| own.0).sum::<f64>() / count;
    let mean_y = points.iter().map(|own| own.1).sum::<f64>() / count;
    let above: f64 = points
        .iter()
        .map(|(x, y)| (x - mean_x) * (y - mean_y))
        .sum();
    let below: f64 = points.iter().map(|(x, _)| (x - mean_x).powi(2)).sum();
    (below > 0.0).then(|| above / below)
}
