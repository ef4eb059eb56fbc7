//! A planar beam as a [`System`]: a chain of elements on a substrate or on its own, with the mesh that follows its peeling front.

use super::{Chain, ChainFactors, Configuration, ElementEnergy, FrontPosition, MOST_FIELDS, PathRow};
use crate::adhesion::Substrate;
use crate::beam::{Focus, MeshKind, MeshPieces, Rest, graded_ends};
use crate::solve::{
    Coefficients, CondensedSystem, Evaluation, History, INTERFACE, MONITORS, Mesh, Rates, SolveError, State, System,
    Unknown, Workspace,
};
use std::sync::Arc;

/// The monitor that is the peeling front: adhesion energy over that of a unit length at rest at the left end, nm; zero where nothing
/// adheres.
pub const FRONT: usize = 0;
/// The monitor that is θ(0), the rotation of the left end, rad. The number for the record is θ(L), that of the grip.
pub const TIP_ROTATION: usize = 1;

/// How the elements of a beam are laid out.
#[derive(Clone, Debug)]
pub struct MeshPolicy {
    /// Whether the mesh follows the front.
    pub kind: MeshKind,
    /// Foci of the mesh besides the front.
    pub fixed_foci: Vec<Focus>,
    /// Between which places elements lie.
    pub pieces: MeshPieces,
}

/// A chain with its reference configuration and the scales of its adhesion.
///
/// Unknowns: the fields of the nodes from left to right, y and θ, or x, y and θ; behind them, where x is condensed and a horizontal force
/// acts, that force H and the place of the right end along x. The interface is the right end.
pub struct PlanarBeam {
    pub chain: Box<dyn Chain>,
    /// Reference length L, nm
    pub length: f64,
    /// x, height and rotation in the stress-free configuration; a chain of two fields a node leaves x out.
    pub rest: Rest,
    /// The height field at the left end at rest, nm.
    pub rest_gap: f64,
    /// The rotation, the last field of a node; the height stands before it.
    pub rotation: usize,
    /// Horizontal section force at rest, nN: of a straight beam that is stretched by `stretch` from end to end before it is pulled.
    pub pretension: f64,
    /// nm
    pub stretch: f64,
    /// Scale of an error of each field: nm near the substrate, rad.
    pub scale: [f64; MOST_FIELDS],
    /// The machine's epsilon times the ratio of the stiffest to the softest way to deform, or zero where that ratio is small.
    pub round_off: f64,
    /// Adhesion energy per length at rest at the left end, nN: negative, or zero where nothing adheres. Then there is no front.
    pub rest_adhesion: f64,
    /// Where the front is.
    pub fronts: FrontPosition,
    /// S of the front of the chain at rest, nm.
    pub rest_front: f64,
    pub mesh: MeshPolicy,
    /// Length ℓ of the process zone, nm; L where nothing adheres
    pub process_length: f64,
    /// Height of a beam that is as high everywhere and whose height field is the gap below it, nm; zero where that is the axis.
    pub height: f64,
    /// Whether the law looks at the edges of a tilted section, or only at the gap below the axis.
    pub sees_tilt: bool,
    /// What the chain is on; flat where nothing adheres.
    pub substrate: Substrate,
    /// What the material points remember at rest, where there is friction.
    pub history: Option<Arc<History>>,
    /// Whether the load has a potential.
    pub conservative: bool,
}

const HEIGHT: Unknown = Unknown { name: "height of the right end", unit: "nm" };
const ROTATION: Unknown = Unknown { name: "rotation of the right end", unit: "rad" };
const PLACE: Unknown = Unknown { name: "place of the right end along the substrate", unit: "nm" };
const AXIAL_FORCE: Unknown = Unknown { name: "horizontal section force", unit: "nN" };
const FREE: [Unknown; 2] = [HEIGHT, ROTATION];
const PULLED_ALONG: [Unknown; 4] = [HEIGHT, ROTATION, AXIAL_FORCE, PLACE];
const WITH_X: [Unknown; 3] = [PLACE, HEIGHT, ROTATION];
/// Unknowns behind the nodes: H and the place of the right end.
const BEHIND: usize = 2;

/// A beam of which less than this share of the process zone adheres is loose.
const LOOSE: f64 = 0.1;
/// One step takes a loose beam no nearer to the substrate than this share of its distance.
const NEARER: f64 = 0.6;
/// The mesh is renewed when the front has moved by this share of the process zone.
const MOVED: f64 = 0.3;

impl PlanarBeam {
    /// Fields a node.
    pub fn fields(&self) -> usize {
        self.chain.fields()
    }

