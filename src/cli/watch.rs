use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use crate::diag::{Code, Diagnostic};

use super::interrupt::Interrupt;
use super::progress;
use super::refusal::Refusal;
use super::status::Status;
use super::voice::Voice;

/// How often memory and signals are looked at.
const INTERVAL: Duration = Duration::from_millis(50);

/// What a run may take.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    pub(super) seconds: u64,
    pub(super) mebibytes: u64,
}

/// Waits for the work to end, but no longer than the budget allows and the user wants; none if the
/// work broke off.
///
/// Memory is watched where the system tells how much a process holds.
pub(super) fn watch(
    done: &Receiver<Status>,
    budget: Budget,
    interrupt: &Interrupt,
    voice: Voice,
) -> Option<Status> {
    let start = Instant::now();
    let most = Duration::from_secs(budget.seconds);
    loop {
        match done.recv_timeout(INTERVAL.min(most)) {
            Ok(status) => return Some(status),
            Err(RecvTimeoutError::Disconnected) => return None,
            Err(RecvTimeoutError::Timeout) => {}
        }
        if interrupt.is_asked() {
            return Some(Status::Interrupted);
        }
        if !voice.is_quiet {
            progress::show(start.elapsed());
        }
        let finding = if start.elapsed() >= most {
            excess(&seconds(budget.seconds), "--max-seconds")
        } else if resident_mebibytes().is_some_and(|own| own > budget.mebibytes) {
            let memory = format!("{} MiB of memory", budget.mebibytes);
            excess(&memory, "--max-memory")
        } else {
            continue;
        };
        return Some(Refusal::from(finding).complain(voice));
    }
}

/// E0508; it names the file where the run has only one.
fn excess(limit: &str, option: &str) -> Diagnostic {
    let what = progress::file().map_or_else(|| "this run".to_owned(), |own| format!("`{own}`"));
    let message = format!("{what} takes more than {limit}");
    Diagnostic::global(Code::E0508, message).help(format!("`{option}` raises the limit"))
}

fn seconds(count: u64) -> String {
    match count {
        1 => "1 second".to_owned(),
        _ => format!("{count} seconds"),
    }
}

/// The memory that this process holds.
fn resident_mebibytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmRSS:"))?;
    let kibibytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kibibytes / 1024)
}
