//! The columns of a CSV: its header, and the texts of its cells.

use super::error::OverlayError;
use crate::writing::file::read_whole;
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
        Self::parse(text.trim_start_matches('\u{feff}')).map_err(|found| not_a_table(path, found))
    }

    /// Reads the file of a testing machine: as [`Columns::read`], with what stands above the header left out, and a row of units below it, `(mm)`
    /// or `[N]`, put behind the names.
    pub fn read_record(path: &Path) -> Result<Self, OverlayError> {
        let cannot =
            |why: String| OverlayError::new(path, format!("cannot be read: {why}"), "Give the path of a CSV file.");
        let bytes = read_whole(path).map_err(|error| cannot(error.to_string()))?;
        let text = String::from_utf8(bytes).map_err(|_| cannot("it is not text in UTF-8".into()))?;
        let text = text.trim_start_matches('\u{feff}');
        Self::parse(&plain_record(text).unwrap_or_else(|| text.to_owned())).map_err(|found| not_a_table(path, found))
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

fn not_a_table(path: &Path, found: String) -> OverlayError {
    OverlayError::new(path, found, "A CSV has a header and as many cells in each row; a number has a decimal point.")
}

/// The record of a machine as a plain table: its header in one line, and what is below it. Nothing where the first line is the header already, or no row
/// of numbers with words above it is found.
fn plain_record(text: &str) -> Option<String> {
    let lines: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#')).collect();
    let is_number = |cell: &String| cell.replacen(',', ".", 1).parse::<f64>().is_ok();
    let numbers = |separator: char| {
        lines.iter().position(|line| {
            let row = cells(line, separator);
            row.len() > 1 && row.iter().all(|cell| cell.is_empty() || is_number(cell)) && row.iter().any(is_number)
        })
    };
    let (separator, data) =
        [';', '\t', ','].into_iter().find_map(|separator| Some((separator, numbers(separator)?)))?;
    let above = |lines_up: usize| Some(cells(lines[data.checked_sub(lines_up)?], separator));
    let unit = |cell: &String| cell.is_empty() || (cell.starts_with(['(', '[']) && cell.ends_with([')', ']']));
    let nearest = above(1)?;
    if data == 1 || nearest.iter().any(is_number) {
        return None;
    }
    let header = match nearest.iter().all(unit) {
        false => nearest,
        true => above(2)?.iter().zip(&nearest).map(|(name, unit)| format!("{name} {unit}").trim().to_owned()).collect(),
    };
    let quoted = header.iter().map(|name| format!("\"{}\"", name.replace('"', "\"\""))).collect::<Vec<_>>();
    let header = quoted.join(&separator.to_string());
    Some([&[header.as_str()], &lines[data..]].concat().join("\n"))
}

/// The cells of one line.
fn cells(line: &str, separator: char) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .delimiter(separator as u8)
        .from_reader(line.as_bytes());
    let row = reader.records().next().and_then(Result::ok);
    row.iter().flat_map(|row| row.iter()).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_record_of_a_machine_is_a_table_with_lines_above_and_units_below_its_header() {
        let machine = "Test,90 degree peel\nSpeed,300,mm/min\n\n\"Time\",\"Extension\",\"Load\"\n\"(s)\",\"(mm)\",\"(N)\"\n0.0,0.00,0.1\n0.1,0.05,0.2\n";
        let table = Columns::parse(&plain_record(machine).unwrap()).unwrap();
        assert_eq!(table.header, ["Time (s)", "Extension (mm)", "Load (N)"]);
        assert_eq!(table.rows, [["0.0", "0.00", "0.1"], ["0.1", "0.05", "0.2"]]);
        let german = "Prüfer;Meier\nWeg;Kraft\n[mm];[N]\n0,00;0,1\n0,05;0,2\n";
        let table = Columns::parse(&plain_record(german).unwrap()).unwrap();
        assert_eq!((table.header[0].as_str(), table.number(&table.rows[1][0])), ("Weg [mm]", Some(0.05)));
        assert_eq!(plain_record("u (nm),P (nN)\n0,0\n"), None);
    }
}
