//! What a pull-off of a seta gives.

use super::standing::Standing;
use crate::model::seta::tip_law::{AdheringTip, TipBranch};
use crate::solve::error::SolveError;
use crate::solve::newton::Solution;
use crate::study::asked::events::{EventAction, EventAt};
use crate::study::asked::stop_criteria::Bound;
use crate::study::states::seta_state::{LocationError, SetaPoint, SetaState};
use serde::{Deserialize, Serialize};

/// What one tip does in an event.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TipChange {
    /// Number of the tip
    pub tip: usize,
    /// What it goes over to
    pub to: TipBranch,
    /// Force of the ground on it before the event, nN: negative along y where the ground pulls it down
    pub load: [f64; 3],
}

/// What an event begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EventCause {
    /// Tips lose their hold, or come into contact
    Tips,
    /// Beams buckle: a loss of stability in which no tip takes part. Tips may follow.
    Buckling,
}

/// Tips that detach or adhere again, or beams that buckle, at a root that stands still; others may follow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaEvent {
    /// The equilibrium that loses its stability
    pub before: SetaPoint,
    /// The one in which the seta comes to rest
    pub after: SetaPoint,
    /// What it begins with
    pub cause: EventCause,
    /// Those that change, in the order in which they go; none where beams buckle and no tip follows
    pub tips: Vec<TipChange>,
    /// Energy released, aJ
    pub released: f64,
}

/// A station of a pull-off, or where an event of the user lies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaStation {
    /// Which one of [`crate::study::StopCriteria::events`]
    pub event: usize,
    /// The equilibrium; where the seta jumps past the value, that behind the jump
    pub point: SetaPoint,
    /// By how much the equilibrium may miss the value, in force and displacement, with mesh and law of the tips as they are; none behind a jump
    pub location: Option<LocationError>,
    /// Whether the quantity jumps past the value, with the root held
    pub jumped: bool,
    /// It lies behind this one of the points
    pub after: usize,
}

/// How a pull-off ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum SetaEnd {
    /// All steps were taken.
    Completed,
    /// A stop criterion was met.
    Bound(Bound),
    /// The computation stopped short.
    Failed(SetaFailure),
}

impl SetaEnd {
    /// Whether the computation stopped short.
    pub fn is_failure(&self) -> bool {
        matches!(self, Self::Failed(_))
    }

    /// Whether not all steps were taken.
    pub fn is_cut_short(&self) -> bool {
        !matches!(self, Self::Completed)
    }
}

/// What it took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SetaEffort {
    /// Newton iterations of the equilibria that were found, each with one factorisation
    pub newton_iterations: usize,
    /// Elements of the tree
    pub elements: usize,
}

/// The pull-off of a seta.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaPullOff {
    /// The stable branches, point by point; those at both sides of an event are among them
    pub points: Vec<SetaPoint>,
    /// At the beginning of the last step, by how much the force along its direction rises with the displacement, the root held in all other
    /// directions, nN/nm; none where that step was not begun
    pub initial_stiffness: Option<f64>,
    /// In their order
    pub events: Vec<SetaEvent>,
    /// Stations and events of the user, in the order in which the root comes to them
    #[serde(default)]
    pub stations: Vec<SetaStation>,
    /// Just before the first detachment of the last step
    pub first_detachment: Option<SetaState>,
    /// At the largest force along the direction of the last step: a maximum, or just before an event or behind it. Where nothing was located it is
    /// the largest one of the equilibria, and has no error.
    pub peak: Option<SetaState>,
    /// Just before the last event at which a tip detaches in the last step
    pub last_detachment: Option<SetaState>,
    /// At the end
    pub last: Option<SetaState>,
    /// How it ended
    pub end: SetaEnd,
    /// What it took
    pub effort: SetaEffort,
}

impl SetaPullOff {
    /// What of the work of the root is neither stored nor released, over the largest of the three, without its sign.
    pub fn imbalance(&self) -> f64 {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else { return 0.0 };
        let stored = last.energy - first.energy;
        let largest = last.work.abs().max(stored.abs()).max(last.released.abs()).max(f64::MIN_POSITIVE);
        (self.unaccounted() / largest).abs()
    }

    /// What of the work of the root is neither stored nor released, aJ.
    pub(super) fn unaccounted(&self) -> f64 {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else { return 0.0 };
        last.work - (last.energy - first.energy) - last.released
    }

    /// Works of the root from point to point without their signs, aJ: a way there and back counts twice.
    pub(super) fn turnover(&self) -> f64 {
        self.points.windows(2).map(|pair| (pair[1].work - pair[0].work).abs()).sum()
    }
}

/// A moment of the last step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaMoment {
    /// On the root along the direction of the step, nN
    pub force: f64,
    /// On the root along x, y and z, nN
    #[serde(default)]
    pub on_root: [f64; 3],
    /// How far the root has moved in the step, nm
    pub displacement: f64,
    /// Tips that adhere
    pub attached: usize,
}

impl From<&SetaState> for SetaMoment {
    fn from(SetaState { point, .. }: &SetaState) -> Self {
        Self {
            force: point.force_along,
            on_root: point.force,
            displacement: point.displacement,
            attached: point.attached,
        }
    }
}

// -- What a pull-off has reached: with it the rest follows bit for bit as if it had not been interrupted --

