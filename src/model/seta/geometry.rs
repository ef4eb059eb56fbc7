//! Where the joints of a seta are, and the tree of beams between them.
//!
//! Every joint stands above the centroid of the tips behind it, moved by the lean of the brush. Joint 0 is the root, joint 1 the end of the shaft;
//! then come the ends of the branches behind one fork, those behind two, and so on: where each fork is one in two, joints 2ᵏ to 2ᵏ⁺¹ - 1. The
//! last ones are the tips. A tree that is given whole says all of this itself.

use super::check::SetaError;
use super::parameters::{Seta, SetaMesh};
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::section::spatial_profile::SpatialStiffness;
use crate::beam::spatial::tree::branching_beam::{Branch, BranchingBeam};
use std::f64::consts::PI;
use std::ops::Range;

/// Of the golden section: fractions of its multiples are spread evenly.
const GOLDEN: f64 = 0.618034;
/// Scales of an error: of a place, nm, and of a turn, rad.
const SCALE: [f64; 2] = [10.0, 1e-2];
/// A branch is nearly across where it goes so many times as far along z as off it.
const ACROSS: f64 = 10.0;
/// Across all branches, in the ground
const SIDEWAYS: [f64; 3] = [0.0, 0.0, 1.0];

impl Seta {
    /// Number of tips.
    pub fn tips(&self) -> usize {
        match &self.tree {
            Some(tree) => tree.tips().len(),
            None => (0..self.levels()).map(|level| self.branches_at(level)).product(),
        }
    }

    /// Number of joints: the root, the forks, the tips, and, of a tree that is given whole, where a branch bends.
    pub fn joints(&self) -> usize {
        match &self.tree {
            Some(tree) => tree.joints().len(),
            None => self.joints_before(self.levels()) + self.tips(),
        }
    }

    /// The most forks between the root and a tip.
    pub fn levels(&self) -> usize {
        match &self.tree {
            Some(tree) => tree.most_forks(),
            None if self.branches.is_empty() => self.forks,
            None => self.branches.len(),
        }
    }

    /// Joint of a tip.
    pub fn tip_joint(&self, tip: usize) -> usize {
        match &self.tree {
            Some(tree) => tree.tips()[tip],
            None => self.joints_before(self.levels()) + tip,
        }
    }

    /// The tip at a joint, if one is there.
    pub(crate) fn tip_at(&self, joint: usize) -> Option<usize> {
        Some(self.tips_behind(joint).start).filter(|&tip| self.tip_joint(tip) == joint)
    }

    /// The joint next to this one on the way to the root; of the root itself the root.
    pub fn parent(&self, joint: usize) -> usize {
        if let Some(tree) = &self.tree {
            return tree.parent(joint);
        }
        match self.level_of(joint) {
            (0, _) => 0,
            (level, index) => self.joints_before(level - 1) + index / self.branches_at(level - 1),
        }
    }

    /// Forks between the root and the branch that ends at a joint.
    pub(crate) fn generation(&self, joint: usize) -> usize {
        self.tree.as_ref().map_or_else(|| self.level_of(joint).0, |tree| tree.generation(joint))
    }

    /// The tips that a joint carries, or that are it.
    pub(crate) fn tips_behind(&self, joint: usize) -> Range<usize> {
        if let Some(tree) = &self.tree {
            return tree.tips_behind(joint);
        }
        let (level, index) = self.level_of(joint);
        let each = (level..self.levels()).map(|level| self.branches_at(level)).product::<usize>();
        each * index..each * (index + 1)
    }

    /// Where a joint is in the stress-free configuration, nm.
    pub fn joint_place(&self, joint: usize) -> [f64; 3] {
        if let Some(tree) = &self.tree {
            return tree.joints()[joint].place;
        }
        if joint == 0 {
            let [x, y, z] = self.joint_place(1);
            let (sin, cos) = self.shaft_angle.sin_cos();
            return [x + self.shaft_length * sin, y + self.shaft_length * cos, z];
        }
        let (level, index) = self.level_of(joint);
        let height = self.height(level);
        let [x, z] = self.centroid(level, index);
        let scatter = if level == self.levels() { self.scatter(index) } else { 0.0 };
        [x + height * self.brush_angle.tan(), height + scatter, z]
    }

    /// By how much a tip stands too high in the stress-free configuration, nm.
    pub(crate) fn scatter(&self, tip: usize) -> f64 {
        match &self.tree {
            Some(tree) => tree.joints()[tree.tips()[tip]].place[1],
            None => self.height_scatter * (2.0 * (GOLDEN * tip as f64).fract() - 1.0),
        }
    }

    /// By how much one tip stands higher than another at most, nm.
    pub fn spread(&self) -> f64 {
        self.tree.as_ref().map_or(2.0 * self.height_scatter, |tree| tree.spread())
    }

    /// How far tips stand apart, nm: the least distance of two along x or z, whichever is larger, but no less than a quarter of what it were if all
    /// stood in rows.
    pub fn tip_distance(&self) -> f64 {
        self.tree.as_ref().map_or(self.tip_pitch, |tree| tree.tip_distance())
    }

    /// How far the root may be from a tip, upright, nm.
    pub fn reach(&self) -> f64 {
        let brush = self.fork_heights.first().unwrap_or(&self.brush_height);
        self.tree.as_ref().map_or(self.shaft_length + brush, |tree| tree.reach())
    }

    /// Diameter of the branch that ends at a joint, nm.
    pub fn branch_diameter(&self, joint: usize) -> f64 {
        if let Some(tree) = &self.tree {
            return tree.joints()[joint].diameter;
        }
        let level = self.level_of(joint).0;
        match self.diameters.get(level) {
            Some(&diameter) => diameter,
            None => self.shaft_diameter * self.diameter_ratio.powi(level as i32),
        }
    }

