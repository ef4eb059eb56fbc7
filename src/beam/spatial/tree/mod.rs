//! Trees of beams in space: joined rigidly where they meet, branching as they like, eliminated from the tips to the root.
//!
//! A joint is one node, with a place r and directors q. A branch that begins or ends there has the directors q ∘ a with a quaternion a that
//! never changes, the angle of the branch, so that its end turns by Rᵀ(a) φ where the joint turns by φ. How such a tree is eliminated says
//! `solve::frontal`.

pub(crate) mod beam_tree;
pub(crate) mod branching_beam;
pub(crate) mod build;
mod joints;
mod moving_mesh;
pub(crate) mod read;
pub(crate) mod sweep;
mod topology;
mod tree_inertia;
mod tree_system;
