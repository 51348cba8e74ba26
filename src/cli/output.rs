use std::ffi::{OsStr, OsString};
use std::path::Path;

/// The last part of a file's name; standard input is called `<stdin>`.
pub(super) fn file_name(file: &Path) -> String {
    if file == Path::new("-") {
        return "<stdin>".to_owned();
    }
    file.file_name()
        .unwrap_or(file.as_os_str())
        .to_string_lossy()
        .into_owned()
}

/// The file as messages call it.
pub(super) fn shown(file: &Path) -> String {
    if file == Path::new("-") {
        return "<stdin>".to_owned();
    }
    file.display().to_string()
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
