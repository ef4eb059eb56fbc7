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
//! Newton's step is taken by blocks: first at fixed σ, then a = -g/(dg/dσ) along t. dg/dσ is a secant of the last two solves, or a
//! difference of g over a short way along t, which takes one more elimination; where a is next to nothing that of a neighbour serves.

use crate::solve::error::SolveError;
use crate::solve::newton::{FINE, NewtonOptions, Solution, slopes, solve};
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::Workspace;
use std::fmt;

/// Most solves until a limit point is located.
const MOST_SOLVES: usize = 8;
/// Solves after which it is taken as it stands, if it is close.
const ENOUGH: usize = 4;
/// A limit point is located when what is left is this share of the width; the rest is extrapolated, with an error of
/// its square.
const CLOSE: f64 = 1e-5;
/// The place of a limit point by secants may be wrong by this share of the width.
const CERTAIN: f64 = 1e-10;
/// Most that one step moves, as a share of the width: by secants, and by differences.
const NEAR_SECANT: f64 = 0.05;
const NEAR_DIFFERENCE: f64 = 0.1;
/// Step over which g is differenced, as a share of the width. The end of the step lies beside the path by its square, which
/// in a stiff strip, whose force is level at its peak, makes an error of 4e3 times this share; the round-off of g, 1e-12 of
/// the force, leaves six digits at an ordinary limit point.
const BESIDE: f64 = 1e-6;
/// Where no more than this share of the width is left, dg/dσ may be that of a neighbour.
const NOTHING: f64 = 1e-8;
/// The error of a neighbour's dg/dσ.
const NEIGHBOURLY: f64 = 0.2;

/// Second derivatives along the path, per unit of the constraint's target squared.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bends {
    /// d²u/dσ²
    pub displacement: f64,
    /// d²P/dσ²
    pub force: f64,
}

impl Bends {
    /// That of the quantity that turns.
    pub(crate) fn of(self, kind: LimitPointKind) -> f64 {
        match kind {
            LimitPointKind::Displacement => self.displacement,
            LimitPointKind::Load => self.force,
        }
    }

    /// The change of the slopes over a step.
    fn between(before: &Observables, here: &Observables, step: f64) -> Self {
        Self {
            displacement: (here.displacement - before.displacement) / step,
            force: (here.force - before.force) / step,
        }
    }
}

/// Where dg/dσ comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum BendRule {
    /// The secant through the last two solves; to begin with these, which are not trusted.
    Secant(Bends),
    /// A difference of g at each solve, or, close by, the dg/dσ of a limit point of nearly the same problem.
    Difference {
        /// dg/dσ of that limit point
        neighbour: Option<f64>,
    },
}

/// What is sought: a limit point of `kind` on a problem, with the place along the path told by `weights`.
#[derive(Clone, Copy)]
pub(crate) struct LimitPointSearch<'p> {
    /// The structure and its grip
    pub problem: &'p Problem,
    /// Weights of the constraint.
    pub weights: Observables,
    /// Of the displacement or of the force
    pub kind: LimitPointKind,
    /// Length, in the constraint's target, over which the path keeps its shape.
    pub width: f64,
}

/// A limit point on its mesh.
#[derive(Clone, Debug)]
pub(crate) struct FoundLimitPoint {
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
    /// Of the quantity that turns: negative at a maximum where the constraint's target grows along the path.
    pub bends: Bends,
    /// Whether dg/dσ was taken here, and not from a neighbour.
    pub measured: bool,
    /// How far Newton moved from the start: the largest of the solves, relative as in [`crate::solve::System::size`].
    pub correction: f64,
    /// Newton iterations.
    pub iterations: usize,
}

impl FoundLimitPoint {
    /// The configuration at the limit point.
    pub(crate) fn configuration(&self, problem: &Problem) -> State {
        self.solution.moved(problem, self.ahead)
    }
}

