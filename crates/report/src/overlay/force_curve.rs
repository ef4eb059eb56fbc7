//! A measured force-displacement curve with its standard errors, or steady forces against a key of the scene: columns of a CSV as a testing machine
//! writes it.

use super::columns::Columns;
use super::error::OverlayError;
use super::measured::{factor, without_unit};
use peelkit::study::MeasuredPoint;
use peelkit_scene::{Dimension, FitColumns, KEYS, Key};
use std::path::Path;

const REMEDY: &str = "Give a column of displacements and one of forces, with names and units, such as displacement_nm,force_nN or u (um),P (mN); \
                      and, if it is known, a third one with the standard error of the forces, such as force_error_nN. Of several alike name those that \
                      are meant: fit.columns = { displacement = \"Extension (mm)\", force = \"Load (N)\" }.";
/// In the name of a column of standard errors.
const ERROR_WORDS: [&str; 5] = ["error", "sigma", "std", "uncertainty", "deviation"];

/// What a column holds.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    Displacement,
    Force,
    ForceError,
}

impl Role {
    fn words(self) -> &'static str {
        match self {
            Self::Displacement => "displacements",
            Self::Force => "forces",
            Self::ForceError => "standard errors of forces",
        }
    }
}

/// What was measured.
#[derive(Clone, Debug)]
pub struct ForceRecord {
    /// In the order of the file: displacements in nm, or values of the key in the unit of the library; forces and their standard errors in nN
    pub points: Vec<MeasuredPoint>,
    /// The key against which steady forces were measured; none of a curve
    pub against: Option<&'static Key>,
}

/// A column, and how many units of the library its unit is.
type Found = (usize, f64);

/// Reads a measured curve; or, where a column has the name of a key of a scene that is a number, `drive.angle (deg)`, steady forces against it. `named` are the columns that hold these; of one
/// that is not named it is the only one with a unit of its dimension. A force per width is one over the `width` of the body, nm.
///
/// Fails with a file that cannot be read, without such a column or with several alike, a cell of these that holds no number, and a standard error that
/// is not above zero.
pub fn read_force_curve(path: &Path, named: &FitColumns, width: Option<f64>) -> Result<ForceRecord, OverlayError> {
    let columns = Columns::read_record(path)?;
    let wrong = |found: String| OverlayError::new(path, found, REMEDY);
    let varied = varied(&columns).map_err(wrong)?;
    let key = varied.map(|(_, (column, _))| column);
    let of = |role: Role, name: &Option<String>| match name {
        Some(name) => by_name(&columns, role, name, width).map(Some).map_err(wrong),
        None => by_unit(&columns, role, named, width, key).map_err(wrong),
    };
    let (across, force) = match varied {
        Some((_, found)) => (Some(found), of(Role::Force, &named.force)?),
        None => (of(Role::Displacement, &named.displacement)?, of(Role::Force, &named.force)?),
    };
    let error = of(Role::ForceError, &named.force_error)?;
    let (Some(across), Some(force)) = (across, force) else {
        let missing = if across.is_none() { Role::Displacement } else { Role::Force };
        return Err(wrong(format!("has the columns {}, and none of {}", columns.header.join(", "), missing.words())));
    };
    let numbers = |(column, of): Found| -> Result<Vec<f64>, OverlayError> {
        let cells = columns.numbers(path, column)?;
        let empty = cells.iter().position(Option::is_none);
        if let Some(row) = empty {
            return Err(wrong(format!("has in row {} no `{}`", row + 1, columns.header[column])));
        }
        Ok(cells.into_iter().flatten().map(|number| of * number).collect())
    };
    let (places, forces) = (numbers(across)?, numbers(force)?);
    let errors = error.map(numbers).transpose()?;
    if let Some(row) = errors.iter().flatten().position(|&error| error <= 0.0) {
        return Err(wrong(format!("has in row {} a standard error that is not above zero", row + 1)));
    }
    let error = |row: usize| errors.as_ref().map(|errors| errors[row]);
    let point = |row: usize| MeasuredPoint { displacement: places[row], force: forces[row], force_error: error(row) };
    Ok(ForceRecord { points: (0..places.len()).map(point).collect(), against: varied.map(|(key, _)| key) })
}

