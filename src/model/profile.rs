//! A beam whose width, height, direction and roundness are given by a table along S, or piece by piece.
//!
//! Between the rows of a table each is a monotone cubic (Fritsch and Butland's PCHIP: SIAM J. Sci. Stat. Comput. 5 (1984) 300), which has no
//! bulge that the table does not have. Its second derivative jumps at the rows, so elements end there.

use super::{Geometry, ProfilePieces};
use crate::beam::{Contour, Material, Outline};
use std::sync::Arc;

/// A beam by a table or by pieces, and what it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    pub form: ProfileForm,
    pub material: Material,
}

/// What gives the outline of a profile.
#[derive(Clone, Debug, PartialEq)]
pub enum ProfileForm {
    Table(ProfileTable),
    Pieces(ProfilePieces),
}

impl ProfileForm {
    fn contour(&self) -> &dyn Contour {
        match self {
            Self::Table(table) => table,
            Self::Pieces(pieces) => pieces,
        }
    }
}

impl Contour for ProfileForm {
    fn length(&self) -> f64 {
        self.contour().length()
    }

    fn breaks(&self) -> Vec<f64> {
        self.contour().breaks()
    }

    fn at(&self, place: f64) -> Outline {
        self.contour().at(place)
    }
}

impl Contour for Profile {
    fn length(&self) -> f64 {
        self.form.length()
    }

    fn breaks(&self) -> Vec<f64> {
        self.form.breaks()
    }

    fn at(&self, place: f64) -> Outline {
        self.form.at(place)
    }
}

impl Geometry for Profile {
    fn name(&self) -> &'static str {
        "profile"
    }

    fn material(&self) -> Material {
        self.material
    }

    fn shared(&self) -> Arc<dyn Contour> {
        Arc::new(self.form.clone())
    }
}

/// The table: a row a place.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileTable {
    /// As it was read.
    text: String,
    /// S, nm
    places: Vec<f64>,
    /// Width (nm), height (nm), direction of the underside (rad) and roundness, each with its slopes at the places.
    columns: [Column; 4],
}

/// Values and slopes at the places.
#[derive(Clone, Debug, PartialEq)]
struct Column {
    values: Vec<f64>,
    slopes: Vec<f64>,
}

/// What is wrong with a table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TableError {
    #[error("is no CSV: {0}")]
    Csv(String),
    #[error("has no column `{0}`")]
    Missing(&'static str),
    #[error("has a column `{0}`, which is none of {names}", names = NAMES.join(", "))]
    Unknown(String),
    #[error("has in row {row} `{column}` = {found}, which {wrong}")]
    Cell { row: usize, column: &'static str, found: String, wrong: &'static str },
    #[error("has {0} rows; it takes 2 to {MOST_ROWS}")]
    Rows(usize),
}

/// Names of the columns; the last two may be left out and are zero then.
const NAMES: [&str; 5] = ["s_nm", "width_nm", "height_nm", "angle_deg", "roundness"];
const NEEDED: usize = 3;
/// Most rows: there is an element at least between two.
const MOST_ROWS: usize = 200;
/// Places beyond this are taken for a slip, nm.
const LARGEST: f64 = 1e12;

impl Default for ProfileTable {
    /// A beam of unit length, width and height, of no text.
    fn default() -> Self {
        let column = |value: f64| Column { values: vec![value; 2], slopes: vec![0.0; 2] };
        Self { text: String::new(), places: vec![0.0, 1.0], columns: [1.0, 1.0, 0.0, 0.0].map(column) }
    }
}

impl ProfileTable {
    /// Reads a CSV with the columns `s_nm`, `width_nm`, `height_nm` and, if wanted, `angle_deg` (direction of the underside, free of
    /// stress) and `roundness` (0: a rectangle, 1: an ellipse). S begins with 0 at the free end and ascends. A line that begins with
    /// `#` is a remark.
    ///
    /// ```
    /// use peelkit::beam::Contour;
    /// use peelkit::model::ProfileTable;
    ///
    /// let table = ProfileTable::parse("s_nm,width_nm,height_nm\n0,20,5\n40,20,5\n100,10,10\n")?;
    /// assert_eq!((table.length(), table.breaks()), (100.0, vec![40.0]));
    /// assert_eq!(table.at(30.0).height, [5.0, 0.0, 0.0]);
    /// # Ok::<(), peelkit::model::TableError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, TableError> {
        let mut reader =
            csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
        let no_csv = |error: csv::Error| TableError::Csv(error.to_string());
        let header = reader.headers().map_err(no_csv)?.clone();
        if let Some(unknown) = header.iter().find(|name| !NAMES.contains(name)) {
            return Err(TableError::Unknown(unknown.chars().take(40).collect()));
        }
        let place_of = |name: &str| header.iter().position(|found| found == name);
        if let Some(missing) = NAMES[..NEEDED].iter().find(|name| place_of(name).is_none()) {
            return Err(TableError::Missing(missing));
        }
        let mut cells: [Vec<f64>; 5] = Default::default();
        for record in reader.records() {
            let record = record.map_err(no_csv)?;
            let row = cells[0].len() + 1;
            if row > MOST_ROWS {
                return Err(TableError::Rows(row));
            }
            for (column, name) in NAMES.into_iter().enumerate() {
                let Some(found) = place_of(name).and_then(|place| record.get(place)) else {
                    cells[column].push(0.0);
                    continue;
                };
                let before = cells[column].last().copied();
                let cell =
                    |wrong| TableError::Cell { row, column: name, found: found.chars().take(40).collect(), wrong };
                let value = found.parse().map_err(|_| cell("is no number"))?;
                match wrong(column, value, before) {
                    Some(wrong) => return Err(cell(wrong)),
                    None => cells[column].push(value),
                }
            }
        }
        Self::from_cells(text, cells)
    }

    fn from_cells(text: &str, [places, widths, heights, angles, roundness]: [Vec<f64>; 5]) -> Result<Self, TableError> {
        if places.len() < 2 {
            return Err(TableError::Rows(places.len()));
        }
        let angles = angles.into_iter().map(f64::to_radians).collect();
        let columns = [widths, heights, angles, roundness];
        let columns = columns.map(|values| Column { slopes: monotone_slopes(&places, &values), values });
        Ok(Self { text: text.to_owned(), places, columns })
    }

    /// The text that it was read from.
    pub fn text(&self) -> &str {
        &self.text
    }
}

