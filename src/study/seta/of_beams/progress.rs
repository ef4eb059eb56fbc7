//! A pull-off of a seta of beams that is under way: what it has reached, and why it ends.

use crate::beam::spatial::tree::beam_tree::BeamTree;
use crate::beam::spatial::tree::branching_beam::TreeMonitor;
use crate::model::seta::check::SetaError;
use crate::model::seta::spatulae::SetaOfBeams;
use crate::solve::error::SolveError;
use crate::solve::newton::{NewtonOptions, Solution};
use crate::solve::path::options::PathOptions;
use crate::solve::problem::Problem;
use crate::solve::state::Observables;
use crate::solve::workspace::Workspace;
use crate::study::asked::stop_criteria::{Bound, Stage, StopCriteria};
use crate::study::seta::loading::SetaLoading;
use crate::study::seta::result::{SetaEnd, SetaFailure, SetaPullOff};
use crate::study::seta::standing::{RootDrive, grip_of};
use crate::study::states::seta_state::{LocationError, SetaPoint, SetaState};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A solution at a value that was asked for.
pub(super) const AT_END: NewtonOptions =
    NewtonOptions { tolerance: 1e-9, largest_update: 0.5, most_iterations: 12, exact_slope: true };
/// Limit points are located to this share.
pub(super) const LOCATED: f64 = 1e-8;
/// Force of a tip that measures a path, nN.
const FORCE: f64 = 0.3;
/// How far pads go aside that measures a path, nm: where a seta leans to one side nothing else moves to first order.
const ASIDE: f64 = 10.0;
/// How far the root is moved on where no further point of a path is found, nm: at first.
pub(super) const NUDGE: f64 = 0.01;

/// From where the largest force of the pull was come to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct BeforePeak {
    /// An equilibrium before it, on the same piece
    pub from: Arc<Solution>,
    /// The spatulae that have let go there
    pub off: Vec<bool>,
    /// Number of the step
    pub step: usize,
    /// Where the root was at its beginning, nm
    pub root: [f64; 3],
}

/// What a pull-off of a seta of beams has reached behind a loss of stability: with it the rest follows bit for bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BeamsProgress {
    /// The result so far
    pub result: SetaPullOff,
    /// The equilibrium that it stands in; none before the start
    pub(super) here: Option<Arc<Solution>>,
    /// How far the root has moved in its step, nm
    pub(super) displacement: f64,
    /// The spatulae that have let go
    pub(super) off: Vec<bool>,
    /// Number of the step that is under way
    pub(super) step: usize,
    /// Where the root was at its beginning, nm
    pub(super) from: [f64; 3],
    /// Losses of stability in it
    pub(super) losses: usize,
    /// How far the root is moved on where the path is stuck, nm
    pub(super) ahead: f64,
    /// From where the largest force of the pull was come to
    pub(super) before_peak: Option<BeforePeak>,
}

/// A pull-off of a seta of beams.
#[derive(Clone, Debug)]
pub struct BeamsPullOff {
    /// What it gives
    pub result: SetaPullOff,
    pub(super) before_peak: Option<BeforePeak>,
}

/// Is shown every equilibrium; behind a loss of stability with what has been reached.
pub(crate) type SeeBeams<'a> = dyn FnMut(&SetaState, Option<&BeamsProgress>) + 'a;

/// A pull-off that is under way.
pub(super) struct Run<'a> {
    pub model: &'a SetaOfBeams,
    pub loading: &'a SetaLoading,
    pub tree: BeamTree,
    pub options: &'a PathOptions,
    pub stop: &'a StopCriteria,
    pub see: &'a mut SeeBeams<'a>,
    pub ws: Workspace,
    pub reached: BeamsProgress,
}

