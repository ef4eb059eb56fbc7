//! The energy densities of planar beams, with and without adhesion: what an element integrates.
pub(crate) mod on_ground;
pub(crate) mod reduced;
pub(crate) mod reissner;
pub(crate) mod sheared;
pub(crate) mod viscous;
pub(crate) mod yielding_film;
