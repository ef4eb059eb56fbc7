//! What a sweep found, as one JSON object.

use super::origin::Origin;
use super::parameters::Parameters;
use crate::number::to_json;
use crate::sweep_row::SweepRow;
use crate::swept_keys::SweptKeys;
use crate::tables::SweepLine;
use peelkit::study::FollowedSweep;
use peelkit_scene::{Key, Scene};
use serde::Serialize;
use std::io;

/// A sweep as one object: the key that was varied, its unit, and a row a value.
#[derive(Debug, Serialize)]
pub struct SweepSummary<L = SweepLine> {
    #[serde(flatten)]
    origin: Origin,
    vary: String,
    /// Of `value` in the rows; `None` where the key is a plain number.
    unit: Option<&'static str>,
    /// The second key, where two are varied.
    #[serde(skip_serializing_if = "Option::is_none")]
    vary_2: Option<String>,
    /// Of `value_2` in the rows.
    #[serde(skip_serializing_if = "Option::is_none")]
    unit_2: Option<&'static str>,
    /// The point that was followed from value to value, where the values were not peeled one by one.
    #[serde(skip_serializing_if = "Option::is_none")]
    followed: Option<&'static str>,
    /// What happened to that point on the way, or where the rows come from.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    remarks: Vec<String>,
    rows: Vec<L>,
    /// The scene before the sweep.
    parameters: Parameters,
}

impl SweepSummary {
    /// The summary of these rows, in which keys of the scene were varied, and what is to be said of them besides.
    pub fn new<'k>(scene: &Scene, keys: impl Into<SweptKeys<'k>>, rows: &[SweepRow], remarks: &[String]) -> Self {
        Self::of(scene, keys.into(), rows.iter().map(SweepLine::from).collect(), remarks.to_vec())
    }

    /// The same for a point that was followed while `key` was varied, each value in so many seconds.
    pub fn followed(scene: &Scene, key: &Key, sweep: &FollowedSweep, solve_s: &[f64]) -> Self {
        let remarks = sweep.remarks.iter().map(ToString::to_string).collect();
        let lines = SweepLine::followed(sweep, solve_s);
        Self { followed: Some(sweep.kind.word()), ..Self::of(scene, key.into(), lines, remarks) }
    }
}

impl<L: Serialize> SweepSummary<L> {
    /// The summary of these lines.
    pub(crate) fn of(scene: &Scene, keys: SweptKeys, rows: Vec<L>, remarks: Vec<String>) -> Self {
        Self {
            origin: Origin::of(scene),
            vary: keys.first.path(),
            unit: Some(keys.first.unit()).filter(|unit| !unit.is_empty()),
            vary_2: keys.second.map(Key::path),
            unit_2: keys.second.map(Key::unit).filter(|unit| !unit.is_empty()),
            followed: None,
            remarks,
            rows,
            parameters: Parameters(scene.clone()),
        }
    }

    /// The same with the command line that asked for it.
    pub fn with_command(self, command: &str) -> Self {
        Self { origin: self.origin.by(command), ..self }
    }

    /// The object as text; a number that is not finite is an error that names its key.
    pub fn to_json(&self) -> io::Result<String> {
        to_json(self)
    }
}
