//! The tables of a fit: fit.csv, and profiles.csv where there are profiles. Units stand in the names of the columns.

use super::table::write_table;
use crate::error::ReportError;
use crate::number::Finite;
use peelkit::study::{Fit, PointPlace};
use serde::Serialize;
use std::path::{Path, PathBuf};

#[derive(Debug, Default, Serialize)]
struct Line {
    displacement_nm: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "modelled_nN")]
    modelled: Finite,
    #[serde(rename = "standard_error_nN")]
    error: Finite,
    residual: Finite,
    weight: Finite,
    place: &'static str,
}

#[derive(Debug, Default, Serialize)]
struct ProfileLine {
    key: String,
    value: Finite,
    excess: Finite,
}

/// Writes fit.csv, one row a measured point, and profiles.csv, one row a point of a profile likelihood, where there is one.
///
/// Fails with [`ReportError::Write`] where a file cannot be written or a number is not finite.
pub fn write_fit(dir: &Path, fit: &Fit) -> Result<Vec<PathBuf>, ReportError> {
    let line = |point: &peelkit::study::FittedPoint| Line {
        displacement_nm: Finite(point.displacement),
        force: Finite(point.force),
        modelled: Finite(point.modelled),
        error: Finite(point.error),
        residual: Finite((point.modelled - point.force) / point.error),
        weight: Finite(point.weight),
        place: match point.place {
            PointPlace::BeforeStart => "before start",
            PointPlace::OnBranch => "branch",
            PointPlace::BehindJump => "behind jump",
        },
    };
    let mut files = vec![write_table(dir, "fit.csv", fit.points.iter().map(line))?];
    let profiles = fit.parameters.iter().filter_map(|parameter| Some((&parameter.key, parameter.profile.as_ref()?)));
    let lines: Vec<ProfileLine> = profiles
        .flat_map(|(key, profile)| {
            let line = |&(value, excess): &(f64, f64)| ProfileLine {
                key: key.clone(),
                value: Finite(value),
                excess: Finite(excess),
            };
            profile.points.iter().map(line)
        })
        .collect();
    if !lines.is_empty() {
        files.push(write_table(dir, "profiles.csv", lines.into_iter())?);
    }
    Ok(files)
}
