//! The pull-off of a solid spatula: stable equilibria, one after the other, while its end face is moved up.
//!
//! Each is found by Newton's method from the tangent of the one before, and where that leads nowhere or to an unstable one, by gradient flow
//! at the displacement. Steps of 50 nm cost less than those of 5 nm, and have led to the same equilibria (`verification/solid-spatula.md`).
//! The spatula begins stress-free, which is no equilibrium: the root of its neck closes by a jump.

use crate::solid::spatula::solid_spatula::SolidSpatula;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution, solve};
use crate::solve::problem::Problem;
use crate::solve::relax::{Held, RelaxError, RelaxOptions, relax};
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::workspace::{ShouldStop, Workspace};
use std::sync::Arc;

/// An equilibrium of the pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidPullPoint {
    /// u of the end face from its stress-free height, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// dP/du, nN/nm
    pub slope: f64,
    /// S of the last station from the tip on that adheres, nm
    pub front: f64,
    /// Elastic energy and that of the adhesion, aJ
    pub energy: f64,
    /// Whether it was found by gradient flow: the contact may have jumped on the way to it
    pub jumped: bool,
    /// Factorisations that it took
    pub eliminations: usize,
}

/// Why a pull stopped.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SolidPullError {
    /// It does not come to rest.
    #[error("the spatula does not come to rest at u = {displacement:.4} nm: {cause}")]
    NotAtRest { displacement: f64, cause: RelaxError },
    /// No force was largest.
    #[error("the force rises up to u = {until:.4} nm: there is no peak before")]
    NoPeak { until: f64 },
    /// The largest force was not solved for.
    #[error("the largest force near u = {displacement:.4} nm was not located: {cause}")]
    NotLocated { displacement: f64, cause: SolveError },
}

/// A spatula that is pulled off.
pub struct SolidPull {
    spatula: Arc<SolidSpatula>,
    problem: Problem,
    here: Solution,
    points: Vec<SolidPullPoint>,
    should_stop: Option<ShouldStop>,
    ws: Workspace,
}

/// Newton's method from a tangent: the error wanted, the largest first update, the most iterations.
const NEWTON: NewtonOptions =
    NewtonOptions { tolerance: 1e-8, largest_update: 1.5, most_iterations: 14, exact_slope: true };
/// A step from which nothing relaxes is halved until it is this short, nm.
const SHORTEST: f64 = 0.1;
/// Most that a step of a relaxation moves, over the gap.
const RELAXING: f64 = 0.3;
/// A peak is left where the force has fallen by this share of it.
const FALLEN: f64 = 5e-3;
/// Most solutions that locate a peak, and what its slope is then, over P/u.
const MOST_LOOKS: usize = 12;
const LEVEL: f64 = 1e-6;

impl SolidPull {
    /// At rest with its end face at its stress-free height; `should_stop` is asked before each factorisation.
    ///
    /// # Errors
    /// It does not come to rest.
    pub fn new(spatula: Arc<SolidSpatula>, should_stop: Option<ShouldStop>) -> Result<Self, SolidPullError> {
        let start = spatula.at_rest();
        Self::from(spatula, start, 0.0, should_stop)
    }

    fn from(
        spatula: Arc<SolidSpatula>,
        start: State,
        displacement: f64,
        should_stop: Option<ShouldStop>,
    ) -> Result<Self, SolidPullError> {
        let problem = spatula.problem();
        let mut ws = Workspace::until(should_stop.clone());
        let (here, eliminations) = relaxed(&problem, start, displacement, &mut ws)?;
        let mut pull = Self { spatula, problem, here, points: Vec::new(), should_stop, ws };
        pull.keep(true, eliminations);
        Ok(pull)
    }

    /// A pull that goes on from here on another mesh of the body, with the same lines across: at rest there, at the same displacement.
    ///
    /// # Errors
    /// It does not come to rest.
    pub fn on(&self, spatula: Arc<SolidSpatula>) -> Result<Self, SolidPullError> {
        let values = self.spatula.transferred(&self.here.at.values, &spatula);
        let start = State { values, force: self.here.at.force, ..spatula.at_rest() };
        Self::from(spatula, start, self.here.observables.displacement, self.should_stop.clone())
    }

    /// Its equilibria so far.
    pub fn points(&self) -> &[SolidPullPoint] {
        &self.points
    }

    /// The last of them.
    pub fn here(&self) -> &SolidPullPoint {
        &self.points[self.points.len() - 1]
    }

    /// Its configuration there.
    pub fn state(&self) -> &State {
        &self.here.at
    }

    fn keep(&mut self, jumped: bool, eliminations: usize) {
        let point = self.point(&self.here, jumped, eliminations);
        self.points.push(point);
    }

    fn point(&self, solution: &Solution, jumped: bool, eliminations: usize) -> SolidPullPoint {
        SolidPullPoint {
            displacement: solution.observables.displacement,
            force: solution.observables.force,
            slope: solution.slope.force,
            front: self.spatula.front(&solution.at.values),
            energy: solution.energy,
            jumped,
            eliminations,
        }
    }

    /// Moves the end face to u in steps of at most `step`, both in nm.
    ///
    /// # Errors
    /// It does not come to rest; what was found before is kept.
    pub fn to(&mut self, u: f64, step: f64) -> Result<&SolidPullPoint, SolidPullError> {
        let from = self.here().displacement;
        let steps = ((u - from).abs() / step).ceil().max(1.0) as usize;
        for k in 1..=steps {
            let next = if k == steps { u } else { from + (u - from) * k as f64 / steps as f64 };
            self.step(next)?;
        }
        Ok(self.here())
    }

