//! What pulls: pair potential, half space, traction, line load.
mod line_load;
pub use line_load::LineLoad;
