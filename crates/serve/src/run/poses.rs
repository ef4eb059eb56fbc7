//! The beam along the path, or a seta along its pull-off, as whole numbers, and the ground below it.

use crate::run::curve::pulled;
use peelkit::model::Seta;
use peelkit::study::{Peel, SetaBranch, SolidPeel, SolidPoint};
use peelkit_analyses::{RunOutcome, SetaOutcome};
use peelkit_report::{Pose, PulledAtRate};
use peelkit_scene::{Described, Scene};
use serde::Serialize;

/// Parts of the largest extent to which a place of an outline is rounded.
const FINE: f64 = 2e4;
/// Points of the surface that are drawn where it is not flat.
const DRAWN: usize = 600;
/// Of the surface beside the beam, over the extent of that.
const BESIDE: f64 = 2.0;

/// Most states of a solid that are sent.
const SOLID_STATES: usize = 200;
/// Branches of a seta that are sent in all its states together, about.
const BRANCHES: usize = 12_000;
/// Most states of a seta.
const STATES: usize = 40;

/// How many states of the seta of a scene are shown; none of a beam.
pub(crate) fn shown_states(scene: &Scene) -> Option<u32> {
    let Described::Seta(table) = scene.describes() else { return None };
    Some(states_of(&table.seta) as u32)
}

/// How many states of a seta are shown.
fn states_of(seta: &Seta) -> usize {
    (BRANCHES / seta.joints()).clamp(2, STATES)
}

/// The beam along the path.
#[derive(Debug, Serialize)]
pub(crate) struct Poses {
    /// What a whole number of an outline or of the ground is, nm
    #[serde(rename = "unit_nm")]
    unit: f64,
    /// x and y in turn
    ground: Vec<i32>,
    /// In path order
    along: Vec<PoseNumbers>,
}

/// The beam at one equilibrium.
#[derive(Debug, Serialize)]
struct PoseNumbers {
    #[serde(rename = "displacement_nm")]
    displacement: f64,
    #[serde(rename = "force_nN")]
    force: f64,
    unstable: bool,
    /// How far along the curve as it is seen, from 0 to 1
    position: f64,
    /// x and y in turn: the lower side from the free end on, and the upper one back; empty where no shape is known
    outline: Vec<i32>,
    /// Of a seta
    #[serde(skip_serializing_if = "Vec::is_empty")]
    branches: Vec<BranchNumbers>,
}

/// A branch of a seta, seen from the side.
#[derive(Debug, Serialize)]
struct BranchNumbers {
    /// x and y in turn, from the root on
    line: Vec<i32>,
    diameter: i32,
    /// Whether a tip behind it adheres
    attached: bool,
}

/// From the lower left corner to the upper right one, the origin within.
fn corners(places: impl Iterator<Item = (f64, f64)> + Clone) -> [(f64, f64); 2] {
    [f64::min, f64::max].map(|pick| places.clone().fold((0.0, 0.0), |(x, y), at| (pick(x, at.0), pick(y, at.1))))
}

impl Poses {
    /// Those of a run.
    pub fn of(outcome: &RunOutcome) -> Self {
        match outcome {
            RunOutcome::Peel(found) => Self::of_peel(&found.peel),
            RunOutcome::Seta(found) => Self::of_seta(found),
            // the places of its roots are not drawn
            RunOutcome::Array(_) => Self { unit: 1.0, ground: Vec::new(), along: Vec::new() },
            RunOutcome::Solid(found) => Self::of_solid(&found.peel),
            RunOutcome::Rate(found) => Self::at_rate(&found.pulled),
        }
    }

    /// The poses of a peel; none where it has no shapes.
    fn of_peel(peel: &Peel) -> Self {
        let poses = peelkit_report::poses(peel);
        let [low, high] = corners(poses.iter().flat_map(|pose| &pose.outline).copied());
        let extent = extent(low, high);
        let unit = extent / FINE;
        let along = |pose: &Pose| PoseNumbers {
            displacement: pose.displacement,
            force: pose.force,
            unstable: pose.unstable,
            position: pose.time,
            outline: numbers(unit, &pose.outline),
            branches: Vec::new(),
        };
        let (from, to) = (low.0 - BESIDE * extent, high.0 + BESIDE * extent);
        Self { unit, ground: numbers(unit, &surface(peel, from, to)), along: poses.iter().map(along).collect() }
    }

