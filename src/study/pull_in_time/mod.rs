//! A pull at a rate, followed in time: inertia, viscous material, and where the work goes.
pub(super) mod result;
pub(super) mod run;
pub(super) mod settings;
