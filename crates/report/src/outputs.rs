//! All tables and objects that are written, each with its keys: what `docs/outputs.md` is made of.

use crate::output_key::OutputKey;
use crate::reference::*;
use crate::seta::SETA_STATE_FIELDS;
use crate::states::{SPATIAL_STATE_FIELDS, STATE_FIELDS, StateField};
use std::borrow::Cow;

/// A table or an object that is written.
#[derive(Clone, Debug)]
pub struct Output {
    /// As its table in `docs/outputs.md` is called
    pub name: &'static str,
    /// What it consists of: a key, a column or an array
    pub unit: &'static str,
    /// In the order in which they are written
    pub keys: Vec<OutputKey>,
}

/// All of them.
pub fn outputs() -> Vec<Output> {
    let all = [
        ("summary.json", "key", PEEL_SUMMARY.to_vec()),
        ("peel sweep --json", "key", SWEEP_SUMMARY.to_vec()),
        ("curve.csv", "column", CURVE_COLUMNS.to_vec()),
        ("limit_points.csv", "column", LIMIT_POINT_COLUMNS.to_vec()),
        ("observed.csv", "column", OBSERVED_COLUMNS.to_vec()),
        ("states.csv", "column", of_state(STATE_FIELDS)),
        ("states.csv in space", "column", of_state(SPATIAL_STATE_FIELDS)),
        ("sweep.csv", "column", SWEEP_COLUMNS.to_vec()),
        ("peel optimise --json", "key", OPTIMISATION_SUMMARY.to_vec()),
        ("history.csv", "column", HISTORY_COLUMNS.to_vec()),
        ("peel fit", "key", FIT_SUMMARY.to_vec()),
        ("fit.csv", "column", FIT_COLUMNS.to_vec()),
        ("profiles.csv", "column", PROFILE_COLUMNS.to_vec()),
        ("summary.json of peel uncertainty", "key", UNCERTAINTY_SUMMARY.to_vec()),
        ("statistics.csv and indices.csv", "column", UNCERTAINTY_COLUMNS.to_vec()),
        ("samples.csv", "column", SAMPLE_COLUMNS.to_vec()),
        ("sweep.csv of setae", "column", SETA_SWEEP_COLUMNS.to_vec()),
        ("summary.json of a seta", "key", SETA_SUMMARY.to_vec()),
        ("curve.csv of a seta", "column", SETA_CURVE_COLUMNS.to_vec()),
        ("events.csv", "column", SETA_EVENT_COLUMNS.to_vec()),
        ("tips.csv", "column", SETA_TIP_COLUMNS.to_vec()),
        ("tip.csv", "column", SETA_TIP_CURVE_COLUMNS.to_vec()),
        (
            "states.pvd of a seta",
            "array",
            SETA_STATE_FIELDS
                .iter()
                .map(|field| OutputKey { path: Cow::Borrowed(field.name), about: field.about, like: None })
                .collect(),
        ),
        ("summary.json of a rate", "key", RATE_SUMMARY.to_vec()),
        ("curve.csv of a rate", "column", RATE_CURVE_COLUMNS.to_vec()),
        ("sweep.csv of rates", "column", RATE_SWEEP_COLUMNS.to_vec()),
        ("peel coarsen", "key", TIP_SUMMARY.to_vec()),
        ("tip_law.csv", "column", TIP_LAW_COLUMNS.to_vec()),
        ("tip_limits.csv", "column", TIP_LIMIT_COLUMNS.to_vec()),
    ];
    all.into_iter().map(|(name, unit, keys)| Output { name, unit, keys }).collect()
}

/// The columns of a state, and of each place.
fn of_state<S>(fields: &[StateField<S>]) -> Vec<OutputKey> {
    let fields =
        fields.iter().map(|field| OutputKey { path: Cow::Borrowed(field.name), about: field.about, like: None });
    STATE_COLUMNS.iter().cloned().chain(fields).collect()
}
