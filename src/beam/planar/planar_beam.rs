//! A planar beam: a chain of elements on a substrate or on its own, in its reference configuration, with where its front is, its mesh and its grip.

use super::chain::{Chain, Configuration, MOST_FIELDS};
use super::model_limits::ModelLimits;
use crate::adhesion::friction::dahl::FrictionState;
use crate::adhesion::section::barrier::Barrier;
use crate::adhesion::substrate::Substrate;
use crate::beam::element::energy_density::{FACE, SectionState};
use crate::beam::element::integration::ElementEnergy;
use crate::beam::element::integration::mend;
use crate::beam::grip_state::{GripForces, GripState};
use crate::beam::material::yielding::FILM;
use crate::beam::mesh::{MeshKind, MeshPolicy, nodal_lengths};
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::beam::viscosity::Viscosity;
use crate::solve::path::hermite::Hermite;
use crate::solve::state::{History, Mesh, Places, State};
use crate::solve::system::{Coefficients, Evaluation, INTERFACE, System};
use std::borrow::Cow;
use std::sync::Arc;

/// The monitor that is the peeling front: adhesion energy over that of a unit length at rest at the left end, nm; zero where nothing
/// adheres.
pub const FRONT: usize = 0;
/// The monitor that is θ(0), the rotation of the left end, rad. The number for the record is θ(L), that of the grip.
pub const TIP_ROTATION: usize = 1;

/// A chain with its reference configuration and the scales of its adhesion.
///
/// Unknowns: the fields of the nodes from left to right, y and θ, or ξ = x - S, y and θ; behind them, where x is condensed and a horizontal force
/// acts, that force H and the place of the right end along x. The interface is the right end.
pub struct PlanarBeam {
    /// Its elements
    pub chain: Box<dyn Chain>,
    /// Reference length L, nm
    pub length: f64,
    /// x, height and rotation in the stress-free configuration; a chain of two fields a node leaves ξ out.
    pub rest: ReferenceConfiguration,
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
    /// Where its elements end
    pub mesh: MeshPolicy,
    /// Length ℓ of the process zone, nm; L where nothing adheres
    pub process_length: f64,
    /// Height of a beam that is as high everywhere and whose height field is the gap below it, nm; zero where that is the axis.
    pub height: f64,
    /// Whether the law looks at the edges of a tilted section, or only at the gap below the axis.
    pub sees_tilt: bool,
    /// What keeps it out of the substrate
    pub barrier: Barrier,
    /// What the chain is on; flat where nothing adheres.
    pub substrate: Substrate,
    /// What its material points remember
    pub memory: BeamMemory,
    /// Whether the load has a potential.
    pub conservative: bool,
    /// How far a face slips until nothing attracts it, nm, where the adhesion holds it along the ground. The load then depends on x - S, and the first
    /// integral is that of this displacement.
    pub slip_reach: Option<f64>,
    /// Where its model ends.
    pub limits: ModelLimits,
    /// Its mass and how its material flows, where it moves in time.
    pub inertia: Option<Arc<BeamInertia>>,
}

/// Unknowns behind the nodes: H and the place of the right end.
const BEHIND: usize = 2;

impl PlanarBeam {
    /// Fields a node.
    pub fn fields(&self) -> usize {
        self.chain.fields()
    }

    /// Slot of the interface for the place along the substrate, where the beam knows it.
    pub(crate) fn slot_of_x(&self) -> Option<usize> {
        if self.rotation > 1 { Some(0) } else { self.chain.has_border().then_some(self.fields() + 1) }
    }

    /// Slot of the interface for the height.
    pub(crate) fn slot_of_height(&self) -> usize {
        self.rotation - 1
    }

    /// Slot of the interface for the rotation.
    pub(crate) fn slot_of_rotation(&self) -> usize {
        self.rotation
    }

