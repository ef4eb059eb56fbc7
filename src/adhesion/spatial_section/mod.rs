//! The adhesion of a section of a beam in space, tilted along the beam and across it: one shape or law a file, and [`SpatialSection`].

mod axis_gap;
mod ellipse;
mod error;
mod even_power;
mod face;
mod near_face;
mod rectangle;
mod response;
mod section;
mod width_average;
pub use error::SpatialSectionError;
pub use response::SpatialSectionResponse;
pub use section::{SectionShape, SpatialSection};
