//! What a branch is followed by where the displacement of the root turns: the place of a joint that goes on.

use super::standing::{HEIGHT, Standing};
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::tree::branching_beam::JointUnknown;
use crate::solve::error::SolveError;
use crate::solve::linear::{Bordered, Tangents};
use crate::solve::newton::Solution;
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;

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

/// First step of a tip, nm.
const FIRST: f64 = 1.0;
/// Behind the place where the displacement nearly turns it has to go on this many times faster than where it was left.
const PASSED: f64 = 2.0;
/// A tip that is so many times as fast as the one that is watched is watched in its place.
const FASTER: f64 = 1.2;
/// The first step, over what the tangent says of the step that was refused.
const SHARE: f64 = 0.1;

impl Watched {
    /// The height of a tip that adheres and goes up, or of one that is detached and goes down.
    pub fn tip(standing: &Standing, tip: usize) -> Self {
        let unknown = JointUnknown { joint: standing.model.seta.tip_joint(tip), slot: HEIGHT };
        Self { unknown, sign: standing.way_out(tip), tip: Some(tip), passed: None, first: FIRST }
    }

    /// The place that changes the most with the displacement, and by how much of it; `ahead` is the step that was refused, nm.
    pub fn fastest(standing: &Standing, here: &Solution, ahead: f64) -> (Self, f64) {
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
    pub fn faster_tip(&self, standing: &Standing, here: &Solution) -> Option<Self> {
        let attached = (0..standing.tips.len()).filter(|&tip| standing.tips[tip].on.adheres());
        let rates =
            attached.map(|tip| Self::tip(standing, tip)).map(|own| (own.rate(here) / here.slope.displacement, own));
        let (rate, fastest) = rates.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let own = self.rate(here) / here.slope.displacement;
        (fastest.unknown != self.unknown && rate > FASTER * own.max(0.0)).then_some(fastest)
    }

    /// Its change with the parameter of a solution.
    pub fn rate(&self, solution: &Solution) -> f64 {
        self.sign * solution.tangent.direction[self.unknown.joint * SPATIAL_UNKNOWNS + self.unknown.slot]
    }

    /// What it is in a state, nm.
    pub fn value(&self, standing: &Standing, at: &State) -> f64 {
        self.sign * standing.tree.joint(at, self.unknown.joint).0[self.unknown.slot]
    }

    /// The place itself where the parameter has a value, nm.
    pub fn place(&self, value: f64) -> f64 {
        self.sign * value
    }

    /// Change of the parameter with the place.
    pub fn sign(&self) -> f64 {
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
