//! The beam in space of Simo and Reissner: strains, elements, chains of them, and the system that they make.
mod chain;
mod density;
mod edges;
mod end_rotation;
mod kinematics;
mod local_adhesion;
mod place_unit;
mod rest;
mod rest_curve;
pub mod rotation;
mod section_state;
mod shared_system;
mod spatial_beam;
mod spatial_grip;
mod spatial_motion;
mod spatial_profile;
mod spatial_system;
mod stiffness;
mod strain_memory;
mod tree;
pub use chain::{SPATIAL_UNKNOWNS, SpatialChain, SpatialConfiguration, SpatialEnd, SpatialFactors, SpatialFunctional};
pub use density::{SPATIAL_FIELDS, SpatialDensity};
pub use end_rotation::{EndRotation, angles, turned};
pub use rest::{RestOutline, SpatialRest};
pub use rest_curve::{ALONG_X, SpatialRestCurve};
pub use section_state::{SpatialIntegrals, SpatialSectionState};
pub use spatial_beam::SpatialBeam;
pub use spatial_grip::{GripReactions, SpatialSectionPlace};
pub use spatial_motion::SpatialInertia;
pub use spatial_profile::{SpatialProfile, Station};
pub use stiffness::SpatialStiffness;
pub use strain_memory::SpatialKnownStrains;
pub use tree::{
    BeamTree, Branch, BranchSection, BranchingBeam, CondensedTree, EndEnergy, EndResponse, JointCondition,
    JointUnknown, TreeError, TreeFactors,
};
