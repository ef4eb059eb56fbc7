//! A cohesive law that was measured: tractions at openings, and a curve through them that overshoots nowhere.
//!
//! Between two rows the traction is a cubic with a continuous slope. The slope at a row is the weighted harmonic mean of those of the two chords
//! beside it, and zero at a row from which the chords lead to one side. So the curve rises and falls as the rows do, and its largest traction is that
//! of a row. At zero opening the slope is that of the parabola through the first three rows, between half and three times the first chord's: it holds
//! the face where it is closed, and repels it where it is pressed. Behind the last row, whose traction is zero with a level slope, nothing pulls.
//! Potential and moments are integrals of cubics.
//!
//! Source: F. N. Fritsch, J. Butland, A method for constructing local monotone piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5 (1984) 300,
//! for rows at unequal distances.

use super::at::At;
use serde::{Deserialize, Serialize};
use std::sync::Mutex;

pub(super) const NAME: &str = "table";
/// Where elements are not cut at the rows.
pub(super) const CORNERS: f64 = 5.0;

/// Rows of measured openings and tractions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Rows", into = "Rows")]
pub struct TractionTable {
    /// nm, ascending from 0
    openings: Vec<f64>,
    /// nN/nm², 0 in the first row and in the last, above zero between
    tractions: Vec<f64>,
}

/// A table of tractions as it is written.
#[derive(Serialize, Deserialize)]
struct Rows {
    openings: Vec<f64>,
    tractions: Vec<f64>,
}

impl From<TractionTable> for Rows {
    fn from(table: TractionTable) -> Self {
        Self { openings: table.openings, tractions: table.tractions }
    }
}

impl TryFrom<Rows> for TractionTable {
    type Error = TractionTableError;

    fn try_from(rows: Rows) -> Result<Self, TractionTableError> {
        Self::new(rows.openings, rows.tractions)
    }
}

/// What is wrong with a table of tractions. Rows are counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TractionTableError {
    #[error("has {0} rows; it takes {least} to {most}", least = TractionTable::LEAST_ROWS, most = TractionTable::MOST_ROWS)]
    Rows(usize),
    #[error("has {openings} openings and {tractions} tractions")]
    Uneven { openings: usize, tractions: usize },
    /// Of row `row`, counted from 1
    #[error("{wrong}")]
    Row { row: usize, column: usize, wrong: &'static str },
}

impl Default for TractionTable {
    /// Up to 1 nN/nm² at 1 nm, and down to nothing at 2 nm.
    fn default() -> Self {
        Self { openings: vec![0.0, 1.0, 2.0], tractions: vec![0.0, 1.0, 0.0] }
    }
}

impl TractionTable {
    /// Fewest rows and most: every row that an element passes takes a piece of it.
    pub(crate) const LEAST_ROWS: usize = 3;
    /// Most rows
    pub const MOST_ROWS: usize = 200;

    /// Openings, nm, ascending from 0, and tractions, nN/nm²: 0 in the first row and in the last, above zero between.
    ///
    /// ```
    /// use peelkit::adhesion::TractionTable;
    ///
    /// let table = TractionTable::new(vec![0.0, 1.0, 4.0], vec![0.0, 0.2, 0.0])?;
    /// assert_eq!(table.strength(), 0.2);
    /// # Ok::<(), peelkit::adhesion::TractionTableError>(())
    /// ```
    ///
    /// # Errors
    /// Too few or too many rows, and the first row that is wrong, with its column: 0 for the opening, 1 for the traction.
    pub fn new(openings: Vec<f64>, tractions: Vec<f64>) -> Result<Self, TractionTableError> {
        if openings.len() != tractions.len() {
            return Err(TractionTableError::Uneven { openings: openings.len(), tractions: tractions.len() });
        }
        let last = openings.len().saturating_sub(1);
        for row in 0..openings.len() {
            let (opening, traction) = (openings[row], tractions[row]);
            let wrong = |column, wrong| Err(TractionTableError::Row { row: row + 1, column, wrong });
            if !opening.is_finite() {
                return wrong(0, "is not finite");
            }
            if !traction.is_finite() {
                return wrong(1, "is not finite");
            }
            match row {
                0 if opening != 0.0 => return wrong(0, "is not 0: the first row is the closed face"),
                0 if traction != 0.0 => return wrong(1, "is not 0: a closed face is at rest without a traction"),
                0 => continue,
                _ => {}
            }
            if opening <= openings[row - 1] {
                return wrong(0, "does not ascend");
            }
            if row < last && traction <= 0.0 {
                return wrong(1, "is not above zero between the first row and the last");
            }
            if row == last && traction != 0.0 {
                return wrong(1, "is not 0: the last row is where the face has come off");
            }
        }
        if !(Self::LEAST_ROWS..=Self::MOST_ROWS).contains(&openings.len()) {
            return Err(TractionTableError::Rows(openings.len()));
        }
        Ok(Self { openings, tractions })
    }

