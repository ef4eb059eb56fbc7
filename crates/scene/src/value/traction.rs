//! The table of a measured cohesive law: openings and tractions, each with a unit in the header.

use super::quantity::{Dimension, parse_quantity};
use super::table::{CsvError, no_csv, read, reader, shown};
use peelkit::adhesion::{TractionTable, TractionTableError};

/// What the two columns are, and a header that is right.
const COLUMNS: [(&str, Dimension); 2] = [("opening", Dimension::Length), ("traction", Dimension::Pressure)];

/// Reads a CSV of two columns, opening and traction, whose names in the header end with their units: `opening_um` or `opening (um)`. The first row is
/// the closed face, 0 and 0; the last has the traction 0. A line that begins with `#` is a remark.
///
/// ```
/// let table = peelkit_scene::parse_tractions("opening_um,traction_MPa\n0,0\n20,0.8\n150,0\n")?;
/// assert_eq!((table.range(), table.strength()), (150e3, 0.8e-3));
/// # Ok::<(), peelkit_scene::CsvError>(())
/// ```
pub fn parse_tractions(text: &str) -> Result<TractionTable, CsvError> {
    let mut reader = reader(text);
    let header = reader.headers().map_err(no_csv)?.clone();
    let names: Vec<String> = header.iter().map(shown).collect();
    let units: Vec<&str> = header.iter().filter_map(unit_of).collect();
    let is_right = |unit: &&str, dimension| parse_quantity(&format!("1 {unit}"), dimension).is_ok();
    let fits = names.len() == COLUMNS.len()
        && units.len() == COLUMNS.len()
        && units.iter().zip(COLUMNS).all(|(unit, (_, dimension))| is_right(unit, dimension));
    if !fits {
        return Err(CsvError::TractionColumns(names.join(", ")));
    }
    let (mut columns, mut cells, mut fault) = ([Vec::new(), Vec::new()], Vec::new(), None);
    // the reader counts a row from the remarks before it on
    let is_row = |line: &&str| !line.is_empty() && !line.starts_with('#');
    let rows = (1..).zip(text.lines()).filter(|(_, line)| is_row(line)).map(|(number, _)| number).skip(1);
    for (line, record) in rows.zip(reader.records()) {
        let record = match record {
            Ok(record) => record,
            Err(error) => {
                fault = Some(no_csv(error));
                break;
            }
        };
        let read = |column: usize| {
            let found = record.get(column).unwrap_or_default();
            let number = found.parse::<f64>().ok().filter(|number| number.is_finite());
            let quantity =
                number.and_then(|_| parse_quantity(&format!("{found} {}", units[column]), COLUMNS[column].1).ok());
            quantity.ok_or_else(|| CsvError::Line {
                line,
                column: names[column].clone(),
                found: shown(found),
                wrong: "is no number",
            })
        };
        match (read(0), read(1)) {
            (Ok(opening), Ok(traction)) => {
                columns[0].push(opening);
                columns[1].push(traction);
                cells.push((line, record));
            }
            (Err(error), _) | (_, Err(error)) => {
                fault = Some(error);
                break;
            }
        }
        // what is too long is refused without reading all of it
        if cells.len() > TractionTable::MOST_ROWS {
            break;
        }
    }
    let complete = fault.is_none();
    let [openings, tractions] = columns;
    match (TractionTable::new(openings, tractions), fault) {
        (Err(TractionTableError::Row { row, column, wrong }), _) if complete || row == 1 || row < cells.len() => {
            let (line, record) = &cells[row - 1];
            let found = record.get(column).map(shown).unwrap_or_default();
            Err(CsvError::Line { line: *line, column: names[column].clone(), found, wrong })
        }
        (_, Some(fault)) => Err(fault),
        (table, None) => Ok(table?),
    }
}

/// Reads the rows of a cohesive law, and gives the text that they are read from.
pub(crate) fn read_tractions(name: &str, text: &str) -> Result<(TractionTable, String), String> {
    read(name, text, parse_tractions)
}

/// The unit at the end of a name: behind a parenthesis, or behind its last underscore.
fn unit_of(name: &str) -> Option<&str> {
    match name.strip_suffix(')') {
        Some(open) => Some(open.rsplit_once('(')?.1.trim()),
        None => Some(name.rsplit_once('_')?.1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_in_the_header() {
        let rows = "\n0,0\n20,0.8\n150,0\n";
        let named = |header: &str| parse_tractions(&format!("{header}{rows}"));
        let table = named("opening_um,traction_MPa").unwrap();
        assert_eq!(named("COD (um),stress (N/mm2)").unwrap(), table);
        assert_eq!(named("# measured in May\nopening_um, traction_MPa").unwrap(), table);
        for header in
            ["opening,traction", "opening_um,traction_N", "traction_MPa,opening_um", "opening_um", "a_um,b_MPa,c_s"]
        {
            let error = named(header).unwrap_err().to_string();
            let columns = header.split(',').collect::<Vec<_>>().join(", ");
            assert!(error.starts_with(&format!("has the columns {columns}; it takes an opening")), "{error}");
        }
    }

    /// By the lines of the text, where remarks count; the first fault is reported.
    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        let refused =
            |rows: &str| parse_tractions(&format!("# a remark\nopening_um,traction_MPa\n{rows}")).unwrap_err();
        for (rows, said) in [
            ("0,0\n20,x\n", "has in line 4 `traction_MPa` = x, which is no number"),
            ("0,0\n20,inf\n", "has in line 4 `traction_MPa` = inf, which is no number"),
            ("0,0\n# one more\n20,-0.8\n150,0\n", "has in line 5 `traction_MPa` = -0.8, which is not above zero"),
            ("1,0\n20,x\n", "has in line 3 `opening_um` = 1, which is not 0"),
            ("0,0\n20,0.8\n20,x\n", "has in line 5 `traction_MPa` = x, which is no number"),
            ("0,0\n20,0.8\n10,0\n", "has in line 5 `opening_um` = 10, which does not ascend"),
            ("0,0\n20,0.8\n150,0.2\n", "has in line 5 `traction_MPa` = 0.2, which is not 0"),
            ("0,0\n20,0\n", "has 2 rows; it takes 3 to 200"),
            ("0,0\n20,0.8,7\n", "is no CSV: "),
        ] {
            let error = refused(rows).to_string();
            assert!(error.starts_with(said), "{error}");
        }
    }
}
