//! The tangent of a problem, factorised once and solved for any number of right-hand sides, also transposed.
//!
//! With the unknowns q and the force P, the residual R, the drive's direction e and a path constraint c(q, P) = σ, it is
//!
//!   [ K   -e  ] [ dq ]   [ r ]
//!   [ c_q c_P ] [ dP ] = [ s ],
//!
//! with the rows of what the grip holds replaced by dq = 0. The transpose gives the multipliers of all equations for the derivatives of
//! one functional: its change with any parameter p of the residual is then -λ·∂R/∂p, whatever the number of parameters.

use super::error::SolveError;
use super::frontal::grip_block::GripBlock;
use super::newton::factorised;
use super::problem::Problem;
use super::state::{PathConstraint, State};
use super::system::{Coefficients, INTERFACE};
use super::workspace::Workspace;

/// A factorised tangent; the factors of the system stay in the workspace.
pub struct Tangents<'p> {
    problem: &'p Problem,
    block: GripBlock<'p>,
    /// c_q, which the transpose needs.
    gradient: Vec<f64>,
    /// The smallest pivot of the system, without its sign.
    pub least_pivot: f64,
    /// Negative eigenvalues with the displacement held, and with the force held.
    pub negative: (usize, usize),
}

/// A solution of the bordered system: of the unknowns, and of the force or of the path constraint.
#[derive(Clone, Debug, PartialEq)]
pub struct Bordered {
    /// Of the unknowns, in their order
    pub direction: Vec<f64>,
    /// Of the force, nN, or of the path constraint
    pub last: f64,
}

impl<'p> Tangents<'p> {
    /// Factorises the tangent at a state.
    pub fn new(
        problem: &'p Problem,
        at: &State,
        constraint: &PathConstraint,
        ws: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let (root, block) = factorised(problem, at, constraint, Coefficients::STATIC, ws)?;
        Ok(Self {
            gradient: problem.system.gradient(at, constraint.weights.monitors),
            negative: block.inertia(root.negative),
            least_pivot: root.least_pivot,
            problem,
            block,
        })
    }

    /// dq and dP for a right-hand side r (by the unknowns) and s.
    pub fn solve(&self, right: &Bordered, ws: &Workspace) -> Result<Bordered, SolveError> {
        let system = &*self.problem.system;
        let mut direction = right.direction.clone();
        let reduced = system.reduce(ws, &mut direction, false);
        // what elimination takes off the constraint's row is the gradient times what is inside, with the interface held
        let mut inside = direction.clone();
        system.substitute(ws, &[0.0; INTERFACE], &mut inside, false);
        let taken: f64 = self.gradient.iter().zip(&inside).map(|(g, q)| g * q).sum();
        let step = self.block.solve_right(&reduced, right.last - taken)?;
        system.substitute(ws, &step.interface, &mut direction, false);
        Ok(Bordered { direction, last: step.force })
    }

    /// Multipliers λ of the residual and of the path constraint, for the derivatives of a functional by the unknowns and by the force.
    pub fn solve_transposed(&self, right: &Bordered, ws: &Workspace) -> Result<Bordered, SolveError> {
        let system = &*self.problem.system;
        let reduced = system.reduce(ws, &mut right.direction.clone(), true);
        let (interface, constraint) = self.block.solve_transposed(&reduced, right.last)?;
        let mut direction: Vec<f64> =
            right.direction.iter().zip(&self.gradient).map(|(r, g)| r - constraint * g).collect();
        system.reduce(ws, &mut direction, true);
        system.substitute(ws, &interface, &mut direction, true);
        Ok(Bordered { direction, last: constraint })
    }
}
