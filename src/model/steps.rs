//! What the grip does before it pulls: a list of steps, each from the equilibrium to which the one before has led.
//!
//! A step moves one thing of the grip, its height, its place along the substrate or its rotation. Held meanwhile are the height,
//! and place and rotation as far as the scene's grip holds them; a place that a step has moved in a grip that is free there is let go
//! before the next step, and before the pull: the force on what is free falls to zero first. The equilibria are followed as a path in
//! what is moved; there is no time in it. A step ends at its amount, and not beyond a loss of stability, where a beam would jump.

use super::{Moved, PeelModel, Step};
use crate::solve::{
    BUNDLE, Beginning, Condition, Direction, Equilibrium, GripForces, Located, MOST_FIELDS, MOST_POINTS, NewtonOptions,
    Observables, Path, PathError, PathOptions, Problem, Solution, SolveError, Stretch, Turn, Workspace, locate, settle,
    solve,
};
use std::sync::Arc;
use std::time::Instant;

/// Why a step was not taken to its end.
#[derive(Debug, thiserror::Error)]
enum Trouble {
    #[error("finds no equilibrium to begin with: {0}")]
    Start(PathError),
    #[error("cannot be followed beyond {}: {why}", told(.at))]
    Path { at: Reached, why: PathError },
    #[error("comes to a turning point at {}, behind which the beam jumps", told(.at))]
    Turns { at: Reached },
    #[error("leads through the surface of the substrate, behind {}", told(.at))]
    Inside { at: Reached },
    #[error("comes to where equilibrium is no longer stable, behind {}: there the beam leaves its path", told(.at))]
    Unstable { at: Reached },
    #[error("is not at its end after {points} equilibria, at {}", told(.at))]
    Long { at: Reached, points: usize },
    #[error("finds no equilibrium at its end, behind {}: {why}", told(.at))]
    End { at: Reached, why: SolveError },
}

/// How far a step has come: in what it moves, nm or rad, with what the grip exerts there.
#[derive(Clone, Copy, Debug)]
struct Reached {
    amount: f64,
    unit: &'static str,
    forces: GripForces,
}

fn told(at: &Reached) -> String {
    let Reached { amount, unit, forces: GripForces { horizontal, vertical, moment } } = at;
    format!("{amount:.6} {unit} (H = {horizontal:.6} nN, V = {vertical:.6} nN, M = {moment:.6} nN nm)")
}

/// Elements on which steps are followed, over those of a short strip, and more for each break of an outline; their ends are found on
/// twice as many.
const SHORT: f64 = 10.0;
const A_BREAK: usize = 4;
/// How many times as many a law with corners takes.
const CORNERED: f64 = 5.0;
/// Most more that friction takes.
const MOST_SLIDING: f64 = 400.0;
/// Error of a prediction, over the gap, and of a solution on the way and at the end.
const STEP_TOLERANCE: f64 = 1e-2;
const ROUGH: f64 = 1e-9;
const FINE: f64 = 1e-11;
/// First step, over the scale of what moves and over the whole way.
const FIRST: f64 = 0.02;
const OF_WAY: f64 = 0.1;
/// Most equilibria of a step.
const MOST_EQUILIBRIA: usize = 500;
/// Parts of a stretch of the path in which its end is looked for.
const PARTS: usize = 64;
/// A force below this share of its scale is none.
const NONE: f64 = 1e-9;

/// Takes the steps of a model: its problem then begins where they have led, or nowhere, with the reason.
pub(super) fn take(model: &PeelModel, problem: &mut Problem, deadline: Option<Instant>) {
    if model.steps.is_empty() || matches!(problem.beginning, Beginning::Nowhere(_)) {
        return;
    }
    let pull = Hands::of(problem);
    let taken = Walk { elements: elements(model, problem), pull, first: None, deadline }.all(&model.steps, problem);
    pull.set(problem);
    if let Err(why) = taken {
        problem.beginning = Beginning::Nowhere(why);
    }
}

/// Elements on which steps are followed.
fn elements(model: &PeelModel, problem: &Problem) -> usize {
    if let Beginning::Settled(at) = &problem.beginning {
        return (at.ends.len() - 1) / 2;
    }
    let span = (model.length() / model.process_length()).asinh();
    let corners = if model.adhesion.attraction.corners() > 1.0 { CORNERED } else { 1.0 };
    let slides = model.sticking_length().map_or(0.0, |_| (model.length() / model.detail()).min(MOST_SLIDING));
    let elements = corners * (SHORT + span * span) + slides;
    (elements.ceil() as usize + A_BREAK * model.breaks().len()).next_multiple_of(BUNDLE)
}

/// What the grip moves and what it holds.
#[derive(Clone, Copy)]
struct Hands {
    driven: usize,
    direction: Direction,
    held: [bool; MOST_FIELDS + 1],
    turn: f64,
}

