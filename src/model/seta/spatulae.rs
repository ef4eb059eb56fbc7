//! A seta whose spatulae are beams that adhere: one tree, from the root to the free end of every pad.
//!
//! Joints 0 to n - 1 and the branches between them are those of the seta, raised by the height at which the end of a spatula's shaft stands when it
//! rests on the ground; joint n + i is the free end of the spatula of tip i, and the branch that ends there comes behind those of the seta. The pads
//! point along -x, as those of tips that follow a table.

use super::check::SetaError;
use super::parameters::{Seta, SetaMesh};
use crate::beam::spatial::rest::{BranchRest, PlacedRest, SpatialRestCurve};
use crate::beam::spatial::rotation::Quaternion;
use crate::beam::spatial::section::branch_sections::BranchSections;
use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::beam::spatial::tree::branching_beam::{Branch, BranchMesh, JointCondition};
use crate::model::problem::branch::BodyBranch;
use crate::solve::state::State;
use crate::solve::system::System;
use std::sync::Arc;

/// No turn
const AS_IT_IS: Quaternion = [1.0, 0.0, 0.0, 0.0];

/// Scales of an error away from the ground: of a place, nm, and of a turn, rad. A spatula that lets go moves by hundreds of nm.
const SCALE: [f64; 2] = [100.0, 0.3];

/// A seta with its spatulae.
#[derive(Clone, Debug)]
pub struct SetaOfBeams {
    /// Geometry and material
    pub seta: Seta,
    /// Elements of its branches; their order is that of the spatulae too
    pub mesh: SetaMesh,
    /// Of every tip
    pub spatula: BodyBranch,
    /// Elements of a spatula
    pub elements: usize,
}

impl SetaOfBeams {
    /// Height at which the end of the shaft of a spatula stands that rests on the ground, nm.
    pub(crate) fn foot(&self) -> f64 {
        let ([_, height, _], _) = self.spatula.rest.at(self.spatula.length);
        height
    }

    /// How near to the ground a spatula adheres, nm.
    pub(crate) fn reach(&self) -> f64 {
        self.spatula.sections.law.law().adhering_distance()
    }

    /// Half of the height of the section in the middle of a spatula, nm.
    pub(crate) fn half_height(&self) -> f64 {
        let [_, height] = self.spatula.sections.profile.outline(0.5 * self.spatula.length);
        0.5 * height
    }

    /// Number of the branch that is the spatula of a tip.
    pub(crate) fn spatula_of(&self, tip: usize) -> usize {
        self.seta.joints() - 1 + tip
    }

    /// The tree, with the root at joint 0.
    ///
    /// # Errors
    /// What of the seta is out of range; a mesh with another number of generations.
    pub fn tree(&self) -> Result<BeamTree, SetaError> {
        let mut beam = self.seta.tree(&self.mesh)?;
        let foot = self.foot();
        for branch in &mut beam.branches {
            if let BranchRest::Curve(SpatialRestCurve { start, .. }) = &mut branch.rest {
                start[1] += foot;
            }
        }
        let joints = self.seta.joints();
        beam.branches.extend((0..self.seta.tips()).map(|tip| self.branch(joints, tip)));
        beam.conditions = vec![JointCondition::free(0)];
        beam.scale = SCALE;
        Ok(beam.build()?)
    }

    /// The spatula of a tip, stress-free.
    fn branch(&self, joints: usize, tip: usize) -> Branch {
        let BodyBranch { sections, rest, length, mesh } = &self.spatula;
        let joint = self.seta.tip_joint(tip);
        let ([along, _, aside], _) = rest.at(*length);
        let [x, y, z] = self.seta.joint_place(joint);
        let placed = PlacedRest { rest: Arc::clone(rest), turn: AS_IT_IS, origin: [x - along, y, z - aside] };
        Branch {
            joints: [joints + tip, joint],
            rest: BranchRest::Placed(placed),
            length: *length,
            sections: BranchSections::Adhering(Arc::clone(sections)),
            mesh: BranchMesh::Following { policy: Arc::clone(mesh), elements: self.elements },
        }
    }

    /// Where every pad lies on the ground, with the branches of the seta straight: no equilibrium, but near to one.
    pub(crate) fn lying(&self, tree: &BeamTree) -> State {
        let (joints, rest) = (self.seta.joints(), tree.stress_free(0));
        // by how much each joint is lowered: tips and what is behind them by their scatter
        let lowered = |joint: usize| match joint.checked_sub(joints) {
            Some(tip) => self.seta.scatter(tip),
            None => self.seta.tip_at(joint).map_or(0.0, |tip| self.seta.scatter(tip)),
        };
        let down = |([x, y, z], turn): ([f64; 3], Quaternion), by: f64| ([x, y - by, z], turn);
        tree.laid_along(
            |joint| down(tree.joint(&rest, joint), lowered(joint)),
            |branch, place| {
                let at_rest = tree.rest_at(branch, place);
                let by = match (branch + 1).checked_sub(joints) {
                    Some(tip) => self.seta.scatter(tip),
                    None => lowered(branch + 1) * place / tree.length(branch),
                };
                down(at_rest, by)
            },
        )
    }
}
