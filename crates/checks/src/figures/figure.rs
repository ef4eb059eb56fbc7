//! A figure as it is written, and the data behind it.

use peelkit_report::chart::{Picture, save};
use peelkit_report::{ReportError, write_whole};
use std::path::{Path, PathBuf};

/// One figure as it was written.
pub(crate) struct Figure {
    pub stem: &'static str,
    pub caption: String,
    pub files: Vec<PathBuf>,
}

impl Figure {
    /// Writes the picture and the data behind it.
    pub fn write(
        dir: &Path,
        stem: &'static str,
        caption: String,
        picture: &Picture,
        data: &Table,
    ) -> Result<Self, ReportError> {
        let mut figure = Figure { stem, caption, files: save(picture, dir, stem)? };
        figure.add_table(dir, stem, data)?;
        Ok(figure)
    }

    /// Writes `dir/stem.csv`, data behind this figure.
    pub fn add_table(&mut self, dir: &Path, stem: &str, data: &Table) -> Result<(), ReportError> {
        let path = dir.join(format!("{stem}.csv"));
        let text = data.text().map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, &text)?;
        self.files.push(path);
        Ok(())
    }
}

/// The data behind a figure.
pub(crate) struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new(header: &[&str]) -> Self {
        Table { rows: vec![header.iter().map(|name| name.to_string()).collect()] }
    }

    /// A row: words, then numbers that may be missing, then words.
    pub fn push(&mut self, before: &[&str], numbers: &[Option<f64>], after: &[&str]) {
        let words = |words: &[&str]| words.iter().map(|word| word.to_string()).collect::<Vec<_>>();
        let numbers = numbers.iter().map(|v| v.map(|v| v.to_string()).unwrap_or_default());
        self.rows.push(words(before).into_iter().chain(numbers).chain(words(after)).collect());
    }

    fn text(&self) -> std::io::Result<Vec<u8>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        self.rows.iter().try_for_each(|row| writer.write_record(row))?;
        writer.into_inner().map_err(|e| e.into_error())
    }
}