impl LimitPointSearch<'_> {
    /// The limit point next to `at`, on its mesh; `target` is the constraint's there.
    pub(crate) fn run(
        &self,
        mut at: State,
        mut target: f64,
        rule: BendRule,
        ws: &mut Workspace,
    ) -> Result<FoundLimitPoint, SolveError> {
        let options = NewtonOptions { tolerance: FINE, largest_update: 0.5, most_iterations: 10, exact_slope: true };
        let (mut ahead, mut iterations, mut correction) = (f64::INFINITY, 0, 0.0f64);
        let mut secant = if let BendRule::Secant(first) = rule { first } else { Bends::default() };
        let mut before: Option<(f64, Observables)> = None;
        for solves in 1..=MOST_SOLVES {
            let constraint = PathConstraint { weights: self.weights, target };
            let solution = solve(self.problem, at, &constraint, &options, ws)?;
            iterations += solution.iterations;
            correction = correction.max(solution.correction);
            let slope = self.kind.pick()(&solution.slope);
            let (bends, neighbour) = match rule {
                BendRule::Secant(_) => {
                    if let Some((step, slope)) = before {
                        secant = Bends::between(&slope, &solution.slope, step);
                    }
                    (secant, None)
                }
                BendRule::Difference { neighbour } => {
                    match neighbour.filter(|bend| (slope / bend).abs() <= NOTHING * self.width) {
                        Some(bend) => (Bends::default(), Some(bend)),
                        None => (self.difference(&solution, &constraint, ws)?, None),
                    }
                }
            };
            let bend = neighbour.unwrap_or(bends.of(self.kind));
            ahead = -slope / bend;
            if !ahead.is_finite() {
                break;
            }
            let uncertain = self.uncertain(ahead, rule, before.map(|(step, _)| step));
            // where round-off leaves no better, what is left counts as neglected
            let certain = uncertain <= CERTAIN * self.width
                || (uncertain.is_finite() && solves > ENOUGH)
                || matches!(rule, BendRule::Difference { .. });
            if ahead.abs() <= CLOSE * self.width && certain {
                let mut neglected = solution.slope.times(uncertain);
                neglected.displacement = neglected.displacement.abs() + bends.displacement.abs() * ahead * ahead;
                neglected.force = neglected.force.abs() + bends.force.abs() * ahead * ahead;
                if neighbour.is_some() {
                    let off = NEIGHBOURLY * ahead.abs();
                    neglected.displacement += off * solution.slope.displacement.abs();
                    neglected.force += off * solution.slope.force.abs();
                }
                let observables = extrapolated(&solution, ahead, bends);
                let measured = neighbour.is_none();
                let mut bends = bends;
                match self.kind {
                    LimitPointKind::Displacement => bends.displacement = bend,
                    LimitPointKind::Load => bends.force = bend,
                }
                return Ok(FoundLimitPoint {
                    solution,
                    ahead,
                    target,
                    observables,
                    neglected,
                    bends,
                    measured,
                    correction,
                    iterations,
                });
            }
            ahead = self.shortened(ahead, rule, before.is_none());
            before = Some((ahead, solution.slope));
            at = solution.moved(self.problem, ahead);
            target += ahead;
        }
        Err(SolveError::NotConverged { update: ahead / self.width, iterations })
    }

    /// How wrong `ahead` may be. What a difference neglects is taken to be as large as its own quadratic terms. A secant is that of the
    /// middle of the last step, and what it is wrong by there it is wrong by in `ahead`; the first one is an interpolant's and not trusted.
    fn uncertain(&self, ahead: f64, rule: BendRule, step: Option<f64>) -> f64 {
        match rule {
            BendRule::Difference { .. } => ahead * ahead / self.width,
            BendRule::Secant(_) => {
                step.map_or(f64::INFINITY, |step| ahead * (step.abs() + ahead.abs()) / self.width).abs()
            }
        }
    }

    /// The step to take; a first one by a secant is long enough for the next secant.
    fn shortened(&self, ahead: f64, rule: BendRule, first: bool) -> f64 {
        match rule {
            BendRule::Difference { .. } => ahead.clamp(-NEAR_DIFFERENCE * self.width, NEAR_DIFFERENCE * self.width),
            BendRule::Secant(_) => {
                let least = 10.0 * CLOSE * self.width;
                let ahead = if first && ahead.abs() < least { least.copysign(ahead) } else { ahead };
                ahead.clamp(-NEAR_SECANT * self.width, NEAR_SECANT * self.width)
            }
        }
    }

    fn difference(
        &self,
        solution: &Solution,
        constraint: &PathConstraint,
        ws: &mut Workspace,
    ) -> Result<Bends, SolveError> {
        let way = BESIDE * self.width;
        let (displacement, force) = slopes(self.problem, &solution.moved(self.problem, way), constraint, ws)?;
        Ok(Bends::between(&solution.slope, &Observables { displacement, force, ..Observables::default() }, way))
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
        roll: o.roll + ahead * s.roll,
    }
}

// -- Which quantity turns at a limit point --

/// Which quantity has a limit point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum LimitPointKind {
    /// du = 0
    Displacement,
    /// dP = 0
    Load,
}

impl LimitPointKind {
    /// The other quantity.
    pub(crate) fn other(self) -> Self {
        match self {
            Self::Displacement => Self::Load,
            Self::Load => Self::Displacement,
        }
    }

    /// The quantity.
    pub(crate) fn pick(self) -> fn(&Observables) -> f64 {
        match self {
            Self::Displacement => |o| o.displacement,
            Self::Load => |o| o.force,
        }
    }

    /// Negative eigenvalues of a solution with this quantity held.
    pub(crate) fn negative(self, solution: &Solution) -> usize {
        match self {
            Self::Displacement => solution.negative,
            Self::Load => solution.negative_load,
        }
    }
}

impl fmt::Display for LimitPointKind {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Displacement => "displacement",
            Self::Load => "force",
        })
    }
}
