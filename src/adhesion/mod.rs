//! Adhesion model and friction: pair potential, half space, traction, line load, friction, ground.
//!
//! From atoms to beams in the order of the paper: `levels/` up to the [`HalfSpace`] (eqs. 1-10 and 18), `section/` with the adhesion of a
//! section of a beam, [`Law`] and [`LineLaw`] (17-22); [`Piece`] evaluates one and the same body at every level. `friction/` has what resists
//! sliding, `substrate/` the shape of the ground, and [`GroundLaw`] is a line law on it.

mod friction;
mod levels;
mod piece;
mod section;
mod substrate;
pub use friction::{FrictionLaw, Slip, Traction};
pub use levels::{
    Cuboid, CurvedBody, HalfSpace, LatticeHalfSpace, LennardJones, Place, Rule, Shape, body_force_by_volume,
    cubic_block, double_integral, pair_sum,
};
pub use piece::{Faces, Level, Piece, Resultant, section_by_body_force};
pub use section::{
    Attraction, Cohesive, CohesiveShape, Law, LineLaw, LineLoad, LineResponse, OwnLaw, SectionLaw, TiltedSection,
};
pub use substrate::*;
