//! A solid spatula as a [`System`]: elimination station by station, from the tip to the end face.

use super::element::ElementWork;
use super::layout::{ELEMENT, OF_FACE};
use super::solid_spatula::SolidSpatula;
use crate::solid::front::{Elimination, Pivots};
use crate::solid::grip::{NAMES, PLACE, ROTATION, per_turn};
use crate::solve::error::{Place, Quantity, SolveError};
use crate::solve::problem::{InitialState, MeasuredBeside, PathMeasure, Problem};
use crate::solve::state::{MONITORS, State};
use crate::solve::system::{Coefficients, CondensedSystem, Evaluation, INTERFACE, Rates, System, Unknown};
use crate::solve::workspace::Workspace;
use rayon::prelude::*;
use std::sync::Arc;

/// Factors of a tangent.
#[derive(Default)]
struct Factors {
    columns: Vec<Elimination>,
    face: Elimination,
    /// The residual, taken down
    residual: Vec<f64>,
    /// What elements add: of columns that are eliminated, and of those behind them
    works: [Vec<ElementWork>; 2],
    front: Vec<f64>,
    carried: Vec<f64>,
}

/// What the elimination of columns has summed so far.
struct Eliminated {
    energy: f64,
    residual: Vec<f64>,
    pivots: Pivots,
}

/// Columns whose elements are computed side by side, while those before them are eliminated: what they add is kept meanwhile.
const AT_ONCE: usize = 16;
/// Share of what changes a displacement off the underside beside one on it, and of the slope by S times the distance of stations.
const OFF_FACE: f64 = 0.1;
const SLOPE: f64 = 0.15;
/// Damping of a slope over that of a displacement times the square of the distance of stations.
const DAMPED_SLOPE: f64 = 0.1;
/// No gap may change by more on one step, relative to itself and the scale of gaps.
const MOST_GAP_CHANGE: f64 = 0.3;
/// How near to the ground a state may come, over the gap at rest.
const NEAREST: f64 = 0.3;
/// Scale of the way of the front, nm.
const FRONT_SCALE: f64 = 10.0;

impl SolidSpatula {
    /// What is to be solved: the spatula in its grip, from rest.
    pub fn problem(self: &Arc<Self>) -> Problem {
        let mut grip = self.drive.conditions(self.half_space.equilibrium_distance, self.end_face.longest());
        // what slides freely is kept where it is
        grip.held[PLACE] |= self.anchored.is_empty();
        let measure = PathMeasure {
            monitors: [FRONT_SCALE, f64::INFINITY],
            force: self.half_space.work_of_adhesion() * self.mean_width(),
            beside: MeasuredBeside::Nothing,
        };
        Problem { system: self.clone(), grip, measure, start: InitialState::Settling }
    }

    /// Mean width of what adheres, nm.
    fn mean_width(&self) -> f64 {
        let mut area = 0.0;
        self.over_underside(&self.at_rest().values, |_, part, _| area += part);
        area / self.mesh.adhering
    }

    fn place(&self, column: usize) -> Place {
        Place { element: column, position: self.mesh.stations[column] }
    }

    /// Energy and residual.
    fn assembled(&self, values: &[f64]) -> (f64, Vec<f64>) {
        let of = |index: usize| {
            let mut work = ElementWork::default();
            self.element_at(values, index, false, &mut work);
            work
        };
        let works: Vec<ElementWork> = (0..self.elements()).into_par_iter().map(of).collect();
        let (mut energy, mut residual) = (0.0, vec![0.0; self.unknowns()]);
        for (index, work) in works.iter().enumerate() {
            energy += work.energy;
            self.scatter(values, work, index, &mut residual);
        }
        self.anchored.iter().for_each(|&anchored| residual[anchored] = 0.0);
        (energy, residual)
    }

    fn scatter(&self, values: &[f64], work: &ElementWork, index: usize, all: &mut [f64]) {
        let start = self.layout.start(self.column_of(index));
        for (place, value) in self.places(index).iter().zip(&work.residual) {
            if let Some(place) = place {
                all[start + place] += value;
            }
        }
        let turned = self.interface_start() + ROTATION;
        for (k, lever) in self.on_end_face(index) {
            let (by, _) = per_turn(self.rotation(values), lever);
            all[turned] += by[0] * work.residual[3 * k] + by[1] * work.residual[3 * k + 1];
        }
    }

