//! The stability of a planar path against leaving its plane: where a beam that is free to rolls or buckles sideways.
pub(super) mod branch;
mod dip;
mod first_loss;
pub(super) mod refusal;
pub(super) mod result;
mod roll_and_yaw;
mod roll_elements;
mod roll_reader;
mod roll_section;
mod run;
mod two_steps;
pub(super) mod width_range;
