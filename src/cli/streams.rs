use std::io::{self, ErrorKind, Write};

use super::progress::suspend;
use super::status::Status;

/// Writes results to standard output. A reader that has gone away ends the output quietly; a
/// stream that takes no more for another reason is a file that cannot be written.
pub(super) fn print(text: &str) -> Status {
    let written = suspend(|| {
        let mut stdout = io::stdout().lock();
        stdout
            .write_all(text.as_bytes())
            .and_then(|()| stdout.flush())
    });
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            complain(&format!("standard output cannot be written: {error}"));
            Status::File
        }
        _ => Status::Success,
    }
}

/// Writes text to standard error.
pub(super) fn tell(text: &str) {
    let _ = suspend(|| io::stderr().write_all(text.as_bytes()));
}

/// One line to standard error.
pub(super) fn complain(message: &str) {
    tell(&format!("sweepc: {message}\n"));
}
