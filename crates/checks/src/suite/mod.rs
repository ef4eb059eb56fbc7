//! The verification suite: the mechanics held against the tables of `verification/`, closed forms and published values.
//!
//! One file or folder a topic. A topic computes its checks when it is run and knows nothing of the others.

pub(crate) mod beam;
pub(crate) mod bounds;
pub(crate) mod check;
mod grip_in_space;
mod ground;
pub mod hard;
mod levels;
pub(crate) mod orders;
mod published;
pub mod reference;
mod solid;
mod space;
mod spatula;
mod strip;
mod strip_variants;
mod toe;

pub use check::{Check, Measure, Topic};

/// Every topic, in the order in which they are reported.
pub const TOPICS: &[Topic] = &[
    published::TOPIC,
    strip::TOPIC,
    levels::TOPIC,
    beam::TOPIC,
    spatula::TOPIC,
    strip_variants::pull::TOPIC,
    strip_variants::laws::TOPIC,
    strip_variants::turns::FRICTION,
    strip_variants::out_of_plane::TOPIC,
    space::TOPIC,
    grip_in_space::TOPIC,
    ground::TOPIC,
    solid::TOPIC,
    toe::TOPIC,
    orders::TOPIC,
    bounds::TOPIC,
];
