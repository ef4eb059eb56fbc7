//! What a pull of a seta in time gives.

use crate::model::problem::motion::NotInTime;
use crate::model::seta::check::SetaError;
use crate::solve::error::SolveError;
use crate::solve::time::dynamic_system::EnergyBalance;
use crate::solve::time::integrator::TimeError;
use crate::study::pull_in_time::result::InTimeFailureKind;
use crate::study::seta::result::TipChange;

/// The seta at one time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetaInTimePoint {
    /// t since the pull began, ns
    pub time: f64,
    /// Of the root, nm
    pub displacement: f64,
    /// Force of what moves the root, along the pull, nN
    pub force: f64,
    /// Sum of the forces with which the ground holds the tips, along the pull, nN: the same as `force` where mass does not count
    pub tip_force: f64,
    /// Tips that adhere
    pub attached: usize,
    /// Energies, aJ: what is released at events is dissipated.
    pub balance: EnergyBalance,
    /// The part of the energy dissipated that was released at events, aJ
    pub released: f64,
}

/// How tips came to leave the branch of their law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TipLoss {
    /// They came to the end of it.
    EndOfBranch,
    /// They softened faster than the seta holds them, with the stiffness of fast loading: they jump.
    Unstable,
}

/// Tips that leave the branch of their law.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaInTimeEvent {
    /// The seta just before
    pub before: SetaInTimePoint,
    /// Just behind, at the same time
    pub after: SetaInTimePoint,
    /// Why
    pub loss: TipLoss,
    /// In their order
    pub tips: Vec<TipChange>,
    /// Energy released, aJ
    pub released: f64,
}

/// A pull of a seta in time.
#[derive(Clone, Debug, Default)]
pub struct SetaInTime {
    /// Every step, from rest on; an event is followed by another point at the same time where it changes the energies.
    pub points: Vec<SetaInTimePoint>,
    /// In their order
    pub events: Vec<SetaInTimeEvent>,
    /// Elements of the tree
    pub elements: usize,
    /// Newton iterations
    pub iterations: usize,
    /// Steps that were tried, those that were refused among them
    pub tried: usize,
}

impl SetaInTime {
    /// The last point.
    pub fn last(&self) -> SetaInTimePoint {
        self.points.last().copied().unwrap_or_default()
    }

    /// The point with the largest force.
    pub fn peak(&self) -> SetaInTimePoint {
        self.points.iter().copied().max_by(|a, b| a.force.total_cmp(&b.force)).unwrap_or_default()
    }

    /// The largest defect of the balance, over the largest work: work = stored + adhesion + dissipated.
    pub fn balance_error(&self) -> f64 {
        let Some(start) = self.points.first() else { return 0.0 };
        let largest = |of: &dyn Fn(&SetaInTimePoint) -> f64| self.points.iter().map(of).fold(0.0, f64::max);
        let defect = |point: &SetaInTimePoint| point.balance.defect(&start.balance).abs();
        largest(&defect) / largest(&|point| point.balance.work.abs()).max(f64::MIN_POSITIVE)
    }
}

/// Why a pull of a seta was not followed to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaInTimeFailureKind {
    #[error(transparent)]
    InTime(#[from] InTimeFailureKind),
    #[error(transparent)]
    Seta(#[from] SetaError),
    #[error(
        "at t = {time:.6e} ns, u = {displacement:.6} nm, the seta does not come to rest behind an event, after {changes} changes of tips: {cause}; try more elements"
    )]
    Restless { time: f64, displacement: f64, changes: usize, cause: SolveError },
}

impl From<NotInTime> for SetaInTimeFailureKind {
    fn from(why: NotInTime) -> Self {
        Self::InTime(why.into())
    }
}

impl From<TimeError> for SetaInTimeFailureKind {
    fn from(why: TimeError) -> Self {
        Self::InTime(why.into())
    }
}

/// A failure with what was reached.
#[derive(Clone, Debug)]
pub struct SetaInTimeFailure {
    /// Why
    pub why: SetaInTimeFailureKind,
    /// Up to there
    pub reached: Option<Box<SetaInTime>>,
}
