//! The end of the chain in its grip: what closes the system of equations, and which way the grip pulls.
//!
//! The grip pulls in one direction, (cos α, sin α) to the substrate. With dx and dy for how far the end is from where it was
//! at rest, its displacement along the pull and across it are
//!
//!   u = dx cos α + dy sin α,   w = dx sin α - dy cos α,
//!
//! and the end's forces H and V are P (cos α, sin α) + Q (sin α, -cos α). Across the pull the end is free, Q = 0, or held,
//! w = 0. A grip that turns as it goes holds the rotation of the end at θ = θ_rest + t u. The unknown in its place is φ, how far θ is
//! from there: with φ = 0 held u, P and their slopes along the path come from the same equations as without, P being the force alone,
//! and dΠ = (P + t M) du with the moment M of the grip. Where a node has no x, H is the chain's border and the end's place dx an unknown of its own, whose equation is
//! that of the distance, ∂Π/∂H = x(0) + dx + x0(L) - x(L) = 0.

use super::{Condition, Equilibrium, MOST_FIELDS, Observables, Problem, ROOT, Root, SolveError};
use crate::beam::SectionState;
use nalgebra::{RowSVector, SMatrix, SVector};
use serde::{Deserialize, Serialize};

/// Unknowns of the last block: fields of the last node, border, place of the end where no field tells it; last the force.
const BLOCK: usize = ROOT;
/// Row and column of the force, and of the path condition.
const FORCE: usize = BLOCK - 1;
/// Row and column of the end's place along x where it is no field.
const SLIDE: usize = MOST_FIELDS;

/// The direction of a pull, as cosine and sine of its angle α to the substrate.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Direction {
    /// cos α: along the substrate, away from the beam
    pub along: f64,
    /// sin α: away from the substrate
    pub up: f64,
}

impl Direction {
    /// Straight up.
    pub const UP: Self = Self { along: 0.0, up: 1.0 };

    /// The component along the pull, of those along x and y.
    pub fn ahead(self, x: f64, y: f64) -> f64 {
        self.turned(x, y).1
    }

    /// Components across and along the pull, of those along x and y.
    pub(crate) fn turned(self, x: f64, y: f64) -> (f64, f64) {
        (self.up * x - self.along * y, self.along * x + self.up * y)
    }

    /// Components along x and y, of those across and along the pull.
    fn back(self, across: f64, ahead: f64) -> (f64, f64) {
        (self.up * across + self.along * ahead, self.up * ahead - self.along * across)
    }
}

/// What the grip exerts on the right end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GripForces {
    /// H along the substrate, away from the beam, nN
    pub horizontal: f64,
    /// V away from the substrate, nN
    pub vertical: f64,
    /// M, nN·nm, positive where it turns the end anticlockwise
    pub moment: f64,
}

/// Where the grip is, and what it exerts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GripState {
    /// How far it has come along the substrate, nm; none where it is free there and nothing looks at it
    pub x: Option<f64>,
    /// How far away from the substrate, nm
    pub y: f64,
    /// θ(L), rad
    pub rotation: f64,
    pub forces: GripForces,
}

impl Problem {
    /// Slot of x in [`Problem::held`].
    pub fn slot_of_x(&self) -> usize {
        if self.rotation > 1 { 0 } else { SLIDE }
    }

    /// Whether it is known where the end is along x.
    pub fn knows_x(&self) -> bool {
        self.rotation > 1 || self.chain.has_border()
    }

    /// The grip in an equilibrium, seen from an earlier one.
    pub fn grip_state(&self, at: &Equilibrium, from: &Equilibrium) -> GripState {
        let end = |at: &Equilibrium, field: usize| at.state[at.state.len() - self.fields() + field];
        let moved = |field| end(at, field) - end(from, field);
        let x = if self.rotation > 1 { moved(0) } else { at.slide - from.slide };
        GripState {
            x: self.knows_x().then_some(x),
            y: moved(self.rotation - 1),
            rotation: end(at, self.rotation),
            forces: self.grip_forces(at),
        }
    }

    /// Where a pull that is not straight up mixes x and height: the slot of x in [`Problem::held`], and the direction.
    fn turned(&self) -> Option<(usize, Direction)> {
        (self.direction != Direction::UP).then_some((self.slot_of_x(), self.direction))
    }

    /// How far a field of the right end is from where it began, or the end's place where that is the slot of x and no field.
    fn end_off_rest(&self, at: &Equilibrium, slot: usize) -> f64 {
        if slot >= self.fields() {
            return at.slide - self.slide_at_rest();
        }
        at.state[at.state.len() - self.fields() + slot] - self.end_at_rest()[slot]
    }