/// What is wrong with a number of a column, given the one before it.
fn wrong(column: usize, value: f64, before: Option<f64>) -> Option<&'static str> {
    let within = |low: f64, high: f64| (low..=high).contains(&value);
    match (column, before) {
        _ if !value.is_finite() => Some("is not finite"),
        (0, None) => (value != 0.0).then_some("is not 0, where the free end is"),
        (0, Some(before)) if value <= before => Some("does not ascend"),
        (0..=2, _) if value > LARGEST => Some("is more than 1e12"),
        (1 | 2, _) => (value <= 0.0).then_some("is not above zero"),
        (3, _) => (!within(-180.0, 180.0)).then_some("is not from -180 to 180"),
        (4, _) => (!within(0.0, 1.0)).then_some("is not from 0 to 1"),
        _ => None,
    }
}

/// Slopes of the monotone cubic through the points: where two chords go the same way their weighted harmonic mean, else zero; at
/// the ends the slope of a parabola through three points, kept from turning round.
fn monotone_slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chords: Vec<f64> = values.windows(2).zip(&steps).map(|(pair, step)| (pair[1] - pair[0]) / step).collect();
    let last = chords.len() - 1;
    if last == 0 {
        return vec![chords[0]; 2];
    }
    let end = |near: usize, next: usize| {
        let (h0, h1, d0, d1) = (steps[near], steps[next], chords[near], chords[next]);
        let slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
        if slope * d0 <= 0.0 {
            0.0
        } else if d0 * d1 <= 0.0 && slope.abs() > 3.0 * d0.abs() {
            3.0 * d0
        } else {
            slope
        }
    };
    let inside = |k: usize| {
        let (h0, h1, d0, d1) = (steps[k - 1], steps[k], chords[k - 1], chords[k]);
        if d0 * d1 <= 0.0 {
            return 0.0;
        }
        let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
        (w0 + w1) / (w0 / d0 + w1 / d1)
    };
    std::iter::once(end(0, 1)).chain((1..=last).map(inside)).chain(std::iter::once(end(last, last - 1))).collect()
}

impl Contour for ProfileTable {
    fn length(&self) -> f64 {
        self.places[self.places.len() - 1]
    }

    fn breaks(&self) -> Vec<f64> {
        self.places[1..self.places.len() - 1].to_vec()
    }

    fn at(&self, place: f64) -> Outline {
        let after = self.places.partition_point(|&row| row <= place).clamp(1, self.places.len() - 1);
        let (from, step) = (self.places[after - 1], self.places[after] - self.places[after - 1]);
        let t = (place - from) / step;
        // value and derivatives of the cubic from value and slope at its ends
        let cubic = |column: &Column| {
            let (y0, y1) = (column.values[after - 1], column.values[after]);
            let (m0, m1) = (step * column.slopes[after - 1], step * column.slopes[after]);
            let (square, cube) = (3.0 * (y1 - y0) - 2.0 * m0 - m1, 2.0 * (y0 - y1) + m0 + m1);
            [
                y0 + t * (m0 + t * (square + t * cube)),
                (m0 + t * (2.0 * square + 3.0 * t * cube)) / step,
                (2.0 * square + 6.0 * t * cube) / (step * step),
            ]
        };
        let [width, height, underside, roundness] = self.columns.each_ref().map(cubic);
        Outline { width: width[0], height, roundness: roundness[0], underside: [underside[0], underside[1]] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// scipy 1.17.1: PchipInterpolator([0, 1, 3, 4, 6], [1, 2, 2.5, 2.4, 5]) and its derivatives at 0.5, 2.2, 3.5 and 5.
    #[test]
    fn the_cubics_are_scipys() {
        let (places, values) = ([0.0, 1.0, 3.0, 4.0, 6.0], [1.0, 2.0, 2.5, 2.4, 5.0]);
        let rows: String =
            places.iter().zip(values).map(|(place, value)| format!("{place},{value},{value},{value},0\n")).collect();
        let table = ProfileTable::parse(&format!("s_nm,width_nm,height_nm,angle_deg,roundness\n{rows}")).unwrap();
        for (place, expected) in SCIPY {
            let outline = table.at(place);
            for (found, expected) in outline.height.into_iter().zip(expected) {
                assert_relative_eq!(found, expected, max_relative = 1e-12);
            }
            assert_relative_eq!(outline.underside[1], expected[1].to_radians(), max_relative = 1e-12);
        }
    }

    const SCIPY: [(f64, [f64; 3]); 4] = [
        (0.5, [1.6026785714285714, 1.0803571428571428, -0.8214285714285714]),
        (2.2, [2.4062857142857146, 0.22285714285714286, -0.23571428571428574]),
        (3.5, [2.4499999999999997, -0.15000000000000013, 0.0]),
        (5.0, [3.1416666666666666, 1.3916666666666666, 1.1166666666666667]),
    ];

    #[test]
    fn bad_tables_are_refused_by_name() {
        let refused = |text: &str| ProfileTable::parse(text).unwrap_err().to_string();
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
}
