//! From molecules to the half space: what the paper derives one from the other, eqs. (1)-(10) and (18).
//!
//! [`LennardJones`] and [`pair_sum`] (eqs. 1, 2), [`double_integral`] (3-7), [`HalfSpace`] (9, 10, 18); a [`CurvedBody`] is what the half space
//! stands for. Nothing here knows of a beam.

mod curved;
mod half_space;
mod lattice;
mod pair;
mod volume;
pub use crate::number::gauss::Rule;
pub use curved::{BodyShape, CurvedBody};
pub use half_space::HalfSpace;
pub use lattice::{LatticeHalfSpace, LatticeSite, cubic_block, pair_sum};
pub use pair::LennardJones;
pub use volume::{Cuboid, body_force_by_volume, double_integral};
