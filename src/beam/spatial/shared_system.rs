//! What a chain and a tree of beams in space answer alike as a [`System`](crate::solve::System).

use super::chain::spatial_chain::{SpatialEnd, quaternion_of};
use super::end_rotation::{EndRotation, turn_on, turned};
use super::rotation::{apply, conjugate, logarithm, product};
use super::section::kinematics::SPATIAL_UNKNOWNS;

const F: usize = SPATIAL_UNKNOWNS;

/// Moves and turns a node by a step of its unknowns; of an end these are along its axes, and its angles, where it has some, are moved with it.
pub(crate) fn step_node(node: &mut [f64], step: [f64; F], end: Option<(&SpatialEnd, &mut [f64])>) {
    let (along, turn) = ([step[0], step[1], step[2]], [step[3], step[4], step[5]]);
    let moved = end.as_ref().map_or(along, |(own, _)| apply(&own.axes, &along));
    (0..3).for_each(|i| node[i] += moved[i]);
    let q = match end {
        Some((own, angles)) if own.rotation == EndRotation::Angles => {
            (0..3).for_each(|i| angles[i] += turn[i]);
            turned([angles[0], angles[1], angles[2]], own.rest)
        }
        _ => turn_on(quaternion_of(node), turn),
    };
    node[3..].copy_from_slice(&q);
}

/// From one node to another: the way, and the turn as a vector.
pub(crate) fn node_difference(from: &[f64], to: &[f64]) -> [f64; F] {
    let turn = logarithm(product(conjugate(quaternion_of(from)), quaternion_of(to)));
    std::array::from_fn(|i| if i < 3 { to[i] - from[i] } else { turn[i - 3] })
}