    /// The fields of the nodes, of values or of a direction.
    pub fn nodes<'a>(&self, values: &'a [f64]) -> &'a [f64] {
        &values[..values.len() - self.behind()]
    }

    /// The numbers of a state of this beam, or of one that is pulled in another direction: H and the place of the right end stay, go,
    /// or come as zero.
    pub(crate) fn adopted<'a>(&self, at: &'a State) -> Cow<'a, [f64]> {
        let nodes = (at.mesh.elements() * self.chain.order() + 1) * self.fields();
        let unknowns = nodes + self.behind();
        if at.values.len() == unknowns {
            return Cow::Borrowed(&at.values);
        }
        let mut values = at.values[..nodes].to_vec();
        values.resize(unknowns, 0.0);
        Cow::Owned(values)
    }

    /// How many of the numbers belong to the chain: those of the nodes, and H.
    pub(super) fn chained(&self, values: &[f64]) -> usize {
        self.nodes(values).len() + usize::from(self.chain.has_border())
    }

    pub(super) fn behind(&self) -> usize {
        if self.chain.has_border() { BEHIND } else { 0 }
    }

    /// H and the place of the right end; zero where they are no unknowns.
    pub(super) fn axial(&self, values: &[f64]) -> (f64, f64) {
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
            axial_multiplier: self.axial(&at.values).0,
            history: at.history.as_deref(),
            strains: None,
        }
    }

    /// Whether there is adhesion, and with it a front.
    pub(crate) fn adheres(&self) -> bool {
        self.rest_adhesion != 0.0
    }

    /// The front for a coverage, or its change for a change of that, nm: how long the left end's adhesion would have to go
    /// on; zero where nothing adheres. [`FrontPosition`] knows where that is.
    pub(crate) fn front(&self, coverage: f64) -> f64 {
        if self.adheres() { coverage / self.rest_adhesion } else { 0.0 }
    }

    /// The fields of a node at rest.
    pub(crate) fn rest_at(&self, place: f64) -> [f64; MOST_FIELDS] {
        let [x, height, rotation] = self.rest.at(place);
        let all = [x - place, height, rotation];
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
            ReferenceConfiguration::Curve(_) => self.height,
            ReferenceConfiguration::Varying(rest) => rest.height(place),
        }
    }

    /// Distance of the two ends at rest along x, nm.
    pub(super) fn span(&self) -> f64 {
        self.rest.at(self.length)[0] - self.rest.at(0.0)[0]
    }

    /// Π of a state whose chain has this energy: with H times the distance of its ends, where H is a multiplier, aJ.
    fn energy_of(&self, at: &State, chain: ElementEnergy) -> f64 {
        let (force, place) = self.axial(&at.values);
        chain.total + force * (self.span() + place)
    }

    pub(super) fn evaluation(&self, at: &State, chain: ElementEnergy) -> Evaluation {
        let nodes = self.nodes(&at.values);
        Evaluation {
            energy: self.energy_of(at, chain),
            monitors: [self.front(chain.coverage), nodes[self.rotation]],
            recorded: nodes[nodes.len() - self.fields() + self.rotation],
        }
    }

    /// The peeling front of a state, nm.
    pub(crate) fn front_of(&self, at: &State) -> f64 {
        self.front(self.chain.energy(self.configuration(at), self.nodes(&at.values)).0.coverage)
    }

    /// The fields of the nodes, x in place of ξ where the ground is not the same everywhere.
    pub(super) fn above_ground<'a>(&self, at: &'a State) -> Cow<'a, [f64]> {
        let nodes = self.nodes(&at.values);
        if self.substrate.is_flat() {
            return Cow::Borrowed(nodes);
        }
        let mut nodes = nodes.to_vec();
        for (node, place) in nodes.chunks_exact_mut(self.fields()).zip(self.places(&at.mesh.boundaries)) {
            node[0] += place;
        }
        Cow::Owned(nodes)
    }

    /// What the height of a node [above the ground](Self::above_ground) is measured by: its scale plus its lift, nm.
    #[inline(always)]
    pub(super) fn height_unit(&self, node: &[f64]) -> f64 {
        let up = self.rotation - 1;
        let lift = match &self.substrate {
            Substrate::Flat => node[up] - self.rest_gap,
            substrate => substrate.clearance(node[0], node[up] + 0.5 * self.height) - 0.5 * self.height - self.rest_gap,
        };
        self.scale[up] + lift.abs()
    }

    /// Distance of the beam from the substrate, nm: of the lowest edge of its nodes, or the least gap below its axis where
    /// the law does not depend on the section's rotation.
    pub(crate) fn nearest(&self, at: &State) -> f64 {
        self.distances(at).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Distance of the beam from what it cannot pass, nm.
    pub(crate) fn clearance(&self, at: &State) -> f64 {
        self.barrier.clearance(self.nearest(at))
    }

    /// Whether all of the beam is farther from the substrate than `far`, nm, or has slipped so far that nothing attracts it.
    pub(crate) fn is_clear(&self, at: &State, far: f64) -> bool {
        self.beyond(at, far) > 0.0
    }

    /// How much farther than `far` the beam is from the substrate where it is nearest, nm. A face that its adhesive holds along the ground and that
    /// has slipped beyond its reach, by a share of that, is by the same share of `far` beyond it.
    pub(crate) fn beyond(&self, at: &State, far: f64) -> f64 {
        let Some(reach) = self.slip_reach else { return self.nearest(at) - far };
        let places = self.places(&at.mesh.boundaries);
        let nodes = self.nodes(&at.values).chunks_exact(self.fields()).zip(places);
        let slips = nodes.map(|(node, place)| node[0] + 0.5 * self.height_at(place) * node[self.rotation].sin());
        let each = self.distances(at).into_iter().zip(slips);
        each.map(|(distance, slip)| (distance - far).max(far * (slip.abs() / reach - 1.0)))
            .fold(f64::INFINITY, f64::min)
    }

    /// Distance of each node from the substrate, nm.
    fn distances(&self, at: &State) -> Vec<f64> {
        let (order, ends) = (self.chain.order(), &at.mesh.boundaries);
        let nodes = self.above_ground(at);
        // a node inside of an element is taken to be as high as the left end of that
        let distance = |(k, node): (usize, &[f64])| self.distance(ends[k / order], node);
        nodes.chunks_exact(self.fields()).enumerate().map(distance).collect()
    }

    /// Whether all of the beam is above what it cannot pass, between its nodes as well.
    pub(crate) fn is_above(&self, at: &State) -> bool {
        let (configuration, ends) = (self.configuration(at), &at.mesh.boundaries);
        let order = self.chain.order();
        let between = |k: usize| (2 * k + 1) as f64 / order as f64 - 1.0;
        self.clearance(at) > 0.0
            && (0..at.mesh.elements()).all(|element| {
                (0..order).all(|k| {
                    let (fields, _) = self.chain.sample(configuration, element, between(k));
                    self.barrier.clearance(self.distance(ends[element], &fields)) > 0.0
                })
            })
    }

    /// Distance of a section with these fields, x in place of ξ, from the substrate, nm, of the height that sections have at `place`.
    fn distance(&self, place: f64, fields: &[f64]) -> f64 {
        let full = self.height_at(place);
        let half = if self.sees_tilt { 0.5 * full } else { 0.0 };
        let (height, rotation) = (fields[self.rotation - 1], fields[self.rotation]);
        if self.substrate.is_flat() {
            return height + half * (1.0 - rotation.cos().abs());
        }
        let closest = self.substrate.project(fields[0], height + 0.5 * full);
        let tilt = (rotation - closest.sin.atan2(closest.cos)).cos().abs();
        closest.distance - 0.5 * full + half * (1.0 - tilt)
    }

    /// The diagonal that coefficients add to the tangent of the chain, a number an unknown of a node; empty where they are zero.
    ///
    /// C: the length that belongs to a node times the adhesion's own stiffness, w/scale². Masses count in steps in time alone.
    pub(super) fn diagonal(&self, at: &State, coefficients: Coefficients) -> Vec<f64> {
        let Coefficients { per_damping: time, per_mass: _ } = coefficients;
        if time.is_infinite() {
            return Vec::new();
        }
        let (fields, lengths) = (self.fields(), nodal_lengths(&at.mesh.boundaries, self.chain.order()));
        let energy = self.rest_adhesion.abs();
        let damping = |length: f64, f: usize| energy * length / self.scale[f].powi(2) / time;
        lengths.iter().flat_map(|&length| (0..fields).map(move |f| damping(length, f))).collect()
    }
}

