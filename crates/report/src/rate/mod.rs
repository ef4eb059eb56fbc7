//! What a user gets of a pull at a rate: the curve, the summary, the picture.

mod curve;
mod picture;
mod summary;

pub use curve::write_rate_curve;
pub use picture::draw_rate;
pub use summary::RateSummary;

/// The library counts times in ns.
const S_PER_NS: f64 = 1e-9;
