use std::collections::{BTreeSet, HashSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::thread::JoinHandle;

use crate::cli::arguments::CompileArguments;
use crate::cli::compile::failed;
use crate::cli::staged::Staged;
use crate::cli::status::Status;
use crate::cli::streams::{complain, print, tell};
use crate::cli::voice::Voice;
use crate::diag::{Code, Diagnostic, Diagnostics, SourceMap};

use super::input::Input;
use super::row::Row;
use super::table::Table;
use super::variant::{Compiled, Variant};
use super::variants::Variants;

/// How many files go to the disk together.
const GROUP: usize = 2_048;
/// How many variants have their findings told; the table has the codes of all.
const TOLD: usize = 10;

type Settling = JoinHandle<Result<Vec<PathBuf>, (PathBuf, std::io::Error)>>;

/// What a batch writes and tells, in the order of its variants.
pub(super) struct Output {
    voice: Voice,
    table: Table,
    group: Staged,
    /// The group before, on its way to the disk.
    settling: Option<Settling>,
    /// The folders of results with the names that they are compared by.
    folders: Vec<(PathBuf, PathBuf)>,
    /// Files that are read and must not be written.
    read: HashSet<PathBuf>,
    told: usize,
    /// How many variants had findings that were not told.
    untold: usize,
    failures: usize,
    codes: BTreeSet<Code>,
    status: Status,
    /// Why nothing more is written.
    failure: Option<Box<Diagnostic>>,
}

impl Output {
    /// Begins the table.
    ///
    /// # Errors
    ///
    /// What the file system says, and a table that has the name of an input.
    pub(super) fn begin(
        variants: &Variants,
        inputs: &[Input],
        own: &CompileArguments,
        voice: Voice,
    ) -> Result<Self, Box<Diagnostic>> {
        let single = match inputs {
            [only] => Some(only),
            _ => None,
        };
        let folder = single.map(|own| own.folder.clone());
        let folder = folder.or(own.output.clone()).unwrap_or_default();
        if folder.is_file() {
            let message = format!("`{}` is a file: `-o` names a folder", folder.display());
            return Err(Box::new(Diagnostic::global(Code::E0602, message)));
        }
        let mut staged = Staged::default();
        let cannot = |error| failed(&folder, &error);
        staged.folder(&folder).map_err(cannot)?;
        let paths = Table::paths(&folder, single.map(|own| own.stem.as_os_str()));
        let folders: BTreeSet<&PathBuf> = inputs.iter().map(|own| &own.folder).collect();
        let folders = folders.into_iter().chain([&folder]);
        let read = inputs.iter().flat_map(|own| own.paths.iter().cloned());
        let list = variants.list.iter().map(|own| canonical(&own.path));
        let table = Table::begin(
            staged,
            paths.clone(),
            variants.names.clone(),
            curves(inputs),
        );
        let output = Self {
            voice,
            folders: folders.map(|own| (own.clone(), canonical(own))).collect(),
            read: read.chain(list).collect(),
            table: table.map_err(cannot)?,
            group: Staged::default(),
            settling: None,
            told: 0,
            untold: 0,
            failures: 0,
            codes: BTreeSet::new(),
            status: Status::Success,
            failure: None,
        };
        paths.iter().try_for_each(|path| output.check(path))?;
        Ok(output)
    }

    /// Refuses to write over an input.
    fn check(&self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let (Some(folder), Some(name)) = (path.parent(), path.file_name()) else {
            return Ok(());
        };
        let known = self.folders.iter().find(|(own, _)| own == folder);
        if known.is_some_and(|(_, own)| self.read.contains(&own.join(name))) {
            let message = format!("`{}` is an input of this compilation", path.display());
            return Err(Box::new(Diagnostic::global(Code::E0602, message)));
        }
        Ok(())
    }

    /// Whether something could not be written.
    pub(super) fn has_failed(&self) -> bool {
        self.failure.is_some()
    }

    /// Tells and writes what came of a variant.
    pub(super) fn take(&mut self, compiled: Compiled, variant: &Variant<'_>) {
        if self.has_failed() {
            return;
        }
        self.note(compiled.status);
        self.codes.extend(&compiled.codes);
        if !compiled.told.is_empty() {
            self.tell(&compiled.told, variant);
        }
        self.failure = self.write(compiled).err();
    }

    /// The work on a variant broke off.
    pub(super) fn take_nothing(&mut self, variant: &Variant<'_>) {
        if self.has_failed() {
            return;
        }
        self.note(Status::Internal);
        let message = "internal error: this is a defect of sweepc, please report it";
        complain(&format!("{}: {message}", variant.describe()));
        let row = variant.row(Status::Internal, Vec::new());
        self.failure = self.add(&row).err();
    }

    fn note(&mut self, status: Status) {
        self.status = self.status.max(status);
        self.failures += usize::from(status != Status::Success);
    }

    fn tell(&mut self, findings: &str, variant: &Variant<'_>) {
        if !variant.is_varied() {
            tell(findings);
        } else if self.told < TOLD {
            self.told += 1;
            tell(&format!("sweepc: {}\n{findings}", variant.describe()));
        } else {
            self.untold += 1;
        }
    }

    fn add(&mut self, row: &Row) -> Result<(), Box<Diagnostic>> {
        let table = Path::new("the table");
        self.table.add(row).map_err(|error| failed(table, &error))
    }

    fn write(&mut self, compiled: Compiled) -> Result<(), Box<Diagnostic>> {
        for row in &compiled.rows {
            self.add(row)?;
        }
        for (path, bytes) in compiled.files {
            self.check(&path)?;
            self.group
                .add_one_of_many(path.clone(), &bytes)
                .map_err(|error| failed(&path, &error))?;
        }
        if self.group.len() >= GROUP {
            self.commit_group()?;
        }
        Ok(())
    }

    /// Sends a group to the disk, once the one before is there.
    fn commit_group(&mut self) -> Result<(), Box<Diagnostic>> {
        self.settle()?;
        let group = std::mem::take(&mut self.group);
        self.settling = Some(std::thread::spawn(|| group.commit()));
        Ok(())
    }

    /// Waits for the group on its way.
    fn settle(&mut self) -> Result<(), Box<Diagnostic>> {
        let ended = self.settling.take().map(Settling::join);
        match ended {
            None | Some(Ok(Ok(_))) => Ok(()),
            Some(Ok(Err((path, error)))) => Err(failed(&path, &error)),
            Some(Err(_)) => {
                let error = std::io::Error::other("the work on it broke off");
                Err(failed(Path::new("a group of files"), &error))
            }
        }
    }

    /// Writes the last group and the table, and says how many variants failed.
    pub(super) fn end(mut self, count: usize) -> Status {
        if self.failure.is_none() {
            self.failure = self.commit_group().and_then(|()| self.settle()).err();
        }
        if self.untold > 0 {
            let others = self.untold;
            complain(&format!(
                "the findings of {others} more variants are not shown; the table has their codes"
            ));
        }
        if self.failures > 0 {
            complain(&format!("{} of {count} variants failed", self.failures));
        }
        let table = match self.failure {
            None => self.table.commit(),
            Some(_) => Ok(Vec::new()),
        };
        let written = table.map_err(|(path, error)| failed(&path, &error));
        let failure = match (self.failure, &written) {
            (Some(finding), _) => Some(finding),
            (None, Err(finding)) => Some(finding.clone()),
            (None, Ok(_)) => None,
        };
        if let Some(finding) = failure {
            self.codes.insert(finding.code);
            let mut findings = Diagnostics::default();
            findings.push(*finding);
            self.status = self.status.max(Status::of(&findings));
            tell(&self.voice.findings(&findings, &SourceMap::default()));
        }
        self.voice.tell_hint(&self.codes);
        if self.voice.is_quiet {
            return self.status;
        }
        let list = written.iter().flatten();
        let list = list.map(|path| format!("{}\n", path.display()));
        self.status.max(print(&list.collect::<String>()))
    }
}

/// The curves of all files, each name once.
fn curves(inputs: &[Input]) -> Vec<String> {
    let mut curves: Vec<String> = Vec::new();
    let mut seen = HashSet::new();
    for curve in inputs.iter().flat_map(|own| &own.curves) {
        if seen.insert(curve) {
            curves.push(curve.clone());
        }
    }
    curves
}

/// The name that a path is compared by.
pub(super) fn canonical(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() {
        Path::new(".")
    } else {
        path
    };
    fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}
