//! A tree of beams as plain data, with the energy of the place and the rotation of a joint (what adheres a tip, for one), and why such a tree
//! cannot be computed.

use crate::beam::mesh::MeshPolicy;
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rest::{BranchRest, SpatialRestCurve};
use crate::beam::spatial::rotation::{Matrix3, Quaternion};
use crate::beam::spatial::section::branch_sections::BranchSections;
use crate::beam::spatial::section::kinematics::SPATIAL_UNKNOWNS;
use crate::beam::spatial::section::spatial_profile::SpatialStiffness;
use crate::solve::state::MONITORS;
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use std::fmt::Debug;
use std::sync::Arc;

/// A beam between two joints.
///
/// Its stress-free curve says where the two joints are, and its directors there at what angle it is joined.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Numbers of the joints at S = 0 and at S = `length`; either may be nearer to the root.
    pub joints: [usize; 2],
    /// The stress-free axis and directors, from S = 0 on
    pub rest: BranchRest,
    /// nm
    pub length: f64,
    /// What bends, and whether it adheres
    pub sections: BranchSections,
    /// Where its elements end
    pub mesh: BranchMesh,
}

/// Where the elements of a branch end.
#[derive(Clone, Debug)]
pub enum BranchMesh {
    /// At these S, nm: from 0 to the length, ascending
    Fixed(Vec<f64>),
    /// So many, which follow the peeling front and the edges of a branch that adheres
    Following {
        /// How they are laid out
        policy: Arc<MeshPolicy>,
        /// How many there are
        elements: usize,
    },
}

impl BranchMesh {
    /// Elements of equal length.
    pub fn even(length: f64, elements: usize) -> Self {
        Self::Fixed((0..=elements).map(|k| length * k as f64 / elements as f64).collect())
    }

    /// How many there are.
    pub fn elements(&self) -> usize {
        match self {
            Self::Fixed(ends) => ends.len().saturating_sub(1),
            Self::Following { policy, elements } => policy.pieces.count().max(*elements),
        }
    }

    /// Whether elements of two branches may be computed side by side: as many; how long they are is that of each.
    pub(super) fn is_alike(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Fixed(one), Self::Fixed(other)) => one.len() == other.len(),
            (Self::Following { policy: one, elements }, Self::Following { policy, elements: others }) => {
                Arc::ptr_eq(one, policy) && elements == others
            }
            _ => false,
        }
    }
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

/// What measures a path of a tree beside its displacement and its force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TreeMonitor {
    /// An unknown of a joint
    Joint(JointUnknown),
    /// The length that adheres, of all branches, nm: the sum of their fronts
    AdheringLength,
    /// The mean place along z of what lets go, nm: of the joints at which a branch that adheres ends freely
    PadsAside,
}

impl From<JointUnknown> for TreeMonitor {
    fn from(unknown: JointUnknown) -> Self {
        Self::Joint(unknown)
    }
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
    pub monitors: [Option<TreeMonitor>; MONITORS],
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
        let rest = BranchRest::Curve(SpatialRestCurve { start: from, directors: [w, x, y, z], curvature: [0.0; 3] });
        let length = axis.norm();
        let mesh = BranchMesh::even(length, elements);
        Self { joints, rest, length, sections: BranchSections::Uniform(Box::new(stiffness)), mesh }
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

/// Why a tree of beams cannot be computed. Branches and joints are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum TreeError {
    /// There is no branch.
    #[error("a tree of beams without a branch: give at least one")]
    Empty,
    /// Elements of this order do not exist.
    #[error("elements of order {order}: orders are 1 to 8")]
    Order { order: usize },
    /// A length or a number of elements of a branch.
    #[error("branch {branch} is {length} nm long and has {elements} elements: both have to be positive")]
    Length { branch: usize, length: f64, elements: usize },
    /// Ends of elements that do not ascend from one end of the branch to the other.
    #[error(
        "the elements of branch {branch} end at S = {ends:?} nm: from 0 to its length, {length} nm, they have to ascend"
    )]
    Ends { branch: usize, length: f64, ends: Vec<f64> },
    /// A mesh that follows a front that is not there.
    #[error("the elements of branch {branch} follow a peeling front, and nothing adheres along it: give a fixed mesh")]
    NoFront { branch: usize },
    /// A stiffness that is not positive definite, or a number that is not finite.
    #[error(
        "branch {branch}: the stiffness is not symmetric and positive definite, or a number of its rest curve is not finite: all of EA, GA, GJ and EI have to be positive"
    )]
    Stiffness { branch: usize },
    /// A branch from a joint to itself.
    #[error("branch {branch} begins and ends at joint {joint}: a ring is no tree; give it two joints")]
    Ring { branch: usize, joint: usize },
    /// A joint with a number that is too large.
    #[error("branch {branch} meets joint {joint}: a tree of {branches} branches has the joints 0 to {branches}")]
    Number { branch: usize, joint: usize, branches: usize },
    /// The root is at no branch.
    #[error("the root is joint {root}, where no branch begins or ends: choose a joint of a branch")]
    Root { root: usize },
    /// Two ways to a joint.
    #[error(
        "branches {first} and {second} close a loop at joint {joint}: a tree has one way from every joint to the root; take one of the two away"
    )]
    Loop { first: usize, second: usize, joint: usize },
    /// A part that hangs on nothing.
    #[error("branch {branch} between joints {first} and {last} does not hang together with the root, joint {root}")]
    Apart { branch: usize, first: usize, last: usize, root: usize },
    /// Branches that do not meet where they are joined.
    #[error(
        "branches {first} and {second} are joined at joint {joint} and lie {distance:.3e} nm apart there: let their rest curves meet"
    )]
    Gap { first: usize, second: usize, joint: usize, distance: f64 },
    /// A condition on a joint that is not there, or a second one.
    #[error("joint {joint} has {count} conditions, of joints 0 to {last}: a joint that is there has at most one")]
    Condition { joint: usize, count: usize, last: usize },
    /// What is held of a joint that is no tip.
    #[error(
        "joint {joint}, where {branches} branches meet, is held: only tips can be held by a condition; what is held of the root, the grip says"
    )]
    Held { joint: usize, branches: usize },
    /// A rotation that is held and has no angles, or axes that are none.
    #[error("joint {joint}: {problem}")]
    Axes { joint: usize, problem: &'static str },
    /// A monitor of what is not there.
    #[error(
        "the monitor of unknown {slot} of joint {joint}: unknowns are 0 to 5, the last three of a joint with angles"
    )]
    Monitor { joint: usize, slot: usize },
    /// A scale that is not positive.
    #[error("the scales of an error are {place} nm and {turn} rad: both have to be positive")]
    Scale { place: f64, turn: f64 },
}

/// An energy at a joint with its derivatives.
///
/// By δ, a change of the place along x, y and z (nm), and φ, a turn in the axes of the directors (rad): of E(r + δ, q ∘ exp(φ)), where exp(φ)
/// turns by |φ| about φ, at δ = φ = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndResponse {
    /// E, aJ
    pub energy: f64,
    /// ∂E/∂(δ, φ): nN and nN·nm
    pub gradient: [f64; 6],
    /// ∂²E/∂(δ, φ)², symmetric: nN/nm, nN, nN·nm
    pub hessian: [[f64; 6]; 6],
}

/// An energy of the place and the rotation of a joint.
pub trait EndEnergy: Send + Sync + Debug {
    /// The energy at a place (nm) and with directors q, of length one.
    fn response(&self, place: [f64; 3], directors: Quaternion) -> EndResponse;
}
