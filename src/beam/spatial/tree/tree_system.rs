//! The tree of beams as a [`System`]: what a solver asks of it. Its interface is the root.

use super::beam_tree::{ANGLES, BeamTree};
use super::branching_beam::JointUnknown;
use super::factors::TreeFactors;
use super::sweep::Added;
use crate::beam::element::basis::slot;
use crate::beam::spatial::chain::read::normalise;
use crate::beam::spatial::end_rotation::{EndRotation, turned};
use crate::beam::spatial::rotation::{Quaternion, apply_transposed};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::beam::spatial::shared_system::{condensed, node_difference, step_node, weighted_sum};
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, Mesh, State};
use crate::solve::system::{Coefficients, CondensedSystem, Evaluation, INTERFACE, NodalTerms, Rates, System, Unknown};
use crate::solve::workspace::Workspace;

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

const ROOT: [Unknown; 6] = [
    Unknown { name: "place of the root along its first axis", unit: "nm" },
    Unknown { name: "place of the root along its second axis", unit: "nm" },
    Unknown { name: "place of the root along its third axis", unit: "nm" },
    Unknown { name: "rotation of the root", unit: "rad" },
    Unknown { name: "yaw of the root", unit: "rad" },
    Unknown { name: "roll of the root", unit: "rad" },
];

impl BeamTree {
    pub(super) fn evaluation(&self, at: &State, energy: f64) -> Evaluation {
        let value = |unknown: JointUnknown| {
            self.end_of[unknown.joint].map_or(at.values[unknown.joint * N + unknown.slot.min(2)], |end| {
                self.end_values(&at.values, end)[unknown.slot]
            })
        };
        Evaluation { energy, monitors: self.monitors.map(|unknown| unknown.map_or(0.0, value)), recorded: 0.0 }
    }

    /// Damping of places and of turns per length: energy of 1 nN times length over a scale squared, over a time.
    fn damping(&self, coefficients: Coefficients) -> [f64; 2] {
        let time = coefficients.per_damping;
        if time.is_infinite() { [0.0; 2] } else { self.scale.map(|scale| 1.0 / (scale * scale * time)) }
    }

    /// Makes the quaternions of a state's values ones of length one, those of ends with angles the ones that these say.
    fn settle_rotations(&self, values: &mut [f64]) {
        values[..self.nodes * N].chunks_exact_mut(N).for_each(normalise);
        for (end, own) in self.ends.iter().enumerate() {
            if own.own.rotation == EndRotation::Angles {
                let q = turned(self.angles(values, end), own.own.rest);
                values[own.joint * N + 3..(own.joint + 1) * N].copy_from_slice(&q);
            }
        }
    }

    /// Values in the stress-free configuration.
    fn rest_values(&self) -> Vec<f64> {
        self.values_along(|joint| self.at_rest[joint], |branch, s| self.branches[branch].rest.at(s))
    }

    /// A state whose joints, and sections of branches at S (nm), have these places and directors. Nothing says that it is in equilibrium. Angles
    /// of ends are zero.
    pub fn laid_along(
        &self,
        joint: impl Fn(usize) -> ([f64; 3], Quaternion),
        section: impl Fn(usize, f64) -> ([f64; 3], Quaternion),
    ) -> State {
        State { values: self.values_along(joint, section), mesh: Mesh::default(), force: 0.0, history: None }
    }

    fn values_along(
        &self,
        joint: impl Fn(usize) -> ([f64; 3], Quaternion),
        section: impl Fn(usize, f64) -> ([f64; 3], Quaternion),
    ) -> Vec<f64> {
        let mut values = vec![0.0; self.nodes * N + self.ends.len() * ANGLES];
        let mut put = |node: usize, (place, q): ([f64; 3], Quaternion)| {
            values[node * N..node * N + 3].copy_from_slice(&place);
            values[node * N + 3..(node + 1) * N].copy_from_slice(&q);
        };
        (0..self.joints()).for_each(|own| put(own, joint(own)));
        let (order, last) = (self.order(), self.order() + 1);
        for (b, branch) in self.branches.iter().enumerate() {
            for e in 0..branch.elements {
                for rank in (0..last).filter(|&rank| branch.end_at(order, e, rank).is_none()) {
                    let share = 0.5 * (1.0 + self.basis.nodes[slot(last, rank)]);
                    let (from, to) = (branch.boundary(e), branch.boundary(e + 1));
                    put(branch.node(order, e, rank), section(b, from + share * (to - from)));
                }
            }
        }
        values
    }

    /// Values of the interface in the stress-free configuration: where displacements of the root are zero.
    pub fn interface_at_rest(&self) -> [f64; INTERFACE] {
        self.end_values(&self.rest_values(), 0)
    }
}

impl System for BeamTree {
    fn interface(&self) -> &[Unknown] {
        &ROOT
    }

