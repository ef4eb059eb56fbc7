//! From the planar path onto the branch, by the terms of second order at the branch point.
//!
//! With the roll a of the grip as its parameter the branch is, by its mirror image a → -a,
//!
//!   q(a) = q* + a v + a² e + O(a³),  u = u* + u₂ a² + O(a⁴),  P = P* + P₂ a² + O(a⁴),
//!
//! v out of the plane, e in it. v is what a small roll of the grip makes of the equilibrium at the loss, which takes no
//! torque there. Two rolls a₀ and 2a₀ without torque give e, u₂ and P₂, and u* once more. These choose the roll of the
//! first point: so large that a² e is a share of the gap that predictions on the path see, and so small that terms of
//! higher order are less.

use super::result::{BranchStart, OutOfPlaneBranchError};
use crate::beam::planar::planar_beam::{FRONT, PlanarBeam};
use crate::beam::spatial::end_rotation::{EndRotation, turned};
use crate::beam::spatial::rest::ALONG_X;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::problem::beam_problem::BeamProblem;
use crate::number::gauss::Rule;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::state::{Mesh, Observables, PathConstraint, State};
use crate::solve::system::System;
use crate::solve::workspace::Workspace;
use crate::study::out_of_plane::first_loss::Beside;
use std::num::NonZeroUsize;

/// Roll of the grip whose effect is taken for linear, over the one that moves an edge of its end by r0.
const LINEAR: f64 = 1e-4;
/// Sizes of a₀ v, which with that of an edge of the end is over r0, and of a² e, relative as in [`System::size`].
const FIRST_ORDER: f64 = 0.01;
const SECOND_ORDER: f64 = 0.02;
/// a₀ is halved until the branch begins where the planar path loses its stability, to this share of u₂ a₀², or so often.
const SAME_PLACE: f64 = 2e-3;
const MOST_SMALLER: usize = 5;
/// Largest roll of the first point, over the one that moves an edge of its end by r0, and rad.
const MOST_ROLL: [f64; 2] = [0.5, 0.2];
/// Terms of higher order are less than this share of those of second order.
const HIGHER_ORDER: f64 = 0.2;
/// Most times the roll of the first point is halved.
const MOST_HALVINGS: usize = 8;

/// A first point of the branch, and the branch point.
pub(super) struct FirstPoint {
    /// In equilibrium, of the grip whose roll is an unknown
    pub at: State,
    pub displacement: f64,
    pub start: BranchStart,
}

/// The planar equilibrium beside the loss, what of it is known, and the same strip in space.
pub(super) struct Switch<'s> {
    pub planar: &'s PlanarBeam,
    pub beside: &'s Beside,
    pub problem: &'s BeamProblem,
    pub spatial: &'s SpatialBeam,
    pub elements: usize,
    /// Half of the larger dimension of the section over r0
    pub broad: f64,
}

/// What is known at the branch point.
struct Expansion {
    /// The planar equilibrium there
    planar: Rolled,
    /// v per unit roll, and e per its square
    first: Vec<f64>,
    second: Vec<f64>,
    /// Of the constraint's target, and the terms of u and P
    target: [f64; 2],
    displacement: [f64; 2],
    force: [f64; 2],
    /// The larger of the two rolls that it was found with
    known: f64,
}

