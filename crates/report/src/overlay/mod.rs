//! Several results in one picture, with measured points over them.

mod columns;
mod error;
mod force_curve;
mod measured;
mod picture;
mod result;

pub use error::OverlayError;
pub use force_curve::{ForceRecord, read_force_curve};
pub use measured::Measured;
pub use picture::draw_overlay;
pub use result::{Kind, ResultFile};
