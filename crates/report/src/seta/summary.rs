//! The pull-off of a seta as one JSON object: summary.json, and what `--json` prints.

use super::names::{seta_end_reason, seta_end_word};
use super::tip_events::TipEvents;
use crate::number::Finite;
use crate::summary::{Origin, Parameters, written};
use peelkit::model::{CurvePoint, PullCurve, Seta};
use peelkit::study::coarsening::{GrowingTable, OutsideTable, TableRound, TipSheet};
use peelkit::study::{ConvergedPeak, EventCause, SetaPullOff, SetaState};
use peelkit_scene::Scene;

/// Everything of a pull-off but its curve and its events. Forces in nN, lengths in nm, works in aJ; `None` where a thing does not occur.
#[derive(Debug, serde::Serialize)]
pub struct SetaSummary {
    #[serde(flatten)]
    origin: Origin,
    end: &'static str,
    /// Of the ends `bound` and `failed`.
    reason: Option<String>,
    /// How many tips the seta has.
    tips: usize,
    peak: Option<Moment>,
    /// Of the peak; `None` where it was not found on a finer mesh: it is then that of the curve.
    mesh_error: Option<MeshError>,
    first_detachment: Option<Moment>,
    last_detachment: Option<Moment>,
    events: Events,
    balance: Balance,
    tip: LawOfTips,
    /// `None` where the tips follow the curve of their normal pull.
    tip_table: Option<TipTableUse>,
    /// What is not to be trusted.
    warnings: Vec<Warning>,
    path: Effort,
    timing: Timing,
    parameters: Parameters,
}

/// What is not to be trusted: a word for programs, and a sentence.
#[derive(Debug, serde::Serialize)]
struct Warning {
    code: &'static str,
    text: String,
}

/// A state of the last step.
#[derive(Debug, serde::Serialize)]
struct Moment {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    /// How far the place that was looked for may lie from here; `None` where none was
    #[serde(rename = "location_error_nN")]
    force_error: Option<Finite>,
    #[serde(rename = "location_error_nm")]
    displacement_error: Option<Finite>,
    tips_attached: usize,
    #[serde(rename = "largest_tip_load_nN")]
    largest_load: Finite,
    #[serde(rename = "largest_tip_push_nN")]
    largest_push: Finite,
    #[serde(rename = "tip_loads_sum_nN")]
    sum: Finite,
}

impl From<&SetaState> for Moment {
    fn from(state: &SetaState) -> Self {
        let loads = || state.tips.iter().map(|tip| 0.0 - tip.load[1]);
        Self {
            force: Finite(state.point.force_along),
            displacement: Finite(state.point.displacement),
            force_error: state.location.map(|error| Finite(error.force)),
            displacement_error: state.location.map(|error| Finite(error.displacement)),
            tips_attached: state.point.attached,
            largest_load: Finite(loads().fold(0.0, f64::max)),
            largest_push: Finite(loads().fold(0.0, |most, load| f64::max(most, -load))),
            sum: Finite(loads().sum()),
        }
    }
}

impl Moment {
    /// The peak on the finest mesh; the tips carry what they do on that of the curve.
    fn converged(self, ConvergedPeak { peak, location, .. }: &ConvergedPeak) -> Self {
        Self {
            force: Finite(peak.force),
            displacement: Finite(peak.displacement),
            force_error: location.map(|error| Finite(error.force)),
            displacement_error: location.map(|error| Finite(error.displacement)),
            ..self
        }
    }
}

/// By how much the peak lies elsewhere on the mesh before the finest.
#[derive(Debug, serde::Serialize)]
struct MeshError {
    #[serde(rename = "force_nN")]
    force: Finite,
    #[serde(rename = "displacement_nm")]
    displacement: Finite,
    /// Of the elements of the finest mesh
    order: usize,
    /// By how much the largest force of the curve is off
    #[serde(rename = "curve_nN")]
    curve: Finite,
}

