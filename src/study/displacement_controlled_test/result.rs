//! What a testing machine would record: the stable part of the path, the jumps, and the way back.

use super::stable_branch::{Balance, LeftModel, LoadingDirection, TestFailure};
use crate::study::asked::locator::StationErrors;
use crate::study::asked::stop_criteria::Bound;
use crate::study::peel::contact::Adhering;
use serde::{Deserialize, Serialize};
use std::fmt;

/// One equilibrium of the test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TestPoint {
    /// Which way the machine moves
    pub way: LoadingDirection,
    /// U = u + P/k of the machine, nm
    pub machine: f64,
    /// u of the grip, nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// ∫ P dU from the start of the test, aJ
    pub work: f64,
    /// S of the peeling front, nm
    pub front: f64,
    /// What adheres
    pub adheres: Adhering,
    /// Whether the strip has jumped here from the point before.
    pub jumped: bool,
}

/// A station of a test, or where an event of the user lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TestStation {
    /// Which one of [`crate::study::StopCriteria::events`]
    pub event: usize,
    /// The equilibrium; where the strip jumps past the value, that in which it comes to rest
    pub point: TestPoint,
    /// Distance of the nearer edge of the section at the free end from the ground, nm
    pub free_end_gap: f64,
    /// Bounds on the errors of these numbers: of the grip, not of the machine; none behind a jump
    pub errors: Option<StationErrors>,
}

/// An equilibrium on one side of a jump.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JumpEnd {
    /// u, nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// Bounds on their errors, nm and nN; infinite where none was found
    pub displacement_error: f64,
    /// Of the force, nN; infinite where none was found
    pub force_error: f64,
    /// Stored, adhesion and spring energy, aJ; zero for a stress-free strip beyond the range of adhesion
    pub energy: f64,
    /// S of the peeling front, nm
    pub front: f64,
    /// What adheres
    pub adheres: Adhering,
}

/// What a jump is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JumpKind {
    /// Less adheres behind it.
    SnapOff,
    /// More adheres behind it.
    IntoContact,
}

/// A loss of stability, and where the strip comes to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jump {
    /// Jump or slide
    pub kind: JumpKind,
    /// Which way the machine moves
    pub way: LoadingDirection,
    /// U at which it happens, nm, and a bound on its error
    pub machine: f64,
    /// On U, nm
    pub machine_error: f64,
    /// Where stability is lost
    pub before: JumpEnd,
    /// Where the strip comes to rest
    pub after: JumpEnd,
    /// Energy before minus energy after, aJ, and a bound on its error
    pub released: f64,
    /// On the energy released, aJ; infinite where none was found
    pub released_error: f64,
    /// Whether no point of the strip is nearer than 10 r0 after it.
    pub detached: bool,
    /// Steps of the relaxation.
    pub steps: usize,
}

/// A largest force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullOff {
    /// U, nm
    pub machine: f64,
    /// nN, and a bound on its error
    pub force: f64,
    /// On the force, nN
    pub force_error: f64,
    /// What adheres there
    pub adheres: Adhering,
}

/// How a test ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum TestEnd {
    /// The machine is back where it started, and so is the strip.
    Closed,
    /// The machine is back, the strip came to rest in another equilibrium.
    Returned(Elsewhere),
    /// The beam is off, or stands on the face of its end, and the machine was not to return ([`crate::study::observed_retreat()`]).
    Off,
    /// It goes on; a stop criterion was met.
    Bound(Bound),
    /// It has come to where its model ends.
    LeftModel(LeftModel),
    /// The computation stopped short; why, with numbers and what to try.
    Failed(TestFailure),
}

/// Another equilibrium at U = 0 than the one in which a test began.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Elsewhere {
    /// Its energy less that of the first, aJ
    pub energy_change: f64,
    /// nN
    pub force: f64,
}

impl fmt::Display for Elsewhere {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { energy_change, force } = self;
        write!(
            f,
            "at U = 0 the strip rests in another equilibrium than at first: its energy is {energy_change:.6} aJ from that, P = {force:.6} nN"
        )
    }
}

/// What it took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TestEffort {
    /// Equilibria
    pub points: usize,
    /// Of paths, limit points and equilibria
    pub newton_iterations: usize,
    /// Of the gradient flow behind all jumps
    pub relaxation_steps: usize,
    /// Most of them on a mesh
    pub elements: usize,
    /// Of the elements, 1 to 8
    pub order: usize,
}

/// A test under control of the machine's displacement.
#[derive(Clone, Debug)]
pub struct Observed {
    /// In the order in which the machine takes them
    pub points: Vec<TestPoint>,
    /// In the same order
    pub jumps: Vec<Jump>,
    /// Stations and events of the user, likewise
    pub stations: Vec<TestStation>,
    /// (U, P) between the jumps, close enough to draw, piece by piece.
    pub pieces: Vec<(LoadingDirection, Vec<(f64, f64)>)>,
    /// The largest force on the stable retreat.
    pub pull_off: Option<PullOff>,
    /// The largest force before the beam stood on the face of its end for the first time; none where it never stands there. What then holds
    /// the beam is the face of its end alone, which says nothing of how it peels.
    pub before_upright: Option<PullOff>,
    /// ∮ P dU of a closed cycle, aJ
    pub hysteresis: Option<f64>,
    /// Up to where the strip is detached; there and back.
    pub retreat: Option<Balance>,
    /// There and back
    pub cycle: Option<Balance>,
    /// How the test ended
    pub end: TestEnd,
    /// What it cost
    pub effort: TestEffort,
    /// Largest bound on the error of a number of a jump, relative to that number.
    pub reached: f64,
}

/// A jump of which no bound was found: no equilibrium on a finer mesh lies next to one of its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnknownJumpError {
    /// U of the jump, nm
    pub machine: f64,
}

impl UnknownJumpError {
    /// As outputs call it.
    pub const CODE: &'static str = "jump-error-unknown";
}

impl fmt::Display for UnknownJumpError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "the error of the jump at U = {:.6} nm is unknown: no equilibrium was found on a finer mesh next to its ends",
            self.machine
        )
    }
}

impl Observed {
    /// The jumps that were found without a bound on their error.
    pub fn warnings(&self) -> Vec<UnknownJumpError> {
        let unknown = self.jumps.iter().filter(|jump| !jump.released_error.is_finite());
        unknown.map(|jump| UnknownJumpError { machine: jump.machine }).collect()
    }

    /// The largest force of the retreat as long as the beam does not stand on the face of its end.
    pub fn peeling_force(&self) -> Option<PullOff> {
        self.before_upright.or(self.pull_off.filter(|largest| largest.adheres != Adhering::EndFace))
    }
}
