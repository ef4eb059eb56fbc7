//! What a run found, as one JSON object: summary.json, and what `--json` prints.

use super::ReportError;
use super::accuracy::AccuracySummary;
use super::considered::ConsideredSummary;
use super::file::write_whole;
use super::ground::GroundSummary;
use super::number::{Finite, to_json};
use super::observed::ObservedSummary;
use super::sliding::SlidingSummary;
use super::table::SweepLine;
use crate::model::Step;
use crate::scene::{KEYS, Key, Kind, Scene, Value};
use crate::beam::GripState;
use crate::study::{self, End, FollowedSweep, Observed, Peel, SweepRow, Turn};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io;
use std::path::{Path, PathBuf};

/// Everything of a peel but its curve. Forces in nN, lengths in nm, works in aJ; `None` where a thing does not occur.
#[derive(Debug, serde::Serialize)]
pub struct PeelSummary {
    scene: String,
    title: String,
    end: &'static str,
    /// Of the ends `bound` and `failed`.
    reason: Option<String>,
    peak: Option<Peak>,
    initiation_peak: Option<Peak>,
    plateau: Option<Plateau>,
    limit_points: Vec<LimitPoint>,
    snap_off: Option<SnapOff>,
    accuracy: AccuracySummary,
    /// What leaving out a term of the model would change, to first order.
    terms: Vec<TermEffect>,
    /// What was left out and what not, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    considered: Option<ConsideredSummary>,
    path: Effort,
    timing: Timing,
    /// The steps before the pull, as far as they were taken.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    steps: Vec<StepEnd>,
    /// How the beam lies where the path begins, on ground that is not flat.
    #[serde(skip_serializing_if = "Option::is_none")]
    ground: Option<GroundSummary>,
    /// How the beam has slid at the initiation peak, with friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    sliding: Option<SlidingSummary>,
    /// What a test would record, where that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    observed: Option<ObservedSummary>,
    parameters: Parameters,
}

#[derive(Debug, serde::Serialize)]
struct Peak {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "end_rotation_rad")]
    end_rotation: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Plateau {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
}

#[derive(Debug, serde::Serialize)]
struct LimitPoint {
    kind: &'static str,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "end_rotation_rad")]
    end_rotation: Finite,
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
    /// Of a load limit point around which the force is so level that its place cannot be told and does not matter.
    flat: bool,
}

#[derive(Debug, serde::Serialize)]
struct SnapOff {
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "error_nm")]
    displacement_error: Finite,
    #[serde(rename = "error_nN")]
    force_error: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Effort {
    points: usize,
    newton_iterations: usize,
    elements: usize,
    order: usize,
}

/// The grip behind a step, seen from where it took hold.
#[derive(Debug, serde::Serialize)]
struct StepEnd {
    step: String,
    /// None where the grip is free along the substrate and nothing looks at it.
    #[serde(rename = "x_nm")]
    x: Option<Finite>,
    #[serde(rename = "y_nm")]
    y: Finite,
    #[serde(rename = "end_rotation_rad")]
    rotation: Finite,
    #[serde(rename = "horizontal_force_nN")]
    horizontal: Finite,
    #[serde(rename = "vertical_force_nN")]
    vertical: Finite,
    #[serde(rename = "moment_nN_nm")]
    moment: Finite,
}

#[derive(Debug, serde::Serialize)]
struct TermEffect {
    left_out: &'static str,
    #[serde(rename = "initiation_peak_change_nN")]
    force: Finite,
}

#[derive(Debug, serde::Serialize)]
struct Timing {
    solve_s: Finite,
}

