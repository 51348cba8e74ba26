use std::path::{Path, PathBuf};

use crate::diag::{Diagnostics, Limits, SourceMap};
use crate::pipeline::{Compilation, Options, Step, compile_with, library};
use crate::sema::Library;
use crate::syntax::ast::Document;

use super::load::{Loaded, load};

/// A file with its imports and the standard library, parsed once and compiled as often as wanted.
#[derive(Debug)]
pub(super) struct Parsed {
    pub(super) sources: SourceMap,
    /// The root file first; none if it cannot be read.
    pub(super) documents: Vec<Document>,
    library: Library,
    pub(super) diagnostics: Diagnostics,
    /// Where the files lie, by their number; standard input has no place.
    pub(super) paths: Vec<Option<PathBuf>>,
}

impl Parsed {
    /// Reads and parses a file and all that it imports.
    pub(super) fn read(file: &Path, limits: &Limits) -> Self {
        let Loaded {
            mut sources,
            documents,
            mut diagnostics,
            paths,
        } = load(file, limits);
        let library = library(&mut sources, &mut diagnostics);
        Self {
            sources,
            documents,
            library,
            diagnostics,
            paths,
        }
    }

    /// Whether the root file could be read.
    pub(super) fn is_readable(&self) -> bool {
        !self.documents.is_empty()
    }

    /// Whether it and all its imports could be read, without errors.
    pub(super) fn is_sound(&self) -> bool {
        self.is_readable() && !self.diagnostics.has_errors()
    }

    /// Compiles the file, and tells of every step that is done.
    pub(super) fn compile(&self, options: &Options, done: &mut dyn FnMut(Step<'_>)) -> Compilation {
        let diagnostics = self.diagnostics.clone();
        if !self.is_readable() {
            return Compilation {
                diagnostics,
                ..Compilation::default()
            };
        }
        let (library, documents) = (&self.library, self.documents.as_slice());
        compile_with(
            library,
            &self.sources,
            documents,
            options,
            diagnostics,
            done,
        )
    }
}
