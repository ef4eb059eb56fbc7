//! In which order the elements of a tree are integrated and eliminated, four at a time.
//!
//! Four elements side by side are of one branch, one behind the other from the far joint on, or of four branches that are alike and carry none of
//! one another: of a tree whose branches have an element each the others would be idle. Each is eliminated behind those that it carries.

use super::branching_beam::Branch;
use super::topology::Topology;
use crate::beam::planar::uniform_chain::BUNDLE;

/// Elements that are integrated side by side: of one section.
#[derive(Clone, Copy, Debug)]
pub(super) struct TreeBundle {
    /// Branch, and which of its elements, counted from the far joint; behind the last one it is repeated.
    pub lanes: [(usize, usize); BUNDLE],
    /// How many there are
    pub count: usize,
}

impl TreeBundle {
    fn of(lanes: &[(usize, usize)]) -> Self {
        let count = lanes.len();
        Self { lanes: std::array::from_fn(|l| lanes[l.min(count - 1)]), count }
    }
}

/// All elements of a tree, those that are carried before those that carry them.
pub(super) fn schedule(branches: &[Branch], topology: &Topology) -> Vec<TreeBundle> {
    let mut depths = vec![0; branches.len()];
    for &b in &topology.outward {
        let near = branches[b].joints[topology.near[b]];
        depths[b] = topology.inward[near].map_or(0, |carrier| depths[carrier] + 1);
    }
    let are_alike = |a: usize, b: usize| {
        let (one, other) = (&branches[a], &branches[b]);
        depths[a] == depths[b]
            && one.elements == other.elements
            && one.stiffness == other.stiffness
            && one.rest.curvature == other.rest.curvature
    };
    let inward: Vec<usize> = topology.outward.iter().rev().copied().collect();
    let (mut bundles, mut rest) = (Vec::new(), &inward[..]);
    while let Some(&first) = rest.first() {
        let alike = rest.iter().take(BUNDLE).take_while(|&&other| are_alike(first, other)).count();
        let (group, behind) = rest.split_at(alike);
        rest = behind;
        let elements = branches[first].elements;
        if elements < alike * elements.div_ceil(BUNDLE) {
            for k in 0..elements {
                let lanes: Vec<_> = group.iter().map(|&branch| (branch, k)).collect();
                bundles.push(TreeBundle::of(&lanes));
            }
        } else {
            for &branch in group {
                let own: Vec<_> = (0..elements).map(|k| (branch, k)).collect();
                bundles.extend(own.chunks(BUNDLE).map(TreeBundle::of));
            }
        }
    }
    bundles
}
