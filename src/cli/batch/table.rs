use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::cli::staged::Staged;

use super::row::Row;

/// The table of a batch as it is written: `STEM.batch.csv`, and `STEM.batch.jsonl` with one object
/// a line.
pub(super) struct Table {
    staged: Staged,
    csv: csv::Writer<File>,
    lines: BufWriter<File>,
    parameters: Vec<String>,
    curves: Vec<String>,
}

impl Table {
    /// The files of a table.
    pub(super) fn paths(folder: &Path, stem: Option<&std::ffi::OsStr>) -> [PathBuf; 2] {
        ["batch.csv", "batch.jsonl"].map(|ending| {
            let mut name = std::ffi::OsString::new();
            if let Some(stem) = stem {
                name.push(stem);
                name.push(".");
            }
            name.push(ending);
            folder.join(name)
        })
    }

    /// Begins a table with columns for parameters and for the lengths of curves.
    ///
    /// # Errors
    ///
    /// What the file system says.
    pub(super) fn begin(
        mut staged: Staged,
        [csv, lines]: [PathBuf; 2],
        parameters: Vec<String>,
        curves: Vec<String>,
    ) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(staged.open(csv)?);
        csv.write_record(Row::columns(&parameters, &curves))?;
        let lines = BufWriter::new(staged.open(lines)?);
        Ok(Self {
            staged,
            csv,
            lines,
            parameters,
            curves,
        })
    }

    /// Adds a row.
    ///
    /// # Errors
    ///
    /// What the file system says.
    pub(super) fn add(&mut self, row: &Row) -> io::Result<()> {
        self.csv
            .write_record(row.cells(&self.parameters, &self.curves))?;
        serde_json::to_writer(&mut self.lines, row)?;
        self.lines.write_all(b"\n")
    }

    /// Gives the table its names.
    ///
    /// # Errors
    ///
    /// What the file system says, with the file.
    pub(super) fn commit(mut self) -> Result<Vec<PathBuf>, (PathBuf, io::Error)> {
        let flushed = self.csv.flush().and_then(|()| self.lines.flush());
        flushed.map_err(|error| (PathBuf::from("the table"), error))?;
        self.staged.commit()
    }
}
