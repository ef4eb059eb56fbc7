//! How the branches of a tree hang together, and in which order its elements are integrated and eliminated, four at a time.
//!
//! Four elements side by side are of one branch, one behind the other from the far joint on, or of four branches that are alike and carry none of
//! one another: of a tree whose branches have an element each the others would be idle. Each is eliminated behind those that it carries.

use super::branching_beam::{Branch, TreeError};
use crate::solve::frontal::forest::Bundle;
use crate::solve::frontal::nodes::BUNDLE;

/// The branches from the root outwards: each behind the one that leads to it.
pub(super) struct Topology {
    /// Numbers of the branches
    pub outward: Vec<usize>,
    /// Of each branch, which of its ends is nearer to the root: 0 or 1
    pub near: Vec<usize>,
    /// Of each joint the branch that leads to the root; none of the root
    pub inward: Vec<Option<usize>>,
    /// Of each joint, the branches that meet there
    pub meeting: Vec<Vec<usize>>,
}

impl Topology {
    /// Of the branches of a tree with this root.
    ///
    /// # Errors
    /// A loop, with two branches of it; a part that does not hang together with the root; numbers of joints that no tree has.
    pub(crate) fn new(branches: &[Branch], root: usize) -> Result<Self, TreeError> {
        // a tree has one joint more than branches
        let joints = branches.len() + 1;
        for (branch, own) in branches.iter().enumerate() {
            let [first, last] = own.joints;
            if first == last {
                return Err(TreeError::Ring { branch, joint: first });
            }
            if first.max(last) >= joints {
                return Err(TreeError::Number { branch, joint: first.max(last), branches: branches.len() });
            }
        }
        let mut meeting = vec![Vec::new(); joints];
        for (b, branch) in branches.iter().enumerate() {
            branch.joints.into_iter().for_each(|joint| meeting[joint].push(b));
        }
        if meeting.get(root).is_none_or(Vec::is_empty) {
            return Err(TreeError::Root { root });
        }
        let (mut inward, mut near) = (vec![None; joints], vec![0; branches.len()]);
        let (mut outward, mut reached, mut next) = (Vec::with_capacity(branches.len()), vec![root], 0);
        while let Some(&joint) = reached.get(next) {
            next += 1;
            let leading = inward[joint];
            for &b in meeting[joint].iter().filter(|&&b| leading != Some(b)) {
                let [first, last] = branches[b].joints;
                let far = if first == joint { last } else { first };
                if let Some(first) = inward[far] {
                    return Err(TreeError::Loop { first, second: b, joint: far });
                }
                near[b] = usize::from(first != joint);
                inward[far] = Some(b);
                outward.push(b);
                reached.push(far);
            }
        }
        let is_apart = |(b, branch): &(usize, &Branch)| !branch.joints.iter().any(|&joint| inward[joint] == Some(*b));
        if let Some((branch, own)) = branches.iter().enumerate().find(is_apart) {
            return Err(TreeError::Apart { branch, first: own.joints[0], last: own.joints[1], root });
        }
        Ok(Self { outward, near, inward, meeting })
    }
}

/// Elements that are integrated side by side, of one section: branch, and which of its elements, counted from the far joint.
pub(super) type TreeBundle = Bundle<(usize, usize)>;

/// All elements of a tree, those that are carried before those that carry them.
pub(super) fn schedule(branches: &[Branch], topology: &Topology) -> Vec<TreeBundle> {
    let mut depths = vec![0; branches.len()];
    for &b in &topology.outward {
        let near = branches[b].joints[topology.near[b]];
        depths[b] = topology.inward[near].map_or(0, |carrier| depths[carrier] + 1);
    }
    let are_alike = |a: usize, b: usize| {
        let (one, other) = (&branches[a], &branches[b]);
        let sections_are = || {
            one.mesh.is_alike(&other.mesh)
                && one.sections.is_alike(&other.sections)
                && one.rest.curvature() == other.rest.curvature()
        };
        a == b || depths[a] == depths[b] && sections_are()
    };
    let inward: Vec<usize> = topology.outward.iter().rev().copied().collect();
    let (mut bundles, mut rest) = (Vec::new(), &inward[..]);
    while let Some(&first) = rest.first() {
        let alike = rest.iter().take(BUNDLE).take_while(|&&other| are_alike(first, other)).count();
        let (group, behind) = rest.split_at(alike);
        rest = behind;
        let elements = branches[first].mesh.elements();
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
