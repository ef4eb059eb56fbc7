//! Newton's method for one equilibrium under one condition that picks it from the path.

use super::grip::GripBlock;
use super::{Equilibrium, PathRow, Problem, SolveError, Workspace};
use crate::beam::ElementEnergy;
use serde::{Deserialize, Serialize};

/// The numbers that tell where on the path an equilibrium lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Observables {
    /// S of the peeling front: adhesion energy over that of a unit length at rest, nm; zero where nothing adheres
    pub front: f64,
    /// u of the driven field at the grip, nm (rad where that is the rotation); of the far end of its spring where it has one
    pub displacement: f64,
    /// θ(0) of the left end, rad
    pub tip_rotation: f64,
    /// P that does work on u, nN (nN·nm where the rotation is driven: the end moment)
    pub force: f64,
    /// θ(L) at the grip, rad; no condition weighs it
    pub grip_rotation: f64,
}

impl Observables {
    /// Weights of a held displacement.
    pub const DISPLACEMENT: Self =
        Self { front: 0.0, displacement: 1.0, tip_rotation: 0.0, force: 0.0, grip_rotation: 0.0 };
    /// Weights of a held force.
    pub const FORCE: Self = Self { front: 0.0, displacement: 0.0, tip_rotation: 0.0, force: 1.0, grip_rotation: 0.0 };

    /// Sum of the products of what a condition can weigh.
    pub fn dot(&self, other: &Self) -> f64 {
        self.front * other.front
            + self.displacement * other.displacement
            + self.tip_rotation * other.tip_rotation
            + self.force * other.force
    }

    /// Whether every component is a finite number.
    pub fn is_finite(&self) -> bool {
        let Self { front, displacement, tip_rotation, force, grip_rotation } = *self;
        [front, displacement, tip_rotation, force, grip_rotation].iter().all(|number| number.is_finite())
    }

    /// Each component times a number.
    pub fn times(&self, factor: f64) -> Self {
        Self {
            front: factor * self.front,
            displacement: factor * self.displacement,
            tip_rotation: factor * self.tip_rotation,
            force: factor * self.force,
            grip_rotation: factor * self.grip_rotation,
        }
    }

    /// The sum with another.
    pub fn plus(&self, other: &Self) -> Self {
        self.since(&other.times(-1.0))
    }

    /// The difference to an earlier point.
    pub fn since(&self, earlier: &Self) -> Self {
        Self {
            front: self.front - earlier.front,
            displacement: self.displacement - earlier.displacement,
            tip_rotation: self.tip_rotation - earlier.tip_rotation,
            force: self.force - earlier.force,
            grip_rotation: self.grip_rotation - earlier.grip_rotation,
        }
    }
}

/// weights · observables = target: displacement control, force control, or a step along the path.
#[derive(Clone, Copy, Debug)]
pub struct Condition {
    pub weights: Observables,
    pub target: f64,
}

/// When Newton's iteration ends.
#[derive(Clone, Copy, Debug)]
pub struct NewtonOptions {
    /// Size of the error wanted, relative as in [`Problem::relative_size`].
    pub tolerance: f64,
    /// A first update above this is refused: the start was too far away.
    pub largest_update: f64,
    pub most_iterations: usize,
    /// Whether slopes are taken at the solution itself. Otherwise they come from Newton's last matrix, one update back,
    /// at no cost, with an error of the size of that update.
    pub exact_slope: bool,
}

/// A converged equilibrium with all that is known about it there.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Solution {
    pub at: Equilibrium,
    /// The state on a mesh whose moving focus lies exactly at the front: what predictions combine. On the mesh of `at` the
    /// focus is where the front was predicted, and that prediction's error would be noise.
    pub aligned: Vec<f64>,
    pub observables: Observables,
    /// Change of the observables along the path, per unit of the condition's target.
    pub slope: Observables,
    /// Change of the configuration on its mesh, likewise.
    pub tangent: Tangent,
    pub energy: ElementEnergy,
    /// Negative eigenvalues with the displacement held, and with the force held.
    pub negative: usize,
    pub negative_load: usize,
    pub iterations: usize,
    /// Distance from the start to the solution, relative as in [`Problem::relative_size`].
    pub correction: f64,
}

