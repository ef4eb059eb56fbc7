//! The figures of `figures/`: computed, drawn, and written with the data and a caption beside each.

pub(crate) mod draw;
mod figure;
mod numerics;
mod opening_rate;
mod peeling;
mod runner;
mod solid;
