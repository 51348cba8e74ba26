use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};

use crate::cli::arguments::{Arguments, CompileArguments};
use crate::cli::compile::{complete, folder};
use crate::cli::emit::Emit;
use crate::cli::output::{file_name, stem};
use crate::cli::parsed::Parsed;
use crate::cli::refusal::Refusal;
use crate::cli::session::{Misuse, check_parameter, curves, options, parameters, surfaces};
use crate::diag::{Diagnostics, Limits};
use crate::pipeline::Options;

use super::output::canonical;
use super::variants::Variants;

/// A file whose variants are compiled.
#[derive(Debug)]
pub(super) struct Input {
    pub(super) file: PathBuf,
    /// The name that reports and tables show.
    pub(super) shown: String,
    pub(super) stem: OsString,
    /// Where its files are written.
    pub(super) folder: PathBuf,
    /// The options of all its variants.
    pub(super) options: Options,
    /// The number of its first variant among those of all files.
    pub(super) first: usize,
    /// How many variants it has: one, and that without values, if it has errors of syntax.
    pub(super) count: usize,
    /// Whether it has the values of the variants.
    pub(super) is_varied: bool,
    /// Where it and its imports lie.
    pub(super) paths: Vec<PathBuf>,
    pub(super) curves: Vec<String>,
    surfaces: Vec<String>,
    /// The tree, where it is needed more than once; else it is read again.
    kept: Option<Parsed>,
}

impl Input {
    /// Reads a file and finds out whether it fits the command line.
    ///
    /// # Errors
    ///
    /// A parameter or surface that it does not declare. Parameters of the list are findings.
    pub(super) fn read(
        file: &Path,
        variants: &Variants,
        emit: &Emit,
        own: &CompileArguments,
        arguments: &Arguments,
        findings: &mut Diagnostics,
    ) -> Result<Self, Refusal> {
        let parsed = Parsed::read(file, &arguments.limits());
        let documents = parsed.documents.as_slice();
        let mut options = options(arguments, &parsed, file)?;
        complete(&mut options, emit, own);
        let is_sound = parsed.is_sound();
        if is_sound {
            for name in variants.grid() {
                check_parameter(name, documents, file)?;
            }
            if let Some(list) = &variants.list {
                findings.extend(list.unknown(&parameters(documents), file));
            }
        }
        let owned = |own: Vec<&str>| own.into_iter().map(str::to_owned).collect();
        let is_varied = is_sound && !variants.names.is_empty();
        let count = if is_varied { variants.count() } else { 1 };
        Ok(Self {
            file: file.to_path_buf(),
            shown: file_name(file),
            stem: stem(file).to_owned(),
            folder: folder(file, own),
            options,
            first: 0,
            count,
            is_varied,
            paths: parsed.paths.iter().flatten().cloned().collect(),
            curves: owned(curves(documents)),
            surfaces: owned(surfaces(documents)),
            kept: (count > 1 || own.files.len() == 1 || file == Path::new("-")).then_some(parsed),
        })
    }

    /// Works on the tree of the file.
    pub(super) fn with_parsed<T>(&self, limits: &Limits, work: impl FnOnce(&Parsed) -> T) -> T {
        match &self.kept {
            Some(parsed) => work(parsed),
            None => work(&Parsed::read(&self.file, limits)),
        }
    }

    /// Whether both write files of the same names.
    fn meets(&self, other: &Self, emit: &Emit) -> bool {
        if canonical(&self.folder) != canonical(&other.folder) {
            return false;
        }
        let joint = emit.formats.iter().any(|own| own.several);
        let of_surface = |name: &String| {
            let mut own = self.stem.clone();
            own.push(format!("-{name}"));
            own == other.stem
        };
        self.stem == other.stem
            || (joint && !self.is_varied && self.surfaces.iter().any(of_surface))
    }
}

/// Refuses files whose results would have the same names.
///
/// # Errors
///
/// Two of them.
pub(super) fn check_names(inputs: &[Input], emit: &Emit) -> Result<(), Misuse> {
    let mut by_length: Vec<&Input> = inputs.iter().collect();
    by_length.sort_by(|one, other| one.stem.cmp(&other.stem));
    for (index, one) in by_length.iter().enumerate() {
        let begins = |own: &&&Input| starts_with(&own.stem, &one.stem);
        let near = by_length[index + 1..].iter().take_while(begins);
        let mut met = near.filter(|own| one.meets(own, emit));
        if let Some(other) = met.next() {
            let [one, other] = [one, other].map(|own| own.file.display().to_string());
            return Err(Misuse(format!(
                "the results of `{one}` and `{other}` have the same names"
            )));
        }
    }
    Ok(())
}

fn starts_with(name: &OsStr, start: &OsStr) -> bool {
    name.as_encoded_bytes()
        .starts_with(start.as_encoded_bytes())
}
