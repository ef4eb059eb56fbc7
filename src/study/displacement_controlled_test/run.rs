//! The run behind [`super::observed`]: retreat, jump, approach, jump, on a mesh from the accuracy asked for, and on a finer one
//! where the errors of the jumps say so.

use super::jump;
use super::looked_over::Passed;
use super::result::{Elsewhere, Jump, Observed, PullOff, TestEffort, TestEnd, TestPoint, TestStation};
use super::stable_branch::{
    Balance, BranchEnd, LeftModel, LoadingDirection, MOST_JUMPS, Machine, ModelLimit, StableBranch, TestError,
    TestFailure, Until,
};
use crate::beam::mesh::MeshKind;
use crate::beam::planar::planar_beam::FRONT;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::{Discretisation, FineEnds};
use crate::solve::newton::Solution;
use crate::solve::path::options::PathOptions;
use crate::solve::path::segment::PathSegment;
use crate::solve::points::locate::Located;
use crate::solve::problem::{EndConditions, MeasuredBeside};
use crate::solve::relax::{Held, RelaxOptions, disturbed, disturbed_anyhow, relax};
use crate::solve::state::State;
use crate::solve::workspace::{Pace, Workspace};
use crate::study::asked::accuracy::{Accuracy, Choice, MOST_FAILED_IN_SPACE, Resolution, most_elements, refined};
use crate::study::asked::error_bounds::{DIFFERENCE_BOUND_FACTOR, ROUND_OFF, least};
use crate::study::asked::events::EventAction;
use crate::study::asked::measured::number;
use crate::study::asked::stop_criteria::{Bound, Stage, StopCriteria};
use crate::study::initial::error::NoEquilibrium;
use crate::study::initial::prepared::prepared;
use crate::study::peel::contact::Adhering;
use crate::study::peel::step_dependence::StepCurve;
use std::sync::Arc;

/// Most that a step of relaxation moves, relative to the gap.
const RELAXING: f64 = 0.1;
/// A mesh whose errors are at most this many times those of the best one shows its round-off.
const COMPARABLE: f64 = 10.0;
/// A strip whose force and front have changed by less than this, over the work of adhesion times the width and over its length, has not jumped.
const STAYS: f64 = 1e-3;
/// How far the machine goes beyond a limit point at which the strip stays, relative to U: farther where it is still on its slow way past it.
const BEYOND: [f64; 3] = [1e-7, 1e-6, 1e-5];
/// The balance of work and energy closes to this, or to the accuracy asked for where that is more.
const BALANCED: f64 = 1e-6;

/// Most that fail in the plane, of two on each mesh.
const MOST_FAILED: usize = 6;
/// Those of them on the usual mesh, and on meshes that move; and the least elements of the fixed one behind them.
const FAILED_AS_USUAL: usize = 2;
const FAILED_ON_MOVING: usize = 4;
const ON_FIXED: usize = 100;
/// Further meshes on which a test in space may fail, with its paths followed warily and measured by the roll of the grip as well.
const MOST_FAILED_WARILY: usize = 3;

/// What the machine does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Course {
    /// It pulls the beam off, and returns.
    ThereAndBack,
    /// It pulls until the beam is off, or stands on the face of its end.
    There,
}

