//! The stability of a planar path against leaving its plane: where a beam that is free to rolls or buckles sideways.
mod branch;
mod dip;
mod first_loss;
mod refusal;
mod result;
mod roll_and_yaw;
mod roll_elements;
mod roll_reader;
mod roll_section;
mod run;
mod two_steps;
mod width_range;
pub use branch::*;
pub use refusal::NotOutOfPlane;
pub use result::*;
pub use width_range::{WidthLimit, WidthRange};
