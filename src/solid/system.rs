//! A solid strip as a [`System`]: block elimination along it, column after column, down to the unknowns of the grip.
//!
//! Functions inside an element are eliminated in it. What is left of a column is added to the Schur complement of those before it, and its
//! left line is eliminated with what its rows share; the last line goes over to the unknowns of the grip.

use super::front::{Elimination, Pivots};
use super::grip::{HEIGHT, ROTATION, SolidGrip};
use super::strip::{ElementWork, SolidStrip};
use crate::solve::error::{Place, Quantity, SolveError};
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem};
use crate::solve::state::{MONITORS, Mesh, State};
use crate::solve::system::{Coefficients, CondensedSystem, Evaluation, INTERFACE, Rates, System, Unknown};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

/// Factors of a tangent.
#[derive(Default)]
struct Factors {
    /// Of what is inside each element, column by column; empty where nothing is
    elements: Vec<Elimination>,
    columns: Vec<Elimination>,
    last: Elimination,
    /// ∂line/∂grip at the factorised state
    jacobian: Vec<f64>,
    /// The residual, taken down
    residual: Vec<f64>,
    work: ElementWork,
    front: Vec<f64>,
    carried: Vec<f64>,
}

/// Share of what changes a displacement off the contact face beside one on it, and that of a slope and of a polynomial on it.
const OFF_FACE: f64 = 0.1;
const SLOPE: f64 = 0.15;
/// No gap may change by more on one step, relative to itself and the scale of gaps.
const MOST_GAP_CHANGE: f64 = 0.3;
/// The same of a state that is no step away from another: how near to the ground it may come, over the gap at rest.
const NEAREST: f64 = 0.3;

impl SolidStrip {
    /// What is to be solved: the strip in its grip, from rest.
    pub fn problem(self: &Arc<Self>) -> Problem {
        let distance = self.design.ground.equilibrium_distance;
        let grip = match self.design.grip {
            SolidGrip::Rigid => self.drive.conditions(distance, 0.5 * self.design.height),
            SolidGrip::Parabolic => EndConditions { scale: [distance; INTERFACE], ..EndConditions::drive(HEIGHT) },
        };
        let force = self.design.ground.work_of_adhesion() * self.design.width;
        let measure = PathMeasure {
            monitors: [self.design.height.min(0.1 * self.design.length), f64::INFINITY],
            force,
            beside: MeasuredBeside::Nothing,
        };
        let settles = self.design.contact == super::contact::SolidContact::BodyForce || self.design.far_face;
        let start = if settles { InitialState::Settling } else { InitialState::StressFree };
        Problem { system: self.clone(), grip, measure, start }
    }

    fn place(&self, column: usize) -> Place {
        Place { element: column, position: self.mesh.lines[column] }
    }

    /// From all functions of displacements to the unknowns: gradients and residuals.
    fn gathered(&self, all: &[f64], jacobian: &[f64]) -> Vec<f64> {
        let inside = self.inside();
        let mut found = all[..inside].to_vec();
        found.extend(transposed_product(jacobian, &all[inside..], self.grip.unknowns()));
        found
    }

    /// Residual of all functions, and the energy; an error where a number is not finite.
    fn assembled(&self, displacements: &[f64]) -> (f64, Vec<f64>) {
        let mut residual = vec![0.0; displacements.len()];
        let (mut energy, mut work) = (0.0, ElementWork::default());
        for column in 0..self.mesh.columns() {
            for row in 0..self.mesh.rows() {
                self.element_at(displacements, (column, row), false, &mut work);
                energy += work.energy;
                self.scatter(&work.residual, (column, row), &mut residual);
            }
        }
        (energy, residual)
    }

    fn scatter(&self, own: &[f64], (column, row): (usize, usize), all: &mut [f64]) {
        for (k, shape) in self.rows[row].shapes.iter().enumerate() {
            let first = 2 * self.layout.function(column, row, shape.place);
            all[first] += own[2 * k];
            all[first + 1] += own[2 * k + 1];
        }
    }

    /// Where in the front of a column the shapes of a row stand that are not inside an element, two numbers a function.
    fn places_in_front(&self, row: usize) -> Vec<usize> {
        let outer = &self.rows[row].shapes[self.rows[row].inner..];
        let first = outer.iter().filter_map(|shape| self.layout.in_front(shape.place));
        first.flat_map(|place| [2 * place, 2 * place + 1]).collect()
    }

