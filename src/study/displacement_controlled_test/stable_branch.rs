//! One stable piece of a test: from an equilibrium on until it is lost or the machine has arrived.

use crate::beam::planar::model_end::CollapsedSection;
use crate::beam::planar::model_limits::BondedLoss;
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::{Beam, BeamProblem};
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::path::equilibrium_path::Path;
use crate::solve::path::options::PathOptions;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::{Located, locate};
use crate::solve::points::search::LimitPointKind;
use crate::solve::points::tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
use crate::solve::problem::Problem;
use crate::solve::relax::RelaxError;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::asked::stop_criteria::{Bound, Stage, StopCriteria};
use crate::study::initial::error::NoEquilibrium;
use crate::study::peel::contact::Adhering;
use crate::study::peel::equilibrium_path::path_end::is_clear;
use crate::study::peel::step_dependence::StepCurve;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// Where a piece ends.
pub(super) enum BranchEnd {
    /// The machine has arrived.
    Arrived,
    /// A limit point of U: stability is lost.
    Limit(Box<Located>),
    /// Stability is lost where U does not turn.
    Branching(Box<Located>),
    /// A stop criterion is met.
    Bound(Bound),
    /// It could not be followed further.
    Lost(BranchError),
}

/// A stable piece.
pub(super) struct StableBranch {
    /// Its equilibria; the last is the limit point, or the one next to it.
    pub points: Vec<Arc<Solution>>,
    /// (U, P) between them.
    pub curve: Vec<(f64, f64)>,
    /// ∫ P dU from its start to each point, aJ
    pub works: Vec<f64>,
    pub end: BranchEnd,
    pub iterations: usize,
}

/// What a piece is followed under.
pub(super) struct Machine<'a> {
    pub model: &'a PeelModel,
    pub problem: &'a BeamProblem,
    pub options: PathOptions,
    pub stop: &'a StopCriteria,
    /// Accuracy asked for.
    pub relative: f64,
    /// A strip with no point nearer than this is detached, nm.
    pub far: f64,
    /// What is nearer than this adheres, nm.
    pub adhering_distance: f64,
}

/// When the machine has arrived.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Until {
    /// The strip is detached.
    Detached,
    /// U has come down to this, nm.
    Displacement(f64),
}

/// Further points beyond a limit point, for a better interpolation of it.
const BEHIND: usize = 2;
/// Places at which the curve is given inside a step.
const INSIDE: usize = 8;

