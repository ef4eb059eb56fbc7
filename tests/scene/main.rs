//! The text of a scene: what it may hold, what it means, and every message about it.

mod any_text;
mod array;
mod conflicts;
mod fit;
mod friction;
mod ground;
mod laws;
mod messages;
mod overrides;
mod parameters;
mod pull;
mod rate;
mod reading;
mod ready_scenes;
mod seta;
mod solid;
mod space;
mod steps;
#[path = "../shared/strip.rs"]
mod strip;
mod text;
mod to_toml;
mod uncertainty;
mod units;
mod written;
