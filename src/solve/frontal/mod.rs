//! The elimination of chains and trees of elements, front by front, that knows nothing of beams.
//!
//! An element has nodes with F unknowns each. Only its two end nodes are shared, and every joint but the root has one element that leads to the
//! root. So nothing fills in: the interior nodes of four elements are eliminated side by side, then the ends of the elements one after the
//! other, each behind those that it carries. What is left is the block of the root. Time and room grow in proportion to the number of elements.
//! The last row of a front carries a functional along, and the last column the residual. The signs of the pivots are those of the eigenvalues
//! (Sylvester), so the elimination counts the negative ones.
//!
//! Source of the order of elimination: S. Parter, The use of linear graphs in Gauss elimination, SIAM Rev. 3 (1961).

pub(crate) mod back;
pub(crate) mod eliminate;
pub(crate) mod end_block;
pub(crate) mod forest;
pub(crate) mod frontal_matrix;
pub(crate) mod grip_block;
pub(crate) mod interior;
pub(crate) mod nodes;
#[cfg(test)]
mod tests;
