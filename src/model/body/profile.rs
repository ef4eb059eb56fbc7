//! A beam whose width, height, direction and roundness are given by a table along S, or piece by piece.
//!
//! Between the rows of a table each is a monotone cubic (Fritsch and Butland's PCHIP: SIAM J. Sci. Stat. Comput. 5 (1984) 300), which has no
//! bulge that the table does not have. Its second derivative jumps at the rows, so elements end there.

use super::geometry::Geometry;
use super::pieces::ProfilePieces;
use crate::beam::section::Material;
use crate::beam::varying::{BeamGeometry, SectionGeometry};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A beam by a table or by pieces, and what it is made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// How width and height are given
    pub form: ProfileForm,
    /// What it is made of
    pub material: Material,
}

/// What gives the outline of a profile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProfileForm {
    /// By rows of numbers
    Table(ProfileTable),
    /// By pieces with a formula each
    Pieces(ProfilePieces),
}

impl ProfileForm {
    fn contour(&self) -> &dyn BeamGeometry {
        match self {
            Self::Table(table) => table,
            Self::Pieces(pieces) => pieces,
        }
    }
}

impl BeamGeometry for ProfileForm {
    fn length(&self) -> f64 {
        self.contour().length()
    }

    fn breaks(&self) -> Vec<f64> {
        self.contour().breaks()
    }

    fn at(&self, place: f64) -> SectionGeometry {
        self.contour().at(place)
    }
}

impl BeamGeometry for Profile {
    fn length(&self) -> f64 {
        self.form.length()
    }

    fn breaks(&self) -> Vec<f64> {
        self.form.breaks()
    }

    fn at(&self, place: f64) -> SectionGeometry {
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

    fn shared(&self) -> Arc<dyn BeamGeometry> {
        Arc::new(self.form.clone())
    }
}

/// The table: a row a place. It is written as its columns, and checked when it is read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Columns", into = "Columns")]
pub struct ProfileTable {
    /// S, nm
    places: Vec<f64>,
    /// Width (nm), height (nm), direction of the underside (rad) and roundness at the places.
    columns: [Vec<f64>; 4],
    /// Between two places each of them as a polynomial of the distance from the first: computed once, since every quadrature point asks for them.
    cubics: Vec<[Cubic; 4]>,
}

/// Coefficients of a polynomial of the third degree, the constant first.
type Cubic = [f64; 4];

/// The monotone cubics through values at places.
fn monotone_cubics(places: &[f64], values: &[f64]) -> Vec<Cubic> {
    let slopes = monotone_slopes(places, values);
    let between = |after: usize| {
        let step = places[after] - places[after - 1];
        let (y0, y1) = (values[after - 1], values[after]);
        let (m0, m1) = (step * slopes[after - 1], step * slopes[after]);
        let (square, cube) = (3.0 * (y1 - y0) - 2.0 * m0 - m1, 2.0 * (y0 - y1) + m0 + m1);
        [y0, slopes[after - 1], square / (step * step), cube / (step * step * step)]
    };
    (1..places.len()).map(between).collect()
}

/// A polynomial with its first two derivatives.
fn polynomial([c0, c1, c2, c3]: &Cubic, s: f64) -> [f64; 3] {
    [c0 + s * (c1 + s * (c2 + s * c3)), c1 + s * (2.0 * c2 + 3.0 * s * c3), 2.0 * c2 + 6.0 * s * c3]
}

/// The columns of a table, a number a row; the last two may be left empty and are zero all along then.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ProfileColumns {
    /// S, nm: 0 at the free end, and ascending
    pub places: Vec<f64>,
    /// nm
    pub widths: Vec<f64>,
    /// nm
    pub heights: Vec<f64>,
    /// Direction of the stress-free underside, degrees
    pub angles: Vec<f64>,
    /// 0: a rectangle, 1: an ellipse
    pub roundness: Vec<f64>,
}

/// The columns of a table as they are written: the angles as they are kept, in rad.
#[derive(Serialize, Deserialize)]
struct Columns {
    places: Vec<f64>,
    widths: Vec<f64>,
    heights: Vec<f64>,
    angles_rad: Vec<f64>,
    roundness: Vec<f64>,
}

impl From<ProfileTable> for Columns {
    fn from(table: ProfileTable) -> Self {
        let [widths, heights, angles_rad, roundness] = table.columns;
        Self { places: table.places, widths, heights, angles_rad, roundness }
    }
}

impl TryFrom<Columns> for ProfileTable {
    type Error = TableError;

    fn try_from(written: Columns) -> Result<Self, TableError> {
        let Columns { places, widths, heights, angles_rad, roundness } = written;
        let angles = angles_rad.iter().map(|angle| angle.to_degrees()).collect();
        let checked = Self::new(ProfileColumns { places, widths, heights, angles, roundness })?;
        if angles_rad.is_empty() {
            return Ok(checked);
        }
        let [widths, heights, _, roundness] = checked.columns;
        Ok(Self::through(checked.places, [widths, heights, angles_rad, roundness]))
    }
}

/// What is wrong with a table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TableError {
    #[error("has in row {row} `{column}` = {found}, which {wrong}")]
    Cell { row: usize, column: &'static str, found: String, wrong: &'static str },
    #[error("has {0} rows; it takes 2 to {most}", most = ProfileTable::MOST_ROWS)]
    Rows(usize),
    #[error("has {found} rows of `{column}` and {rows} of `s_nm`")]
    Uneven { column: &'static str, found: usize, rows: usize },
}

