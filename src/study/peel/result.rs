//! The whole peel of one model: path, special points, error bounds, how it ended.

use super::solution_history::{BranchPoint, DeformedShape, LimitPoint, PathPoint, Peak, SolutionHistory};
use crate::beam::grip_state::{GripState, StepJump};
use crate::beam::planar::chain::NodeState;
use crate::beam::planar::model_limits::{BondedLoss, UprightSection};
use crate::beam::spatial::section_state::{SpatialSectionPlace, SpatialSectionState};
use crate::model::peel::PeelModel;
use crate::solve::error::SolveError;
use crate::solve::path::options::PathError;
use crate::solve::points::search::LimitPointKind;
use crate::solve::workspace::Pace;
use crate::study::asked::accuracy::Choice;
use crate::study::asked::stop_criteria::Bound;
use crate::study::asked::terms::TermDecisions;
use crate::study::initial::error::NoEquilibrium;
use crate::study::initial::stability::RelaxedStart;
use serde::{Deserialize, Serialize};

/// How a path ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum PathEnd {
    /// No point of the beam is nearer than [`crate::adhesion::LineLaw::cutoff_distance`].
    Detached,
    /// The force has come back to zero, or the beam stands upright, and it is still in edge contact.
    Pivoting,
    /// A grip that rotates as it goes has passed a displacement limit point while it pushes: behind that the force is below zero and
    /// has not come back to zero.
    Pushing,
    /// The beam has re-adhered: u has returned to 0.
    TurnedBack,
    /// The whole contact slides, and would at a constant force from here on; or next to none of it is left.
    Sliding,
    /// With friction, the displacement has a limit point: equilibrium does not determine how a beam slides during a jump.
    Snapped,
    /// What is bonded loses its stability under the horizontal force, and the beam leaves its path there for no state that is near.
    BondedPartUnstable(BondedLoss),
    /// A branch that had left the plane has come back into it: there it ends on the planar path.
    BackInPlane,
    /// A section stands upright in the reach of a law whose energy has no lower bound there.
    Upright(UprightSection),
    /// It goes on; a stop criterion was met.
    Bound(Bound),
    /// The computation stopped short; why, with numbers and what to try.
    Failed(Failure),
}

/// The largest force among the points of a path where that is at no located limit point: at an end of the path, say. How far the force goes up
/// from there is not known, and so it has no error bound.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LargestComputedForce {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
}

/// The steady force: where the force changes least with the displacement while the front advances.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plateau {
    /// u of the grip, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Bound on the error of `force`, nN; none with friction, where a term of the model was left out, and where the force has a limit point
    /// elsewhere between the initiation peak and the first jump: which of the two places is taken depends on how long the steps are. Beyond
    /// the first jump, the same of limit points of its level segment
    pub force_error: Option<f64>,
    /// How far from `displacement` the force changes as little, as far as the error of its slope tells, nm; none likewise
    pub displacement_error: Option<f64>,
    /// Whether it is stable under displacement control
    #[serde(default)]
    pub stable: bool,
    /// It lies between `points[after]` and `points[after + 1]` of the path.
    #[serde(default)]
    pub after: usize,
}

/// What it took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Effort {
    /// On the final mesh
    pub points: usize,
    /// On all meshes
    pub newton_iterations: usize,
    /// Of the final mesh
    pub elements: usize,
    /// Of the elements, 1 to 8
    pub order: usize,
    /// At which the path was followed: wary where every mesh had lost it
    pub pace: Pace,
}

