//! The peel of a strip or a spatula as a solid: its path, its limit points and their errors, how it ended.
//!
//! The path is followed as that of a beam, by [`crate::solve::PathTracer`]; what differs is the error ([`super::finer`]).

use super::super::asked::events::{EventAt, StationQuantity};
use super::super::asked::stop_criteria::{Bound, FollowedUntil, Stage, StopCriteria};
use super::super::peel::budget::Checkpoint;
use super::finer::{Finer, SolidErrors};
use crate::model::peel::PeelModel;
use crate::model::solid::{SolidError, SolidSettings};
use crate::solid::body::SolidBody;
use crate::solid::spatula::solid_spatula::SolidSpatula;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::PathOptions;
use crate::solve::points::locate::Located;
use crate::solve::points::passing::{FoundValue, PathNumber, SoughtValue};
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
use crate::solve::problem::{EndConditions, Problem};
use crate::solve::relax::{Held, RelaxError, RelaxOptions, relax};
use crate::solve::state::{Observables, State};
use crate::solve::system::INTERFACE;
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// What is asked of the peel of a solid.
#[derive(Clone, Debug)]
pub struct SolidOptions {
    /// Where the path is stopped although it goes on, and the stations and events that are located on it: of [`StationQuantity::OF_SOLID`]
    pub stop: StopCriteria,
    /// How many limit points and stations are solved again on a finer mesh, from the first on
    pub bounded: usize,
    /// Error of a prediction along the path that its steps aim at, relative to the gap; none: by the body
    pub step: Option<f64>,
}

impl Default for SolidOptions {
    /// The whole path, with errors of the first twenty limit points.
    fn default() -> Self {
        Self { stop: StopCriteria::default(), bounded: 20, step: None }
    }
}

/// An error of a prediction that steps aim at: those over one element are then some five or more. The path of a spatula is longer.
const STEP: f64 = 0.02;
const STEP_OF_SPATULA: f64 = 0.05;
/// An equilibrium of a solid.
#[derive(Clone, Debug)]
pub struct SolidPoint {
    /// u, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Of the chord of the end face, rad
    pub end_rotation: f64,
    /// Length that has come off, by the logarithm of the gap, nm
    pub front: f64,
    /// Work of the grip from the start of the path on, aJ: none where the load has no potential
    pub work: Option<f64>,
    /// Negative eigenvalues with u held: none where the load has no potential
    pub negative: Option<usize>,
    /// The same with P held
    pub negative_load: Option<usize>,
    solution: Arc<Solution>,
}

impl SolidPoint {
    /// Its unknowns, for the fields of a [`SolidBody`].
    pub fn values(&self) -> &[f64] {
        &self.solution.at.values
    }
}

/// A limit point of the path of a solid.
#[derive(Clone, Debug)]
pub struct SolidLimitPoint {
    /// Of the displacement or of the force
    pub kind: LimitPointKind,
    /// u, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// It lies between `points[after]` and `points[after + 1]`.
    pub after: usize,
    /// None where it was not asked for, or where the finer mesh has no solution beside it
    pub errors: Option<SolidErrors>,
}

/// A station, or where an event of the user lies.
#[derive(Clone, Debug)]
pub struct SolidStation {
    /// Which one of [`StopCriteria::events`]
    pub event: usize,
    /// The equilibrium
    pub point: SolidPoint,
    /// It lies between `points[after]` and `points[after + 1]`.
    pub after: usize,
    /// Bound on the error of P, nN, at this displacement; none as of a limit point
    pub force_error: Option<f64>,
}

/// How the path of a solid ends.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidPathEnd {
    /// No vertex of the contact face is nearer to the ground than 10 r0.
    Detached,
    /// The force has come back to zero behind a displacement limit point, and it is still in contact.
    Pivoting,
    /// u has returned to 0.
    TurnedBack,
    /// It goes on; a stop criterion was met.
    Bound(Bound),
    /// The path could not be continued.
    Failed(TraceError),
    /// There is no path: it does not come to rest before.
    NotAtRest(RelaxError),
}