    /// States of a seta while it is pulled.
    fn of_seta(found: &SetaOutcome) -> Self {
        let seta = found.seta();
        let last = pulled(found.pull_off()).next().map(|point| point.step);
        let states = found.states(states_of(seta)).into_iter().filter(|state| Some(state.point.step) == last);
        let states: Vec<_> = states.map(|state| (state.point, state.branches(seta))).collect();
        let [low, high] = corners(states.iter().flat_map(|(_, branches)| branches).flat_map(side));
        let extent = extent(low, high);
        let unit = extent / FINE;
        let branch = |branch: &SetaBranch| BranchNumbers {
            line: numbers(unit, &side(branch).collect::<Vec<_>>()),
            diameter: (2.0 * branch.radius / unit).round() as i32,
            attached: branch.attached,
        };
        let most = states.len().saturating_sub(1).max(1) as f64;
        let along = states.iter().enumerate().map(|(k, (point, branches))| PoseNumbers {
            displacement: point.displacement,
            force: point.force_along,
            unstable: false,
            position: k as f64 / most,
            outline: Vec::new(),
            branches: branches.iter().map(branch).collect(),
        });
        let (from, to) = (low.0 - BESIDE * extent, high.0 + BESIDE * extent);
        Self { unit, ground: numbers(unit, &[(from, 0.0), (to, 0.0)]), along: along.collect() }
    }

    /// The outline of a solid at points of its path.
    fn of_solid(peel: &SolidPeel) -> Self {
        let ((across, _), [under, upper]) = (peel.body.mesh_lines(), peel.body.faces());
        let corners_of = across.iter().map(|&s| [s, under]).chain(across.iter().rev().map(|&s| [s, upper]));
        let (length, corners_of): (f64, Vec<[f64; 2]>) = (peel.body.length(), corners_of.collect());
        let every = peel.points.len().div_ceil(SOLID_STATES).max(1);
        let outline = |at: &SolidPoint| -> Vec<(f64, f64)> {
            corners_of.iter().map(|&of| peel.body.place_at(at.values(), of).into()).collect()
        };
        let shown: Vec<_> = peel.points.iter().enumerate().step_by(every).map(|(k, at)| (k, at, outline(at))).collect();
        let [low, high] = corners(shown.iter().flat_map(|(_, _, outline)| outline).copied());
        let unit = extent(low, high).max(length) / FINE;
        let most = peel.points.len().saturating_sub(1).max(1) as f64;
        let along = shown.iter().map(|(k, at, outline)| PoseNumbers {
            displacement: at.displacement,
            force: at.force,
            unstable: at.negative.is_some_and(|count| count > 0),
            position: *k as f64 / most,
            outline: numbers(unit, outline),
            branches: Vec::new(),
        });
        let (from, to) = (low.0 - BESIDE * length, high.0 + BESIDE * length);
        Self { unit, ground: numbers(unit, &[(from, 0.0), (to, 0.0)]), along: along.collect() }
    }

    /// The steps of a pull at a rate, whose shapes are not kept.
    fn at_rate(pulled: &PulledAtRate) -> Self {
        let most = pulled.steps().max(1) as f64;
        let along = pulled.points.iter().enumerate().map(|(k, at)| PoseNumbers {
            displacement: at.displacement,
            force: at.force,
            unstable: false,
            position: k as f64 / most,
            outline: Vec::new(),
            branches: Vec::new(),
        });
        Self { unit: 1.0, ground: Vec::new(), along: along.collect() }
    }
}

/// The larger of width and height.
fn extent(low: (f64, f64), high: (f64, f64)) -> f64 {
    (high.0 - low.0).max(high.1 - low.1).max(f64::MIN_POSITIVE)
}

/// x and y in turn, in whole units.
fn numbers(unit: f64, places: &[(f64, f64)]) -> Vec<i32> {
    places.iter().flat_map(|&(x, y)| [x, y]).map(|value| (value / unit).round() as i32).collect()
}

/// A branch from the side, along z.
fn side(branch: &SetaBranch) -> impl Iterator<Item = (f64, f64)> + Clone {
    branch.sections.iter().map(|at| (at.place[0], at.place[1]))
}

/// The upper side of the ground between two places.
fn surface(peel: &Peel, from: f64, to: f64) -> Vec<(f64, f64)> {
    let substrate = &peel.model.ground.substrate;
    let pieces = if substrate.is_flat() { 1 } else { DRAWN };
    let place = |k: usize| from + (to - from) * k as f64 / pieces as f64;
    (0..=pieces).map(place).map(|x| (x, substrate.top(x, x))).collect()
}
