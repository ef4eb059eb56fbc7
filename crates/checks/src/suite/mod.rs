//! The verification suite: the mechanics held against the tables of `verification/`, closed forms and published values.
//!
//! One file or folder a topic. A topic computes its checks when it is run and knows nothing of the others.

pub(crate) mod accuracy;
pub(crate) mod beam;
mod ground;
pub mod hard;
mod levels;
mod published;
pub mod reference;
mod solid;
mod space;
mod spatula;
mod strip;
mod toe;

pub use crate::check::{Check, Measure, Topic};

/// Every topic, in the order in which they are reported.
pub const TOPICS: &[Topic] = &[
    published::TOPIC,
    strip::TOPIC,
    levels::TOPIC,
    beam::TOPIC,
    spatula::TOPIC,
    strip::pull::TOPIC,
    strip::laws::TOPIC,
    strip::films::TOPIC,
    strip::turns::FRICTION,
    strip::out_of_plane::TOPIC,
    space::strips::TOPIC,
    space::grip::TOPIC,
    space::held::TOPIC,
    ground::TOPIC,
    solid::TOPIC,
    toe::TOPIC,
    accuracy::orders::TOPIC,
    accuracy::bounds::TOPIC,
];
