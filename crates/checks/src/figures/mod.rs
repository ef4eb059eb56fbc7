//! The figures of `figures/`: computed, drawn, and written with the data and a caption beside each.

mod draw;
mod figure;
mod numerics;
mod peeling;
mod runner;

pub use draw::{draw_figures, holds_figures};
