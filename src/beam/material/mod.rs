//! How the material of a beam answers to its strains.
pub(crate) mod stretch_law;
pub(crate) mod yielding;
