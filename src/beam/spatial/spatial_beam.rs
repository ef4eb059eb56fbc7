//! A beam in space: a chain of elements above flat ground or on its own, in its rest configuration.

use super::chain::fields_along::FieldsAlong;
use super::chain::read::normalise;
use super::chain::spatial_chain::{SpatialChain, SpatialConfiguration};
use super::end_rotation::{EndRotation, turned};
use super::rest::SpatialRest;
use super::rotation::apply_transposed;
use super::section::branch_sections::lowest;
use super::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::adhesion::section::barrier::Barrier;
use crate::adhesion::spatial_section::section::SpatialSection;
use crate::beam::mesh::{MeshKind, MeshPolicy};
use crate::beam::viscosity::Viscosity;
use crate::solve::state::{Mesh, State};
use crate::solve::system::INTERFACE;
use std::fmt;
use std::sync::Arc;

/// Values of a state behind those of its nodes: the angles of the two ends.
pub(super) const ANGLES: usize = 6;

/// A chain with its rest configuration and the scales of its adhesion.
///
/// Values of a state: x, y, z and the quaternion of each node from left to right, then the angles of the left and of the right end (of an end
/// that turns freely they count its turns alone). A direction has six numbers a node: of its place, and of its turn in the axes of its directors; of the two end
/// nodes those of [`crate::beam::SpatialEnd`]. The interface is the right end.
#[derive(Clone, Debug)]
pub struct SpatialBeam {
    /// Its elements
    pub chain: SpatialChain,
    /// Reference length L, nm
    pub length: f64,
    /// The stress-free configuration
    pub rest: SpatialRest,
    /// Scales of an error: of a place near the ground (nm), and of a turn (rad).
    pub scale: [f64; 2],
    /// The machine's epsilon times the ratio of the stiffest to the softest way to deform, or zero where that ratio is small.
    pub round_off: f64,
    /// Adhesion energy per length at rest, nN: negative, or zero where nothing adheres. Then there is no front.
    pub rest_adhesion: f64,
    /// Length ℓ of the process zone, nm; L where nothing adheres
    pub process_length: f64,
    /// What keeps it out of the substrate
    pub barrier: Barrier,
    /// Where its elements end
    pub mesh: MeshPolicy,
    /// Its mass, where it moves in time
    pub inertia: Option<SpatialInertia>,
}

impl SpatialBeam {
    /// Whether there is adhesion, and with it a front.
    pub fn adheres(&self) -> bool {
        self.rest_adhesion != 0.0
    }

    /// The front for a coverage, or its change for a change of that, nm; zero where nothing adheres.
    pub(crate) fn front(&self, coverage: f64) -> f64 {
        if self.adheres() { coverage / self.rest_adhesion } else { 0.0 }
    }