    /// Adds the tangent of an element to the front of its column, of this width: its upper triangle.
    fn add_to_front(&self, work: &ElementWork, index: usize, front: &mut [f64], width: usize) {
        let places = self.places(index);
        for (i, row) in places.iter().enumerate() {
            let Some(row) = *row else { continue };
            let values = &work.tangent[i * ELEMENT + i..][..ELEMENT - i];
            for (shift, (column, value)) in places[i..].iter().zip(values).enumerate() {
                let Some(column) = *column else { continue };
                // two numbers of an element may be one unknown of the end face: then both of their entries count
                let (low, high) = (row.min(column), row.max(column));
                let both = if row == column && shift > 0 { 2.0 } else { 1.0 };
                front[low * width + high] += both * value;
            }
        }
    }

    /// Adds what belongs to the rotation of the end face: aᵀK of the other unknowns and aᵀK a + Σ f·∂²u/∂φ², with a = ∂u/∂φ.
    fn add_turn_to_front(&self, values: &[f64], work: &ElementWork, index: usize, front: &mut [f64], width: usize) {
        let turned = self.interface_start() + ROTATION - self.layout.start(self.column_of(index));
        let mut turn = [0.0; ELEMENT];
        for (k, lever) in self.on_end_face(index) {
            let (by, bend) = per_turn(self.rotation(values), lever);
            for axis in 0..2 {
                turn[3 * k + axis] = by[axis];
                front[turned * width + turned] += bend[axis] * work.residual[3 * k + axis];
            }
        }
        let tangent = |i: usize, j: usize| work.tangent[i.min(j) * ELEMENT + i.max(j)];
        for (i, place) in self.places(index).iter().enumerate() {
            let sum: f64 =
                turn.iter().enumerate().filter(|(_, by)| **by != 0.0).map(|(j, by)| tangent(i, j) * by).sum();
            front[turned * width + turned] += turn[i] * sum;
            if let Some(place) = *place {
                front[place.min(turned) * width + place.max(turned)] += sum;
            }
        }
    }

    /// The distance of stations next to one, nm.
    fn spacing(&self, station: usize) -> f64 {
        let column = station.min(self.layout.columns - 1);
        self.mesh.stations[column + 1] - self.mesh.stations[column]
    }

    /// The diagonal of the damping of the unknowns of a station, over E.
    fn damping(&self, station: usize) -> Vec<f64> {
        let slope = DAMPED_SLOPE * self.spacing(station).powi(2);
        if station == self.layout.columns {
            let mut damping = vec![slope; self.layout.face - OF_FACE];
            let turn = self.end_face.longest().powi(2);
            damping.extend((0..OF_FACE).map(|slot| if slot == ROTATION { turn } else { 1.0 }));
            return damping;
        }
        self.layout.station.iter().map(|unknown| if unknown.slope { slope } else { 1.0 }).collect()
    }

    /// A right-hand side taken down to the interface.
    fn forward(&self, factors: &Factors, right: &mut [f64], transposed: bool) {
        for (column, elimination) in factors.columns.iter().enumerate() {
            let start = self.layout.start(column);
            let size = self.layout.at(column) + self.layout.at(column + 1);
            elimination.forward(&mut right[start..start + size], transposed);
        }
        factors.face.forward(&mut right[self.layout.start(self.layout.columns)..], transposed);
    }

    /// From a right-hand side that was taken down, with the solution on the interface, to the whole.
    fn backward(&self, factors: &Factors, right: &mut [f64], transposed: bool) {
        factors.face.backward(&mut right[self.layout.start(self.layout.columns)..], transposed);
        for (column, elimination) in factors.columns.iter().enumerate().rev() {
            let start = self.layout.start(column);
            let size = self.layout.at(column) + self.layout.at(column + 1);
            elimination.backward(&mut right[start..start + size], transposed);
        }
    }

    /// ∫ ln((y + s)/(r_eq + s)) dA over the mean width, and over the logarithm at 10 r0, nm: how far the front has gone.
    fn front_position(&self, values: &[f64]) -> f64 {
        let (scale, rest, mut sum) = (self.gap_scale(), self.half_space.equilibrium_gap(), 0.0);
        self.over_underside(values, |gap, area, _| sum += area * ((gap + scale) / (rest + scale)).ln());
        sum / self.front_norm()
    }

    fn front_norm(&self) -> f64 {
        let (scale, rest) = (self.gap_scale(), self.half_space.equilibrium_gap());
        self.mean_width() * ((10.0 * self.half_space.equilibrium_distance + scale) / (rest + scale)).ln()
    }

    fn evaluation(&self, values: &[f64], energy: f64) -> Evaluation {
        let monitors = [self.front_position(values), 0.0];
        Evaluation { energy, monitors, recorded: self.end_rotation(values) }
    }

