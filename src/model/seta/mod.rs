//! A seta as a tree of beams: a shaft that forks again and again, with a spatula at each tip that adheres by a law of its own.
pub(crate) mod check;
mod geometry;
pub(crate) mod normal_pull;
pub(crate) mod parameters;
pub(crate) mod spatulae;
pub(crate) mod tip_law;
pub(crate) mod whole_tree;
