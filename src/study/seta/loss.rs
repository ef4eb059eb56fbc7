//! Where a branch loses its stability: located with the place of a joint as the parameter, mostly the height of a tip, which goes on where the
//! displacement turns.
//!
//! Behind the peak of its law the force of a tip falls as it is pulled on. That is stable until it falls faster than the seta yields: there the
//! displacement u of the root turns as the tip's height η goes on, du/dη = 0. With everything else linear du/dη = a + b h(η), h = ∂²E/∂y² of
//! the tip, which says where to look; of another joint the zero of du/dη follows from two of its values. Where another direction than that of
//! the branch becomes unstable first, du/dη does not turn, and the number of negative eigenvalues alone shows it.
//!
//! Where another tip is the one that lets go, it runs away from the tip that is watched, little of whose height is much of its own: from there on the
//! branch is followed by the height of the faster tip.

use super::knot::{Allowed, Knot, Reached, maximum};
use super::loading::SetaOptions;
use super::standing::{HEIGHT, RootDrive, Standing, TipTangent};
use crate::beam::spatial::rotation::{exponential, product};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::branching_beam::{EndEnergy, JointUnknown};
use crate::solve::error::SolveError;
use crate::solve::linear::{Bordered, Tangents};
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use crate::study::states::seta_state::LocationError;

/// Error of the displacement at a loss, nm: that of the force there goes with its root.
const LOCATED: f64 = 1e-8;
/// The same by a straight line through the slopes behind it and before it.
const AGREED: f64 = 1e-6;
/// The same where it is found by the number of negative eigenvalues.
const BRACKETED: f64 = 1e-4;
/// First step of a tip, and in looking for the height at which it is as soft as wanted, nm.
const FIRST: f64 = 1.0;
/// Longest step of a tip, nm.
const LONGEST: f64 = 20.0;
/// Shortest one, nm.
const SHORTEST: f64 = 1e-7;
/// What is left of a step that led too far.
const SHORTENED: f64 = 0.3;
/// How often another tip is watched on the way to a loss, at most.
const MOST_CHANGES: usize = 3;
/// Most solutions.
const MOST_SOLVES: usize = 80;
/// Of the solutions where the slopes at both ends of the bracket say that it turns, one of so many is in the middle instead.
const HALVED: usize = 6;
/// Most halvings of a step for the sake of its work.
const DEEPEST: usize = 8;

/// A loss of stability.
pub(super) struct Loss {
    /// Equilibria behind the start up to the loss, where the force has a maximum among them
    pub taken: Vec<Reached>,
    /// Where the force has a maximum at the start: by how much that misses it
    pub start: Option<LocationError>,
    /// What it leads to
    pub critical: Critical,
    /// ∂²E/∂y² of the tip there, nN/nm
    pub slope: Option<f64>,
    pub iterations: usize,
}

impl Loss {
    /// The equilibria up to the start of another one, and that.
    fn followed_by(mut self, loss: Self) -> Self {
        if let (Some(start), Some(last)) = (loss.start, self.taken.last_mut()) {
            last.location = Some(start);
        }
        self.taken.extend(loss.taken);
        Self { taken: self.taken, start: self.start, iterations: self.iterations + loss.iterations, ..loss }
    }
}