/// The peel of a solid.
#[derive(Clone, Debug)]
pub struct SolidPeel {
    /// What it was computed on
    pub body: SolidBody,
    /// From rest on
    pub points: Vec<SolidPoint>,
    /// In path order
    pub limit_points: Vec<SolidLimitPoint>,
    /// Of each station and event all that the path passes, in path order
    pub stations: Vec<SolidStation>,
    /// How it ended
    pub end: SolidPathEnd,
    /// Limit points that were not located, and steps on which the number of negative eigenvalues changed by more than limit points explain: what,
    /// and behind which point
    pub left_out: Vec<SolidLeftOut>,
    /// Newton iterations, on the path and to its limit points
    pub iterations: usize,
}

/// Something of a path that is not among its limit points.
#[derive(Clone, Debug, PartialEq)]
pub enum SolidLeftOut {
    /// A station or an event that was not located.
    NotPassed {
        /// Which one of [`StopCriteria::events`]
        event: usize,
        /// It lies between `points[after]` and `points[after + 1]`.
        after: usize,
        /// Why
        cause: SolveError,
    },
    /// A limit point that was not located.
    NotLocated {
        /// Of the displacement or of the force
        kind: LimitPointKind,
        /// It lies between `points[after]` and `points[after + 1]`.
        after: usize,
        /// Why
        cause: SolveError,
    },
    /// Negative eigenvalues with this quantity held that no limit point explains.
    Inertia {
        /// What is held
        kind: LimitPointKind,
        /// Between `points[after]` and `points[after + 1]`
        after: usize,
        /// At the first of these
        from: usize,
        /// At the second
        to: usize,
    },
}

impl SolidPathEnd {
    /// Whether the computation stopped short.
    pub fn has_failed(&self) -> bool {
        matches!(self, Self::Failed(_) | Self::NotAtRest(_))
    }
}

impl SolidPeel {
    /// Whether its path was stopped on the way, by time or by who watches it: more of it may be computed.
    pub fn is_unfinished(&self) -> bool {
        matches!(self.end, SolidPathEnd::Bound(Bound::Time { .. } | Bound::Interrupted))
    }

    /// The first maximum of the force.
    pub fn initiation_peak(&self) -> Option<&SolidLimitPoint> {
        self.limit_points.iter().find(|point| point.kind == LimitPointKind::Load)
    }

    /// The load limit point with the largest force up to the first jump.
    pub fn peak(&self) -> Option<&SolidLimitPoint> {
        let last = self.snap_off().map_or(usize::MAX, |jump| jump.after);
        let maxima = self.limit_points.iter().filter(|at| at.kind == LimitPointKind::Load && at.after <= last);
        maxima.max_by(|a, b| a.force.total_cmp(&b.force))
    }

    /// The first displacement limit point: where a displacement-controlled test jumps.
    pub fn snap_off(&self) -> Option<&SolidLimitPoint> {
        self.limit_points.iter().find(|point| point.kind == LimitPointKind::Displacement)
    }
}

/// The peel of a model as a solid.
///
/// # Errors
/// What of the model or of the settings cannot be computed. Where the path stops short, [`SolidPeel::end`] says why, with all before.
///
/// ```
/// use peelkit::model::{PeelModel, SolidSettings, StripModel};
/// use peelkit::study::{FollowedUntil, SolidOptions, StopCriteria, peel_solid};
///
/// let mut model = PeelModel::from(StripModel::of_the_paper(40.0, 1.0));
/// model.adhesion.far_face = false;
/// let options = SolidOptions { stop: StopCriteria::up_to(0.6), ..SolidOptions::default() };
/// let peel = peel_solid(&model, &SolidSettings::default(), &options)?;
/// let peak = peel.initiation_peak().expect("the force has a peak");
/// let errors = peak.errors.expect("it was found on a finer mesh as well");
/// // in a rigid grip the strip of 100 nm has its first peak at 0.325137 nN, and so has one of 40 nm
/// assert!((peak.force - 0.325137).abs() < errors.force && errors.force < 0.02);
/// # Ok::<(), peelkit::model::SolidError>(())
/// ```
pub fn peel_solid(
    model: &PeelModel,
    settings: &SolidSettings,
    options: &SolidOptions,
) -> Result<SolidPeel, SolidError> {
    peel_solid_on(model, settings, options, &Checkpoint::NOTHING)
}