impl Switch<'_> {
    /// The first point of the branch.
    pub(crate) fn first_point(&self, ws: &mut Workspace) -> Result<FirstPoint, OutOfPlaneBranchError> {
        let strip = RolledStrip { problem: self.problem, weights: self.beside.weights };
        let expansion = self.expansion(&strip, ws).map_err(OutOfPlaneBranchError::NotSwitched)?;
        let size = |direction: &[f64]| self.spatial.size(direction, &expansion.planar.solution.at);
        let mut roll = (SECOND_ORDER / size(&expansion.second)).sqrt().min(MOST_ROLL[0] / self.broad).min(MOST_ROLL[1]);
        let mut missed = f64::NAN;
        for _ in 0..MOST_HALVINGS {
            let [_, second] = expansion.target;
            let target = expansion.target[0] + second * roll * roll;
            let mut start = expansion.planar.solution.at.clone();
            let step: Vec<f64> =
                expansion.first.iter().zip(&expansion.second).map(|(v, e)| roll * v + roll * roll * e).collect();
            self.spatial.retract(&mut start, &step, 1.0);
            start.force += expansion.force[1] * roll * roll;
            let found = strip.without_torque(start, roll, target, self.beside.margin_slope, ws);
            let Ok(found) = found else {
                roll *= 0.5;
                continue;
            };
            let o = &found.solution.observables;
            let of_second = expansion.displacement[1] * roll * roll;
            missed = ((o.displacement - expansion.displacement[0] - of_second) / of_second).abs();
            if missed <= HIGHER_ORDER {
                let start = BranchStart {
                    roll,
                    displacement: expansion.displacement[0],
                    force: expansion.force[0],
                    displacement_by_roll: expansion.displacement[1],
                    force_by_roll: expansion.force[1],
                    yaw_by_roll: expansion.first[expansion.first.len() - 2],
                };
                return Ok(FirstPoint { displacement: o.displacement, at: found.solution.at, start });
            }
            roll *= 0.5;
        }
        Err(OutOfPlaneBranchError::HigherOrder { roll, share: missed, known: expansion.known })
    }

    /// The terms at the branch point, from two small rolls.
    fn expansion(&self, strip: &RolledStrip, ws: &mut Workspace) -> Result<Expansion, SolveError> {
        let Beside { solution, weights, ahead, margin_slope } = self.beside;
        let (ahead, margin_slope) = (*ahead, *margin_slope);
        let front = self.planar.fronts.place(solution.observables.monitors[FRONT]);
        let start = embedded((self.planar, &solution.at), self.spatial, front, self.elements);
        // the monitors of the two kinds of elements differ by their errors
        let (evaluation, _) = self.spatial.evaluate(&start, &vec![0.0; self.spatial.unknowns(&start)]);
        let target = weights.dot(&self.problem.observables(&start, &evaluation)) + ahead;
        let planar = strip.held(start, 0.0, target, ws)?;
        let at = planar.solution.at.clone();
        let linear = LINEAR / self.broad;
        let rolled = strip.held(at.clone(), linear, target, ws)?;
        let first = self.out_of_plane(&self.difference(&at, &rolled.solution.at, linear));
        let mut roll = FIRST_ORDER / self.spatial.size(&first, &at).max(self.broad);
        let mut of_roll = |roll: f64, target: f64| {
            let mut start = at.clone();
            self.spatial.retract(&mut start, &first, roll);
            strip.without_torque(start, roll, target, margin_slope, ws)
        };
        // f(2a) - f(a) = 3 f₂ a², f* = f(a) - f₂ a²
        let terms = |roll: f64, one: f64, two: f64| [one - (two - one) / 3.0, (two - one) / (3.0 * roll * roll)];
        // how far from the loss it begins, over the term of second order
        let missed = |roll: f64, one: &Rolled, two: &Rolled| {
            let [begins, second] = terms(roll, one.target, two.target);
            ((begins - target) / (second * roll * roll)).abs()
        };
        let (mut one, mut two) = (of_roll(roll, target)?, of_roll(2.0 * roll, target)?);
        for _ in 0..MOST_SMALLER {
            let least = missed(roll, &one, &two);
            if least <= SAME_PLACE {
                break;
            }
            let (Ok(nearer), Ok(next)) = (of_roll(0.5 * roll, target), of_roll(roll, target)) else { break };
            // smaller ones are lost in what the two meshes differ by
            if missed(0.5 * roll, &nearer, &next) >= least {
                break;
            }
            (roll, one, two) = (0.5 * roll, nearer, next);
        }
        let terms = |one: f64, two: f64| terms(roll, one, two);
        let second = self.difference(&one.solution.at, &two.solution.at, 3.0 * roll * roll);
        let (a, b): (&Observables, &Observables) = (&one.solution.observables, &two.solution.observables);
        Ok(Expansion {
            planar,
            second: self.in_the_plane(&second),
            target: terms(one.target, two.target),
            displacement: terms(a.displacement, b.displacement),
            force: terms(a.force, b.force),
            known: 2.0 * roll,
            first,
        })
    }

    /// From one state to another on its mesh, over a number.
    fn difference(&self, from: &State, to: &State, over: f64) -> Vec<f64> {
        let mut direction = self.spatial.difference(&from.values, &to.values);
        direction.iter_mut().for_each(|entry| *entry /= over);
        direction
    }

    /// The part of a direction in the plane: x, y and the turn about the width, which of an end is the first angle.
    fn in_the_plane(&self, direction: &[f64]) -> Vec<f64> {
        self.parted(direction, true)
    }

    fn out_of_plane(&self, direction: &[f64]) -> Vec<f64> {
        self.parted(direction, false)
    }

    fn parted(&self, direction: &[f64], in_the_plane: bool) -> Vec<f64> {
        const OF_NODE: usize = 6;
        let last = direction.len() / OF_NODE - 1;
        let part = |(index, &entry): (usize, &f64)| {
            let (node, field) = (index / OF_NODE, index % OF_NODE);
            let turn = if node == 0 || node == last { 3 } else { 4 };
            let is_planar = field < 2 || field == turn;
            if is_planar == in_the_plane { entry } else { 0.0 }
        };
        direction.iter().enumerate().map(part).collect()
    }
}

// -- A planar equilibrium as a state of the same strip in space --

/// Points of the rule with which x' is integrated from node to node.
const POINTS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(7);

/// A planar state, whose front is at S = `front` (nm), on so many elements in space: y and θ as they are, x by
/// quadrature of x', no z, yaw or roll. It is an equilibrium up to what the two kinds of elements differ by.
pub(super) fn embedded(
    (planar, at): (&PlanarBeam, &State),
    spatial: &SpatialBeam,
    front: f64,
    elements: usize,
) -> State {
    let at_front = on_mesh((planar, at), spatial, spatial.mesh_at(front, &[0.0; 2], elements));
    let edges = spatial.edges(&at_front, front);
    if edges == [0.0; 2] { at_front } else { on_mesh((planar, at), spatial, spatial.mesh_at(front, &edges, elements)) }
}