/// The result of one run. It is written without the solutions behind its points.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Peel {
    /// What was peeled
    pub model: PeelModel,
    /// The grip behind each step before the pull, as far as they were taken, seen from where it took hold.
    pub steps: Vec<GripState>,
    /// The grip at the equilibria of each step, from where it begins; those of a step that has no end as far as they go. Between its ends they are on
    /// the mesh of the step, without a bound.
    #[serde(default)]
    pub step_ways: Vec<Vec<GripState>>,
    /// Jumps on the way of the steps; what they released is on the mesh of the step, without a bound.
    #[serde(default)]
    pub step_jumps: Vec<StepJump>,
    /// Where the equilibrium next to the stress-free configuration is unstable: that the path starts in the stable one to which the beam has
    /// been relaxed from there.
    #[serde(default)]
    pub relaxed_start: Option<RelaxedStart>,
    /// The path, from rest on
    pub points: Vec<PathPoint>,
    /// In path order.
    pub limit_points: Vec<LimitPoint>,
    /// Where other branches meet the path, in its order. The path goes on along the branch that it is on, stable or not.
    #[serde(default)]
    pub branch_points: Vec<BranchPoint>,
    /// The first load limit point that is a maximum; none where the path has none
    pub initiation_peak: Option<Peak>,
    /// The limit point with the largest force up to the first displacement limit point, or as far as a stop criterion or the model let the path go. None
    /// where the computed curve goes higher at a point that is no limit point, where the grip pushes all the way, and where the
    /// computation stopped short before the first displacement limit point: an end of a path is never a peak.
    pub peak: Option<Peak>,
    /// Where there is no `peak`: the largest force of the computed curve up to the first displacement limit point.
    pub largest_computed_force: Option<LargestComputedForce>,
    /// The steady force: between the initiation peak and the first jump where the force is level there, else on the level segment of the path on
    /// which the front advances furthest; none where there is none
    pub plateau: Option<Plateau>,
    /// The first displacement limit point: a displacement-controlled test makes its first jump here, whatever jumps.
    pub snap_off: Option<LimitPoint>,
    /// The displacement limit point behind which the pad does not adhere any more ([`Adhering`](crate::study::Adhering)): at the most an edge or
    /// the end does. None where there is no such fold, and on a path that was not followed to where the beam comes off.
    pub pad_detachment: Option<LimitPoint>,
    /// The displacement limit point behind which nothing adheres any more, up to where the path ends detached. None where there is no
    /// such fold, as where an edge still adheres in the end or comes off without a jump.
    pub detachment: Option<LimitPoint>,
    /// Where and why the path ends
    pub end: PathEnd,
    /// What it cost
    pub effort: Effort,
    /// Relative accuracy asked for.
    pub asked: f64,
    /// What was fixed of the discretisation.
    pub choice: Choice,
    /// Load limit points left out, because the force changes by less than the accuracy between them.
    pub ripple: usize,
    /// What was decided of the terms of the model, of [`crate::study::Terms::Auto`]; `model` is then without those that were left out.
    pub considered: Option<TermDecisions>,
    /// Whether time or an interruption ended the run although it goes on, along the path or to a finer mesh.
    pub unfinished: bool,
    /// The solutions behind the points, for pictures.
    #[serde(skip)]
    pub(in crate::study) trace: Option<SolutionHistory>,
}

impl Peel {
    /// The curve between the path points as well, `per_step` intervals a step: (u, P, negative eigenvalues under
    /// displacement control). The displacement limit points are among its points.
    pub fn dense_curve(&self, per_step: usize) -> Vec<(f64, f64, usize)> {
        match &self.trace {
            Some(trace) => trace.dense_curve(&self.limit_points, per_step),
            None => self.points.iter().map(|p| (p.displacement, p.force, p.negative_eigenvalues)).collect(),
        }
    }

    /// Which of `points` has its front nearest to a place along the beam, nm.
    pub fn nearest_front(&self, place: f64) -> Option<usize> {
        let away = |&index: &usize| (self.points[index].front - place).abs();
        (0..self.points.len()).min_by(|a, b| away(a).total_cmp(&away(b)))
    }

    /// Section forces, stretch and adhesion at the ends of the elements at `points[index]`, from S = 0 to S = L; empty
    /// where there is none, and in space. H x' + V y' + M θ' - stored - bΨ is the same at all of them.
    pub fn sections(&self, index: usize) -> Vec<NodeState> {
        self.trace.as_ref().map(|trace| trace.sections(index)).unwrap_or_default()
    }

    /// The same of a beam in space; empty in the plane. [`SpatialSectionState::integrals`] of a uniform beam are the same at all of them.
    pub fn sections_in_space(&self, index: usize) -> Vec<SpatialSectionState> {
        self.trace.as_ref().map(|trace| trace.sections_in_space(index)).unwrap_or_default()
    }

    /// The same without the solutions behind its points, which take most of its memory: without shapes, sections and terms.
    pub fn without_solutions(self) -> Self {
        Self { trace: None, ..self }
    }

    /// The deformed axis at `points[index]`; empty where there is none.
    pub fn shape(&self, index: usize) -> DeformedShape {
        self.trace.as_ref().map(|trace| trace.shape(index)).unwrap_or_default()
    }

    /// The same with so many samples that a picture of it has no corners.
    pub fn smooth_shape(&self, index: usize) -> DeformedShape {
        self.trace.as_ref().map(|trace| trace.smooth_shape(index)).unwrap_or_default()
    }

    /// The deformed axis at a limit point of this peel, for a picture. Nothing where the solutions behind the path are not known.
    pub fn shape_at_limit_point(&self, limit: &LimitPoint) -> Option<DeformedShape> {
        let number = self.limit_points.iter().position(|known| known == limit)?;
        self.trace.as_ref()?.shape_at_limit_point(number)
    }

    /// Sections at `count` places evenly along a beam in space at `points[index]`; empty in the plane.
    pub fn places_in_space(&self, index: usize, count: usize) -> Vec<SpatialSectionPlace> {
        self.trace.as_ref().map(|trace| trace.evenly_in_space(index, count)).unwrap_or_default()
    }

    /// The same at a limit point of this peel. Nothing where the solutions behind the path are not known.
    pub fn places_at_limit_point(&self, limit: &LimitPoint, count: usize) -> Option<Vec<SpatialSectionPlace>> {
        let number = self.limit_points.iter().position(|known| known == limit)?;
        self.trace.as_ref()?.evenly_at_limit_point(number, count)
    }
}

// -- Why a peel stopped short, with what was computed, where and how far --

