//! Where the elements of a planar beam lie, and how a state gets onto another mesh.

use super::planar_beam::PlanarBeam;
use crate::beam::mesh::{Focus, MeshIntervals, MeshKind, graded_ends};
use crate::solve::state::{Mesh, State};

/// How the elements of a beam are laid out.
#[derive(Clone, Debug)]
pub struct MeshPolicy {
    /// Whether the mesh follows the front.
    pub kind: MeshKind,
    /// Foci that follow the front, as they are for a front at S = 0.
    pub front_foci: Vec<Focus>,
    /// Foci that follow each of the two edges of a section in space, likewise.
    pub edge_foci: Vec<Focus>,
    /// Foci of the mesh besides those.
    pub fixed_foci: Vec<Focus>,
    /// Between which places elements lie.
    pub pieces: MeshIntervals,
}

impl MeshPolicy {
    /// Ends of so many elements on each piece for a front at this place and edges so far from it, which may be found faster from the `near` ones of
    /// a similar mesh; without a front they are graded towards nothing.
    pub fn ends(&self, front: Option<f64>, edges: [f64; 2], counts: &[usize], near: &[f64]) -> Vec<f64> {
        let Self { kind, front_foci, edge_foci, fixed_foci, pieces } = self;
        let mut foci = Vec::with_capacity(front_foci.len() + edges.len() * edge_foci.len() + fixed_foci.len());
        if let Some(front) = front.filter(|_| *kind != MeshKind::Uniform) {
            let at = |place: f64| move |focus: &Focus| Focus { center: place + focus.center, ..*focus };
            foci.extend(front_foci.iter().map(at(front)));
            edges.iter().for_each(|edge| foci.extend(edge_foci.iter().map(at((front + edge).max(0.0)))));
            foci.extend(fixed_foci);
        }
        graded_ends(pieces, &foci, counts, near)
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
        Mesh { boundaries: self.mesh.ends(front, [0.0; 2], counts, near), focus, ..Mesh::default() }
    }

    /// A mesh of its own for a front.
    pub fn mesh_at(&self, front: f64, elements: usize) -> Mesh {
        self.mesh_of(front, &self.mesh.pieces.shared_out(elements), &[])
    }

    /// The mesh for a front with as many elements as another one, found faster near to that.
    pub fn mesh_near(&self, front: f64, like: &Mesh) -> Mesh {
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
    pub fn resampled(&self, at: &State, mesh: Mesh) -> State {
        let mut values = self.chain.resampled(self.configuration(at), &mesh.boundaries);
        values.extend_from_slice(&at.values[self.nodes(&at.values).len()..]);
        State { mesh, values, ..at.clone() }
    }
}