    fn unknowns(&self, _: &State) -> usize {
        self.nodes * F
    }

    fn interface_values(&self, at: &State) -> [f64; INTERFACE] {
        self.end_values(&at.values, 0)
    }

    fn place_of(&self, slot: usize, _: &State) -> usize {
        self.root() * F + slot
    }

    fn is_conservative(&self) -> bool {
        self.ends.iter().all(|end| end.own.dead_load[1] == [0.0; 3])
    }

    fn has_near_branches(&self) -> bool {
        true
    }

    fn factorise(
        &self,
        at: &State,
        coefficients: Coefficients,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let damping = self.damping(coefficients);
        let added = Added { damping, nodal: NodalTerms::NONE };
        let root = self.eliminate_with(&at.values, weights, added, ws.factors::<TreeFactors>())?;
        Ok(condensed(&root.matrix, (root.negative, root.least_pivot), self.evaluation(at, root.energy)))
    }

    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]) {
        self.recover(ws.factored::<TreeFactors>(), interface, scale, direction);
    }

    fn reduce(&self, ws: &Workspace, right: &mut [f64], transposed: bool) -> [f64; INTERFACE] {
        self.reduce(ws.factored::<TreeFactors>(), right, transposed)
    }

    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool) {
        self.substitute(ws.factored::<TreeFactors>(), interface, right, transposed);
    }

    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates) {
        let rate = |unknown: JointUnknown| direction[unknown.joint * F + unknown.slot];
        let monitors = self.monitors.map(|unknown| unknown.map_or(0.0, rate));
        (self.evaluation(at, self.energy(&at.values)), Rates { monitors, recorded: 0.0 })
    }

    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let mut gradient = vec![0.0; self.unknowns(at)];
        for (monitor, weight) in self.monitors.iter().zip(weights) {
            if let Some(unknown) = monitor {
                gradient[unknown.joint * F + unknown.slot] += weight;
            }
        }
        gradient
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        self.residual_of(&at.values)
    }

    fn retract(&self, at: &mut State, direction: &[f64], factor: f64) {
        let (fields, angles) = at.values.split_at_mut(self.nodes * N);
        for (k, (node, step)) in fields.chunks_exact_mut(N).zip(direction.chunks_exact(F)).enumerate() {
            let step: [f64; F] = std::array::from_fn(|f| factor * step[f]);
            let end = self.end_of.get(k).copied().flatten();
            let own = end.map(|end| (&self.ends[end].own, &mut angles[ANGLES * end..ANGLES * (end + 1)]));
            step_node(node, step, own);
        }
    }

    fn difference(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let last = self.nodes * N;
        let mut direction = Vec::with_capacity(self.nodes * F);
        for (a, b) in from[..last].chunks_exact(N).zip(to[..last].chunks_exact(N)) {
            direction.extend(node_difference(a, b));
        }
        for (end, own) in self.ends.iter().enumerate() {
            let place = &mut direction[own.joint * F..(own.joint + 1) * F];
            let along = apply_transposed(&own.own.axes, &[place[0], place[1], place[2]]);
            place[..3].copy_from_slice(&along);
            if own.own.rotation == EndRotation::Angles {
                let (to, from) = (self.angles(to, end), self.angles(from, end));
                (0..3).for_each(|i| place[3 + i] = to[i] - from[i]);
            }
        }
        direction
    }

    /// Places and angles are combined; quaternions too, and made ones of length one: that commutes with any turn of the whole.
    fn combine(&self, states: &[&[f64]], weights: &[f64]) -> Vec<f64> {
        let mut sum = weighted_sum(states, weights);
        self.settle_rotations(&mut sum);
        sum
    }

    fn miss(&self, reached: &[f64], states: &[&[f64]], weights: &[f64], out: &mut Vec<f64>) {
        *out = self.difference(&self.combine(states, weights), reached);
    }

    fn size(&self, direction: &[f64], _: &State) -> f64 {
        let (mut largest, mut sum) = (0.0f64, 0.0);
        for (k, step) in direction.iter().enumerate() {
            let size = step.abs() / self.scale[k % F / 3];
            sum += size;
            largest = largest.max(size);
        }
        if f64::is_finite(sum) { largest } else { f64::NAN }
    }

    fn per_unit(&self, _: &State) -> Vec<f64> {
        (0..self.nodes * F).map(|k| 1.0 / self.scale[k % F / 3]).collect()
    }

    fn stress_free(&self, _: usize) -> State {
        State { values: self.rest_values(), mesh: Mesh::default(), force: 0.0, history: None }
    }

    /// Every joint and node moved and turned alike, by `size`.
    fn disturbance(&self, at: &State, size: f64) -> Vec<f64> {
        (0..self.unknowns(at)).map(|k| size * self.scale[k % F / 3]).collect()
    }
}
