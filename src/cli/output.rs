use std::ffi::{OsStr, OsString};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

/// The last part of a file's name; standard input is called `stdin`.
pub(super) fn file_name(file: &Path) -> String {
    if file == Path::new("-") {
        return "<stdin>".to_owned();
    }
    file.file_name()
        .unwrap_or(file.as_os_str())
        .to_string_lossy()
        .into_owned()
}

/// The name without its extension, as it is on disk, for the names of output files.
pub(super) fn stem(file: &Path) -> &OsStr {
    if file == Path::new("-") {
        return OsStr::new("stdin");
    }
    file.file_stem().unwrap_or(file.as_os_str())
}

/// `STEM` with something appended.
pub(super) fn named(stem: &OsStr, ending: &str) -> OsString {
    let mut name = stem.to_owned();
    name.push(ending);
    name
}

/// Files that are written whole or not at all: each is a temporary file in its folder until
/// [`Staged::commit`] renames them all.
#[derive(Debug, Default)]
pub(super) struct Staged {
    files: Vec<(NamedTempFile, PathBuf)>,
}

impl Staged {
    /// Writes a file under a temporary name.
    ///
    /// # Errors
    ///
    /// What the file system says; nothing is left behind.
    pub(super) fn add(&mut self, path: PathBuf, bytes: &[u8]) -> io::Result<()> {
        let folder = path.parent().filter(|own| !own.as_os_str().is_empty());
        let mut file = builder().tempfile_in(folder.unwrap_or(Path::new(".")))?;
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

    /// Gives all files their names.
    ///
    /// # Errors
    ///
    /// What the file system says, with the file; those not renamed by then are removed.
    pub(super) fn commit(self) -> Result<Vec<PathBuf>, (PathBuf, io::Error)> {
        if let Some((_, path)) = self.files.iter().find(|(_, path)| path.is_dir()) {
            return Err((path.clone(), io::Error::from(io::ErrorKind::IsADirectory)));
        }
        let mut written = Vec::new();
        for (file, path) in self.files {
            match file.persist(&path) {
                Ok(_) => written.push(path),
                Err(error) => return Err((path, error.error)),
            }
        }
        Ok(written)
    }
}

/// Temporary files that get the permissions of ordinary new files.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".sweepc-").suffix(".partial");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder
}