impl Machine<'_> {
    /// Where a branch begins on which the strip has come to rest. In space on a mesh whose focus is its front: steps are so short there that
    /// the way from another mesh would be longer.
    pub(crate) fn begin_at(&self, landed: &Solution) -> State {
        match self.problem.beam {
            Beam::Planar(_) => landed.at.clone(),
            Beam::Spatial(_) => self.problem.system.refocused(&landed.at, landed.observables.monitors),
        }
    }

    /// Follows the stable equilibria from `start` on; U rises or falls as `rising` says. `points` have been computed before. Where it
    /// cannot be followed further what was found of it is kept; there is none where not even its first point was found.
    pub(crate) fn follow(
        &self,
        start: State,
        rising: bool,
        until: Until,
        points: usize,
    ) -> Result<StableBranch, BranchError> {
        let first = self.options.first_displacement.copysign(if rising { 1.0 } else { -1.0 });
        let options = PathOptions { first_displacement: first, elements: start.mesh.elements(), ..self.options };
        let path = Path::from(self.problem, options, start);
        let trace = TraceOptions {
            kinds: &[LimitPointKind::Displacement],
            branches: true,
            relative: self.relative,
            behind: BEHIND,
        };
        let (mut tracer, mut ws) = (PathTracer::new(self.problem, path, trace), Workspace::default());
        let mut looked = 0;
        loop {
            let path = tracer.path();
            if let Some(bound) = self.bound(path, rising, points) {
                return Ok(self.leg(path.points(), BranchEnd::Bound(bound), path.iterations()));
            }
            let event = tracer.advance();
            let path = tracer.path();
            let event = match event {
                Ok(event) => event,
                Err(why) if looked == 0 => return Err(why.into()),
                Err(why) => {
                    return Ok(self.leg(&path.points()[..looked], BranchEnd::Lost(why.into()), path.iterations()));
                }
            };
            let lost = |after: usize, located: Located, end: fn(Box<Located>) -> BranchEnd| {
                self.leg_to(path, after, located.solution.clone(), end(Box::new(located)))
            };
            match event {
                PathEvent::LimitPoint { after, located, .. } => return Ok(lost(after, located, BranchEnd::Limit)),
                PathEvent::BranchPoint { after, located } => return Ok(lost(after, located, BranchEnd::Branching)),
                PathEvent::InertiaChange { .. } => {}
                PathEvent::Point(_) => {
                    looked += 1;
                    let Some(before) = path.points().len().checked_sub(2) else { continue };
                    match self.arrived(path, before, until, &mut ws) {
                        Ok(None) => {}
                        Ok(Some(last)) => return Ok(self.leg_to(path, before, last, BranchEnd::Arrived)),
                        Err(why) => {
                            return Ok(self.leg(&path.points()[..=before], BranchEnd::Lost(why), path.iterations()));
                        }
                    }
                }
            }
        }
    }

    /// Whether Newton's method stays where a relaxation has ended. Next to where an equilibrium has vanished it goes to and fro, by little.
    pub(crate) fn is_equilibrium(&self, rest: &Solution) -> bool {
        let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: rest.observables.displacement };
        let options = NewtonOptions { tolerance: self.options.tolerance, ..NewtonOptions::default() };
        solve(self.problem, rest.at.clone(), &constraint, &options, &mut Workspace::default()).is_ok()
    }

    /// What adheres at an equilibrium.
    pub(crate) fn adhering(&self, solution: &Solution) -> Adhering {
        Adhering::of(&self.problem.beam, &solution.at, self.adhering_distance)
    }

    /// The criterion that is met; a piece has one point at least.
    fn bound(&self, path: &Path, rising: bool, points: usize) -> Option<Bound> {
        let u = path.points().last()?.observables.displacement;
        let most = self.stop.points;
        if points + path.points().len() >= most {
            return Some(Bound::Points(most));
        }
        let beyond = || self.stop.displacement.filter(|&most| rising && u > most).map(Bound::Displacement);
        self.stop.reached_bound(Stage::Path).or_else(beyond)
    }

    /// The criterion that has ended a relaxation, if one has.
    pub(crate) fn stopped_by(&self, why: &TestError) -> Option<Bound> {
        match why {
            TestError::Relax { cause: RelaxError::Stopped { .. }, .. } => self.stop.reached_bound(Stage::Path),
            _ => None,
        }
    }

    /// The largest force of a piece, if it is a maximum within.
    pub(crate) fn peak(&self, leg: &StableBranch) -> Result<Option<Located>, BranchError> {
        let (points, mut ws) = (&leg.points, Workspace::default());
        let force = |p: &Solution| p.observables.force;
        let largest = (0..points.len()).max_by(|&a, &b| force(&points[a]).total_cmp(&force(&points[b])));
        let Some(largest) = largest else { return Ok(None) };
        for index in [largest.saturating_sub(1), largest] {
            let Some(next) = points.get(index + 1) else { continue };
            if points[index].slope.force <= 0.0 || next.slope.force > 0.0 {
                continue;
            }
            let segment = PathSegment::around(self.problem, points, index);
            let bracket = (0.0, segment.end());
            let located = locate(self.problem, &segment, LimitPointKind::Load, bracket, Some(self.relative), &mut ws);
            let machine_nm = points[index].observables.displacement;
            return located.map(Some).map_err(|cause| BranchError::NoPeak { machine_nm, cause });
        }
        Ok(None)
    }

    /// The last point, if the newest is there or beyond it.
    fn arrived(
        &self,
        path: &Path,
        before: usize,
        until: Until,
        ws: &mut Workspace,
    ) -> Result<Option<Arc<Solution>>, BranchError> {
        let newest = &path.points()[before + 1];
        match until {
            Until::Detached if is_clear(self.problem, path, self.far) => Ok(Some(newest.clone())),
            Until::Displacement(target) if newest.observables.displacement <= target => {
                let segment = PathSegment::around(self.problem, path.points(), before);
                let from = path.points()[before].observables.displacement;
                let share = (from - target) / (from - newest.observables.displacement);
                let start = segment.start(self.problem, share * segment.end(), 4);
                let weights = Observables { displacement: -1.0, ..Observables::default() };
                let options =
                    NewtonOptions { tolerance: 1e-10, largest_update: 0.5, most_iterations: 10, exact_slope: true };
                let constraint = PathConstraint { weights, target: -target };
                solve(self.problem, start, &constraint, &options, ws)
                    .map(|last| Some(Arc::new(last)))
                    .map_err(|cause| BranchError::NotArrived { machine_nm: target, cause })
            }
            _ => Ok(None),
        }
    }

    /// The piece up to `last`, which lies on the step behind the point `before`.
    fn leg_to(&self, path: &Path, before: usize, last: Arc<Solution>, end: BranchEnd) -> StableBranch {
        let mut segment = PathSegment::around(self.problem, path.points(), before);
        let label = segment.insert(last.clone());
        let mut leg = self.leg(&path.points()[..=before], end, path.iterations());
        leg.add(&StepCurve::pieces(self.worked(), &segment, label, &last, &mut Workspace::default()));
        leg.points.push(last);
        leg
    }

    /// The part of a piece up to an equilibrium on the step behind a point.
    pub(crate) fn cut(&self, leg: &StableBranch, after: usize, last: Arc<Solution>, end: BranchEnd) -> StableBranch {
        let mut segment = PathSegment::around(self.problem, &leg.points, after);
        let label = segment.insert(last.clone());
        let mut cut = self.leg(&leg.points[..=after], end, leg.iterations);
        cut.add(&StepCurve::pieces(self.worked(), &segment, label, &last, &mut Workspace::default()));
        cut.points.push(last);
        cut
    }

    /// The problem, and a scale of its works, aJ.
    fn worked(&self) -> (&Problem, f64) {
        (self.problem, self.problem.measure.force * self.problem.beam.length())
    }

    fn leg(&self, points: &[Arc<Solution>], end: BranchEnd, iterations: usize) -> StableBranch {
        let first = points.first().map(|p| (p.observables.displacement, p.observables.force));
        let curve = first.into_iter().collect();
        let mut leg = StableBranch { points: points.to_vec(), curve, works: vec![0.0], end, iterations };
        let mut ws = Workspace::default();
        for index in 0..points.len().saturating_sub(1) {
            let segment = PathSegment::around(self.problem, points, index);
            leg.add(&StepCurve::pieces(self.worked(), &segment, segment.end(), &points[index + 1], &mut ws));
        }
        leg
    }
}

