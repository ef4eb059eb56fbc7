//! The planar beam as a [`System`]: what a solver asks of it. Its interface is the right end.

use super::chain::{ChainFactors, Configuration, ConstraintGradient};
use super::planar_beam::{BeamMemory, FRONT, PlanarBeam, TIP_ROTATION};
use crate::adhesion::substrate::Substrate;
use crate::beam::mesh::MeshKind;
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::solve::error::SolveError;
use crate::solve::state::{History, MONITORS, Mesh, State};
use crate::solve::system::{
    Coefficients, CondensedSystem, Evaluation, INTERFACE, NodalTerms, Rates, StepDependence, System, Unknown,
};
use crate::solve::workspace::Workspace;
use std::sync::Arc;

const HEIGHT: Unknown = Unknown { name: "height of the right end", unit: "nm" };
const ROTATION: Unknown = Unknown { name: "rotation of the right end", unit: "rad" };
const PLACE: Unknown = Unknown { name: "place of the right end along the substrate", unit: "nm" };
const AXIAL_FORCE: Unknown = Unknown { name: "horizontal section force", unit: "nN" };
const FREE: [Unknown; 2] = [HEIGHT, ROTATION];
const PULLED_ALONG: [Unknown; 4] = [HEIGHT, ROTATION, AXIAL_FORCE, PLACE];
const WITH_X: [Unknown; 3] = [PLACE, HEIGHT, ROTATION];

/// A beam of which less than this share of the process zone adheres is loose.
const LOOSE: f64 = 0.1;
/// One step takes a loose beam no nearer to the substrate than this share of its distance.
const NEARER: f64 = 0.6;
/// An update that turns no section by more, rad, is linear to round-off.
const TURNED: f64 = 1e-7;
/// The mesh is renewed when the front has moved by this share of the process zone.
const MOVED: f64 = 0.3;

impl System for PlanarBeam {
    fn interface(&self) -> &[Unknown] {
        match (self.rotation, self.chain.has_border()) {
            (1, false) => &FREE,
            (1, true) => &PULLED_ALONG,
            _ => &WITH_X,
        }
    }

    fn unknowns(&self, at: &State) -> usize {
        at.values.len()
    }

    fn interface_values(&self, at: &State) -> [f64; INTERFACE] {
        let from = self.nodes(&at.values).len() - self.fields();
        let end = &at.values[from..];
        let mut values = [0.0; INTERFACE];
        values[..end.len()].copy_from_slice(end);
        values
    }

    fn place_of(&self, slot: usize, at: &State) -> usize {
        self.nodes(&at.values).len() - self.fields() + slot
    }

    fn multipliers(&self) -> usize {
        usize::from(self.chain.has_border())
    }

    fn is_conservative(&self) -> bool {
        self.conservative
    }

    fn step_dependence(&self) -> StepDependence {
        match self.memory {
            BeamMemory::Nothing | BeamMemory::Opening(_) => StepDependence::None,
            BeamMemory::Slip(_) => StepDependence::Friction,
            BeamMemory::Film { .. } => StepDependence::Yielding,
        }
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
        let added = NodalTerms { stiffness: &diagonal, force: &[] };
        self.condensed(at, self.configuration(at), added, weights, ws)
    }

