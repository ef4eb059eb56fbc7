//! The whole peel of one model: path, special points, error bounds, how it ended.
pub(super) mod along_path;
pub(super) mod assembly;
mod attempt;
pub(super) mod budget;
pub(super) mod contact;
pub(super) mod equilibrium_path;
pub(super) mod meshes;
pub(super) mod result;
pub(super) mod run;
pub(super) mod solution_history;
pub(super) mod step_dependence;
