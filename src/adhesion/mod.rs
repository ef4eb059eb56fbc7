//! What pulls: pair potential, half space, traction, line load.
//!
//! From atoms to beams in the order of the paper: [`LennardJones`] and [`pair_sum`] (eqs. 1, 2), [`double_integral`] (3-7),
//! [`HalfSpace`] (9, 10, 18), [`LineLaw`] (17-22); [`Piece`] evaluates one and the same body at every level. A [`Law`] says
//! what pulls a section of a beam, [`Substrate`] is the shape of the ground and [`GroundLaw`] a line law on it.

mod body_force;
mod cohesive;
mod curved;
mod friction;
mod half_space;
mod lattice;
mod line_load;
mod pair;
mod piece;
mod rule;
mod substrate;
mod surface_traction;
mod volume;
pub use cohesive::{Cohesive, CohesiveShape};
pub use curved::{CurvedBody, Shape};
pub use friction::{FrictionLaw, Slip, Traction};
pub use half_space::HalfSpace;
pub use lattice::{LatticeHalfSpace, Place, cubic_block, pair_sum};
pub use line_load::{Law, LineLaw, LineLoad, LineResponse};
pub use pair::LennardJones;
pub use piece::{Faces, Level, Piece, Resultant, section_by_body_force};
pub use rule::Rule;
pub use substrate::{Foot, GroundLaw, GroundResponse, Heights, HeightsError, Round, SelfAffine, Sinusoid, Substrate};
pub use volume::{Cuboid, body_force_by_volume, double_integral};
