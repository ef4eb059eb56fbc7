//! A plane truss as a [`System`], with dense algebra: the second implementor of the solver's one boundary, and no chain.
//!
//! Bars of stiffness EA and unstressed length l0 store ½EA l0 (l/l0 - 1)². Unknowns are the displacements of the free nodes. A `follower`
//! adds the residual f (-q_y, q_x) at every free node, which has no potential.

use nalgebra::{DMatrix, DVector, Dyn, LU};
use peelkit::solve::{
    Coefficients, CondensedSystem, EndConditions, Evaluation, INTERFACE, InitialState, MONITORS, MeasuredBeside,
    PathMeasure, Problem, Rates, SolveError, State, System, Unknown, Workspace,
};
use std::sync::Arc;

/// A bar between two nodes, with its EA.
pub type Bar = (usize, usize, f64);

#[derive(Clone)]
pub struct Truss {
    pub nodes: Vec<[f64; 2]>,
    /// How many of the nodes, from the first on, are free in both directions; the others are held.
    pub free: usize,
    pub bars: Vec<Bar>,
    /// Unknowns that end conditions can be set on.
    pub interface: Vec<usize>,
    /// Unknowns that are the monitors.
    pub monitors: [usize; MONITORS],
    pub follower: f64,
}

#[derive(Default)]
struct Factors {
    inside: Option<LU<f64, Dyn, Dyn>>,
    tangent: DMatrix<f64>,
    residual: DVector<f64>,
}

const NAMES: [Unknown; INTERFACE] = [Unknown { name: "displacement", unit: "nm" }; INTERFACE];

impl Truss {
    pub fn problem(self, grip: EndConditions) -> Problem {
        let measure = PathMeasure { monitors: [f64::INFINITY, 1.0], force: 1.0, beside: MeasuredBeside::Force };
        Problem { system: Arc::new(self), grip, measure, start: InitialState::StressFree }
    }

    /// ∂R/∂ln EA of a bar.
    pub fn residual_by_stiffness(&self, bar: usize, at: &State) -> Vec<f64> {
        Self { bars: vec![self.bars[bar]], follower: 0.0, ..self.clone() }.residual(at)
    }

    fn inside(&self) -> Vec<usize> {
        (0..2 * self.free).filter(|unknown| !self.interface.contains(unknown)).collect()
    }

    fn position(&self, node: usize, values: &[f64]) -> [f64; 2] {
        let moved = |axis: usize| if node < self.free { values[2 * node + axis] } else { 0.0 };
        std::array::from_fn(|axis| self.nodes[node][axis] + moved(axis))
    }

    /// Energy, residual and tangent.
    pub fn assembled(&self, values: &[f64]) -> (f64, DVector<f64>, DMatrix<f64>) {
        let n = 2 * self.free;
        let (mut energy, mut residual, mut tangent) = (0.0, DVector::zeros(n), DMatrix::zeros(n, n));
        for &(a, b, stiffness) in &self.bars {
            let span = |p: [f64; 2], q: [f64; 2]| [q[0] - p[0], q[1] - p[1]];
            let [x, y] = span(self.nodes[a], self.nodes[b]);
            let rest = x.hypot(y);
            let [x, y] = span(self.position(a, values), self.position(b, values));
            let length = x.hypot(y);
            let strain = length / rest - 1.0;
            energy += 0.5 * stiffness * rest * strain * strain;
            let along = [x / length, y / length];
            let force = stiffness * strain;
            for (p, sign_p) in [(a, -1.0), (b, 1.0)] {
                for i in (0..2).filter(|_| p < self.free) {
                    residual[2 * p + i] += sign_p * force * along[i];
                    for (q, sign_q) in [(a, -1.0), (b, 1.0)] {
                        for j in (0..2).filter(|_| q < self.free) {
                            let across = if i == j { 1.0 } else { 0.0 } - along[i] * along[j];
                            let term = stiffness / rest * along[i] * along[j] + force / length * across;
                            tangent[(2 * p + i, 2 * q + j)] += sign_p * sign_q * term;
                        }
                    }
                }
            }
        }
        for node in 0..self.free {
            residual[2 * node] -= self.follower * values[2 * node + 1];
            residual[2 * node + 1] += self.follower * values[2 * node];
            tangent[(2 * node, 2 * node + 1)] -= self.follower;
            tangent[(2 * node + 1, 2 * node)] += self.follower;
        }
        (energy, residual, tangent)
    }

    fn evaluation(&self, values: &[f64], energy: f64) -> Evaluation {
        Evaluation { energy, monitors: self.monitors.map(|unknown| values[unknown]), recorded: 0.0 }
    }
}

impl System for Truss {
    fn interface(&self) -> &[Unknown] {
        &NAMES[..self.interface.len()]
    }

    fn unknowns(&self, _: &State) -> usize {
        2 * self.free
    }

    fn interface_values(&self, at: &State) -> [f64; INTERFACE] {
        std::array::from_fn(|slot| self.interface.get(slot).map_or(0.0, |&unknown| at.values[unknown]))
    }

    fn place_of(&self, slot: usize, _: &State) -> usize {
        self.interface[slot]
    }

    fn is_conservative(&self) -> bool {
        self.follower == 0.0
    }

