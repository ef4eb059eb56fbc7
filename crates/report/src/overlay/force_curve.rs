//! A measured force-displacement curve with its standard errors: two or three columns of a CSV.

use super::OverlayError;
use super::columns::Columns;
use super::measured::factor;
use peelkit::study::MeasuredPoint;
use peelkit_scene::Dimension;
use std::path::Path;

const REMEDY: &str = "Give a column of displacements and one of forces, with names and units, such as displacement_nm,force_nN or u (um),P (mN); \
                      and, if it is known, a third one with the standard error of the forces, such as force_error_nN.";
/// In the name of a column of standard errors.
const ERROR_WORDS: [&str; 5] = ["error", "sigma", "std", "uncertainty", "deviation"];

/// What a column holds, with how many units of the library its unit is.
enum Role {
    Displacement(f64),
    Force(f64),
    ForceError(f64),
}

/// Reads a measured curve, in its order: displacements in nm, forces and their standard errors in nN.
///
/// Fails with a file that cannot be read, other columns or units than those of a displacement, a force and perhaps its standard error, a cell
/// that holds no number, and a standard error that is not above zero.
pub fn read_force_curve(path: &Path) -> Result<Vec<MeasuredPoint>, OverlayError> {
    let columns = Columns::read(path)?;
    let wrong = |found: String| OverlayError::new(path, found, REMEDY);
    let (mut displacement, mut force, mut error) = (None, None, None);
    for (column, name) in columns.header.iter().enumerate() {
        let (place, what, of) = match role(name) {
            Some(Role::Displacement(of)) => (&mut displacement, "displacements", of),
            Some(Role::Force(of)) => (&mut force, "forces", of),
            Some(Role::ForceError(of)) => (&mut error, "standard errors of forces", of),
            None => {
                return Err(wrong(format!(
                    "has in its header the column `{name}`, which is neither a displacement nor a force with its unit"
                )));
            }
        };
        if let Some((other, _)) = place.replace((column, of)) {
            let other: &String = &columns.header[other];
            return Err(wrong(format!("has two columns of {what}, `{other}` and `{name}`")));
        }
    }
    let (Some(displacement), Some(force)) = (displacement, force) else {
        let missing = if displacement.is_none() { "displacements" } else { "forces" };
        return Err(wrong(format!("has the columns {}, and none of {missing}", columns.header.join(", "))));
    };
    let numbers = |(column, of): (usize, f64)| -> Result<Vec<f64>, OverlayError> {
        let cells = columns.numbers(path, column)?;
        let empty = cells.iter().position(Option::is_none);
        if let Some(row) = empty {
            return Err(wrong(format!("has in row {} no `{}`", row + 1, columns.header[column])));
        }
        Ok(cells.into_iter().flatten().map(|number| of * number).collect())
    };
    let (displacements, forces) = (numbers(displacement)?, numbers(force)?);
    let errors = error.map(numbers).transpose()?;
    if let Some(row) = errors.iter().flatten().position(|&error| error <= 0.0) {
        return Err(wrong(format!("has in row {} a standard error that is not above zero", row + 1)));
    }
    let error = |row: usize| errors.as_ref().map(|errors| errors[row]);
    let point =
        |row: usize| MeasuredPoint { displacement: displacements[row], force: forces[row], force_error: error(row) };
    Ok((0..displacements.len()).map(point).collect())
}

fn role(name: &str) -> Option<Role> {
    let lower = name.to_lowercase();
    let is_error = ERROR_WORDS.iter().any(|word| lower.contains(word));
    match (factor(name, Some(Dimension::Length)), factor(name, Some(Dimension::Force))) {
        (Some(of), _) if !is_error => Some(Role::Displacement(of)),
        (_, Some(of)) if is_error => Some(Role::ForceError(of)),
        (_, Some(of)) => Some(Role::Force(of)),
        _ => None,
    }
}
