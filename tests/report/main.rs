//! What a user gets: files, pictures, checkpoints; and that garbled scenes get no others.

mod animation;
#[path = "../shared/frames.rs"]
mod frames;
mod garbled;
mod in_space;
mod outputs;
mod overlay;
mod pictures;
mod resume;
mod seta;
#[path = "../shared/pictures.rs"]
mod shared_pictures;
mod sketch;
mod states;
mod states_in_space;
#[path = "../shared/strip.rs"]
mod strip;
