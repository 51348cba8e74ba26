use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::export::{ALL, Exporter};
use crate::report::render_json;

use super::arguments::{Arguments, CompileArguments};
use super::output::{file_name, named, stem};
use super::progress;
use super::report::require_surfaces;
use super::session::Session;
use super::staged::Staged;
use super::status::Status;
use super::streams::{complain, print, tell};
use super::voice::Voice;

/// `sweepc compile FILE`
pub(super) fn run(own: &CompileArguments, arguments: &Arguments) -> Status {
    let Some(emit) = Emit::of(&own.emit) else {
        return Status::Usage;
    };
    progress::begin(&file_name(&own.file));
    let mut session = match Session::open(&own.file, arguments, own.allow_weight_ratio) {
        Ok(session) => session,
        Err(misuse) => return misuse.complain(),
    };
    session.options.view = own.view.clone();
    session.options.step_schema = own.step_schema.into();
    session.options.iges_trimmed = own.iges_trimmed;
    require_surfaces(&mut session, &own.file);
    let files = if keeps_files(&session.compilation.diagnostics) {
        build(&mut session, own, &emit)
    } else {
        Vec::new()
    };
    session.stopwatch.lap("nets and files made");
    let written = match write(&session, own, files) {
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
        tell(&session.stopwatch.lines(&file_name(&own.file)));
    }
    let status = Status::of(&session.compilation.diagnostics);
    if voice.is_quiet {
        return status;
    }
    let list = written.iter().map(|path| format!("{}\n", path.display()));
    status.max(print(&list.collect::<String>()))
}

/// What is asked for.
struct Emit {
    report: bool,
    formats: Vec<&'static Exporter>,
}

impl Emit {
    fn of(words: &[String]) -> Option<Self> {
        let mut emit = Self {
            report: false,
            formats: Vec::new(),
        };
        for word in words
            .iter()
            .map(|own| own.trim())
            .filter(|own| !own.is_empty())
        {
            match ALL.iter().find(|format| format.name == word) {
                Some(format) if emit.formats.iter().all(|own| own.name != word) => {
                    emit.formats.push(format)
                }
                Some(_) => {}
                None if word == "report" => emit.report = true,
                None => {
                    let names: Vec<&str> = ALL.iter().map(|format| format.name).collect();
                    complain(&format!(
                        "`{word}` is no output format; there are: report, {}",
                        names.join(", ")
                    ));
                    return None;
                }
            }
        }
        if !emit.report && emit.formats.is_empty() {
            complain("`--emit` names no output format");
            return None;
        }
        Some(emit)
    }
}

/// Errors of single surfaces spoil only their own files; any other error spoils all.
fn keeps_files(diagnostics: &Diagnostics) -> bool {
    diagnostics
        .errors()
        .all(|own| own.code.as_str().starts_with("E03") && own.code != Code::E0303)
}

/// The files of a compilation, by name; refusals and warnings go to the findings.
fn build(session: &mut Session, own: &CompileArguments, emit: &Emit) -> Vec<(OsString, Vec<u8>)> {
    let stem = stem(&own.file);
    let shown = stem.to_string_lossy();
    let mut files = Vec::new();
    let mut findings = Vec::new();
    let compilation = &session.compilation;
    if emit.report {
        match render_json(&compilation.report(&file_name(&own.file), &session.sources)) {
            Ok(text) => files.push((named(stem, ".report.json"), text.into_bytes())),
            Err(error) => findings.push(Diagnostic::global(Code::E0602, error.to_string())),
        }
    }
    for surface in compilation.sound_surfaces() {
        let span = surface.definition().span;
        let exports = compilation.export(surface, &emit.formats, &shown, &session.options);
        for (format, result) in exports {
            match result {
                Ok(exported) => {
                    findings.extend(exported.warnings.into_iter().map(|own| own.at(span)));
                    let ending = format!("-{}.{}", surface.name(), format.extension);
                    files.push((named(stem, &ending), exported.bytes));
                }
                Err(finding) => findings.push(*finding),
            }
        }
    }
    let together = compilation.export_together(&emit.formats, &shown, &session.options);
    for (format, result) in together {
        match result {
            // What is odd about a surface is told with its own file.
            Ok(exported) => {
                let name = named(stem, &format!(".{}", format.extension));
                files.push((name, exported.bytes));
            }
            Err(finding) => findings.push(*finding),
        }
    }
    session.compilation.diagnostics.extend(findings);
    files
}

/// Writes all files or none.
fn write(
    session: &Session,
    own: &CompileArguments,
    files: Vec<(OsString, Vec<u8>)>,
) -> Result<Vec<PathBuf>, Box<Diagnostic>> {
    if files.is_empty() {
        return Ok(Vec::new());
    }
    let folder = folder(own);
    let failed = |path: &Path, error: &std::io::Error| {
        let message = format!("`{}` cannot be written: {error}", path.display());
        Box::new(Diagnostic::global(Code::E0602, message))
    };
    if folder.is_file() {
        let message = format!("`{}` is a file: `-o` names a folder", folder.display());
        return Err(Box::new(Diagnostic::global(Code::E0602, message)));
    }
    let mut staged = Staged::default();
    staged
        .folder(&folder)
        .map_err(|error| failed(&folder, &error))?;
    for (name, bytes) in files {
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

/// The folder asked for, or that of the file; for standard input the working directory.
fn folder(own: &CompileArguments) -> PathBuf {
    match &own.output {
        Some(folder) => folder.clone(),
        None => own.file.parent().map(Path::to_path_buf).unwrap_or_default(),
    }
}

fn is_input(session: &Session, path: &Path) -> bool {
    let canonical = fs::canonicalize(path).ok();
    canonical.is_some_and(|path| session.paths.iter().flatten().any(|own| *own == path))
}