impl PeelSummary {
    /// What is told of the peel of this scene.
    pub fn new(scene: &Scene, peel: &Peel) -> Self {
        Self {
            scene: scene.name.clone(),
            title: scene.title.clone(),
            end: end_word(&peel.end),
            reason: end_reason(&peel.end).map(str::to_owned),
            peak: peel.peak.map(Peak::from),
            initiation_peak: peel.initiation_peak.map(Peak::from),
            plateau: peel.plateau.map(|at| Plateau { force: Finite(at.force), displacement: Finite(at.displacement) }),
            limit_points: peel.limit_points.iter().map(LimitPoint::from).collect(),
            snap_off: peel.snap_off.map(|at| SnapOff {
                displacement: Finite(at.displacement),
                force: Finite(at.force),
                work: Finite(at.work),
                displacement_error: Finite(at.displacement_error),
                force_error: Finite(at.force_error),
            }),
            accuracy: AccuracySummary::of(peel),
            terms: peel.terms().iter().map(TermEffect::from).collect(),
            considered: peel.considered.as_ref().map(ConsideredSummary::from),
            path: Effort {
                points: peel.effort.points,
                newton_iterations: peel.effort.newton_iterations,
                elements: peel.effort.elements,
                order: peel.effort.order,
            },
            timing: Timing { solve_s: Finite(peel.solve_s) },
            steps: peel.model.steps.iter().zip(&peel.steps).map(StepEnd::from).collect(),
            ground: GroundSummary::of(peel),
            sliding: SlidingSummary::of(peel),
            observed: None,
            parameters: Parameters(scene.clone()),
        }
    }

    /// The same with what a test of this scene would record.
    pub fn with_observed(self, test: &Observed) -> Self {
        Self { observed: Some(ObservedSummary::from(test)), ..self }
    }

    /// The object as text; a number that is not finite is an error that names its key.
    pub fn to_json(&self) -> io::Result<String> {
        to_json(self)
    }

    /// Writes summary.json.
    pub fn write(&self, dir: &Path) -> Result<PathBuf, ReportError> {
        let path = dir.join("summary.json");
        let json = self.to_json().map_err(|source| ReportError::Write { path: path.clone(), source })?;
        write_whole(&path, json.as_bytes())?;
        Ok(path)
    }
}

impl From<(&Step, &GripState)> for StepEnd {
    fn from((step, grip): (&Step, &GripState)) -> Self {
        Self {
            step: step.to_string(),
            x: grip.x.map(Finite),
            y: Finite(grip.y),
            rotation: Finite(grip.rotation),
            horizontal: Finite(grip.forces.horizontal),
            vertical: Finite(grip.forces.vertical),
            moment: Finite(grip.forces.moment),
        }
    }
}

impl From<&study::TermEffect> for TermEffect {
    fn from(effect: &study::TermEffect) -> Self {
        Self { left_out: effect.term.word(), force: Finite(effect.force) }
    }
}

impl From<study::Peak> for Peak {
    fn from(at: study::Peak) -> Self {
        Self {
            force: Finite(at.force),
            displacement: Finite(at.displacement),
            end_rotation: Finite(at.end_rotation),
            force_error: Finite(at.force_error),
            displacement_error: Finite(at.displacement_error),
        }
    }
}

impl From<&study::LimitPoint> for LimitPoint {
    fn from(at: &study::LimitPoint) -> Self {
        Self {
            kind: turn_word(at.kind),
            displacement: Finite(at.displacement),
            force: Finite(at.force),
            end_rotation: Finite(at.end_rotation),
            work: Finite(at.work),
            displacement_error: Finite(at.displacement_error),
            force_error: Finite(at.force_error),
            flat: at.flat,
        }
    }
}

/// A sweep as one object: the key that was varied, its unit, and a row a value.
#[derive(Debug, serde::Serialize)]
pub struct SweepSummary {
    scene: String,
    title: String,
    vary: String,
    /// Of `value` in the rows; `None` where the key is a plain number.
    unit: Option<&'static str>,
    /// The point that was followed from value to value, where the values were not peeled one by one.
    #[serde(skip_serializing_if = "Option::is_none")]
    followed: Option<&'static str>,
    /// What happened to that point on the way, or where the rows come from.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    remarks: Vec<String>,
    rows: Vec<SweepLine>,
    /// The scene before the sweep.
    parameters: Parameters,
}

impl SweepSummary {
    /// What is told of these rows, in which `key` of the scene was varied, and what is to be said of them besides.
    pub fn new(scene: &Scene, key: &Key, rows: &[SweepRow], remarks: &[String]) -> Self {
        Self { remarks: remarks.to_vec(), ..Self::of(scene, key, rows.iter().map(SweepLine::from).collect()) }
    }

