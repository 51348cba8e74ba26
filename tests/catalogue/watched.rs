//! The compiler under watch.

use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The longest that any run may take.
const PATIENCE: Duration = Duration::from_secs(20);

/// A run that has ended by itself.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) status: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Run {
    /// The codes of the findings on standard error, in their order.
    pub(crate) fn codes(&self) -> Vec<&str> {
        let lines = self.err.lines();
        let codes = lines.filter_map(|line| {
            let rest = line
                .strip_prefix("error[")
                .or_else(|| line.strip_prefix("warning["))?;
            rest.get(..5)
        });
        codes.collect()
    }
}

/// The compiler as a command in a folder, with no more than 4 GiB of memory where the system can
/// hold it to that.
pub(crate) fn command(folder: &Path) -> Command {
    let program = env!("CARGO_BIN_EXE_sweepc");
    let mut command = if cfg!(target_os = "linux") {
        let mut shell = Command::new("sh");
        let limited = r#"ulimit -v 4194304 && exec "$0" "$@""#;
        shell.args(["-c", limited, program]);
        shell
    } else {
        Command::new(program)
    };
    command.current_dir(folder).env_remove("NO_COLOR");
    command
}

/// Runs the compiler in a folder, with additions to its environment.
pub(crate) fn sweepc(folder: &Path, arguments: &[&str], environment: &[(&str, &str)]) -> Run {
    let mut command = command(folder);
    command.args(arguments).envs(environment.iter().copied());
    finish(command)
}

/// Runs a command to its end, which must be its own: no panic, no signal, and soon.
pub(crate) fn finish(mut command: Command) -> Run {
    let folder = tempfile::TempDir::new().unwrap();
    let file = |name: &str| std::fs::File::create(folder.path().join(name)).unwrap();
    let mut child = command
        .stdin(Stdio::null())
        .stdout(file("out"))
        .stderr(file("err"))
        .spawn()
        .unwrap();
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if start.elapsed() > PATIENCE {
            child.kill().unwrap();
            panic!("{command:?} takes more than {PATIENCE:?}");
        }
        sleep(Duration::from_millis(2));
    };
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    let text = |name: &str| String::from_utf8(read(name)).unwrap();
    let (out, err) = (text("out"), text("err"));
    assert!(!err.contains("panicked"), "{command:?}\n{err}");
    let Some(status) = status.code() else {
        panic!("{command:?} died: {status}\n{err}");
    };
    Run { status, out, err }
}
