//! The tables of `verification/`, built into the program so that a check needs no file and no Python.

use std::collections::HashMap;

/// A row of a table, by the names of the columns.
#[derive(Clone, Debug)]
pub struct Row {
    cells: HashMap<String, String>,
}

impl Row {
    /// The text of a cell; None where it is empty or the column does not exist.
    pub fn text(&self, column: &str) -> Option<&str> {
        self.cells.get(column).map(String::as_str).filter(|text| !text.is_empty())
    }

    /// The number in a cell; None where it is empty, no number, or the column does not exist.
    pub fn number(&self, column: &str) -> Option<f64> {
        self.text(column)?.parse().ok()
    }
}

/// Reads a table: lines that begin with `#` are remarks, the first other line names the columns.
pub fn read(table: &str) -> Vec<Row> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes());
    reader.deserialize().filter_map(Result::ok).map(|cells| Row { cells }).collect()
}

/// A number of verification/published.csv; NaN, which fails, where it is not there.
pub fn published(quantity: &str) -> f64 {
    let rows = read(include_str!("../../../verification/published.csv"));
    let row = rows.iter().find(|row| row.text("quantity") == Some(quantity));
    row.and_then(|row| row.number("value")).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_remarks_names_and_gaps() {
        let rows = read("# remark\na,b,c\n1,,x\n2,3e-4,\n");
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].number("a"), Some(1.0));
        assert_eq!((rows[0].number("b"), rows[0].text("c"), rows[0].number("c")), (None, Some("x"), None));
        assert_eq!(rows[1].number("b"), Some(3e-4));
        assert_eq!(rows[1].text("d"), None);
    }
}
