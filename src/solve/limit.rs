//! Turning points of the path, located and not sampled, with a bound on their error from twice the elements.

use super::stretch::Stretch;
use super::{Condition, Equilibrium, NewtonOptions, Observables, Problem, Solution, SolveError, Workspace, solve};
use std::sync::Arc;

/// Which quantity has a turning point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// du = 0
    Displacement,
    /// dP = 0
    Load,
}

impl Turn {
    /// The quantity.
    pub fn pick(self) -> fn(&Observables) -> f64 {
        match self {
            Self::Displacement => |o| o.displacement,
            Self::Load => |o| o.force,
        }
    }
}

/// A point of the path found by a condition on it.
#[derive(Clone, Debug)]
pub struct Located {
    /// The solution next to it.
    pub solution: Arc<Solution>,
    /// The observables there.
    pub observables: Observables,
    /// Their difference to those on twice the elements.
    pub difference: Observables,
    /// Newton iterations it took, on both meshes.
    pub iterations: usize,
}

/// Most solves until a turning point is located.
const MOST_SOLVES: usize = 12;
/// A turning point is located when what is left is this share of the step it lies in; the rest is extrapolated, with an
/// error of its square.
const CLOSE: f64 = 1e-5;

fn options() -> NewtonOptions {
    NewtonOptions { tolerance: 1e-12, largest_update: 0.5, most_iterations: 10 }
}

/// A further solution on a stretch, at the label `at`.
pub fn solve_on(
    problem: &Problem,
    stretch: &Stretch,
    at: f64,
    work: &mut Workspace,
) -> Result<Arc<Solution>, SolveError> {
    let condition = Condition { weights: stretch.weights, target: stretch.target(at) };
    solve(problem, stretch.start(problem, at), &condition, &options(), work).map(Arc::new)
}

/// Locates the turning point of `turn` between the labels `from` and `to`, at which its slope differs in sign.
pub fn locate(
    problem: &Problem,
    mut stretch: Stretch,
    turn: Turn,
    (from, to): (f64, f64),
    work: &mut Workspace,
) -> Result<Located, SolveError> {
    let width = to - from;
    let (mut low, mut high) = (from, to);
    let rising = stretch.observable(turn.pick(), from).at(from).1 < 0.0;
    let mut iterations = 0;
    for _ in 0..MOST_SOLVES {
        let guess = stretch.observable(turn.pick(), 0.5 * (low + high)).turning_point(low, high);
        let solution = solve_on(problem, &stretch, guess, work)?;
        iterations += solution.iterations;
        let label = stretch.insert(solution.clone());
        let (_, slope, bend) = stretch.observable(turn.pick(), label).at(label);
        if (slope < 0.0) == rising { low = label } else { high = label }
        let left = -slope / bend;
        if left.abs() <= CLOSE * width {
            let ahead = label + left;
            let coarse = observables_at(&stretch, ahead, label);
            let bends = Bends::of(&stretch, label);
            let (fine, more) = on_twice_the_elements(problem, &solution, &stretch, ahead, turn, &bends, work)?;
            return Ok(Located {
                solution,
                observables: coarse,
                difference: fine.since(&coarse),
                iterations: iterations + more,
            });
        }
    }
    Err(SolveError::NotConverged { update: (high - low) / width, iterations })
}

/// All observables at a label, from the interpolants around `near`.
fn observables_at(stretch: &Stretch, at: f64, near: f64) -> Observables {
    let value = |pick: fn(&Observables) -> f64| stretch.observable(pick, near).at(at).0;
    Observables {
        front: value(|o| o.front),
        displacement: value(|o| o.displacement),
        tip_rotation: value(|o| o.tip_rotation),
        force: value(|o| o.force),
        grip_rotation: value(|o| o.grip_rotation),
    }
}

/// Second derivatives along the path of what is reported.
struct Bends {
    displacement: f64,
    force: f64,
}

impl Bends {
    fn of(stretch: &Stretch, at: f64) -> Self {
        let bend = |turn: Turn| stretch.observable(turn.pick(), at).at(at).2;
        Self { displacement: bend(Turn::Displacement), force: bend(Turn::Load) }
    }
}

/// The same turning point on twice the elements, and the iterations it took.
fn on_twice_the_elements(
    problem: &Problem,
    coarse: &Solution,
    stretch: &Stretch,
    at: f64,
    turn: Turn,
    bends: &Bends,
    work: &mut Workspace,
) -> Result<(Observables, usize), SolveError> {
    let mut start = refined(problem, &coarse.at);
    let mut target = stretch.target(at);
    let mut iterations = 0;
    let bend = match turn {
        Turn::Displacement => bends.displacement,
        Turn::Load => bends.force,
    };
    for _ in 0..4 {
        let fine = solve(problem, start, &Condition { weights: stretch.weights, target }, &options(), work)?;
        iterations += fine.iterations;
        let left = -turn.pick()(&fine.slope) / bend;
        if !left.is_finite() || left.abs() > stretch.end() {
            break;
        }
        if left.abs() <= 10.0 * CLOSE * stretch.end() {
            let mut o = fine.observables;
            o.displacement += left * (fine.slope.displacement + 0.5 * left * bends.displacement);
            o.force += left * (fine.slope.force + 0.5 * left * bends.force);
            o.grip_rotation += left * fine.slope.grip_rotation;
            return Ok((o, iterations));
        }
        target += left;
        start = fine.at;
    }
    Err(SolveError::TurnNotConfirmed)
}

/// Difference to the solution on twice the elements at the same displacement.
pub fn difference_on_twice_the_elements(
    problem: &Problem,
    coarse: &Solution,
    work: &mut Workspace,
) -> Result<Observables, SolveError> {
    let weights = Observables { displacement: 1.0, ..Observables::default() };
    let condition = Condition { weights, target: coarse.observables.displacement };
    let fine = solve(problem, refined(problem, &coarse.at), &condition, &options(), work)?;
    Ok(fine.observables.since(&coarse.observables))
}

/// The configuration on elements cut in two at half the mesh coordinate.
fn refined(problem: &Problem, at: &Equilibrium) -> Equilibrium {
    let elements = at.ends.len() - 1;
    let mut ends = problem.ends(at.center, 2 * elements);
    for (e, &end) in at.ends.iter().enumerate() {
        ends[2 * e] = end;
    }
    let cuts: Vec<f64> = (0..elements)
        .map(|e| 2.0 * (ends[2 * e + 1] - ends[2 * e]) / (ends[2 * e + 2] - ends[2 * e]) - 1.0)
        .collect();
    Equilibrium {
        state: problem.chain.refine(&at.state, &cuts),
        ends,
        center: at.center,
        border: at.border,
        force: at.force,
    }
}