    /// A right-hand side taken down, all but the interface.
    fn forward(&self, factors: &Factors, right: &mut [f64], transposed: bool) {
        let (inside, columns) = (self.inside(), self.mesh.columns());
        let mut line = vec![0.0; 2 * self.layout.line.len()];
        let mut local = Vec::new();
        self.over_elements(factors, |elimination, column, row| {
            self.gather(right, &line, (column, row), &mut local);
            elimination.forward(&mut local, transposed);
            self.spread(&local, (column, row), right, &mut line);
        });
        right[2 * self.layout.vertex(0)] = 0.0;
        let taken = transposed_product(&factors.jacobian, &line, self.grip.unknowns());
        right[inside..].iter_mut().zip(taken).for_each(|(right, taken)| *right += taken);
        for column in 0..columns {
            self.gather_front(right, column, &mut local);
            factors.columns[column].forward(&mut local, transposed);
            self.spread_front(&local, column, right);
        }
        factors.last.forward(&mut right[inside..], transposed);
    }

    /// From a right-hand side that was taken down, with the solution on the interface, to the whole.
    fn backward(&self, factors: &Factors, right: &mut [f64], transposed: bool) {
        let inside = self.inside();
        factors.last.backward(&mut right[inside..], transposed);
        let mut local = Vec::new();
        for column in (0..self.mesh.columns()).rev() {
            self.gather_front(right, column, &mut local);
            factors.columns[column].backward(&mut local, transposed);
            self.spread_front(&local, column, right);
        }
        let n = self.grip.unknowns();
        let mut line: Vec<f64> = factors
            .jacobian
            .chunks_exact(n)
            .map(|row| row.iter().zip(&right[inside..]).map(|(g, q)| g * q).sum())
            .collect();
        self.over_elements(factors, |elimination, column, row| {
            self.gather(right, &line, (column, row), &mut local);
            elimination.backward(&mut local, transposed);
            self.spread(&local, (column, row), right, &mut line);
        });
    }

    fn over_elements(&self, factors: &Factors, mut of: impl FnMut(&Elimination, usize, usize)) {
        let rows = self.mesh.rows();
        for column in 0..self.mesh.columns() {
            for row in (0..rows).filter(|&row| self.rows[row].inner > 0) {
                of(&factors.elements[column * rows + row], column, row);
            }
        }
    }

    /// Numbers of the shapes of an element, from those of the unknowns and of the last line.
    fn gather(&self, right: &[f64], line: &[f64], (column, row): (usize, usize), local: &mut Vec<f64>) {
        let inside = self.inside();
        local.clear();
        for shape in &self.rows[row].shapes {
            let first = 2 * self.layout.function(column, row, shape.place);
            for k in [first, first + 1] {
                local.push(if k < inside { right[k] } else { line[k - inside] });
            }
        }
    }

    fn spread(&self, local: &[f64], (column, row): (usize, usize), right: &mut [f64], line: &mut [f64]) {
        let inside = self.inside();
        for (k, shape) in self.rows[row].shapes.iter().enumerate() {
            let first = 2 * self.layout.function(column, row, shape.place);
            for i in 0..2 {
                let target = if first < inside { &mut right[first + i] } else { &mut line[first + i - inside] };
                *target = local[2 * k + i];
            }
        }
    }

    /// Numbers of the front of a column: those of the last one end in the unknowns of the grip.
    fn gather_front(&self, right: &[f64], column: usize, local: &mut Vec<f64>) {
        let (own, next) = (self.front_start(column), self.front_start(column + 1));
        local.clear();
        local.extend_from_slice(&right[own..own + 2 * self.layout.front(false)]);
        local.extend_from_slice(&right[next..next + self.behind(column)]);
    }

    fn spread_front(&self, local: &[f64], column: usize, right: &mut [f64]) {
        let (own, next) = (self.front_start(column), self.front_start(column + 1));
        let (first, last) = local.split_at(2 * self.layout.front(false));
        right[own..own + first.len()].copy_from_slice(first);
        right[next..next + last.len()].copy_from_slice(last);
    }

    fn front_start(&self, column: usize) -> usize {
        2 * self.layout.line_start(column)
    }

    /// Unknowns of a column's front behind those that are eliminated.
    fn behind(&self, column: usize) -> usize {
        let is_last = column + 1 == self.mesh.columns();
        if is_last { self.grip.unknowns() } else { 2 * self.layout.line.len() }
    }