pub(super) fn run(model: &PeelModel, course: Course, accuracy: &Accuracy, stop: &StopCriteria) -> Observed {
    let accuracy = &accuracy.fitted(model);
    let mut others = Vec::new();
    let (mut iterations, mut steps, mut failures) = (0, 0, 0);
    let first = Resolution::first(model, accuracy);
    let best = refined(first, most_elements(model), Test::is_better_than, |resolution, _| {
        let mut test = Test::new(course);
        test.effort.elements = resolution.elements;
        test.effort.order = resolution.order;
        let how = How::after(model, accuracy, resolution.order, failures);
        match problem(model, &how) {
            Ok(problem) => {
                let machine = Machine {
                    model,
                    problem: &problem,
                    options: PathOptions { pace: how.pace, ..resolution.path_options(model, accuracy.relative) },
                    stop,
                    relative: accuracy.relative,
                    far: model.line_law().cutoff_distance(),
                    adhering_distance: model.line_law().adhering_distance(),
                };
                test.run(&machine, resolution.elements);
            }
            Err(why) => test.end = Err(TestError::NoStart(why)),
        }
        iterations += test.effort.newton_iterations;
        steps += test.effort.relaxation_steps;
        let (failed, worst) = (test.end.is_err(), test.worst() / accuracy.relative);
        if failed {
            failures += 1;
        } else {
            others.push((test.worst(), test.jumps.clone()));
        }
        let most_failed = if model.space.is_some() { MOST_FAILED_IN_SPACE + MOST_FAILED_WARILY } else { MOST_FAILED };
        let hopeless = failures == most_failed;
        let late = stop.reached_bound(Stage::Path).is_some();
        // what comes through on the last mesh of all is taken as it is
        let last = model.space.is_none() && failures >= FAILED_ON_MOVING;
        let enough = !failed && (worst <= 1.0 || last);
        let enough = enough || late || hopeless || accuracy.choice.elements.is_some();
        let finer = match failed {
            true if failures == MOST_FAILED_IN_SPACE && model.space.is_some() => first,
            true if model.space.is_none() && how.pace == Pace::Quick => resolution,
            true if last => Resolution { elements: resolution.elements.max(ON_FIXED), ..resolution },
            true => resolution.times(1.5),
            false => resolution.finer(worst, 0.0),
        };
        (test, (!enough).then_some(finer))
    });
    let mut test = best.unwrap_or_else(|| Test::new(course));
    if test.worst() > accuracy.relative {
        test.widen(&others);
    }
    test.effort = TestEffort { newton_iterations: iterations, relaxation_steps: steps, ..test.effort };
    test.into_result(accuracy.relative)
}

/// How a test is followed.
struct How {
    pace: Pace,
    discretisation: Discretisation,
}

impl How {
    /// Behind so many that failed. In the plane every mesh is watched before another one is tried. On the second and third the grip has small elements
    /// too: on the way back it may be pressed on the ground and adhere, as may a blister's end far from both, for which the third one
    /// stays where it is. In space the first four are quick. Without x the horizontal section force of a strip, where it has one, is a multiplier, and
    /// the energy no minimum: such a strip is relaxed with all three unknowns.
    fn after(model: &PeelModel, accuracy: &Accuracy, order: usize, failures: usize) -> Self {
        let Choice { form, mesh, .. } = accuracy.choice;
        let form = if model.has_horizontal_force() { Form::ThreeField } else { form };
        let usual = Discretisation::moving(form, order).on(mesh);
        let pace = match model.space {
            Some(_) if failures >= MOST_FAILED_IN_SPACE => Pace::Wary,
            None if failures % 2 == 1 => Pace::Watchful,
            _ => Pace::Quick,
        };
        let discretisation = match (model.space, failures) {
            (Some(_), _) | (None, 0..FAILED_AS_USUAL) => usual,
            (None, FAILED_AS_USUAL..FAILED_ON_MOVING) => Discretisation { fine: FineEnds::Both, ..usual },
            (None, _) => Discretisation { fine: FineEnds::Both, ..usual.on(MeshKind::Graded) },
        };
        Self { pace, discretisation }
    }
}

/// The strip behind its spring.
fn problem(model: &PeelModel, how: &How) -> Result<BeamProblem, NoEquilibrium> {
    let compliance = model.grip.stiffness.map_or(0.0, f64::recip);
    let problem = prepared(model, how.discretisation, None).map_err(|failed| failed.why)?.problem;
    let measured = match how.pace {
        Pace::Quick => problem,
        Pace::Wary | Pace::Watchful => problem.measured_beside(MeasuredBeside::Roll),
    };
    Ok(measured.with_grip(EndConditions { compliance, ..measured.grip }))
}

/// How stability is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Loss {
    /// The machine's displacement turns.
    LimitPoint,
    /// It does not, and the path branches.
    Branching,
}

/// Where a jump leads.
enum Landing {
    /// To a stable equilibrium
    Rest(Arc<Solution>),
    /// Beyond what the model is for
    Beyond(ModelLimit),
}

