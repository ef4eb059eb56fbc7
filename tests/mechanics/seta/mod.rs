//! Setae: the curve of a tip, a small tree on the ground against shooting, events, balance of work and energy, resumption.

mod branching;
mod converged_peak;
mod four_tips;
mod hard;
mod hysteresis;
mod initial_stiffness;
mod of_beams;
pub mod setup;
mod snap_on;
mod stations;
mod symmetry;
mod table_law;
mod tip;
mod unaccounted;