    /// The front of the last column with the unknowns of the grip in place of those of the last line; `force` is the residual of that line.
    fn gripped(&self, front: &[f64], jacobian: &[f64], symmetric: bool) -> Vec<f64> {
        let (own, line, n) = (2 * self.layout.front(false), 2 * self.layout.line.len(), self.grip.unknowns());
        let (size, after) = (own + line, own + n);
        let at = |i: usize, j: usize| if symmetric && i > j { front[j * size + i] } else { front[i * size + j] };
        // K G first, then Gᵀ K G
        let mut right = vec![0.0; size * n];
        for i in 0..size {
            let row = &mut right[i * n..][..n];
            for k in 0..line {
                let value = at(i, own + k);
                let jacobian = &jacobian[k * n..][..n];
                row.iter_mut().zip(jacobian).for_each(|(row, g)| *row += value * g);
            }
        }
        let mut found = vec![0.0; after * after];
        for i in 0..own {
            found[i * after..][..own].copy_from_slice(&front[i * size..][..own]);
            found[i * after + own..][..n].copy_from_slice(&right[i * n..][..n]);
        }
        for k in 0..line {
            for a in 0..n {
                let g = jacobian[k * n + a];
                if g == 0.0 {
                    continue;
                }
                let row = &mut found[(own + a) * after..][..after];
                let (left, rest) = row.split_at_mut(own);
                if !symmetric {
                    left.iter_mut().enumerate().for_each(|(j, left)| *left += g * at(own + k, j));
                }
                rest.iter_mut().zip(&right[(own + k) * n..][..n]).for_each(|(rest, value)| *rest += g * value);
            }
        }
        found
    }

    /// Adds one row's elements of a column to the front; what is inside them is eliminated.
    fn add_element(
        &self,
        displacements: &[f64],
        (column, row): (usize, usize),
        factors: &mut Factors,
        residual: &mut [f64],
    ) -> Result<(f64, Pivots), SolveError> {
        let Factors { elements, work, front, .. } = factors;
        let symmetric = self.has_potential();
        self.element_at(displacements, (column, row), true, work);
        if !work.energy.is_finite() || !work.residual.iter().all(|value| value.is_finite()) {
            return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place: self.place(column) });
        }
        self.scatter(&work.residual, (column, row), residual);
        let (inner, size) = (2 * self.rows[row].inner, work.residual.len());
        let mut pivots = Pivots::NONE;
        if inner > 0 {
            let elimination = &mut elements[column * self.mesh.rows() + row];
            pivots = elimination.run(&mut work.matrix, size, inner, symmetric);
        }
        let places = self.places_in_front(row);
        let width = 2 * self.layout.front(true);
        for (i, &p) in places.iter().enumerate() {
            let from = if symmetric { i } else { 0 };
            let values = &work.matrix[(inner + i) * size + inner..][..places.len()];
            for (&q, value) in places[from..].iter().zip(&values[from..]) {
                let (p, q) = if symmetric { (p.min(q), p.max(q)) } else { (p, q) };
                front[p * width + q] += value;
            }
        }
        Ok((work.energy, pivots))
    }

    /// Σ weights·monitors by all functions.
    fn monitor_gradient(&self, displacements: &[f64], weight: f64) -> Vec<f64> {
        let mut gradient = vec![0.0; displacements.len()];
        let scale = self.gap_scale();
        let unit = weight / self.monitor_norm();
        self.over_contact(displacements, |y, length, add| add(unit * length / (y + scale), &mut gradient));
        gradient
    }

    /// The front: ∫ ln((y + s)/(r_eq + s)) dS over the logarithm at 10 r0, nm.
    fn front_position(&self, displacements: &[f64]) -> f64 {
        let (scale, rest) = (self.gap_scale(), self.rest_gap());
        let mut sum = 0.0;
        self.over_contact(displacements, |y, length, _| sum += length * ((y + scale) / (rest + scale)).ln());
        sum / self.monitor_norm()
    }

    fn monitor_norm(&self) -> f64 {
        let (scale, rest) = (self.gap_scale(), self.rest_gap());
        ((10.0 * self.design.ground.equilibrium_distance + scale) / (rest + scale)).ln()
    }

    fn evaluation(&self, displacements: &[f64], energy: f64) -> Evaluation {
        Evaluation {
            energy,
            monitors: [self.front_position(displacements), 0.0],
            recorded: self.end_rotation(displacements),
        }
    }

    /// Rotation of the end face, by its two corners, rad.
    pub(crate) fn end_rotation(&self, displacements: &[f64]) -> f64 {
        let line = self.layout.line_start(self.layout.columns);
        let [low, high] = [0, self.mesh.rows()].map(|row| 2 * (line + self.layout.vertex(row)));
        let along = displacements[high] - displacements[low];
        (-along).atan2(self.mesh.height() + displacements[high + 1] - displacements[low + 1])
    }
}

