//! Deformed shapes: of beams in the plane, and of beams in space as they are seen.

pub(super) mod in_space;
pub(crate) mod posed;
mod projection;
