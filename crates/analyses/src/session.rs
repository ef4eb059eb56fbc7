//! What an analysis has around it: who looks on and may stop it, and where what it finds is kept.

use peelkit::solve::{PathOptions, Waypoint};
use peelkit::study::{SetaPoint, StopCriteria};
use peelkit_report::{Journal, JournalKind, ReportError};
use peelkit_scene::Scene;
use std::fmt;
use std::path::Path;

/// Who looks on while something is computed, from any thread, and may ask to stop.
pub trait Watcher: Sync {
    /// Hears how far it is.
    fn see(&self, _progress: Progress) {}

    /// These criteria, and besides: what is computed ends where it was asked to stop.
    fn ends(&self, stop: StopCriteria) -> StopCriteria {
        stop
    }

    /// Whether it was asked to stop.
    fn asked(&self) -> bool {
        false
    }

    /// Hears that nothing of what comes now is kept; whether it was asked to stop before. What was asked before does not end what comes.
    fn nothing_more_is_kept(&self) -> bool {
        self.asked()
    }
}

/// Nobody looks on.
#[derive(Clone, Copy, Debug)]
pub struct Nobody;

impl Watcher for Nobody {}

/// How far a computation is.
#[derive(Clone, Copy, Debug)]
pub enum Progress<'p> {
    /// What comes next
    Stage(&'static str),
    /// A point of a path with these options was computed.
    Point(&'p PathOptions, &'p Waypoint),
    /// An equilibrium of a seta was computed.
    Equilibrium(&'p SetaPoint),
    /// So many samples, designs or values are computed from now on, at most.
    Begin(usize),
    /// One of these is known from an earlier run.
    Known,
    /// One of these was computed.
    Done,
    /// What is computed again and again from now on costs this.
    Cost(Cost),
}

/// What an analysis costs that has no derivatives, as soon as the first of its computations is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// What is computed, in words: "pull-offs of a seta"
    pub what: &'static str,
    /// How many of these
    pub parts: Parts,
    /// That the first of them took, s
    pub first_s: f64,
}

/// How many computations there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parts {
    /// So many at most
    AtMost(usize),
    /// So many in each step of a search
    AStep(usize),
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { what, parts, first_s } = self;
        match parts {
            Parts::AtMost(most) => write!(f, "at most {most} {what} are computed; ")?,
            Parts::AStep(each) => write!(f, "each step of the search takes {each} {what}; ")?,
        }
        match first_s {
            short if *short < 0.1 => write!(f, "the first took {:.1} ms", 1e3 * short),
            long => write!(f, "the first took {long:.2} s"),
        }
    }
}

/// Where an analysis keeps what it finds while it computes, so that the next one goes on from there.
#[derive(Clone, Copy, Debug)]
pub struct Keeping<'s> {
    /// The folder of its outputs
    pub folder: &'s Path,
    /// Whether what an earlier run has kept is discarded
    pub fresh: bool,
}

/// What an analysis has around it.
#[derive(Clone, Copy)]
pub struct Session<'s> {
    /// Looks on
    pub watcher: &'s dyn Watcher,
    /// Where what is found is kept, if it is
    pub keeping: Option<Keeping<'s>>,
    /// Whether a sample, a design or a value that is under way ends as well where it was asked to stop; else it is computed to its end,
    /// because it is kept
    pub abrupt: bool,
}

impl Session<'_> {
    /// A computation that nobody looks at, within the bounds of its scene, of which nothing is kept.
    pub const PLAIN: Session<'static> = Session { watcher: &Nobody, keeping: None, abrupt: false };

    /// The stop criteria of something that begins now: the bounds of its scene, and where it was asked to stop.
    pub fn stop(&self, scene: &Scene) -> StopCriteria {
        self.watcher.ends(scene.bounds.from_now())
    }

    /// Those of one among many, which begins now.
    pub(crate) fn stop_of_one(&self, scene: &Scene) -> StopCriteria {
        if self.abrupt { self.stop(scene) } else { scene.bounds.from_now() }
    }

    pub(crate) fn stage(&self, next: &'static str) {
        self.watcher.see(Progress::Stage(next));
    }

    /// Where what is found is kept, with what an earlier run of this scene with these settings has left there; nowhere if nothing is to be kept.
    pub(crate) fn open(
        &self,
        kind: JournalKind,
        scene: &Scene,
        settings: &[(&str, &str)],
    ) -> Result<Journal, ReportError> {
        let Some(Keeping { folder, fresh }) = self.keeping else { return Ok(Journal::nowhere()) };
        if fresh {
            kind.discard(folder)?;
        }
        Journal::open(folder, kind, scene, settings)
    }
}