/// The end of a test at the limit of its model.
fn left_model(last: &Solution, way: LoadingDirection, limit: ModelLimit) -> TestEnd {
    let o = &last.observables;
    TestEnd::LeftModel(LeftModel { way, machine: o.displacement, force: o.force, limit })
}

/// Whether the strip is still where it lost its stability: that was round-off's, or it has stayed on its branch.
fn stays(machine: &Machine, limit: &Located, at: &Solution) -> bool {
    let (problem, change) = (machine.problem, at.observables.since(&limit.observables));
    let (force, front) = (problem.measure.force, problem.beam.length());
    change.force.abs() <= STAYS * force && change.monitors[FRONT].abs() <= STAYS * front
}

/// A test under way.
struct Test {
    course: Course,
    points: Vec<TestPoint>,
    jumps: Vec<Jump>,
    stations: Vec<TestStation>,
    pieces: Vec<(LoadingDirection, Vec<(f64, f64)>)>,
    pull_off: Option<PullOff>,
    /// As of [`Observed`], and whether the beam has stood on its end.
    before_upright: Option<PullOff>,
    stood: bool,
    retreat: Option<Balance>,
    cycle: Option<Balance>,
    end: Result<TestEnd, TestError>,
    effort: TestEffort,
    /// ∫ P dU so far, and what its parts amount to without their signs
    work: f64,
    largest: f64,
    /// Energy at the start
    start: f64,
    /// Whether the next point is where the strip has jumped to.
    jumped: bool,
}

impl Test {
    fn new(course: Course) -> Self {
        Self {
            course,
            points: Vec::new(),
            jumps: Vec::new(),
            stations: Vec::new(),
            pieces: Vec::new(),
            pull_off: None,
            before_upright: None,
            stood: false,
            retreat: None,
            cycle: None,
            end: Err(TestError::NothingComputed),
            effort: TestEffort::default(),
            work: 0.0,
            largest: 0.0,
            start: 0.0,
            jumped: false,
        }
    }

    fn run(&mut self, machine: &Machine, elements: usize) {
        self.end = self.cycle(machine, elements);
        self.effort.points = self.points.len();
    }

    fn cycle(&mut self, machine: &Machine, elements: usize) -> Result<TestEnd, TestError> {
        let rest = machine.problem.initial(elements);
        let (far, end) = self.way(machine, rest, LoadingDirection::Retreat)?;
        if let Some(end) = end {
            return Ok(end);
        }
        self.retreat = Some(self.balance(machine, &far)?);
        if self.course == Course::There {
            return Ok(TestEnd::Off);
        }
        let (back, end) = self.way(machine, machine.begin_at(&far), LoadingDirection::Approach)?;
        if let Some(end) = end {
            return Ok(end);
        }
        let cycle = self.balance(machine, &back)?;
        self.cycle = Some(cycle);
        let elsewhere = Elsewhere { energy_change: cycle.energy_change, force: back.observables.force };
        let closed = cycle.energy_change.abs() <= BALANCED.max(machine.relative) * cycle.largest;
        Ok(if closed { TestEnd::Closed } else { TestEnd::Returned(elsewhere) })
    }

