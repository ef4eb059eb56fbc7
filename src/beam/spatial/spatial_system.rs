//! The beam in space as a [`System`]: what a solver asks of it. Its interface is the right end.

use super::chain::fields_along::FieldsAlong;
use super::chain::room::SpatialFactors;
use super::chain::spatial_chain::{SpatialConfiguration, SpatialFunctional, quaternion_of};
use super::end_rotation::EndRotation;
use super::rotation::{apply, apply_transposed, cross, matrix};
use super::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use super::shared_system::{node_difference, step_node};
use super::spatial_beam::{ANGLES, SpatialBeam};
use crate::beam::element::integrand::Integrand;
use crate::beam::element::integration::ElementEnergy;
use crate::beam::mesh::{MeshKind, nodal_lengths};
use crate::beam::planar::planar_beam::{FRONT, TIP_ROTATION};
use crate::solve::error::SolveError;
use crate::solve::state::{MONITORS, Mesh, State, weighted_sum};
use crate::solve::system::{
    Coefficients, CondensedSystem, EndRoll, Evaluation, INTERFACE, NodalTerms, Rates, System, Unknown,
};
use crate::solve::workspace::Workspace;

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

const RIGHT_END: [Unknown; 6] = [
    Unknown { name: "place of the right end along the pull", unit: "nm" },
    Unknown { name: "place of the right end across the pull", unit: "nm" },
    Unknown { name: "place of the right end sideways", unit: "nm" },
    Unknown { name: "rotation of the right end", unit: "rad" },
    Unknown { name: "yaw of the right end", unit: "rad" },
    Unknown { name: "roll of the right end", unit: "rad" },
];

/// The mesh is renewed when the front has moved by this share of the process zone.
pub(super) const MOVED: f64 = 0.3;
/// A beam of which less than this share of the process zone adheres is loose.
const LOOSE: f64 = 0.1;
/// One step takes a loose beam no nearer to the ground than this share of its distance.
pub(super) const NEARER: f64 = 0.6;

impl SpatialBeam {
    fn nodes(&self, values: &[f64]) -> usize {
        (values.len() - ANGLES) / N
    }

    fn evaluation(&self, at: &State, chain: ElementEnergy) -> Evaluation {
        let angles = self.configuration(at).angles;
        Evaluation {
            energy: chain.total,
            monitors: [self.front(chain.coverage), angles[0][0]],
            recorded: self.rotation_of_grip(at),
        }
    }

    /// θ of the right end, rad.
    pub(crate) fn rotation_of_grip(&self, at: &State) -> f64 {
        self.angles_of_grip(at)[0]
    }

    fn diagonal(&self, at: &State, coefficients: Coefficients) -> Vec<f64> {
        let time = coefficients.per_damping;
        if time.is_infinite() {
            return Vec::new();
        }
        let lengths = nodal_lengths(&at.mesh.boundaries, self.chain.order());
        let energy = if self.adheres() { self.rest_adhesion.abs() } else { 1.0 };
        let damping = |length: f64, f: usize| energy * length / self.scale[f / 3].powi(2) / time;
        lengths.iter().flat_map(|&length| (0..F).map(move |f| damping(length, f))).collect()
    }

    /// The chain eliminated down to its right end, as it is `seen` in a step, with terms of single unknowns added and Σ weights·monitors carried along.
    pub(super) fn condensed_with(
        &self,
        at: &State,
        seen: SpatialConfiguration,
        added: NodalTerms,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let mut row = SpatialFunctional { coverage: self.front(weights[FRONT]), left: [0.0; F] };
        row.left[3] = weights[TIP_ROTATION];
        let root = self.chain.eliminate(seen, &row, added, ws.factors::<SpatialFactors>())?;
        let [total, coverage] = root.integrals;
        Ok(root.condensed(self.evaluation(at, ElementEnergy { total, coverage })))
    }
}

impl System for SpatialBeam {
    fn interface(&self) -> &[Unknown] {
        &RIGHT_END
    }

    fn unknowns(&self, at: &State) -> usize {
        self.nodes(&at.values) * F
    }

    fn interface_values(&self, at: &State) -> [f64; INTERFACE] {
        let mut values = self.chain.end_values(self.configuration(at), 1);
        if self.chain.ends[1].rotation == EndRotation::Free {
            values[3..].fill(0.0);
        }
        values
    }