impl Hands {
    fn of(problem: &Problem) -> Self {
        Self { driven: problem.driven, direction: problem.direction, held: problem.held, turn: problem.turn }
    }

    fn set(self, problem: &mut Problem) {
        Self { driven: problem.driven, direction: problem.direction, held: problem.held, turn: problem.turn } = self;
    }
}

/// What the path of a step ends at.
#[derive(Clone, Copy)]
struct Goal {
    what: Turn,
    value: f64,
    /// First displacement on the way there.
    first: f64,
    unit: &'static str,
}

/// Steps under way.
struct Walk {
    elements: usize,
    /// What the grip does in the pull behind them.
    pull: Hands,
    /// Where they began.
    first: Option<Arc<Equilibrium>>,
    deadline: Option<Instant>,
}

impl Walk {
    fn all(mut self, steps: &[Step], problem: &mut Problem) -> Result<(), String> {
        let tried = |why: Trouble, what: String| format!("{what} {why}. Try a shorter step, or other steps before it");
        self.begin(problem).map_err(|why| tried(why, "the first of drive.steps".into()))?;
        for (index, step) in steps.iter().enumerate() {
            let named = || format!("step {} of drive.steps, \"{step}\",", index + 1);
            if let Some((moved, amount)) = step.motion() {
                self.take_hold(problem, moved).map_err(|why| tried(why, format!("letting go before {}", named())))?;
                let scale = problem.scale[problem.driven];
                let first = (FIRST * scale).min(OF_WAY * amount.abs()).copysign(amount);
                let unit = if moved == Moved::Rotation { "rad" } else { "nm" };
                let goal = Goal { what: Turn::Displacement, value: amount, first, unit };
                self.follow(problem, goal).map_err(|why| tried(why, named()))?;
            }
            if let (Beginning::Settled(at), Some(first)) = (&problem.beginning, &self.first) {
                let state = problem.grip_state(at, first);
                problem.steps.push(state);
            }
        }
        self.pull.set(problem);
        self.let_go(problem).map_err(|why| tried(why, "letting go before the pull".into()))
    }

    /// The equilibrium from which the first step goes.
    fn begin(&mut self, problem: &mut Problem) -> Result<(), Trouble> {
        let options = self.options(problem.scale[problem.driven]);
        let start = Path::new(problem, options).until(self.deadline).advance().map_err(Trouble::Start)?;
        let condition = Condition { weights: Observables::DISPLACEMENT, target: start.observables.displacement };
        self.lead(problem, &start, &condition)?;
        self.first = match &problem.beginning {
            Beginning::Settled(at) => Some(at.clone()),
            Beginning::AtRest | Beginning::Nowhere(_) => None,
        };
        Ok(())
    }

    /// Makes the grip move this and hold the rest, from the equilibrium where it is.
    fn take_hold(&self, problem: &mut Problem, moved: Moved) -> Result<(), Trouble> {
        let (height, rotation) = (self.pull.driven, problem.rotation);
        let across = problem.slot_of_x();
        let mut held = self.pull.held;
        let (driven, direction) = match moved {
            Moved::Height => (height, Direction::UP),
            // the height is then what is held across
            Moved::Place => (height, Direction { along: 1.0, up: 0.0 }),
            Moved::Rotation => (rotation, Direction::UP),
        };
        held[height] = moved == Moved::Rotation;
        held[rotation] &= moved != Moved::Rotation;
        held[across] |= moved == Moved::Place;
        Hands { driven, direction, held, turn: 0.0 }.set(problem);
        self.let_go(problem)
    }

    /// Lets the force on what the grip does not hold across fall to zero, with all else held.
    fn let_go(&self, problem: &mut Problem) -> Result<(), Trouble> {
        let (hands, across) = (Hands::of(problem), problem.slot_of_x());
        let Beginning::Settled(at) = problem.beginning.clone() else { return Ok(()) };
        if hands.held[across] || !problem.knows_x() {
            return Ok(());
        }
        let GripForces { horizontal, vertical, .. } = problem.grip_forces(&at);
        let Direction { along, up } = hands.direction;
        let (force, _) = hands.direction.turned(horizontal, vertical);
        if force.abs() < NONE * problem.force_scale {
            return Ok(());
        }
        let mut held = hands.held;
        // what is about to be moved as well, and the height across the way in which the place is let go
        held[hands.driven] = true;
        (held[across], held[self.pull.driven]) = (true, false);
        Hands { driven: self.pull.driven, direction: Direction { along: up, up: -along }, held, turn: 0.0 }
            .set(problem);
        let first = -(FIRST * problem.scale[problem.driven]).copysign(force);
        let done = self.follow(problem, Goal { what: Turn::Load, value: 0.0, first, unit: "nm" });
        hands.set(problem);
        done
    }