/// Longest step of Newton's method from a start that is no equilibrium, relative as in [`Problem::relative_size`], and the most of
/// them.
const WHOLE: f64 = 0.3;
const MOST_SETTLING: usize = 200;
/// Updates below this that do not fall any more are round-off, even where the problem is not stiff.
const STAGNANT: f64 = 1e-9;
/// An update below this leaves the slopes as they are; they change by up to some sixty times its size.
const EXACT: f64 = 1e-12;
/// The last update of any solution: the curve between points is interpolated with their slopes, which are one update back.
const LAST: f64 = 1e-5;

/// Change of a configuration along the path on a mesh that stays.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Tangent {
    pub state: Vec<f64>,
    pub border: f64,
    pub slide: f64,
    pub force: f64,
}

impl Solution {
    /// The configuration `ahead` along the tangent, on the same mesh.
    pub fn moved(&self, ahead: f64) -> Equilibrium {
        let mut at = self.at.clone();
        for (s, t) in at.state.iter_mut().zip(&self.tangent.state) {
            *s += ahead * t;
        }
        at.border += ahead * self.tangent.border;
        at.slide += ahead * self.tangent.slide;
        at.force += ahead * self.tangent.force;
        at
    }
}

/// Solves from the start `at`.
pub fn solve(
    problem: &Problem,
    mut at: Equilibrium,
    condition: &Condition,
    options: &NewtonOptions,
    work: &mut Workspace,
) -> Result<Solution, SolveError> {
    if work.is_late() {
        return Err(SolveError::OutOfTime);
    }
    let fields = problem.fields();
    let row = path_row(problem, condition);
    let mut update = vec![0.0; at.state.len()];
    let mut correction = 0.0;
    let mut previous = f64::INFINITY;
    let stagnant = problem.round_off.max(STAGNANT);
    for iterations in 1..=options.most_iterations {
        let root = problem.chain.eliminate(at.configuration(), &row, work)?;
        let observed = observables(problem, &at, root.energy);
        let grip = GripBlock::new(problem, &root, &at, condition, &observed);
        let step = grip.solve(-1.0)?;
        problem.chain.recover(work, &step.border_block, -1.0, &mut update);
        let size = problem.relative_size(&update, &at.state);
        if !(size.is_finite() && step.force.is_finite()) {
            return Err(SolveError::NotFinite { quantity: "Newton's update", element: 0, position_nm: 0.0 });
        }
        if size > options.largest_update || (iterations > 2 && size > 0.9 * previous && size > stagnant) {
            return Err(SolveError::NotConverged { update: size, iterations });
        }
        for (s, u) in at.state.iter_mut().zip(&update) {
            *s += u;
        }
        at.add(1.0, &step);
        correction += size;
        // quadratic convergence: what the next update would be, as far as round-off lets it fall
        let next = if previous.is_finite() { size * (size / previous).powi(2).min(1.0) } else { size };
        let next = next.max(problem.round_off);
        let converged = size <= options.tolerance || (next <= options.tolerance && size <= LAST);
        if converged || (size < stagnant && size > 0.5 * previous) {
            let (root, grip) = if options.exact_slope && size > EXACT {
                let root = problem.chain.eliminate(at.configuration(), &row, work)?;
                let observed = observables(problem, &at, root.energy);
                (root, GripBlock::new(problem, &root, &at, condition, &observed))
            } else {
                (root, grip)
            };
            let tangent = grip.tangent()?;
            problem.chain.recover(work, &tangent.border_block, 0.0, &mut update);
            let (energy, adhesion_slope) = problem.chain.energy(at.configuration(), &update);
            let (negative, negative_load) = grip.inertia(root.negative);
            let last = at.state.len() - fields;
            let observables = observables(problem, &at, energy);
            let slope = Observables {
                front: problem.front(adhesion_slope),
                displacement: tangent.displacement,
                tip_rotation: update[problem.rotation],
                force: tangent.force,
                grip_rotation: update[last + problem.rotation],
            };
            if !(observables.is_finite() && slope.is_finite()) {
                let (element, position_nm) = (at.ends.len() - 2, problem.length);
                return Err(SolveError::NotFinite { quantity: "the path's tangent", element, position_nm });
            }
            let center = problem.centered(observables.front);
            let ends = problem.ends_near(center, at.ends.len() - 1, &at.ends);
            return Ok(Solution {
                aligned: problem.chain.shifted(at.configuration(), &ends),
                observables,
                slope,
                tangent: Tangent { state: update, border: tangent.border, slide: tangent.slide, force: tangent.force },
                energy,
                negative,
                negative_load,
                iterations,
                correction,
                at,
            });
        }
        previous = size;
    }
    Err(SolveError::NotConverged { update: previous, iterations: options.most_iterations })
}

