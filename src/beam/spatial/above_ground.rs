//! How far sections of a beam in space are above the ground: where their edges let go of it, and what places of nodes are measured by.
//!
//! A strip that is rolled peels along one of its edges first. Behind the place where that edge lets go it twists, up to the place where the other
//! one does: within a short way at each of the two, and evenly in between. So a mesh follows both. With the gap g of an edge and its equilibrium
//! distance r0, an edge has let go at
//!
//!   E = ∫ w(g)/w(g0) dS,   w(g) = 1/(1 + (g/r0)⁸),   g± = y ± ½ b d2·e_y - ½ h |d3·e_y|,
//!
//! g0 that of a section that lies on the ground; of an ellipse both are its lowest point.
//!
//! Places of a node are measured by how far the lowest point of its section is from where that of a section is that lies on the ground. A
//! section that stands on its edge has its axis half a width above the ground and adheres by its corner. With the gap g of its lowest point and
//! that at rest g0, a change of its place is one of its own scale when it is as large as r0 + (g - g0): near the ground the law changes within r0,
//! whatever part of the section is there.
//!
//! So it is where the section varies. A uniform strip is measured by the height of its axis: by that of its lowest point the branch point of one 1 nm wide
//! (`tests/mechanics/study/space.rs`) was located to 1.2e-6 of its displacement instead of the 1e-6 asked for.

use super::chain::spatial_chain::quaternion_of;
use super::rotation::{Quaternion, matrix};
use super::section::kinematics::SPATIAL_FIELDS;
use super::section::spatial_profile::SpatialProfile;
use super::spatial_beam::{ANGLES, SpatialBeam};
use crate::adhesion::spatial_section::section::SectionShape;
use crate::solve::state::State;

/// Sections whose edges let go of the ground: their outline, and how they lie.
#[derive(Clone, Copy)]
pub(super) struct LettingGo<'a> {
    pub profile: &'a SpatialProfile,
    pub shape: SectionShape,
    /// r0, nm
    pub gap_scale: f64,
    /// g0: gap of a section that lies on the ground, nm
    pub gap: f64,
}

impl LettingGo<'_> {
    /// E of the two edges, nm, of nodes at S with their fields.
    pub(crate) fn edges<'n>(&self, nodes: impl Iterator<Item = (f64, &'n [f64])>) -> [f64; 2] {
        let (mut sums, mut before) = ([0.0; 2], (0.0, [0.0; 2]));
        for (place, node) in nodes {
            let adhering = self.adhering_edges(place, node);
            for edge in 0..2 {
                sums[edge] += 0.5 * (place - before.0) * (adhering[edge] + before.1[edge]);
            }
            before = (place, adhering);
        }
        let rest = adhering(self.gap / self.gap_scale);
        sums.map(|sum| sum / rest)
    }

    /// w of the two edges of a section with these fields.
    fn adhering_edges(&self, place: f64, node: &[f64]) -> [f64; 2] {
        let frame = matrix(quaternion_of(node));
        let [width, height] = self.profile.outline(place);
        let (aside, up) = (0.5 * width * frame[1][1], 0.5 * height * frame[1][2].abs());
        let gaps = match self.shape {
            SectionShape::Ellipse => [node[1] - aside.hypot(up); 2],
            SectionShape::Rectangle => [node[1] - up - aside, node[1] - up + aside],
        };
        gaps.map(|gap| adhering(gap / self.gap_scale))
    }
}

impl SpatialBeam {
    /// The two places, from that of the front, nm; zeros where nothing follows them.
    pub(crate) fn edges(&self, at: &State, front: f64) -> Vec<f64> {
        let Some(adhesion) = self.chain.density.adhesion.as_ref().filter(|_| !self.mesh.edge_foci.is_empty()) else {
            return vec![0.0; 2];
        };
        let (order, boundaries) = (self.chain.order(), &at.mesh.boundaries);
        let nodes = at.values[..at.values.len() - ANGLES].chunks_exact(SPATIAL_FIELDS).enumerate().map(|(k, node)| {
            let element = (k / order).min(boundaries.len() - 2);
            let (from, to) = (boundaries[element], boundaries[element + 1]);
            (from + self.chain.node_fraction(k - element * order) * (to - from), node)
        });
        let ([_, y, _], _) = self.rest.at(0.0);
        let profile = &self.chain.density.profile;
        let gap = y - 0.5 * profile.outline(0.0)[1];
        let own = LettingGo { profile, shape: adhesion.shape(), gap_scale: self.scale[0], gap };
        let place = self.rest.fronts().place(front);
        own.edges(nodes).map(|edge| edge - place).to_vec()
    }
}

/// w of a gap over r0.
fn adhering(gap: f64) -> f64 {
    1.0 / (1.0 + gap.max(0.0).powi(8))
}

impl SpatialBeam {
    /// What the places of the nodes of a state are measured by, nm, from the left end on. Between the ends of an element its outline counts as
    /// straight.
    pub(super) fn place_units<'a>(&'a self, at: &'a State) -> impl Iterator<Item = f64> + 'a {
        let (order, ends) = (self.chain.order(), &at.mesh.boundaries);
        let is_round = self.chain.density.adhesion.as_ref().is_some_and(|own| own.shape() == SectionShape::Ellipse);
        let (mut element, mut outline) = (usize::MAX, [[0.0; 2]; 2]);
        let nodes = at.values[..at.values.len() - ANGLES].chunks_exact(SPATIAL_FIELDS);
        nodes.enumerate().map(move |(k, node)| {
            let own = (k / order).min(ends.len() - 2);
            if own != element {
                let first =
                    if element == usize::MAX { self.chain.density.profile.outline(ends[0]) } else { outline[1] };
                (element, outline) = (own, [first, self.chain.density.profile.outline(ends[own + 1])]);
            }
            let share = self.chain.node_fraction(k - own * order);
            let [width, height] = [0, 1].map(|i| outline[0][i] + share * (outline[1][i] - outline[0][i]));
            let [aside, up] = tilts(quaternion_of(node)).map(f64::abs);
            let (aside, up) = (0.5 * width * aside, 0.5 * height * up);
            let lowest = node[1] - if is_round { aside.hypot(up) } else { aside + up };
            self.scale[0] + self.rest.lift(node[1], lowest)
        })
    }
}

/// d2·e_y and d3·e_y.
fn tilts([w, x, y, z]: Quaternion) -> [f64; 2] {
    [w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)]
}
