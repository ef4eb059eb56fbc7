//! The run behind [`pull_in_time`].

use super::result::{InTimeFailure, InTimeFailureKind, InTimePoint, PullInTime};
use super::settings::{PullRate, TimeAccuracy, Until};
use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::model::problem::motion::{MovingBeam, MovingMaterial};
use crate::solve::newton::{NewtonOptions, settle};
use crate::solve::observables::{Observables, PathConstraint};
use crate::solve::path::control::controlled;
use crate::solve::state::State;
use crate::solve::time::drive::Drive;
use crate::solve::time::integrator::{Crossing, StepControl, TimeIntegrator, TimeOptions};
use crate::solve::time::rule::Motion;
use crate::solve::workspace::{ShouldStop, Workspace};

/// A beam adheres no more where its front is shorter than this many process lengths; the time of that is found to this share of it.
const LOOSE: f64 = 1.0;
const WITHIN: f64 = 1e-3;
/// Length of the elements over that of the process zone, and how many there are besides.
const ELEMENT: f64 = 2.0;
const BESIDES: usize = 12;
/// Accuracy of the equilibrium at the start.
const AT_START: f64 = 1e-12;
/// Way on which the grip accelerates, over that which moves a section by r0.
const ACCELERATES: f64 = 0.1;
/// The first step over the time of acceleration, the longest over the time of the whole pull, and Newton's tolerance over that of a step.
const FIRST: f64 = 1e-2;
const LONGEST: f64 = 0.005;
const NEWTON: f64 = 1e-6;

/// A beam in equilibrium, from which any number of pulls may start.
#[derive(Clone)]
pub struct PullStart {
    /// In its grip, behind the machine's spring
    pub beam: MovingBeam,
    /// The equilibrium
    pub at: State,
    /// Its displacement, nm
    pub displacement: f64,
    /// On how much of the way the grip accelerates where nothing else is said, nm
    pub accelerates: f64,
}

/// Pulls a strip or a spatula at a rate, from equilibrium on.
///
/// # Errors
/// What the model cannot be followed with, no equilibrium at the start, a step in time that failed.
pub fn pull_in_time(
    model: &PeelModel,
    material: &MovingMaterial,
    pull: &PullRate,
    accuracy: &TimeAccuracy,
    should_stop: Option<ShouldStop>,
) -> Result<PullInTime, InTimeFailure> {
    let failed = |why| InTimeFailure { why, reached: None };
    let start = pull_start(model, material, pull.from, accuracy).map_err(failed)?;
    pull_in_time_from(&start, pull, accuracy, should_stop)
}

/// The equilibrium at a displacement, on a fixed mesh.
///
/// # Errors
/// What the model cannot be followed with, no equilibrium there.
pub fn pull_start(
    model: &PeelModel,
    material: &MovingMaterial,
    displacement: f64,
    accuracy: &TimeAccuracy,
) -> Result<PullStart, InTimeFailureKind> {
    let mut beam = model.in_time(material, accuracy.order)?;
    let elements = accuracy.elements.unwrap_or_else(|| {
        let process = beam.statics.beam.process_length();
        (model.contact_extent() / (ELEMENT * process)).ceil() as usize + BESIDES
    });
    let no_start = |cause| InTimeFailureKind::NoStart { displacement, cause };
    let newton = NewtonOptions { tolerance: AT_START, largest_update: 0.5, most_iterations: 30, exact_slope: false };
    let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: 0.0 };
    let first = beam.statics.initial(elements);
    let rest = settle(&beam.statics, first, &constraint, &newton, &mut Workspace::default()).map_err(no_start)?;
    let compliance = model.grip.stiffness.map_or(0.0, f64::recip);
    beam.statics.grip.compliance = compliance;
    beam.dynamics.problem.grip.compliance = compliance;
    let at = if displacement == 0.0 {
        rest.at
    } else {
        let found = controlled(&beam.statics, rest.at, Observables::DISPLACEMENT, &[displacement], AT_START);
        found.map_err(no_start)?.swap_remove(0).at
    };
    Ok(PullStart { beam, at, displacement, accelerates: ACCELERATES * model.first_way() })
}