/// The same on a mesh.
fn on_mesh((planar, at): (&PlanarBeam, &State), spatial: &SpatialBeam, mesh: Mesh) -> State {
    let (rule, order) = (Rule::new(POINTS), spatial.chain.order());
    let (mut values, mut x, mut before) = (Vec::new(), 0.0, 0.0);
    let mut rotations = [0.0; 2];
    for (element, pair) in mesh.boundaries.windows(2).enumerate() {
        let last = usize::from(element + 2 == mesh.boundaries.len());
        for rank in 0..order + last {
            let place = pair[0] + spatial.chain.node_fraction(rank) * (pair[1] - pair[0]);
            x += rule.over(before, place).map(|(s, weight)| weight * planar_at(planar, at, s)[2]).sum::<f64>();
            before = place;
            let [y, rotation, _] = planar_at(planar, at, place);
            values.extend([x, y, 0.0]);
            values.extend(turned([rotation, 0.0, 0.0], ALONG_X));
            rotations[usize::from(place > 0.0)] = rotation;
        }
    }
    for (end, rotation) in spatial.chain.ends.iter().zip(rotations) {
        let own = if end.rotation == EndRotation::Angles { rotation } else { 0.0 };
        values.extend([own, 0.0, 0.0]);
    }
    State { mesh, values, force: at.force, history: None }
}

/// y of the axis, θ and x' at S, of a planar state.
fn planar_at(beam: &PlanarBeam, at: &State, place: f64) -> [f64; 3] {
    let ends = &at.mesh.boundaries;
    let element = ends.partition_point(|&end| end <= place).clamp(1, at.mesh.elements()) - 1;
    let local = 2.0 * (place - ends[element]) / (ends[element + 1] - ends[element]) - 1.0;
    let (values, section) = beam.chain.sample(beam.configuration(at), element, local);
    [values[beam.rotation - 1] + 0.5 * beam.height_at(place), values[beam.rotation], section.horizontal_slope]
}

// -- Equilibria of a strip in space whose grip is held at a roll, and those of them at which that takes no torque --
//
// With its roll held a strip is stable at the branch point as well: these equilibria are regular on either side of it,
// and for a roll of zero they are the planar path. The torque on the roll a is T(σ, a) = m(σ) a + O(a³) along the path
// σ, m the moment that rolls the grip by one. So T = 0 has two solutions: a = 0, and the branch, σ = σ* + O(a²).

/// Most solves until the torque is zero.
const MOST_SOLVES: usize = 14;
/// It is zero where what is left to go along the path is this share of the place.
const FOUND: f64 = 1e-13;
/// Where it does not come nearer than this share any more, that is round-off.
const ROUND_OFF: f64 = 1e-9;
/// Error of a solution, relative as in [`crate::solve::System::size`].
const FINE: f64 = 1e-12;

/// A strip whose grip is held at a roll, by a constraint along its path.
pub(super) struct RolledStrip<'p> {
    /// Of a grip whose roll is an unknown
    pub problem: &'p BeamProblem,
    /// Of the path constraint
    pub weights: Observables,
}

/// An equilibrium of it.
pub(super) struct Rolled {
    pub solution: Solution,
    /// What the grip exerts on the roll, nN·nm
    pub torque: f64,
    /// weights · observables
    pub target: f64,
}

impl RolledStrip<'_> {
    /// With the grip held at `roll` (rad), at `target` along the path.
    pub(crate) fn held(&self, start: State, roll: f64, target: f64, ws: &mut Workspace) -> Result<Rolled, SolveError> {
        let problem = self.problem.with_roll(Some(roll));
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 14, exact_slope: true };
        let solution = solve(&problem, start, &PathConstraint { weights: self.weights, target }, &options, ws)?;
        let torque = problem.spatial_grip(&solution.at).map_or(f64::NAN, |grip| grip.torque);
        Ok(Rolled { solution, torque, target })
    }

    /// The one next to `start` that takes no torque, by the secant rule; `slope`: dm/dσ.
    pub(crate) fn without_torque(
        &self,
        start: State,
        roll: f64,
        target: f64,
        slope: f64,
        ws: &mut Workspace,
    ) -> Result<Rolled, SolveError> {
        let problem = self.problem.with_roll(Some(roll));
        let mut found = self.held(start, roll, target, ws)?;
        let (mut slope, mut before) = (slope * roll, f64::INFINITY);
        for _ in 0..MOST_SOLVES {
            let ahead = -found.torque / slope;
            let share = (ahead / found.target).abs();
            if share <= FOUND || (share <= ROUND_OFF && share >= 0.5 * before) {
                return Ok(found);
            }
            if !ahead.is_finite() {
                break;
            }
            before = share;
            let next = self.held(found.solution.moved(&problem, ahead), roll, found.target + ahead, ws)?;
            // nearer than that the change of the torque is round-off
            slope = if share > ROUND_OFF { (next.torque - found.torque) / ahead } else { slope };
            found = next;
        }
        Err(SolveError::NotConverged { update: before, iterations: MOST_SOLVES })
    }
}
