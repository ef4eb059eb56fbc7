//! Analyses: the whole peel of a model, sweeps over a parameter, tests, limit points followed, the path of a rod.
mod accuracy;
mod checkpoint;
pub mod coarsening;
mod displacement_controlled_test;
mod error_bounds;
mod fit;
mod initial;
mod limit_point_continuation;
pub mod optimisation;
mod out_of_plane;
mod peel;
mod peeling;
mod power_law;
mod pull_in_time;
mod refinement;
mod refused;
mod rod;
mod sensitivity;
mod seta;
mod seta_in_time;
mod states;
mod stop_criteria;
mod sweep;
mod terms;
pub mod uncertainty;
mod warnings;
pub use crate::solve::LimitPointKind;
/// Order of the elements with which a point is followed.
pub use accuracy::ORDER as FOLLOWED_ORDER;
pub use accuracy::{ACCURACY_NUMBERS, Accuracy, Choice};
pub use checkpoint::Checkpoint;
pub use displacement_controlled_test::balance::{Balance, LoadingDirection};
pub use displacement_controlled_test::failure::{BranchError, TestError, TestFailure};
pub use displacement_controlled_test::model_limit::{LeftModel, ModelLimit};
pub use displacement_controlled_test::observed::{NoTest, no_test, observed, observed_retreat};
pub use displacement_controlled_test::result::{
    Elsewhere, Jump, JumpEnd, JumpKind, Observed, PullOff, TestEffort, TestEnd, TestPoint, UnknownJumpError,
};
pub use fit::error::{FitDataError, NoFit};
pub use fit::loss::Loss;
pub use fit::measured_curve::{MeasuredCurve, MeasuredJump, MeasuredPoint};
pub use fit::problem::{CurveBy, CurveOf, FitOptions, FitParameter, FitProblem, ModelOf, ParameterOf, ProfileChoice};
pub use fit::pulled_curve::PulledCurve;
pub use fit::result::{
    Combination, Fit, FitEnd, FittedJump, FittedParameter, FittedPoint, PairDetermined, PointPlace, Profile,
};
pub use fit::run::fit;
pub use fit::warnings::FitWarning;
pub use initial::error::{
    LoadingError, LoadingPhase, LoadingProgress, LoadingUnit, NoEquilibrium, NotPrepared, SettlingError, UnstableRest,
};
pub use initial::prepared::{Prepared, prepared};
pub use initial::stability::RelaxedStart;
pub use limit_point_continuation::cusp::{Cusp, cusp};
pub use limit_point_continuation::failure::{CuspError, PointNotFound};
pub use limit_point_continuation::result::{FollowedPoint, FollowedRow, FollowedSweep, PointKind, Remark, Spacing};
pub use limit_point_continuation::sweep::follow_point;
pub use out_of_plane::branch::result::{BranchStart, OutOfPlaneBranch, OutOfPlaneBranchError};
pub use out_of_plane::refusal::NotOutOfPlane;
pub use out_of_plane::result::{OutOfPlane, OutOfPlaneError, OutOfPlaneLoss};
pub use out_of_plane::width_range::{WidthLimit, WidthRange};
pub use peel::adhering::Adhering;
pub use peel::contact::{Contact, SMALLEST_RADIUS};
pub use peel::equilibrium_path::point_by_point::PathPoints;
pub use peel::failure::{Failure, PathFailure};
pub use peel::points::{BranchPoint, DeformedShape, LimitPoint, PathPoint, Peak};
pub use peel::result::{Effort, LargestComputedForce, PathEnd, Peel, Plateau};
pub use peel::sliding::Sliding;
pub use peeling::{checked, peel, peel_on};
pub use power_law::power_law;
pub use pull_in_time::result::{InTimeFailure, InTimeFailureKind, InTimePeak, InTimePoint, PullInTime};
pub use pull_in_time::run::{PullStart, pull_in_time, pull_in_time_from, pull_start};
pub use pull_in_time::settings::{PullRate, TimeAccuracy, Until};
pub use rod::{RodFailure, RodLimitPoint, RodPath, follow_rod};
pub use sensitivity::differences::MOST_CHANGED;
pub use sensitivity::error::NoSensitivities;
pub use sensitivity::force::force_derivatives;
pub use sensitivity::logarithmic::Exponent;
pub use sensitivity::quantity::PeelQuantity;
pub use sensitivity::run::{Sensitivities, sensitivities};
pub use sensitivity::{Derivative, Variation};
pub use seta::converged_peak::{ConvergedPeak, converged_peak};
pub use seta::failure::SetaFailure;
pub use seta::loading::{SetaLoading, SetaStart, SetaStep, StepEnd};
pub use seta::numbers::SetaResult;
pub use seta::options::SetaOptions;
pub use seta::progress::SetaProgress;
pub use seta::result::{
    EventCause, JointPlace, LocationError, SetaEffort, SetaEnd, SetaEvent, SetaMoment, SetaPoint, SetaPullOff,
    SetaState, TipChange, TipState,
};
pub use seta::run::{pull_off, pull_off_from};
pub use seta::sections::SetaBranch;
pub use seta::spatula_curve::{SpatulaCurveError, tip_curve};
pub use seta_in_time::result::{
    SetaInTime, SetaInTimeEvent, SetaInTimeFailure, SetaInTimeFailureKind, SetaInTimePoint, TipLoss,
};
pub use seta_in_time::run::pull_seta_in_time;
pub use seta_in_time::settings::{SetaPullRate, SetaTimeAccuracy};
pub use states::along_beam::SectionFields;
pub use states::beam_state::{BeamState, StateSections};
pub use states::in_space::SpatialSectionFields;
pub use stop_criteria::{Bound, FollowedUntil, Patience, Stage, StopCheck, StopCriteria, StopReason};
pub use sweep::{PeelResult, sweep};
pub use terms::decision::{KeptReason, LeftOut, NotEstimated, Term, TermDecisions, Terms};
pub use terms::effects::TermEffect;
pub use warnings::{Warning, WarningKind};
