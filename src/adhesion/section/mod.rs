//! The adhesion model of a section: one law a file, and [`Law`], which answers everything about itself.
//!
//! A law of the half space is a file here. A cohesive law is a file in `cohesive/` and a line of its list. A law of the user's own is a
//! [`SectionLaw`]. [`LineLaw`] is a law with the height of a section and with what of it reaches the axis.

pub(crate) mod barrier;
mod body_force;
pub(crate) mod calibrated;
pub(crate) mod cohesive;
pub(crate) mod coverage;
pub(crate) mod law;
pub(crate) mod line_load;
pub(super) mod own;
pub(crate) mod response;
pub(crate) mod sheared;
mod surface_traction;
mod written;
