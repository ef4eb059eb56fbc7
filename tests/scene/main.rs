//! The text of a scene: what it may hold, what it means, and every message about it.

mod friction;
mod ground;
mod laws;
mod messages;
mod pull;
mod steps;
mod written;