/// What a pull-off has reached.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SetaProgress {
    /// The result so far
    pub result: SetaPullOff,
    /// The equilibrium that it stands in
    pub(super) here: Solution,
    /// Branch and place of adhesion of each tip, nm
    pub(super) tips: Vec<(TipBranch, [f64; 3])>,
    /// Number of the step that is under way
    pub(super) step: usize,
    /// Where the root was at its beginning, nm
    pub(super) from: [f64; 3],
    /// Length of the next step of the root, nm
    pub(super) ahead: f64,
    /// ∂²E/∂y² of a tip at the last loss of stability, nN/nm
    pub(super) softest: Option<f64>,
}

/// Where a run is between two steps of its root: a step that is stopped on its way is taken back.
pub(super) struct Mark {
    points: usize,
    events: usize,
    stations: usize,
    effort: SetaEffort,
    here: Solution,
    tips: Vec<AdheringTip>,
    ahead: f64,
    softest: Option<f64>,
}

impl Mark {
    pub(crate) fn of(progress: &SetaProgress, standing: &Standing) -> Self {
        let SetaProgress { result, here, ahead, softest, .. } = progress;
        Self {
            points: result.points.len(),
            events: result.events.len(),
            stations: result.stations.len(),
            effort: result.effort,
            here: here.clone(),
            tips: standing.tips.clone(),
            ahead: *ahead,
            softest: *softest,
        }
    }

    pub(crate) fn restore(self, progress: &mut SetaProgress, standing: &mut Standing) {
        let SetaProgress { result, here, ahead, softest, .. } = progress;
        result.points.truncate(self.points);
        result.events.truncate(self.events);
        result.stations.truncate(self.stations);
        result.effort = self.effort;
        (*here, *ahead, *softest) = (self.here, self.ahead, self.softest);
        standing.tips = self.tips;
    }
}

/// A state of the last step that has a name.
#[derive(Clone, Copy)]
pub(super) enum Named {
    FirstDetachment,
    Peak,
    LastDetachment,
}

impl SetaPullOff {
    pub(super) fn named(&mut self, name: Named) -> &mut Option<SetaState> {
        match name {
            Named::FirstDetachment => &mut self.first_detachment,
            Named::Peak => &mut self.peak,
            Named::LastDetachment => &mut self.last_detachment,
        }
    }
}

impl SetaPullOff {
    /// Keeps stations and events of the user that a jump from one equilibrium to another passes, of which the last two points are those.
    ///
    /// # Errors
    /// The end of a run that such an event stops.
    pub(super) fn take_jump(
        &mut self,
        events: &[EventAt],
        before: &SetaState,
        behind: &SetaState,
    ) -> Result<(), SetaEnd> {
        let after = self.points.len() - 2;
        for (event, at) in events.iter().enumerate() {
            let value = |state: &SetaState| at.quantity.of_seta(state);
            if at.passes(value(before), value(behind)) {
                self.stations.push(SetaStation { event, point: behind.point, location: None, jumped: true, after });
                if at.action == EventAction::Stop {
                    return Err(SetaEnd::Bound(Bound::Event { name: at.name.clone() }));
                }
            }
        }
        Ok(())
    }

    /// Of nothing.
    pub(super) fn empty(elements: usize) -> Self {
        Self {
            points: Vec::new(),
            initial_stiffness: None,
            events: Vec::new(),
            stations: Vec::new(),
            first_detachment: None,
            peak: None,
            last_detachment: None,
            last: None,
            end: SetaEnd::Completed,
            effort: SetaEffort { newton_iterations: 0, elements },
        }
    }
}

// -- Why a pull-off of a seta stopped short. Steps are counted from 0 in the data and from 1 in the messages --

/// Why a pull-off of a seta stopped short.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaFailure {
    /// No equilibrium at the start.
    #[error("the seta does not come to rest at the start: {cause}; try a smaller scatter of its tips")]
    NoStart { cause: SolveError },
    /// The branch cannot be followed.
    #[error(
        "in step {} the seta cannot be followed beyond {displacement:.6} nm with {attached} tips attached: {cause}; try more elements", .step + 1
    )]
    Lost { step: usize, displacement: f64, attached: usize, cause: SolveError },
    /// An event has no end.
    #[error(
        "in step {} at {displacement:.6} nm the seta does not come to rest behind an event, after {changes} changes of tips: {cause}; try more elements", .step + 1
    )]
    Restless { step: usize, displacement: f64, changes: usize, cause: SolveError },
    /// The same where the law of tips is an extrapolation.
    #[error(
        "in step {} at {displacement:.6} nm the seta does not come to rest behind an event, where {outside} tips are outside of the table of their spatula: what is extrapolated there need not be stable; press the seta less, or give a table that begins less deep", .step + 1
    )]
    Extrapolated { step: usize, displacement: f64, outside: usize },
    /// A preload that is not reached.
    #[error("in step {} the preload of {preload} nN is not reached within {displacement:.3} nm: ask for less", .step + 1)]
    NoPreload { step: usize, preload: f64, displacement: f64 },
    /// Work and energy differ.
    #[error(
        "in step {} at {displacement:.6} nm work and energy differ by {imbalance:.3e} of the larger: the seta may have gone over to another branch; try shorter steps", .step + 1
    )]
    Unbalanced { step: usize, displacement: f64, imbalance: f64 },
    /// Work that is nowhere at the end.
    #[error(
        "all steps are taken, but {missing:.6} aJ of the {work:.6} aJ that the root has worked are neither stored nor released, {share:.1e} of the work there and back, where steps are held to {balance:.1e}: on the way the seta has gone over to another branch, and neither its peak nor its events can be relied on; try a smaller accuracy.relative"
    )]
    Unaccounted { missing: f64, work: f64, share: f64, balance: f64 },
}
