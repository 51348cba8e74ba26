use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic, Diagnostics, FileId, Limits, SourceMap, Span};
use crate::syntax::ast::{Declaration, Document};
use crate::syntax::{decode, parse};

/// The files of one compilation, the root first.
#[derive(Debug, Default)]
pub(super) struct Loaded {
    pub(super) sources: SourceMap,
    pub(super) documents: Vec<Document>,
    pub(super) diagnostics: Diagnostics,
    /// Where the files lie, by their number; standard input has no place.
    pub(super) paths: Vec<Option<PathBuf>>,
}

/// Reads and parses a file and all that it imports.
///
/// Imports are relative to the file that names them and stay inside the folder of the root file,
/// for standard input inside the working directory.
pub(super) fn load(root: &Path, limits: &Limits) -> Loaded {
    let mut loader = Loader {
        loaded: Loaded::default(),
        folder: PathBuf::new(),
        shown: PathBuf::new(),
        limits,
        chain: Vec::new(),
    };
    if root == Path::new("-") {
        match read_from(std::io::stdin().lock(), limits) {
            Ok(bytes) => {
                loader.folder = canonical(Path::new("."));
                loader.parse("<stdin>", &bytes, None, None);
            }
            Err(error) => loader.fail(format!("standard input cannot be read: {error}"), None),
        }
        return loader.loaded;
    }
    let name = root.display().to_string();
    match read(root, limits) {
        Ok(bytes) => {
            let path = canonical(root);
            loader.folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
            loader.shown = shown(root, &loader.folder);
            loader.parse(&name, &bytes, Some(path), None);
        }
        Err(error) => loader.fail(format!("`{name}` cannot be read: {error}"), None),
    }
    loader.loaded
}

/// The folder of a file as the file names it; a link may lead to another one, named in full.
fn shown(file: &Path, folder: &Path) -> PathBuf {
    let named = file.parent().unwrap_or(Path::new(""));
    if canonical(&Path::new(".").join(named)) == folder {
        return named.to_path_buf();
    }
    folder.to_path_buf()
}

/// The bytes of a file, but no more than one beyond the limit.
pub(super) fn read(path: &Path, limits: &Limits) -> std::io::Result<Vec<u8>> {
    read_from(fs::File::open(path)?, limits)
}

fn read_from(reader: impl Read, limits: &Limits) -> std::io::Result<Vec<u8>> {
    let most = u64::try_from(limits.largest_source()).unwrap_or(u64::MAX);
    let mut bytes = Vec::new();
    reader
        .take(most.saturating_add(1))
        .read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn canonical(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}

struct Loader<'a> {
    loaded: Loaded,
    /// The folder that imports must not leave.
    folder: PathBuf,
    /// That folder as messages show it, from the working directory.
    shown: PathBuf,
    limits: &'a Limits,
    /// The files that are being read, each imported by the one before.
    chain: Vec<FileId>,
}

impl Loader<'_> {
    fn fail(&mut self, message: String, span: Option<Span>) {
        let finding = match span {
            Some(span) => Diagnostic::new(Code::E0601, span, message),
            None => Diagnostic::global(Code::E0601, message),
        };
        self.loaded.diagnostics.push(finding);
    }

    /// Parses the bytes of a file, which may be imported at a place.
    fn parse(&mut self, name: &str, bytes: &[u8], path: Option<PathBuf>, site: Option<Span>) {
        let text = match decode(bytes, name, self.limits) {
            Ok(text) => text,
            Err(mut finding) => {
                finding.primary = site;
                return self.loaded.diagnostics.push(*finding);
            }
        };
        let file = self.loaded.sources.add(name, text.as_str());
        let document = parse(file, &text, self.limits, &mut self.loaded.diagnostics);
        let folder = path
            .as_deref()
            .and_then(Path::parent)
            .map(Path::to_path_buf);
        let folder = folder.unwrap_or_else(|| self.folder.clone());
        self.loaded.paths.push(path);
        let imports: Vec<(String, Span)> = document
            .items
            .iter()
            .filter_map(|item| match &item.declaration {
                Declaration::Import { path, path_span } => Some((path.clone(), *path_span)),
                _ => None,
            })
            .collect();
        self.loaded.documents.push(document);
        self.chain.push(file);
        for (target, span) in imports {
            self.import(&folder, &target, span);
        }
        self.chain.pop();
    }

    fn import(&mut self, folder: &Path, target: &str, span: Span) {
        let relative = Path::new(target);
        let joined = folder.join(relative);
        let outside = || {
            Diagnostic::new(
                Code::E0603,
                span,
                format!("`{target}` lies outside the project folder"),
            )
            .help("imports stay inside the folder of the file that is compiled")
        };
        if relative.is_absolute() {
            return self.loaded.diagnostics.push(outside());
        }
        let path = match fs::canonicalize(&joined) {
            Ok(path) => path,
            Err(error) => {
                let message = format!("`{target}` cannot be read: {error}");
                let tried = joined.strip_prefix(&self.folder).unwrap_or(&joined);
                let finding = Diagnostic::new(Code::E0601, span, message).note(format!(
                    "looked for `{}` in the project folder",
                    tried.display()
                ));
                return self.loaded.diagnostics.push(finding);
            }
        };
        if !path.starts_with(&self.folder) {
            return self.loaded.diagnostics.push(outside());
        }
        let known = self
            .loaded
            .paths
            .iter()
            .position(|own| own.as_deref() == Some(path.as_path()));
        if let Some(known) = known {
            return self.check_cycle(known, span);
        }
        if self.loaded.documents.len() > self.limits.imports {
            let message = format!("more than {} files are imported", self.limits.imports);
            let finding = Diagnostic::new(Code::E0506, span, message);
            return self
                .loaded
                .diagnostics
                .push(finding.help("raise the limit with `--max-imports`"));
        }
        if !path.is_file() {
            return self.fail(format!("`{target}` is not a file"), Some(span));
        }
        let inside = path.strip_prefix(&self.folder).unwrap_or(&path);
        let name = self.shown.join(inside).display().to_string();
        match read(&path, self.limits) {
            Ok(bytes) => self.parse(&name, &bytes, Some(path), Some(span)),
            Err(error) => self.fail(format!("`{target}` cannot be read: {error}"), Some(span)),
        }
    }

    /// A file may be imported twice, but not by one that it imports itself.
    fn check_cycle(&mut self, known: usize, span: Span) {
        let Some(start) = self.chain.iter().position(|own| own.0 as usize == known) else {
            return;
        };
        let circle = self.chain[start..].iter().chain([&self.chain[start]]);
        let names = circle.map(|own| self.loaded.sources.file(*own).name.as_str());
        let chain = names.collect::<Vec<_>>().join(" → ");
        let finding = Diagnostic::new(Code::E0604, span, "these files import each other");
        self.loaded.diagnostics.push(finding.note(chain));
    }
}
