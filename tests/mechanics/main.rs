//! The mechanics: laws of adhesion, elements, bodies on their ground, and whole peels.
//!
//! A topic is run by its name: `cargo test --test mechanics friction::`.

mod adhesion;
mod beam;
mod body;
mod coarsening;
mod common;
mod effort;
mod model;
mod seta;
mod solid;
mod solve;
mod study;
mod time;
mod toe;
mod uncertainty;
