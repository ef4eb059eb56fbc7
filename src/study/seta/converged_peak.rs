//! The peak of a pull-off on finer and finer meshes, until the mesh no longer matters.
//!
//! The seta is laid along the branches of the peak a little before it, with the same tips on the same branches of their law, comes to rest on a
//! mesh of elements one order higher, and is pulled on until its force has passed its largest value. So only a few equilibria are computed again.
//! What is found is the peak of a finer mesh where the same tips detach before it as on the coarser one.

use super::loading::{SetaLoading, SetaOptions};
use super::result::SetaProgress;
use super::result::{SetaEffort, SetaEnd, SetaMoment, SetaPullOff};
use super::run::Run;
use super::standing::{RootDrive, Standing, TipTangent};
use crate::beam::element::basis::MOST_ORDER;
use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::{Seta, SetaModel};
use crate::model::seta::tip_law::TipBranch;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::stop_criteria::{Stage, StopCriteria};
use crate::study::states::seta_state::{LocationError, SetaPoint, SetaState};
use serde::{Deserialize, Serialize};

/// How far before the peak the finer mesh begins, over the first step: the nearest at which it is stable with the same tips and its force rises.
const BEFORE: [f64; 4] = [0.02, 0.2, 2.0, 20.0];
/// Of Newton's method at the first equilibrium: the axis of a branch is near, but not in equilibrium.
const LARGEST_UPDATE: f64 = 30.0;
const MOST_ITERATIONS: usize = 20;
/// Equilibria until the peak has to be passed.
const MOST_POINTS: usize = 200;
/// Peaks of two meshes that differ by more than this share of the force are not taken for one: other tips may have let go.
const LARGEST_ERROR: f64 = 1e-2;

/// The peak of a pull-off on the finest of its meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvergedPeak {
    /// Its numbers
    pub peak: SetaMoment,
    /// Where it was looked for: its error
    pub location: Option<LocationError>,
    /// Order of the elements
    pub order: usize,
    /// By how much it differs from the peak on elements one order lower: above its own error as long as each mesh is better than the one before
    pub mesh: LocationError,
}

/// The peak of a pull-off on elements of rising order, until that on two meshes differs by no more than this share of the force, or as far as it
/// goes. None where there is no peak, where it is that behind an event, or where the first finer mesh does not come to it.
///
/// # Errors
/// What of the seta cannot be computed.
pub fn converged_peak(
    model: &SetaModel,
    loading: &SetaLoading,
    options: &SetaOptions,
    pull_off: &SetaPullOff,
    tolerance: f64,
    stop: &StopCriteria,
) -> Result<Option<ConvergedPeak>, SetaError> {
    let Some(peak) = &pull_off.peak else { return Ok(None) };
    if pull_off.events.iter().any(|event| event.after == peak.point) {
        return Ok(None);
    }
    let (mut mesh, mut coarser, mut found) = (model.mesh.clone(), peak.clone(), None);
    let mut nearest = 0;
    while mesh.order < MOST_ORDER {
        mesh = mesh.finer();
        let finer = SetaModel { mesh: mesh.clone(), ..model.clone() };
        let is_near = |peak: &SetaState| {
            let [force, before] = [peak, &coarser].map(|state| state.point.force_along);
            (force - before).abs() <= LARGEST_ERROR * before.abs()
        };
        let Some(peak) = peak_on(&finer, loading, options, &coarser, &mut nearest, stop)?.filter(is_near) else {
            break;
        };
        let error = LocationError {
            force: (peak.point.force_along - coarser.point.force_along).abs(),
            displacement: (peak.point.displacement - coarser.point.displacement).abs(),
        };
        found = Some(ConvergedPeak {
            peak: SetaMoment::from(&peak),
            location: peak.location,
            order: mesh.order,
            mesh: error,
        });
        if error.force <= tolerance * peak.point.force_along.abs() {
            break;
        }
        coarser = peak;
    }
    Ok(found)
}

/// The peak on a mesh, from that on a coarser one. Where that began, `nearest` of [`BEFORE`], this one is tried first.
fn peak_on(
    finer: &SetaModel,
    loading: &SetaLoading,
    options: &SetaOptions,
    peak: &SetaState,
    nearest: &mut usize,
    stop: &StopCriteria,
) -> Result<Option<SetaState>, SetaError> {
    let step = peak.point.step;
    let (drive, standing) = (drive_of(&finer.seta, loading, &peak.point), standing_in(finer, peak)?);
    let laid = laid_along(&standing, &finer.seta, peak);
    for (k, share) in BEFORE.into_iter().enumerate().skip(*nearest) {
        let before = share * options.first_step;
        let Some(here) = begin(&standing, &drive, laid.clone(), peak.point.displacement - before, options, stop) else {
            continue;
        };
        *nearest = k;
        let progress = SetaProgress {
            result: SetaPullOff::empty(standing.tree.elements()),
            here,
            tips: standing.tips.iter().map(|tip| (tip.on, tip.foot)).collect(),
            step,
            from: drive.from,
            ahead: before,
            softest: None,
        };
        let Ok(mut run) = Run::new(finer, loading, options, stop, Some(progress))? else { continue };
        return Ok(pulled_on(&mut run, &peak.point, before));
    }
    Ok(None)
}