    /// Eliminates the unknowns of the left station of a column, of which this is what its elements add.
    fn eliminate(
        &self,
        values: &[f64],
        (column, works): (usize, &[ElementWork]),
        damping: f64,
        factors: &mut Factors,
        eliminated: &mut Eliminated,
    ) -> Result<(), SolveError> {
        let (layout, Eliminated { energy, residual, pivots }) = (&self.layout, eliminated);
        let Factors { columns: eliminations, front, carried, .. } = factors;
        let (own, next) = (layout.at(column), layout.at(column + 1));
        let width = own + next;
        front.clear();
        front.resize(width * width, 0.0);
        for (i, row) in carried.chunks_exact(own).enumerate() {
            front[i * width..][..own].copy_from_slice(row);
        }
        for (strip, work) in works.iter().enumerate() {
            let index = column * layout.strips + strip;
            if !work.energy.is_finite() || !work.residual.iter().all(|value| value.is_finite()) {
                return Err(SolveError::NotFinite { quantity: Quantity::Tangent, place: self.place(column) });
            }
            *energy += work.energy;
            self.scatter(values, work, index, residual);
            self.add_to_front(work, index, front, width);
            if column + 1 == layout.columns {
                self.add_turn_to_front(values, work, index, front, width);
            }
        }
        for &anchored in self.anchored.iter().filter(|_| column == 0) {
            residual[anchored] = 0.0;
            (0..width).for_each(|k| (front[anchored * width + k], front[k * width + anchored]) = (0.0, 0.0));
            front[anchored * width + anchored] = self.youngs_modulus;
        }
        if damping > 0.0 {
            let own = self.damping(column);
            own.iter().enumerate().for_each(|(k, own)| front[k * width + k] += damping * own);
        }
        let found = eliminations[column].run(front, width, own, true);
        if !found.regular {
            return Err(SolveError::Singular { pivot: found.least, place: self.place(column) });
        }
        *pivots = pivots.and(found);
        carried.clear();
        (own..width).for_each(|row| carried.extend_from_slice(&front[row * width + own..][..next]));
        Ok(())
    }

    /// Elements of a span of columns at these values, with their tangents.
    fn compute(&self, values: &[f64], columns: std::ops::Range<usize>, works: &mut Vec<ElementWork>) {
        let (first, count) = (columns.start * self.layout.strips, columns.len() * self.layout.strips);
        works.resize_with(works.len().max(count), ElementWork::default);
        works[..count].par_iter_mut().enumerate().for_each(|(k, work)| self.element_at(values, first + k, true, work));
    }
}

impl System for SolidSpatula {
    fn interface(&self) -> &[Unknown] {
        &NAMES
    }

    fn unknowns(&self, _: &State) -> usize {
        SolidSpatula::unknowns(self)
    }

    fn interface_values(&self, at: &State) -> [f64; INTERFACE] {
        let own = &at.values[self.interface_start()..];
        std::array::from_fn(|slot| own.get(slot).copied().unwrap_or(0.0))
    }

    fn place_of(&self, slot: usize, _: &State) -> usize {
        self.interface_start() + slot
    }