/// Gᵀ v of a matrix G with n columns, row by row.
fn transposed_product(matrix: &[f64], vector: &[f64], n: usize) -> Vec<f64> {
    let mut found = vec![0.0; n];
    for (row, value) in matrix.chunks_exact(n).zip(vector) {
        found.iter_mut().zip(row).for_each(|(found, g)| *found += g * value);
    }
    found
}

impl System for SolidStrip {
    fn interface(&self) -> &[Unknown] {
        self.grip.interface()
    }

    fn unknowns(&self, _: &State) -> usize {
        SolidStrip::unknowns(self)
    }

    fn interface_values(&self, at: &State) -> [f64; INTERFACE] {
        let own = &at.values[self.inside() + self.grip.free()..];
        std::array::from_fn(|slot| own.get(slot).copied().unwrap_or(0.0))
    }

    fn place_of(&self, slot: usize, _: &State) -> usize {
        self.inside() + self.grip.free() + slot
    }

    fn is_conservative(&self) -> bool {
        self.has_potential()
    }

    fn factorise(
        &self,
        at: &State,
        coefficients: Coefficients,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let displacements = self.displacements(&at.values);
        let (inside, columns, rows) = (self.inside(), self.mesh.columns(), self.mesh.rows());
        let symmetric = self.has_potential();
        let factors = ws.factors::<Factors>();
        factors.elements.resize(columns * rows, Elimination::default());
        factors.columns.resize(columns, Elimination::default());
        factors.jacobian = self.grip.jacobian(&at.values[inside..]);
        let mut residual = vec![0.0; displacements.len()];
        let (line, own) = (2 * self.layout.line.len(), 2 * self.layout.front(false));
        let damping = self.design.material.youngs_modulus * self.design.width / coefficients.per_damping;
        let (mut energy, mut pivots) = (0.0, Pivots::NONE);
        factors.carried.clear();
        for column in 0..columns {
            let width = 2 * self.layout.front(true);
            factors.front.clear();
            factors.front.resize(width * width, 0.0);
            if column > 0 {
                for i in 0..line {
                    factors.front[i * width..][..line].copy_from_slice(&factors.carried[i * line..][..line]);
                }
            }
            for row in 0..rows {
                let (added, found) = self.add_element(&displacements, (column, row), factors, &mut residual)?;
                energy += added;
                pivots = pivots.and(found);
            }
            if damping > 0.0 {
                (0..own).for_each(|k| factors.front[k * width + k] += damping);
            }
            if column == 0 {
                hold(&mut factors.front, width, 2 * self.layout.vertex(0));
            }
            let is_last = column + 1 == columns;
            let mut front = std::mem::take(&mut factors.front);
            if is_last {
                front = self.gripped(&front, &factors.jacobian, symmetric);
            }
            let size = own + self.behind(column);
            let found = factors.columns[column].run(&mut front, size, own, symmetric);
            if !found.regular {
                return Err(SolveError::Singular { pivot: found.least, place: self.place(column) });
            }
            pivots = pivots.and(found);
            let left = size - own;
            factors.carried.clear();
            for i in 0..left {
                factors.carried.extend_from_slice(&front[(own + i) * size + own..][..left]);
            }
            factors.front = front;
        }
        let (n, free) = (self.grip.unknowns(), self.grip.free());
        let mut last = std::mem::take(&mut factors.carried);
        if self.grip.is_rigid() {
            let turned = free + ROTATION;
            last[turned * n + turned] += self.grip.curvature(&at.values[inside..], &residual[inside..]);
        }
        if damping > 0.0 {
            (0..n).for_each(|k| last[k * n + k] += damping);
        }
        let found = factors.last.run(&mut last, n, free, symmetric);
        if !found.regular {
            return Err(SolveError::Singular { pivot: found.least, place: self.place(columns - 1) });
        }
        pivots = pivots.and(found);
        let mut residual = self.gathered(&residual, &factors.jacobian);
        self.forward(factors, &mut residual, false);
        let mut condensed = CondensedSystem {
            matrix: [[0.0; INTERFACE]; INTERFACE],
            residual: [0.0; INTERFACE],
            gradient: [0.0; INTERFACE],
            gradient_residual: 0.0,
            negative: pivots.negative,
            least_pivot: pivots.least,
            evaluation: self.evaluation(&displacements, energy),
        };
        let first = inside + free;
        for i in 0..n - free {
            for j in 0..n - free {
                let (row, column) = if symmetric { (i.min(j), i.max(j)) } else { (i, j) };
                condensed.matrix[i][j] = last[(free + row) * n + free + column];
            }
            condensed.residual[i] = residual[first + i];
        }
        factors.carried = last;
        if weights[0] != 0.0 {
            let mut gradient = self.gathered(&self.monitor_gradient(&displacements, weights[0]), &factors.jacobian);
            self.forward(factors, &mut gradient, true);
            condensed.gradient_residual = -gradient[..first].iter().zip(&residual).map(|(g, r)| g * r).sum::<f64>();
            (0..n - free).for_each(|i| condensed.gradient[i] = gradient[first + i]);
        }
        factors.residual = residual;
        Ok(condensed)
    }

    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]) {
        let factors = ws.factored::<Factors>();
        direction.iter_mut().zip(&factors.residual).for_each(|(own, r)| *own = scale * r);
        self.substitute(ws, interface, direction, false);
    }

    fn reduce(&self, ws: &Workspace, right: &mut [f64], transposed: bool) -> [f64; INTERFACE] {
        self.forward(ws.factored::<Factors>(), right, transposed);
        let own = &right[self.inside() + self.grip.free()..];
        std::array::from_fn(|slot| own.get(slot).copied().unwrap_or(0.0))
    }

    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool) {
        let first = self.inside() + self.grip.free();
        let count = right.len() - first;
        right[first..].copy_from_slice(&interface[..count]);
        self.backward(ws.factored::<Factors>(), right, transposed);
    }

    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates) {
        let displacements = self.displacements(&at.values);
        let evaluation = self.evaluation(&displacements, self.assembled(&displacements).0);
        let gradient = System::gradient(self, at, [1.0, 0.0]);
        let rate = gradient.iter().zip(direction).map(|(g, d)| g * d).sum();
        (evaluation, Rates { monitors: [rate, 0.0], recorded: 0.0 })
    }

    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let all = self.monitor_gradient(&self.displacements(&at.values), weights[0]);
        self.gathered(&all, &self.grip.jacobian(&at.values[self.inside()..]))
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        let residual = self.assembled(&self.displacements(&at.values)).1;
        self.gathered(&residual, &self.grip.jacobian(&at.values[self.inside()..]))
    }

    fn per_unit(&self, at: &State) -> Vec<f64> {
        let gaps = self.gaps(&self.displacements(&at.values));
        let unit = |line: usize| 1.0 / (gaps[line].abs() + self.gap_scale());
        let (inside, columns) = (self.inside(), self.mesh.columns());
        let mut units = vec![0.0; self.layout.functions() * 2];
        for column in 0..=columns {
            let first = 2 * self.layout.line_start(column);
            let own = unit(column);
            let next = if column < columns { unit(column + 1).max(own) } else { own };
            let length = self.mesh.length_of(column.min(columns - 1));
            for (k, function) in self.layout.line.iter().enumerate() {
                let share = if function.slope { SLOPE * length } else { 1.0 };
                let is_contact = function.row == 0 && function.bubble.is_none();
                units[first + 2 * k] = OFF_FACE * own * share;
                units[first + 2 * k + 1] = own * share * if is_contact { 1.0 } else { OFF_FACE };
            }
            if column < columns {
                let end = 2 * self.layout.line_start(column + 1);
                units[first + 2 * self.layout.line.len()..end].fill(OFF_FACE * next);
            }
        }
        units.truncate(inside);
        let last = unit(columns);
        units.resize(inside + self.grip.free(), OFF_FACE * last);
        let interface = [1.0, 0.5 * self.design.height, 1.0];
        units.extend(interface.iter().take(self.interface().len()).map(|share| share * last));
        units
    }

    fn stress_free(&self, _elements: usize) -> State {
        let mesh = Mesh { boundaries: self.mesh.lines.clone(), ..Mesh::default() };
        State { mesh, values: vec![0.0; SolidStrip::unknowns(self)], force: 0.0, history: None }
    }

    fn admits(&self, from: &State, _monitors: [f64; MONITORS], prediction: &State) -> bool {
        let [before, after] = [from, prediction].map(|at| self.gaps(&self.displacements(&at.values)));
        let scale = self.gap_scale();
        before.iter().zip(&after).all(|(before, after)| (after - before).abs() <= MOST_GAP_CHANGE * (before + scale))
    }

    fn is_admissible(&self, at: &State) -> bool {
        let nearest = NEAREST * self.rest_gap();
        self.gaps(&self.displacements(&at.values)).into_iter().all(|gap| gap > nearest)
    }
}

/// Replaces the equation of an unknown by that it stays.
fn hold(front: &mut [f64], width: usize, unknown: usize) {
    for k in 0..width {
        front[unknown * width + k] = 0.0;
        front[k * width + unknown] = 0.0;
    }
    front[unknown * width + unknown] = 1.0;
}
