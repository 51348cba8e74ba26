use std::time::{Duration, Instant};

/// The time that each stage of a run took.
#[derive(Debug)]
pub(super) struct Stopwatch {
    since: Instant,
    laps: Vec<(String, Duration)>,
}

impl Stopwatch {
    /// Begins the first stage.
    pub(super) fn start() -> Self {
        Self {
            since: Instant::now(),
            laps: Vec::new(),
        }
    }

    /// Ends a stage and begins the next.
    pub(super) fn lap(&mut self, stage: impl Into<String>) {
        let now = Instant::now();
        self.laps.push((stage.into(), now - self.since));
        self.since = now;
    }

    /// A line for each stage of the work on a file.
    pub(super) fn lines(&self, file: &str) -> String {
        let lines = self.laps.iter().map(|(stage, time)| {
            let (seconds, milliseconds) = (time.as_secs(), time.subsec_millis());
            format!("sweepc: {seconds:>3}.{milliseconds:03} s  {file}: {stage}\n")
        });
        lines.collect()
    }
}