/// What a beam in motion has besides its stiffness.
pub struct BeamInertia {
    /// ρA and ρI at S: mass per length and rotary inertia per length
    pub section: Box<dyn Fn(f64) -> [f64; 2] + Send + Sync>,
    /// How its material flows; a chain of a viscous one has a density that is `Viscous`
    pub viscosity: Viscosity,
    /// Of an adhesive that resists its opening, the distance (nm) of the bonded face at S, gap and rotation; such a chain has that density too
    pub distance: Option<FaceDistance>,
}

/// Distance of a face from the substrate (nm) at S, the gap (nm) and the rotation.
pub(crate) type FaceDistance = Box<dyn Fn(f64, [f64; 2]) -> f64 + Send + Sync>;

impl BeamInertia {
    /// The same everywhere.
    pub fn uniform(per_length: f64, rotary: f64, viscosity: Viscosity) -> Self {
        Self { section: Box::new(move |_| [per_length, rotary]), viscosity, distance: None }
    }
}

impl PlanarBeam {
    /// A front as the focus of a mesh: no farther than the ends of the chain.
    pub(super) fn centered(&self, front: f64) -> f64 {
        front.clamp(0.0, self.fronts.near(self.length))
    }

    /// Element ends for a front at `center`.
    pub fn ends(&self, center: f64, elements: usize) -> Vec<f64> {
        self.mesh_at(center, elements).boundaries
    }

