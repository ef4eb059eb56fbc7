//! How equilibrium is found: elimination along a chain, Newton, path following, limit points, stability.
mod bracket;
mod branching;
mod chain;
mod control;
mod error;
mod fold;
mod fronts;
mod grip;
mod limit;
mod mesh;
mod newton;
mod path;
mod predictor;
mod problem;
mod relax;
mod slips;
mod stretch;
mod uniform_chain;
pub use bracket::brackets;
pub use branching::locate_branching;
pub use chain::*;
pub use control::controlled;
pub use error::SolveError;
pub use fold::{Fold, FoldSearch};
pub use fronts::Fronts;
pub use grip::{Direction, GripForces, GripState};
pub use limit::{
    Located, ROUGH, Turn, difference_on_more_elements, locate, on_more_elements, reach, solve_on, unlocated,
};
pub use mesh::{Focus, Mesh, Pieces, graded_ends};
pub use newton::*;
pub use path::{Path, PathError, PathOptions, Waypoint};
pub use predictor::{MOST_POINTS, lagrange_weights, longest_step};
pub use problem::{Beginning, Equilibrium, Problem};
pub use relax::{Held, RelaxError, RelaxOptions, Relaxed, disturbed, relax, turned};
pub use slips::Slips;
pub use stretch::{Hermite, Stretch};
pub use uniform_chain::{BUNDLE, UniformChain};
