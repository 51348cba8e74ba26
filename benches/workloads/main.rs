//! `cargo bench --bench workloads -- --set W1 [--data FILE] [--samples N] [--json]`: the workloads,
//! timed step by step through the functions that `compile` calls.
#![allow(
    clippy::float_arithmetic,
    missing_docs,
    reason = "a program whose results are times"
)]

mod record;

use std::path::PathBuf;
use std::time::Duration;

use clap::Parser;

use record::{Outcome, Parsed, Record, Set};

/// Times the workloads, from the parsed text to the doubles.
#[derive(Parser)]
struct Arguments {
    /// The set: W1, W2s, W3, W5, W6 or W7
    #[arg(long, default_value = "W1")]
    set: String,
    /// A file of records instead of a set
    #[arg(long)]
    data: Option<PathBuf>,
    /// Runs of each case, of which the median counts
    #[arg(long, default_value_t = 9)]
    samples: usize,
    /// Only cases whose names contain this
    #[arg(long, default_value = "")]
    only: String,
    /// One JSON object a line
    #[arg(long)]
    json: bool,
    /// What `cargo bench` passes
    #[arg(long, hide = true)]
    bench: bool,
}

const STEPS: [&str; 4] = ["lower", "expand", "bernstein", "round"];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments = Arguments::parse();
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("benches/workloads");
    let known = folder.join(format!("{}.json", arguments.set));
    let text = std::fs::read_to_string(arguments.data.as_ref().unwrap_or(&known))?;
    let set: Set = serde_json::from_str(&text)?;
    let mut logarithms = 0.0;
    let mut count = 0_u32;
    let wanted = |own: &&Record| own.id.contains(&arguments.only);
    for record in set.cases.iter().filter(wanted) {
        let (outcome, times) = measure(record, arguments.samples.max(1));
        let total: Duration = times.iter().sum();
        logarithms += total.as_secs_f64().ln();
        count += 1;
        println!("{}", line(record, &outcome, &times, arguments.json));
    }
    let mean = (logarithms / f64::from(count.max(1))).exp();
    if arguments.json {
        println!(
            "{}",
            serde_json::json!({"cases": count, "geometric_mean_us": mean * 1e6})
        );
    } else {
        println!("{count} cases, geometric mean {:.1} µs", mean * 1e6);
    }
    Ok(())
}

/// The outcome, and the median time of each step.
fn measure(record: &Record, samples: usize) -> (Outcome, [Duration; 4]) {
    let parsed = Parsed::new(record);
    let outcome = parsed.compile();
    let runs: Vec<_> = (0..samples).map(|_| parsed.compile().times).collect();
    let median = |step: usize| {
        let mut own: Vec<Duration> = runs.iter().map(|run| run[step]).collect();
        own.sort();
        own[own.len() / 2]
    };
    (outcome, [0, 1, 2, 3].map(median))
}

fn line(record: &Record, outcome: &Outcome, times: &[Duration; 4], json: bool) -> String {
    let micros = |own: &Duration| own.as_secs_f64() * 1e6;
    let total: f64 = times.iter().map(micros).sum();
    let expected = record.expected.as_ref();
    let agrees = expected.map(|own| own.hash == outcome.hash && own.bidegree == outcome.bidegree);
    if json {
        let steps = STEPS.iter().zip(times);
        let steps: serde_json::Map<_, _> = steps
            .map(|(name, own)| ((*name).to_owned(), micros(own).into()))
            .collect();
        return serde_json::json!({
            "id": record.id, "hash": outcome.hash, "agrees": agrees,
            "bidegree": outcome.bidegree, "common_factor": outcome.common_factor,
            "expected_common_factor": expected.map(|own| own.common_factor),
            "median_us": steps, "total_us": total,
        })
        .to_string();
    }
    let steps = STEPS.iter().zip(times);
    let steps: Vec<String> = steps
        .map(|(name, own)| format!("{name} {:.1}", micros(own)))
        .collect();
    let verdict = match agrees {
        Some(true) => "equal",
        Some(false) => "DIFFERENT",
        None => "",
    };
    let ([u, v], [a, b]) = (outcome.bidegree, outcome.common_factor);
    format!(
        "{:<28} {} {verdict:<9} ({u}, {v}) factor ({a}, {b})  {} total {total:.1} µs",
        record.id,
        outcome.hash,
        steps.join("  ")
    )
}
