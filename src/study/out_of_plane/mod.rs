//! The stability of a planar path against leaving its plane: where a beam that is free to rolls or buckles sideways.
pub(super) mod branch;
mod first_loss;
pub(super) mod result;
mod roll_and_yaw;
mod roll_elements;
mod roll_section;
mod run;
pub(super) mod width_range;