impl MeshError {
    fn new(state: &SetaState, converged: &ConvergedPeak) -> Self {
        Self {
            force: Finite(converged.mesh.force),
            displacement: Finite(converged.mesh.displacement),
            order: converged.order,
            curve: Finite((converged.peak.force - state.point.force_along).abs()),
        }
    }
}

#[derive(Debug, serde::Serialize)]
struct Events {
    #[serde(flatten)]
    tips: TipEvents,
    buckled: usize,
}

/// What becomes of the work of the root.
#[derive(Debug, serde::Serialize)]
struct Balance {
    #[serde(rename = "work_aJ")]
    work: Finite,
    #[serde(rename = "released_aJ")]
    released: Finite,
    #[serde(rename = "energy_change_aJ")]
    energy: Finite,
    imbalance: Finite,
}

/// The law of each tip.
#[derive(Debug, serde::Serialize)]
pub struct LawOfTips {
    law: &'static str,
    #[serde(rename = "peak_force_nN")]
    peak: Finite,
    snap_off_displacement_nm: Finite,
    #[serde(rename = "energy_at_rest_aJ")]
    energy_at_rest: Finite,
}

/// The table that tips follow, and what it came to that they left it.
#[derive(Debug, serde::Serialize)]
struct TipTableUse {
    rows: usize,
    press_nm: Finite,
    rotation_rad: [Finite; 2],
    relative_error: Finite,
    #[serde(rename = "normal_force_error_nN")]
    force_error: Finite,
    #[serde(rename = "moment_error_nN_nm")]
    moment_error: Finite,
    pull_offs: usize,
    rows_added: usize,
    /// Of the first pull-off, and of the last
    tips_outside_first: usize,
    tips_outside: usize,
    #[serde(rename = "first_peak_force_nN")]
    first_peak: Option<Finite>,
    #[serde(rename = "peak_force_change_nN")]
    change: Option<Finite>,
    /// Of the tips that were solved as spatulae in the last pull-off
    #[serde(rename = "resolve_within_nm")]
    within: Option<Finite>,
    tips_resolved: usize,
    tips_unresolved: usize,
    #[serde(rename = "resolved_force_change_nN")]
    resolved_force: Option<Finite>,
    #[serde(rename = "resolved_moment_change_nN_nm")]
    resolved_moment: Option<Finite>,
    #[serde(rename = "resolved_peak_force_change_nN")]
    resolved_peak: Option<Finite>,
}

impl From<&GrowingTable> for TipTableUse {
    fn from(growing: &GrowingTable) -> Self {
        let (table, rounds) = (growing.table(), growing.rounds());
        let range = table.options.range;
        let resolved = rounds.last().filter(|round| round.within.is_some());
        let outside = |round: Option<&TableRound>| round.map_or(0, |round| round.visited.outside.len());
        let error = |i: usize| {
            let own = |on: TipSheet| table.errors(on).force[i];
            Finite(own(TipSheet::Attached).max(own(TipSheet::Detached)))
        };
        Self {
            rows: table.rows(),
            press_nm: Finite(range.press),
            rotation_rad: range.rotation.map(Finite),
            relative_error: Finite(table.relative_error()),
            force_error: error(0),
            moment_error: error(2),
            pull_offs: rounds.len(),
            rows_added: growing.added(),
            tips_outside_first: outside(rounds.first()),
            tips_outside: outside(rounds.last()),
            first_peak: rounds.first().and_then(|round| round.peak_force).map(Finite),
            change: growing.changed().map(Finite),
            within: resolved.and_then(|round| round.within).map(Finite),
            tips_resolved: resolved.map_or(0, |round| round.visited.resolved.tips.len()),
            tips_unresolved: resolved.map_or(0, |round| round.visited.resolved.unsolved.len()),
            resolved_force: resolved.map(|round| Finite(round.visited.resolved.force)),
            resolved_moment: resolved.map(|round| Finite(round.visited.resolved.moment)),
            resolved_peak: growing.changed_by_resolved().map(Finite),
        }
    }
}

#[derive(Debug, serde::Serialize)]
struct Effort {
    points: usize,
    newton_iterations: usize,
    elements: usize,
}