/// How many columns have to be given.
const NEEDED: usize = 3;
/// Places beyond this are taken for a slip, nm.
const LARGEST: f64 = 1e12;

impl Default for ProfileTable {
    /// A beam of unit length, width and height.
    fn default() -> Self {
        Self::through(vec![0.0, 1.0], [1.0, 1.0, 0.0, 0.0].map(|value| vec![value; 2]))
    }
}

impl ProfileTable {
    /// Names of the columns in texts and messages.
    pub const COLUMNS: [&str; 5] = ["s_nm", "width_nm", "height_nm", "angle_deg", "roundness"];
    /// Most rows: there is an element at least between two.
    pub const MOST_ROWS: usize = 200;

    /// Its columns, as it was made of them.
    pub fn columns(&self) -> ProfileColumns {
        let [widths, heights, angles, roundness] = self.columns.clone();
        let angles = angles.into_iter().map(f64::to_degrees).collect();
        ProfileColumns { places: self.places.clone(), widths, heights, angles, roundness }
    }

    /// The table of these columns, checked row by row. Rows are counted from 1 in an error.
    ///
    /// ```
    /// use peelkit::beam::BeamGeometry;
    /// use peelkit::model::{ProfileColumns, ProfileTable};
    ///
    /// let table = ProfileTable::new(ProfileColumns {
    ///     places: vec![0.0, 40.0, 100.0],
    ///     widths: vec![20.0, 20.0, 10.0],
    ///     heights: vec![5.0, 5.0, 10.0],
    ///     ..Default::default()
    /// })?;
    /// assert_eq!((table.length(), table.breaks()), (100.0, vec![40.0]));
    /// assert_eq!(table.at(30.0).height, [5.0, 0.0, 0.0]);
    /// # Ok::<(), peelkit::model::TableError>(())
    /// ```
    pub fn new(columns: ProfileColumns) -> Result<Self, TableError> {
        let ProfileColumns { places, widths, heights, angles, roundness } = columns;
        let mut cells = [places, widths, heights, angles, roundness];
        let longest = cells.iter().map(Vec::len).max().unwrap_or(0);
        for row in 0..longest.min(Self::MOST_ROWS) {
            for (column, values) in cells.iter().enumerate() {
                let Some(&value) = values.get(row) else { continue };
                let before = row.checked_sub(1).and_then(|before| values.get(before)).copied();
                if let Some(wrong) = wrong(column, value, before) {
                    let column = Self::COLUMNS[column];
                    return Err(TableError::Cell { row: row + 1, column, found: value.to_string(), wrong });
                }
            }
        }
        let rows = cells[0].len();
        if !(2..=Self::MOST_ROWS).contains(&rows) {
            return Err(TableError::Rows(rows));
        }
        for (index, values) in cells.iter_mut().enumerate() {
            if index >= NEEDED && values.is_empty() {
                values.resize(rows, 0.0);
            }
            if values.len() != rows {
                return Err(TableError::Uneven { column: Self::COLUMNS[index], found: values.len(), rows });
            }
        }
        let [places, widths, heights, angles, roundness] = cells;
        let angles = angles.into_iter().map(f64::to_radians).collect();
        Ok(Self::through(places, [widths, heights, angles, roundness]))
    }

    /// Of columns that are right.
    fn through(places: Vec<f64>, columns: [Vec<f64>; 4]) -> Self {
        let of = columns.each_ref().map(|values| monotone_cubics(&places, values));
        let cubics = (0..places.len() - 1).map(|interval| of.each_ref().map(|cubics| cubics[interval])).collect();
        Self { places, columns, cubics }
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
pub(crate) fn monotone_slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
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

impl BeamGeometry for ProfileTable {
    fn length(&self) -> f64 {
        self.places[self.places.len() - 1]
    }

    fn breaks(&self) -> Vec<f64> {
        self.places[1..self.places.len() - 1].to_vec()
    }

    fn at(&self, place: f64) -> SectionGeometry {
        let inner = &self.places[1..self.places.len() - 1];
        let interval = inner.partition_point(|&row| row <= place);
        let s = place - self.places[interval];
        let [width, height, underside, roundness] = self.cubics[interval].each_ref().map(|cubic| polynomial(cubic, s));
        SectionGeometry { width: width[0], height, roundness: roundness[0], underside: [underside[0], underside[1]] }
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
        let columns = ProfileColumns {
            places: places.to_vec(),
            widths: values.to_vec(),
            heights: values.to_vec(),
            angles: values.to_vec(),
            roundness: vec![0.0; 5],
        };
        let table = ProfileTable::new(columns).unwrap();
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
    fn bad_columns_are_refused_by_name() {
        let refused = |places: &[f64], widths: &[f64], heights: &[f64]| {
            let columns = ProfileColumns {
                places: places.to_vec(),
                widths: widths.to_vec(),
                heights: heights.to_vec(),
                ..Default::default()
            };
            ProfileTable::new(columns).unwrap_err().to_string()
        };
        assert_eq!(refused(&[], &[], &[]), "has 0 rows; it takes 2 to 200");
        assert_eq!(refused(&[0.0, 0.0], &[1.0; 2], &[1.0; 2]), "has in row 2 `s_nm` = 0, which does not ascend");
        assert_eq!(refused(&[0.0, 5.0], &[1.0; 2], &[1.0]), "has 1 rows of `height_nm` and 2 of `s_nm`");
    }
}
