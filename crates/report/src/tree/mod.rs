//! A tree of beams as it lies: what pictures, the animation and the files for ParaView are made of.

mod shape;
mod vtk;

pub use shape::{BranchShape, TreeState};
pub use vtk::{TREE_FIELDS, TreeField, write_tree_states};
