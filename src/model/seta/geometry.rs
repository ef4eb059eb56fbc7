//! Where the joints of a seta are, and the tree of beams between them.
//!
//! Every joint stands above the centroid of the tips behind it, moved by the lean of the brush. Joint 0 is the root; the branches that end at
//! joints 2ᵏ to 2ᵏ⁺¹ - 1 are those behind k forks, and the last of these joints are the tips.

use super::check::SetaError;
use super::parameters::{Seta, SetaMesh};
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::section::spatial_profile::SpatialStiffness;
use crate::beam::spatial::tree::branching_beam::{Branch, BranchingBeam};
use std::f64::consts::PI;

/// Of the golden section: fractions of its multiples are spread evenly.
const GOLDEN: f64 = 0.618034;
/// Scales of an error: of a place, nm, and of a turn, rad.
const SCALE: [f64; 2] = [10.0, 1e-2];
/// Across all branches, in the ground
const SIDEWAYS: [f64; 3] = [0.0, 0.0, 1.0];

impl Seta {
    /// Number of tips.
    pub fn tips(&self) -> usize {
        1 << self.forks
    }

    /// Joint of a tip.
    pub fn tip_joint(&self, tip: usize) -> usize {
        self.tips() + tip
    }

    /// Where a joint is in the stress-free configuration, nm.
    pub fn joint_place(&self, joint: usize) -> [f64; 3] {
        if joint == 0 {
            let [x, y, z] = self.joint_place(1);
            let (sin, cos) = self.shaft_angle.sin_cos();
            return [x + self.shaft_length * sin, y + self.shaft_length * cos, z];
        }
        let generation = joint.ilog2() as usize;
        let height = self.height(generation);
        let [x, z] = self.centroid(joint, generation);
        let scatter = if generation == self.forks { self.scatter(joint - self.tips()) } else { 0.0 };
        [x + height * self.brush_angle.tan(), height + scatter, z]
    }

    /// By how much a tip stands too high in the stress-free configuration, nm.
    pub fn scatter(&self, tip: usize) -> f64 {
        self.height_scatter * (2.0 * (GOLDEN * tip as f64).fract() - 1.0)
    }

    /// Height of the forks of a generation above the plane of the tips, nm.
    fn height(&self, generation: usize) -> f64 {
        if generation == self.forks {
            return 0.0;
        }
        let last = self.height_ratio.powi(self.forks as i32);
        self.brush_height * (self.height_ratio.powi(generation as i32) - last) / (1.0 - last)
    }

    /// x and z of the centroid of the tips behind a joint, nm: it parts in x at the first fork, in z at the second one.
    fn centroid(&self, joint: usize, generation: usize) -> [f64; 2] {
        let parts = [self.forks.div_ceil(2), self.forks / 2];
        let mut place = [0.0; 2];
        for fork in 0..generation {
            let (axis, before) = (fork % 2, fork / 2);
            let side = if joint >> (generation - 1 - fork) & 1 == 1 { 1.0 } else { -1.0 };
            place[axis] += side * self.tip_pitch * 2f64.powi((parts[axis] - before) as i32 - 2);
        }
        place
    }

    /// Diameter of a branch behind so many forks, nm.
    pub fn diameter(&self, generation: usize) -> f64 {
        self.shaft_diameter * self.diameter_ratio.powi(generation as i32)
    }

    /// Of a branch behind so many forks.
    fn stiffness(&self, generation: usize) -> SpatialStiffness {
        let diameter = self.diameter(generation);
        let (area, second) = (PI * diameter.powi(2) / 4.0, PI * diameter.powi(4) / 64.0);
        SpatialStiffness::isotropic(&self.material, area, [second; 2], 2.0 * second)
    }

    /// ρA, and ρJ about the axis, the width and the height, of a branch of the tree, by its number; ρ in 1e-18 kg/nm³.
    pub fn section_inertia(&self, branch: usize, density: f64) -> [f64; 4] {
        let diameter = self.diameter((branch + 1).ilog2() as usize);
        let (area, second) = (PI * diameter.powi(2) / 4.0, PI * diameter.powi(4) / 64.0);
        [area, 2.0 * second, second, second].map(|of| density * of)
    }

    /// The branch that ends at a joint, stress-free, with elements by its generation.
    fn branch(&self, joint: usize, elements: &[usize]) -> Branch {
        let (parent, generation) = (joint / 2, joint.ilog2() as usize);
        let ends = [parent, joint].map(|end| self.joint_place(end));
        Branch::straight([parent, joint], ends, SIDEWAYS, self.stiffness(generation), elements[generation])
    }

    /// Directors of the branch that ends at a joint, in the stress-free configuration; of the root those of the shaft.
    pub fn directors(&self, joint: usize) -> Quaternion {
        self.branch(joint.max(1), &vec![1; self.forks + 1]).rest.directors
    }

    /// The tree of beams, with the root at joint 0 and without conditions at its tips. Branch b ends at joint b + 1.
    ///
    /// # Errors
    /// What of it is out of range; a mesh with another number of generations.
    pub fn tree(&self, mesh: &SetaMesh) -> Result<BranchingBeam, SetaError> {
        self.check()?;
        self.check_mesh(mesh)?;
        let branches = (1..2 * self.tips()).map(|joint| self.branch(joint, &mesh.elements)).collect();
        Ok(BranchingBeam { order: mesh.order, scale: SCALE, ..BranchingBeam::new(branches, 0) })
    }
}
