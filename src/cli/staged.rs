use std::collections::{BTreeSet, HashSet};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use tempfile::TempPath;

/// Files that are written whole or not at all: each is a temporary file in its folder until
/// [`Staged::commit`] renames them all. None is renamed before all are on the disk.
#[derive(Debug, Default)]
pub(super) struct Staged {
    files: Vec<(TempPath, PathBuf)>,
    /// Files that are still written to.
    open: Vec<File>,
    /// Folders whose file systems hold files that are not yet known to be on the disk.
    waiting: BTreeSet<PathBuf>,
    /// The folders that were made for them.
    folders: Vec<PathBuf>,
}

impl Staged {
    /// Makes a folder for files to come, if it is not there.
    ///
    /// # Errors
    ///
    /// What the file system says.
    pub(super) fn folder(&mut self, path: &Path) -> io::Result<()> {
        if path.as_os_str().is_empty() || path.exists() {
            return Ok(());
        }
        let mut ledger = ledger();
        fs::create_dir(path)?;
        ledger.folders.push(path.to_path_buf());
        self.folders.push(path.to_path_buf());
        Ok(())
    }

    /// Writes a file under a temporary name.
    ///
    /// # Errors
    ///
    /// What the file system says; nothing is left behind.
    pub(super) fn add(&mut self, path: PathBuf, bytes: &[u8]) -> io::Result<()> {
        let (mut file, temporary) = create(folder_of(&path))?;
        file.write_all(bytes)?;
        file.sync_all()?;
        self.files.push((temporary, path));
        Ok(())
    }

    /// As [`Staged::add`], for one of many files: they go to the disk together, before the first
    /// is renamed.
    ///
    /// # Errors
    ///
    /// What the file system says; nothing is left behind.
    pub(super) fn add_one_of_many(&mut self, path: PathBuf, bytes: &[u8]) -> io::Result<()> {
        if !cfg!(target_os = "linux") {
            return self.add(path, bytes);
        }
        let folder = folder_of(&path);
        let (mut file, temporary) = create(folder)?;
        file.write_all(bytes)?;
        if !self.waiting.contains(folder) {
            self.waiting.insert(folder.to_path_buf());
        }
        self.files.push((temporary, path));
        Ok(())
    }

    /// A file under a temporary name, to be written before [`Staged::commit`].
    ///
    /// # Errors
    ///
    /// What the file system says; nothing is left behind.
    pub(super) fn open(&mut self, path: PathBuf) -> io::Result<File> {
        let (file, temporary) = create(folder_of(&path))?;
        self.open.push(file.try_clone()?);
        self.files.push((temporary, path));
        Ok(file)
    }

    /// How many files there are.
    pub(super) fn len(&self) -> usize {
        self.files.len()
    }

    /// Writes the new text of a file that is there under a temporary name. A link stays a link, and
    /// the file keeps its permissions.
    ///
    /// # Errors
    ///
    /// What the file system says; nothing is left behind.
    pub(super) fn replace(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let path = path.canonicalize()?;
        let permissions = path.metadata()?.permissions();
        if permissions.readonly() {
            return Err(io::Error::from(io::ErrorKind::PermissionDenied));
        }
        self.add(path, bytes)?;
        match self.files.last() {
            Some((temporary, _)) => fs::set_permissions(temporary, permissions),
            None => Ok(()),
        }
    }

    /// Brings to the disk what is not yet known to be there.
    fn settle(&mut self) -> Result<(), (PathBuf, io::Error)> {
        for file in self.open.drain(..) {
            let first = || self.files.first().map(|(_, path)| path.clone());
            file.sync_all()
                .map_err(|error| (first().unwrap_or_default(), error))?;
        }
        for folder in std::mem::take(&mut self.waiting) {
            sync_file_system(&folder).map_err(|error| (folder, error))?;
        }
        Ok(())
    }

    /// Gives all files their names. A run that is broken off meanwhile ends after the last.
    ///
    /// # Errors
    ///
    /// What the file system says, with the file; those not renamed by then are removed.
    pub(super) fn commit(mut self) -> Result<Vec<PathBuf>, (PathBuf, io::Error)> {
        self.settle()?;
        let mut ledger = ledger();
        if let Some((_, path)) = self.files.iter().find(|(_, path)| path.is_dir()) {
            return Err((path.clone(), io::Error::from(io::ErrorKind::IsADirectory)));
        }
        let mut written = Vec::new();
        for (temporary, path) in std::mem::take(&mut self.files) {
            ledger.files.remove::<Path>(&temporary);
            temporary
                .persist(&path)
                .map_err(|error| (path.clone(), error.error))?;
            written.push(path);
        }
        let made = std::mem::take(&mut self.folders);
        ledger.folders.retain(|own| !made.contains(own));
        Ok(written)
    }
}

/// The folder that a file lies in.
fn folder_of(path: &Path) -> &Path {
    let folder = path.parent().filter(|own| !own.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

/// A new file with a temporary name.
fn create(folder: &Path) -> io::Result<(File, TempPath)> {
    let mut ledger = ledger();
    // The temporary name, which the error tells, is no affair of the user.
    let file = builder()
        .tempfile_in(folder)
        .map_err(|error| io::Error::from(error.kind()))?;
    ledger.files.insert(file.path().to_path_buf());
    Ok(file.into_parts())
}

/// Brings everything that a file system has been given to the disk.
#[cfg(target_os = "linux")]
fn sync_file_system(folder: &Path) -> io::Result<()> {
    Ok(rustix::fs::syncfs(File::open(folder)?)?)
}

/// Other systems do not promise it for a whole file system: each file is brought there by itself.
#[cfg(not(target_os = "linux"))]
fn sync_file_system(_: &Path) -> io::Result<()> {
    Ok(())
}

impl Drop for Staged {
    /// Takes away what was not given a name, and the folders that were made for it.
    fn drop(&mut self) {
        self.files.clear();
        for folder in self.folders.drain(..) {
            // One that holds files of its own stays.
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Temporary files that get the permissions of ordinary new files.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".sweepc-").suffix(".partial");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder
}

/// What this process has staged and not yet given its name.
#[derive(Debug, Default)]
struct Ledger {
    is_closed: bool,
    files: HashSet<PathBuf>,
    folders: Vec<PathBuf>,
}

static LEDGER: LazyLock<Mutex<Ledger>> = LazyLock::new(Mutex::default);

/// The ledger, as long as the run goes on. Once it has been broken off nothing is written any
/// more: whoever still wants to waits for the end of the process.
fn ledger() -> MutexGuard<'static, Ledger> {
    loop {
        let ledger = LEDGER.lock().unwrap_or_else(PoisonError::into_inner);
        if !ledger.is_closed {
            return ledger;
        }
        drop(ledger);
        std::thread::park();
    }
}

/// Breaks the run off: takes away all that is staged.
pub(super) fn abandon() {
    let mut ledger = LEDGER.lock().unwrap_or_else(PoisonError::into_inner);
    ledger.is_closed = true;
    for file in std::mem::take(&mut ledger.files) {
        let _ = fs::remove_file(file);
    }
    for folder in std::mem::take(&mut ledger.folders) {
        let _ = fs::remove_dir(folder);
    }
}