impl<'a> Run<'a> {
    pub(crate) fn new(
        model: &'a SetaOfBeams,
        loading: &'a SetaLoading,
        options: &'a PathOptions,
        stop: &'a StopCriteria,
        reached: Option<BeamsProgress>,
        see: &'a mut SeeBeams<'a>,
    ) -> Result<Self, SetaError> {
        loading.check()?;
        let tree = model.tree()?;
        let [x, y, z] = model.seta.joint_place(0);
        let begun = || BeamsProgress {
            result: SetaPullOff::empty(tree.elements()),
            here: None,
            displacement: 0.0,
            off: vec![false; model.seta.tips()],
            step: 0,
            from: [x, y + loading.above(), z],
            losses: 0,
            ahead: NUDGE,
            before_peak: None,
        };
        let reached = reached.unwrap_or_else(begun);
        let ws = Workspace::until(stop.for_solves(Stage::Results));
        Ok(Self { model, loading, tree, options, stop, see, ws, reached })
    }

    /// Whether the step is the pull.
    pub(crate) fn is_last(&self) -> bool {
        self.reached.step + 1 == self.loading.steps.len()
    }

    /// The tree with its spatulae as they are, in the grip that moves its root.
    pub(crate) fn problem(&self, drive: &RootDrive) -> Problem {
        let (first, off) = (self.model.spatula_of(0), &self.reached.off);
        let adheres = |branch: usize| !branch.checked_sub(first).is_some_and(|tip| off[tip]);
        let tree = self.tree.with_adhesion(adheres).with_root_axes(drive.axes);
        let [x, y, z] = drive.from;
        let drive = RootDrive { from: [x, y + self.model.foot(), z], ..*drive };
        let tree = tree.with_monitors([Some(TreeMonitor::AdheringLength), Some(TreeMonitor::PadsAside)]);
        let mut problem = grip_of(Arc::new(tree), &drive, FORCE * off.len() as f64);
        // the fronts of several spatulae may go to and fro, and the force goes on then
        problem.measure.monitors = [self.model.spatula.sections.lying.process_length, ASIDE];
        problem
    }
}

// -- Where a run ends, and why --

impl Run<'_> {
    /// The criterion that is met before a path goes on.
    pub(crate) fn bound(&self) -> Option<Bound> {
        let points = self.reached.result.points.len() >= self.stop.points;
        points.then_some(Bound::Points(self.stop.points)).or_else(|| self.stop.reached_bound(Stage::Path))
    }

    /// The displacement at which the pull is left, nm.
    pub(crate) fn most_displacement(&self) -> Option<f64> {
        self.stop.displacement.filter(|_| self.is_last())
    }

    pub(crate) fn bound_of_displacement(&self) -> Option<Bound> {
        self.most_displacement()
            .filter(|&most| self.reached.displacement >= most * (1.0 - LOCATED))
            .map(Bound::Displacement)
    }

    /// What has stopped a solve from outside, whether it is to stop at once or not to go on: where the path ends for that it is not stuck.
    fn stopped_by(&self, cause: &SolveError) -> Option<Bound> {
        let bound = || self.stop.reached_bound(Stage::Results).or_else(|| self.stop.reached_bound(Stage::Path));
        if *cause == SolveError::Stopped { bound() } else { None }
    }

    /// Whether a solve was stopped from outside.
    pub(crate) fn is_cut_short(&self, cause: &SolveError) -> bool {
        self.stopped_by(cause).is_some()
    }

    /// Where the run stands when it cannot go on.
    pub(crate) fn lost(&self, cause: SolveError) -> SetaEnd {
        if let Some(bound) = self.stopped_by(&cause) {
            return SetaEnd::Bound(bound);
        }
        let SetaPoint { displacement, attached, .. } = self.last();
        SetaEnd::Failed(SetaFailure::Lost { step: self.reached.step, displacement, attached, cause })
    }
}

/// By how much a limit point misses what was looked for, which lies no farther ahead than so far, nm.
pub(super) fn location(at: &Solution, ahead: f64) -> LocationError {
    let (Observables { displacement, force, .. }, slope) = (at.observables, at.slope);
    let along = if ahead > 0.0 { (slope.force / slope.displacement * ahead).abs() } else { 0.0 };
    LocationError { force: LOCATED * force.abs() + along, displacement: LOCATED * displacement.abs() + ahead }
}