/// The column that has the name of a key, and that key.
fn varied(columns: &Columns) -> Result<Option<(&'static Key, Found)>, String> {
    let key =
        |name: &String| KEYS.iter().find(|key| key.is_numeric() && !key.is_count() && key.path() == without_unit(name));
    let found = columns.header.iter().enumerate().find_map(|(column, name)| Some((column, name, key(name)?)));
    let Some((column, name, key)) = found else { return Ok(None) };
    match factor(name, key.dimension()) {
        Some(of) => Ok(Some((key, (column, of)))),
        None => {
            Err(format!("has the column `{name}`, whose key takes a unit: `{} ({})`", key.path(), key.usual_unit()))
        }
    }
}

/// How many units of the library one of a column is, if it has a unit of what it is to hold.
fn unit(role: Role, name: &str, width: Option<f64>) -> Option<f64> {
    match role {
        Role::Displacement => factor(name, Some(Dimension::Length)),
        Role::Force | Role::ForceError => factor(name, Some(Dimension::Force))
            .or_else(|| width.and_then(|width| Some(width * factor(name, Some(Dimension::Work))?))),
    }
}

/// The column of this name, which may have its unit in the data, in the scene or in both.
fn by_name(columns: &Columns, role: Role, name: &str, width: Option<f64>) -> Result<Found, String> {
    let header = &columns.header;
    let alike = |column: &&usize| without_unit(&header[**column]) == without_unit(name);
    let all: Vec<usize> = (0..header.len()).collect();
    let same: Vec<usize> = all.iter().copied().filter(|&column| header[column] == name).collect();
    let found = if same.is_empty() { all.iter().filter(alike).copied().collect() } else { same };
    let [column] = found[..] else {
        let count = if found.is_empty() { "no column".to_owned() } else { format!("{} columns", found.len()) };
        return Err(format!("has {count} `{name}` of {}: it has {}", role.words(), header.join(", ")));
    };
    match (unit(role, &header[column], width), unit(role, name, width)) {
        (Some(written), Some(named)) if (written / named - 1.0).abs() > 1e-12 => {
            Err(format!("has the column `{}`, and the scene names it with another unit, `{name}`", header[column]))
        }
        (Some(of), _) | (None, Some(of)) => Ok((column, of)),
        (None, None) => Err(format!(
            "has the column `{}` without a unit of {}: name it with its unit, such as `{name} (mm)` or `{name} (N)`",
            header[column],
            role.words()
        )),
    }
}

/// The only column with a unit of this role that the scene does not name for another one, and that is not the one of a key.
fn by_unit(
    columns: &Columns,
    role: Role,
    named: &FitColumns,
    width: Option<f64>,
    key: Option<usize>,
) -> Result<Option<Found>, String> {
    let FitColumns { displacement, force, force_error } = named;
    let is_named = |name: &str| {
        [displacement, force, force_error].into_iter().flatten().any(|own| without_unit(own) == without_unit(name))
    };
    let says_error = |name: &str| ERROR_WORDS.iter().any(|word| name.to_lowercase().contains(word));
    let found = columns.header.iter().enumerate().filter(|(column, name)| {
        (role == Role::ForceError) == says_error(name) && !is_named(name) && Some(*column) != key
    });
    let found: Vec<Found> = found.filter_map(|(column, name)| Some((column, unit(role, name, width)?))).collect();
    match found[..] {
        [] => Ok(None),
        [one] => Ok(Some(one)),
        [(one, _), (other, _), ..] => {
            let (one, other) = (&columns.header[one], &columns.header[other]);
            Err(format!("has two columns of {}, `{one}` and `{other}`", role.words()))
        }
    }
}