    /// As one text, which [`Self::of_text`] reads.
    pub(in crate::adhesion) fn text(&self) -> String {
        let row = |(opening, traction)| format!("{opening} {traction}");
        let rows: Vec<String> = self.openings.iter().zip(&self.tractions).map(row).collect();
        format!("{NAME}: {}", rows.join(", "))
    }

    /// From the text of a table; none where it is none.
    pub(in crate::adhesion) fn of_text(text: &str) -> Option<Self> {
        let rows = text.strip_prefix(NAME)?.strip_prefix(": ")?;
        let row = |row: &str| row.split_once(' ').and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
        let (openings, tractions) = rows.split(", ").map(row).collect::<Option<Vec<(f64, f64)>>>()?.into_iter().unzip();
        Self::new(openings, tractions).ok()
    }

    /// How many rows it has.
    pub fn rows(&self) -> usize {
        self.openings.len()
    }

    /// The largest traction, nN/nm².
    pub fn strength(&self) -> f64 {
        self.tractions.iter().copied().fold(0.0, f64::max)
    }

    /// The opening of the last row, nm.
    pub fn range(&self) -> f64 {
        self.openings.last().copied().unwrap_or(0.0)
    }

    /// The integral of the curve over all openings, nN/nm.
    pub fn work(&self) -> f64 {
        self.strength() * self.range() * MeasuredShape::through(self).at(0.0)[0]
    }
}

/// The curve through a table, over its largest traction and its last opening. It lives as long as the program, so that a model that has one is copied
/// like any other.
#[derive(Clone, Copy, Debug)]
pub struct Measured(&'static MeasuredShape);

/// One curve is kept for one table, however often it is read.
static KEPT: Mutex<Vec<&'static MeasuredShape>> = Mutex::new(Vec::new());

impl Measured {
    /// The curve through a table. Its memory is kept to the end of the program, once for each table.
    pub fn through(table: &TractionTable) -> Self {
        // what a panic elsewhere left is whole: it grows by one element at a time
        let mut kept = KEPT.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(known) = kept.iter().find(|known| known.table == *table) {
            return Self(known);
        }
        let shape: &'static MeasuredShape = Box::leak(Box::new(MeasuredShape::through(table)));
        kept.push(shape);
        Self(shape)
    }

    /// The rows that it goes through.
    pub fn table(self) -> &'static TractionTable {
        &self.0.table
    }

    #[inline]
    pub(super) fn at(self, t: f64) -> At {
        self.0.at(t)
    }

    #[inline]
    pub(super) fn primitive(self, t: f64) -> f64 {
        self.0.primitive(t)
    }

    pub(super) fn knots(self) -> &'static [f64] {
        &self.0.places
    }

    /// The last row with a thousandth of the strength, behind which the traction falls to nothing.
    pub(super) fn last_top(self) -> f64 {
        let last = self.0.rows.iter().rposition(|row| row[0] > 1e-3);
        last.map_or(0.0, |last| self.0.places[last])
    }
}

/// The same table.
impl PartialEq for Measured {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

impl Eq for Measured {}

/// Pieces of a curve, each with what lies behind it.
#[derive(Debug)]
struct MeasuredShape {
    table: TractionTable,
    /// t of the rows, from 0 to 1
    places: Vec<f64>,
    /// s there, its slope, ∫ s from there on, and the integral of that
    rows: Vec<[f64; 4]>,
}

impl MeasuredShape {
    fn through(table: &TractionTable) -> Self {
        let (range, strength) = (table.range(), table.strength());
        let places: Vec<f64> = table.openings.iter().map(|opening| opening / range).collect();
        let values: Vec<f64> = table.tractions.iter().map(|traction| traction / strength).collect();
        let slopes = slopes(&places, &values);
        let mut rows: Vec<[f64; 4]> = values.iter().zip(&slopes).map(|(&s, &slope)| [s, slope, 0.0, 0.0]).collect();
        for k in (1..rows.len()).rev() {
            let length = places[k] - places[k - 1];
            let [work, twice] = [rows[k][2], rows[k][3]];
            let cubic = Cubic::between(length, rows[k - 1], rows[k]);
            let [whole, twice_whole] = [cubic.integral(length), cubic.twice_integral(length)];
            rows[k - 1][2] = work + whole;
            // ∫ (W - ∫ s) over the piece, W the integral from its beginning on
            rows[k - 1][3] = twice + (work + whole) * length - twice_whole;
        }
        Self { table: table.clone(), places, rows }
    }