/// The same, with the points of its path from an earlier run that was stopped, and each one behind them kept.
///
/// # Errors
/// As of [`peel_solid`].
pub fn peel_solid_on(
    model: &PeelModel,
    settings: &SolidSettings,
    options: &SolidOptions,
    checkpoint: &Checkpoint,
) -> Result<SolidPeel, SolidError> {
    let body = settings.body(model)?;
    let mut problem = body.problem();
    let (traced, points) = Traced::follow(&body, &mut problem, options, checkpoint);
    let problem = problem;
    let is_asked = !(traced.found.is_empty() && options.stop.events.is_empty());
    let finer = (options.bounded > 0 && is_asked).then(|| Finer::new(&body, &problem));
    let bounded = |index: usize| finer.as_ref().filter(|_| index < options.bounded);
    let solutions = &traced.solutions;
    let limit_points = traced.found.iter().enumerate().map(|(index, (kind, after, located))| {
        let [from, to] = [*after, after + 1].map(|k| solutions[k].observables.monitors[0]);
        let errors = bounded(index).and_then(|finer| finer.limit_point(*kind, located, (to - from).abs()));
        let Observables { displacement, force, .. } = located.observables;
        SolidLimitPoint { kind: *kind, displacement, force, after: *after, errors }
    });
    let limit_points = limit_points.collect();
    let (passed, missed) = passed(&body, &problem, &solutions[..points.len()], &options.stop);
    let at_rest = points.first().map_or(0.0, |first| first.solution.energy);
    let stations = passed.iter().enumerate().map(|(index, (event, found))| {
        let solution = &found.solution;
        let force_error = bounded(index).and_then(|finer| finer.station(solution, solutions));
        let point = SolidPoint::new(&body, solution, at_rest);
        SolidStation { event: *event, point, after: found.after, force_error }
    });
    let stations = stations.collect();
    let Traced { mut left_out, iterations, end, .. } = traced;
    left_out.extend(missed);
    Ok(SolidPeel { body, points, limit_points, stations, end, left_out, iterations })
}

/// A path as far as it was followed.
struct Traced {
    solutions: Vec<Arc<Solution>>,
    found: Vec<(LimitPointKind, usize, Located)>,
    left_out: Vec<SolidLeftOut>,
    iterations: usize,
    end: SolidPathEnd,
}

impl Traced {
    /// One without a point.
    fn ended(end: SolidPathEnd) -> Self {
        Self { solutions: Vec::new(), found: Vec::new(), left_out: Vec::new(), iterations: 0, end }
    }

