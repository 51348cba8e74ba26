//! `cargo bench --bench workloads -- --set W1 [--data FILE] [--samples N] [--json]`: the workloads,
//! timed step by step through the functions that `compile` calls.
#![allow(
    clippy::float_arithmetic,
    missing_docs,
    reason = "a program whose results are times"
)]

mod curves;
mod grid;
mod record;
mod summary;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Parser;
use serde_json::json;

use grid::Grid;
use record::{Expected, Outcome, Parsed, Record, STEPS, Set};
use summary::Summary;

/// That of the program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Times the workloads, from the parsed text to the doubles.
#[derive(Parser)]
struct Arguments {
    /// The set: W1, W2s, W2ds, W3, W4 (a grid on a surface), W5 (its first 1,000 cases), W6 or W7
    #[arg(long, default_value = "W1")]
    set: String,
    /// A file of records instead of a set
    #[arg(long)]
    data: Option<PathBuf>,
    /// A file that maps names of cases to what is expected of them
    #[arg(long)]
    expected: Option<PathBuf>,
    /// Runs of each case, of which the median counts
    #[arg(long, default_value_t = 9)]
    samples: usize,
    /// Run each case once and only once, for counts of instructions
    #[arg(long, conflicts_with = "samples")]
    once: bool,
    /// Only the case of this name, or else those whose names contain it
    #[arg(long, default_value = "")]
    only: String,
    /// Only so many cases
    #[arg(long)]
    first: Option<usize>,
    /// One JSON object a line
    #[arg(long)]
    json: bool,
    /// What `cargo bench` passes
    #[arg(long, hide = true)]
    bench: bool,
}

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

fn main() -> Fallible<()> {
    let arguments = Arguments::parse();
    if arguments.set == "W4" {
        return grid(&arguments);
    }
    sweeps(&arguments)
}

/// Times the points and normals of the first surface of W1 on a grid.
fn grid(arguments: &Arguments) -> Fallible<()> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("benches/workloads");
    let set: Set = read(&folder.join("W1.json"))?;
    let record = set.cases.first().ok_or("W1 has no case")?;
    let grid = Grid::measure(record, arguments.samples).ok_or("a number beyond the doubles")?;
    let (sum, time) = (format!("{:.5}", grid.sum), micros(grid.time));
    if arguments.json {
        let line = json!({"id": "W4", "points": grid.points, "sum": sum, "total_us": time});
        println!("{line}");
    } else {
        println!(
            "W4 {} points with normals, sum {sum}, {time:.0} µs",
            grid.points
        );
    }
    Ok(())
}

/// Times the compilation of every record of a set.
fn sweeps(arguments: &Arguments) -> Fallible<()> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("benches/workloads");
    let known = folder.join(format!("{}.json", arguments.set));
    let set: Set = read(arguments.data.as_ref().unwrap_or(&known))?;
    let expected: HashMap<String, Expected> = match &arguments.expected {
        Some(path) => read(path)?,
        None => HashMap::new(),
    };
    let is_name = set.cases.iter().any(|own| own.id == arguments.only);
    let wanted =
        |own: &&Record| own.id == arguments.only || (!is_name && own.id.contains(&arguments.only));
    let samples = if arguments.once {
        0
    } else {
        arguments.samples.max(1)
    };
    let records = set.cases.iter().filter(wanted);
    let mut summary = Summary::default();
    let mut different = 0;
    for record in records.take(arguments.first.unwrap_or(usize::MAX)) {
        let case = Case::measure(record, samples);
        let expected = record.expected.as_ref().or(expected.get(&record.id));
        summary.add(&record.id, record.m, case.times());
        different += u32::from(case.agrees(expected) == Some(false));
        println!("{}", case.line(record, expected, arguments.json));
    }
    println!("{}", conclusion(&summary, different, arguments.json));
    if different > 0 {
        return Err(format!("{different} cases differ from what is expected").into());
    }
    Ok(())
}

fn read<T: serde::de::DeserializeOwned>(path: &Path) -> Fallible<T> {
    let text = std::fs::read_to_string(path);
    let text = text.map_err(|own| format!("{}: {own}", path.display()))?;
    Ok(serde_json::from_str(&text)?)
}

/// The steps of a compilation, and the curves alone.
type Run = ([Duration; STEPS.len()], Duration);