    fn factorise(
        &self,
        at: &State,
        coefficients: Coefficients,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let (energy, residual, mut tangent) = self.assembled(&at.values);
        (0..2 * self.free)
            .for_each(|k| tangent[(k, k)] += 1.0 / coefficients.per_damping + 1.0 / coefficients.per_mass);
        let (inside, gradient) = (self.inside(), DVector::from_vec(self.gradient(at, weights)));
        let block = tangent.select_rows(&inside).select_columns(&inside);
        let eigenvalues = block.clone().symmetric_eigenvalues();
        let factors = ws.factors::<Factors>();
        *factors = Factors { inside: Some(block.lu()), tangent, residual };
        let Factors { inside: Some(lu), tangent, residual } = factors else { return Err(SolveError::SingularGrip) };
        let solved = |right: DMatrix<f64>| lu.solve(&right).ok_or(SolveError::SingularGrip);
        let across = tangent.select_rows(&inside).select_columns(&self.interface);
        let back = tangent.select_rows(&self.interface).select_columns(&inside);
        let own = tangent.select_rows(&self.interface).select_columns(&self.interface);
        let rows = |vector: &DVector<f64>, which: &[usize]| vector.select_rows(which);
        let loaded = solved(DMatrix::from_column_slice(inside.len(), 1, rows(residual, &inside).as_slice()))?;
        let spread = solved(across)?;
        let schur = own - &back * &spread;
        let left = rows(residual, &self.interface) - &back * &loaded;
        let inner = rows(&gradient, &inside).transpose();
        let carried = rows(&gradient, &self.interface).transpose() - &inner * &spread;
        let mut condensed = CondensedSystem {
            matrix: [[0.0; INTERFACE]; INTERFACE],
            residual: [0.0; INTERFACE],
            gradient: [0.0; INTERFACE],
            gradient_residual: -(&inner * &loaded)[0],
            negative: eigenvalues.iter().filter(|&&eigenvalue| eigenvalue < 0.0).count(),
            least_pivot: eigenvalues.iter().fold(f64::INFINITY, |least, eigenvalue| least.min(eigenvalue.abs())),
            evaluation: self.evaluation(&at.values, energy),
        };
        for i in 0..self.interface.len() {
            for j in 0..self.interface.len() {
                condensed.matrix[i][j] = schur[(i, j)];
            }
            condensed.residual[i] = left[i];
            condensed.gradient[i] = carried[i];
        }
        Ok(condensed)
    }

    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]) {
        let residual = &ws.factored::<Factors>().residual;
        direction.iter_mut().zip(residual.iter()).for_each(|(d, r)| *d = scale * r);
        self.substitute(ws, interface, direction, false);
    }

    fn reduce(&self, ws: &Workspace, right: &mut [f64], transposed: bool) -> [f64; INTERFACE] {
        let Factors { inside: Some(lu), tangent, .. } = ws.factored::<Factors>() else { unreachable!() };
        let inside = self.inside();
        let inner = DVector::from_iterator(inside.len(), inside.iter().map(|&unknown| right[unknown]));
        let (block, back) = if transposed {
            let whole = tangent.transpose();
            (whole.select_rows(&inside).select_columns(&inside).lu(), whole)
        } else {
            (lu.clone(), tangent.clone())
        };
        let loaded = block.solve(&inner).expect("it was solved before");
        let left = back.select_rows(&self.interface).select_columns(&inside) * loaded;
        std::array::from_fn(|slot| self.interface.get(slot).map_or(0.0, |&unknown| right[unknown] - left[slot]))
    }

    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool) {
        let tangent = &ws.factored::<Factors>().tangent;
        let whole = if transposed { tangent.transpose() } else { tangent.clone() };
        let inside = self.inside();
        let known = DVector::from_column_slice(&interface[..self.interface.len()]);
        let inner = DVector::from_iterator(inside.len(), inside.iter().map(|&unknown| right[unknown]));
        let across = whole.select_rows(&inside).select_columns(&self.interface) * &known;
        let block = whole.select_rows(&inside).select_columns(&inside).lu();
        let found = block.solve(&(inner - across)).expect("it was solved before");
        inside.iter().zip(found.iter()).for_each(|(&unknown, &value)| right[unknown] = value);
        self.interface.iter().zip(known.iter()).for_each(|(&unknown, &value)| right[unknown] = value);
    }

    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates) {
        let rates = Rates { monitors: self.monitors.map(|unknown| direction[unknown]), recorded: 0.0 };
        (self.evaluation(&at.values, self.assembled(&at.values).0), rates)
    }

    fn gradient(&self, _: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let mut gradient = vec![0.0; 2 * self.free];
        self.monitors.iter().zip(weights).for_each(|(&unknown, weight)| gradient[unknown] += weight);
        gradient
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        self.assembled(&at.values).1.as_slice().to_vec()
    }

    fn size(&self, direction: &[f64], _: &State) -> f64 {
        direction.iter().fold(0.0, |largest, change| if change.abs() <= largest { largest } else { change.abs() })
    }

    fn per_unit(&self, at: &State) -> Vec<f64> {
        vec![1.0; at.values.len()]
    }

    fn stress_free(&self, _: usize) -> State {
        State { values: vec![0.0; 2 * self.free], ..State::default() }
    }
}