/// What a solve along a branch begins from.
#[derive(Clone, Copy)]
enum Known<'k> {
    /// A knot and its tangent
    One(&'k Knot),
    /// Two knots and their tangents: the state is taken on the cubic through them
    Two([&'k Knot; 2]),
}

impl<'k> Known<'k> {
    /// The last knot of a stable branch with the unstable one ahead, or with the one before it where that is no farther than the way ahead.
    fn of(low: &'k [Knot], high: Option<&'k Knot>, height: f64) -> Self {
        let from = &low[low.len() - 1];
        let before = low.len().checked_sub(2).map(|k| &low[k]);
        let reaches = |before: &&Knot| height - from.parameter <= from.parameter - before.parameter;
        high.or(before.filter(reaches)).map_or(Self::One(from), |other| Self::Two([from, other]))
    }
}

/// A branch along which the place of a joint goes on.
struct Along<'a> {
    standing: &'a Standing,
    problem: Problem,
    watched: Watched,
    options: &'a SetaOptions,
    iterations: usize,
}

impl Along<'_> {
    fn solve(&mut self, known: Known, height: f64, ws: &mut Workspace) -> Result<Knot, SolveError> {
        self.solve_with(known, height, &self.options.newton(), ws)
    }

    fn solve_with(
        &mut self,
        known: Known,
        height: f64,
        newton: &NewtonOptions,
        ws: &mut Workspace,
    ) -> Result<Knot, SolveError> {
        let per_height = |knot: &Knot| 1.0 / self.watched.rate(&knot.solution);
        let start = match known {
            Known::One(from) => from.solution.moved(&self.problem, (height - from.parameter) * per_height(from)),
            Known::Two(pair) => pair[0].predicted(pair[1], height, pair.map(per_height), &self.problem),
        };
        let constraint = PathConstraint { weights: Observables::monitor(0), target: self.watched.place(height) };
        let solution = solve(&self.problem, start, &constraint, newton, ws)?;
        self.iterations += solution.iterations;
        Ok(Knot::new(height, solution, self.watched.sign()))
    }

    /// h = ∂²E/∂y² of the tip at another height.
    fn softening(&self, at: &Knot, height: f64) -> Option<f64> {
        let tip = self.watched.tip?;
        let (place, directors) = self.standing.place(&at.solution.at, tip);
        let direction = &at.solution.tangent.direction;
        let way = (height - at.parameter) / self.watched.rate(&at.solution);
        let moved: [f64; SPATIAL_UNKNOWNS] =
            std::array::from_fn(|k| way * direction[self.watched.unknown.joint * SPATIAL_UNKNOWNS + k]);
        let place = std::array::from_fn(|i| place[i] + moved[i]);
        let directors = product(directors, exponential([moved[3], moved[4], moved[5]]));
        let own = &self.standing.tips[tip];
        (own.adheres(place, directors) == own.on.adheres())
            .then(|| self.standing.softening(&own.response(place, directors), tip, direction))
    }

    /// The height ahead at which h falls to this, or the end of the branch.
    fn where_softening_is(&self, at: &Knot, wanted: f64) -> f64 {
        let falls = |height: f64| self.softening(at, height).is_none_or(|h| h < wanted);
        let (mut low, mut step) = (at.parameter, FIRST);
        while !falls(low + step) && step < 1e4 {
            low += step;
            step *= 1.5;
        }
        let mut high = low + step;
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if falls(middle) { high = middle } else { low = middle }
        }
        low
    }

    /// The maximum of the force between two knots, as good as [`maximum`] finds it: one of them where that is good enough.
    fn maximum(&mut self, from: &Knot, to: &Knot, ws: &mut Workspace) -> Option<(Knot, LocationError)> {
        let newton = NewtonOptions { exact_slope: true, ..self.options.newton() };
        maximum(from, to, &mut |known, height| self.solve_with(Known::Two(known), height, &newton, ws))
    }

    /// Work by cubics between two knots as good as asked for: solutions in between.
    fn refined(
        &mut self,
        from: &Knot,
        to: Knot,
        depth: usize,
        ws: &mut Workspace,
        out: &mut Vec<(Knot, Option<LocationError>)>,
    ) -> Result<(), SolveError> {
        if depth < DEEPEST
            && from.imbalance_to(&to, &Allowed::new(self.standing, &from.solution, self.options.balance)).1 > 1.0
        {
            let middle = self.solve(Known::Two([from, &to]), 0.5 * (from.parameter + to.parameter), ws)?;
            self.refined(from, middle.clone(), depth + 1, ws, out)?;
            return self.refined(&middle, to, depth + 1, ws, out);
        }
        out.push((to, None));
        Ok(())
    }
}

/// The loss of stability ahead of a stable equilibrium, on the way of this joint; `slope` is what ∂²E/∂y² of a tip was at the loss before.
pub(super) fn locate(
    standing: &Standing,
    drive: &RootDrive,
    here: &Solution,
    watched: Watched,
    slope: Option<f64>,
    options: &SetaOptions,
    ws: &mut Workspace,
) -> Result<Loss, SolveError> {
    locate_by((standing, drive), here, (watched, MOST_CHANGES), slope, options, ws)
}