    fn factorise(
        &self,
        at: &State,
        coefficients: Coefficients,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let (layout, values) = (&self.layout, &at.values);
        let columns = layout.columns;
        let factors = ws.factors::<Factors>();
        factors.columns.resize(columns, Elimination::default());
        let damping = self.youngs_modulus / coefficients.per_damping;
        let mut eliminated = Eliminated { energy: 0.0, residual: vec![0.0; layout.unknowns()], pivots: Pivots::NONE };
        factors.carried.clear();
        let [mut own, mut behind] = std::mem::take(&mut factors.works);
        self.compute(values, 0..AT_ONCE.min(columns), &mut own);
        for first in (0..columns).step_by(AT_ONCE) {
            let last = (first + AT_ONCE).min(columns);
            let next = last..(last + AT_ONCE).min(columns);
            let (found, ()) = rayon::join(
                || {
                    (first..last).try_for_each(|column| {
                        let works = &own[(column - first) * layout.strips..][..layout.strips];
                        self.eliminate(values, (column, works), damping, factors, &mut eliminated)
                    })
                },
                || self.compute(values, next, &mut behind),
            );
            found?;
            std::mem::swap(&mut own, &mut behind);
        }
        factors.works = [own, behind];
        let Eliminated { energy, mut residual, mut pivots } = eliminated;
        let (n, free) = (layout.face, layout.face - OF_FACE);
        let mut last = std::mem::take(&mut factors.carried);
        if damping > 0.0 {
            self.damping(columns).iter().enumerate().for_each(|(k, own)| last[k * n + k] += damping * own);
        }
        let found = factors.face.run(&mut last, n, free, true);
        if !found.regular {
            return Err(SolveError::Singular { pivot: found.least, place: self.place(columns - 1) });
        }
        pivots = pivots.and(found);
        self.forward(factors, &mut residual, false);
        let first = self.interface_start();
        let mut condensed = CondensedSystem {
            matrix: [[0.0; INTERFACE]; INTERFACE],
            residual: [0.0; INTERFACE],
            gradient: [0.0; INTERFACE],
            gradient_residual: 0.0,
            negative: pivots.negative,
            least_pivot: pivots.least,
            evaluation: self.evaluation(values, energy),
        };
        for i in 0..OF_FACE {
            for j in 0..OF_FACE {
                condensed.matrix[i][j] = last[(free + i.min(j)) * n + free + i.max(j)];
            }
            condensed.residual[i] = residual[first + i];
        }
        factors.carried = last;
        if weights[0] != 0.0 {
            let mut gradient = self.gradient(at, weights);
            self.forward(factors, &mut gradient, true);
            condensed.gradient_residual = -gradient[..first].iter().zip(&residual).map(|(g, r)| g * r).sum::<f64>();
            (0..OF_FACE).for_each(|i| condensed.gradient[i] = gradient[first + i]);
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
        let own = &right[self.interface_start()..];
        std::array::from_fn(|slot| own.get(slot).copied().unwrap_or(0.0))
    }

    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool) {
        let first = self.interface_start();
        right[first..].copy_from_slice(&interface[..OF_FACE]);
        self.backward(ws.factored::<Factors>(), right, transposed);
    }

    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates) {
        let evaluation = self.evaluation(&at.values, self.assembled(&at.values).0);
        let gradient = self.gradient(at, [1.0, 0.0]);
        let rate = gradient.iter().zip(direction).map(|(g, d)| g * d).sum();
        (evaluation, Rates { monitors: [rate, 0.0], recorded: direction[self.interface_start() + ROTATION] })
    }

    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let mut gradient = vec![0.0; at.values.len()];
        let (scale, unit) = (self.gap_scale(), weights[0] / self.front_norm());
        self.over_underside(&at.values, |gap, area, add| add(unit * area / (gap + scale), &mut gradient));
        self.anchored.iter().for_each(|&anchored| gradient[anchored] = 0.0);
        gradient
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        self.assembled(&at.values).1
    }

    fn per_unit(&self, at: &State) -> Vec<f64> {
        let gaps = self.gaps(&at.values);
        let unit = |station: usize| 1.0 / (gaps[station].abs() + self.gap_scale());
        let mut units = Vec::with_capacity(at.values.len());
        for station in 0..self.layout.columns {
            let own = unit(station);
            let slope = SLOPE * self.spacing(station);
            units.extend(self.layout.station.iter().map(|unknown| {
                let is_gap = unknown.through == 0 && unknown.axis == 1;
                own * if unknown.slope { slope } else { 1.0 } * if is_gap { 1.0 } else { OFF_FACE }
            }));
        }
        let last = unit(self.layout.columns);
        let slopes = self.layout.face - OF_FACE;
        units.resize(units.len() + slopes, OFF_FACE * SLOPE * last * self.spacing(self.layout.columns));
        let turn = self.end_face.longest() * last;
        units.extend((0..OF_FACE).map(|slot| if slot == ROTATION { turn } else { last }));
        units
    }

    fn stress_free(&self, _elements: usize) -> State {
        self.at_rest()
    }

    fn disturbance(&self, at: &State, size: f64) -> Vec<f64> {
        self.per_unit(at).into_iter().map(|unit| size / unit.max(f64::MIN_POSITIVE)).collect()
    }

    fn admits(&self, from: &State, _monitors: [f64; MONITORS], prediction: &State) -> bool {
        let [before, after] = [from, prediction].map(|at| self.gaps(&at.values));
        let scale = self.gap_scale();
        let change = |(before, after): (&f64, &f64)| (after - before).abs() <= MOST_GAP_CHANGE * (before + scale);
        before.iter().zip(&after).take(self.adhering_stations()).all(change)
    }

    fn is_admissible(&self, at: &State) -> bool {
        let nearest = NEAREST * self.half_space.equilibrium_gap();
        self.gaps(&at.values).into_iter().take(self.adhering_stations()).all(|gap| gap > nearest)
    }
}