    // -- Level by level: the branches of level k are those behind k forks --

    /// Branches behind a fork of a level.
    fn branches_at(&self, level: usize) -> usize {
        self.branches.get(level).copied().unwrap_or(2)
    }

    /// Joints nearer to the root than those at which the branches of a level end.
    fn joints_before(&self, level: usize) -> usize {
        let (mut before, mut ends) = (1, 1);
        for level in 0..level {
            before += ends;
            ends *= self.branches_at(level);
        }
        before
    }

    /// Which branch of its level ends at a joint: the level, and its number there. The root counts as the shaft's end.
    fn level_of(&self, joint: usize) -> (usize, usize) {
        let (mut index, mut ends) = (joint.saturating_sub(1), 1);
        for level in 0..self.levels() {
            if index < ends {
                return (level, index);
            }
            index -= ends;
            ends *= self.branches_at(level);
        }
        (self.levels(), index)
    }

    /// Height of the forks behind so many, or of the tips, above the plane of the tips, nm.
    pub(super) fn height(&self, level: usize) -> f64 {
        if level == self.levels() {
            return 0.0;
        }
        if let Some(&height) = self.fork_heights.get(level) {
            return height;
        }
        let last = self.height_ratio.powi(self.levels() as i32);
        self.brush_height * (self.height_ratio.powi(level as i32) - last) / (1.0 - last)
    }

    /// Into how many rows along x and along z the forks of each level part the tips behind them: as square as the number of branches allows, with more
    /// rows along the side that has been parted less, and along x where that is equal.
    fn rows(&self) -> Vec<[usize; 2]> {
        let mut parted = [1, 1];
        let of = |level| {
            let branches: usize = self.branches_at(level);
            let few = (1..=branches)
                .take_while(|few| few * few <= branches)
                .filter(|few| branches.is_multiple_of(*few))
                .last();
            let few = few.unwrap_or(1);
            let own = if parted[0] <= parted[1] { [branches / few, few] } else { [few, branches / few] };
            parted = [parted[0] * own[0], parted[1] * own[1]];
            own
        };
        (0..self.levels()).map(of).collect()
    }

    /// x and z of the centroid of the tips behind a joint, nm.
    fn centroid(&self, level: usize, index: usize) -> [f64; 2] {
        let rows = self.rows();
        let (mut place, mut index) = ([0.0; 2], index);
        let mut branch = vec![0; level];
        for k in (0..level).rev() {
            (branch[k], index) = (index % self.branches_at(k), index / self.branches_at(k));
        }
        for k in 0..level {
            let [along, across] = rows[k];
            for (axis, own, count) in [(0, branch[k] % along, along), (1, branch[k] / along, across)] {
                let behind: usize = rows[k + 1..].iter().map(|rows| rows[axis]).product();
                place[axis] += (own as f64 - 0.5 * (count - 1) as f64) * (self.tip_pitch * behind as f64);
            }
        }
        place
    }

    /// Area (nm²) and second moment of area (nm⁴) of the branch that ends at a joint.
    fn round_section(&self, joint: usize) -> (f64, f64) {
        let diameter = self.branch_diameter(joint);
        (PI * diameter.powi(2) / 4.0, PI * diameter.powi(4) / 64.0)
    }

    /// Of the branch that ends at a joint.
    fn stiffness(&self, joint: usize) -> SpatialStiffness {
        let (area, second) = self.round_section(joint);
        SpatialStiffness::isotropic(&self.material, area, [second; 2], 2.0 * second)
    }

    /// ρA, and ρJ about the axis, the width and the height, of a branch of the tree, by its number; ρ in 1e-18 kg/nm³.
    pub(crate) fn section_inertia(&self, branch: usize, density: f64) -> [f64; 4] {
        let (area, second) = self.round_section(branch + 1);
        [area, 2.0 * second, second, second].map(|of| density * of)
    }

    /// The branch that ends at a joint, stress-free, with so many elements.
    fn branch(&self, joint: usize, elements: usize) -> Branch {
        let parent = self.parent(joint);
        let ends = [parent, joint].map(|end| self.joint_place(end));
        let axis: [f64; 3] = std::array::from_fn(|i| ends[1][i] - ends[0][i]);
        // only a tree that is given whole has branches that are nearly across all others
        let is_across = axis[2].abs() > ACROSS * axis[0].hypot(axis[1]);
        let width = if is_across { [1.0, 0.0, 0.0] } else { SIDEWAYS };
        Branch::straight([parent, joint], ends, width, self.stiffness(joint), elements)
    }

    /// Directors of the branch that ends at a joint, in the stress-free configuration; of the root those of the shaft.
    pub(crate) fn directors(&self, joint: usize) -> Quaternion {
        self.branch(joint.max(1), 1).rest.at(0.0).1
    }

    /// The tree of beams, with the root at joint 0 and without conditions at its tips. Branch b ends at joint b + 1.
    ///
    /// # Errors
    /// What of it is out of range; a mesh with another number of generations.
    pub fn tree(&self, mesh: &SetaMesh) -> Result<BranchingBeam, SetaError> {
        self.check()?;
        self.check_mesh(mesh)?;
        let of_joint = |joint: usize| self.branch(joint, mesh.elements[self.generation(joint)]);
        let branches = (1..self.joints()).map(of_joint).collect();
        Ok(BranchingBeam { order: mesh.order, scale: SCALE, ..BranchingBeam::new(branches, 0) })
    }
}
