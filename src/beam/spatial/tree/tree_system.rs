//! The tree of beams as a [`System`]: what a solver asks of it. Its interface is the root.

use super::beam_tree::{ANGLES, ASIDE, BeamTree, TreeBranch};
use super::branching_beam::{JointUnknown, TreeMonitor};
use super::sweep::Added;
use crate::beam::spatial::chain::read::normalise;
use crate::beam::spatial::chain::room::SpatialFactors;
use crate::beam::spatial::end_rotation::{EndRotation, turned};
use crate::beam::spatial::rotation::apply_transposed;
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::beam::spatial::shared_system::{node_difference, step_node};
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, Mesh, State, weighted_sum};
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
    pub(super) fn evaluation(&self, at: &State, [energy, adhering]: [f64; 2]) -> Evaluation {
        let value = |monitor: TreeMonitor| match monitor {
            TreeMonitor::AdheringLength => adhering,
            TreeMonitor::PadsAside => self.mean_of_pads(|pad| at.values[pad * N + ASIDE]),
            TreeMonitor::Joint(JointUnknown { joint, slot }) => self.end_of[joint]
                .map_or(at.values[joint * N + slot.min(2)], |end| self.end_values(&at.values, end)[slot]),
        };
        Evaluation { energy, monitors: self.monitors.map(|monitor| monitor.map_or(0.0, value)), recorded: 0.0 }
    }

    /// What the unknowns of a node are measured by whose height has this unit.
    fn units(&self, height: f64) -> [f64; F] {
        let [place, turn] = self.scale;
        [place, height, place, turn, turn, turn]
    }

    /// What damps the unknowns of a branch per length and in a unit of time: its energy per length, of 1 nN where nothing adheres, over a scale
    /// squared.
    pub(super) fn damping(&self, branch: &TreeBranch) -> [f64; F] {
        let (energy, height) = match &branch.adhering {
            None => (1.0, self.scale[0]),
            Some(sections) => (sections.lying.energy.abs(), sections.lying.gap_scale),
        };
        self.units(height).map(|unit| energy / (unit * unit))
    }

    fn mean_of_pads(&self, of: impl Fn(usize) -> f64) -> f64 {
        self.pads.iter().map(|&pad| of(pad)).sum::<f64>() / self.pads.len().max(1) as f64
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

    /// Values of the interface in the stress-free configuration: where displacements of the root are zero.
    pub fn interface_at_rest(&self) -> [f64; INTERFACE] {
        self.end_values(&self.stress_free(0).values, 0)
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
        // of an infinite time there is none
        let added = Added { damping: 1.0 / coefficients.per_damping, nodal: NodalTerms::NONE };
        let root = self.eliminate_with(at, weights, added, ws.factors::<SpatialFactors>())?;
        Ok(root.condensed(self.evaluation(at, root.integrals)))
    }

    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]) {
        ws.factored::<SpatialFactors>().recover(interface, scale, direction);
    }

    fn reduce(&self, ws: &Workspace, right: &mut [f64], transposed: bool) -> [f64; INTERFACE] {
        ws.factored::<SpatialFactors>().reduce(right, transposed)
    }

    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool) {
        ws.factored::<SpatialFactors>().substitute(interface, right, transposed);
    }

    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates) {
        let rate = |monitor: TreeMonitor| match monitor {
            TreeMonitor::Joint(JointUnknown { joint, slot }) => direction[joint * F + slot],
            TreeMonitor::PadsAside => self.mean_of_pads(|pad| direction[pad * F + ASIDE]),
            TreeMonitor::AdheringLength => {
                self.adhering_gradient(at).iter().zip(direction).map(|(by, change)| by * change).sum()
            }
        };
        let monitors = self.monitors.map(|monitor| monitor.map_or(0.0, rate));
        (self.evaluation(at, self.energies(at)), Rates { monitors, recorded: 0.0 })
    }

    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let weight = self.weight_of_adhering(weights);
        let mut gradient = if weight == 0.0 { vec![0.0; self.unknowns(at)] } else { self.adhering_gradient(at) };
        gradient.iter_mut().for_each(|entry| *entry *= weight);
        for (monitor, weight) in self.monitors.iter().zip(weights) {
            match monitor {
                Some(TreeMonitor::Joint(unknown)) => gradient[unknown.joint * F + unknown.slot] += weight,
                Some(TreeMonitor::PadsAside) => {
                    self.pads.iter().for_each(|&pad| gradient[pad * F + ASIDE] += weight / self.pads.len() as f64);
                }
                Some(TreeMonitor::AdheringLength) | None => {}
            }
        }
        gradient
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        self.residual_of(at)
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

    fn size(&self, direction: &[f64], at: &State) -> f64 {
        let (mut largest, mut sum) = (0.0f64, 0.0);
        for (step, height) in direction.chunks_exact(F).zip(self.height_units(at)) {
            let units = self.units(height);
            for f in 0..F {
                let size = step[f].abs() / units[f];
                sum += size;
                largest = largest.max(size);
            }
        }
        if f64::is_finite(sum) { largest } else { f64::NAN }
    }

    fn per_unit(&self, at: &State) -> Vec<f64> {
        self.height_units(at).into_iter().flat_map(|height| self.units(height).map(|unit| 1.0 / unit)).collect()
    }

    fn stress_free(&self, _: usize) -> State {
        self.laid_along(|joint| self.at_rest[joint], |branch, s| self.branches[branch].rest.at(s))
    }

    fn refocused(&self, at: &State, _: [f64; MONITORS]) -> State {
        self.resampled(at, self.mesh_near(&self.follows(at), &at.mesh))
    }

    fn mesh_for(&self, _: [f64; MONITORS], follows: &[f64], like: &Mesh) -> Mesh {
        self.mesh_near(follows, like)
    }

    fn aligned(&self, at: &State, _: [f64; MONITORS]) -> State {
        self.shifted(at, self.mesh_near(&self.follows(at), &at.mesh))
    }

    fn remeshed(&self, at: &State) -> Option<State> {
        let follows = self.follows(at);
        self.has_moved(&follows, &at.mesh).then(|| self.resampled(at, self.mesh_near(&follows, &at.mesh)))
    }

    /// Every joint and node moved and turned alike, by `size`.
    fn disturbance(&self, at: &State, size: f64) -> Vec<f64> {
        (0..self.unknowns(at)).map(|k| size * self.scale[k % F / 3]).collect()
    }

    fn admits(&self, from: &State, _: [f64; MONITORS], prediction: &State) -> bool {
        self.stays_clear(from, prediction)
    }

    fn is_admissible(&self, at: &State) -> bool {
        self.is_above_ground(at)
    }
}
