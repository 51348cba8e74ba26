use std::io;
use std::path::{Path, PathBuf};

use clap::{Command, CommandFactory};
use clap_mangen::Man;

use super::arguments::{Arguments, ManArguments};
use super::staged::Staged;
use super::status::Status;
use super::streams::{complain, print};

/// `sweepc man DIR`
pub(super) fn run(own: &ManArguments, arguments: &Arguments) -> Status {
    match write(&own.folder) {
        Ok(_) if arguments.quiet => Status::Success,
        Ok(written) => {
            let list = written.iter().map(|path| format!("{}\n", path.display()));
            print(&list.collect::<String>())
        }
        Err((path, error)) => {
            complain(&format!("`{}` cannot be written: {error}", path.display()));
            Status::File
        }
    }
}

/// A page for the program and one for each of its commands.
fn write(folder: &Path) -> Result<Vec<PathBuf>, (PathBuf, io::Error)> {
    let mut program = Arguments::command().disable_help_subcommand(true);
    program.build();
    let commands: Vec<Command> = program.get_subcommands().cloned().collect();
    let mut staged = Staged::default();
    let failed = |path: &Path| {
        let path = path.to_path_buf();
        move |error| (path, error)
    };
    staged.folder(folder).map_err(failed(folder))?;
    for command in std::iter::once(program).chain(commands) {
        let name = command.get_display_name().unwrap_or(command.get_name());
        let path = folder.join(format!("{name}.1"));
        let mut page = Vec::new();
        let made = Man::new(command).render(&mut page);
        made.and_then(|()| staged.add(path.clone(), &page))
            .map_err(failed(&path))?;
    }
    staged.commit()
}
