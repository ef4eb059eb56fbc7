//! How thin adhesive beams peel from a surface.
//!
//! Units inside the library: nm and nN, hence 1 nN/nm² = 1 GPa, 1 nN/nm = 1 J/m², 1 nN·nm = 1 aJ.
//! The modules build on one another in this order; each knows only those above it.

#![forbid(unsafe_code)]
// sums over fields, nodes and points read as in the equations
#![allow(clippy::needless_range_loop)]

pub mod number;

pub mod adhesion;
pub mod analytic;
pub mod beam;
pub mod model;
pub mod solve;
pub mod study;