    /// From rest to its end, with its points; a few solutions may be known behind the last of them.
    fn follow(
        body: &SolidBody,
        problem: &mut Problem,
        options: &SolidOptions,
        checkpoint: &Checkpoint,
    ) -> (Self, Vec<SolidPoint>) {
        let usual = match body {
            SolidBody::Strip(_) => STEP,
            SolidBody::Spatula(_) => STEP_OF_SPATULA,
        };
        let how = PathOptions {
            step_tolerance: options.step.unwrap_or(usual),
            first_displacement: FIRST * body.rest_gap(),
            ..PathOptions::default()
        };
        let taken = (checkpoint.taken)(&how);
        let mut known = taken.len();
        let path = match body {
            // what an earlier run has kept begins at rest
            SolidBody::Spatula(spatula) if taken.is_empty() => match settled(spatula, problem, options) {
                Ok(start) => Path::from(problem, how, start),
                Err(end) => return (Self::ended(end), Vec::new()),
            },
            SolidBody::Spatula(_) | SolidBody::Strip(_) => {
                if let (false, Some(first)) = (body.substrate().is_flat(), taken.first()) {
                    problem.start_at(Arc::new(first.point.at.clone()));
                }
                Path::new(problem, how)
            }
        };
        let path = path.until(options.stop.for_solves(Stage::Path)).knowing(taken);
        let mut tracer = PathTracer::new(problem, path, TraceOptions::default());
        let (mut found, mut left_out, mut points) = (Vec::new(), Vec::new(), Vec::<SolidPoint>::new());
        let mut at_rest = None;
        let end = loop {
            if let Some(bound) = options.stop.reached_bound(Stage::Path) {
                break SolidPathEnd::Bound(bound);
            }
            let turned = found.iter().any(|(kind, _, _)| *kind == LimitPointKind::Displacement);
            let event = tracer.advance();
            for waypoint in tracer.new_waypoints() {
                match known.checked_sub(1) {
                    Some(left) => known = left,
                    None => (checkpoint.keep)(&how, waypoint),
                }
            }
            let solution = match event {
                Ok(PathEvent::Point(solution)) => solution,
                Ok(PathEvent::LimitPoint { kind, after, located }) => {
                    found.push((kind, after, located));
                    continue;
                }
                Ok(PathEvent::InertiaChange { kind, after, from, to, .. }) => {
                    left_out.push(SolidLeftOut::Inertia { kind, after, from, to });
                    continue;
                }
                Ok(PathEvent::BranchPoint { .. }) => continue,
                // the path goes on, and its point behind is known
                Err(TraceError::NotLocated { kind, after, cause, .. }) if cause != SolveError::Stopped => {
                    left_out.push(SolidLeftOut::NotLocated { kind, after, cause });
                    match tracer.path().points().get(after + 1) {
                        Some(solution) => solution.clone(),
                        None => continue,
                    }
                }
                Err(error) => match options.stop.reached_bound(Stage::Path) {
                    Some(bound) => break SolidPathEnd::Bound(bound),
                    None => break SolidPathEnd::Failed(error),
                },
            };
            let point = SolidPoint::new(body, &solution, *at_rest.get_or_insert(solution.energy));
            let (displacement, force) = (point.displacement, point.force);
            points.push(point);
            if points.len() == 1 {
                continue;
            }
            if body.is_detached(&solution.at.values) {
                break SolidPathEnd::Detached;
            }
            if displacement <= 0.0 {
                break SolidPathEnd::TurnedBack;
            }
            if turned && force <= 0.0 {
                break SolidPathEnd::Pivoting;
            }
            if points.len() >= options.stop.points {
                break SolidPathEnd::Bound(Bound::Points(options.stop.points));
            }
            if let Some(most) = options.stop.displacement.filter(|&most| displacement > most) {
                break SolidPathEnd::Bound(Bound::Displacement(most));
            }
            if turned && options.stop.until == FollowedUntil::FirstJump {
                break SolidPathEnd::Bound(Bound::Until(FollowedUntil::FirstJump));
            }
            let known = &tracer.path().points()[..points.len()];
            if let Some(event) = stopping(body, problem, known, &options.stop) {
                break SolidPathEnd::Bound(Bound::Event { name: event.name.clone() });
            }
        };
        let mut solutions = tracer.path().points().to_vec();
        if let SolidPathEnd::Bound(Bound::Event { name }) = &end {
            let event = options.stop.ending().find(|event| event.name == *name);
            let first = event.and_then(|event| first_on_last_step(body, problem, &solutions[..points.len()], event));
            // where it cannot be located the point beyond it stays: it is an equilibrium too
            if let (Some(at), Some(rest), Some(last)) = (first, at_rest, points.last_mut()) {
                let label = |observables: &Observables| at.segment.label(observables);
                found.retain(|(_, after, located): &(_, usize, Located)| {
                    *after < at.after || label(&located.observables) <= label(&at.solution.observables)
                });
                *last = SolidPoint::new(body, &at.solution, rest);
                solutions.truncate(at.after + 1);
                solutions.push(at.solution);
            }
        }
        (Self { solutions, found, left_out, iterations: tracer.iterations(), end }, points)
    }
}

/// Most that a step of a relaxation moves, over the gap.
const SETTLING: f64 = 0.3;

/// A spatula at rest: it is bonded along its pad without stress, or pressed on uneven ground, which is no equilibrium.
fn settled(spatula: &SolidSpatula, problem: &mut Problem, options: &SolidOptions) -> Result<State, SolidPathEnd> {
    let mut ws = Workspace::until(options.stop.for_solves(Stage::Path));
    let guess = spatula.mesh.pressed.map_or_else(|| spatula.at_rest(), |pad| spatula.conformed(pad));
    let relaxed = |problem: &Problem, held: Held| {
        let relaxed = relax(problem, guess, held, &RelaxOptions::by(SETTLING), &mut ws);
        relaxed.map(|relaxed| relaxed.solution.at).map_err(|cause| match options.stop.reached_bound(Stage::Path) {
            Some(bound) => SolidPathEnd::Bound(bound),
            None => SolidPathEnd::NotAtRest(cause),
        })
    };
    if spatula.substrate().is_flat() {
        return relaxed(problem, Held::Displacement(0.0));
    }
    // it lies where nothing holds its end, and displacements count from there
    let grip = EndConditions { held: [false; INTERFACE], ..problem.grip };
    let at = relaxed(&Problem { grip, ..problem.clone() }, Held::Force(0.0))?;
    problem.start_at(Arc::new(at.clone()));
    Ok(at)
}

