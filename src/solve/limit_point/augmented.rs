//! A limit point of the path on one mesh, as the regular solution of an augmented system.
//!
//! At a limit point of the force the tangent K of equilibrium F(x, P) = 0 is singular with the force held, at one of the
//! displacement with the displacement held. Bordered by a constraint c·(x, P) = σ that runs along the path it is regular,
//! and what it gives for the right-hand side (0, 1) is the tangent t of the path. By Cramer's rule its component for the
//! force, or for the displacement, is
//!
//!   g = det K / det [K bordered],
//!
//! so that F = 0, g = 0 is a regular system for the limit point (minimally augmented), whether K is symmetric or not.
//! Newton's step is taken by blocks: first at fixed σ, then a = -g/(dg/dσ) along t. dg/dσ is a difference of g over a short
//! way along t, which takes one more elimination; where a is next to nothing that of a neighbour serves.

use super::LimitPointKind;
use crate::solve::{
    NewtonOptions, Observables, PathConstraint, Problem, Solution, SolveError, State, Workspace, slopes, solve,
};

/// Most solves until a limit point is located.
const MOST_SOLVES: usize = 8;
/// A limit point is located when what is left is this share of the width; the rest is extrapolated, with an error of
/// its square.
const CLOSE: f64 = 1e-5;
/// Most that one step moves, as a share of the width.
const NEAR: f64 = 0.1;
/// Way over which g is differenced, as a share of the width. The end of the way lies beside the path by its square, which
/// in a stiff strip, whose force is level at its peak, makes an error of 4e3 times this share; the round-off of g, 1e-12 of
/// the force, leaves six digits at an ordinary limit point.
const BESIDE: f64 = 1e-6;
/// Where no more than this share of the width is left, dg/dσ may be that of a neighbour.
const NOTHING: f64 = 1e-8;
/// The error of a neighbour's dg/dσ.
const NEIGHBOURLY: f64 = 0.2;
/// Error of a solution, relative as in [`crate::solve::System::size`].
const FINE: f64 = 1e-12;

/// Second derivatives along the path, per unit of the constraint's target squared.
#[derive(Clone, Copy, Default)]
struct Bends {
    /// d²u/dσ²
    displacement: f64,
    /// d²P/dσ²
    force: f64,
}

/// What is sought: a limit point of `turn` on a problem, with the place along the path given by `weights`.
#[derive(Clone, Copy)]
pub struct FoldSearch<'p> {
    pub problem: &'p Problem,
    /// Weights of the constraint.
    pub weights: Observables,
    pub turn: LimitPointKind,
    /// Length, in the constraint's target, over which the path keeps its shape.
    pub width: f64,
}

/// A limit point on its mesh.
#[derive(Clone, Debug)]
pub struct Fold {
    /// The solution next to it.
    pub solution: Solution,
    /// From there to the limit point, in the constraint's target.
    pub ahead: f64,
    /// The constraint's target at the solution.
    pub target: f64,
    /// At the limit point.
    pub observables: Observables,
    /// Size of what is neglected in displacement and force.
    pub neglected: Observables,
    /// dg/dσ: negative at a maximum where the constraint's target grows along the path.
    pub bend: f64,
    /// Whether dg/dσ was taken here, and not from a neighbour.
    pub measured: bool,
    /// How far Newton moved from the start: the largest of the solves, relative as in [`crate::solve::System::size`].
    pub correction: f64,
    /// Newton iterations.
    pub iterations: usize,
}

impl Fold {
    /// The configuration at the limit point.
    pub fn configuration(&self, problem: &Problem) -> State {
        self.solution.moved(problem, self.ahead)
    }
}

impl FoldSearch<'_> {
    /// The limit point next to `at`, on its mesh; `target` is the constraint's there, `neighbour` is dg/dσ at a turning
    /// point near by, of nearly the same problem.
    pub fn run(
        &self,
        mut at: State,
        mut target: f64,
        neighbour: Option<f64>,
        ws: &mut Workspace,
    ) -> Result<Fold, SolveError> {
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 10, exact_slope: true };
        let (mut ahead, mut iterations, mut correction) = (f64::INFINITY, 0, 0.0f64);
        for _ in 0..MOST_SOLVES {
            let constraint = PathConstraint { weights: self.weights, target };
            let solution = solve(self.problem, at, &constraint, &options, ws)?;
            iterations += solution.iterations;
            correction = correction.max(solution.correction);
            let slope = self.turn.pick()(&solution.slope);
            let taken_over = neighbour.filter(|bend| (slope / bend).abs() <= NOTHING * self.width);
            let bends = if taken_over.is_some() { Bends::default() } else { self.bends(&solution, &constraint, ws)? };
            let bend = taken_over.unwrap_or(match self.turn {
                LimitPointKind::Displacement => bends.displacement,
                LimitPointKind::Load => bends.force,
            });
            ahead = -slope / bend;
            if !ahead.is_finite() {
                break;
            }
            if ahead.abs() <= CLOSE * self.width {
                let observables = extrapolated(&solution, ahead, bends);
                // what the extrapolation neglects is taken to be as large as its own quadratic terms
                let mut neglected = solution.slope.times(ahead * ahead / self.width);
                neglected.displacement = neglected.displacement.abs() + bends.displacement.abs() * ahead * ahead;
                neglected.force = neglected.force.abs() + bends.force.abs() * ahead * ahead;
                let measured = taken_over.is_none();
                if !measured {
                    let off = NEIGHBOURLY * ahead.abs();
                    neglected.displacement += off * solution.slope.displacement.abs();
                    neglected.force += off * solution.slope.force.abs();
                }
                return Ok(Fold {
                    solution,
                    ahead,
                    target,
                    observables,
                    neglected,
                    bend,
                    measured,
                    correction,
                    iterations,
                });
            }
            ahead = ahead.clamp(-NEAR * self.width, NEAR * self.width);
            at = solution.moved(self.problem, ahead);
            target += ahead;
        }
        Err(SolveError::NotConverged { update: ahead / self.width, iterations })
    }

    fn bends(&self, solution: &Solution, constraint: &PathConstraint, ws: &mut Workspace) -> Result<Bends, SolveError> {
        let way = BESIDE * self.width;
        let (displacement, force) = slopes(self.problem, &solution.moved(self.problem, way), constraint, ws)?;
        Ok(Bends {
            displacement: (displacement - solution.slope.displacement) / way,
            force: (force - solution.slope.force) / way,
        })
    }
}

/// The observables a little ahead of a solution; second derivatives only of displacement and force.
fn extrapolated(solution: &Solution, ahead: f64, bends: Bends) -> Observables {
    let (o, s) = (&solution.observables, &solution.slope);
    Observables {
        monitors: std::array::from_fn(|k| o.monitors[k] + ahead * s.monitors[k]),
        displacement: o.displacement + ahead * (s.displacement + 0.5 * ahead * bends.displacement),
        force: o.force + ahead * (s.force + 0.5 * ahead * bends.force),
        recorded: o.recorded + ahead * s.recorded,
    }
}