/// The root moved as in the step of the peak, from where that began.
fn drive_of(seta: &Seta, loading: &SetaLoading, peak: &SetaPoint) -> RootDrive {
    let rest = seta.joint_place(0);
    let along = RootDrive::new(loading.steps[peak.step].direction, rest).direction();
    RootDrive::new(along, std::array::from_fn(|i| rest[i] + peak.root[i] - peak.displacement * along[i]))
}

/// The seta with its tips as in a state.
fn standing_in(model: &SetaModel, state: &SetaState) -> Result<Standing, SetaError> {
    let mut standing = Standing::new(model, TipBranch::Attached)?;
    for (tip, state) in standing.tips.iter_mut().zip(&state.tips) {
        (tip.on, tip.foot) = (state.on, state.foot);
    }
    Ok(standing)
}

/// The equilibrium at a displacement, from a state nearby; none where it is not stable there, a tip changes, or its force falls.
fn begin(
    standing: &Standing,
    drive: &RootDrive,
    near: State,
    displacement: f64,
    options: &SetaOptions,
    stop: &StopCriteria,
) -> Option<Solution> {
    let mut ws = Workspace::until(stop.for_solves(Stage::Results));
    let problem = standing.problem(drive, None, TipTangent::Own);
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: displacement };
    let newton = NewtonOptions { largest_update: LARGEST_UPDATE, most_iterations: MOST_ITERATIONS, ..options.newton() };
    // on the finer mesh the peak may lie before that of the coarser one
    let rises = |solution: &Solution| solution.slope.force * solution.slope.displacement > 0.0;
    let is_alike = |solution: &Solution| solution.negative == 0 && standing.changing(&solution.at).is_empty();
    solve(&problem, near, &held, &newton, &mut ws).ok().filter(is_alike).filter(rises)
}

/// The nodes of a tree where the branches of a state lie.
fn laid_along(standing: &Standing, seta: &Seta, state: &SetaState) -> State {
    let axes: Vec<_> = (1..seta.joints()).map(|joint| state.axis(seta, joint)).collect();
    let joint = |joint: usize| (state.joints[joint].place, state.joints[joint].directors);
    let section = |branch: usize, s: f64| {
        let (place, directors) = axes[branch].at(s / axes[branch].length);
        (place.into(), directors)
    };
    standing.tree.laid_along(joint, section)
}

/// The largest force before the next event, or where the force falls again as far behind the peak of the coarser mesh as the run began before it.
fn pulled_on(run: &mut Run, peak: &SetaPoint, before: f64) -> Option<SetaState> {
    let step = &run.loading.steps[peak.step];
    let drive = RootDrive::new(step.direction, run.progress.from);
    for _ in 0..MOST_POINTS {
        let leads_to_event = run.advance_to_event(step, &drive, run.options.longest_step).ok()?;
        let Observables { displacement, force, .. } = run.progress.here.observables;
        let result = &mut run.progress.result;
        let is_below = result.peak.as_ref().is_some_and(|largest| force < largest.point.force_along);
        if (is_below && displacement > peak.displacement + before) || leads_to_event {
            return result.peak.take();
        }
    }
    None
}

// -- What a pull-off found, without its points and its states: what a row of a sweep has, and a sample --

/// The numbers of a pull-off.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaResult {
    /// On the finest mesh, or as of [`SetaPullOff`] where that was not found
    pub peak: Option<SetaMoment>,
    /// By how much the force of the peak differs from that on the mesh before, nN; none where no finer mesh came to the peak
    pub mesh_error: Option<f64>,
    /// As of [`SetaPullOff`]
    pub first_detachment: Option<SetaMoment>,
    /// As of [`SetaPullOff`]
    pub last_detachment: Option<SetaMoment>,
    /// How many events there are
    pub events: usize,
    /// Changes of tips in the largest event
    pub most_at_once: usize,
    /// Of the root over all steps, aJ
    pub work: f64,
    /// At events, aJ
    pub released: f64,
    /// As of [`SetaPullOff::imbalance`]
    pub imbalance: f64,
    /// Tips that adhere at the end
    pub attached: usize,
    /// As of [`SetaPullOff`]
    pub end: SetaEnd,
    /// Equilibria
    pub points: usize,
    /// As of [`SetaPullOff`]
    pub effort: SetaEffort,
}

impl SetaResult {
    /// Of a pull-off, and of its peak on finer meshes.
    pub fn new(pull_off: &SetaPullOff, converged: Option<&ConvergedPeak>) -> Self {
        let moment = |state: &Option<SetaState>| state.as_ref().map(SetaMoment::from);
        let last = pull_off.points.last().copied().unwrap_or_default();
        Self {
            peak: converged.map(|found| found.peak).or_else(|| moment(&pull_off.peak)),
            mesh_error: converged.map(|found| found.mesh.force),
            first_detachment: moment(&pull_off.first_detachment),
            last_detachment: moment(&pull_off.last_detachment),
            events: pull_off.events.len(),
            most_at_once: pull_off.events.iter().map(|event| event.tips.len()).max().unwrap_or(0),
            work: last.work,
            released: last.released,
            imbalance: pull_off.imbalance(),
            attached: last.attached,
            end: pull_off.end.clone(),
            points: pull_off.points.len(),
            effort: pull_off.effort,
        }
    }
}