    /// How far what a slot of [`Problem::held`] stands for is from its value at rest.
    fn off_rest(&self, at: &Equilibrium, slot: usize) -> f64 {
        let own = self.end_off_rest(at, slot);
        match self.turned() {
            Some((x, direction)) if x == slot => direction.turned(own, self.end_off_rest(at, self.driven)).0,
            _ if slot == self.rotation => own - self.turn * self.grip_displacement(at),
            _ => own,
        }
    }

    /// U = u + P/k of a configuration: how far what moves the grip is from where it was at rest, nm.
    pub fn displacement(&self, at: &Equilibrium) -> f64 {
        self.grip_displacement(at) + self.compliance * at.force
    }

    /// u of a configuration: how far the grip is along the pull from where it was at rest, nm.
    fn grip_displacement(&self, at: &Equilibrium) -> f64 {
        let driven = self.end_off_rest(at, self.driven);
        match self.turned() {
            Some((x, direction)) => direction.turned(self.end_off_rest(at, x), driven).1,
            None => driven,
        }
    }

    /// What the grip exerts on the end of an equilibrium.
    pub fn grip_forces(&self, at: &Equilibrium) -> GripForces {
        let last = at.ends.len() - 2;
        let section = self.chain.node_states(at.configuration(), last..last + 1)[1].section;
        let SectionState { horizontal_force: horizontal, vertical_force: vertical, moment, .. } = section;
        GripForces { horizontal, vertical, moment }
    }

    /// dΠ/du of an equilibrium, nN: the force along the pull, and of a grip that turns as it goes the work of the moment besides.
    pub fn power(&self, at: &Equilibrium) -> f64 {
        if self.turn == 0.0 { at.force } else { at.force + self.turn * self.grip_forces(at).moment }
    }

    /// The configuration with the grip moved on along the pull, nm.
    pub(super) fn moved(&self, mut at: Equilibrium, ahead: f64) -> Equilibrium {
        let end = at.state.len() - self.fields();
        at.state[end + self.driven] += self.direction.up * ahead;
        at.state[end + self.rotation] += self.turn * ahead;
        match self.turned() {
            Some((x, direction)) if x < self.fields() => at.state[end + x] += direction.along * ahead,
            Some((_, direction)) => at.slide += direction.along * ahead,
            None => {}
        }
        at
    }
}

/// The root of the chain with grip, border constraint, force and path condition.
///
/// Rows: the last node's equations, the driven field's and that of x turned into the direction of the pull, or held values;
/// border constraint; path condition. Unused rows are unit rows.
pub(super) struct GripBlock<'p> {
    problem: &'p Problem,
    matrix: SMatrix<f64, BLOCK, BLOCK>,
    residual: SVector<f64, BLOCK>,
    /// Change of t M with each unknown: what the driven row lacks to be that of P + t M.
    turning: RowSVector<f64, BLOCK>,
}

/// Solution of a [`GripBlock`].
pub(super) struct GripStep {
    /// Fields of the last node, then the border: what the chain needs to go back.
    pub border_block: [f64; BLOCK],
    pub border: f64,
    /// dx, where no field tells it
    pub slide: f64,
    pub force: f64,
    /// Of what moves the grip.
    pub displacement: f64,
}

impl<'p> GripBlock<'p> {
    pub fn new(
        problem: &'p Problem,
        root: &Root,
        at: &Equilibrium,
        condition: &Condition,
        observed: &Observables,
    ) -> Self {
        let (fields, border) = (problem.fields(), problem.chain.has_border());
        let known = fields + usize::from(border);
        let mut matrix = SMatrix::<f64, BLOCK, BLOCK>::identity();
        let mut residual = SVector::<f64, BLOCK>::zeros();
        for i in 0..known {
            for j in 0..known {
                matrix[(i, j)] = root.matrix[i][j];
            }
            residual[i] = root.matrix[i][known];
            matrix[(FORCE, i)] = root.matrix[known][i];
        }
        if border {
            matrix[(SLIDE, SLIDE)] = 0.0;
            matrix[(SLIDE, fields)] = 1.0;
            matrix[(fields, SLIDE)] = 1.0;
            residual[SLIDE] = at.border;
            residual[fields] += problem.span() + at.slide;
        }
        let mut block = Self { problem, matrix, residual, turning: RowSVector::zeros() };
        block.turn();
        block.gear();
        let Self { matrix, residual, .. } = &mut block;
        matrix[(problem.driven, FORCE)] = -1.0;
        residual[problem.driven] -= at.force;
        matrix[(FORCE, problem.driven)] += condition.weights.displacement;
        matrix[(FORCE, FORCE)] = condition.weights.force + condition.weights.displacement * problem.compliance;
        residual[FORCE] = root.matrix[known][known] + condition.weights.dot(observed) - condition.target;
        for slot in (0..FORCE).filter(|&slot| problem.held[slot]) {
            matrix.row_mut(slot).fill(0.0);
            matrix[(slot, slot)] = 1.0;
            residual[slot] = problem.off_rest(at, slot);
        }
        block
    }