    /// A state as its chain sees it.
    pub fn configuration<'a>(&self, at: &'a State) -> SpatialConfiguration<'a> {
        self.seen(&at.values, &at.mesh.boundaries)
    }

    pub(super) fn seen<'a>(&self, values: &'a [f64], boundaries: &'a [f64]) -> SpatialConfiguration<'a> {
        let (fields, angles) = values.split_at(values.len() - ANGLES);
        let of = |end: usize| [angles[3 * end], angles[3 * end + 1], angles[3 * end + 2]];
        SpatialConfiguration { boundaries, fields, angles: [of(0), of(1)], known: None }
    }

    /// Makes the quaternions of a state's values ones of length one, those of ends with angles the ones that these say.
    pub(super) fn settle_rotations(&self, values: &mut [f64]) {
        let last = values.len() - ANGLES - SPATIAL_FIELDS;
        values[..last + SPATIAL_FIELDS].chunks_exact_mut(SPATIAL_FIELDS).for_each(normalise);
        for (end, from) in [(0, 0), (1, last)] {
            let own = &self.chain.ends[end];
            if own.rotation == EndRotation::Angles {
                let angles = std::array::from_fn(|k| values[last + SPATIAL_FIELDS + 3 * end + k]);
                values[from + 3..from + SPATIAL_FIELDS].copy_from_slice(&turned(angles, own.rest));
            }
        }
    }

    /// The mesh for a front and edges with so many elements on each piece, which may be found faster from the `near` ends of a similar one.
    pub(super) fn mesh_of(&self, front: f64, edges: &[f64], counts: &[usize], near: &[f64]) -> Mesh {
        let focus = self.centered(front);
        let moves = self.mesh.kind == MeshKind::Moving;
        let place = || if moves { self.rest.fronts().place(focus) } else { self.rest.front(self.length) };
        let followed = if moves { edges } else { &[0.0; 2] };
        Mesh {
            boundaries: self.mesh.ends(self.adheres().then(place), followed, counts, near),
            focus,
            follows: edges.to_vec(),
        }
    }

    /// A front as the focus of a mesh: no farther than the ends of the chain.
    pub(super) fn centered(&self, front: f64) -> f64 {
        front.clamp(0.0, self.rest.fronts().near(self.length))
    }

    /// A mesh of its own for a front and [`Mesh::follows`], its edges.
    pub(crate) fn mesh_at(&self, front: f64, edges: &[f64], elements: usize) -> Mesh {
        self.mesh_of(front, edges, &self.mesh.pieces.shared_out(elements), &[])
    }

    /// The mesh for a front and edges with as many elements as another one, found faster near to that.
    pub(crate) fn mesh_near(&self, front: f64, edges: &[f64], like: &Mesh) -> Mesh {
        self.mesh_of(front, edges, &self.mesh.pieces.counted(&like.boundaries), &like.boundaries)
    }

    /// A state read off on another mesh.
    pub(crate) fn resampled(&self, at: &State, mesh: Mesh) -> State {
        let mut values = FieldsAlong::of(&self.chain, self.configuration(at)).resampled(&mesh.boundaries);
        values.extend_from_slice(&at.values[at.values.len() - ANGLES..]);
        self.settle_rotations(&mut values);
        State { mesh, values, ..at.clone() }
    }

    /// The peeling front of a state, nm.
    pub(crate) fn front_of(&self, at: &State) -> f64 {
        let still = vec![0.0; (at.values.len() - ANGLES) / SPATIAL_FIELDS * SPATIAL_UNKNOWNS];
        self.front(self.chain.energy(self.configuration(at), &still).0.coverage)
    }

    /// Height of the lowest point of a section with these fields above the ground, nm.
    fn lowest(&self, place: f64, fields: &[f64; SPATIAL_FIELDS]) -> f64 {
        let shape = self.chain.density.adhesion.as_ref().map(SpatialSection::shape).unwrap_or_default();
        lowest(self.chain.density.profile.outline(place), shape, fields)
    }

    /// Distance of the beam from the ground, nm: of the lowest points of its sections, at its nodes and between them.
    pub(crate) fn nearest(&self, at: &State) -> f64 {
        self.lowest_points(at).fold(f64::INFINITY, f64::min)
    }

    /// Distance of the beam from what it cannot pass, nm.
    pub(crate) fn clearance(&self, at: &State) -> f64 {
        self.barrier.clearance(self.nearest(at))
    }

    /// Whether no part of the beam is nearer to the ground than `far`, nm, unless it has slipped so far that nothing attracts it.
    pub(crate) fn is_clear(&self, at: &State, far: f64) -> bool {
        self.beyond(at, far) > 0.0
    }

    /// How much farther than `far` the beam is from the ground where it is nearest, nm. A face that its adhesive holds along the ground and that has
    /// slipped beyond its reach, by a share of that, is by the same share of `far` beyond it.
    pub(crate) fn beyond(&self, at: &State, far: f64) -> f64 {
        let density = &self.chain.density;
        let held = density.held.as_ref().map(|held| (held, held.law.slip_reach()));
        let of = |(place, fields): (f64, [f64; SPATIAL_FIELDS])| {
            let lifted = self.lowest(place, &fields) - far;
            held.map_or(lifted, |(held, reach)| {
                let [_, height] = density.profile.outline(place);
                lifted.max(far * (held.slip(place, height, &fields) / reach - 1.0))
            })
        };
        self.sections(at).map(of).fold(f64::INFINITY, f64::min)
    }

    /// Heights of the lowest points of sections at the nodes and between them, from the left end on, nm.
    fn lowest_points(&self, at: &State) -> impl Iterator<Item = f64> {
        self.sections(at).map(|(place, fields)| self.lowest(place, &fields))
    }

    /// S (nm) and the fields of sections at the nodes and between them, from the left end on.
    fn sections(&self, at: &State) -> impl Iterator<Item = (f64, [f64; SPATIAL_FIELDS])> {
        let (configuration, order) = (self.configuration(at), self.chain.order());
        at.mesh.boundaries.windows(2).enumerate().flat_map(move |(element, pair)| {
            (0..=2 * order).map(move |k| {
                let local = k as f64 / order as f64 - 1.0;
                let (fields, _) = self.chain.sample(configuration, element, local);
                (pair[0] + 0.5 * (1.0 + local) * (pair[1] - pair[0]), fields)
            })
        })
    }

    /// Values of the stress-free state on a mesh.
    pub(super) fn rest_values(&self, boundaries: &[f64]) -> Vec<f64> {
        let order = self.chain.order();
        let mut values = Vec::new();
        for (e, pair) in boundaries.windows(2).enumerate() {
            let last = usize::from(e + 2 == boundaries.len());
            for rank in 0..order + last {
                let place = pair[0] + self.chain.node_fraction(rank) * (pair[1] - pair[0]);
                let ([x, y, z], q) = self.rest.at(place);
                values.extend([x, self.rest.lifted(place, y), z]);
                values.extend(q);
            }
        }
        values.extend(self.rest_angles());
        values
    }

    /// The angles of the two ends at rest, rad.
    fn rest_angles(&self) -> [f64; ANGLES] {
        let rotation = |end: usize, place: f64| match self.chain.ends[end].rotation {
            EndRotation::Angles => self.rest.rotation(place),
            EndRotation::Free => 0.0,
        };
        [rotation(0, 0.0), 0.0, 0.0, rotation(1, self.length), 0.0, 0.0]
    }

    /// Values of the interface in the stress-free configuration, not lifted off the ground.
    pub fn interface_at_rest(&self) -> [f64; INTERFACE] {
        let ([_, _, _, rotation, yaw, roll], (place, _)) = (self.rest_angles(), self.rest.at(self.length));
        let [along, across, sideways] = apply_transposed(&self.chain.ends[1].axes, &place);
        [along, across, sideways, rotation, yaw, roll]
    }
}

/// What a beam in space in motion has besides its stiffness.
#[derive(Clone)]
pub struct SpatialInertia {
    /// At S: ρA, then ρJ1 about the axis, ρJ2 about the width and ρJ3 about the height
    pub section: Arc<dyn Fn(f64) -> [f64; 4] + Send + Sync>,
    /// How its material flows
    pub viscosity: Viscosity,
}

impl SpatialInertia {
    /// The same everywhere: mass per length, and rotary inertia per length about the three directors.
    pub fn uniform(per_length: f64, rotary: [f64; 3], viscosity: Viscosity) -> Self {
        Self { section: Arc::new(move |_| [per_length, rotary[0], rotary[1], rotary[2]]), viscosity }
    }
}

impl fmt::Debug for SpatialInertia {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("SpatialInertia")
            .field("at the left end", &(self.section)(0.0))
            .field("viscosity", &self.viscosity)
            .finish()
    }
}
