//! The adhesion model of a section: one law a file, and [`Law`], which answers everything about itself.
//!
//! A law of the half space is a file here. A cohesive law is a file in `cohesive/` and a line of its list. A law of the user's own is a
//! [`SectionLaw`]. [`LineLaw`] is a law with the height of a section and with what of it reaches the axis.

mod barrier;
mod body_force;
mod cohesive;
mod coverage;
mod law;
mod line_load;
mod own;
mod response;
mod surface_traction;
mod written;
pub use barrier::Barrier;
pub(super) use cohesive::Part;
pub use cohesive::{Cohesive, CohesiveShape};
pub use coverage::TiltCount;
pub use law::{Attraction, Law};
pub use line_load::{LineLaw, LineLoad};
pub use own::{OwnLaw, SectionLaw, TiltedSection};
pub use response::LineResponse;
