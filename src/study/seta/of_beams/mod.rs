//! The pull-off of a seta whose spatulae are beams that adhere: every equilibrium is one of the whole tree.
pub(in crate::study) mod finer_peak;
mod looked;
mod piece;
pub(in crate::study) mod progress;
mod read;
pub(in crate::study) mod run;