/// A compiled record with its median times.
struct Case {
    outcome: Outcome,
    steps: [Duration; STEPS.len()],
    total: Duration,
    /// From the numbers in memory on, as peers are timed: the curves instead of `lower`.
    same_work: Duration,
    /// From the surface in memory on: without names, types, the numbers and the curves of the text.
    without_lower: Duration,
}

impl Case {
    fn measure(record: &Record, samples: usize) -> Self {
        let parsed = Parsed::new(record);
        let outcome = parsed.compile();
        let run = |_| (parsed.compile().times, parsed.curves(&outcome));
        let mut runs: Vec<_> = (0..samples).map(run).collect();
        if runs.is_empty() {
            runs.push((outcome.times, Duration::ZERO));
        }
        let algebra = |run: &Run| run.0[1..].iter().sum::<Duration>();
        let median = |time: &dyn Fn(&Run) -> Duration| {
            let mut own: Vec<Duration> = runs.iter().map(time).collect();
            own.sort();
            own[own.len() / 2]
        };
        Self {
            outcome,
            steps: std::array::from_fn(|step| median(&|run| run.0[step])),
            total: median(&|run| run.0.iter().sum()),
            same_work: median(&|run| run.1 + algebra(run)),
            without_lower: median(&algebra),
        }
    }

    /// The total, that of the same work, and that without `lower`.
    fn times(&self) -> [Duration; 3] {
        [self.total, self.same_work, self.without_lower]
    }

    fn agrees(&self, expected: Option<&Expected>) -> Option<bool> {
        let Outcome { hash, bidegree, .. } = &self.outcome;
        expected.map(|own| own.hash == *hash && own.bidegree == *bidegree)
    }

    fn line(&self, record: &Record, expected: Option<&Expected>, json: bool) -> String {
        let (id, outcome, agrees) = (&record.id, &self.outcome, self.agrees(expected));
        let steps = STEPS.iter().zip(self.steps.map(micros));
        if json {
            let steps: serde_json::Map<_, _> = steps
                .map(|(name, own)| ((*name).to_owned(), own.into()))
                .collect();
            return json!({
                "id": id, "hash": outcome.hash, "agrees": agrees,
                "bidegree": outcome.bidegree, "common_factor": outcome.common_factor,
                "expected_common_factor": expected.map(|own| own.common_factor),
                "median_us": steps, "total_us": micros(self.total),
                "same_work_us": micros(self.same_work),
                "without_lower_us": micros(self.without_lower),
            })
            .to_string();
        }
        let steps: Vec<String> = steps
            .map(|(name, own)| format!("{name} {own:.1}"))
            .collect();
        let verdict = match agrees {
            Some(true) => "equal",
            Some(false) => "DIFFERENT",
            None => "",
        };
        let ([u, v], [a, b]) = (outcome.bidegree, outcome.common_factor);
        format!(
            "{id:<28} {} {verdict:<9} ({u}, {v}) factor ({a}, {b})  {}  total {:.1} µs",
            outcome.hash,
            steps.join("  "),
            micros(self.total)
        )
    }
}

/// The geometric means, and the growth in m.
fn conclusion(summary: &Summary, different: u32, json: bool) -> String {
    let (cases, [total, same_work, without_lower]) = (summary.cases(), summary.means());
    let growths = summary.growths();
    if json {
        let growths: Vec<_> = growths
            .iter()
            .map(|own| {
                json!({
                    "cases": own.group, "m": [own.from, own.to], "exponent": own.exponent,
                })
            })
            .collect();
        return json!({
            "cases": cases, "different": different, "geometric_mean_us": total,
            "geometric_mean_same_work_us": same_work,
            "geometric_mean_without_lower_us": without_lower, "growth": growths,
        })
        .to_string();
    }
    let mut text = format!(
        "{cases} cases, geometric mean {total:.1} µs, from numbers in memory {same_work:.1} µs, without lower {without_lower:.1} µs"
    );
    for own in growths {
        text += &format!(
            "\n{:<28} time ~ m^{:.2} from m = {} to {}",
            own.group, own.exponent, own.from, own.to
        );
    }
    text
}

fn micros(own: Duration) -> f64 {
    own.as_secs_f64() * 1e6
}