    /// The last row that is not behind t, for 0 < t < 1.
    fn piece(&self, t: f64) -> usize {
        self.places.partition_point(|&place| place <= t) - 1
    }

    fn at(&self, t: f64) -> At {
        if t <= 0.0 {
            let [_, slope, work, _] = self.rows[0];
            return [work - 0.5 * slope * t * t, slope * t, slope];
        }
        if t >= 1.0 {
            return [0.0; 3];
        }
        let (cubic, x, [.., work, _]) = self.of(t);
        [work - cubic.integral(x), cubic.value(x), cubic.slope(x)]
    }

    fn primitive(&self, t: f64) -> f64 {
        if t <= 0.0 {
            let [_, slope, work, twice] = self.rows[0];
            return twice - work * t + slope * t * t * t / 6.0;
        }
        if t >= 1.0 {
            return 0.0;
        }
        let (cubic, x, [.., work, twice]) = self.of(t);
        twice - work * x + cubic.twice_integral(x)
    }

    /// The piece at t, how far it lies behind its beginning, and the row there.
    fn of(&self, t: f64) -> (Cubic, f64, [f64; 4]) {
        let k = self.piece(t);
        let row = self.rows[k];
        (Cubic::between(self.places[k + 1] - self.places[k], row, self.rows[k + 1]), t - self.places[k], row)
    }
}

/// c0 + c1 x + c2 x² + c3 x³
struct Cubic([f64; 4]);

impl Cubic {
    /// With these values and slopes at 0 and at `length`.
    fn between(length: f64, [from, leaves, ..]: [f64; 4], [to, arrives, ..]: [f64; 4]) -> Self {
        let chord = (to - from) / length;
        let bend = (3.0 * chord - 2.0 * leaves - arrives) / length;
        Self([from, leaves, bend, (leaves + arrives - 2.0 * chord) / (length * length)])
    }

    fn value(&self, x: f64) -> f64 {
        let [a, b, c, d] = self.0;
        a + x * (b + x * (c + x * d))
    }

    fn slope(&self, x: f64) -> f64 {
        let [_, b, c, d] = self.0;
        b + x * (2.0 * c + x * 3.0 * d)
    }

    fn integral(&self, x: f64) -> f64 {
        let [a, b, c, d] = self.0;
        x * (a + x * (b / 2.0 + x * (c / 3.0 + x * d / 4.0)))
    }

