//! Analyses: the whole peel of a model, sweeps over a parameter, tests, limit points followed, the path of a rod.
mod asked;
pub mod coarsening;
mod displacement_controlled_test;
mod in_time;
mod initial;
mod out_of_plane;
mod parameters;
mod peel;
mod seta;
mod solid;
mod states;
mod terms;
pub use crate::solve::LimitPointKind;
pub use crate::solve::points::passing::Passing;
pub use crate::solve::points::tracer::{RodFailure, RodLimitPoint, RodPath, follow_rod};
/// Order of the elements with which a point is followed.
pub use asked::accuracy::{ACCURACY_NUMBERS, Accuracy, Choice, ORDER as FOLLOWED_ORDER};
pub use asked::events::{EventAction, EventAt, EventQuantity, StationAt, StationQuantity};
pub use asked::locator::StationErrors;
pub use asked::stop_criteria::{Bound, FollowedUntil, Patience, Stage, StopCriteria, StopReason};
pub use asked::terms::{KeptReason, LeftOut, NotEstimated, Term, TermDecisions, Terms};
pub use displacement_controlled_test::observed::{NoTest, no_test, observed, observed_retreat};
pub use displacement_controlled_test::result::{
    Elsewhere, Jump, JumpEnd, JumpKind, Observed, PullOff, TestEffort, TestEnd, TestPoint, TestStation,
    UnknownJumpError,
};
pub use displacement_controlled_test::stable_branch::{
    Balance, BranchError, LeftModel, LoadingDirection, ModelLimit, TestError, TestFailure,
};
pub use in_time::pull::{
    InTimeFailure, InTimeFailureKind, InTimePeak, InTimePoint, InTimeStation, PullInTime, PullRate, TimeAccuracy,
    Until, pull_in_time, pull_in_time_with,
};
pub use in_time::seta::{
    SetaInTime, SetaInTimeEvent, SetaInTimeFailure, SetaInTimeFailureKind, SetaInTimePoint, SetaInTimeStation,
    SetaPullRate, SetaTimeAccuracy, TipLoss, pull_seta_in_time, pull_seta_in_time_with,
};
pub use initial::error::{
    LoadingError, LoadingPhase, LoadingProgress, LoadingUnit, NoEquilibrium, NotPrepared, SettlingError, UnstableRest,
};
pub use initial::prepared::{Prepared, prepared};
pub use initial::stability::RelaxedStart;
pub use out_of_plane::branch::result::{BranchStart, OutOfPlaneBranch, OutOfPlaneBranchError};
pub use out_of_plane::result::{NotOutOfPlane, OutOfPlane, OutOfPlaneError, OutOfPlaneLoss};
pub use out_of_plane::width_range::{WidthLimit, WidthRange};
pub use parameters::fit::curves::measured_curve::{MeasuredCurve, MeasuredJump, MeasuredPoint};
pub use parameters::fit::curves::pulled_curve::PulledCurve;
pub use parameters::fit::problem::{
    CurveBy, DisplacementError, FitCurve, FitOptions, FitParameter, FitProblem, Loss, ModelOf, ParameterOf,
    ProfileChoice,
};
pub use parameters::fit::result::{
    Combination, Fit, FitDataError, FitEnd, FittedCurve, FittedJump, FittedParameter, FittedPoint, NoFit,
    PairDetermined, PointPlace, Profile,
};
pub use parameters::fit::run::fit;
pub use parameters::fit::warnings::FitWarning;
pub use parameters::limit_point_continuation::cusp::{Cusp, cusp};
pub use parameters::limit_point_continuation::result::{
    CuspError, FollowedPoint, FollowedRow, FollowedSweep, PointKind, PointNotFound, Remark, Spacing,
};
pub use parameters::limit_point_continuation::sweep::follow_point;
pub use parameters::sensitivity::differences::MOST_CHANGED;
pub use parameters::sensitivity::force::force_derivatives;
pub use parameters::sensitivity::quantity::{Derivative, Variation};
pub use parameters::sensitivity::quantity::{NoSensitivities, PeelQuantity};
pub use parameters::sensitivity::run::{Exponent, Sensitivities, sensitivities};
pub use parameters::sweep::{PeelResult, power_law, sweep};
pub use parameters::{optimisation, uncertainty};
pub use peel::along_path::station::{Events, MissedStation, Station, Stations};
pub use peel::along_path::work::Sliding;
pub use peel::along_path::yielded::Yielded;
pub use peel::budget::Checkpoint;
pub use peel::contact::{Adhering, Contact, SMALLEST_RADIUS};
pub use peel::equilibrium_path::follow::PathPoints;
pub use peel::result::{Effort, Failure, GivenUp, LargestComputedForce, PathEnd, PathFailure, Peel, Plateau};
pub use peel::solution_history::{BranchPoint, DeformedShape, LimitPoint, PathPoint, Peak};
pub use seta::converged_peak::{ConvergedPeak, SetaResult, converged_peak};
pub use seta::loading::{SetaLoading, SetaOptions, SetaStart, SetaStep, StepEnd};
pub use seta::of_beams::finer_peak::peak_of_beams_on_finer_mesh;
pub use seta::of_beams::progress::{BeamsProgress, BeamsPullOff};
pub use seta::of_beams::run::pull_off_of_beams;
pub use seta::result::{
    EventCause, SetaEffort, SetaEnd, SetaEvent, SetaFailure, SetaMoment, SetaProgress, SetaPullOff, SetaStation,
    TipChange,
};
pub use seta::run::{pull_off, pull_off_from};
pub use seta::spatula_curve::{SpatulaCurveError, tip_curve};
pub use solid::finer::SolidErrors;
pub use solid::peel::{
    SolidLeftOut, SolidLimitPoint, SolidOptions, SolidPathEnd, SolidPeel, SolidPoint, SolidStation, peel_solid,
    peel_solid_on,
};
pub use states::along_beam::{SectionFields, SpatialSectionFields};
pub use states::fields::{BeamState, StateSections};
pub use states::seta_state::{JointPlace, LocationError, SetaBranch, SetaPoint, SetaState, SpatulaState, TipState};
pub use terms::effects::TermEffect;
pub use terms::term_selection::{checked, peel, peel_on};
pub use terms::warnings::{Warning, WarningKind};