    fn step(&self, at: &mut State, update: &[f64]) {
        let nodes = self.nodes(update).len();
        let turns = update[..nodes].iter().skip(self.rotation).step_by(self.fields());
        if turns.fold(0.0, |largest: f64, turn| largest.max(turn.abs())) > TURNED {
            let axial = [self.axial(&at.values).0, self.axial(update).0];
            self.chain.follow_force(&at.mesh.boundaries, &mut at.values[..nodes], &update[..nodes], axial);
        }
        self.retract(at, update, 1.0);
    }

    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]) {
        let nodes = self.nodes(direction).len();
        let fields = self.fields();
        self.chain.recover(ws.factored::<ChainFactors>(), interface, scale, &mut direction[..nodes]);
        direction[nodes..].copy_from_slice(&interface[fields..fields + self.behind()]);
    }

    /// The chain ends with H; where the right end is along the substrate stands behind it, beyond what is eliminated.
    fn reduce(&self, ws: &Workspace, right: &mut [f64], transposed: bool) -> [f64; INTERFACE] {
        let (chain, known) = (self.chained(right), self.fields() + self.multipliers());
        let left = self.chain.reduce(ws.factored::<ChainFactors>(), &mut right[..chain], transposed);
        let mut interface = [0.0; INTERFACE];
        interface[..known].copy_from_slice(&left[..known]);
        if let Some(place) = right.get(chain) {
            interface[known] = *place;
        }
        interface
    }

    fn substitute(&self, ws: &Workspace, interface: &[f64; INTERFACE], right: &mut [f64], transposed: bool) {
        let chain = self.chained(right);
        self.chain.substitute(ws.factored::<ChainFactors>(), interface, &mut right[..chain], transposed);
        if let Some(place) = right.get_mut(chain) {
            *place = interface[self.fields() + 1];
        }
    }

    fn evaluate(&self, at: &State, direction: &[f64]) -> (Evaluation, Rates) {
        let nodes = self.nodes(direction);
        let (energy, adhesion) = self.chain.energy(self.configuration(at), nodes);
        let rates = Rates {
            monitors: [self.front(adhesion), nodes[self.rotation]],
            recorded: nodes[nodes.len() - self.fields() + self.rotation],
        };
        (self.evaluation(at, energy), rates)
    }

    fn gradient(&self, at: &State, weights: [f64; MONITORS]) -> Vec<f64> {
        let mut gradient = if weights[FRONT] == 0.0 {
            vec![0.0; self.nodes(&at.values).len()]
        } else {
            self.chain.coverage_gradient(self.configuration(at))
        };
        gradient.iter_mut().for_each(|entry| *entry = weights[FRONT] * self.front(*entry));
        gradient[self.rotation] += weights[TIP_ROTATION];
        gradient.resize(at.values.len(), 0.0);
        gradient
    }

    fn residual(&self, at: &State) -> Vec<f64> {
        let (mut residual, by_force) = self.chain.residual(self.configuration(at));
        if self.chain.has_border() {
            let (force, end) = self.axial(&at.values);
            residual.extend([by_force + self.span() + end, force]);
        }
        residual
    }

    fn size(&self, direction: &[f64], at: &State) -> f64 {
        let (direction, values) = (self.nodes(direction), &*self.above_ground(at));
        if self.fields() == 2 { self.largest::<2>(direction, values) } else { self.largest::<3>(direction, values) }
    }

    fn per_unit(&self, at: &State) -> Vec<f64> {
        let (rotation, nodes) = (self.rotation, self.above_ground(at));
        let mut units = vec![1.0 / self.scale[rotation]; at.values.len()];
        units[nodes.len()..].fill(0.0);
        for (units, s) in units.chunks_exact_mut(self.fields()).zip(nodes.chunks_exact(self.fields())) {
            units[..rotation].fill(1.0 / self.height_unit(s));
        }
        units
    }

    /// Where a beam of varying outline would lie within the substrate it is lifted onto that.
    fn stress_free(&self, elements: usize) -> State {
        let focus = self.fronts.near(self.rest_front);
        let boundaries = self.ends(focus, elements);
        let mut values = Vec::new();
        for s in self.places(&boundaries) {
            let mut node = self.rest_at(s);
            if self.rotation > 1 {
                node[0] += self.stretch * s / self.length;
            }
            if let ReferenceConfiguration::Varying(rest) = &self.rest {
                let up = self.rotation - 1;
                let tilted = 0.5 * rest.height(s) * (1.0 - node[self.rotation].cos().abs());
                node[up] = node[up].max(self.rest_gap - tilted);
            }
            values.extend_from_slice(&node[..self.fields()]);
        }
        if self.chain.has_border() {
            values.extend([self.pretension, self.stretch]);
        }
        let history = self.memory_at_rest(&boundaries);
        State { mesh: Mesh { boundaries, focus, ..Mesh::default() }, values, force: 0.0, history }
    }

    fn on_elements(&self, at: &State, elements: usize) -> State {
        let focus = at.mesh.focus;
        self.resampled(at, Mesh { boundaries: self.ends(focus, elements), ..at.mesh.clone() })
    }

    fn refined(&self, at: &State) -> State {
        let finer = self.mesh_of(at.mesh.focus, &self.mesh.pieces.refined(&at.mesh.boundaries), &[]);
        self.resampled(at, Mesh { boundaries: finer.boundaries, ..at.mesh.clone() })
    }

    fn refocused(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        self.resampled(at, self.mesh_of(monitors[FRONT], &self.mesh.pieces.counted(&at.mesh.boundaries), &[]))
    }

    fn mesh_for(&self, monitors: [f64; MONITORS], _: &[f64], like: &Mesh) -> Mesh {
        self.mesh_near(monitors[FRONT], like)
    }

    fn aligned(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        let mesh = self.mesh_near(monitors[FRONT], &at.mesh);
        let mut values = self.chain.shifted(self.configuration(at), &mesh.boundaries);
        values.extend_from_slice(&at.values[values.len()..]);
        State { mesh, values, force: at.force, history: at.history.clone() }
    }

    fn remeshed(&self, at: &State) -> Option<State> {
        if self.mesh.kind != MeshKind::Moving {
            return None;
        }
        let front = self.front_of(at);
        if (self.centered(front) - at.mesh.focus).abs() < MOVED * self.process_length {
            return None;
        }
        Some(self.resampled(at, self.mesh_near(front, &at.mesh)))
    }

    fn corner_before(&self, at: &State) -> Option<Arc<History>> {
        self.remembered_before_closing(at).map(Arc::new)
    }

    fn commit(&self, at: &State) -> Option<Arc<History>> {
        self.remembered(at).map(Arc::new)
    }

    /// Turned, the more the farther from the grip.
    fn disturbance(&self, at: &State, size: f64) -> Vec<f64> {
        let mut direction = vec![0.0; at.values.len()];
        let (fields, nodes) = (self.fields(), self.nodes(&at.values).len() / self.fields());
        for node in 0..nodes {
            let away = 1.0 - node as f64 / (nodes - 1) as f64;
            direction[node * fields + self.rotation] = size * self.scale[self.rotation] * away;
        }
        direction
    }

    fn admits(&self, from: &State, monitors: [f64; MONITORS], prediction: &State) -> bool {
        let loose = self.adheres() && monitors[FRONT] < LOOSE * self.process_length;
        !(loose && self.clearance(prediction) < NEARER * self.clearance(from))
    }

    fn is_admissible(&self, at: &State) -> bool {
        !self.adheres() || self.is_above(at)
    }
}

