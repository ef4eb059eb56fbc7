//! The columns of a CSV: its header, and the texts of its cells.

use super::OverlayError;
use crate::file::read_whole;
use std::path::Path;

/// A CSV with a header.
pub(super) struct Columns {
    pub header: Vec<String>,
    pub rows: Vec<Vec<String>>,
    /// What separates its cells
    pub separator: char,
}

impl Columns {
    /// Reads a file. Cells are separated by commas, or by semicolons or tabs where the header has these.
    pub fn read(path: &Path) -> Result<Self, OverlayError> {
        let cannot =
            |why: String| OverlayError::new(path, format!("cannot be read: {why}"), "Give the path of a CSV file.");
        let bytes = read_whole(path).map_err(|error| cannot(error.to_string()))?;
        let text = String::from_utf8(bytes).map_err(|_| cannot("it is not text in UTF-8".into()))?;
        Self::parse(text.trim_start_matches('\u{feff}')).map_err(|found| {
            OverlayError::new(
                path,
                found,
                "A CSV has a header and as many cells in each row; a number has a decimal point.",
            )
        })
    }

    fn parse(text: &str) -> Result<Self, String> {
        let first = text.lines().find(|line| !line.starts_with('#')).unwrap_or_default();
        let separator = [';', '\t'].into_iter().find(|&separator| first.contains(separator)).unwrap_or(',');
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .delimiter(separator as u8)
            .flexible(true)
            .from_reader(text.as_bytes());
        let cells = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect::<Vec<_>>();
        let header = cells(reader.headers().map_err(|error| format!("is no CSV: {error}"))?);
        if header.is_empty() {
            return Err("is empty: it has no header and no rows".to_owned());
        }
        let mut rows = Vec::new();
        for (index, record) in reader.records().enumerate() {
            let row = cells(&record.map_err(|error| format!("is no CSV: {error}"))?);
            if row.len() != header.len() {
                let (found, wanted) = (row.len(), header.len());
                return Err(format!("has {found} cells in row {} and {wanted} in its header", index + 1));
            }
            rows.push(row);
        }
        Ok(Self { header, rows, separator })
    }

    /// The numbers of a column; nothing where a cell is empty.
    pub fn numbers(&self, path: &Path, column: usize) -> Result<Vec<Option<f64>>, OverlayError> {
        let name = &self.header[column];
        let number = |(index, row): (usize, &Vec<String>)| match self.number(&row[column]) {
            _ if row[column].is_empty() => Ok(None),
            Some(number) if number.is_finite() => Ok(Some(number)),
            _ => Err(OverlayError::new(
                path,
                format!(
                    "has in row {} `{name}` = {}, which is no finite number",
                    index + 1,
                    row[column].chars().take(40).collect::<String>()
                ),
                "Write numbers with a decimal point: 0.4 or 4e-1.",
            )),
        };
        self.rows.iter().enumerate().map(number).collect()
    }

    /// A cell as a number; between semicolons or tabs a comma is a decimal one.
    fn number(&self, cell: &str) -> Option<f64> {
        cell.parse().ok().or_else(|| (self.separator != ',').then(|| cell.replacen(',', ".", 1).parse().ok())?)
    }
}
