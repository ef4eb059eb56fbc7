//! Trees of beams in space: joined rigidly where they meet, branching as they like, eliminated from the tips to the root.
//!
//! A joint is one node, with a place r and directors q. A branch that begins or ends there has the directors q ∘ a with a quaternion a that
//! never changes, the angle of the branch, so that its end turns by Rᵀ(a) φ where the joint turns by φ. In a tree every joint but the root has
//! one branch that leads to the root. So the tangent is eliminated without fill-in: the interior nodes of each element, then the nodes of each
//! branch from the tips on, and each joint behind the branches that it carries. What is left is the block of the root. Time and room grow in
//! proportion to the number of elements. The signs of the pivots are those of the eigenvalues.
//!
//! Source of the order of elimination: S. Parter, The use of linear graphs in Gauss elimination, SIAM Rev. 3 (1961).

pub(crate) mod beam_tree;
pub(crate) mod branching_beam;
pub(crate) mod build;
pub(crate) mod factors;
mod inside;
mod joints;
mod moving_mesh;
pub(crate) mod read;
pub(crate) mod sweep;
mod topology;
mod tree_inertia;
mod tree_system;
