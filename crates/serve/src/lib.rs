//! A live page on the user's own machine: sliders for the keys of a scene, and the peel computed again while one drags.
//!
//! The page speaks to [`Server`] in the texts of scenes alone: it sends a TOML text and keys that replace those of it, and gets the
//! summary of the run ([`peelkit_analyses::RunOutcome`]), the curve and the outlines of the beam, or the branches of the seta. A run whose
//! page has gone is stopped.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod asked;
mod http;
mod page;
mod run;

pub use asked::limits::Limits;
pub use http::server::{Server, Stopper};
pub use page::{READY, StartScene};
