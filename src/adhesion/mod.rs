//! Adhesion model and friction: pair potential, half space, traction, line load, friction, ground.
//!
//! From atoms to beams in the order of the paper: `levels/` up to the [`HalfSpace`] (eqs. 1-10 and 18), `section/` with the adhesion of a
//! section of a beam, [`Law`] and [`LineLaw`] (17-22); [`TiltedBlock`] evaluates one and the same body at every level.
//! `spatial_section/` has that of a section of a beam in space, `friction/` what resists sliding, `substrate/` the
//! shape of the ground, and [`GroundLaw`] is a line law on it.

pub(crate) mod friction;
pub(crate) mod levels;
pub(crate) mod section;
pub(crate) mod spatial_section;
pub(crate) mod substrate;
pub(crate) mod substrate_response;
mod tilted_block;
pub use crate::number::gauss::Rule;
pub use friction::dahl::{FrictionLaw, Traction};
pub use levels::curved::{BodyShape, CurvedBody};
pub use levels::half_space::HalfSpace;
pub use levels::lattice::{LatticeHalfSpace, cubic_block, pair_sum};
pub use levels::pair::LennardJones;
pub use levels::volume::{Cuboid, body_force_by_volume, double_integral};
pub use section::barrier::Barrier;
pub use section::calibrated::Cohesive;
pub use section::cohesive::CohesiveShape;
pub use section::cohesive::opening_rate::OpeningRate;
pub use section::cohesive::tabulated::{Measured, TractionTable, TractionTableError};
pub use section::coverage::TiltCount;
pub use section::law::{Attraction, Law};
pub use section::line_load::{LineLaw, LineLoad};
pub use section::own::{OwnLaw, SectionLaw, TiltedSection};
pub use section::response::LineResponse;
pub use spatial_section::error::SpatialSectionError;
pub use spatial_section::response::SpatialSectionResponse;
pub use spatial_section::section::{SectionShape, SpatialSection};
pub use substrate::Substrate;
pub use substrate::heights::{Heights, HeightsError};
pub use substrate::ridge::Ridge;
pub use substrate::round::Round;
pub use substrate::self_affine::SelfAffine;
pub use substrate::sinusoid::Sinusoid;
pub use substrate::surface::{ClosestPoint, Misfit, Surface};
pub use substrate_response::{GroundLaw, GroundResponse};
pub use tilted_block::{Faces, Level, Resultant, TiltedBlock, section_by_body_force};
