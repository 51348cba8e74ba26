use std::sync::LazyLock;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// How long a run lasts before it says what it is at.
const PATIENCE: Duration = Duration::from_secs(1);

/// The one line of the one terminal; it hides where standard error is none.
static LINE: LazyLock<ProgressBar> =
    LazyLock::new(|| ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()));

/// One file is worked on.
pub(super) fn begin(name: &str) {
    style("{elapsed} {msg}");
    LINE.set_message(name.to_owned());
}

/// The file, where one is worked on.
pub(super) fn file() -> Option<String> {
    Some(LINE.message()).filter(|own| !own.is_empty())
}

/// Some files are worked on.
pub(super) fn begin_files(count: usize) {
    style("{elapsed} {pos} of {len} files");
    LINE.set_length(count as u64);
}

/// Some variants are worked on.
pub(super) fn begin_variants(count: usize) {
    style("{elapsed} {pos} of {len} variants");
    LINE.set_length(count as u64);
}

/// One of the files or variants is done.
pub(super) fn advance() {
    LINE.inc(1);
}

/// Shows the line, or draws it anew, once the run has lasted for a while.
pub(super) fn show(elapsed: Duration) {
    if elapsed < PATIENCE {
        return;
    }
    if LINE.is_hidden() {
        LINE.set_draw_target(ProgressDrawTarget::stderr());
    }
    LINE.tick();
}

/// Writes something else to the terminal.
pub(super) fn suspend<T>(write: impl FnOnce() -> T) -> T {
    LINE.suspend(write)
}

/// Takes the line away.
pub(super) fn end() {
    LINE.finish_and_clear();
}

fn style(template: &str) {
    if let Ok(style) = ProgressStyle::with_template(template) {
        LINE.set_style(style);
    }
}
