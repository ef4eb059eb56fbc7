//! Paths of equilibria: stepped, predicted, interpolated.
mod equilibrium_path;
mod hermite;
mod metric;
mod near_branch;
mod options;
mod predictor;
mod segment;
mod settling;
mod tracer;
mod waypoint;
pub use equilibrium_path::Path;
pub use hermite::Hermite;
pub(crate) use near_branch::is_mirrored;
pub use options::{PathError, PathOptions};
pub use predictor::{MOST_POINTS, lagrange_weights, longest_step};
pub use segment::PathSegment;
pub use tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
pub use waypoint::Waypoint;
