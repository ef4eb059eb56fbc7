//! A spatula as a solid in space: half of it, on one side of its plane of symmetry.
//!
//! Elements are cubic along S, with the slope by S as an unknown (Hermite), and quadratic through the thickness and across the half width.
//! The ground acts on the underside. A beam has sections that stay plane; here they may warp, bend across the width and thin.

mod element;
mod end_face;
mod fields;
pub(crate) mod geometry;
mod ground;
mod layout;
mod material;
pub(crate) mod solid_spatula;
mod start;
mod system;
pub use solid_spatula::{SolidSpatula, SpatulaMesh};