/// Pulls from an equilibrium that is known; it need not be the one at `pull.from`, which is taken from there.
///
/// # Errors
/// A number out of range, a step in time that failed.
pub fn pull_in_time_from(
    start: &PullStart,
    pull: &PullRate,
    accuracy: &TimeAccuracy,
    should_stop: Option<ShouldStop>,
) -> Result<PullInTime, InTimeFailure> {
    let pull = &PullRate { from: start.displacement, ..*pull };
    check(pull, accuracy, pull.accelerates.unwrap_or(start.accelerates))
        .map_err(|why| InTimeFailure { why, reached: None })?;
    let accelerates = pull.accelerates.unwrap_or(start.accelerates);
    let (ramp, problem) = (pull.ramp(accelerates), &start.beam.dynamics);
    let end = ramp.end() + if let Until::Held(time) = pull.until { time } else { 0.0 };
    let still = vec![0.0; problem.system.unknowns(&start.at)];
    let memory = problem.system.relaxed_memory(&start.at);
    let motion = Motion::new(0.0, start.at.clone(), still.clone(), still, memory);
    let process = start.beam.statics.beam.process_length();
    let options = TimeOptions {
        spectral_radius: accuracy.spectral_radius,
        newton: NEWTON * accuracy.tolerance,
        crossing: Some(Crossing { monitor: FRONT, level: LOOSE * process, within: WITHIN * process }),
        ..TimeOptions::new(StepControl::Adaptive {
            tolerance: accuracy.tolerance,
            first: FIRST * ramp.smooth,
            longest: LONGEST * end,
        })
    };
    let mut integrator =
        TimeIntegrator::new(problem, Drive::ramp(ramp), motion, options, Workspace::until(should_stop));
    let mut pulled = PullInTime {
        points: vec![point(&integrator)],
        peak: None,
        contact_lost: None,
        elements: start.at.mesh.elements(),
        iterations: 0,
        tried: 0,
    };
    let mut went = Ok(());
    while went.is_ok() && integrator.motion().time < end {
        if pulled.points.len() > accuracy.most_steps {
            let (steps, time) = (accuracy.most_steps, integrator.motion().time);
            went = Err(InTimeFailureKind::TooManySteps { steps, time, end });
            break;
        }
        went = integrator.advance(end).map_err(InTimeFailureKind::from);
        if went.is_ok() {
            pulled.points.push(point(&integrator));
        }
        if pull.until == Until::ContactLost && integrator.crossed().is_some() {
            break;
        }
    }
    pulled.contact_lost = integrator.crossed();
    (pulled.iterations, pulled.tried) = integrator.effort();
    pulled.find_peak();
    match went {
        Ok(()) => Ok(pulled),
        Err(why) => Err(InTimeFailure { why, reached: Some(Box::new(pulled)) }),
    }
}

fn point(integrator: &TimeIntegrator) -> InTimePoint {
    let motion = integrator.motion();
    InTimePoint {
        time: motion.time,
        displacement: integrator.displacement(),
        force: motion.at.force,
        front: integrator.monitors()[FRONT],
        balance: *integrator.balance(),
    }
}

fn check(pull: &PullRate, accuracy: &TimeAccuracy, accelerates: f64) -> Result<(), InTimeFailureKind> {
    let numbers = [
        ("the rate of the pull in nm/ns", pull.rate, pull.rate > 0.0, "positive"),
        ("the end of the pull in nm", pull.to, pull.to != pull.from, "another displacement than its beginning"),
        ("the way on which the grip accelerates in nm", accelerates, accelerates > 0.0, "positive"),
        ("the tolerance of a step in time", accuracy.tolerance, accuracy.tolerance > 0.0, "positive"),
        (
            "the spectral radius",
            accuracy.spectral_radius,
            (0.0..=1.0).contains(&accuracy.spectral_radius),
            "from 0 to 1",
        ),
    ];
    match numbers.into_iter().find(|(_, value, good, _)| !(*good && value.is_finite())) {
        Some((what, value, _, wanted)) => Err(InTimeFailureKind::OutOfRange { what, value, wanted }),
        None => Ok(()),
    }
}
