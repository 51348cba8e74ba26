use std::fs;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic};
use crate::pipeline::Options;

use super::arguments::{Arguments, CompileArguments};
use super::batch;
use super::emit::{Emit, Product, keeps_files};
use super::output::{file_name, stem};
use super::progress;
use super::report::require_surfaces;
use super::session::Session;
use super::staged::Staged;
use super::status::Status;
use super::streams::{print, tell};
use super::voice::Voice;

/// `sweepc compile FILE…`
pub(super) fn run(own: &CompileArguments, arguments: &Arguments, stack: usize) -> Status {
    let emit = match Emit::of(own, &arguments.limits()) {
        Ok(emit) => emit,
        Err(refusal) => return refusal.complain(Voice::of(arguments)),
    };
    match own.files.as_slice() {
        [file] if own.grid.is_empty() && own.list.is_none() && !emit.table => {
            compile(file, &emit, own, arguments)
        }
        _ => batch::run(&emit, own, arguments, stack),
    }
}

/// Compiles one file as it stands.
fn compile(file: &Path, emit: &Emit, own: &CompileArguments, arguments: &Arguments) -> Status {
    progress::begin(&file_name(file));
    let mut session = match Session::open(file, arguments) {
        Ok(session) => session,
        Err(refusal) => return refusal.complain(Voice::of(arguments)),
    };
    complete(&mut session.options, emit, own);
    require_surfaces(&mut session.compilation, session.readable, file);
    let files = if keeps_files(&session.compilation.diagnostics) {
        let (products, findings) = emit.products(
            &session.compilation,
            &session.sources,
            &file_name(file),
            stem(file),
            &session.options,
        );
        session.compilation.diagnostics.extend(findings);
        products
    } else {
        Vec::new()
    };
    session.stopwatch.lap("nets and files made");
    let written = match write(&session, &folder(file, own), files) {
        Ok(written) => written,
        Err(finding) => {
            session.compilation.diagnostics.push(*finding);
            Vec::new()
        }
    };
    session.stopwatch.lap("files written");
    let voice = Voice::of(arguments);
    voice.tell(&session.compilation.diagnostics, &session.sources);
    if voice.is_verbose {
        tell(&session.stopwatch.lines(&file_name(file)));
    }
    let status = Status::of(&session.compilation.diagnostics);
    if voice.is_quiet {
        return status;
    }
    let list = written.iter().map(|path| format!("{}\n", path.display()));
    status.max(print(&list.collect::<String>()))
}

/// Writes all files or none.
fn write(
    session: &Session,
    folder: &Path,
    files: Vec<Product>,
) -> Result<Vec<PathBuf>, Box<Diagnostic>> {
    if files.is_empty() {
        return Ok(Vec::new());
    }
    if folder.is_file() {
        let message = format!("`{}` is a file: `-o` names a folder", folder.display());
        return Err(Box::new(Diagnostic::global(Code::E0602, message)));
    }
    let mut staged = Staged::default();
    staged
        .folder(folder)
        .map_err(|error| failed(folder, &error))?;
    for Product { name, bytes, .. } in files {
        let path = folder.join(name);
        if is_input(session, &path) {
            let message = format!("`{}` is an input of this compilation", path.display());
            return Err(Box::new(Diagnostic::global(Code::E0602, message)));
        }
        staged
            .add(path.clone(), &bytes)
            .map_err(|error| failed(&path, &error))?;
    }
    staged
        .commit()
        .map_err(|(path, error)| failed(&path, &error))
}

/// The finding that a file could not be written.
pub(super) fn failed(path: &Path, error: &std::io::Error) -> Box<Diagnostic> {
    let message = format!("`{}` cannot be written: {error}", path.display());
    Box::new(Diagnostic::global(Code::E0602, message))
}

/// Adds what only `compile` is asked.
pub(super) fn complete(options: &mut Options, emit: &Emit, own: &CompileArguments) {
    options.any_weight_ratio = own.allow_weight_ratio;
    options.view = own.view.clone();
    options.step_schema = own.step_schema.into();
    options.iges_trimmed = own.iges_trimmed;
    options.chord.clone_from(&emit.chord);
}

/// The folder asked for, or that of the file; for standard input the working directory.
pub(super) fn folder(file: &Path, own: &CompileArguments) -> PathBuf {
    match &own.output {
        Some(folder) => folder.clone(),
        None => file.parent().map(Path::to_path_buf).unwrap_or_default(),
    }
}

fn is_input(session: &Session, path: &Path) -> bool {
    let canonical = fs::canonicalize(path).ok();
    canonical.is_some_and(|path| session.paths.iter().flatten().any(|own| *own == path))
}