/// The same; the tip that is watched may be changed for a faster one so often.
fn locate_by(
    (standing, drive): (&Standing, &RootDrive),
    here: &Solution,
    (watched, changes): (Watched, usize),
    slope: Option<f64>,
    options: &SetaOptions,
    ws: &mut Workspace,
) -> Result<Loss, SolveError> {
    let problem = standing.problem(drive, Some(watched.unknown), TipTangent::Own);
    let height = watched.value(standing, &here.at);
    let first = Knot::new(height, here.clone(), watched.rate(here));
    let mut along = Along { standing, problem, watched, options, iterations: 0 };
    let guess = slope.filter(|_| watched.tip.is_some());
    let guess = guess.map_or(height + watched.first, |slope| along.where_softening_is(&first, slope));
    let most = LONGEST.max(watched.first);
    let (mut low, mut high): (Vec<Knot>, Option<Knot>) = (vec![first], None);
    let mut longest = most;
    let mut crossings = 0;
    let mut may_change = changes > 0 && watched.passed.is_none();
    let mut next = guess.clamp(height + SHORTEST, height + longest);
    for _ in 0..MOST_SOLVES {
        let from = low[low.len() - 1].clone();
        let solved = along.solve(Known::of(&low, high.as_ref(), next), next, ws);
        let found = match solved {
            Ok(knot) if standing.changing(&knot.solution.at).is_empty() => knot,
            // beyond the end of the branch, or too far
            other => {
                // where another tip runs away from the one that is watched, its height is what the branch is smooth in
                if may_change
                    && low.len() > 1
                    && let Some(faster) = watched.faster_tip(standing, &from.solution)
                {
                    may_change = false;
                    let by = (faster, changes - 1);
                    if let Ok(loss) = locate_by((standing, drive), &from.solution, by, slope, options, ws) {
                        return Ok(finished(along, low, Critical::Passed, [0.0; 2], ws)?.followed_by(loss));
                    }
                }
                longest = SHORTENED * (next - from.parameter);
                if longest < SHORTEST {
                    return match other {
                        // stable up to where a tip comes to the end of its branch, which need not be the one that is watched
                        Ok(beyond) if low.len() > 1 => {
                            let (last, tips) = (&low[low.len() - 1], standing.changing(&beyond.solution.at));
                            let error = [0, 1].map(|k| (last.slopes[k] * SHORTEST / SHORTENED).abs());
                            finished(along, low, Critical::Tips(tips), error, ws)
                        }
                        Ok(_) => Err(SolveError::LimitPointNotConfirmed),
                        Err(cause) => Err(cause),
                    };
                }
                next = from.parameter + longest;
                continue;
            }
        };
        let is_stable = found.solution.negative == 0 && found.slopes[0] > 0.0;
        let turns = found.slopes[0] <= 0.0 || is_stable;
        let estimate = model_root(&along, &from, &found);
        let crossing = match (is_stable, &high) {
            (true, Some(high)) => crossing(&found, high),
            (true, None) => None,
            (false, _) => crossing(&from, &found),
        };
        let crossing = crossing.filter(|by| !by.holds(estimate));
        let estimate = crossing.as_ref().map_or(estimate, |by| by.root);
        crossings += usize::from(crossing.is_some());
        let missed = [0, 1].map(|k| (found.slopes[k] * (estimate - found.parameter)).abs());
        let error = 0.5 * missed[0];
        // the softening of a tip that turns is known on the tangent alone: two slopes have to say the same
        let straight = straight_root(&from, &found);
        let agrees = found.slopes[0] >= 0.0 || (0.5 * found.slopes[0] * (straight - found.parameter)).abs() < AGREED;
        let estimate = if error < LOCATED && !agrees { straight } else { estimate };
        if turns && error < LOCATED && agrees {
            let critical = at_fold(standing, &along.problem, &found.solution, watched.sign());
            let missed = missed.map(|missed| 2.0 * missed);
            low.push(found);
            return finished(along, low, critical, missed, ws);
        }
        if is_stable && watched.passed.is_some_and(|passed| found.slopes[0] > passed) {
            low.push(found);
            return finished(along, low, Critical::Passed, [0.0; 2], ws);
        }
        if let Some(high) = &high
            && !turns
            && (high.values[0] - from.values[0]).abs() < BRACKETED
        {
            let critical = at_branching(standing, &along.problem, &found.solution, ws)?;
            let missed = [0, 1].map(|k| (high.values[k] - from.values[k]).abs());
            if matches!(critical, Critical::Shape(_)) {
                // the first that is unstable: held there, the seta leaves its shape
                low.push(found);
            }
            return finished(along, low, critical, missed, ws);
        }
        if is_stable {
            low.push(found)
        } else {
            high = Some(found)
        }
        let from = &low[low.len() - 1];
        longest = (1.7 * longest).min(most);
        next = match &high {
            Some(high) => {
                let (a, b) = (from.parameter, high.parameter);
                let inside = estimate > a && estimate < b && turns;
                let halved = crossing.is_some() && crossings % HALVED == 0;
                if inside && !halved { estimate } else { 0.5 * (a + b) }
            }
            None if estimate > from.parameter => estimate.min(from.parameter + longest),
            None => from.parameter + longest.min(2.0 * watched.first),
        };
    }
    Err(SolveError::LimitPointNotConfirmed)
}

