//! The beam in space of Simo and Reissner: strains, elements, chains of them, and the system that they make.
mod above_ground;
pub(crate) mod chain;
pub(crate) mod end_rotation;
pub(crate) mod rest;
pub mod rotation;
pub(crate) mod section;
pub(crate) mod section_state;
mod shared_system;
pub(crate) mod spatial_beam;
pub(super) mod spatial_motion;
mod spatial_system;
pub(crate) mod tree;
