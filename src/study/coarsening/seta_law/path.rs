//! Resolved paths of the root of a seta, which its law is made of: pulls from where all tips adhere until the last one has let go.

use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::TipBranch;
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::seta::loading::{SetaLoading, SetaOptions, SetaStart};
use crate::study::seta::result::{EventCause, SetaEnd, SetaFailure, SetaPullOff};
use crate::study::seta::run::pull_off;
use crate::study::states::seta_state::SetaPoint;
use serde::{Deserialize, Serialize};

/// The root moves straight on where it is so near to the line of its last way, nm.
const STRAIGHT: f64 = 1e-6;

/// A place of the root in a resolved path, in the plane of x and y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RootPoint {
    /// (u, v), nm
    pub root: [f64; 2],
    /// That holds the root, nN
    pub force: [f64; 2],
    /// Against being detached and stress-free, aJ
    pub energy: f64,
    /// Of the root from the start, aJ
    pub work: f64,
    /// That adhere
    pub tips: usize,
}

/// A path of the root of a resolved seta, on which its tips let go. All of them adhere at its first point; at its last one the last one lets go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RootPath {
    /// In their order, two at least
    pub points: Vec<RootPoint>,
}

/// Why the law of a seta cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaLawError {
    #[error(transparent)]
    Seta(#[from] SetaError),
    #[error("a potential of degree {degree} is asked of the law of a seta: give 2, 3 or 4")]
    Degree { degree: usize },
    #[error("{sheets} sheets are asked of the law of a seta: give 1 to 64")]
    Sheets { sheets: usize },
    #[error("a tolerance of {tolerance} is asked of the law of a seta: give one above zero and below 1")]
    Tolerance { tolerance: f64 },
    #[error("the law of a seta is made of {paths} paths of its root: give at least three, in different directions")]
    TooFewPaths { paths: usize },
    #[error(
        "step {} of the path of the root goes along {direction:?}, out of the plane of x and y: the law of a seta knows no way along z", .step + 1
    )]
    OutOfPlane { step: usize, direction: [f64; 3] },
    #[error(
        "the path of the root starts {height} nm above the ground: the law of a seta wants all tips to adhere at the start"
    )]
    StartsAbove { height: f64 },
    #[error(
        "{attached} of {tips} tips adhere at the start of the path of the root: the law of a seta wants all; try a smaller scatter of the tips"
    )]
    NotAllAdhere { attached: usize, tips: usize },
    #[error("the path of the root cannot be followed to the loss of the last tip: {0}")]
    Failed(SetaFailure),
    #[error("the path of the root is stopped by {0} before the last tip lets go: allow more")]
    Stopped(Bound),
    #[error(
        "{attached} of {tips} tips adhere at the end of the path of the root, at {displacement:.6} nm of its last step: pull farther"
    )]
    StillAdheres { attached: usize, tips: usize, displacement: f64 },
    #[error(
        "the first event on the path of the root, at {displacement:.6} nm of its step {}, is not the loss of a tip: beams buckle or tips adhere; leave out this direction", .step + 1
    )]
    OtherEvent { step: usize, displacement: f64 },
    #[error(
        "path {} of the root has a number that is not finite, fewer than two points, no work or force, or other tips than the first one: compute it again", .path + 1
    )]
    Path { path: usize },
    #[error(
        "{paths} paths of the root do not determine a potential of degree {degree}, and with each one left out they have to: least singular value {least:.1e}; give more directions or a lower degree"
    )]
    Undetermined { paths: usize, degree: usize, least: f64 },
}

impl RootPath {
    /// Moves the root of a seta as the loading says until the last tip lets go.
    ///
    /// # Errors
    /// A loading out of the plane or from above the ground; a path that fails, is stopped, ends with tips that adhere, or has another event before
    /// a tip lets go.
    pub fn resolved(
        model: &SetaModel,
        loading: &SetaLoading,
        options: &SetaOptions,
        stop: &StopCriteria,
    ) -> Result<Self, SetaLawError> {
        loading.check()?;
        if let SetaStart::Above(height) = loading.start {
            return Err(SetaLawError::StartsAbove { height });
        }
        for (step, own) in loading.steps.iter().enumerate() {
            if own.direction[2] != 0.0 {
                return Err(SetaLawError::OutOfPlane { step, direction: own.direction });
            }
        }
        Self::of(&pull_off(model, loading, options, stop)?, model.seta.tips())
    }

