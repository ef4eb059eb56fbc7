//! A chain of elements of a beam in space, eliminated front by front down to its right end.
//!
//! As in the planar chain: the interior nodes of four elements are eliminated side by side, then the ends of the elements from left to
//! right. The last row of a front carries the path functional and the last column the residual. The sign of a pivot is the sign of an
//! eigenvalue, so the sweep counts the negative ones.

pub(super) mod assembly;
mod back;
pub(super) mod end_block;
mod factors;
pub(in crate::beam::spatial) mod fields_along;
pub(crate) mod projection;
pub mod read;
pub(crate) mod spatial_chain;
pub(super) mod sweep;
