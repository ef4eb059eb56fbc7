//! The run behind [`pull_in_time`].

use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::PeelModel;
use crate::model::problem::motion::{MovingBeam, MovingMaterial, NotInTime};
use crate::number::root;
use crate::solve::error::{Quantity, SolveError};
use crate::solve::newton::{NewtonOptions, settle};
use crate::solve::path::options::controlled;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::time::drive::{Drive, Ramp};
use crate::solve::time::dynamic_system::EnergyBalance;
use crate::solve::time::integrator::{Crossing, Inside, StepControl, TimeError, TimeIntegrator, TimeOptions};
use crate::solve::time::rule::Motion;
use crate::solve::workspace::{ShouldStop, Workspace};
use crate::study::asked::events::{EventAction, EventAt, EventQuantity, StationQuantity};
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::states::fields::Reader;

/// A beam adheres no more where its front is shorter than this many process lengths; the time of that is found to this share of it.
const LOOSE: f64 = 1.0;
const WITHIN: f64 = 1e-3;
/// Length of the elements over that of the process zone, and how many there are besides.
const ELEMENT: f64 = 2.0;
/// The same where the traction grows with the rate of opening: it bends where the face begins to be pulled.
const WITH_OPENING: f64 = 1.0;
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
pub(crate) struct PullStart {
    /// In its grip, behind the machine's spring
    pub beam: MovingBeam,
    /// The equilibrium
    pub at: State,
    /// Its displacement, nm
    pub displacement: f64,
    /// On how much of the way the grip accelerates where nothing else is said, nm
    pub accelerates: f64,
    /// Of which it was made
    pub model: PeelModel,
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
    pull_in_time_from(&start, pull, accuracy, &[], should_stop)
}

/// The same with stations and events of the user, which are located to round-off inside of steps; one that stops ends the pull where it lies. Of
/// the stop criteria these are heeded, and what the caller says.
///
/// # Errors
/// As of [`pull_in_time`]; an event whose quantity is no number.
pub fn pull_in_time_with(
    model: &PeelModel,
    material: &MovingMaterial,
    pull: &PullRate,
    accuracy: &TimeAccuracy,
    stop: &StopCriteria,
) -> Result<PullInTime, InTimeFailure> {
    let failed = |why| InTimeFailure { why, reached: None };
    let start = pull_start(model, material, pull.from, accuracy).map_err(failed)?;
    pull_in_time_from(&start, pull, accuracy, &stop.events, stop.while_followed())
}

