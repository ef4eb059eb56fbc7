//! A run of a scene, and what the page gets of it.

pub(crate) mod answer;
pub(crate) mod controls;
pub(crate) mod curve;
pub(crate) mod files;
pub(crate) mod poses;
pub(crate) mod runs;
