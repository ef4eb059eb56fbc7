//! states.csv: one row for each place of the beam at each state.

use super::fields::{STATE_FIELDS, StateField};
use super::spatial_fields::SPATIAL_STATE_FIELDS;
use crate::error::ReportError;
use crate::file::write_whole;
use crate::names::limit_point_kind_word;
use peelkit::study::{BeamState, StateSections};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Columns that are the same in all rows of a state.
const OF_STATE: [&str; 5] = ["state", "limit_point", "path_position", "displacement_nm", "force_nN"];

/// Writes states.csv: one row for each place of the beam at each state, in path order and from S = 0 to S = L; the columns are those of the
/// state, its number from 0 among them, and [`STATE_FIELDS`], of a beam in space [`SPATIAL_STATE_FIELDS`].
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_states(dir: &Path, states: &[BeamState]) -> Result<PathBuf, ReportError> {
    let path = dir.join("states.csv");
    let text = table(states).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}

fn table(states: &[BeamState]) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let fields = match states.first().map(|state| &state.sections) {
        Some(StateSections::Spatial { .. }) => names(SPATIAL_STATE_FIELDS),
        Some(StateSections::Planar(_)) | None => names(STATE_FIELDS),
    };
    writer.write_record(OF_STATE.into_iter().chain(fields))?;
    for (number, state) in states.iter().enumerate() {
        let of_state = [
            number.to_string(),
            state.limit_point.map_or_else(String::new, |kind| limit_point_kind_word(kind).to_owned()),
            written("path_position", state.path_position)?,
            written("displacement_nm", state.displacement)?,
            written("force_nN", state.force)?,
        ];
        let rows = match &state.sections {
            StateSections::Planar(sections) => rows(sections, STATE_FIELDS),
            StateSections::Spatial { sections, .. } => rows(sections, SPATIAL_STATE_FIELDS),
        };
        for row in rows? {
            writer.write_record(of_state.iter().chain(&row))?;
        }
    }
    writer.into_inner().map_err(|error| error.into_error())
}

fn names<S>(fields: &'static [StateField<S>]) -> Vec<&'static str> {
    fields.iter().map(|field| field.name).collect()
}

fn rows<S>(sections: &[S], fields: &[StateField<S>]) -> io::Result<Vec<Vec<String>>> {
    let row = |section| fields.iter().map(|field| written(field.name, (field.value)(section))).collect();
    sections.iter().map(row).collect()
}

/// A number with all its digits; one that is not finite is refused.
pub(super) fn written(name: &str, value: f64) -> io::Result<String> {
    if value.is_finite() {
        return Ok(format!("{value:?}"));
    }
    Err(io::Error::new(ErrorKind::InvalidData, format!("{name}: {value} is not a finite number")))
}
