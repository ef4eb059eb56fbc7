//! What is read along a path: states and stations, work, and the points that a user asks for.

mod beam_state;
pub(in crate::study::peel) mod special_points;
pub(in crate::study) mod station;
pub(in crate::study) mod work;
pub(in crate::study) mod yielded;