/// Seconds of the law of the tips, of the pull-off, and of the peak on finer meshes.
#[derive(Debug, serde::Serialize)]
struct Timing {
    tip_s: Finite,
    solve_s: Finite,
    mesh_error_s: Finite,
}

impl From<&PullCurve> for LawOfTips {
    fn from(tip: &PullCurve) -> Self {
        Self {
            law: "curve",
            peak: Finite(tip_peak(tip)),
            snap_off_displacement_nm: Finite(tip.snap_off()),
            energy_at_rest: Finite(tip.energy_at_rest()),
        }
    }
}

/// Points of the curve of a tip between two of its own at which its largest force is looked for.
const BETWEEN: usize = 100;

/// The largest force of the curve of a tip, nN.
pub fn tip_peak(tip: &PullCurve) -> f64 {
    let between = |pair: &[CurvePoint]| {
        let (from, to) = (pair[0].displacement, pair[1].displacement);
        let force = |k: usize| tip.force(from + (to - from) * k as f64 / BETWEEN as f64).0;
        (0..=BETWEEN).map(force).fold(0.0, f64::max)
    };
    tip.points().windows(2).map(between).fold(0.0, f64::max)
}

impl SetaSummary {
    /// The summary of the pull-off of this scene, whose tips follow this curve, and of its peak on finer meshes: the three took `tip_s`, `solve_s`
    /// and `mesh_error_s` seconds.
    pub fn new(
        scene: &Scene,
        seta: &Seta,
        tip: &PullCurve,
        (pull_off, converged): (&SetaPullOff, Option<&ConvergedPeak>),
        [tip_s, solve_s, mesh_error_s]: [f64; 3],
    ) -> Self {
        let (first, last) = (pull_off.points.first(), pull_off.points.last());
        let energy = first.zip(last).map_or(0.0, |(first, last)| last.energy - first.energy);
        let peak = pull_off.peak.as_ref();
        Self {
            origin: Origin::of(scene),
            end: seta_end_word(pull_off),
            reason: seta_end_reason(&pull_off.end),
            tips: seta.tips(),
            peak: peak.map(Moment::from).map(|peak| match converged {
                Some(converged) => peak.converged(converged),
                None => peak,
            }),
            mesh_error: peak.zip(converged).map(|(peak, converged)| MeshError::new(peak, converged)),
            first_detachment: pull_off.first_detachment.as_ref().map(Moment::from),
            last_detachment: pull_off.last_detachment.as_ref().map(Moment::from),
            events: Events {
                tips: TipEvents::of(pull_off.events.iter().map(|event| &event.tips[..])),
                buckled: pull_off.events.iter().filter(|event| event.cause == EventCause::Buckling).count(),
            },
            balance: Balance {
                work: Finite(last.map_or(0.0, |last| last.work)),
                released: Finite(last.map_or(0.0, |last| last.released)),
                energy: Finite(energy),
                imbalance: Finite(pull_off.imbalance()),
            },
            tip: LawOfTips::from(tip),
            tip_table: None,
            warnings: Vec::new(),
            path: Effort {
                points: pull_off.points.len(),
                newton_iterations: pull_off.effort.newton_iterations,
                elements: pull_off.effort.elements,
            },
            timing: Timing { tip_s: Finite(tip_s), solve_s: Finite(solve_s), mesh_error_s: Finite(mesh_error_s) },
            parameters: Parameters(scene.clone()),
        }
    }
}

impl SetaSummary {
    /// The same where the tips follow a table.
    pub fn with_table(self, table: Option<&GrowingTable>) -> Self {
        let law = if table.is_some() { "table" } else { self.tip.law };
        Self { tip: LawOfTips { law, ..self.tip }, tip_table: table.map(TipTableUse::from), ..self }
    }

    /// The same where tips were outside of a table that does not grow any more.
    pub fn with_outside(self, outside: Option<&OutsideTable>) -> Self {
        let warning = |outside: &OutsideTable| Warning { code: outside.code(), text: outside.to_string() };
        Self { warnings: outside.map(warning).into_iter().collect(), ..self }
    }
}

written!(SetaSummary);
