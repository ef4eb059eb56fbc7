//! Strips in space, and what their grip does there.

pub(super) mod grip;
pub(super) mod held;
pub(super) mod strips;
