//! A measured profile: heights at places.

use super::closest::{Graph, closest};
use super::surface::{ClosestPoint, Named, Surface};
use serde::{Deserialize, Serialize};

/// A cubic spline through heights, twice continuously differentiable (I. J. Schoenberg, Quart. Appl. Math. 4 (1946) 45), with no
/// curvature at its ends, behind which it goes on as a straight line. Its third derivative jumps at the places. It is written as its
/// places and heights, and checked when it is read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Rows", into = "Rows")]
pub struct Heights {
    /// nm, ascending
    places: Vec<f64>,
    /// nm
    values: Vec<f64>,
    /// f'' at the places, 1/nm
    bends: Vec<f64>,
    /// Highest and lowest height, largest f'' without its sign, and how far apart samples are taken.
    graph: [f64; 4],
}

/// A table of heights as it is written, nm.
#[derive(Serialize, Deserialize)]
struct Rows {
    places: Vec<f64>,
    heights: Vec<f64>,
}

impl From<Heights> for Rows {
    fn from(table: Heights) -> Self {
        Self { places: table.places, heights: table.values }
    }
}

impl TryFrom<Rows> for Heights {
    type Error = HeightsError;

    fn try_from(rows: Rows) -> Result<Self, HeightsError> {
        Self::new(rows.places, rows.heights)
    }
}

/// What is wrong with a table of heights.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum HeightsError {
    #[error("has in row {row} `{column}` = {found}, which {wrong}")]
    Cell { row: usize, column: &'static str, found: String, wrong: &'static str },
    #[error("has {0} rows; it takes 3 to {most}", most = Heights::MOST_ROWS)]
    Rows(usize),
    #[error("has {places} places and {heights} heights")]
    Uneven { places: usize, heights: usize },
}

/// Numbers beyond this are taken for a slip, nm.
const LARGEST: f64 = 1e9;
/// Places on the shortest wave.
const WAVE: f64 = 4.0;
/// Samples between two neighbouring places.
const SAMPLES: f64 = 4.0;

impl Heights {
    /// Names of the columns in texts and messages.
    pub const COLUMNS: [&str; 2] = ["x_nm", "height_nm"];
    /// Most rows.
    pub const MOST_ROWS: usize = 20_000;

    /// The spline through heights at places, both in nm, the places ascending; checked row by row. Rows are counted from 1 in an
    /// error.
    ///
    /// ```
    /// use peelkit::adhesion::Heights;
    ///
    /// let valley = Heights::new(vec![0.0, 50.0, 100.0], vec![0.0, -8.0, 0.0])?;
    /// assert_eq!(valley.at(50.0)[0], -8.0);
    /// assert_eq!(valley.at(-10.0)[2], 0.0);
    /// # Ok::<(), peelkit::adhesion::HeightsError>(())
    /// ```
    pub fn new(places: Vec<f64>, values: Vec<f64>) -> Result<Self, HeightsError> {
        for row in 0..places.len().max(values.len()).min(Self::MOST_ROWS) {
            for (column, cells) in [&places, &values].into_iter().enumerate() {
                let Some(&value) = cells.get(row) else { continue };
                let wrong = if value.is_nan() || value.abs() > LARGEST {
                    "is not from -1e9 to 1e9"
                } else if column == 0 && row > 0 && value <= cells[row - 1] {
                    "does not ascend"
                } else {
                    continue;
                };
                let column = Self::COLUMNS[column];
                return Err(HeightsError::Cell { row: row + 1, column, found: value.to_string(), wrong });
            }
        }
        if !(3..=Self::MOST_ROWS).contains(&places.len()) {
            return Err(HeightsError::Rows(places.len()));
        }
        if places.len() != values.len() {
            return Err(HeightsError::Uneven { places: places.len(), heights: values.len() });
        }
        Ok(Self::through(places, values))
    }

    fn through(places: Vec<f64>, values: Vec<f64>) -> Self {
        let bends = bends(&places, &values);
        let mut heights = Self { places, values, bends, graph: [0.0; 4] };
        let (mut top, mut bottom) = (f64::NEG_INFINITY, f64::INFINITY);
        for pair in heights.places.windows(2) {
            for k in 0..=SAMPLES as usize {
                let [height, ..] = heights.at(pair[0] + (pair[1] - pair[0]) * k as f64 / SAMPLES);
                (top, bottom) = (height.max(top), height.min(bottom));
            }
        }
        let bend = heights.bends.iter().fold(0.0, |most: f64, bend| most.max(bend.abs()));
        heights.graph = [top, bottom, bend, heights.least() / SAMPLES];
        heights
    }