    /// What of a pull-off comes before the loss of its last tip.
    fn of(pulled: &SetaPullOff, tips: usize) -> Result<Self, SetaLawError> {
        if let Some(&start) = pulled.points.first()
            && start.attached != tips
        {
            return Err(SetaLawError::NotAllAdhere { attached: start.attached, tips });
        }
        if let Some(event) = pulled.events.first() {
            let lets_go = event.tips.first().is_some_and(|change| change.to == TipBranch::Detached);
            if event.cause != EventCause::Tips || !lets_go {
                let (step, displacement) = (event.before.step, event.before.displacement);
                return Err(SetaLawError::OtherEvent { step, displacement });
            }
        }
        let last = pulled.points.last();
        match &pulled.end {
            SetaEnd::Failed(failure) => return Err(SetaLawError::Failed(failure.clone())),
            SetaEnd::Bound(bound) => return Err(SetaLawError::Stopped(bound.clone())),
            SetaEnd::Completed => {}
        }
        if let Some(&SetaPoint { attached, displacement, .. }) = last
            && attached > 0
        {
            return Err(SetaLawError::StillAdheres { attached, tips, displacement });
        }
        let adhering = pulled.points.iter().take_while(|point| point.attached > 0);
        let of = |point: &SetaPoint| RootPoint {
            root: [point.root[0], point.root[1]],
            force: [point.force[0], point.force[1]],
            energy: point.energy,
            work: point.work,
            tips: point.attached,
        };
        Ok(Self { points: adhering.map(of).collect() })
    }

    /// Where the last one of more than so many tips is, nm: there the next ones let go.
    pub(super) fn loss(&self, tips: usize) -> [f64; 2] {
        let above = |point: &&RootPoint| point.tips > tips;
        self.points.iter().rfind(above).map_or([0.0; 2], |point| point.root)
    }

    /// Its points with more than `fewest` and at most `most` tips.
    pub(super) fn with(&self, fewest: usize, most: usize) -> impl Iterator<Item = &RootPoint> {
        self.points.iter().filter(move |point| point.tips > fewest && point.tips <= most)
    }

    /// Places between which the root moves straight on, nm: the first and the last one, and those between its steps.
    pub(super) fn corners(&self) -> Vec<[f64; 2]> {
        let mut corners: Vec<[f64; 2]> = Vec::new();
        for &RootPoint { root, .. } in &self.points {
            if let [.., from, to] = corners[..] {
                let (way, more) = ([to[0] - from[0], to[1] - from[1]], [root[0] - to[0], root[1] - to[1]]);
                let across = (way[0] * more[1] - way[1] * more[0]).abs();
                if across <= STRAIGHT * way[0].hypot(way[1]) && way[0] * more[0] + way[1] * more[1] >= 0.0 {
                    corners.pop();
                }
            }
            if corners.last() != Some(&root) {
                corners.push(root);
            }
        }
        corners
    }

    /// Tips that adhere at its start.
    pub(super) fn tips(&self) -> usize {
        self.points.first().map_or(0, |first| first.tips)
    }

    /// Work of the root on it, aJ.
    pub fn work(&self) -> f64 {
        let of = |point: Option<&RootPoint>| point.map_or(0.0, |point| point.work);
        of(self.points.last()) - of(self.points.first())
    }

    /// Largest force that holds the root on it, nN.
    pub fn largest_force(&self) -> f64 {
        self.points.iter().map(|point| point.force[0].hypot(point.force[1])).fold(0.0, f64::max)
    }

    /// Whether a law can be made of it.
    pub(super) fn is_usable(&self) -> bool {
        let numbers = |p: &RootPoint| [p.root[0], p.root[1], p.force[0], p.force[1], p.energy, p.work];
        let finite = self.points.iter().all(|point| numbers(point).iter().all(|number| number.is_finite()));
        finite && self.points.len() >= 2 && self.tips() > 0 && self.work() > 0.0 && self.largest_force() > 0.0
    }
}
