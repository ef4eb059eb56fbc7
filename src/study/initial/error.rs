//! Why a path has no start.

use crate::beam::grip_state::{ForcesInSpace, GripForces, StepsTaken};
use crate::beam::planar::model_end::CollapsedSection;
use crate::beam::planar::model_limits::UprightSection;
use crate::model::problem::build::NoSuchOrder;
use crate::model::step::{Moved, Step, whole_degrees};
use crate::solve::error::SolveError;
use crate::solve::path::options::PathError;
use crate::solve::relax::RelaxError;
use crate::units::{FORCES, LENGTHS, MOMENTS, Unit};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Why no equilibrium was found for a path to start from; and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum NoEquilibrium {
    /// There are no elements on which to look for one.
    #[error("{0}")]
    Order(#[from] NoSuchOrder),
    /// The beam does not come to rest on ground that is not flat.
    #[error(
        "no equilibrium of the beam without a grip was found on the substrate: {0}. Try another substrate.start, or a \
         stiffer beam"
    )]
    OnGround(SettlingError),
    /// What the grip does before the pull has no end.
    #[error("{phase} {cause}. Try a shorter step, or other steps before it")]
    Loading { phase: LoadingPhase, cause: Box<LoadingError> },
    /// The model has no stable state to start from.
    #[error("there is no stable state at rest: {why}. {}", .why.remedy())]
    Unstable {
        #[from]
        why: UnstableRest,
    },
}

impl NoEquilibrium {
    /// Whether the model was refused by a criterion with a name, and not for want of a solution.
    pub(crate) fn is_refusal(&self) -> bool {
        matches!(self, Self::Unstable { .. })
    }

    /// Whether a step before the pull has ended where the beam would jump.
    pub(super) fn is_loss_of_stability(&self) -> bool {
        let Self::Loading { cause, .. } = self else { return false };
        matches!(**cause, LoadingError::Turns { .. } | LoadingError::Unstable { .. })
    }
}

/// Why a model has no stable state at rest: the criterion with its numbers, and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum UnstableRest {
    /// Sections that tilt all together gain more from the adhesion than shear costs them.
    #[error(
        "the adhesion softens a tilt of the bonded sections by {softening:.6} nN, {ratio:.4} times the {resistance:.6} nN with \
         which the beam resists (shear stiffness GA_s = {shear:.6} nN)"
    )]
    Tilting { softening: f64, resistance: f64, shear: f64, ratio: f64 },
    /// Waves gain more than shear, bending and the adhesion's own stiffness cost.
    #[error(
        "the adhesion softens a tilt of the bonded sections by {softening:.6} nN, {ratio:.4} times what a beam of this bending \
         stiffness takes: it wrinkles in waves of {wavelength:.4} nm ({negative} negative eigenvalues)"
    )]
    Wrinkling { softening: f64, ratio: f64, wavelength: f64, negative: usize },
    /// It is unstable, and does not come to rest elsewhere.
    #[error(
        "the equilibrium has {negative} negative eigenvalues, and the beam does not come to rest when it leaves it: {cause} (tilt \
         softening over what keeps its free end down: {ratio:.4})"
    )]
    NotRelaxed { negative: usize, ratio: f64, cause: RelaxError },
    /// A section stands upright where the law has a pole.
    #[error("{0}")]
    Upright(UprightSection),
    /// With the near face alone the beam does not settle in a stable state, with both faces it does.
    #[error(
        "with the near face alone the beam does not come to rest, with both faces it does: its sections are up to {steepest:.1} \
         degrees steep then, and the energy of the near face alone, W/cos θ, has no lower bound at 90 degrees"
    )]
    NearFaceAlone { steepest: f64 },
}

impl UnstableRest {
    /// What to try: a sentence of its own.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Tilting { .. } | Self::Wrinkling { .. } | Self::NotRelaxed { .. } => STIFFER,
            Self::Upright(_) | Self::NearFaceAlone { .. } => BOTH_FACES,
        }
    }
}

/// What to try where the adhesion tilts the sections.
const STIFFER: &str = "Try a higher, stiffer or shear-rigid beam (strip.height, youngs_modulus, shear_correction), a larger \
                       adhesion.equilibrium_distance, a smaller hamaker_constant, or line_load = \"axis-gap\", which has no such moment.";
/// What to try where the near face has its pole.
const BOTH_FACES: &str = "Give adhesion.far_face = true, which has no such pole, or a shaft or a pull less steep.";

/// Why a beam without a grip does not come to rest on its ground.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum SettlingError {
    /// Down the gradient of its energy.
    #[error("{0}")]
    Relax(#[from] RelaxError),
    /// By Newton's method, on more elements.
    #[error("{0}")]
    Solve(#[from] SolveError),
}

/// What the grip was about to do before the pull.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs)] // the text of each names its fields
pub enum LoadingPhase {
    /// To begin.
    Start,
    /// To let go of what the step before has moved; the number of a step counts from 1.
    LettingGo { number: usize, step: Step },
    /// A step.
    Step { number: usize, step: Step },
    /// To let go before the pull.
    LettingGoToPull,
}

impl fmt::Display for LoadingPhase {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Start => f.write_str("the first of drive.steps"),
            Self::LettingGo { number, step } => {
                write!(f, "letting go before {}", Self::Step { number: *number, step: *step })
            }
            Self::Step { number, step } => write!(f, "step {number} of drive.steps, \"{step}\","),
            Self::LettingGoToPull => f.write_str("letting go before the pull"),
        }
    }
}