    /// One way to its end: the last equilibrium, and why the test ends there, if it does.
    fn way(
        &mut self,
        machine: &Machine,
        start: State,
        way: LoadingDirection,
    ) -> Result<(Arc<Solution>, Option<TestEnd>), TestError> {
        let until = match way {
            LoadingDirection::Retreat => Until::Detached,
            LoadingDirection::Approach => Until::Displacement(0.0),
        };
        let mut at = start;
        for _ in 0..=MOST_JUMPS {
            let leg = machine.follow(at, way == LoadingDirection::Retreat, until, self.points.len())?;
            let (leg, found) = machine.looked_over(leg, way)?;
            let last = leg.points[leg.points.len() - 1].clone();
            self.take_stations(machine, found, &leg, way);
            self.take(machine, &leg, way);
            if way == LoadingDirection::Retreat {
                self.take_peak(machine, &leg)?;
            }
            let (located, loss) = match leg.end {
                _ if self.is_over() => return Ok((last, None)),
                BranchEnd::Arrived => return Ok((last, None)),
                BranchEnd::Bound(bound) => return Ok((last, Some(TestEnd::Bound(bound)))),
                BranchEnd::Lost(why) => {
                    let limit = machine.model_limit(&last).ok_or(why)?;
                    return Ok((last.clone(), Some(left_model(&last, way, limit))));
                }
                BranchEnd::Limit(located) => (located, Loss::LimitPoint),
                BranchEnd::Branching(located) => (located, Loss::Branching),
            };
            if let (Loss::Branching, Some(limit)) = (loss, machine.bonded(&located.solution)) {
                return Ok((last.clone(), Some(left_model(&last, way, limit))));
            }
            let landed = match self.lost(machine, &located, loss, way) {
                Ok(Landing::Rest(landed)) => landed,
                Ok(Landing::Beyond(limit)) => return Ok((last.clone(), Some(left_model(&last, way, limit)))),
                Err(why) => {
                    let limit = || machine.model_limit(&last).map(|limit| left_model(&last, way, limit));
                    let end = machine.stopped_by(&why).map(TestEnd::Bound).or_else(limit);
                    return end.map(|end| (last, Some(end))).ok_or(why);
                }
            };
            if way == LoadingDirection::Retreat {
                self.notice_stand(machine, &landed, self.pull_off);
            }
            if let Some(stopped) = self.look_at_jump(machine, &located.solution, &landed, way) {
                self.point(machine, &landed, way, self.work);
                return Ok((landed, Some(TestEnd::Bound(stopped))));
            }
            let off = || way == LoadingDirection::Retreat && machine.problem.beam.is_clear(&landed.at, machine.far);
            if self.is_over() || off() {
                self.point(machine, &landed, way, self.work);
                return Ok((landed, None));
            }
            at = machine.begin_at(&landed);
        }
        Err(TestError::TooManyJumps { way })
    }

    /// Whether the machine is not to go on because the beam stands on its end.
    fn is_over(&self) -> bool {
        self.course == Course::There && self.stood
    }

    /// The points of a stable piece.
    fn take(&mut self, machine: &Machine, leg: &StableBranch, way: LoadingDirection) {
        let problem = machine.problem;
        if self.points.is_empty() {
            self.start = leg.points.first().map_or(0.0, |s| problem.energy(&s.at, s.energy));
        }
        for (solution, work) in leg.points.iter().zip(&leg.works) {
            self.point(machine, solution, way, self.work + work);
        }
        let work = leg.works.last().copied().unwrap_or(0.0);
        self.work += work;
        self.largest = self.largest.max(work.abs()).max(self.work.abs());
        self.effort.newton_iterations += leg.iterations;
        self.pieces.push((way, leg.curve.clone()));
    }

    /// The largest force so far, and that before the beam stood on its end.
    fn take_peak(&mut self, machine: &Machine, leg: &StableBranch) -> Result<(), TestError> {
        let before = self.pull_off;
        self.take_peak_of(machine, leg)?;
        leg.points.iter().for_each(|point| self.notice_stand(machine, point, before));
        Ok(())
    }

    /// Keeps the largest force so far where the beam stands on its end for the first time; `before` is that before the piece.
    fn notice_stand(&mut self, machine: &Machine, at: &Solution, before: Option<PullOff>) {
        if !self.stood && machine.adhering(at) == Adhering::EndFace {
            let earlier = |peak: &PullOff| peak.machine <= at.observables.displacement;
            self.before_upright = self.pull_off.filter(earlier).or(before);
            self.stood = true;
        }
    }

