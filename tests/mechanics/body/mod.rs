//! Bodies, their ground, and what the grip does.

mod friction;
mod ground;
mod pieces;
mod pull;
mod rough_spatula;
mod step_jumps;
mod steps;
mod steps_in_space;