/// Where du/dη = a + b h(η) through two knots is zero; a + b η where the softening of no tip says it.
fn model_root(along: &Along, one: &Knot, other: &Knot) -> f64 {
    let h = |knot: &Knot| along.softening(knot, knot.parameter);
    let change = other.slopes[0] - one.slopes[0];
    let (Some(first), Some(second)) = (h(one), h(other)) else { return straight_root(one, other) };
    let b = change / (second - first);
    if !(b.is_finite() && b > 0.0) {
        return if along.watched.passed.is_some() { straight_root(one, other) } else { f64::NAN };
    }
    let wanted = second - other.slopes[0] / b;
    let from = if other.slopes[0] > 0.0 { other } else { one };
    along.where_softening_is(from, wanted)
}

/// Where du/dη is zero between a stable and an unstable knot.
struct Crossing {
    bracket: [f64; 2],
    root: f64,
}

impl Crossing {
    /// Whether a parameter is in the bracket.
    fn holds(&self, parameter: f64) -> bool {
        parameter > self.bracket[0] && parameter < self.bracket[1]
    }
}

/// By the cubic through u and du/dη at both, which says more than the softening of a tip whose rotation is not that of the tangent; none where
/// du/dη has one sign.
fn crossing(low: &Knot, high: &Knot) -> Option<Crossing> {
    let bracket = [low.parameter, high.parameter];
    let turns = low.slopes[0] > 0.0 && high.slopes[0] < 0.0;
    turns.then(|| Crossing { bracket, root: bracket[0] + low.turn_of(high, 0) * (bracket[1] - bracket[0]) })
}

/// Where du/dη is zero on a straight line through its values at two knots.
fn straight_root(one: &Knot, other: &Knot) -> f64 {
    other.parameter - other.slopes[0] * (other.parameter - one.parameter) / (other.slopes[0] - one.slopes[0])
}

/// The equilibria up to a loss, the last of which misses it by so much, nm and nN.
fn finished(
    mut along: Along,
    low: Vec<Knot>,
    critical: Critical,
    [displacement, force]: [f64; 2],
    ws: &mut Workspace,
) -> Result<Loss, SolveError> {
    let mut knots = vec![(low[0].clone(), None)];
    for pair in low.windows(2) {
        let mut from = pair[0].clone();
        if let Some((highest, error)) = along.maximum(&from, &pair[1], ws) {
            if highest.parameter > from.parameter {
                along.refined(&from, highest.clone(), 0, ws, &mut knots)?;
                from = highest;
            }
            if let Some(last) = knots.last_mut() {
                last.1 = Some(error);
            }
        }
        if pair[1].parameter > from.parameter {
            along.refined(&from, pair[1].clone(), 0, ws, &mut knots)?;
        }
    }
    if let Some(last) = knots.last_mut().filter(|_| !matches!(critical, Critical::Passed)) {
        last.1 = Some(LocationError { force, displacement });
    }
    let last = &knots[knots.len() - 1].0;
    let slope = along.softening(last, last.parameter).filter(|_| matches!(critical, Critical::Tips(_)));
    let start = knots[0].1;
    let works: Vec<f64> = knots.windows(2).map(|pair| pair[0].0.work_to(&pair[1].0)).collect();
    let reached = knots.into_iter().skip(1).zip(works);
    let taken = reached.map(|((knot, location), work)| Reached { solution: knot.solution, work, location }).collect();
    Ok(Loss { taken, start, critical, slope, iterations: along.iterations })
}

// -- What a branch is followed by where the displacement of the root turns: the place of a joint that goes on --

/// A place of a joint along x, y or z that grows or falls along a branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched {
    pub unknown: JointUnknown,
    /// 1 where it grows, -1 where it falls: the parameter is the place times this
    sign: f64,
    /// The tip whose height it is, if it is one that goes on to the end of its branch: adheres and goes up, or is detached and goes down
    pub tip: Option<usize>,
    /// du over the change of the parameter above which the branch can be followed by the displacement again; none where it is followed up to
    /// its end
    pub passed: Option<f64>,
    /// First step of the parameter, nm, where no better one is known
    pub first: f64,
}

