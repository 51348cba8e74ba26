use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// Files that are written whole or not at all: each is a temporary file in its folder until
/// [`Staged::commit`] renames them all.
#[derive(Debug, Default)]
pub(super) struct Staged {
    files: Vec<(NamedTempFile, PathBuf)>,
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
        let folder = path.parent().filter(|own| !own.as_os_str().is_empty());
        let mut file = {
            let mut ledger = ledger();
            let made = builder().tempfile_in(folder.unwrap_or(Path::new(".")));
            // The temporary name, which the error tells, is no affair of the user.
            let file = made.map_err(|error| io::Error::from(error.kind()))?;
            ledger.files.push(file.path().to_path_buf());
            file
        };
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        self.files.push((file, path));
        Ok(())
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
            Some((file, _)) => file.as_file().set_permissions(permissions),
            None => Ok(()),
        }
    }

    /// Gives all files their names. A run that is broken off meanwhile ends after the last.
    ///
    /// # Errors
    ///
    /// What the file system says, with the file; those not renamed by then are removed.
    pub(super) fn commit(mut self) -> Result<Vec<PathBuf>, (PathBuf, io::Error)> {
        let mut ledger = ledger();
        if let Some((_, path)) = self.files.iter().find(|(_, path)| path.is_dir()) {
            return Err((path.clone(), io::Error::from(io::ErrorKind::IsADirectory)));
        }
        let mut written = Vec::new();
        for (file, path) in std::mem::take(&mut self.files) {
            let temporary = file.path().to_path_buf();
            file.persist(&path)
                .map_err(|error| (path.clone(), error.error))?;
            ledger.files.retain(|own| *own != temporary);
            written.push(path);
        }
        let made = std::mem::take(&mut self.folders);
        ledger.folders.retain(|own| !made.contains(own));
        Ok(written)
    }
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
#[derive(Debug)]
struct Ledger {
    is_closed: bool,
    files: Vec<PathBuf>,
    folders: Vec<PathBuf>,
}

static LEDGER: Mutex<Ledger> = Mutex::new(Ledger {
    is_closed: false,
    files: Vec::new(),
    folders: Vec::new(),
});

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
