//! What places of a node are measured by: how far the lowest point of its section is from where that of a section is that lies on the ground.
//!
//! A section that stands on its edge has its axis half a width above the ground and adheres by its corner. With the gap g of its lowest point and
//! that at rest g0, a change of its place is one of its own scale when it is as large as r0 + (g - g0): near the ground the law changes within r0,
//! whatever part of the section is there.
//!
//! So it is where the section varies. A uniform strip is measured by the height of its axis: by that of its lowest point the branch point of one 1 nm wide
//! (`tests/mechanics/study/space.rs`) was located to 1.2e-6 of its displacement instead of the 1e-6 asked for.

use super::chain::quaternion_of;
use super::kinematics::SPATIAL_FIELDS;
use super::rotation::Quaternion;
use super::spatial_beam::{ANGLES, SpatialBeam};
use crate::adhesion::spatial_section::section::SectionShape;
use crate::solve::state::State;

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
