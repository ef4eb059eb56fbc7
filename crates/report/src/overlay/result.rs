//! A result of an earlier command, read from its table.

use super::columns::Columns;
use super::error::OverlayError;
use crate::swept;
use peelkit_scene::{KEYS, Key};
use std::path::{Path, PathBuf};

/// What a table holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// curve.csv: force against displacement
    Curve,
    /// sweep.csv: peak force against the varied value
    Sweep,
}

impl Kind {
    /// The name of the table.
    pub fn file(self) -> &'static str {
        match self {
            Self::Curve => "curve.csv",
            Self::Sweep => "sweep.csv",
        }
    }

    /// The columns that are drawn.
    fn columns(self) -> [&'static str; 2] {
        match self {
            Self::Curve => ["displacement_nm", "force_nN"],
            Self::Sweep => ["value", "peak_force_nN"],
        }
    }
}

/// A result: what the legend calls it, and its points.
#[derive(Clone, Debug)]
pub struct ResultFile {
    /// Of the legend
    pub name: String,
    /// What its points are
    pub kind: Kind,
    /// Pieces of one kind, each with whether it is unstable under displacement control; nm and nN, or the unit of the key and nN
    pub pieces: Vec<(bool, Vec<(f64, f64)>)>,
    /// The key that a sweep varies, where its table names it
    pub key: Option<&'static Key>,
}

impl ResultFile {
    /// Reads the table of a folder that `peel run` or `peel sweep` has written, or the table itself.
    ///
    /// Fails with a file that cannot be read or is no such table.
    pub fn read(path: &Path) -> Result<Self, OverlayError> {
        let (table, kind) = table_of(path)?;
        let columns = Columns::read(&table)?;
        let place = |name: &str| columns.header.iter().position(|found| found == name);
        let [x, y] = kind.columns();
        let (Some(x), Some(y)) = (place(x), place(y)) else {
            return Err(OverlayError::new(
                &table,
                format!("lacks one of the columns {x} and {y}"),
                "Give a folder that peel run or peel sweep has written.",
            ));
        };
        let (xs, ys) = (columns.numbers(&table, x)?, columns.numbers(&table, y)?);
        let unstable = match place("negative_eigenvalues").filter(|_| kind == Kind::Curve) {
            Some(column) => columns.numbers(&table, column)?.iter().map(|count| count.unwrap_or(0.0) > 0.0).collect(),
            None => vec![false; xs.len()],
        };
        let points: Vec<_> = xs.into_iter().zip(ys).map(|(x, y)| Some((x?, y?))).zip(unstable).collect();
        let pieces = pieces(&points);
        if pieces.is_empty() {
            return Err(OverlayError::new(&table, "has no points to draw", "Leave it out, or run its command again."));
        }
        let key = KEYS.iter().find(|key| columns.header.iter().any(|name| names(key, name)));
        Ok(Self { name: path.display().to_string(), kind, pieces, key: key.filter(|_| kind == Kind::Sweep) })
    }

    /// Shortens the names of results to the last parts of their paths by which they differ.
    pub fn shorten(results: &mut [Self]) {
        let parts = |name: &str, count: usize| {
            let parts: Vec<&str> = name.split(['/', '\\']).filter(|part| !part.is_empty() && *part != ".").collect();
            parts[parts.len().saturating_sub(count)..].join("/")
        };
        let names: Vec<String> = results.iter().map(|result| result.name.clone()).collect();
        let differ = |count: &usize| {
            let mut short: Vec<String> = names.iter().map(|name| parts(name, *count)).collect();
            short.sort();
            short.windows(2).all(|pair| pair[0] != pair[1])
        };
        if let Some(count) = (1..=8).find(differ) {
            results.iter_mut().for_each(|result| result.name = parts(&result.name, count));
        }
    }
}

/// Whether a column is that of the key: its path, with its unit behind it, or that of the library.
fn names(key: &Key, column: &str) -> bool {
    [key.usual_unit(), key.unit()].iter().any(|unit| column == swept::column(key, unit))
}

/// The table that a path means.
fn table_of(path: &Path) -> Result<(PathBuf, Kind), OverlayError> {
    let kinds = [Kind::Curve, Kind::Sweep];
    if path.is_file() {
        let name = path.file_name().unwrap_or_default();
        let kind = kinds.into_iter().find(|kind| name == kind.file());
        return kind.map(|kind| (path.to_path_buf(), kind)).ok_or_else(|| {
            OverlayError::new(path, "is neither a curve.csv nor a sweep.csv", "Measured points are given with --data.")
        });
    }
    let found: Vec<_> =
        kinds.into_iter().map(|kind| (path.join(kind.file()), kind)).filter(|(file, _)| file.is_file()).collect();
    match <[_; 1]>::try_from(found) {
        Ok([one]) => Ok(one),
        Err(found) if found.is_empty() => Err(OverlayError::new(
            path,
            "has neither a curve.csv nor a sweep.csv",
            "Give a folder that peel run or peel sweep has written, such as out/strip.",
        )),
        Err(_) => Err(OverlayError::new(
            path,
            "has both a curve.csv and a sweep.csv",
            "Give the table itself, such as out/strip/curve.csv.",
        )),
    }
}

/// Lines of one kind, which share their end points; they break where a point is missing.
fn pieces(points: &[(Option<(f64, f64)>, bool)]) -> Vec<(bool, Vec<(f64, f64)>)> {
    let mut pieces: Vec<(bool, Vec<(f64, f64)>)> = Vec::new();
    let mut open = false;
    for &(point, unstable) in points {
        let Some(point) = point else {
            open = false;
            continue;
        };
        match pieces.last_mut().filter(|_| open) {
            Some((kind, line)) if *kind == unstable => line.push(point),
            Some((_, line)) => {
                let joint = line[line.len() - 1];
                pieces.push((unstable, vec![joint, point]));
            }
            None => pieces.push((unstable, vec![point])),
        }
        open = true;
    }
    pieces
}