/// Behind the place where the displacement nearly turns it has to go on this many times faster than where it was left.
const PASSED: f64 = 2.0;
/// A tip that is so many times as fast as the one that is watched is watched in its place.
const FASTER: f64 = 1.2;
/// The first step, over what the tangent says of the step that was refused.
const SHARE: f64 = 0.1;

impl Watched {
    /// The height of a tip that adheres and goes up, or of one that is detached and goes down.
    pub(crate) fn tip(standing: &Standing, tip: usize) -> Self {
        let unknown = JointUnknown { joint: standing.model.seta.tip_joint(tip), slot: HEIGHT };
        Self { unknown, sign: standing.way_out(tip), tip: Some(tip), passed: None, first: FIRST }
    }

    /// The place that changes the most with the displacement, and by how much of it; `ahead` is the step that was refused, nm.
    pub(crate) fn fastest(standing: &Standing, here: &Solution, ahead: f64) -> (Self, f64) {
        let per = |k: usize| here.tangent.direction[k] / here.slope.displacement;
        let places = (1..standing.tree.joints()).flat_map(|joint| (0..3).map(move |slot| JointUnknown { joint, slot }));
        let mut fastest = (JointUnknown { joint: 0, slot: 0 }, 0.0f64);
        for unknown in places {
            let rate = per(unknown.joint * SPATIAL_UNKNOWNS + unknown.slot);
            if rate.abs() > fastest.1.abs() {
                fastest = (unknown, rate);
            }
        }
        let (unknown, rate) = fastest;
        let tips = standing.model.seta.tips();
        let tip = (unknown.joint >= tips && unknown.slot == HEIGHT && rate > 0.0).then(|| unknown.joint - tips);
        let tip = tip.filter(|&tip| standing.tips[tip].on.adheres());
        let first = (SHARE * ahead * rate.abs()).max(FIRST);
        (Self { unknown, sign: rate.signum(), tip, passed: Some(PASSED / rate.abs()), first }, rate.abs())
    }

    /// The tip that goes on to the end of its branch the fastest, if it is faster than this place.
    pub(crate) fn faster_tip(&self, standing: &Standing, here: &Solution) -> Option<Self> {
        let attached = (0..standing.tips.len()).filter(|&tip| standing.tips[tip].on.adheres());
        let rates =
            attached.map(|tip| Self::tip(standing, tip)).map(|own| (own.rate(here) / here.slope.displacement, own));
        let (rate, fastest) = rates.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let own = self.rate(here) / here.slope.displacement;
        (fastest.unknown != self.unknown && rate > FASTER * own.max(0.0)).then_some(fastest)
    }

    /// Its change with the parameter of a solution.
    pub(crate) fn rate(&self, solution: &Solution) -> f64 {
        self.sign * solution.tangent.direction[self.unknown.joint * SPATIAL_UNKNOWNS + self.unknown.slot]
    }

    /// What it is in a state, nm.
    pub(crate) fn value(&self, standing: &Standing, at: &State) -> f64 {
        self.sign * standing.tree.joint(at, self.unknown.joint).0[self.unknown.slot]
    }

    /// The place itself where the parameter has a value, nm.
    pub(crate) fn place(&self, value: f64) -> f64 {
        self.sign * value
    }

    /// Change of the parameter with the place.
    pub(crate) fn sign(&self) -> f64 {
        self.sign
    }
}

// -- What happens where a branch loses its stability: tips lose their hold, or the seta goes over to another shape --
//
// At a loss the tangent K has a direction v with vᵀKv = 0. K is that of beams under load, K⁺, plus what softens tips, h < 0 of their ∂²E/∂y².
// Where a softening tip has a part in v, vᵀK⁺v = -Σ h v² > 0: the tips let go, or a detached one snaps on, and the seta would hold. Where none has, K⁺ itself is singular: the
// beams buckle, as under a preload, and the seta leaves its shape along v.

/// Components of the critical direction that differ by this share are equal by symmetry.
const ALIKE: f64 = 1e-6;
/// A tip has a part in a direction where it moves by this share of the largest movement of a joint.
const PART: f64 = 1e-2;
/// How far a shape is left along its critical direction, in units of 10 nm and 0.01 rad.
const DISTURBED: f64 = 0.1;
/// A detached tip snaps on in a loss of stability where it is so near to the end of its branch, nm: farther away the seta leaves its shape, and
/// is led to where the tip snaps on.
const NEAR_SNAP_ON: f64 = 5.0;
/// Iterations for a critical direction.
const ITERATIONS: usize = 6;

