//! The last dense block: what is left of a system on its interface, with the end conditions, the force and the path constraint.
//!
//! Rows: the interface's equations, those of the driven unknown and of the one across turned into the direction of the drive, or held
//! values; then the path constraint. Columns: the interface, then the force.

use crate::solve::error::SolveError;
use crate::solve::problem::Problem;
use crate::solve::state::{Observables, PathConstraint, State};
use crate::solve::system::{CondensedSystem, INTERFACE};
use nalgebra::{RowSVector, SMatrix, SVector};

/// Unknowns of the block: the interface and the force.
const BLOCK: usize = INTERFACE + 1;
/// A block up to this size is solved as one of this size.
const SMALL: usize = 5;

/// The block at one state.
pub(in crate::solve) struct GripBlock<'p> {
    problem: &'p Problem,
    /// Unknowns of the interface; the force comes behind them.
    interface: usize,
    matrix: SMatrix<f64, BLOCK, BLOCK>,
    residual: SVector<f64, BLOCK>,
    /// Change of t M with each unknown: what the driven row lacks to be that of P + t M.
    gearing: RowSVector<f64, BLOCK>,
}

/// Solution of a [`GripBlock`].
#[derive(Clone, Copy, Debug)]
pub(in crate::solve) struct GripStep {
    /// Of the unknowns of the interface.
    pub interface: [f64; INTERFACE],
    pub force: f64,
    /// Of what moves the grip.
    pub displacement: f64,
}

impl<'p> GripBlock<'p> {
    pub(crate) fn new(
        problem: &'p Problem,
        root: &CondensedSystem,
        at: &State,
        constraint: &PathConstraint,
        observed: &Observables,
    ) -> Self {
        let (interface, grip) = (problem.system.interface().len(), &problem.grip);
        let mut matrix = SMatrix::<f64, BLOCK, BLOCK>::identity();
        let mut residual = SVector::<f64, BLOCK>::zeros();
        for i in 0..interface {
            for j in 0..interface {
                matrix[(i, j)] = root.matrix[i][j];
            }
            residual[i] = root.residual[i];
            matrix[(interface, i)] = root.gradient[i];
        }
        if let Some(roll) = problem.roll(at) {
            (0..interface).for_each(|i| matrix[(interface, i)] += constraint.weights.roll * roll.gradient[i]);
        }
        let mut block = Self { problem, interface, matrix, residual, gearing: RowSVector::zeros() };
        block.turn();
        block.gear();
        let Self { matrix, residual, .. } = &mut block;
        let (force, driven) = (interface, grip.driven);
        matrix[(driven, force)] = -1.0;
        residual[driven] -= at.force;
        matrix[(force, driven)] += constraint.weights.displacement;
        matrix[(force, force)] = constraint.weights.force + constraint.weights.displacement * grip.compliance;
        residual[force] = root.gradient_residual + constraint.weights.dot(observed) - constraint.target;
        let values = problem.system.interface_values(at);
        for slot in (0..interface).filter(|&slot| grip.held[slot]) {
            matrix.row_mut(slot).fill(0.0);
            matrix[(slot, slot)] = 1.0;
            residual[slot] = grip.off(slot, &values);
        }
        block
    }