    /// The mesh for a front with so many elements on each piece, which may be found faster from the `near` ends of a similar one.
    pub(super) fn mesh_of(&self, front: f64, counts: &[usize], near: &[f64]) -> Mesh {
        let focus = self.centered(front);
        let moves = self.mesh.kind == MeshKind::Moving;
        let front = self.adheres().then(|| if moves { self.fronts.place(focus) } else { self.rest_front });
        Mesh { boundaries: self.mesh.ends(front, &[0.0; 2], counts, near), focus, ..Mesh::default() }
    }

    /// A mesh of its own for a front.
    pub(crate) fn mesh_at(&self, front: f64, elements: usize) -> Mesh {
        self.mesh_of(front, &self.mesh.pieces.shared_out(elements), &[])
    }

    /// The mesh for a front with as many elements as another one, found faster near to that.
    pub(crate) fn mesh_near(&self, front: f64, like: &Mesh) -> Mesh {
        self.mesh_of(front, &self.mesh.pieces.counted(&like.boundaries), &like.boundaries)
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
    pub(crate) fn resampled(&self, at: &State, mesh: Mesh) -> State {
        let mut values = self.chain.resampled(self.configuration(at), &mesh.boundaries);
        values.extend_from_slice(&at.values[self.nodes(&at.values).len()..]);
        let history = at.history.clone().map(|known| match known.places {
            Places::Even(_) => known,
            Places::Gauss(_) => {
                let points = self.chain.gauss_points(&mesh.boundaries);
                Arc::new(known.on_gauss_points(points, |place, numbers| mend(&known, place, numbers)))
            }
        });
        State { mesh, values, force: at.force, history }
    }
}

impl PlanarBeam {
    /// The grip in an equilibrium, seen from an earlier one.
    pub(crate) fn grip_state(&self, at: &State, from: &State) -> GripState {
        let (here, there) = (self.interface_values(at), self.interface_values(from));
        let moved = |slot: usize| here[slot] - there[slot];
        GripState {
            x: self.slot_of_x().map(moved),
            y: moved(self.slot_of_height()),
            rotation: here[self.slot_of_rotation()],
            in_space: None,
            forces: self.grip_forces(at),
        }
    }