/// Why a step before the pull was not taken to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum LoadingError {
    /// There is no equilibrium that it could go from.
    #[error("finds no equilibrium to begin with: {0}")]
    Start(PathError),
    /// Its equilibria end on the way.
    #[error("cannot be followed beyond {at}: after {} ever shorter steps: {}", .why.tries, .why.cause)]
    Path { at: LoadingProgress, why: Box<PathError> },
    /// What it moves turns back.
    #[error("comes to a limit point at {at}, beyond which the beam jumps")]
    Turns { at: LoadingProgress },
    /// The beam jumps, and does not come to rest.
    #[error("comes to where the beam jumps, at {at}, and it does not come to rest: {cause}")]
    NoRest { at: LoadingProgress, cause: RelaxError },
    /// The beam jumps to where it is none.
    #[error("comes to where the beam jumps, at {at}, and {section}")]
    Collapses { at: LoadingProgress, section: CollapsedSection },
    /// The beam jumps off, and no step behind that presses it down again.
    #[error(
        "comes to a limit point at {at}, where the beam jumps off the substrate, and nothing adheres where the pull begins"
    )]
    Off { at: LoadingProgress },
    /// The beam jumps to where a section stands upright and the law has a pole.
    #[error("comes to where the beam jumps, at {at}, and {section}")]
    Upright { at: LoadingProgress, section: UprightSection },
    /// The beam jumps to where its free end stands on its edge.
    #[error("comes to where the beam jumps, at {at}, and its free end comes to stand upright, on its edge")]
    OnEnd { at: LoadingProgress },
    /// It jumps again and again.
    #[error("has jumped {jumps} times, the last time at {at}")]
    Jumps { at: LoadingProgress, jumps: usize },
    /// Its equilibria go into the substrate.
    #[error("leads through the surface of the substrate, beyond {at}")]
    Inside { at: LoadingProgress },
    /// Stability is lost although what it moves does not turn back.
    #[error("comes to where equilibrium is no longer stable, beyond {at}: there the beam leaves its path")]
    Unstable { at: LoadingProgress },
    /// It takes too many equilibria.
    #[error("is not at its end after {points} equilibria, at {at}")]
    Long { at: LoadingProgress, points: usize },
    /// The last of its equilibria was not found.
    #[error("finds no equilibrium at its end, beyond {at}: {why}")]
    End { at: LoadingProgress, why: SolveError },
}

/// How far a step has come, with what the grip exerts there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LoadingProgress {
    /// Of what it moves, in `unit`
    pub amount: f64,
    /// Of the amount
    pub unit: LoadingUnit,
    /// What the grip exerts there
    pub forces: GripForces,
}

/// The unit of what a step moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum LoadingUnit {
    /// Of a translation
    Nanometre,
    /// Of a rotation
    Radian,
    /// Of a rotation that the scene writes in degrees
    Degree,
}

impl LoadingUnit {
    /// That in which a step moves this amount, nm or rad.
    pub(super) fn of(moved: Moved, amount: f64) -> Self {
        match (moved.is_angle(), whole_degrees(amount)) {
            (false, _) => Self::Nanometre,
            (true, None) => Self::Radian,
            (true, Some(_)) => Self::Degree,
        }
    }

    /// That what moves has come so far, nm or rad, with what the grip exerts there.
    pub(super) fn reached(self, forces: GripForces, moved: f64) -> LoadingProgress {
        let amount = match self {
            Self::Nanometre | Self::Radian => moved,
            Self::Degree => moved.to_degrees(),
        };
        LoadingProgress { amount, unit: self, forces }
    }
}

impl fmt::Display for LoadingUnit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Nanometre => "nm",
            Self::Radian => "rad",
            Self::Degree => "deg",
        })
    }
}

impl fmt::Display for LoadingProgress {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { amount, unit, forces: GripForces { horizontal, vertical, moment, in_space } } = self;
        match unit {
            LoadingUnit::Nanometre => f.write_str(&fitted(LENGTHS, *amount))?,
            LoadingUnit::Radian | LoadingUnit::Degree => write!(f, "{amount:.6} {unit}")?,
        }
        let [horizontal, vertical] = [horizontal, vertical].map(|force| fitted(FORCES, *force));
        write!(f, " (H = {horizontal}, V = {vertical}, M = {}", fitted(MOMENTS, *moment))?;
        if let Some(ForcesInSpace { lateral, yaw_moment, torque }) = in_space {
            let [yaw_moment, torque] = [yaw_moment, torque].map(|moment| fitted(MOMENTS, *moment));
            write!(f, ", sideways {}, on the yaw {yaw_moment}, on the roll {torque}", fitted(FORCES, *lateral))?;
        }
        f.write_str(")")
    }
}

/// A number in the unit that fits it.
fn fitted(units: &[Unit], value: f64) -> String {
    let unit = Unit::fitting(units, value.abs());
    format!("{:.6} {}", unit.of(value), unit.name)
}

/// A problem that has no start, and what the grip did before that was known.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{why}")]
pub struct NotPrepared {
    /// Why there is no equilibrium to start from
    pub why: NoEquilibrium,
    /// The grip in the steps before the pull, as far as they were taken.
    pub steps: Box<StepsTaken>,
}