    /// The largest force of a piece of the retreat: a maximum of its own, or its limit point.
    fn take_peak_of(&mut self, machine: &Machine, leg: &StableBranch) -> Result<(), TestError> {
        let largest = leg.points.iter().map(|p| p.observables.force).fold(f64::NEG_INFINITY, f64::max);
        if self.pull_off.is_some_and(|known| known.force > largest) {
            return Ok(());
        }
        let peak = machine.peak(leg)?;
        let at_limit = match &leg.end {
            BranchEnd::Limit(located) | BranchEnd::Branching(located) => Some(Located::clone(located)),
            BranchEnd::Arrived | BranchEnd::Bound(_) | BranchEnd::Lost(_) => None,
        };
        let highest = peak.into_iter().chain(at_limit);
        let highest = highest.max_by(|a, b| a.observables.force.total_cmp(&b.observables.force));
        if let Some(Located { observables: o, difference, solution, .. }) = highest {
            let force_error = DIFFERENCE_BOUND_FACTOR * difference.force.abs()
                + (ROUND_OFF + least(machine.relative)) * o.force.abs();
            let adheres = machine.adhering(&solution);
            self.pull_off = Some(PullOff { machine: o.displacement, force: o.force, force_error, adheres });
        }
        Ok(())
    }

    fn point(&mut self, machine: &Machine, solution: &Solution, way: LoadingDirection, work: f64) {
        let jumped = std::mem::take(&mut self.jumped);
        self.points.push(TestPoint { jumped, ..machine.point(solution, way, work) });
    }

    /// Stations and events that were found on a piece, before the piece itself is taken.
    fn take_stations(&mut self, machine: &Machine, found: Vec<Passed>, leg: &StableBranch, way: LoadingDirection) {
        for Passed { event, after, solution, errors } in found {
            let segment = PathSegment::around(machine.problem, &leg.points, after);
            let label = segment.label(&solution.observables);
            let ahead = StepCurve::until(machine.problem, &segment, label, &solution, &mut Workspace::default());
            let work = self.work + leg.works[after] + ahead.work();
            let (point, free_end_gap) = (machine.point(&solution, way, work), machine.free_end_gap(&solution));
            self.stations.push(TestStation { event, point, free_end_gap, errors });
        }
    }

    /// The same where the strip has jumped, at one displacement of the machine; the event that stops the test, if one does.
    fn look_at_jump(
        &mut self,
        machine: &Machine,
        before: &Solution,
        landed: &Solution,
        way: LoadingDirection,
    ) -> Option<Bound> {
        for (event, at) in machine.stop.events.iter().enumerate() {
            let measure = number(machine.model, machine.problem, &at.quantity);
            if !self.jumped || !at.passes(measure.at(before), measure.at(landed)) {
                continue;
            }
            let point = TestPoint { jumped: true, ..machine.point(landed, way, self.work) };
            self.stations.push(TestStation { event, point, free_end_gap: machine.free_end_gap(landed), errors: None });
            if at.action == EventAction::Stop {
                return Some(Bound::Event { name: at.name.clone() });
            }
        }
        None
    }

    /// Relaxes from where stability is lost; where it comes to rest. A path that branches may go on without a jump.
    fn lost(
        &mut self,
        machine: &Machine,
        limit: &Located,
        loss: Loss,
        way: LoadingDirection,
    ) -> Result<Landing, TestError> {
        let problem = machine.problem;
        let machine_nm = limit.observables.displacement;
        let mut relaxing = Workspace::until(machine.stop.for_solves(Stage::Path));
        let options = RelaxOptions::by(RELAXING);
        let start = match loss {
            Loss::LimitPoint => disturbed(problem, &limit.solution),
            Loss::Branching => disturbed_anyhow(problem, &limit.solution.at),
        };
        let mut relaxed_at = |start: State, machine_nm: f64| {
            let relaxed = relax(problem, start, Held::Displacement(machine_nm), &options, &mut relaxing)
                .map_err(|cause| TestError::Relax { machine_nm, cause })?;
            self.effort.relaxation_steps += relaxed.steps;
            Ok::<_, TestError>(relaxed)
        };
        let (mut relaxed, mut stayed) = (relaxed_at(start, machine_nm)?, None);
        if stays(machine, limit, &relaxed.solution) {
            // at the limit point itself nothing drives the strip away from it: a little beyond it something does
            for share in BEYOND {
                let ahead = share * machine_nm.abs();
                let beyond = machine_nm + if way == LoadingDirection::Retreat { ahead } else { -ahead };
                let further = relaxed_at(relaxed.solution.at.clone(), beyond)?.solution;
                relaxed = relaxed_at(further.at.clone(), machine_nm)?;
                if !stays(machine, limit, &relaxed.solution) {
                    break;
                }
                if machine.is_equilibrium(&further) {
                    stayed = Some(further);
                    break;
                }
            }
        }
        if let Some(limit) = machine.collapsed(&relaxed.solution) {
            return Ok(Landing::Beyond(limit));
        }
        let jump = jump::described(machine, limit, &relaxed, way, &mut Workspace::default());
        // one that releases next to nothing was round-off's
        let nothing = jump.released.abs() <= jump.released_error && jump.released_error <= BALANCED * self.largest;
        let rests = stayed.is_some() && jump.released <= jump.released_error;
        let solution = stayed.unwrap_or(relaxed.solution);
        if nothing || rests {
            return Ok(Landing::Rest(Arc::new(solution)));
        }
        if jump.released <= 0.0 && jump.released.abs() > jump.released_error {
            return Err(TestError::NoRelease { machine_nm, released: jump.released });
        }
        self.largest = self.largest.max(jump.released);
        self.jumps.push(jump);
        self.jumped = true;
        Ok(Landing::Rest(Arc::new(solution)))
    }

