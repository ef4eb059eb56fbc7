//! The verification suite: the mechanics held against the tables of `verification/`, closed forms and published values.
//!
//! One file a topic. A topic computes its checks when it is run and knows nothing of the others.

pub(crate) mod beam;
pub mod bounds;
mod check;
pub mod drawn;
mod friction;
mod ground;
pub mod hard;
mod hard_scene;
mod laws;
mod levels;
pub mod orders;
mod published;
mod pull;
pub mod reference;
mod repeated;
mod spatula;
mod strip;
mod turns;

pub use check::{Check, Measure, Topic};

/// Every topic, in the order in which they are reported.
pub const TOPICS: &[Topic] = &[
    published::TOPIC,
    strip::TOPIC,
    levels::TOPIC,
    beam::TOPIC,
    spatula::TOPIC,
    pull::TOPIC,
    laws::TOPIC,
    friction::TOPIC,
    ground::TOPIC,
    orders::TOPIC,
    bounds::TOPIC,
];