    /// An equilibrium of the same beam with ξ at every node, `of`, as one of this beam, which has condensed that.
    pub(crate) fn without_x(&self, at: &State, of: &Self) -> State {
        let mut values: Vec<f64> = at.values.chunks_exact(of.fields()).flat_map(|node| &node[1..]).copied().collect();
        if self.chain.has_border() {
            let along = |node: usize| at.values[node * of.fields()];
            let last = at.values.len() / of.fields() - 1;
            let apart = self.length - self.span() + along(last) - along(0);
            values.extend([of.grip_forces(at).horizontal, apart]);
        }
        State { values, ..at.clone() }
    }

    /// What the grip exerts on the end of an equilibrium.
    pub(crate) fn grip_forces(&self, at: &State) -> GripForces {
        let last = at.mesh.elements() - 1;
        let section = self.chain.node_states(self.configuration(at), last..last + 1)[1].section;
        let SectionState { horizontal_force: horizontal, vertical_force: vertical, moment, .. } = section;
        GripForces { horizontal, vertical, moment, in_space: None }
    }
}

/// The place of the front along a chain, from the adhesion energy that is left over that of a unit length at the left end.
#[derive(Clone, Debug)]
pub enum FrontPosition {
    /// Every unit of length adheres alike: the two are the same number.
    Even,
    /// (front, S, dS/dfront), ascending: what adheres differs from place to place.
    Table(Vec<(f64, f64, f64)>),
}

/// Panels over which what adheres is summed.
const PANELS: usize = 256;

impl FrontPosition {
    /// From what adheres at each place of a chain when it lies on the substrate, over what adheres at its left end; of the `length` that adheres.
    pub fn new(length: f64, adheres: impl Fn(f64) -> f64) -> Self {
        let place = |k: usize| length * k as f64 / PANELS as f64;
        let (mut front, mut here) = (0.0, adheres(0.0));
        let mut table = vec![(front, 0.0, 1.0 / here)];
        for k in 1..=PANELS {
            let (from, to) = (place(k - 1), place(k));
            let (middle, next) = (adheres(0.5 * (from + to)), adheres(to));
            front += (to - from) / 6.0 * (here + 4.0 * middle + next);
            table.push((front, to, 1.0 / next));
            here = next;
        }
        Self::Table(table)
    }

    /// S of a front, nm; an end of the chain for a front beyond it.
    pub fn place(&self, front: f64) -> f64 {
        let Self::Table(table) = self else { return front };
        let before = table.partition_point(|known| known.0 < front).saturating_sub(1);
        match (table.get(before), table.get(before + 1)) {
            (Some(&a), Some(&b)) => Hermite::new(&[a, b]).at(front.max(a.0)).0,
            (Some(last), None) => last.1,
            _ => 0.0,
        }
    }