/// Solves from a start that is no equilibrium: Newton's method with shortened steps, then [`solve`].
pub fn settle(
    problem: &Problem,
    mut at: Equilibrium,
    condition: &Condition,
    options: &NewtonOptions,
    work: &mut Workspace,
) -> Result<Solution, SolveError> {
    let mut size = f64::INFINITY;
    for iterations in 0..MOST_SETTLING {
        if size < WHOLE {
            let solved = solve(problem, at, condition, options, work)?;
            return Ok(Solution { iterations: solved.iterations + iterations, ..solved });
        }
        size = damped_step(problem, &mut at, condition, &[], WHOLE, work)?.0;
    }
    Err(SolveError::NotConverged { update: size, iterations: MOST_SETTLING })
}

/// A step of Newton's method with `damping` on the diagonal of the tangent, as in [`super::Chain::eliminate_damped`], shortened
/// to `most`: how large it was before, relative as in [`Problem::relative_size`], and the negative eigenvalues of the damped
/// tangent with the displacement held, and with the force held.
pub fn damped_step(
    problem: &Problem,
    at: &mut Equilibrium,
    condition: &Condition,
    damping: &[f64],
    most: f64,
    work: &mut Workspace,
) -> Result<(f64, (usize, usize)), SolveError> {
    if work.is_late() {
        return Err(SolveError::OutOfTime);
    }
    let row = path_row(problem, condition);
    let root = problem.chain.eliminate_damped(at.configuration(), &row, damping, work)?;
    let grip = GripBlock::new(problem, &root, at, condition, &observables(problem, at, root.energy));
    let step = grip.solve(-1.0)?;
    let mut update = vec![0.0; at.state.len()];
    problem.chain.recover(work, &step.border_block, -1.0, &mut update);
    let size = problem.relative_size(&update, &at.state);
    if !size.is_finite() {
        return Err(SolveError::NotFinite { quantity: "a damped update", element: 0, position_nm: 0.0 });
    }
    let part = (most / size).min(1.0);
    for (s, u) in at.state.iter_mut().zip(&update) {
        *s += part * u;
    }
    at.add(part, &step);
    Ok((size, grip.inertia(root.negative)))
}

/// du/dσ and dP/dσ along the path, per unit of the condition's target σ, at a configuration on it or beside it.
pub fn slopes(
    problem: &Problem,
    at: &Equilibrium,
    condition: &Condition,
    work: &mut Workspace,
) -> Result<(f64, f64), SolveError> {
    let row = path_row(problem, condition);
    let root = problem.chain.eliminate(at.configuration(), &row, work)?;
    let observed = observables(problem, at, root.energy);
    let tangent = GripBlock::new(problem, &root, at, condition, &observed).tangent()?;
    Ok((tangent.displacement, tangent.force))
}

/// What the condition wants of the chain.
fn path_row(problem: &Problem, condition: &Condition) -> PathRow {
    let mut row = PathRow { adhesion: problem.front(condition.weights.front), ..PathRow::default() };
    row.left[problem.rotation] = condition.weights.tip_rotation;
    row
}

/// Where on the path a configuration lies.
pub fn observables(problem: &Problem, at: &Equilibrium, energy: ElementEnergy) -> Observables {
    let last = at.state.len() - problem.fields();
    Observables {
        front: problem.front(energy.adhesion),
        displacement: problem.displacement(at),
        tip_rotation: at.state[problem.rotation],
        force: at.force,
        grip_rotation: at.state[last + problem.rotation],
    }
}
