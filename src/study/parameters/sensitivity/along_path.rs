//! Equilibria beside a limit point or a plateau: how what is differentiated changes along the path, and how the path bends there.

use super::differences::{ALONG, Change, Estimate, Stencil, along_path, change_along_path};
use super::point::{Adjoint, Held, solved, turned};
use crate::model::problem::beam_problem::BeamProblem;
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::solve::state::State;
use crate::solve::workspace::Workspace;
use crate::study::peel::along_path::work::power;

/// How far apart the equilibria beside a limit point are, over the distance in which the path is smooth: a sixth-order difference over them misses
/// the sixth power of four times that.
const APART: f64 = 4e-3;
/// How much nearer they are where they are not found, and how often that is tried.
const NEARER: f64 = 0.25;
const MOST_TRIES: usize = 4;
/// Most that the logarithm of the displacement of a plateau is taken to change per unit of a parameter's coordinate. Of a strip 50 nm long pulled at 60
/// degrees by a grip that holds it, it is 4.5 for the angle.
const PLATEAU_MOVES: f64 = 16.0;

/// An equilibrium at a limit point, or at a plateau, with what the derivatives there need.
pub(super) struct AtPoint {
    pub adjoint: Adjoint,
    /// dΠ/du, nN
    pub power: f64,
    /// What is held, nm or nN, and the slope of what is not
    at: [f64; 2],
    sides: Option<Sides>,
}

struct Sides {
    adjoints: [Adjoint; 6],
    slopes: [f64; 6],
    step: f64,
}

/// What turns at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    /// What is not held
    Limit,
    /// Nothing: the point is where it is
    None,
}

impl AtPoint {
    /// Next to an equilibrium `start`, where what is held takes the value `target`, or near there where the path turns. `smooth` is how far away the next
    /// limit point or zero is, of what is held, where the path is to be looked at beside it.
    pub(crate) fn new(
        problem: &BeamProblem,
        start: State,
        (held, target, turn): (Held, f64, Turn),
        smooth: Option<f64>,
        ws: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let (center, target) = match turn {
            Turn::Limit => turned(problem, start, held, target, ws)?,
            Turn::None => (solved(problem, start, held, target, ws)?, target),
        };
        let sides = smooth.map(|smooth| Sides::near(problem, &center, held, target, smooth, ws)).transpose()?;
        let adjoint = Adjoint::new(problem, &center.at, held, ws)?;
        Ok(Self { adjoint, power: power(problem, &center), at: [target, held.slope(&center)], sides })
    }

    /// How a limit point moves along the path: the change of what is held there, -f_xs/f_ss. NaN where that was not asked for.
    pub(crate) fn moved(&self, stencil: &Stencil) -> Estimate {
        let Some(sides) = &self.sides else { return Estimate::NAN };
        let bend = along_path(sides.slopes, sides.step);
        change_along_path(sides.changes(stencil), sides.step).over(bend).times(-1.0)
    }

    /// The change of the force of a plateau: with the displacement held. The plateau moves besides, and with it the force along its slope; as where it
    /// lies is known little, that counts as an error.
    pub(crate) fn at_plateau(&self, stencil: &Stencil) -> Estimate {
        let [displacement, slope] = self.at;
        let moves = PLATEAU_MOVES * slope * displacement;
        stencil.force(&self.adjoint).estimate().plus(Estimate { value: 0.0, error: moves.abs() })
    }
}

impl Sides {
    /// Where the path bends faster than limit points tell, nearer.
    fn near(
        problem: &BeamProblem,
        center: &Solution,
        held: Held,
        target: f64,
        smooth: f64,
        ws: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let mut step = APART * smooth;
        for _ in 0..MOST_TRIES {
            if let Ok(sides) = Self::beside(problem, center, held, target, step, ws) {
                return Ok(sides);
            }
            step *= NEARER;
        }
        Self::beside(problem, center, held, target, step, ws)
    }

    fn beside(
        problem: &BeamProblem,
        center: &Solution,
        held: Held,
        target: f64,
        step: f64,
        ws: &mut Workspace,
    ) -> Result<Self, SolveError> {
        let mut one = |k: f64| {
            let found = solved(problem, center.moved(problem, k * step), held, target + k * step, ws)?;
            Ok::<_, SolveError>((Adjoint::new(problem, &found.at, held, ws)?, held.slope(&found)))
        };
        let [a, b, c, d, e, f] = ALONG;
        let found = [one(a)?, one(b)?, one(c)?, one(d)?, one(e)?, one(f)?];
        let slopes = std::array::from_fn(|k| found[k].1);
        Ok(Self { adjoints: found.map(|(adjoint, _)| adjoint), slopes, step })
    }

    fn changes(&self, stencil: &Stencil) -> [Change; 6] {
        std::array::from_fn(|k| stencil.force(&self.adjoints[k]))
    }
}