    fn step(&mut self, u: f64) -> Result<(), SolidPullError> {
        let ahead = u - self.here().displacement;
        let start = self.here.moved(&self.problem, ahead);
        let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: u };
        let is_admissible = self.problem.system.is_admissible(&start);
        let direct = is_admissible
            .then(|| solve(&self.problem, start.clone(), &constraint, &NEWTON, &mut self.ws).ok())
            .flatten()
            .filter(|found| found.negative == 0);
        if let Some(found) = direct {
            let iterations = found.iterations;
            self.here = found;
            self.keep(false, iterations);
            return Ok(());
        }
        // a tangent may lead into the ground: then the end face alone is moved
        let by_tangent =
            is_admissible && self.energy(&start) < self.energy(&self.problem.moved(self.here.at.clone(), ahead));
        let start = if by_tangent { start } else { self.here.at.clone() };
        let (here, eliminations) = match relaxed(&self.problem, start, u, &mut self.ws) {
            Ok(found) => found,
            Err(SolidPullError::NotAtRest { cause: RelaxError::Stuck { .. }, .. }) if ahead.abs() > SHORTEST => {
                self.step(u - 0.5 * ahead)?;
                return self.step(u);
            }
            Err(error) => return Err(error),
        };
        self.here = here;
        self.keep(true, eliminations);
        Ok(())
    }

    /// Π of a configuration, aJ; infinite where it has none.
    fn energy(&self, at: &State) -> f64 {
        let energy = self.problem.system.evaluate(at, &vec![0.0; at.values.len()]).0.energy;
        if energy.is_finite() { energy } else { f64::INFINITY }
    }

    /// Pulls on in steps of `step` until the force has fallen behind its largest, and solves for that: where dP/du is zero, or, where the
    /// contact jumps next, the last equilibrium before. Lengths in nm.
    ///
    /// # Errors
    /// It does not come to rest; the force does not fall before u = `until`.
    pub fn peak(&mut self, step: f64, until: f64) -> Result<SolidPullPoint, SolidPullError> {
        let mut largest = (*self.here(), self.here.clone());
        let mut next: Option<(SolidPullPoint, Solution)> = None;
        loop {
            let u = self.here().displacement + step;
            if u > until {
                return Err(SolidPullError::NoPeak { until });
            }
            self.step(u)?;
            let own = (*self.here(), self.here.clone());
            if own.0.force > largest.0.force {
                (largest, next) = (own, None);
            } else {
                next = next.or_else(|| Some(own.clone()));
                if own.0.force < (1.0 - FALLEN) * largest.0.force {
                    break;
                }
            }
        }
        let index = self.points.iter().rposition(|point| *point == largest.0).unwrap_or(0);
        let Some(behind) = next else { return Ok(largest.0) };
        let rises = largest.0.slope > 0.0;
        if rises && behind.0.jumped {
            return Ok(largest.0);
        }
        let (from, to) = if rises {
            (largest.0, behind.0)
        } else if index > 0 && !largest.0.jumped {
            (self.points[index - 1], largest.0)
        } else {
            return Ok(largest.0);
        };
        self.located(&largest.1, from, to)
    }

    /// Where dP/du is zero between two points, by the Illinois rule, from a solution next to it.
    fn located(
        &mut self,
        near: &Solution,
        from: SolidPullPoint,
        to: SolidPullPoint,
    ) -> Result<SolidPullPoint, SolidPullError> {
        let (mut left, mut right) = ((from.displacement, from.slope), (to.displacement, to.slope));
        let level = LEVEL * from.force / from.displacement;
        let mut best: Option<SolidPullPoint> = None;
        for _ in 0..MOST_LOOKS {
            let u = left.0 - left.1 * (right.0 - left.0) / (right.1 - left.1);
            let start = near.moved(&self.problem, u - near.observables.displacement);
            let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: u };
            let found = solve(&self.problem, start, &constraint, &NEWTON, &mut self.ws)
                .map_err(|cause| SolidPullError::NotLocated { displacement: u, cause })?;
            let slope = found.slope.force;
            best = Some(self.point(&found, false, found.iterations));
            if slope.abs() < level {
                break;
            }
            if slope > 0.0 {
                (left, right.1) = ((u, slope), if left.0 == from.displacement { right.1 } else { 0.5 * right.1 });
            } else {
                (right, left.1) = ((u, slope), if right.0 == to.displacement { left.1 } else { 0.5 * left.1 });
            }
        }
        Ok(best.filter(|best| best.force >= from.force.max(to.force)).unwrap_or(from))
    }
}

/// The stable equilibrium to which the spatula relaxes at this displacement, and the factorisations that it took.
fn relaxed(
    problem: &Problem,
    start: State,
    displacement: f64,
    ws: &mut Workspace,
) -> Result<(Solution, usize), SolidPullError> {
    let relaxed = relax(problem, start, Held::Displacement(displacement), &RelaxOptions::by(RELAXING), ws);
    let relaxed = relaxed.map_err(|cause| SolidPullError::NotAtRest { displacement, cause })?;
    Ok((relaxed.solution, relaxed.eliminations))
}