impl StableBranch {
    /// Takes in the step behind its last point, in pieces.
    fn add(&mut self, pieces: &[StepCurve]) {
        let work: f64 = pieces.iter().map(StepCurve::work).sum();
        self.works.push(self.works[self.works.len() - 1] + work);
        for piece in pieces {
            for k in 1..=INSIDE {
                let (u, _, force, _) = piece.at(2.0 * k as f64 / INSIDE as f64 - 1.0);
                self.curve.push((u, force));
            }
        }
    }
}

// -- The two ways of a test, and what work and energy balance on them --

/// Which way the machine moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum LoadingDirection {
    /// Away from the substrate.
    Retreat,
    /// Towards it.
    Approach,
}

impl LoadingDirection {
    /// In words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Retreat => "retreat",
            Self::Approach => "approach",
        }
    }
}

/// Work of the machine against change of energy and energy released, aJ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// ∫ P dU over the stable pieces
    pub work: f64,
    /// Energy at the end minus energy at the start
    pub energy_change: f64,
    /// Sum over the jumps
    pub released: f64,
    /// The largest of these and of the works of the two ways, without its sign
    pub largest: f64,
}

impl Balance {
    /// What is not accounted for, over the largest term.
    pub fn error(&self) -> f64 {
        (self.work - self.energy_change - self.released).abs() / self.largest.max(f64::MIN_POSITIVE)
    }
}

// -- Why a test stopped short, with what was computed, where and how far --

/// Most jumps on one way.
pub(super) const MOST_JUMPS: usize = 50;

/// Why a test stopped short, on the best mesh that was tried, and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[error(
    "{cause}; on {elements} elements of order {order}. The results so far are kept. Try another accuracy.relative than {asked:e}"
)]
#[allow(missing_docs)] // the message of each names its numbers
pub struct TestFailure {
    pub cause: TestError,
    pub elements: usize,
    pub order: usize,
    /// Relative accuracy asked for.
    pub asked: f64,
}

