//! How equilibrium is found: Newton's method, path following, limit points, stability, relaxation, for any [`System`].
mod branching;
mod control;
mod end_conditions;
mod error;
mod grip_block;
mod limit_point;
mod linear;
mod newton;
mod observables;
mod path;
mod problem;
mod relax;
mod state;
mod system;
pub mod time;
pub use branching::locate_branching;
pub use control::controlled;
pub use end_conditions::{Direction, EndConditions};
pub use error::{Place, Quantity, SolveError};
pub use limit_point::*;
pub use linear::{Bordered, Tangents};
pub use newton::*;
pub use observables::{MONITORS, Observables, PathConstraint};
pub use path::*;
pub use problem::{InitialState, MeasuredBeside, PathMeasure, Problem};
pub use relax::{
    Held, RelaxError, RelaxOptions, Relaxed, disturbed, disturbed_anyhow, relax, relaxed_on_more_elements,
};
pub use state::{History, Mesh, State};
pub use system::{
    Coefficients, CondensedSystem, EndRoll, Evaluation, INTERFACE, NodalTerms, Rates, ShouldStop, System, Unknown,
    Workspace,
};
