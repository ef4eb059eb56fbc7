//! Motion in time: rods that spin, vibrate and fly, strips that are pulled at a rate.
mod flight;
mod in_space;
mod opening_rate;
mod pull;
mod rods;
mod seta;
mod spin_up;
mod stations;
mod trees;
