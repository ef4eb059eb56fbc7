//! Garbled scenes drawn from bytes, and what holds for each of them: shared by the tests and by `fuzz/`.
//!
//! Everything is a function of the bytes, so that a fuzzer may search among them and a test may draw them.

// every user takes a part of this
#![allow(dead_code, unused_imports)]

mod absurd;
mod check_parse;
mod check_run;
mod dice;
mod text;

pub use absurd::{absurd_scene, absurd_scene_of};
pub use check_parse::{check_parse, printed};
pub use check_run::{check_run, is_computed};
pub use dice::{BYTES, Dice};
pub use text::{ODD_VALUES, garbled_text, misspell};
