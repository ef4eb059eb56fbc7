//! How equilibrium is found: Newton's method, path following, limit points, stability, relaxation, for any [`System`].
pub(crate) mod branching;
pub(crate) mod control;
pub(crate) mod end_conditions;
pub(crate) mod error;
mod grip_block;
pub(crate) mod limit_point;
pub(crate) mod linear;
pub(crate) mod newton;
pub(crate) mod observables;
pub(crate) mod path;
pub(crate) mod problem;
pub(crate) mod relax;
pub(crate) mod state;
pub(crate) mod system;
pub mod time;
pub(crate) mod workspace;
pub use branching::locate_branching;
pub use control::controlled;
pub use end_conditions::{Direction, EndConditions};
pub use error::{Place, Quantity, SolveError};
pub use limit_point::bracket::brackets;
pub use limit_point::kind::LimitPointKind;
pub use limit_point::locate::{
    Located, ROUGH, difference_on_more_elements, locate, on_more_elements, solve_on, step_to, unlocated,
};
pub use limit_point::search::{BendRule, Bends, FoundLimitPoint, LimitPointSearch};
pub use linear::{Bordered, Tangents};
pub use newton::{NewtonOptions, Solution, Tangent, damped_step, settle, slopes, solve};
pub use observables::{MONITORS, Observables, PathConstraint};
pub use path::equilibrium_path::Path;
pub use path::hermite::Hermite;
pub use path::options::{PathError, PathOptions};
pub use path::predictor::{MOST_POINTS, lagrange_weights, longest_step};
pub use path::segment::PathSegment;
pub use path::tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
pub use path::waypoint::Waypoint;
pub use problem::{InitialState, MeasuredBeside, PathMeasure, Problem};
pub use relax::{
    Held, RelaxError, RelaxOptions, Relaxed, disturbed, disturbed_anyhow, relax, relaxed_on_more_elements,
};
pub use state::{History, Mesh, State};
pub use system::{Coefficients, CondensedSystem, EndRoll, Evaluation, INTERFACE, NodalTerms, Rates, System, Unknown};
pub use workspace::{Pace, ShouldStop, Workspace};