    /// Level ground at three places.
    pub fn level() -> Self {
        Self::through(vec![0.0, 1.0, 2.0], vec![0.0; 3])
    }

    /// The least distance of two places, nm.
    fn least(&self) -> f64 {
        self.places.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min)
    }

    /// First and last place, nm.
    pub fn span(&self) -> (f64, f64) {
        (self.places[0], self.places[self.places.len() - 1])
    }

    /// y and its first three derivatives.
    pub fn at(&self, x: f64) -> [f64; 4] {
        let last = self.places.len() - 1;
        let after = self.places.partition_point(|&place| place <= x);
        if after == 0 || after > last {
            // straight on from an end
            let (end, panel) = if after == 0 { (0, 1) } else { (last, last) };
            let [height, slope, ..] = self.within(panel, self.places[end]);
            return [height + slope * (x - self.places[end]), slope, 0.0, 0.0];
        }
        self.within(after, x)
    }

    /// The same on the panel that ends at the place `after`.
    fn within(&self, after: usize, x: f64) -> [f64; 4] {
        let (from, to) = (self.places[after - 1], self.places[after]);
        let (y0, y1, m0, m1) = (self.values[after - 1], self.values[after], self.bends[after - 1], self.bends[after]);
        let step = to - from;
        let (a, b) = ((to - x) / step, (x - from) / step);
        let six = step * step / 6.0;
        [
            a * y0 + b * y1 + six * ((a * a * a - a) * m0 + (b * b * b - b) * m1),
            (y1 - y0) / step + step / 6.0 * ((1.0 - 3.0 * a * a) * m0 + (3.0 * b * b - 1.0) * m1),
            a * m0 + b * m1,
            (m1 - m0) / step,
        ]
    }
}

/// As scenes name it.
pub(super) const NAMED: &[Named<Heights>] = &[("profile", Heights::level)];

impl Surface for Heights {
    fn name(&self) -> &'static str {
        "profile"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["table", "start"]
    }

    fn clearance(&self, x: f64, y: f64) -> f64 {
        y - self.at(x)[0]
    }

    /// The length of the shortest wave that it can tell, nm: four times the least distance of two places.
    fn feature_length(&self) -> f64 {
        WAVE * self.least()
    }

    fn peak_to_valley(&self) -> f64 {
        let [top, bottom, ..] = self.graph;
        top - bottom
    }

    fn project(&self, x: f64, y: f64) -> ClosestPoint {
        let [top, bottom, bend, step] = self.graph;
        // behind its ends it goes on straight, and may be higher there than anywhere
        let reach = (y - self.at(x)[0]).abs();
        let (from, to) = self.span();
        let before = self.at(from)[0] - self.at(from)[1] * (x - reach - from).min(0.0).abs();
        let behind = self.at(to)[0] + self.at(to)[1] * (x + reach - to).max(0.0);
        let ceiling = [before, behind].into_iter().fold(top, f64::max);
        closest(|s| self.at(s), &Graph { ceiling, top, bottom, bend, step }, [x; 2], (x, y))
    }

    /// The highest place of the table or point between its places, nm.
    fn top(&self, from: f64, to: f64) -> f64 {
        let ends = self.at(from)[0].max(self.at(to)[0]);
        let samples = (((to - from) / self.graph[3]).ceil()).clamp(1.0, 1e5) as usize;
        (0..=samples).map(|k| self.at(from + (to - from) * k as f64 / samples as f64)[0]).fold(ends, f64::max)
    }
}

/// f'' at the places of the natural spline: tridiagonal, by elimination from the left.
fn bends(places: &[f64], values: &[f64]) -> Vec<f64> {
    let n = places.len();
    let step = |k: usize| places[k + 1] - places[k];
    let chord = |k: usize| (values[k + 1] - values[k]) / step(k);
    let (mut above, mut right) = (vec![0.0; n], vec![0.0; n]);
    for k in 1..n - 1 {
        let pivot = 2.0 * (step(k - 1) + step(k)) - step(k - 1) * above[k - 1];
        above[k] = step(k) / pivot;
        right[k] = (6.0 * (chord(k) - chord(k - 1)) - step(k - 1) * right[k - 1]) / pivot;
    }
    let mut bends = vec![0.0; n];
    for k in (1..n - 1).rev() {
        bends[k] = right[k] - above[k] * bends[k + 1];
    }
    bends
}