    /// The balance so far, if it closes.
    fn balance(&self, machine: &Machine, at: &Solution) -> Result<Balance, TestError> {
        let energy_change = machine.problem.energy(&at.at, at.energy) - self.start;
        let released = self.jumps.iter().map(|jump| jump.released).sum();
        let largest = self.largest.max(energy_change.abs());
        let balance = Balance { work: self.work, energy_change, released, largest };
        if balance.error() <= BALANCED.max(machine.relative) {
            Ok(balance)
        } else {
            Err(TestError::Unbalanced(balance))
        }
    }

    /// One that did not fail comes first, then the one that found more, then the errors.
    fn is_better_than(&self, best: &Self) -> bool {
        let rank = |test: &Self| (test.end.is_ok(), test.jumps.len());
        rank(self) > rank(best) || (rank(self) == rank(best) && self.worst() < best.worst())
    }

    /// Largest relative bound of the reported numbers of the jumps.
    fn worst(&self) -> f64 {
        let relative = |jump: &Jump| {
            let place = jump.machine_error / jump.machine.abs();
            // the two forces of a jump are read on one scale
            let force = jump.before.force.abs().max(jump.after.force.abs());
            let ends = jump.before.force_error.max(jump.after.force_error) / force;
            place.max(ends).max(jump.released_error / jump.released)
        };
        let share = |peak: PullOff| peak.force_error / peak.force.abs();
        match self.course {
            Course::ThereAndBack => self.jumps.iter().map(relative).fold(self.pull_off.map_or(0.0, share), f64::max),
            // of the jumps on the way none is asked for
            Course::There => self.before_upright.or(self.pull_off).map_or(0.0, share),
        }
    }

    /// Where finer meshes did not bring the errors down to what was asked for, they are round-off: no bound is less than twice
    /// the difference to what comparable meshes gave.
    fn widen(&mut self, others: &[(f64, Vec<Jump>)]) {
        let worst = self.worst();
        let comparable = |other: &&(f64, Vec<Jump>)| other.0 <= COMPARABLE * worst && other.1.len() == self.jumps.len();
        let others: Vec<_> = others.iter().filter(comparable).collect();
        for (n, jump) in self.jumps.iter_mut().enumerate() {
            others.iter().for_each(|(_, twins)| jump.widen(&twins[n]));
        }
    }

    /// What a user reads.
    fn into_result(self, relative: f64) -> Observed {
        let reached = self.worst();
        let TestEffort { elements, order, .. } = self.effort;
        let failed = |cause| TestEnd::Failed(TestFailure { cause, elements, order, asked: relative });
        let end = self.end.unwrap_or_else(failed);
        let hysteresis = self.cycle.filter(|_| end == TestEnd::Closed).map(|cycle| cycle.work);
        let Self { points, jumps, stations, pieces, pull_off, before_upright, retreat, cycle, effort, .. } = self;
        Observed {
            points,
            jumps,
            stations,
            pieces,
            pull_off,
            before_upright,
            hysteresis,
            retreat,
            cycle,
            end,
            effort,
            reached,
        }
    }
}
