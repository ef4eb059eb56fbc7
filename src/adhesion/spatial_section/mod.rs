//! The adhesion of a section of a beam in space, tilted along the beam and across it: one shape or law a file, and
//! [`SpatialSection`].

mod adaptive_mean;
mod axis_gap;
mod cohesive_face;
mod ellipse;
pub(crate) mod error;
mod even_power;
pub(crate) mod held_face;
mod near_face;
mod own_face;
mod rectangle;
pub(crate) mod response;
pub(crate) mod section;
