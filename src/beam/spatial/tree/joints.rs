//! What a joint adds of its own, and how the ends of branches move with it.

use super::beam_tree::{BeamTree, TreeBranch, TreeEnd};
use super::branching_beam::EndResponse;
use crate::beam::spatial::chain::projection::{EndMaps, SAME, SpatialFront};
use crate::beam::spatial::chain::spatial_chain::quaternion_of;
use crate::beam::spatial::end_rotation::EndMap;
use crate::beam::spatial::rotation::{Matrix3, Quaternion, apply, apply_transposed, dot, matrix, multiply_transposed};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::solve::frontal::nodes::{Nodes, slot};

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

/// Energy, gradient and second derivatives by the unknowns of a joint of what is done to it; a moment of a dead load has no energy.
#[derive(Default)]
pub(super) struct Own {
    pub energy: f64,
    pub gradient: [f64; F],
    pub tangent: [[f64; F]; F],
}

impl BeamTree {
    /// From the unknowns of a joint to those of the end of a branch whose directors are turned by `offset`, and what bends them, for the
    /// gradient by the turn of that end. None where they are the same.
    pub(super) fn end_map(
        &self,
        values: &[f64],
        joint: usize,
        offset: Option<Quaternion>,
        gradient: [f64; 3],
    ) -> Option<(EndMap, Matrix3)> {
        let angle = offset.map(matrix);
        let gradient = angle.map_or(gradient, |angle| apply(&angle, &gradient));
        let mapped = self.end_of[joint].filter(|&end| !self.ends[end].own.is_node()).map(|end| {
            let own = &self.ends[end].own;
            own.rotation.map(own.axes, self.angles(values, end), quaternion_of(&values[joint * N..]), gradient)
        });
        let (map, bent) = match (mapped, angle) {
            (None, None) => return None,
            (mapped, _) => mapped.unwrap_or((EndMap { place: SAME, turn: SAME }, [[0.0; 3]; 3])),
        };
        let turn = angle.map_or(map.turn, |angle| multiply_transposed(&angle, &map.turn));
        Some((EndMap { turn, ..map }, bent))
    }

    /// From the unknowns of the last nodes of branches to those of their joints, where they are among four elements.
    #[inline(always)]
    pub(super) fn take_ends(
        &self,
        nodes: impl Nodes,
        values: &[f64],
        lanes: &[(&TreeBranch, usize)],
        front: &mut SpatialFront,
    ) {
        let count = nodes.count();
        for rank in [0, count - 1] {
            let (node, mut maps) = (slot(count, rank), None);
            for (l, &(branch, e)) in lanes.iter().enumerate() {
                let Some(end) = branch.end_at(count - 1, e, rank) else { continue };
                let gradient = std::array::from_fn(|f| front.rows[node][3 + f].residual.0[l]);
                if let Some((map, bent)) = self.end_map(values, branch.joints[end], branch.offsets[end], gradient) {
                    maps.get_or_insert_with(EndMaps::same).set(l, &map, &bent);
                }
            }
            if let Some(maps) = maps {
                maps.apply(nodes, node, true, front);
            }
        }
    }

    /// What is done to the joint of an end, by its unknowns.
    pub(super) fn own(&self, values: &[f64], end: usize) -> Own {
        let TreeEnd { joint, own: condition, energy, .. } = &self.ends[end];
        let node = &values[joint * N..(joint + 1) * N];
        let (place, q) = ([node[0], node[1], node[2]], quaternion_of(node));
        if let (Some(energy), true, true) = (energy, condition.is_node(), condition.dead_load == [[0.0; 3]; 2]) {
            let EndResponse { energy, gradient, hessian } = energy.response(place, q);
            return Own { energy, gradient, tangent: hessian };
        }
        let angles = self.angles(values, end);
        let map = |gradient| condition.rotation.map(condition.axes, angles, q, gradient);
        let mut out = Own::default();
        if let Some(energy) = energy {
            let response = energy.response(place, q);
            let [x, y, z, a, b, c] = response.gradient;
            let (map, bent) = map([a, b, c]);
            out.energy = response.energy;
            out.gradient = map.back(&[x, y, z, a, b, c]);
            let half = response.hessian.map(|row| map.back(&row));
            for j in 0..F {
                let column = map.back(&half.map(|row| row[j]));
                (0..F).for_each(|i| out.tangent[i][j] = column[i]);
            }
            add_turns(&mut out.tangent, &bent, 1.0);
        }
        let [force, moment] = condition.dead_load;
        if condition.dead_load != [[0.0; 3]; 2] {
            let along = apply_transposed(&matrix(q), &moment);
            let (map, _) = map([0.0; 3]);
            let load = map.back(&[force[0], force[1], force[2], along[0], along[1], along[2]]);
            out.energy -= dot(force, place);
            (0..F).for_each(|f| out.gradient[f] -= load[f]);
            add_turns(&mut out.tangent, &condition.rotation.moment_change(&map.turn, along), -1.0);
        }
        out
    }

    /// By how much what is held of an end is off.
    pub(super) fn off(&self, values: &[f64], end: usize) -> [Option<f64>; F] {
        let here = self.end_values(values, end);
        std::array::from_fn(|f| self.ends[end].held[f].map(|held| here[f] - held))
    }

    /// By how much what is held of a joint is off.
    pub(super) fn joint_off(&self, values: &[f64], joint: usize) -> [Option<f64>; F] {
        self.end_of[joint].map_or([None; F], |end| self.off(values, end))
    }
}

fn add_turns(tangent: &mut [[f64; F]; F], block: &Matrix3, factor: f64) {
    for i in 0..3 {
        for j in 0..3 {
            tangent[3 + i][3 + j] += factor * block[i][j];
        }
    }
}
