//! What a user gets: files, pictures, checkpoints; and that garbled scenes get no others.

mod garbled;
mod outputs;
mod pictures;
mod resume;
#[path = "../shared/pictures.rs"]
mod shared_pictures;
mod sketch;
mod states;
#[path = "../shared/strip.rs"]
mod strip;
