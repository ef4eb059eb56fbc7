//! How equilibrium is found: Newton's method, path following, limit points, stability, relaxation, for any [`System`].
pub(crate) mod error;
pub(crate) mod frontal;
pub(crate) mod linear;
pub(crate) mod newton;
pub(crate) mod path;
pub(crate) mod points;
pub(crate) mod problem;
pub(crate) mod relax;
pub(crate) mod state;
pub(crate) mod system;
pub mod time;
pub(crate) mod workspace;
pub use error::{Place, Quantity, SolveError};
pub use frontal::eliminate::Eliminated;
pub use frontal::end_block::Carry;
pub use frontal::frontal_matrix::{FrontalMatrix, FrontalRow};
pub use frontal::nodes::{Fixed, MOST_NODES, Nodes, slot};
pub use linear::{Bordered, Tangents};
pub use newton::{NewtonOptions, Solution, Tangent, settle, slopes, solve};
pub use path::equilibrium_path::Path;
pub use path::hermite::Hermite;
pub use path::options::{PathError, PathOptions, Waypoint, controlled};
pub use path::predictor::{MOST_POINTS, longest_step};
pub use path::segment::PathSegment;
pub use points::bracket::brackets;
pub use points::branching::locate_branching;
pub use points::locate::{Located, locate};
pub use points::passing::{FoundValue, Passing, PathNumber, SoughtValue};
pub use points::search::LimitPointKind;
pub use points::tracer::{PathEvent, PathTracer, TraceError, TraceOptions};
pub use problem::{Direction, EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem};
pub use relax::{Held, RelaxError, RelaxOptions, Relaxed, disturbed, relax};
pub use state::{History, MONITORS, Mesh, Observables, PathConstraint, Places, State};
pub use system::{
    Coefficients, CondensedSystem, EndRoll, Evaluation, INTERFACE, NodalTerms, Rates, StepDependence, System, Unknown,
};
pub use workspace::{Pace, ShouldStop, Workspace};