/// Why a test on one mesh stopped.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TestError {
    /// No mesh was tried.
    #[error("nothing was computed")]
    NothingComputed,
    /// There is no equilibrium to start from.
    #[error(
        "the path cannot be continued from u = 0.000000 nm, P = 0.000000 nN (point 0): after 1 shorter and shorter steps: {0}"
    )]
    NoStart(NoEquilibrium),
    /// A stable branch was not followed to its end.
    #[error("{0}")]
    Branch(#[from] BranchError),
    /// The structure does not come to rest.
    #[error("the state after the jump at U = {machine_nm:.6} nm was not found: {cause}")]
    Relax { machine_nm: f64, cause: RelaxError },
    /// A jump takes energy, aJ.
    #[error("the jump at U = {machine_nm:.6} nm releases {released:.3e} aJ: that is no jump")]
    NoRelease { machine_nm: f64, released: f64 },
    /// One jump comes after another.
    #[error("there were {MOST_JUMPS} jumps on the {}, more than are computed", .way.word())]
    TooManyJumps { way: LoadingDirection },
    /// The work is not the energy.
    #[error(
        "work and energy do not balance: ∫ P dU = {:.9e} aJ, change of energy {:.9e} aJ, released {:.9e} aJ; the difference is \
         {:.1e} of the largest term", .0.work, .0.energy_change, .0.released, .0.error()
    )]
    Unbalanced(Balance),
}

/// Why a stable branch could not be followed.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum BranchError {
    /// Its path, or where that loses its stability.
    #[error("{0}")]
    Trace(#[from] TraceError),
    /// Its largest force.
    #[error("the largest force on the stable branch near U = {machine_nm:.6} nm was not located: {cause}")]
    NoPeak { machine_nm: f64, cause: SolveError },
    /// A station or an event of the user.
    #[error("the event \"{name}\" near U = {machine_nm:.6} nm was not located: {cause}")]
    NoEvent { name: String, machine_nm: f64, cause: SolveError },
    /// Its last point.
    #[error("the last point, at U = {machine_nm:.6} nm, was not found: {cause}")]
    NotArrived { machine_nm: f64, cause: SolveError },
}

// -- Where a test leaves its model: what is bonded has lost its stability, or its end has collapsed onto the substrate --

/// What of the model has come to its end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum ModelLimit {
    /// What is bonded is unstable.
    Bonded(BondedLoss),
    /// The beam has collapsed onto the substrate.
    Collapsed(CollapsedSection),
}

/// Where a test has come to the end of its model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftModel {
    /// Which way the machine moves
    pub way: LoadingDirection,
    /// U, nm
    pub machine: f64,
    /// P of the last equilibrium within the model, nN
    pub force: f64,
    /// What has come to its end
    pub limit: ModelLimit,
}

impl fmt::Display for LeftModel {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { way, machine, force, limit } = self;
        write!(f, "on the {} at U = {machine:.6} nm, P = {force:.6} nN ", way.word())?;
        match limit {
            ModelLimit::Bonded(loss) => loss.fmt(f),
            ModelLimit::Collapsed(section) => section.fmt(f),
        }
    }
}

impl Machine<'_> {
    /// The limit of the model at which an equilibrium is, where the test cannot go on from it.
    pub(crate) fn model_limit(&self, at: &Solution) -> Option<ModelLimit> {
        self.collapsed(at).or_else(|| self.bonded(at))
    }

    /// Whether a beam has collapsed in an equilibrium.
    pub(crate) fn collapsed(&self, at: &Solution) -> Option<ModelLimit> {
        self.problem.beam.planar()?.collapsed_section(&at.at).map(ModelLimit::Collapsed)
    }

    /// Whether what is bonded is unstable at an equilibrium, or nearly so.
    pub(crate) fn bonded(&self, at: &Solution) -> Option<ModelLimit> {
        let beam = self.problem.beam.planar()?;
        if self.adhering(at) != Adhering::Pad {
            return None;
        }
        beam.limits.near_bonded_loss(beam.grip_forces(&at.at).horizontal).map(ModelLimit::Bonded)
    }
}