    /// Slot of the interface for the place along the substrate, where the beam knows it.
    pub fn slot_of_x(&self) -> Option<usize> {
        if self.rotation > 1 { Some(0) } else { self.chain.has_border().then_some(self.fields() + 1) }
    }

    /// Slot of the interface for the height.
    pub fn slot_of_height(&self) -> usize {
        self.rotation - 1
    }

    /// Slot of the interface for the rotation.
    pub fn slot_of_rotation(&self) -> usize {
        self.rotation
    }

    /// The fields of the nodes, of values or of a direction.
    pub fn nodes<'a>(&self, values: &'a [f64]) -> &'a [f64] {
        &values[..values.len() - self.behind()]
    }

    fn behind(&self) -> usize {
        if self.chain.has_border() { BEHIND } else { 0 }
    }

    /// H and the place of the right end; zero where they are no unknowns.
    fn axial(&self, values: &[f64]) -> (f64, f64) {
        match self.nodes(values).len() {
            nodes if nodes < values.len() => (values[nodes], values[nodes + 1]),
            _ => (0.0, 0.0),
        }
    }

    /// A state as its chain sees it.
    pub fn configuration<'a>(&self, at: &'a State) -> Configuration<'a> {
        Configuration {
            ends: &at.mesh.boundaries,
            state: self.nodes(&at.values),
            border: self.axial(&at.values).0,
            history: at.history.as_deref(),
        }
    }

    /// Whether there is adhesion, and with it a front.
    pub fn adheres(&self) -> bool {
        self.rest_adhesion != 0.0
    }

    /// The front for an adhesion energy, or its change for a change of that, nm: how long the left end's adhesion would have to go
    /// on; zero where nothing adheres. [`FrontPosition`] knows where that is.
    pub fn front(&self, adhesion: f64) -> f64 {
        if self.adheres() { adhesion / self.rest_adhesion } else { 0.0 }
    }

    /// A front as the focus of a mesh: no farther than the ends of the chain.
    fn centered(&self, front: f64) -> f64 {
        front.clamp(0.0, self.fronts.near(self.length))
    }

    /// The fields of a node at rest.
    pub fn rest_at(&self, place: f64) -> [f64; MOST_FIELDS] {
        let all = self.rest.at(place);
        let left_out = MOST_FIELDS - self.fields();
        std::array::from_fn(|f| all.get(f + left_out).copied().unwrap_or(0.0))
    }

    /// Values of the interface in the stress-free configuration, or stretched by its pretension.
    pub fn interface_at_rest(&self) -> [f64; INTERFACE] {
        let rest = self.rest_at(self.length);
        let mut values = [0.0; INTERFACE];
        values[..self.fields()].copy_from_slice(&rest[..self.fields()]);
        match self.slot_of_x() {
            Some(0) => values[0] += self.stretch,
            Some(place) => (values[place - 1], values[place]) = (self.pretension, self.stretch),
            None => {}
        }
        values
    }

    /// Height of the section above the gap that the height field is, nm.
    pub fn height_at(&self, place: f64) -> f64 {
        match &self.rest {
            Rest::Curve(_) => self.height,
            Rest::Varying(rest) => rest.height(place),
        }
    }

    /// Distance of the two ends at rest along x, nm.
    fn span(&self) -> f64 {
        self.rest.at(self.length)[0] - self.rest.at(0.0)[0]
    }

    /// Π of a state whose chain has this energy: with H times the distance of its ends, where H is a multiplier, aJ.
    fn energy_of(&self, at: &State, chain: ElementEnergy) -> f64 {
        let (force, place) = self.axial(&at.values);
        chain.total + force * (self.span() + place)
    }

    fn evaluation(&self, at: &State, chain: ElementEnergy) -> Evaluation {
        let nodes = self.nodes(&at.values);
        Evaluation {
            energy: self.energy_of(at, chain),
            monitors: [self.front(chain.adhesion), nodes[self.rotation]],
            recorded: nodes[nodes.len() - self.fields() + self.rotation],
        }
    }

    /// The peeling front of a state, nm.
    pub fn front_of(&self, at: &State) -> f64 {
        self.front(self.chain.energy(self.configuration(at), self.nodes(&at.values)).0.adhesion)
    }

    /// Element ends for a front at `center`.
    pub fn ends(&self, center: f64, elements: usize) -> Vec<f64> {
        self.ends_near(center, elements, &[])
    }

    /// The same, found faster from the ends of a similar mesh.
    pub fn ends_near(&self, center: f64, elements: usize, near: &[f64]) -> Vec<f64> {
        let MeshPolicy { kind, fixed_foci, pieces } = &self.mesh;
        let mut foci = Vec::with_capacity(1 + fixed_foci.len());
        if self.adheres() && *kind != MeshKind::Uniform {
            let center = if *kind == MeshKind::Moving { self.fronts.place(center) } else { self.rest_front };
            foci.push(Focus { center, length: self.process_length, weight: 1.0 });
            foci.extend(fixed_foci);
        }
        graded_ends(pieces, &foci, elements, near)
    }

    /// A mesh of its own for a front.
    pub fn mesh_at(&self, front: f64, elements: usize) -> Mesh {
        let focus = self.centered(front);
        Mesh { boundaries: self.ends(focus, elements), focus }
    }

    /// The mesh for a front with as many elements as another one, found faster near to that.
    pub fn mesh_near(&self, front: f64, like: &Mesh) -> Mesh {
        let focus = self.centered(front);
        Mesh { boundaries: self.ends_near(focus, like.elements(), &like.boundaries), focus }
    }

    /// S of every node, nm.
    pub fn places(&self, ends: &[f64]) -> Vec<f64> {
        let (elements, order) = (ends.len() - 1, self.chain.order());
        let place = |node: usize| {
            let e = (node / order).min(elements - 1);
            ends[e] + (ends[e + 1] - ends[e]) * self.chain.node_fraction(node - e * order)
        };
        (0..=elements * order).map(place).collect()
    }

    /// A state read off on another mesh.
    pub fn resampled(&self, at: &State, mesh: Mesh) -> State {
        let mut values = self.chain.resampled(self.configuration(at), &mesh.boundaries);
        values.extend_from_slice(&at.values[self.nodes(&at.values).len()..]);
        State { mesh, values, ..at.clone() }
    }

    /// What the height of a node is measured by: its scale plus its lift, nm.
    fn height_unit(&self, node: &[f64]) -> f64 {
        let up = self.rotation - 1;
        let lift = match &self.substrate {
            Substrate::Flat => node[up] - self.rest_gap,
            substrate => substrate.clearance(node[0], node[up] + 0.5 * self.height) - 0.5 * self.height - self.rest_gap,
        };
        self.scale[up] + lift.abs()
    }

    /// Distance of the beam from the substrate, nm: of the lowest edge of its nodes, or the least gap below its axis where
    /// the law does not depend on the section's rotation.
    pub fn nearest(&self, at: &State) -> f64 {
        self.distances(at).fold(f64::INFINITY, f64::min)
    }

    /// Whether no part of the beam is nearer to the substrate than `far`, nm.
    pub fn is_clear(&self, at: &State, far: f64) -> bool {
        self.distances(at).all(|distance| distance > far)
    }

    /// Distance of each node from the substrate, nm.
    fn distances<'a>(&'a self, at: &'a State) -> impl Iterator<Item = f64> + 'a {
        let (order, ends) = (self.chain.order(), &at.mesh.boundaries);
        self.nodes(&at.values).chunks_exact(self.fields()).enumerate().map(move |(k, node)| {
            let half = if self.sees_tilt {
                // a node inside of an element is taken to be as high as the left end of that
                0.5 * self.height_at(ends[k / order])
            } else {
                0.0
            };
            if self.substrate.is_flat() {
                return node[self.rotation - 1] + half * (1.0 - node[self.rotation].cos().abs());
            }
            let full = self.height_at(ends[k / order]);
            let foot = self.substrate.foot(node[0], node[self.rotation - 1] + 0.5 * full);
            let tilt = (node[self.rotation] - foot.sin.atan2(foot.cos)).cos().abs();
            foot.distance - 0.5 * full + half * (1.0 - tilt)
        })
    }

    /// The diagonal that coefficients add to the tangent of the chain, a number an unknown of a node; empty where they are zero.
    ///
    /// C: the length that belongs to a node times the adhesion's own stiffness, w/scale². The beam has no mass yet: M is zero.
    fn diagonal(&self, at: &State, coefficients: Coefficients) -> Vec<f64> {
        let Coefficients { per_damping: time, per_mass: _ } = coefficients;
        if time.is_infinite() {
            return Vec::new();
        }
        let (fields, order) = (self.fields(), self.chain.order());
        let mut lengths = vec![0.0; self.nodes(&at.values).len() / fields];
        for (e, pair) in at.mesh.boundaries.windows(2).enumerate() {
            let share = (pair[1] - pair[0]) / order as f64;
            for rank in 0..=order {
                let inside = rank > 0 && rank < order;
                lengths[e * order + rank] += if inside { share } else { 0.5 * share };
            }
        }
        let energy = self.rest_adhesion.abs();
        let damping = |length: f64, f: usize| energy * length / self.scale[f].powi(2) / time;
        lengths.iter().flat_map(|&length| (0..fields).map(move |f| damping(length, f))).collect()
    }
}

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

    fn has_history(&self) -> bool {
        self.history.is_some()
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
        let mut row = PathRow { adhesion: self.front(weights[FRONT]), ..PathRow::default() };
        row.left[self.rotation] = weights[TIP_ROTATION];
        let diagonal = self.diagonal(at, coefficients);
        let factors = ws.factors::<ChainFactors>();
        let root = self.chain.eliminate_damped(self.configuration(at), &row, &diagonal, factors)?;
        let known = self.fields() + usize::from(self.chain.has_border());
        let mut condensed = CondensedSystem {
            matrix: [[0.0; INTERFACE]; INTERFACE],
            residual: [0.0; INTERFACE],
            gradient: [0.0; INTERFACE],
            gradient_residual: root.matrix[known][known],
            negative: root.negative,
            least_pivot: f64::INFINITY,
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

    fn recover(&self, ws: &Workspace, interface: &[f64; INTERFACE], scale: f64, direction: &mut [f64]) {
        let nodes = self.nodes(direction).len();
        let fields = self.fields();
        self.chain.recover(ws.factored::<ChainFactors>(), interface, scale, &mut direction[..nodes]);
        direction[nodes..].copy_from_slice(&interface[fields..fields + self.behind()]);
    }

    fn reduce(&self, _ws: &Workspace, _right: &mut [f64], _transposed: bool) -> [f64; INTERFACE] {
        [0.0; INTERFACE]
    }

    fn substitute(&self, _ws: &Workspace, _interface: &[f64; INTERFACE], _right: &mut [f64], _transposed: bool) {}

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
            self.chain.adhesion_gradient(self.configuration(at))
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

    fn size(&self, direction: &[f64], values: &[f64]) -> f64 {
        let (fields, rotation, up) = (self.fields(), self.rotation, self.rotation - 1);
        let per_rotation = 1.0 / self.scale[rotation];
        let (mut largest, mut sum) = (0.0f64, 0.0);
        for (u, s) in self.nodes(direction).chunks_exact(fields).zip(self.nodes(values).chunks_exact(fields)) {
            // x, where it is an unknown, is measured like the height
            let height = if up > 0 { u[0].abs().max(u[up].abs()) } else { u[up].abs() };
            let size = height / self.height_unit(s);
            let turn = u[rotation].abs() * per_rotation;
            largest = if size > largest { size } else { largest };
            largest = if turn > largest { turn } else { largest };
            sum += height + turn;
        }
        // a comparison passes over a NaN, a sum does not
        if sum.is_finite() { largest } else { f64::NAN }
    }

    fn per_unit(&self, values: &[f64]) -> Vec<f64> {
        let (rotation, nodes) = (self.rotation, self.nodes(values));
        let mut units = vec![1.0 / self.scale[rotation]; values.len()];
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
            if let Rest::Varying(rest) = &self.rest {
                let up = self.rotation - 1;
                let tilted = 0.5 * rest.height(s) * (1.0 - node[self.rotation].cos().abs());
                node[up] = node[up].max(self.rest_gap - tilted);
            }
            values.extend_from_slice(&node[..self.fields()]);
        }
        if self.chain.has_border() {
            values.extend([self.pretension, self.stretch]);
        }
        State { mesh: Mesh { boundaries, focus }, values, force: 0.0, history: self.history.clone() }
    }

    fn on_elements(&self, at: &State, elements: usize) -> State {
        let focus = at.mesh.focus;
        self.resampled(at, Mesh { boundaries: self.ends(focus, elements), focus })
    }

    fn refocused(&self, at: &State, monitors: [f64; MONITORS]) -> State {
        self.resampled(at, self.mesh_at(monitors[FRONT], at.mesh.elements()))
    }

    fn mesh_for(&self, monitors: [f64; MONITORS], like: &Mesh) -> Mesh {
        self.mesh_near(monitors[FRONT], like)
    }

    fn aligned(&self, at: &State, monitors: [f64; MONITORS]) -> Vec<f64> {
        let mesh = self.mesh_for(monitors, &at.mesh);
        let mut values = self.chain.shifted(self.configuration(at), &mesh.boundaries);
        values.extend_from_slice(&at.values[values.len()..]);
        values
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

    fn commit(&self, at: &State) -> Option<Arc<History>> {
        self.chain.slid(self.configuration(at)).map(Arc::new)
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
        !(loose && self.nearest(prediction) < NEARER * self.nearest(from))
    }

    fn is_admissible(&self, at: &State) -> bool {
        self.nearest(at) > 0.0
    }
}