/// What a loss of stability leads to.
pub(super) enum Critical {
    /// These tips lose their hold, or are drawn to the ground
    Tips(Vec<usize>),
    /// Beams buckle: disturbed a little along the critical direction
    Shape(Box<State>),
    /// None: the displacement has nearly turned, and goes on
    Passed,
}

/// Where the branch turns its own direction is critical.
pub(super) fn at_fold(standing: &Standing, problem: &Problem, at: &Solution, sign: f64) -> Critical {
    let direction: Vec<f64> = at.tangent.direction.iter().map(|x| sign * x).collect();
    of_direction(standing, problem, &at.at, &direction)
}

/// Where it branches: by the direction in which the tangent is least stiff.
pub(super) fn at_branching(
    standing: &Standing,
    problem: &Problem,
    at: &Solution,
    ws: &mut Workspace,
) -> Result<Critical, SolveError> {
    let mode = critical_direction(problem, at, ws)?;
    let of = |tip: usize| standing.way_out(tip) * mode[standing.model.seta.tip_joint(tip) * SPATIAL_UNKNOWNS + HEIGHT];
    let softening: Vec<usize> = (0..standing.tips.len()).filter(|&tip| softens(standing, &at.at, tip, &mode)).collect();
    let most = softening.iter().map(|&tip| of(tip).abs()).fold(0.0, f64::max);
    let first = softening.iter().find(|&&tip| of(tip).abs() >= (1.0 - ALIKE) * most);
    let sign = first.map_or(1.0, |&tip| of(tip).signum());
    let direction: Vec<f64> = mode.iter().map(|x| sign * x).collect();
    Ok(of_direction(standing, problem, &at.at, &direction))
}

/// The direction in which the tangent with the root held is least stiff, its largest component ±1.
pub(super) fn critical_direction(problem: &Problem, at: &Solution, ws: &mut Workspace) -> Result<Vec<f64>, SolveError> {
    let held = PathConstraint { weights: Observables::DISPLACEMENT, target: at.observables.displacement };
    let tangents = Tangents::new(problem, &at.at, &held, ws)?;
    let unknowns = problem.system.unknowns(&at.at);
    let mut mode: Vec<f64> = (1..=unknowns).map(|k| (0.618_033_988_749_895 * k as f64).fract() - 0.5).collect();
    for _ in 0..ITERATIONS {
        mode = tangents.solve(&Bordered { direction: mode, last: 0.0 }, ws)?.direction;
        let largest = mode.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        mode.iter_mut().for_each(|x| *x /= largest);
    }
    Ok(mode)
}

/// A state moved a little along a direction.
pub(super) fn disturbed(problem: &Problem, at: &State, direction: &[f64]) -> State {
    let mut next = at.clone();
    let size = problem.system.size(direction, at);
    problem.system.retract(&mut next, direction, DISTURBED / size);
    next
}

/// The tips that go the fastest to the end of their branch of those that soften, where equal all of them; where none takes part the shape that is
/// left.
fn of_direction(standing: &Standing, problem: &Problem, at: &State, direction: &[f64]) -> Critical {
    let places = direction[..standing.tree.joints() * SPATIAL_UNKNOWNS].chunks_exact(SPATIAL_UNKNOWNS);
    let largest = places.flat_map(|joint| &joint[..3]).fold(0.0f64, |most, x| most.max(x.abs()));
    let height = |tip: usize| direction[standing.model.seta.tip_joint(tip) * SPATIAL_UNKNOWNS + HEIGHT];
    let speed = |tip: usize| standing.way_out(tip) * height(tip);
    let takes_part = |&tip: &usize| speed(tip) > PART * largest && softens(standing, at, tip, direction);
    let softening: Vec<usize> = (0..standing.tips.len()).filter(takes_part).collect();
    let most = softening.iter().map(|&tip| speed(tip)).fold(f64::NEG_INFINITY, f64::max);
    if softening.is_empty() {
        return Critical::Shape(Box::new(disturbed(problem, at, direction)));
    }
    Critical::Tips(softening.into_iter().filter(|&tip| speed(tip) >= most - ALIKE * most.abs()).collect())
}

/// Whether a tip that adheres, or one that is about to snap on, softens as it goes along a direction.
fn softens(standing: &Standing, at: &State, tip: usize, direction: &[f64]) -> bool {
    let may_change = standing.tips[tip].on.adheres() || standing.snaps_on_within(at, tip, NEAR_SNAP_ON);
    may_change && standing.softening(&standing.response(at, tip), tip, direction) < 0.0
}
