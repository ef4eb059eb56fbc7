//! The table of a beam or of a substrate: in the scene, or in a file beside it.

use crate::error::one_line;
use csv::StringRecord;
use peelkit::adhesion::{Heights, HeightsError, TractionTableError};
use peelkit::model::{ProfileColumns, ProfileTable, TableError};
use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};

/// What is wrong with a table in CSV.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CsvError {
    /// The text is no CSV, with the reason.
    #[error("is no CSV: {0}")]
    Csv(String),
    /// A column that has to be there is not.
    #[error("has no column `{0}`")]
    Missing(&'static str),
    /// A column of this name is none of a profile.
    #[error("has a column `{0}`, which is none of {names}", names = ProfileTable::COLUMNS.join(", "))]
    Unknown(String),
    /// The columns are these, and not those of heights.
    #[error("has the columns {0}; it takes x_nm and height_nm")]
    Columns(String),
    /// The columns are these, and not those of a law.
    #[error("has the columns {0}; it takes an opening and a traction with their units, as opening_um,traction_MPa")]
    TractionColumns(String),
    /// A cell is wrong, by the lines of the text.
    #[error("has in line {line} `{column}` = {found}, which {wrong}")]
    Line {
        /// From 1, with the header and the remarks.
        line: usize,
        /// Its name in the header.
        column: String,
        /// The text of the cell.
        found: String,
        /// What is wrong with it.
        wrong: &'static str,
    },
    /// A cell holds no number.
    #[error("has in row {row} `{column}` = {found}, which is no number")]
    NoNumber {
        /// From 1, without the header.
        row: usize,
        /// Its name in the header.
        column: &'static str,
        /// The text of the cell.
        found: String,
    },
    /// The numbers are no table of a profile.
    #[error(transparent)]
    Profile(#[from] TableError),
    /// The numbers are no heights of a substrate.
    #[error(transparent)]
    Heights(#[from] HeightsError),
    /// The numbers are no cohesive law.
    #[error(transparent)]
    Tractions(#[from] TractionTableError),
}

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 20;
/// The first columns of a profile, which it has to have.
const NEEDED: usize = 3;

/// Reads a CSV with the columns `s_nm`, `width_nm`, `height_nm` and, optionally, `angle_deg` (direction of the underside in the
/// stress-free configuration) and `roundness` (0: a rectangle, 1: an ellipse). S begins with 0 at the free end and ascends. A line that begins with
/// `#` is a remark.
///
/// ```
/// use peelkit::beam::BeamGeometry;
///
/// let table = peelkit_scene::parse_profile("s_nm,width_nm,height_nm\n0,20,5\n40,20,5\n100,10,10\n")?;
/// assert_eq!((table.length(), table.breaks()), (100.0, vec![40.0]));
/// # Ok::<(), peelkit_scene::CsvError>(())
/// ```
pub fn parse_profile(text: &str) -> Result<ProfileTable, CsvError> {
    let names = ProfileTable::COLUMNS;
    let mut reader = reader(text);
    let header = reader.headers().map_err(no_csv)?.clone();
    if let Some(unknown) = header.iter().find(|name| !names.contains(name)) {
        return Err(CsvError::Unknown(shown(unknown)));
    }
    let places = names.map(|name| header.iter().position(|found| found == name));
    if let Some(missing) = names[..NEEDED].iter().zip(places).find(|(_, place)| place.is_none()) {
        return Err(CsvError::Missing(missing.0));
    }
    let cells = Cells::read(&mut reader, names, places, ProfileTable::MOST_ROWS);
    let [places, widths, heights, angles, roundness] = cells.columns;
    let table = ProfileTable::new(ProfileColumns { places, widths, heights, angles, roundness });
    let as_written = |error| match error {
        TableError::Cell { row, column, wrong, .. } => {
            let place = header.iter().position(|name| name == column);
            TableError::Cell { row, column, found: written(&cells.records, row, place), wrong }
        }
        other => other,
    };
    match (table.map_err(as_written), cells.fault) {
        (Err(error @ TableError::Cell { .. }), _) => Err(error.into()),
        (_, Some(Fault::Text(error))) => Err(error),
        (_, Some(Fault::Rows(rows))) => Err(TableError::Rows(rows).into()),
        (table, None) => Ok(table?),
    }
}

/// Reads a CSV with the columns `x_nm`, ascending, and `height_nm`. A line that begins with `#` is a remark.
///
/// ```
/// let valley = peelkit_scene::parse_heights("x_nm,height_nm\n0,0\n50,-8\n100,0\n")?;
/// assert_eq!(valley.at(50.0)[0], -8.0);
/// # Ok::<(), peelkit_scene::CsvError>(())
/// ```
pub fn parse_heights(text: &str) -> Result<Heights, CsvError> {
    let names = Heights::COLUMNS;
    let mut reader = reader(text);
    let header = reader.headers().map_err(no_csv)?.clone();
    if header.iter().ne(names) {
        let found: Vec<String> = header.iter().map(shown).collect();
        return Err(CsvError::Columns(found.join(", ")));
    }
    let cells = Cells::read(&mut reader, names, [Some(0), Some(1)], Heights::MOST_ROWS);
    let [places, values] = cells.columns;
    let heights = Heights::new(places, values);
    let as_written = |error| match error {
        HeightsError::Cell { row, column, wrong, .. } => {
            let place = names.iter().position(|&name| name == column);
            HeightsError::Cell { row, column, found: written(&cells.records, row, place), wrong }
        }
        other => other,
    };
    match (heights.map_err(as_written), cells.fault) {
        (Err(error @ HeightsError::Cell { .. }), _) => Err(error.into()),
        (_, Some(Fault::Text(error))) => Err(error),
        (_, Some(Fault::Rows(rows))) => Err(HeightsError::Rows(rows).into()),
        (heights, None) => Ok(heights?),
    }
}

/// The numbers of a CSV, row by row up to where reading ends.
struct Cells<const N: usize> {
    columns: [Vec<f64>; N],
    records: Vec<StringRecord>,
    /// Why it ends before the text does.
    fault: Option<Fault>,
}

enum Fault {
    Text(CsvError),
    /// The first row too many.
    Rows(usize),
}

impl<const N: usize> Cells<N> {
    /// `places` are those of the columns in a record; one that has none stays empty.
    fn read(
        reader: &mut csv::Reader<&[u8]>,
        names: [&'static str; N],
        places: [Option<usize>; N],
        most_rows: usize,
    ) -> Self {
        let mut cells = Self { columns: [(); N].map(|()| Vec::new()), records: Vec::new(), fault: None };
        for record in reader.records() {
            if let Err(fault) = cells.add(record, &names, &places, most_rows) {
                cells.fault = Some(fault);
                break;
            }
        }
        cells
    }

    fn add(
        &mut self,
        record: Result<StringRecord, csv::Error>,
        names: &[&'static str; N],
        places: &[Option<usize>; N],
        most_rows: usize,
    ) -> Result<(), Fault> {
        let record = record.map_err(|error| Fault::Text(no_csv(error)))?;
        let row = self.records.len() + 1;
        if row > most_rows {
            return Err(Fault::Rows(row));
        }
        self.records.push(record.clone());
        for ((values, name), place) in self.columns.iter_mut().zip(names).zip(places) {
            let Some(found) = place.and_then(|place| record.get(place)) else { continue };
            let no_number = |_| Fault::Text(CsvError::NoNumber { row, column: name, found: shown(found) });
            values.push(found.parse().map_err(no_number)?);
        }
        Ok(())
    }
}

pub(super) fn reader(text: &str) -> csv::Reader<&[u8]> {
    csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes())
}

pub(super) fn no_csv(error: csv::Error) -> CsvError {
    CsvError::Csv(error.to_string())
}

/// A cell as it stands in the text.
fn written(records: &[StringRecord], row: usize, place: Option<usize>) -> String {
    let cell = place.and_then(|place| records.get(row - 1)?.get(place));
    cell.map(shown).unwrap_or_default()
}

/// The beginning of a cell.
pub(super) fn shown(cell: &str) -> String {
    cell.chars().take(40).collect()
}

/// Reads the outline of a beam, and gives the text that it is read from.
pub(crate) fn read_profile(name: &str, text: &str) -> Result<(ProfileTable, String), String> {
    read(name, text, parse_profile)
}

/// Reads the heights of a substrate, and gives the text that they are read from.
pub(crate) fn read_heights(name: &str, text: &str) -> Result<(Heights, String), String> {
    read(name, text, parse_heights)
}

/// The file or folder that a scene of this name names, which is beside it.
pub(crate) fn beside(scene: &str, named: &str) -> PathBuf {
    Path::new(scene).parent().unwrap_or(Path::new("")).join(named)
}

/// Reads a table from a text of several lines, or from the file that a text of one line names, beside the scene `name`. The error
/// says what was found.
pub(super) fn read<T, E: Display>(
    name: &str,
    text: &str,
    parse: fn(&str) -> Result<T, E>,
) -> Result<(T, String), String> {
    if text.contains('\n') {
        return parse(text).map(|table| (table, text.to_owned())).map_err(|error| error.to_string());
    }
    let path = beside(name, text);
    let shown = one_line(&path.display().to_string());
    let metadata =
        fs::metadata(&path).map_err(|error| format!("names the file {shown}, which cannot be read: {error}"))?;
    if !metadata.is_file() || metadata.len() > LARGEST {
        return Err(format!("names {shown}, which is no file of at most {LARGEST} bytes"));
    }
    let text =
        fs::read_to_string(&path).map_err(|error| format!("names the file {shown}, which cannot be read: {error}"))?;
    let table = parse(&text).map_err(|error| format!("names the file {shown}, which {error}"))?;
    Ok((table, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_tables_are_refused_by_name() {
        let refused = |text: &str| parse_profile(text).unwrap_err().to_string();
        assert_eq!(refused("s_nm,width_nm\n0,1\n"), "has no column `height_nm`");
        assert!(refused("s_nm,width_nm,height_nm,hight\n").starts_with("has a column `hight`, which is none of s_nm,"));
        let head = "s_nm,width_nm,height_nm\n";
        assert_eq!(refused(head), "has 0 rows; it takes 2 to 200");
        for (rows, said) in [
            ("1,1,1\n2,1,1\n", "has in row 1 `s_nm` = 1, which is not 0, where the free end is"),
            ("0,1,1\n0,1,1\n", "has in row 2 `s_nm` = 0, which does not ascend"),
            ("0,1,1\n5,0,1\n", "has in row 2 `width_nm` = 0, which is not above zero"),
            ("0,1,x\n5,0,1\n", "has in row 1 `height_nm` = x, which is no number"),
            ("0,1,nan\n5,0,1\n", "has in row 1 `height_nm` = nan, which is not finite"),
        ] {
            assert_eq!(refused(&format!("{head}{rows}")), said);
        }
        assert!(refused(&format!("{head}0,1\n")).starts_with("is no CSV: "));
    }

    #[test]
    fn a_table_that_is_none_is_refused() {
        let wrong = |text: &str| parse_heights(text).unwrap_err().to_string();
        assert_eq!(wrong("x_nm,height_nm\n0,0\n1,1\n"), "has 2 rows; it takes 3 to 20000");
        assert_eq!(wrong("x,y\n"), "has the columns x, y; it takes x_nm and height_nm");
        assert_eq!(wrong("x_nm,height_nm\n0,0\n0,1\n"), "has in row 2 `x_nm` = 0, which does not ascend");
        assert_eq!(wrong("x_nm,height_nm\n0,NaN\n"), "has in row 1 `height_nm` = NaN, which is not from -1e9 to 1e9");
        assert_eq!(wrong("x_nm,height_nm\n0,a\n"), "has in row 1 `height_nm` = a, which is no number");
    }

    /// The first error is reported, whether with a number or with the text.
    #[test]
    fn the_first_fault_of_a_table_is_told() {
        let refused =
            |rows: &str| parse_profile(&format!("s_nm,width_nm,height_nm\n0,1,1\n{rows}")).unwrap_err().to_string();
        assert_eq!(refused("0,1,x\n"), "has in row 2 `s_nm` = 0, which does not ascend");
        assert_eq!(refused("1,x,0\n"), "has in row 2 `width_nm` = x, which is no number");
        assert_eq!(refused("1,-0.0,1\n2,1\n"), "has in row 2 `width_nm` = -0.0, which is not above zero");
        let many: String = (1..=200).map(|row| format!("{row},1,1\n")).collect();
        assert_eq!(refused(&many), "has 201 rows; it takes 2 to 200");
        assert_eq!(
            refused(&many.replace("\n9,1,1", "\n9,1,0")),
            "has in row 10 `height_nm` = 0, which is not above zero"
        );
    }
}
