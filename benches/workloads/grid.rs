//! `--set W4`: points and unit normals of the first surface of W1 on a grid, in doubles.

use std::time::{Duration, Instant};

use sweepc::export::Samples;

use crate::record::{Parsed, Record};

/// Parameters along u and along v.
const COUNT: [usize; 2] = [1_000, 1_000];

/// The sum of all coordinates, and the median time from the exact net to the last normal.
pub(crate) struct Grid {
    pub(crate) points: usize,
    pub(crate) sum: f64,
    pub(crate) time: Duration,
}

impl Grid {
    /// Samples the surface of a record so many times; none if it has no doubles.
    pub(crate) fn measure(record: &Record, samples: usize) -> Option<Self> {
        let net = Parsed::new(record).compile().net;
        let mut times = Vec::new();
        let mut last = None;
        for _ in 0..samples.max(1) {
            let start = Instant::now();
            let points = Samples::new(&net, COUNT)?.points();
            times.push(start.elapsed());
            last = Some(points);
        }
        times.sort();
        let points = last?;
        Some(Self {
            points: points.len(),
            sum: points.iter().flatten().sum(),
            time: times[times.len() / 2],
        })
    }
}
