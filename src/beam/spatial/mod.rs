//! The beam in space of Simo and Reissner: strains, elements, chains of them, and the system that they make.
mod above_ground;
pub(crate) mod chain;
pub(crate) mod density;
pub(crate) mod end_rotation;
pub(crate) mod kinematics;
mod local_adhesion;
pub(crate) mod rest;
pub mod rotation;
pub(crate) mod section_state;
mod shared_system;
pub(crate) mod spatial_beam;
pub(crate) mod spatial_grip;
pub(super) mod spatial_motion;
pub(crate) mod spatial_profile;
mod spatial_system;
pub(super) mod strain_memory;
pub(crate) mod tree;