/// The equilibrium at a displacement, on a fixed mesh.
///
/// # Errors
/// What the model cannot be followed with, no equilibrium there.
pub(crate) fn pull_start(
    model: &PeelModel,
    material: &MovingMaterial,
    displacement: f64,
    accuracy: &TimeAccuracy,
) -> Result<PullStart, InTimeFailureKind> {
    let mut beam = model.in_time(material, accuracy.order)?;
    let elements = accuracy.elements.unwrap_or_else(|| {
        let process = beam.statics.beam.process_length();
        let element = if material.opening.is_some() { WITH_OPENING } else { ELEMENT };
        (model.contact_extent() / (element * process)).ceil() as usize + BESIDES
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
    Ok(PullStart { beam, at, displacement, accelerates: ACCELERATES * model.first_way(), model: model.clone() })
}

/// Pulls from an equilibrium that is known; it need not be the one at `pull.from`, which is taken from there.
///
/// # Errors
/// A number out of range, a step in time that failed.
pub(crate) fn pull_in_time_from(
    start: &PullStart,
    pull: &PullRate,
    accuracy: &TimeAccuracy,
    events: &[EventAt],
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
        stations: Vec::new(),
        stopped: None,
        peak: None,
        contact_lost: None,
        elements: start.at.mesh.elements(),
        iterations: 0,
        tried: 0,
    };
    let reader = Reader::new(&start.model, &start.beam.statics.beam);
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
            went = pulled.look(&mut integrator, events, &reader);
        }
        if pulled.stopped.is_some() {
            break;
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

/// By how much an event is missed at most, over the largest value of its quantity on the step.
const MET: f64 = 1e-10;

impl PullInTime {
    /// Looks for stations and events on the newest step; one that stops the pull takes the place of its end.
    fn look(
        &mut self,
        integrator: &mut TimeIntegrator,
        events: &[EventAt],
        reader: &Reader,
    ) -> Result<(), InTimeFailureKind> {
        let [.., from, to] = self.points[..] else { return Ok(()) };
        let failed = |cause| TimeError::Failed { time: from.time, step: to.time - from.time, cause };
        let mut found: Vec<(f64, InTimeStation)> = Vec::new();
        for (event, at) in events.iter().enumerate() {
            let value = |point: &InTimePoint, state: &State| match &at.quantity {
                EventQuantity::Named(StationQuantity::Time) => point.time,
                EventQuantity::Named(StationQuantity::Displacement) => point.displacement,
                EventQuantity::Named(StationQuantity::Force) => point.force,
                EventQuantity::Named(StationQuantity::Front) => point.front,
                EventQuantity::Named(StationQuantity::FreeEndGap) => reader.free_end_gap(state),
                EventQuantity::OfBeam(of) => of(&reader.state(state, point.displacement)),
                EventQuantity::Named(_) | EventQuantity::OfSeta(_) => f64::NAN,
            };
            let ends = [value(&from, integrator.before()), value(&to, &integrator.motion().at)];
            let not_finite = || failed(SolveError::NotFiniteUpdate { quantity: Quantity::EventQuantity });
            if ends.iter().any(|end| !end.is_finite()) {
                return Err(not_finite().into());
            }
            if !at.passes(ends[0], ends[1]) {
                continue;
            }
            let mut solve = |share: f64| {
                let Inside { motion, monitors, balance } = integrator.inside(share)?;
                let point = InTimePoint {
                    time: motion.time,
                    displacement: integrator.displacement_of(&motion.at),
                    force: motion.at.force,
                    front: monitors[FRONT],
                    balance,
                };
                let free_end_gap = reader.free_end_gap(&motion.at);
                let above = value(&point, &motion.at) - at.value;
                Ok::<_, SolveError>((InTimeStation { event, point, free_end_gap, after: self.points.len() - 2 }, above))
            };
            let scale = MET * at.value.abs().max(ends[0].abs()).max(ends[1].abs());
            let is_met = |above: f64, _, left: f64| above.abs() <= scale || left <= MET;
            let [low, high] = [(0.0, ends[0] - at.value), (1.0, ends[1] - at.value)];
            // where the step ends at it nothing is to be found
            let at_end = if high.1.abs() <= scale { Some(1.0) } else { None };
            let (station, place) = match at_end {
                Some(share) => (solve(share).map_err(failed)?.0, share),
                None => {
                    let (station, passing) = root::passed(low, high, solve, is_met).map_err(failed)?;
                    (station, passing.place)
                }
            };
            found.push((place, station));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, station) in found {
            self.stations.push(station);
            if events[station.event].action == EventAction::Stop {
                self.points.pop();
                self.points.push(station.point);
                self.stopped = Some(Bound::Event { name: events[station.event].name.clone() });
                break;
            }
        }
        Ok(())
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

// -- What a pull in time gives --

/// The beam at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InTimePoint {
    /// t since the pull began, ns
    pub time: f64,
    /// U of what moves the grip, nm
    pub displacement: f64,
    /// P of the grip, nN
    pub force: f64,
    /// The peeling front, nm: how long the free end's adhesion would have to go on
    pub front: f64,
    /// Energies, aJ
    pub balance: EnergyBalance,
}

/// A station of a pull in time, or where an event of the user lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InTimeStation {
    /// Which one of [`StopCriteria::events`]
    pub event: usize,
    /// The beam there: by a step of its own from the step before
    pub point: InTimePoint,
    /// Distance of the nearer edge of the section at the free end from the ground, nm
    pub free_end_gap: f64,
    /// It lies behind this one of the points
    pub after: usize,
}

/// The largest force of the pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InTimePeak {
    /// ns
    pub time: f64,
    /// nm
    pub displacement: f64,
    /// nN
    pub force: f64,
}

/// A pull in time.
#[derive(Clone, Debug)]
pub struct PullInTime {
    /// Every step, from rest on
    pub points: Vec<InTimePoint>,
    /// Stations and events of the user, in time
    pub stations: Vec<InTimeStation>,
    /// The event that stopped it, if one has
    pub stopped: Option<Bound>,
    /// The largest force, by a parabola through the three points next to it; none where the force is largest at an end
    pub peak: Option<InTimePeak>,
    /// When nothing adhered any more for the first time, ns
    pub contact_lost: Option<f64>,
    /// Elements of the mesh
    pub elements: usize,
    /// Newton iterations
    pub iterations: usize,
    /// Steps that were tried, those that were refused among them
    pub tried: usize,
}

impl PullInTime {
    /// The last point.
    pub fn last(&self) -> InTimePoint {
        self.points.last().copied().unwrap_or_default()
    }

    /// The largest force of any point, nN.
    pub fn largest_force(&self) -> f64 {
        let largest = self.points.iter().map(|point| point.force).fold(f64::NEG_INFINITY, f64::max);
        self.peak.map_or(largest, |peak| peak.force.max(largest))
    }

    /// The largest defect of the balance, over the largest work: work = stored + kinetic + adhesion + dissipated.
    pub fn balance_error(&self) -> f64 {
        let Some(start) = self.points.first() else { return 0.0 };
        let defect = |point: &InTimePoint| point.balance.defect(&start.balance).abs();
        let largest = |of: &dyn Fn(&InTimePoint) -> f64| self.points.iter().map(of).fold(0.0, f64::max);
        largest(&defect) / largest(&|point| point.balance.work.abs()).max(f64::MIN_POSITIVE)
    }

    /// Finds the peak among the points.
    pub(in crate::study) fn find_peak(&mut self) {
        let forces = self.points.iter().map(|point| point.force).enumerate();
        let Some((k, _)) = forces.max_by(|a, b| a.1.total_cmp(&b.1)) else { return };
        if k == 0 || k + 1 == self.points.len() {
            return;
        }
        let [before, here, after] = [self.points[k - 1], self.points[k], self.points[k + 1]];
        let (a, b) = (here.time - before.time, after.time - here.time);
        let (down, up) = ((here.force - before.force) / a, (after.force - here.force) / b);
        let bend = (up - down) / (a + b);
        // the parabola's slope at the middle point
        let slope = down + bend * a;
        let shift = (-0.5 * slope / bend).clamp(-a, b);
        let rate = (after.displacement - before.displacement) / (a + b);
        self.peak = Some(InTimePeak {
            time: here.time + shift,
            displacement: here.displacement + rate * shift,
            force: here.force + shift * (slope + bend * shift),
        });
    }
}

/// Why a pull was not followed to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum InTimeFailureKind {
    #[error(transparent)]
    Model(#[from] NotInTime),
    #[error("{what} is {value}; it must be {wanted}")]
    OutOfRange { what: &'static str, value: f64, wanted: &'static str },
    #[error(
        "there is no equilibrium at u = {displacement:.6} nm, where the pull in time begins: {cause}; try another `from`"
    )]
    NoStart { displacement: f64, cause: SolveError },
    #[error(transparent)]
    Step(#[from] TimeError),
    #[error(
        "{steps} steps were not enough for the pull: it is at t = {time:.6e} ns of {end:.6e} ns; try a larger tolerance"
    )]
    TooManySteps { steps: usize, time: f64, end: f64 },
}