/// Why a computation stopped short, and what to try.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum Failure {
    /// The model, or the accuracy asked for, cannot be computed: the key of a scene, what was found, and what would be right.
    #[error("`{key}` {found}. {remedy}")]
    Refused { key: String, found: String, remedy: String },
    /// The path has no start.
    #[error("{0}")]
    NoStart(NoEquilibrium),
    /// On the best mesh that was tried, of so many elements of this order.
    #[error(
        "{cause}; on {elements} elements of order {order}. The results so far are kept. Try another accuracy.relative than {asked:e}, or \
         bounds.displacement to stop before{}",
        given_up.as_ref().map_or(String::new(), GivenUp::to_string)
    )]
    Path {
        cause: PathFailure,
        elements: usize,
        order: usize,
        /// Relative accuracy asked for.
        asked: f64,
        /// Why no more was tried, where more would have been.
        given_up: Option<GivenUp>,
    },
    /// No mesh was tried.
    #[error("nothing was computed")]
    NothingComputed,
}

/// What ended the search for a mesh on which a path comes to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum GivenUp {
    /// [`crate::study::Patience::Usual`]
    #[error(", or bounds.time = \"60 s\": this run was given up after a hundred times the usual work")]
    Work,
    /// What the caller knows: the time.
    #[error(", or more time: {0} ended the search for a better mesh")]
    Stopped(Bound),
}

impl Failure {
    /// Whether nothing was tried, because of what the model or the accuracy asks: by a criterion with a name, and not for want of a solution.
    pub fn is_refusal(&self) -> bool {
        match self {
            Self::Refused { .. } => true,
            Self::NoStart(why) => why.is_refusal(),
            Self::Path { .. } | Self::NothingComputed => false,
        }
    }
}

impl PathFailure {
    /// The path point behind which the trouble is, where that is known.
    pub(super) fn after(&self) -> Option<usize> {
        match self {
            Self::Missed { after, .. } | Self::NotLocated { after, .. } | Self::Jumped { after, .. } => Some(*after),
            Self::Path(_)
            | Self::LostAtRest { .. }
            | Self::Stuck { .. }
            | Self::OutOfTime
            | Self::OutOfWork { .. }
            | Self::NearUpright(_)
            | Self::TooManyPoints { .. }
            | Self::StepsMatter { .. }
            | Self::BoundsMissed { .. } => None,
        }
    }
}

/// Why a path on one mesh cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum PathFailure {
    /// It cannot be continued.
    #[error("{0}")]
    Path(PathError),
    /// A limit point was not located.
    #[error(
        "the limit point of the {turn} after path point {after} (u = {displacement_nm:.6} nm) was not located: {cause}"
    )]
    NotLocated { turn: LimitPointKind, after: usize, displacement_nm: f64, cause: SolveError },
    /// A limit point was not seen.
    #[error(
        "between path points {after} and {} (u = {displacement_nm:.6} nm) the number of negative eigenvalues goes from \
         {from} to {to}, which {turns} located displacement limit points do not explain",
        after + 1
    )]
    Missed { after: usize, displacement_nm: f64, from: usize, to: usize, turns: usize },
    /// A step may have led to another part of the path.
    #[error(
        "between path points {after} and {} (u = {displacement_nm:.6} nm) no solution was found, and force and displacement do \
         not change smoothly: the path may have skipped a part of itself",
        after + 1
    )]
    Jumped { after: usize, displacement_nm: f64 },
    /// The force vanishes again before it had a maximum.
    #[error(
        "the path came back to P = 0 at u = {displacement_nm:.6} nm before the force had a maximum: its first step went to \
         another equilibrium, or the strip is too soft for its adhesion (process zone {process_nm:.3e} nm)"
    )]
    LostAtRest { displacement_nm: f64, process_nm: f64 },
    /// The first step is too short for the numbers.
    #[error("the first step, {step_nm:e} nm, is lost in the rounding of the displacement")]
    Stuck { step_nm: f64 },
    /// The caller stopped it at [`crate::study::Stage::Results`].
    #[error(
        "the limit points and the work of the path were not computed before the run was stopped, within twice bounds.time and a second or \
         soon behind Ctrl-C: a larger bounds.time allows more time"
    )]
    OutOfTime,
    /// It took too much work.
    #[error("the path is not at its end after {iterations} Newton iterations")]
    OutOfWork { iterations: usize },
    /// It comes near a pole of its law that the elements do not resolve.
    #[error("{0}")]
    NearUpright(UprightSection),
    /// Its steps have become short.
    #[error("{points} path points were not enough on {elements} elements: the continuation steps have collapsed")]
    TooManyPoints { points: usize, elements: usize },
    /// Numbers of limit points with shorter and with longer steps, and of those that are the same with both.
    #[error(
        "with shorter steps the path has {shorter} limit points, with longer ones {longer}, of which the first {same} are the same: what slides \
         behind these depends on the steps"
    )]
    StepsMatter { shorter: usize, longer: usize, same: usize },
    /// The error bounds are larger than the accuracy asked for by this factor.
    #[error("the error bounds are {factor:.1} times the requested tolerance")]
    BoundsMissed { factor: f64 },
}