impl PlanarBeam {
    /// The chain eliminated down to its right end, with terms of the nodes added and Σ weights·monitors carried along.
    pub(super) fn condensed(
        &self,
        at: &State,
        configuration: Configuration,
        added: NodalTerms,
        weights: [f64; MONITORS],
        ws: &mut Workspace,
    ) -> Result<CondensedSystem, SolveError> {
        let mut row = ConstraintGradient { coverage: self.front(weights[FRONT]), ..ConstraintGradient::default() };
        row.left[self.rotation] = weights[TIP_ROTATION];
        let root = self.chain.eliminate_with(configuration, &row, added, ws.factors::<ChainFactors>())?;
        let known = self.fields() + self.multipliers();
        let mut condensed = CondensedSystem {
            matrix: [[0.0; INTERFACE]; INTERFACE],
            residual: [0.0; INTERFACE],
            gradient: [0.0; INTERFACE],
            gradient_residual: root.matrix[known][known],
            negative: root.negative,
            least_pivot: root.least_pivot.size,
            evaluation: self.evaluation(at, root.energy),
        };
        for i in 0..known {
            condensed.matrix[i][..known].copy_from_slice(&root.matrix[i][..known]);
            condensed.residual[i] = root.matrix[i][known];
            condensed.gradient[i] = root.matrix[known][i];
        }
        if self.chain.has_border() {
            // ∂Π/∂H is the distance of the ends less what the chain spans, ∂Π/∂x(L) is H
            let (multiplier, place) = (known - 1, known);
            let (force, end) = self.axial(&at.values);
            condensed.matrix[place][multiplier] = 1.0;
            condensed.matrix[multiplier][place] = 1.0;
            condensed.residual[place] = force;
            condensed.residual[multiplier] += self.span() + end;
        }
        Ok(condensed)
    }
}

/// Nodes that are measured side by side.
const LANES: usize = 4;

impl PlanarBeam {
    /// The largest size of a change of the F fields of these nodes; NaN where a number is none.
    fn largest<const F: usize>(&self, direction: &[f64], values: &[f64]) -> f64 {
        let (direction, values) = (direction.as_chunks::<F>().0, values.as_chunks::<F>().0);
        match &self.substrate {
            Substrate::Flat => {
                let (scale, rest) = (self.scale[F - 2], self.rest_gap);
                largest(direction, values, self.scale[F - 1], |node| scale + (node[F - 2] - rest).abs())
            }
            _ => largest(direction, values, self.scale[F - 1], |node| self.height_unit(node)),
        }
    }
}

/// The same, with what rotations and, node by node, heights are measured by.
fn largest<const F: usize>(
    direction: &[[f64; F]],
    values: &[[f64; F]],
    rotation_unit: f64,
    height_unit: impl Fn(&[f64; F]) -> f64,
) -> f64 {
    let (rotation, up) = (F - 1, F - 2);
    let per_rotation = 1.0 / rotation_unit;
    let (mut heights, mut turns, mut sums) = ([0.0f64; LANES], [0.0f64; LANES], [0.0; LANES]);
    let mut take = |l: usize, u: &[f64; F], s: &[f64; F]| {
        // ξ, where it is an unknown, is measured like the height
        let height = if up > 0 { u[0].abs().max(u[up].abs()) } else { u[up].abs() };
        let (size, turn) = (height / height_unit(s), u[rotation].abs() * per_rotation);
        heights[l] = if size > heights[l] { size } else { heights[l] };
        turns[l] = if turn > turns[l] { turn } else { turns[l] };
        sums[l] += height + turn;
    };
    let ((directions, rest), (values, values_rest)) = (direction.as_chunks::<LANES>(), values.as_chunks::<LANES>());
    for (u, s) in directions.iter().zip(values) {
        for l in 0..LANES {
            take(l, &u[l], &s[l]);
        }
    }
    for (u, s) in rest.iter().zip(values_rest) {
        take(0, u, s);
    }
    // a comparison passes over a NaN, a sum does not
    if sums.iter().sum::<f64>().is_finite() { heights.into_iter().chain(turns).fold(0.0, f64::max) } else { f64::NAN }
}