    /// The same for a point that was followed while `key` was varied.
    pub fn followed(scene: &Scene, key: &Key, sweep: &FollowedSweep) -> Self {
        Self {
            followed: Some(sweep.kind.word()),
            remarks: sweep.remarks.iter().map(ToString::to_string).collect(),
            ..Self::of(scene, key, SweepLine::followed(sweep))
        }
    }

    fn of(scene: &Scene, key: &Key, rows: Vec<SweepLine>) -> Self {
        Self {
            scene: scene.name.clone(),
            title: scene.title.clone(),
            vary: key.path(),
            unit: Some(key.unit()).filter(|unit| !unit.is_empty()),
            followed: None,
            remarks: Vec::new(),
            rows,
            parameters: Parameters(scene.clone()),
        }
    }

    /// The object as text; a number that is not finite is an error that names its key.
    pub fn to_json(&self) -> io::Result<String> {
        to_json(self)
    }
}

/// The scene as it was computed, defaults and overrides in, a table of it an object; units in the names.
#[derive(Debug)]
pub(super) struct Parameters(pub Scene);

impl Serialize for Parameters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tables = serializer.serialize_map(None)?;
        // the title has a place of its own
        for key in KEYS.iter().filter(|key| key.table.is_empty() && !matches!(key.kind, Kind::Text(_))) {
            if let Some(Value::Text(text)) = key.value(&self.0) {
                tables.serialize_entry(key.name, &text)?;
            }
        }
        let stands = |key: &Key| !key.table.is_empty() && key.belongs_to(&self.0);
        for keys in KEYS.chunk_by(|a, b| a.table == b.table).filter(|keys| keys.iter().any(stands)) {
            tables.serialize_entry(keys[0].table, &Table { scene: &self.0, keys })?;
        }
        tables.end()
    }
}

struct Table<'a> {
    scene: &'a Scene,
    keys: &'a [Key],
}

impl Serialize for Table<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut table = serializer.serialize_map(None)?;
        for key in self.keys.iter().filter(|key| key.belongs_to(self.scene)) {
            let unit = key.unit().replace('/', "_per_");
            let name = if unit.is_empty() { key.name.to_owned() } else { format!("{}_{unit}", key.name) };
            match key.value(self.scene) {
                Some(Value::Number(count)) if key.is_count() => table.serialize_entry(&name, &(count as u64))?,
                value => table.serialize_entry(&name, &value.as_ref().map(Given))?,
            }
        }
        table.end()
    }
}

/// A value as a scene holds it.
struct Given<'a>(&'a Value);

impl Serialize for Given<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Number(number) => Finite(*number).serialize(serializer),
            Value::Text(text) => serializer.serialize_str(text),
            Value::Flag(flag) => serializer.serialize_bool(*flag),
            Value::List(items) => serializer.collect_seq(items.iter().map(Given)),
            Value::Table(entries) => serializer.collect_map(entries.iter().map(|(name, value)| (name, Given(value)))),
            Value::Other(_) => serializer.serialize_none(),
        }
    }
}

/// The name of an end in outputs.
pub fn end_word(end: &End) -> &'static str {
    match end {
        End::Detached => "detached",
        End::Pivoting => "pivoting",
        End::TurnedBack => "turned-back",
        End::Sliding => "sliding",
        End::Snapped => "snapped",
        End::Bound(_) => "bound",
        End::Failed(_) => "failed",
    }
}

/// Why a path ended where it did, if that was not by itself.
pub fn end_reason(end: &End) -> Option<&str> {
    match end {
        End::Bound(reason) | End::Failed(reason) => Some(reason),
        End::Detached | End::Pivoting | End::TurnedBack | End::Sliding | End::Snapped => None,
    }
}

/// The name of a limit point's kind in outputs.
pub(super) fn turn_word(turn: Turn) -> &'static str {
    match turn {
        Turn::Displacement => "displacement",
        Turn::Load => "load",
    }
}