/// The first step, over the gap at rest.
const FIRST: f64 = 0.03;

impl SolidPoint {
    fn new(body: &SolidBody, solution: &Arc<Solution>, at_rest: f64) -> Self {
        let counts = body.has_potential();
        let o = solution.observables;
        Self {
            displacement: o.displacement,
            force: o.force,
            end_rotation: o.recorded,
            front: body.adhering_length() - body.front(&solution.at.values, o.monitors[0]),
            work: counts.then_some(solution.energy - at_rest),
            negative: counts.then_some(solution.negative),
            negative_load: counts.then_some(solution.negative_load),
            solution: solution.clone(),
        }
    }
}

/// The value of a station or an event on a path with these points.
fn sought<'p>(body: &'p SolidBody, problem: &'p Problem, points: &'p [Arc<Solution>], at: &EventAt) -> SoughtValue<'p> {
    let number = match at.quantity.named() {
        Some(StationQuantity::Displacement) => PathNumber::observable(problem, |o| o.displacement),
        Some(StationQuantity::Force) => PathNumber::observable(problem, |o| o.force),
        // how fast it changes is not among what a point of the path knows
        Some(StationQuantity::EndRotation) => PathNumber::of_state(problem, |at| body.end_rotation(&at.values)),
        Some(StationQuantity::Front) => match body {
            SolidBody::Strip(_) => PathNumber::following(problem, |o| o.monitors[0], |off| body.length() - off, 1.0),
            SolidBody::Spatula(spatula) => PathNumber::of_state(problem, |at| spatula.front(&at.values)),
        },
        Some(StationQuantity::FreeEndGap) => PathNumber::of_state(problem, |at| body.free_end_gap(&at.values)),
        Some(StationQuantity::Time | StationQuantity::Attached) | None => PathNumber::of_state(problem, |_| f64::NAN),
    };
    SoughtValue::new(number, at.value, at.passing, points)
}

/// The event that ends a path, on its newest step: the first that it passes.
fn stopping<'e>(
    body: &SolidBody,
    problem: &Problem,
    points: &[Arc<Solution>],
    stop: &'e StopCriteria,
) -> Option<&'e EventAt> {
    let after = points.len().checked_sub(2)?;
    stop.first_passed(after, |event| sought(body, problem, points, event))
}

/// Where an event first lies on the newest step of a path.
fn first_on_last_step(
    body: &SolidBody,
    problem: &Problem,
    points: &[Arc<Solution>],
    event: &EventAt,
) -> Option<FoundValue> {
    let after = points.len().checked_sub(2)?;
    let found = sought(body, problem, points, event).on_step(after, &mut Workspace::default());
    found.ok()?.into_iter().next()
}

/// Where the stations and events lie on a path, in its order, each with its number; and which of them were not located.
fn passed(
    body: &SolidBody,
    problem: &Problem,
    points: &[Arc<Solution>],
    stop: &StopCriteria,
) -> (Vec<(usize, FoundValue)>, Vec<SolidLeftOut>) {
    let (mut passed, mut missed, mut ws) = (Vec::new(), Vec::new(), Workspace::default());
    for (event, at) in stop.events.iter().enumerate() {
        let value = sought(body, problem, points, at);
        for after in 0..points.len().saturating_sub(1) {
            match value.on_step(after, &mut ws) {
                Ok(found) => passed.extend(found.into_iter().map(|found| (event, found))),
                Err(cause) => missed.push(SolidLeftOut::NotPassed { event, after, cause }),
            }
        }
    }
    let place = |found: &FoundValue| found.segment.label(&found.solution.observables) / found.segment.end();
    passed.sort_by(|(_, a), (_, b)| a.after.cmp(&b.after).then(place(a).total_cmp(&place(b))));
    (passed, missed)
}
