//! Measured points: two columns of a CSV, whose header has names and units.

use super::columns::Columns;
use super::error::OverlayError;
use super::result::Kind;
use peelkit_scene::{Dimension, Key, parse_quantity};
use std::path::Path;

/// Measured points in the units of the results that they are drawn over.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Of the legend: the name of the file without its ending
    pub name: String,
    /// nm and nN, or the unit of the key and nN
    pub points: Vec<(f64, f64)>,
}

const REMEDY: &str =
    "Give two columns whose header has names and units, such as displacement_nm,force_nN or u (um),P (mN).";

impl Measured {
    /// Reads points to be drawn over results of a kind; `key` is what a sweep varies, where that is known.
    ///
    /// Fails with a file that cannot be read, has other columns than two, or other units than those of a length and a force (of
    /// the key and a force over a sweep).
    pub fn read(path: &Path, kind: Kind, key: Option<&Key>) -> Result<Self, OverlayError> {
        let columns = Columns::read(path)?;
        let wrong = |found: String| OverlayError::new(path, found, REMEDY);
        let [first, second] = &columns.header[..] else {
            return Err(wrong(format!("has {} columns", columns.header.len())));
        };
        let across = match (kind, key) {
            (Kind::Curve, _) => Some(Dimension::Length),
            (Kind::Sweep, Some(key)) => key.dimension(),
            (Kind::Sweep, None) => None,
        };
        let in_units = |x: &str, y: &str| Some((factor(x, across)?, factor(y, Some(Dimension::Force))?));
        // a table may have the force first
        let (swapped, (x, y)) = match (in_units(first, second), in_units(second, first)) {
            (Some(factors), _) => (false, factors),
            (None, Some(factors)) => (true, factors),
            (None, None) => {
                let what = across.map_or("a number".to_owned(), |dimension| dimension.to_string());
                return Err(wrong(format!(
                    "has the columns {first} and {second}, which are not {what} and a force with their units"
                )));
            }
        };
        let [xs, ys] = if swapped { [1, 0] } else { [0, 1] }.map(|column| columns.numbers(path, column));
        let points: Option<Vec<_>> = xs?.into_iter().zip(ys?).map(|(at, force)| Some((x * at?, y * force?))).collect();
        let points = points.ok_or_else(|| wrong("has a row with an empty cell".into()))?;
        if points.is_empty() {
            return Err(wrong("has a header and no rows".into()));
        }
        Ok(Self { name: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(), points })
    }
}

/// How many units of the library one of a column is whose name is followed by its unit; 1 where it has none and needs none.
pub(super) fn factor(column: &str, dimension: Option<Dimension>) -> Option<f64> {
    let Some(dimension) = dimension else { return unit_of(column).is_none_or(|unit| unit.is_empty()).then_some(1.0) };
    let read = |unit: &str| parse_quantity(&format!("1 {unit}"), dimension).ok();
    unit_of(column).and_then(read).or_else(|| read(column.rsplit_once('_')?.1))
}

/// The name of a column without the unit in brackets behind it.
pub(super) fn without_unit(column: &str) -> &str {
    column.split_once(['(', '[']).map_or(column, |(name, _)| name).trim()
}

/// What stands in brackets behind a name.
fn unit_of(column: &str) -> Option<&str> {
    let (_, rest) = column.split_once(['(', '['])?;
    rest.strip_suffix([')', ']']).map(str::trim)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_behind_the_names_of_columns() {
        for (column, factor_nm) in
            [("displacement_nm", 1.0), ("u (um)", 1e3), ("u [µm]", 1e3), ("x_mm", 1e6), ("tip displacement (nm)", 1.0)]
        {
            assert_eq!(factor(column, Some(Dimension::Length)), Some(factor_nm), "{column}");
        }
        for column in ["displacement", "force_nN", "u (mil)", "u", "nm"] {
            assert_eq!(factor(column, Some(Dimension::Length)), None, "{column}");
        }
        assert_eq!((factor("EI/EI0", None), factor("angle (deg)", None)), (Some(1.0), None));
    }
}
