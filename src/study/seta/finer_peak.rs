//! The peak of a pull-off on a finer mesh: what the mesh does to its force.
//!
//! The seta is laid along the branches of the peak a little before it, with the same tips on the same branches of their law, comes to rest on the
//! finer mesh, and is pulled on until its force has passed its largest value. So only a few equilibria are computed again. What is found is the error
//! of the mesh where the same tips detach before the peak on both meshes.

use super::loading::SetaLoading;
use super::numbers::SetaMoment;
use super::options::SetaOptions;
use super::progress::SetaProgress;
use super::result::{SetaPoint, SetaPullOff, SetaState};
use super::run::Run;
use super::standing::{RootDrive, Standing, TipTangent};
use crate::model::{Seta, SetaError, SetaModel, TipBranch};
use crate::solve::{NewtonOptions, Observables, PathConstraint, Solution, State, Workspace, solve};
use crate::study::{Stage, StopCriteria};

/// How far before the peak the finer mesh begins, over the first step: the nearest at which it is stable with the same tips and its force rises.
const BEFORE: [f64; 4] = [0.02, 0.2, 2.0, 20.0];
/// Of Newton's method at the first equilibrium: the cubic of a branch is near, but not in equilibrium.
const LARGEST_UPDATE: f64 = 30.0;
const MOST_ITERATIONS: usize = 20;
/// Equilibria until the peak has to be passed.
const MOST_POINTS: usize = 200;

/// The peak of a pull-off on a mesh of elements one order higher. None where there is no peak, where it is that behind an event, or where the
/// finer mesh does not come to it.
///
/// # Errors
/// What of the seta cannot be computed.
pub fn peak_on_finer_mesh(
    model: &SetaModel,
    loading: &SetaLoading,
    options: &SetaOptions,
    pull_off: &SetaPullOff,
    stop: &StopCriteria,
) -> Result<Option<SetaMoment>, SetaError> {
    let Some(peak) = &pull_off.peak else { return Ok(None) };
    if pull_off.events.iter().any(|event| event.after == peak.point) {
        return Ok(None);
    }
    let finer = SetaModel { mesh: model.mesh.finer(), ..model.clone() };
    let step = peak.point.step;
    let (drive, standing) = (drive_of(&finer.seta, loading, &peak.point), standing_in(&finer, peak)?);
    let laid = laid_along(&standing, &finer.seta, peak);
    for share in BEFORE {
        let before = share * options.first_step;
        let Some(here) = begin(&standing, &drive, laid.clone(), peak.point.displacement - before, options, stop) else {
            continue;
        };
        let progress = SetaProgress {
            result: SetaPullOff::empty(standing.tree.elements()),
            here,
            tips: standing.tips.iter().map(|tip| (tip.on, tip.foot)).collect(),
            step,
            from: drive.from,
            ahead: before,
            softest: None,
        };
        let Ok(mut run) = Run::new(&finer, loading, options, stop, Some(progress))? else { continue };
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
    let axes: Vec<_> = (1..2 * seta.tips()).map(|joint| state.axis(seta, joint)).collect();
    let joint = |joint: usize| (state.joints[joint].place, state.joints[joint].directors);
    let section = |branch: usize, s: f64| {
        let (axis, length) = &axes[branch];
        let (place, directors) = axis.at(s / length);
        (place.into(), directors)
    };
    standing.tree.laid_along(joint, section)
}

/// The largest force before the next event, or where the force falls again as far behind the peak of the coarser mesh as the run began before it.
fn pulled_on(run: &mut Run, peak: &SetaPoint, before: f64) -> Option<SetaMoment> {
    let step = &run.loading.steps[peak.step];
    let drive = RootDrive::new(step.direction, run.progress.from);
    for _ in 0..MOST_POINTS {
        run.advance(step, &drive, run.options.longest_step).ok()?;
        let Observables { displacement, force, .. } = run.progress.here.observables;
        if let Some(largest) = &run.progress.result.peak {
            let is_passed = displacement > peak.displacement + before && force < largest.point.force_along;
            if is_passed || !run.progress.result.events.is_empty() {
                return Some(SetaMoment::from(largest));
            }
        }
    }
    None
}