/// A failure with what was reached.
#[derive(Clone, Debug)]
pub struct InTimeFailure {
    /// Why
    pub why: InTimeFailureKind,
    /// Up to there
    pub reached: Option<Box<PullInTime>>,
}

// -- How a grip is pulled in time, and how accurately that is followed --

/// Where a pull in time ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Until {
    /// Where nothing adheres any more, or at the end of the way
    #[default]
    ContactLost,
    /// So long after the grip has come to rest, ns
    Held(f64),
}

/// How what moves the grip goes: from rest at one displacement to rest at another, at a constant rate in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullRate {
    /// Displacement at which the beam is in equilibrium before, nm
    pub from: f64,
    /// Displacement of the end of the way, nm
    pub to: f64,
    /// nm/ns = m/s
    pub rate: f64,
    /// On how much of the way the grip accelerates, and on how much it comes to rest, nm; none: a tenth of `PeelModel::first_way`. A jump in
    /// velocity makes a force of its own.
    pub accelerates: Option<f64>,
    /// Where it ends
    pub until: Until,
}

impl PullRate {
    /// From the displacement zero on until nothing adheres.
    pub const fn new(to: f64, rate: f64) -> Self {
        Self { from: 0.0, to, rate, accelerates: None, until: Until::ContactLost }
    }

    /// Displacement in time, with accelerations on so much of the way, at most a quarter of it.
    pub(in crate::study) fn ramp(&self, accelerates: f64) -> Ramp {
        let way = (self.to - self.from).abs();
        Ramp::new(self.from, self.to, self.rate, 2.0 * accelerates / way)
    }
}

/// How accurately a pull in time is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeAccuracy {
    /// Elements, of a fixed mesh; none: as many as make them two process lengths long, and a dozen more
    pub elements: Option<usize>,
    /// Order of the elements, 1 to 8
    pub order: usize,
    /// Error of a step in time, in units of the gap at rest next to the substrate
    pub tolerance: f64,
    /// ρ∞: what is left, a step, of vibrations that are faster than steps
    pub spectral_radius: f64,
    /// Most steps
    pub most_steps: usize,
}

impl Default for TimeAccuracy {
    fn default() -> Self {
        Self { elements: None, order: 7, tolerance: 2e-6, spectral_radius: 0.8, most_steps: 100_000 }
    }
}
