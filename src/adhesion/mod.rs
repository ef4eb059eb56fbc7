//! What pulls: pair potential, half space, traction, line load.
mod half_space;
mod line_load;
pub use half_space::HalfSpace;
pub use line_load::{LineLaw, LineLoad, LineResponse};
