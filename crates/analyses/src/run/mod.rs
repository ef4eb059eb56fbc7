//! What `peel run` computes: the peel of a scene, as a beam or as a solid, the pull-off of its seta, the pull of its array of setae, or its pull at a rate, by what the scene describes.

mod array;
mod asked;
mod kept_path;
mod peel;
mod rate;
mod sensitivities;
mod seta;
mod solid;

pub use array::{ArrayOutcome, ArrayRun};
pub use asked::Asked;
pub use peel::{PeelOutcome, PeelRun};
pub use rate::{OfSeta, Pull, RateOutcome, RateRun};
pub use sensitivities::Exponents;
pub use seta::{SetaOutcome, SetaRun};
pub use solid::{SolidOutcome, SolidRun};

use crate::outcome::{Analysis, End, Outcome, Refusal};
use crate::session::Session;
use peelkit_report::{Journal, JournalKind, ReportError};
use peelkit_scene::{Described, Scene};
use std::io;
use std::path::{Path, PathBuf};

/// A run of a scene, by what it describes.
pub enum Run<'s> {
    /// A beam in equilibrium
    Peel(PeelRun<'s>),
    /// A solid in equilibrium
    Solid(SolidRun<'s>),
    /// An array of setae, event by event
    Array(Box<ArrayRun<'s>>),
    /// A seta in equilibrium
    Seta(SetaRun<'s>),
    /// Either, pulled at a rate
    Rate(RateRun<'s>),
}

impl<'s> Run<'s> {
    /// Of a scene.
    ///
    /// Fails where something is asked for that has no meaning for what the scene describes, or cannot be computed of it.
    pub fn of(scene: &'s Scene, asked: Asked) -> Result<Self, Refusal> {
        Ok(match scene.describes() {
            Described::Rate(..) => Self::Rate(RateRun::of(scene, asked)?),
            Described::Array(_) => Self::Array(Box::new(ArrayRun::of(scene, asked)?)),
            Described::Seta(_) => Self::Seta(SetaRun::of(scene, asked)?),
            Described::Solid(_) => Self::Solid(SolidRun::of(scene, asked)?),
            Described::Peel => Self::Peel(PeelRun::of(scene, asked)?),
        })
    }
}

impl Analysis for Run<'_> {
    type Found = RunOutcome;

    fn journal(&self) -> Option<JournalKind> {
        match self {
            Self::Peel(run) => run.journal(),
            Self::Solid(run) => run.journal(),
            Self::Array(run) => run.journal(),
            Self::Seta(run) => run.journal(),
            Self::Rate(run) => run.journal(),
        }
    }

    fn run(&self, session: &Session) -> Result<RunOutcome, Refusal> {
        Ok(match self {
            Self::Peel(run) => RunOutcome::Peel(Box::new(run.run(session)?)),
            Self::Solid(run) => RunOutcome::Solid(Box::new(run.run(session)?)),
            Self::Array(run) => RunOutcome::Array(Box::new(run.run(session)?)),
            Self::Seta(run) => RunOutcome::Seta(Box::new(run.run(session)?)),
            Self::Rate(run) => RunOutcome::Rate(Box::new(run.run(session)?)),
        })
    }
}

/// What a run has found.
pub enum RunOutcome {
    /// Of a beam in equilibrium
    Peel(Box<PeelOutcome>),
    /// Of a solid in equilibrium
    Solid(Box<SolidOutcome>),
    /// Of an array of setae
    Array(Box<ArrayOutcome>),
    /// Of a seta in equilibrium
    Seta(Box<SetaOutcome>),
    /// Of either, pulled at a rate
    Rate(Box<RateOutcome>),
}

impl RunOutcome {
    fn any(&self) -> &dyn Outcome {
        match self {
            Self::Peel(found) => &**found,
            Self::Solid(found) => &**found,
            Self::Array(found) => &**found,
            Self::Seta(found) => &**found,
            Self::Rate(found) => &**found,
        }
    }
}

impl Outcome for RunOutcome {
    fn json(&self, scene: &Scene, command: Option<&str>) -> io::Result<String> {
        self.any().json(scene, command)
    }

    fn write(&self, scene: &Scene, dir: &Path, command: &str) -> Result<Vec<PathBuf>, ReportError> {
        self.any().write(scene, dir, command)
    }

    fn end(&self) -> End {
        self.any().end()
    }

    fn kept(&self) -> Option<(&Journal, bool)> {
        self.any().kept()
    }
}
