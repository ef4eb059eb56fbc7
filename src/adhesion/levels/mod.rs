//! From molecules to the half space: what the paper derives one from the other, eqs. (1)-(10) and (18).
//!
//! [`LennardJones`] and [`pair_sum`] (eqs. 1, 2), [`double_integral`] (3-7), [`HalfSpace`] (9, 10, 18); a [`CurvedBody`] is what the half space
//! stands for. Nothing here knows of a beam.

pub(crate) mod curved;
pub(crate) mod half_space;
pub(super) mod lattice;
pub(super) mod pair;
pub(super) mod volume;
