//! A tree of beams as plain data.

use super::end_energy::EndEnergy;
use crate::beam::spatial::chain::projection::SPATIAL_UNKNOWNS;
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rest_curve::SpatialRestCurve;
use crate::beam::spatial::rotation::{Matrix3, Quaternion};
use crate::beam::spatial::stiffness::SpatialStiffness;
use crate::solve::observables::MONITORS;
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use std::sync::Arc;

/// A beam between two joints.
///
/// Its stress-free curve says where the two joints are, and its directors there at what angle it is joined.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Numbers of the joints at S = 0 and at S = `length`; either may be nearer to the root.
    pub joints: [usize; 2],
    /// The stress-free axis and directors, from S = 0 on
    pub rest: SpatialRestCurve,
    /// nm
    pub length: f64,
    /// The same all along
    pub stiffness: SpatialStiffness,
    /// How many, equally long
    pub elements: usize,
}

/// What is done to a joint.
#[derive(Clone, Debug)]
pub struct JointCondition {
    /// Its number
    pub joint: usize,
    /// Columns: the axes along which its place is counted and held.
    pub axes: Matrix3,
    /// How its rotation is counted: by three angles, from rest, of which each may be held, or freely
    pub rotation: EndRotation,
    /// What is held, and at what: the place along the axes (nm), and θ, yaw and roll (rad). Of a tip alone; what is held of the root, the grip
    /// says.
    pub held: [Option<f64>; SPATIAL_UNKNOWNS],
    /// Force (nN) and moment (nN·nm) that keep their directions in space, along and about x, y, z; the moment has no potential.
    pub dead_load: [[f64; 3]; 2],
    /// What depends on its place and its rotation
    pub energy: Option<Arc<dyn EndEnergy>>,
}

/// An unknown of a joint: its place along an axis (0 to 2, nm) or one of its angles θ, yaw and roll (3 to 5, rad).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointUnknown {
    /// Number of the joint
    pub joint: usize,
    /// From 0 to 5
    pub slot: usize,
}

/// A tree of beams.
#[derive(Clone, Debug)]
pub struct BranchingBeam {
    /// In any order
    pub branches: Vec<Branch>,
    /// The joint whose six unknowns are the interface: what a grip drives and holds. Its condition may be left out.
    pub root: usize,
    /// Of the root, of tips, of any joint at most one; a joint without one is free.
    pub conditions: Vec<JointCondition>,
    /// Order p of the elements, 1 to 8
    pub order: usize,
    /// What measures a path beside its displacement and its force
    pub monitors: [Option<JointUnknown>; MONITORS],
    /// Scales of an error: of a place (nm), and of a turn (rad)
    pub scale: [f64; 2],
}

impl Branch {
    /// A straight beam from one place to another, nm, whose width points along `width` as far as that is normal to the axis. The places should
    /// be those of the joints, and `width` not along the axis.
    pub fn straight(
        joints: [usize; 2],
        [from, to]: [[f64; 3]; 2],
        width: [f64; 3],
        stiffness: SpatialStiffness,
        elements: usize,
    ) -> Self {
        let axis = Vector3::from(to) - Vector3::from(from);
        let first = axis.normalize();
        let third = first.cross(&Vector3::from(width)).normalize();
        let directors = Rotation3::from_basis_unchecked(&[first, third.cross(&first), third]);
        let [x, y, z, w] = UnitQuaternion::from_rotation_matrix(&directors).coords.into();
        let rest = SpatialRestCurve { start: from, directors: [w, x, y, z], curvature: [0.0; 3] };
        Self { joints, rest, length: axis.norm(), stiffness, elements }
    }

    /// Place (nm) and directors at rest where it ends, at S = `length`: where the next branch begins.
    pub fn end(&self) -> ([f64; 3], Quaternion) {
        self.rest.at(self.length)
    }
}

/// The axes x, y and z.
const SPACE: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl JointCondition {
    /// Of a joint that is free and carries nothing; its place counts along x, y and z, its angles from rest.
    pub fn free(joint: usize) -> Self {
        Self {
            joint,
            axes: SPACE,
            rotation: EndRotation::Angles,
            held: [None; SPATIAL_UNKNOWNS],
            dead_load: [[0.0; 3]; 2],
            energy: None,
        }
    }

    /// Of a joint with a force (nN) and a moment (nN·nm) that keep their directions in space. It turns freely, by any angle.
    pub fn loaded(joint: usize, force: [f64; 3], moment: [f64; 3]) -> Self {
        Self { rotation: EndRotation::Free, dead_load: [force, moment], ..Self::free(joint) }
    }

    /// Of a joint with an energy. It turns freely, by any angle.
    pub fn with_energy(joint: usize, energy: Arc<dyn EndEnergy>) -> Self {
        Self { rotation: EndRotation::Free, energy: Some(energy), ..Self::free(joint) }
    }

    /// Of a tip that is held at a place (nm) and free to turn.
    pub fn pinned(joint: usize, place: [f64; 3]) -> Self {
        let [x, y, z] = place.map(Some);
        Self { held: [x, y, z, None, None, None], ..Self::free(joint) }
    }

    /// Of a tip that is held at a place (nm) with the rotation that it has at rest.
    pub fn clamped(joint: usize, place: [f64; 3]) -> Self {
        let [x, y, z] = place.map(Some);
        Self { held: [x, y, z, Some(0.0), Some(0.0), Some(0.0)], ..Self::free(joint) }
    }
}

impl BranchingBeam {
    /// Of branches, from a root, with elements of order 3 and scales of a thousandth of the longest branch and of a thousandth of a radian.
    pub fn new(branches: Vec<Branch>, root: usize) -> Self {
        let longest = branches.iter().map(|branch| branch.length).fold(0.0, f64::max);
        Self {
            branches,
            root,
            conditions: Vec::new(),
            order: 3,
            monitors: [None; MONITORS],
            scale: [1e-3 * longest, 1e-3],
        }
    }
}