    /// Rows and columns of x and of the driven field from those of dx and dy to those of w and u.
    fn turn(&mut self) {
        let Some((across, direction)) = self.problem.turned() else { return };
        let driven = self.problem.driven;
        for j in 0..BLOCK {
            let (x, y) = (self.matrix[(across, j)], self.matrix[(driven, j)]);
            (self.matrix[(across, j)], self.matrix[(driven, j)]) = direction.turned(x, y);
        }
        for i in 0..BLOCK {
            let (x, y) = (self.matrix[(i, across)], self.matrix[(i, driven)]);
            (self.matrix[(i, across)], self.matrix[(i, driven)]) = direction.turned(x, y);
        }
        let (x, y) = (self.residual[across], self.residual[driven]);
        (self.residual[across], self.residual[driven]) = direction.turned(x, y);
    }

    /// The column of the rotation from θ to φ.
    fn gear(&mut self) {
        let Problem { turn, driven, rotation, .. } = *self.problem;
        if turn != 0.0 {
            let geared = self.matrix.column(driven) + turn * self.matrix.column(rotation);
            self.matrix.set_column(driven, &geared);
            self.turning = turn * self.matrix.row(rotation);
        }
    }

    fn step(&self, right: SVector<f64, BLOCK>) -> Result<GripStep, SolveError> {
        let problem = self.problem;
        let mut values = self.matrix.lu().solve(&right).ok_or(SolveError::SingularGrip)?;
        let (force, moved) = (values[FORCE], values[problem.driven]);
        if let Some((across, direction)) = problem.turned() {
            (values[across], values[problem.driven]) = direction.back(values[across], moved);
        }
        // what was θ's is φ's, where the driven field is another
        if problem.turn != 0.0 {
            values[problem.rotation] += problem.turn * moved;
        }
        let border = problem.chain.has_border();
        Ok(GripStep {
            border_block: values.into(),
            border: if border { values[problem.fields()] } else { 0.0 },
            slide: if border { values[SLIDE] } else { 0.0 },
            force,
            displacement: moved + problem.compliance * force,
        })
    }

    /// What removes this multiple of the residual.
    pub fn solve(&self, scale: f64) -> Result<GripStep, SolveError> {
        self.step(self.residual * scale)
    }

    /// Change along the path per unit of the condition's target.
    pub fn tangent(&self) -> Result<GripStep, SolveError> {
        let mut right = SVector::<f64, BLOCK>::zeros();
        right[FORCE] = 1.0;
        self.step(right)
    }

    /// Negative eigenvalues of the whole tangent with the displacement held, and with the force held; of a grip that turns as it
    /// goes, with P + t M, what works on u. A border is a multiplier: it adds one negative eigenvalue that is none of the structure's. Where the displacement is that of a
    /// spring's far end, ½k(U - u)² adds k to the diagonal of the driven field, which is left out where k is infinite: one
    /// more than with u held where dP/du + k < 0, by the Schur complement dP/du of that field.
    pub fn inertia(&self, chain: usize) -> (usize, usize) {
        let problem = self.problem;
        let border = problem.chain.has_border();
        // a border comes with the end's place, the slot behind it
        let free = (0..problem.fields() + 2 * usize::from(border)).filter(|&slot| !problem.held[slot]);
        let rigid = problem.compliance == 0.0;
        let held: Vec<usize> = free.clone().filter(|&slot| !rigid || slot != problem.driven).collect();
        let loose: Vec<usize> = free.collect();
        let spring = if rigid { 0.0 } else { 1.0 / problem.compliance };
        let count = |rows: &[usize], added: f64| {
            let pivots = self.negative_pivots(rows, problem.driven, added);
            (chain + pivots).saturating_sub(usize::from(border))
        };
        (count(&held, spring), count(&loose, 0.0))
    }

    /// Of the block of `rows`, with `added` to the diagonal of the row `driven`.
    fn negative_pivots(&self, rows: &[usize], driven: usize, added: f64) -> usize {
        let n = rows.len();
        let mut a = [[0.0; BLOCK]; BLOCK];
        for i in 0..n {
            for j in 0..n {
                a[i][j] = self.matrix[(rows[i], rows[j])];
                a[i][j] += if rows[i] == driven { self.turning[rows[j]] } else { 0.0 };
            }
            a[i][i] += if rows[i] == driven { added } else { 0.0 };
        }
        let mut negative = 0;
        for k in 0..n {
            negative += usize::from(a[k][k] < 0.0);
            for i in k + 1..n {
                let factor = a[i][k] / a[k][k];
                for j in k + 1..n {
                    a[i][j] -= factor * a[k][j];
                }
            }
        }
        negative
    }
}