    fn twice_integral(&self, x: f64) -> f64 {
        let [a, b, c, d] = self.0;
        x * x * (a / 2.0 + x * (b / 6.0 + x * (c / 12.0 + x * d / 20.0)))
    }
}

/// The slopes of the curve at its rows.
fn slopes(places: &[f64], values: &[f64]) -> Vec<f64> {
    let lengths: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chords: Vec<f64> = values.windows(2).zip(&lengths).map(|(pair, length)| (pair[1] - pair[0]) / length).collect();
    let mut slopes = vec![0.0; places.len()];
    let [first, second] = [lengths[0], lengths[1]];
    let parabola = ((2.0 * first + second) * chords[0] - first * chords[1]) / (first + second);
    slopes[0] = parabola.clamp(0.5 * chords[0], 3.0 * chords[0]);
    for k in 1..places.len() - 1 {
        let [before, behind] = [chords[k - 1], chords[k]];
        if before * behind > 0.0 {
            let [of_before, of_behind] = [lengths[k - 1] + 2.0 * lengths[k], 2.0 * lengths[k - 1] + lengths[k]];
            slopes[k] = (of_before + of_behind) / (of_before / before + of_behind / behind);
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    /// Rows at unequal distances, with two that are level and a second maximum.
    fn table() -> TractionTable {
        let openings = vec![0.0, 0.7, 1.0, 2.2, 2.5, 4.0, 5.0, 9.0];
        TractionTable::new(openings, vec![0.0, 0.15, 0.2, 0.2, 0.12, 0.13, 0.05, 0.0]).unwrap()
    }

    #[test]
    fn its_text_is_read_as_it_was_written() {
        assert_eq!(TractionTable::of_text(&table().text()), Some(table()));
        for wrong in ["table", "bilinear", "table: 0 0, 1", "table: 0 0, 1 x, 2 0", "table: 1 0, 2 1, 3 0"] {
            assert_eq!(TractionTable::of_text(wrong), None, "{wrong}");
        }
    }

    /// An exponential law of strength 1 at the opening 1, up to `last` in so many rows, which become sparser.
    fn exponential(rows: usize, last: f64) -> TractionTable {
        let share = |k: usize| k as f64 / (rows - 1) as f64;
        let openings: Vec<f64> = (0..rows).map(|k| last * share(k) * (0.3 + 0.7 * share(k))).collect();
        let mut tractions: Vec<f64> = openings.iter().map(|t| t * (1.0 - t).exp()).collect();
        tractions[rows - 1] = 0.0;
        TractionTable::new(openings, tractions).unwrap()
    }

    #[test]
    fn each_is_minus_the_slope_of_the_one_before() {
        let curve = Measured::through(&table());
        let d = 1e-4;
        for k in -30..112 {
            let t = 0.009_13 * f64::from(k);
            // at a row the slope has a corner
            if curve.knots().iter().any(|row| (row - t).abs() < 3.0 * d) {
                continue;
            }
            let slope =
                |f: &dyn Fn(f64) -> f64| (8.0 * (f(t + d) - f(t - d)) - (f(t + 2.0 * d) - f(t - 2.0 * d))) / (12.0 * d);
            let [work, s, rise] = curve.at(t);
            assert_abs_diff_eq!(-slope(&|t| curve.primitive(t)), work, epsilon = 1e-9);
            assert_abs_diff_eq!(-slope(&|t| curve.at(t)[0]), s, epsilon = 1e-9);
            assert_abs_diff_eq!(slope(&|t| curve.at(t)[1]), rise, epsilon = 1e-9);
        }
        assert_eq!((curve.at(1.0), curve.primitive(1.0)), ([0.0; 3], 0.0));
    }

    /// Through every row, with the row's traction the largest, and from row to row without another maximum.
    #[test]
    fn the_curve_goes_as_the_rows_do() {
        let rows = table();
        let curve = Measured::through(&rows);
        let traction = |opening: f64| rows.strength() * curve.at(opening / rows.range())[1];
        for k in 1..rows.openings.len() {
            let [from, to] = [rows.openings[k - 1], rows.openings[k]];
            assert_relative_eq!(traction(to), rows.tractions[k], epsilon = 1e-15, max_relative = 1e-13);
            let rise = rows.tractions[k] - rows.tractions[k - 1];
            let values: Vec<f64> = (0..=50).map(|j| traction(from + (to - from) * f64::from(j) / 50.0)).collect();
            assert!(values.windows(2).all(|pair| (pair[1] - pair[0]) * rise >= -1e-15), "row {k}: {values:?}");
            assert!(rise != 0.0 || values.iter().all(|value| (value - rows.tractions[k]).abs() < 1e-15));
        }
    }

    /// Of a law that is known the traction is wrong by most at its top, nearly by the square of the distance of the rows, and the work by far less; what
    /// is cut off is behind 20.
    #[test]
    fn rows_of_a_known_law_give_that_law() {
        let error = |rows: usize| {
            let rows = exponential(rows, 20.0);
            let curve = Measured::through(&rows);
            let off = |k: u32| {
                let t = 20.0 * f64::from(k) / 4000.0;
                (rows.strength() * curve.at(t / 20.0)[1] - t * (1.0 - t).exp()).abs()
            };
            let work = (rows.work() / std::f64::consts::E - 1.0).abs();
            ((0..=4000).map(off).fold(0.0, f64::max), work)
        };
        let [coarse, fine] = [50, 200].map(error);
        assert!(coarse.0 < 4e-3 && fine.0 < 4e-4, "{coarse:?} {fine:?}");
        assert!(coarse.1 < 4e-5 && fine.1 < 2e-7, "{coarse:?} {fine:?}");
    }

    #[test]
    fn the_first_wrong_row_is_named() {
        let refused = |rows: &[[f64; 2]]| {
            let [openings, tractions] = [0, 1].map(|column| rows.iter().map(|row| row[column]).collect());
            match TractionTable::new(openings, tractions).unwrap_err() {
                TractionTableError::Row { row, column, wrong } => (row, column, wrong.split(':').next().unwrap()),
                other => panic!("{other}"),
            }
        };
        assert_eq!(refused(&[[0.1, 0.0], [1.0, 1.0], [2.0, 0.0]]), (1, 0, "is not 0"));
        assert_eq!(refused(&[[0.0, 0.5], [1.0, 1.0], [2.0, 0.0]]), (1, 1, "is not 0"));
        assert_eq!(refused(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0]]), (3, 0, "does not ascend"));
        assert_eq!(refused(&[[0.0, 0.0], [1.0, f64::NAN], [2.0, 0.0]]), (2, 1, "is not finite"));
        assert_eq!(refused(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.1]]), (3, 1, "is not 0"));
        let between = "is not above zero between the first row and the last";
        assert_eq!(refused(&[[0.0, 0.0], [1.0, -1.0], [2.0, 0.0]]), (2, 1, between));
        let few = TractionTable::new(vec![0.0, 1.0], vec![0.0, 0.0]).unwrap_err();
        assert_eq!(few.to_string(), "has 2 rows; it takes 3 to 200");
    }
}