    fn place_of(&self, slot: usize, at: &State) -> usize {
        (self.nodes(&at.values) - 1) * F + slot
    }

    fn is_conservative(&self) -> bool {
        self.chain.ends[1].dead_load[1] == [0.0; 3] && self.chain.density.is_symmetric()
    }

    fn has_near_branches(&self) -> bool {
        true
    }

    fn roll(&self, at: &State) -> Option<EndRoll> {
        Some(self.roll_of_grip(at))
    }

    fn round_off(&self) -> f64 {
        self.round_off
    }

    fn factorise(
        &self,
        at: &State,
        coefficients: Coefficients,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let diagonal = self.diagonal(at, coefficients);
        self.condensed_with(at, self.configuration(at), NodalTerms { stiffness: &diagonal, force: &[] }, weights, ws)
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
        let (energy, adhesion) = self.chain.energy(self.configuration(at), direction);
        let recorded = match self.chain.ends[1].rotation {
            EndRotation::Angles => direction[direction.len() - F + 3],
            EndRotation::Free => self.rotation_rate(at, direction),
        };
        let rates = Rates { monitors: [self.front(adhesion), direction[3]], recorded };
        (self.evaluation(at, energy), rates)
    }

    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let mut gradient = if weights[FRONT] == 0.0 {
            vec![0.0; self.unknowns(at)]
        } else {
            self.chain.coverage_gradient(self.configuration(at))
        };
        gradient.iter_mut().for_each(|entry| *entry = weights[FRONT] * self.front(*entry));
        gradient[3] += weights[TIP_ROTATION];
        gradient
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        self.chain.residual(self.configuration(at))
    }

    fn retract(&self, at: &mut State, direction: &[f64], factor: f64) {
        let nodes = self.nodes(&at.values);
        let (fields, known) = at.values.split_at_mut(nodes * N);
        for (k, (node, step)) in fields.chunks_exact_mut(N).zip(direction.chunks_exact(F)).enumerate() {
            let step: [f64; F] = std::array::from_fn(|f| factor * step[f]);
            let end = if k == 0 { Some(0) } else { (k + 1 == nodes).then_some(1) };
            step_node(node, step, end.map(|end| (&self.chain.ends[end], &mut known[3 * end..3 * end + 3])));
        }
        self.count_turns(at);
    }

    fn difference(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let nodes = self.nodes(from);
        let mut direction = Vec::with_capacity(nodes * F);
        for (a, b) in from[..nodes * N].chunks_exact(N).zip(to[..nodes * N].chunks_exact(N)) {
            direction.extend(node_difference(a, b));
        }
        let last = direction.len() - F;
        for (end, at) in [(0, 0), (1, last)] {
            let own = &self.chain.ends[end];
            let moved = [direction[at], direction[at + 1], direction[at + 2]];
            direction[at..at + 3].copy_from_slice(&apply_transposed(&own.axes, &moved));
            if own.rotation == EndRotation::Angles {
                let angle = nodes * N + 3 * end;
                (0..3).for_each(|i| direction[at + 3 + i] = to[angle + i] - from[angle + i]);
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
        for (step, unit) in direction.chunks_exact(F).zip(self.place_units(at)) {
            for f in 0..F {
                let size = step[f].abs() / if f < 3 { unit } else { self.scale[1] };
                sum += size;
                largest = largest.max(size);
            }
        }
        if sum.is_finite() { largest } else { f64::NAN }
    }

    fn per_unit(&self, at: &State) -> Vec<f64> {
        let turn = 1.0 / self.scale[1];
        let of = |unit: f64| [1.0 / unit, 1.0 / unit, 1.0 / unit, turn, turn, turn];
        self.place_units(at).flat_map(of).collect()
    }

    fn stress_free(&self, elements: usize) -> State {
        let mesh = self.mesh_at(self.rest.fronts().near(self.rest.front(self.length)), &[0.0; 2], elements);
        let mut values = self.rest_values(&mesh.boundaries);
        self.settle_rotations(&mut values);
        State { values, mesh, force: 0.0, history: None }
    }

    fn on_elements(&self, at: &State, elements: usize) -> State {
        self.resampled(at, self.mesh_at(at.mesh.focus, &at.mesh.follows, elements))
    }

    fn refined(&self, at: &State) -> State {
        let counts = self.mesh.pieces.refined(&at.mesh.boundaries);
        self.resampled(at, self.mesh_of(at.mesh.focus, &at.mesh.follows, &counts, &[]))
    }

    fn refocused(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        let counts = self.mesh.pieces.counted(&at.mesh.boundaries);
        self.resampled(at, self.mesh_of(monitors[FRONT], &self.edges(at, monitors[FRONT]), &counts, &[]))
    }

    fn mesh_for(&self, monitors: [f64; MONITORS], follows: &[f64], like: &Mesh) -> Mesh {
        self.mesh_near(monitors[FRONT], follows, like)
    }

    fn aligned(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        let mesh = self.mesh_near(monitors[FRONT], &self.edges(at, monitors[FRONT]), &at.mesh);
        let mut values = FieldsAlong::of(&self.chain, self.configuration(at)).shifted(&mesh.boundaries);
        values.extend_from_slice(&at.values[values.len()..]);
        self.settle_rotations(&mut values);
        State { mesh, values, force: at.force, history: None }
    }

    fn remeshed(&self, at: &State) -> Option<State> {
        if self.mesh.kind != MeshKind::Moving || !self.adheres() {
            return None;
        }
        let front = self.front_of(at);
        if (self.centered(front) - at.mesh.focus).abs() < MOVED * self.process_length {
            return None;
        }
        Some(self.resampled(at, self.mesh_near(front, &self.edges(at, front), &at.mesh)))
    }

    /// Turned in the plane, the more the farther from the grip, and rolled to the side to which the end is pulled, by as much as moves an
    /// edge by `size` over the scale of a place.
    fn disturbance(&self, at: &State, size: f64) -> Vec<f64> {
        let (nodes, order) = (self.nodes(&at.values), self.chain.order());
        let boundaries = &at.mesh.boundaries;
        let side = if self.chain.ends[1].axes[2][0] < 0.0 { -1.0 } else { 1.0 };
        let mut direction = vec![0.0; nodes * F];
        for (node, fields) in at.values[..nodes * N].chunks_exact(N).enumerate() {
            let element = (node / order).min(boundaries.len() - 2);
            let share = self.chain.node_fraction(node - element * order);
            let place = boundaries[element] + share * (boundaries[element + 1] - boundaries[element]);
            let half = 0.5 * self.chain.density.profile.outline(place)[0];
            let turn = size * self.scale[1] * (1.0 - place / self.length);
            let roll = side * size * (self.scale[0] / half).min(self.scale[1]);
            let own = &mut direction[node * F + 3..(node + 1) * F];
            match node {
                // its angles: the rotation in the plane, the yaw, the roll
                0 => own.copy_from_slice(&[turn, 0.0, roll]),
                _ if node + 1 == nodes => {}
                _ => own.copy_from_slice(&apply_transposed(&matrix(quaternion_of(fields)), &[roll, 0.0, turn])),
            }
        }
        direction
    }

    fn admits(&self, from: &State, monitors: [f64; MONITORS], prediction: &State) -> bool {
        let loose = self.adheres() && monitors[FRONT] < LOOSE * self.process_length;
        !(loose && self.clearance(prediction) < NEARER * self.clearance(from))
    }

    fn is_admissible(&self, at: &State) -> bool {
        !self.adheres() || self.clearance(at) > 0.0
    }
}

impl SpatialBeam {
    /// How fast θ of an end that turns freely changes along a direction.
    fn rotation_rate(&self, at: &State, direction: &[f64]) -> f64 {
        let rest = matrix(self.chain.ends[1].rest);
        let r = matrix(quaternion_of(self.chain.end_node(self.configuration(at), 1)));
        let last = direction.len() - 3;
        // what lies along x at rest, in the axes of the directors
        let (along, turn) = (rest[0], [direction[last], direction[last + 1], direction[last + 2]]);
        let ([x, y, _], [dx, dy, _]) = (apply(&r, &along), apply(&r, &cross(turn, along)));
        (x * dy - y * dx) / (x * x + y * y).max(f64::MIN_POSITIVE)
    }
}
