//! states.csv: one row for each place of the beam at each state.

use super::fields::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField};
use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use crate::writing::names::limit_point_kind_word;
use crate::writing::record::{Cell, Fields, Record, columns};
use crate::writing::reference::{Output, OutputKey};
use peelkit::study::{BeamState, StateSections};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// What is the same at all places of a state.
struct OfState<'a> {
    number: usize,
    state: &'a BeamState,
}

impl Record for OfState<'_> {
    #[rustfmt::skip]
    fn fields(of: &mut Fields<Self>) {
        of.field("state", "number of the state from 0, in path order; the time of states.pvd", |found| found.number);
        of.field("limit_point", "`load` or `displacement` where the state is a limit point, else empty", |found| found.state.limit_point.map(limit_point_kind_word));
        of.field("path_position", "0 at the beginning of the path, 1 at its end", |found| found.state.path_position);
        of.field("displacement_nm", "u", |found| found.state.displacement);
        of.field("force_nN", "P", |found| found.state.force);
    }
}

/// The tables with their columns.
pub(crate) fn outputs() -> Vec<Output> {
    vec![
        Output::table("states.csv", [OfState::keys(), keys(STATE_FIELDS)].concat()),
        Output::table("states.csv in space", [OfState::keys(), keys(SPATIAL_STATE_FIELDS)].concat()),
    ]
}

fn keys<S>(fields: &[StateField<S>]) -> Vec<OutputKey> {
    fields.iter().map(|field| OutputKey::new(field.name, field.about)).collect()
}

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
    let of_state = columns::<OfState>();
    writer.write_record(of_state.iter().map(String::as_str).chain(fields))?;
    for (number, state) in states.iter().enumerate() {
        let of_state = OfState { number, state }.object();
        let of_state: Vec<String> =
            of_state.0.iter().map(|(name, cell)| text(name, cell)).collect::<io::Result<_>>()?;
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

fn text(name: &str, cell: &Cell) -> io::Result<String> {
    match cell {
        Cell::Number(number) => written(name, *number),
        Cell::Count(count) => Ok(count.to_string()),
        Cell::Text(text) => Ok(text.clone()),
        _ => Ok(String::new()),
    }
}

/// A number with all its digits; one that is not finite is refused.
pub(super) fn written(name: &str, value: f64) -> io::Result<String> {
    if value.is_finite() {
        return Ok(format!("{value:?}"));
    }
    Err(io::Error::new(ErrorKind::InvalidData, format!("{name}: {value} is not a finite number")))
}
