//! The section of a beam in space: stiffness, strains, energy density, and what it remembers.
pub(crate) mod branch_sections;
pub(crate) mod density;
pub(crate) mod held_sections;
pub(crate) mod kinematics;
pub(super) mod local_adhesion;
pub(crate) mod lying_section;
pub(crate) mod spatial_profile;
pub(crate) mod strain_memory;
