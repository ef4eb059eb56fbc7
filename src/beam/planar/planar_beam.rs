//! A planar beam: a chain of elements on a substrate or on its own, in its reference configuration.

use super::chain::{Chain, Configuration, MOST_FIELDS};
use super::element::planar_element::ElementEnergy;
use super::front_position::FrontPosition;
use super::mesh_policy::MeshPolicy;
use super::model_limits::ModelLimits;
use super::planar_motion::BeamInertia;
use crate::adhesion::section::barrier::Barrier;
use crate::adhesion::substrate::Substrate;
use crate::beam::mesh::nodal_lengths;
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::solve::state::{History, State};
use crate::solve::system::{Coefficients, Evaluation, INTERFACE};
use std::borrow::Cow;
use std::sync::Arc;

/// The monitor that is the peeling front: adhesion energy over that of a unit length at rest at the left end, nm; zero where nothing
/// adheres.
pub const FRONT: usize = 0;
/// The monitor that is θ(0), the rotation of the left end, rad. The number for the record is θ(L), that of the grip.
pub const TIP_ROTATION: usize = 1;

/// A chain with its reference configuration and the scales of its adhesion.
///
/// Unknowns: the fields of the nodes from left to right, y and θ, or x, y and θ; behind them, where x is condensed and a horizontal force
/// acts, that force H and the place of the right end along x. The interface is the right end.
pub struct PlanarBeam {
    /// Its elements
    pub chain: Box<dyn Chain>,
    /// Reference length L, nm
    pub length: f64,
    /// x, height and rotation in the stress-free configuration; a chain of two fields a node leaves x out.
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
    /// What the material points remember at rest, where there is friction.
    pub history: Option<Arc<History>>,
    /// Whether the load has a potential.
    pub conservative: bool,
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

    /// The numbers of a state of this beam, or of one that is pulled in another direction: H and the place of the right end stay, go,
    /// or come as zero.
    pub fn adopted<'a>(&self, at: &'a State) -> Cow<'a, [f64]> {
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
    pub fn adheres(&self) -> bool {
        self.rest_adhesion != 0.0
    }

    /// The front for a coverage, or its change for a change of that, nm: how long the left end's adhesion would have to go
    /// on; zero where nothing adheres. [`FrontPosition`] knows where that is.
    pub fn front(&self, coverage: f64) -> f64 {
        if self.adheres() { coverage / self.rest_adhesion } else { 0.0 }
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
    pub fn front_of(&self, at: &State) -> f64 {
        self.front(self.chain.energy(self.configuration(at), self.nodes(&at.values)).0.coverage)
    }

    /// What the height of a node is measured by: its scale plus its lift, nm.
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
    pub fn nearest(&self, at: &State) -> f64 {
        self.distances(at).fold(f64::INFINITY, f64::min)
    }

    /// Distance of the beam from what it cannot pass, nm.
    pub fn clearance(&self, at: &State) -> f64 {
        self.barrier.clearance(self.nearest(at))
    }

    /// Whether no part of the beam is nearer to the substrate than `far`, nm.
    pub fn is_clear(&self, at: &State, far: f64) -> bool {
        self.distances(at).all(|distance| distance > far)
    }

    /// Distance of each node from the substrate, nm.
    fn distances<'a>(&'a self, at: &'a State) -> impl Iterator<Item = f64> + 'a {
        let (order, ends) = (self.chain.order(), &at.mesh.boundaries);
        let nodes = self.nodes(&at.values).chunks_exact(self.fields()).enumerate();
        // a node inside of an element is taken to be as high as the left end of that
        nodes.map(move |(k, node)| self.distance(ends[k / order], node))
    }

    /// Whether all of the beam is above what it cannot pass, between its nodes as well.
    pub fn is_above(&self, at: &State) -> bool {
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

    /// Distance of a section with these fields from the substrate, nm, of the height that sections have at `place`.
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