    /// The front that is not far from a place, nm.
    pub(crate) fn near(&self, place: f64) -> f64 {
        let Self::Table(table) = self else { return place };
        table.iter().rev().find(|known| known.1 <= place).map_or(0.0, |known| known.0 + (place - known.1) / known.2)
    }
}

// -- What a beam remembers from step to step --

/// What the face of a beam and its film remember, with what that is at rest.
#[derive(Clone, Debug, Default)]
pub enum BeamMemory {
    /// Nothing
    #[default]
    Nothing,
    /// How it has slid, from step to step: place, mobilisation and shear strength of each point.
    Slip(Arc<History>),
    /// How far it has been open and has slipped at most, where it does not heal: these up to where it began to close, by which the law goes, and up
    /// to now.
    Opening(Arc<History>),
    /// The same of a face under a film that yields, at the Gauss points of its mesh, which stays: behind it stands what its
    /// sections have been through.
    Film {
        /// Whether its face is as new where it comes back
        heals: bool,
    },
}

/// What a face may have healed without being said to have closed, over the work of adhesion of a process zone.
const HEALED: f64 = 1e-11;

impl BeamMemory {
    /// At rest, of a face that slides under friction
    pub(crate) fn slip_at_rest(&self) -> Option<&Arc<History>> {
        match self {
            Self::Slip(history) => Some(history),
            Self::Nothing | Self::Opening(_) | Self::Film { .. } => None,
        }
    }
}

impl PlanarBeam {
    /// What its material points remember at rest, on a mesh.
    pub(super) fn memory_at_rest(&self, ends: &[f64]) -> Option<Arc<History>> {
        match &self.memory {
            BeamMemory::Nothing => None,
            BeamMemory::Slip(history) | BeamMemory::Opening(history) => Some(history.clone()),
            BeamMemory::Film { .. } => {
                Some(Arc::new(History::at_gauss_points(self.chain.gauss_points(ends), FACE + FILM)))
            }
        }
    }

    /// What its material points remember behind a step that ended in a state.
    pub(super) fn remembered(&self, at: &State) -> Option<History> {
        let before = at.history.as_deref()?;
        let mut ends = before.ends;
        if let BeamMemory::Film { .. } = self.memory {
            ends = [ends[1], self.front_of(at)];
        }
        let steps = [before.ends[1] - before.ends[0], ends[1] - ends[0]];
        let (mut known, energy) = self.chain.updated_history(self.configuration(at), steps[0] / steps[1])?;
        known.ends = ends;
        if let BeamMemory::Slip(_) = self.memory {
            known.dissipated += energy;
        }
        Some(known)
    }

    /// A face that only opens goes by its law as it is. Where it has closed again in a step, how far it had been before that is what its law goes by
    /// from there on.
    pub(super) fn remembered_before_closing(&self, at: &State) -> Option<History> {
        let (BeamMemory::Opening(_) | BeamMemory::Film { heals: false, .. }) = self.memory else { return None };
        let (_, healed) = self.chain.updated_history(self.configuration(at), 0.0)?;
        let mut known =
            at.history.as_deref().filter(|_| healed > HEALED * self.rest_adhesion.abs() * self.process_length)?.clone();
        known.numbers_mut().for_each(|row| (row[0], row[1]) = (row[2], row[3]));
        Some(known)
    }
}

// -- What the face of a beam remembers of its sliding --

/// A history read as that of friction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrictionHistory<'a>(pub &'a History);

/// Share of the friction that is all of it.
const ALL: f64 = 1.0 - 1e-9;

impl FrictionHistory<'_> {
    /// S of each place (nm), with what it remembers.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (f64, FrictionState)> + '_ {
        self.0.points().map(|(s, _, row)| (s, FrictionState { place: row[0], mobilisation: row[1], limit: row[2] }))
    }

    /// ∫ τ dS, the friction that the contact bears per width, nN/nm.
    pub(crate) fn capacity(&self) -> f64 {
        self.0.points().map(|(_, length, row)| length * row[2]).sum()
    }

    /// ∫ t dS, what of it is carried, likewise; its sign is that of the way gone.
    pub(crate) fn carried(&self) -> f64 {
        self.0.points().map(|(_, length, row)| length * row[1] * row[2]).sum()
    }

    /// Whether all that is in contact slides one way, or the friction that it bears is below `little`, nN/nm.
    pub(crate) fn slides(&self, little: f64) -> bool {
        let capacity = self.capacity();
        capacity < little || self.carried().abs() > ALL * capacity
    }
}