    /// Rows and columns of the two driven unknowns from those of dx and dy to those of w and u.
    fn turn(&mut self) {
        let Some((across, direction)) = self.problem.grip.mixed() else { return };
        let driven = self.problem.grip.driven;
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

    /// The column of the geared unknown from its own to how far it is from where the gear puts it.
    fn gear(&mut self) {
        let grip = &self.problem.grip;
        if grip.gear != 0.0 {
            let geared = self.matrix.column(grip.driven) + grip.gear * self.matrix.column(grip.geared);
            self.matrix.set_column(grip.driven, &geared);
            self.gearing = grip.gear * self.matrix.row(grip.geared);
        }
    }

    fn step(&self, right: SVector<f64, BLOCK>) -> Result<GripStep, SolveError> {
        let grip = &self.problem.grip;
        let mut values = self.solved(&self.matrix, right)?;
        let (force, moved) = (values[self.interface], values[grip.driven]);
        if let Some((across, direction)) = grip.mixed() {
            (values[across], values[grip.driven]) = direction.back(values[across], moved);
        }
        // in place of the geared unknown stands how far it is from its place
        if grip.gear != 0.0 {
            values[grip.geared] += grip.gear * moved;
        }
        Ok(GripStep {
            interface: std::array::from_fn(|slot| if slot < self.interface { values[slot] } else { 0.0 }),
            force,
            displacement: moved + grip.compliance * force,
        })
    }

    fn solved(
        &self,
        matrix: &SMatrix<f64, BLOCK, BLOCK>,
        right: SVector<f64, BLOCK>,
    ) -> Result<SVector<f64, BLOCK>, SolveError> {
        let mut values = right;
        if self.interface < SMALL {
            let small = matrix.fixed_view::<SMALL, SMALL>(0, 0).into_owned();
            let solved = small.lu().solve(&right.fixed_rows::<SMALL>(0).into_owned());
            values.fixed_rows_mut::<SMALL>(0).copy_from(&solved.ok_or(SolveError::SingularGrip)?);
        } else {
            values = matrix.lu().solve(&right).ok_or(SolveError::SingularGrip)?;
        }
        Ok(values)
    }

    /// What removes this multiple of the residual.
    pub(crate) fn solve(&self, scale: f64) -> Result<GripStep, SolveError> {
        self.step(self.residual * scale)
    }

    /// Change along the path per unit of the constraint's target.
    pub(crate) fn tangent(&self) -> Result<GripStep, SolveError> {
        let mut right = SVector::<f64, BLOCK>::zeros();
        right[self.interface] = 1.0;
        self.step(right)
    }

    /// Solves the block for a right-hand side `right` of the interface and `last` of the path constraint; what is held does not move.
    pub(crate) fn solve_right(&self, right: &[f64; INTERFACE], last: f64) -> Result<GripStep, SolveError> {
        let grip = &self.problem.grip;
        let mut vector = SVector::<f64, BLOCK>::zeros();
        vector.as_mut_slice()[..self.interface].copy_from_slice(&right[..self.interface]);
        if let Some((across, direction)) = grip.mixed() {
            (vector[across], vector[grip.driven]) = direction.turned(vector[across], vector[grip.driven]);
        }
        self.held_slots().for_each(|slot| vector[slot] = 0.0);
        vector[self.interface] = last;
        self.step(vector)
    }

    /// Solves the transpose of the block: for the derivatives of a functional by the unknowns of the interface and by the force, the
    /// multipliers of the interface's equations and of the path constraint. Those of what is held are zero.
    pub(crate) fn solve_transposed(
        &self,
        right: &[f64; INTERFACE],
        force: f64,
    ) -> Result<([f64; INTERFACE], f64), SolveError> {
        let grip = &self.problem.grip;
        let mut vector = SVector::<f64, BLOCK>::zeros();
        vector.as_mut_slice()[..self.interface].copy_from_slice(&right[..self.interface]);
        if let Some((across, direction)) = grip.mixed() {
            (vector[across], vector[grip.driven]) = direction.turned(vector[across], vector[grip.driven]);
        }
        if grip.gear != 0.0 {
            vector[grip.driven] += grip.gear * right[grip.geared];
        }
        vector[self.interface] = force;
        let mut values = self.solved(&self.matrix.transpose(), vector)?;
        let constraint = values[self.interface];
        self.held_slots().for_each(|slot| values[slot] = 0.0);
        if let Some((across, direction)) = grip.mixed() {
            (values[across], values[grip.driven]) = direction.back(values[across], values[grip.driven]);
        }
        Ok((std::array::from_fn(|slot| if slot < self.interface { values[slot] } else { 0.0 }), constraint))
    }

    fn held_slots(&self) -> impl Iterator<Item = usize> {
        let held = self.problem.grip.held;
        (0..self.interface).filter(move |&slot| held[slot])
    }

    /// Negative eigenvalues of the whole tangent with the displacement held, and with the force held; of a geared unknown, with
    /// P + t M, what works on u. A multiplier adds one negative eigenvalue that is none of the structure's. Where the displacement is that of a
    /// spring's far end, ½k(U - u)² adds k to the diagonal of the driven unknown, which is left out where k is infinite: one
    /// more than with u held where dP/du + k < 0, by the Schur complement dP/du of that unknown.
    pub(crate) fn inertia(&self, inside: usize) -> (usize, usize) {
        let grip = &self.problem.grip;
        let free = (0..self.interface).filter(|&slot| !grip.held[slot]);
        let rigid = grip.compliance == 0.0;
        let held: Vec<usize> = free.clone().filter(|&slot| !rigid || slot != grip.driven).collect();
        let loose: Vec<usize> = free.collect();
        let spring = if rigid { 0.0 } else { 1.0 / grip.compliance };
        let count = |rows: &[usize], added: f64| {
            let pivots = self.negative_pivots(rows, grip.driven, added);
            (inside + pivots).saturating_sub(self.problem.system.multipliers())
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
                a[i][j] += if rows[i] == driven { self.gearing[rows[j]] } else { 0.0 };
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
