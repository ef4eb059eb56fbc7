//! Adhesion model and friction: pair potential, half space, traction, line load, friction, ground.
//!
//! From atoms to beams in the order of the paper: `levels/` up to the [`HalfSpace`] (eqs. 1-10 and 18), `section/` with the adhesion of a
//! section of a beam, [`Law`] and [`LineLaw`] (17-22); [`TiltedBlock`] evaluates one and the same body at every level.
//! `spatial_section/` has that of a section of a beam in space, `friction/` what resists sliding, `substrate/` the
//! shape of the ground, and [`GroundLaw`] is a line law on it.

mod friction;
mod levels;
mod section;
mod spatial_section;
mod substrate;
mod tilted_block;
pub use friction::{FrictionLaw, FrictionState, Traction};
pub use levels::{
    BodyShape, Cuboid, CurvedBody, HalfSpace, LatticeHalfSpace, LatticeSite, LennardJones, Rule, body_force_by_volume,
    cubic_block, double_integral, pair_sum,
};
pub use section::{
    Attraction, Barrier, Cohesive, CohesiveShape, Law, LineLaw, LineLoad, LineResponse, OwnLaw, SectionLaw, TiltCount,
    TiltedSection,
};
pub use spatial_section::{SectionShape, SpatialSection, SpatialSectionError, SpatialSectionResponse};
pub use substrate::*;
pub use tilted_block::{Faces, Level, Resultant, TiltedBlock, section_by_body_force};