    fn options(&self, first: f64) -> PathOptions {
        PathOptions {
            elements: self.elements,
            step_tolerance: STEP_TOLERANCE,
            stride: 1.0,
            tolerance: ROUGH,
            prediction: MOST_POINTS,
            first_displacement: first,
        }
    }

    /// Follows the equilibria from where the problem begins to the goal, where it then begins.
    fn follow(&self, problem: &mut Problem, goal: Goal) -> Result<(), Trouble> {
        let end = self.path(problem, goal)?;
        let weights = goal.weights();
        self.lead(problem, &end, &Condition { weights, target: goal.value })
    }

    /// The solution at the goal, on the elements of the path there.
    fn path(&self, problem: &Problem, goal: Goal) -> Result<Solution, Trouble> {
        let mut path = Path::new(problem, self.options(goal.first)).until(self.deadline);
        let start = path.advance().map_err(Trouble::Start)?;
        let value = goal.what.pick();
        let onward = (goal.value - value(&start.observables)).signum();
        let is_there = |o: &Observables| (value(o) - goal.value) * onward >= 0.0;
        let mut before = start.clone();
        while path.points().len() < MOST_EQUILIBRIA {
            let here = path.advance().map_err(|why| Trouble::Path { at: goal.reached(problem, &before), why })?;
            if problem.nearest(&here.at) <= 0.0 {
                return Err(Trouble::Inside { at: goal.reached(problem, &before) });
            }
            let turned = here.slope.displacement * goal.first < 0.0;
            let is_lost = |s: &Solution| problem.conservative && s.negative > start.negative;
            if turned || is_there(&here.observables) || is_lost(&here) {
                let last = path.points().len() - 1;
                let stretch = Stretch::around(problem, path.points(), last - 1);
                let label = |part: usize| stretch.end() * part as f64 / PARTS as f64;
                let at = |label: f64| stretch.observable(value, 0.5 * stretch.end()).at(label).0;
                let part = (1..=PARTS).find(|&part| (at(label(part)) - goal.value) * onward >= 0.0);
                let Some(part) = part.or(is_there(&here.observables).then_some(PARTS)) else {
                    return Err(lost(problem, &stretch, goal, &before, turned));
                };
                let condition = Condition { weights: goal.weights(), target: goal.value };
                let guess = stretch.start(problem, label(part) - 0.5 * label(1), 4);
                let end = solve(problem, guess, &condition, &newton(ROUGH), &mut Workspace::default());
                let end = end.map_err(|why| match turned {
                    true => lost(problem, &stretch, goal, &before, turned),
                    false => Trouble::End { at: goal.reached(problem, &before), why },
                })?;
                return if is_lost(&end) { Err(lost(problem, &stretch, goal, &before, turned)) } else { Ok(end) };
            }
            before = here;
        }
        Err(Trouble::Long { at: goal.reached(problem, &before), points: MOST_EQUILIBRIA })
    }

    /// Lets the problem begin in a solution, on twice as many elements and a mesh that is fine at its front.
    fn lead(&self, problem: &mut Problem, end: &Solution, condition: &Condition) -> Result<(), Trouble> {
        let center = problem.centered(end.observables.front);
        let finer = problem.on_elements(&Equilibrium { center, ..end.at.clone() }, 2 * self.elements);
        let settled = settle(problem, finer, condition, &newton(FINE), &mut Workspace::default());
        let at = Reached { amount: end.observables.displacement, unit: "nm", forces: problem.grip_forces(&end.at) };
        problem.beginning = Beginning::Settled(Arc::new(settled.map_err(|why| Trouble::End { at, why })?.at));
        Ok(())
    }
}

impl Goal {
    fn weights(self) -> Observables {
        match self.what {
            Turn::Displacement => Observables::DISPLACEMENT,
            Turn::Load => Observables::FORCE,
        }
    }

    fn reached(self, problem: &Problem, solution: &Solution) -> Reached {
        let amount = solution.observables.displacement;
        Reached { amount, unit: self.unit, forces: problem.grip_forces(&solution.at) }
    }
}

/// Why a stretch that loses its stability does not lead to the goal: the displacement turns, or the path branches.
fn lost(problem: &Problem, stretch: &Stretch, goal: Goal, before: &Solution, turned: bool) -> Trouble {
    let whole = (0.0, stretch.end());
    let turn = |at: Located| {
        let reached = goal.reached(problem, &at.solution);
        Trouble::Turns { at: Reached { amount: at.observables.displacement, ..reached } }
    };
    let located =
        turned.then(|| locate(problem, stretch, Turn::Displacement, whole, None, &mut Workspace::default()).ok());
    match located.flatten() {
        Some(at) => turn(at),
        None => Trouble::Unstable { at: goal.reached(problem, before) },
    }
}

fn newton(tolerance: f64) -> NewtonOptions {
    NewtonOptions { tolerance, largest_update: 0.5, most_iterations: 20, exact_slope: false }
}
