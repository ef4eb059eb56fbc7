//! The beam at chosen points of its path: fields along S, for tables and pictures.

mod along_beam;
mod along_path;
mod beam_state;
mod in_space;

pub use along_beam::SectionFields;
pub use beam_state::{BeamState, StateSections};
pub use in_space::SpatialSectionFields;
