//! How equilibrium is found: elimination along a chain, Newton, path following, limit points, stability.
mod chain;
mod error;
mod limit;
mod mesh;
mod newton;
mod path;
mod predictor;
mod problem;
mod stretch;
pub use chain::*;
pub use error::SolveError;
pub use limit::{Located, Turn, difference_on_more_elements, locate, solve_on, unlocated};
pub use mesh::{Focus, graded_ends};
pub use newton::*;
pub use path::{Path, PathError, PathOptions};
pub use problem::{Equilibrium, Problem};
pub use stretch::{Hermite, Stretch};
